//! What is epsilon at these dampings? Reads numbers `u` from standard input and prints, for each, `u`, epsilon and
//! 1 - epsilon at zero compression, and both at zero force, with all their bits.
//!
//! ```sh
//! echo 0.5 1 2 | cargo run --release --package restitution --example what_is_epsilon
//! ```

use restitution::{End, epsilon, one_minus_epsilon};
use std::error::Error;
use std::io::{Write, read_to_string, stdin, stdout};

fn main() -> Result<(), Box<dyn Error>> {
    let mut out = stdout().lock();
    for word in read_to_string(stdin())?.split_whitespace() {
        let u: f64 = word.parse().map_err(|error| format!("'{word}' is not a number u: {error}"))?;
        let at = |end| (epsilon(u, end), one_minus_epsilon(u, end));
        let ((a, b), (c, d)) = (at(End::ZeroCompression), at(End::ZeroForce));
        writeln!(out, "{u:?} {a:?} {b:?} {c:?} {d:?}")?;
    }
    Ok(())
}
