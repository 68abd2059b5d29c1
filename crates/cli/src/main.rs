//! The command `restitution`.

fn main() {}
