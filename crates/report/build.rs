//! Tells the report which compiler built it.

use std::env;
use std::process::Command;

fn main() {
    let rustc = env::var("RUSTC").unwrap_or_else(|_| "rustc".into());
    let version = Command::new(rustc).arg("--version").output().ok();
    let version = version.and_then(|output| String::from_utf8(output.stdout).ok()).unwrap_or_default();
    println!("cargo:rustc-env=RESTITUTION_RUSTC={}", version.trim());
    for (name, variable) in [("TARGET", "TARGET"), ("OPTIMISATION", "OPT_LEVEL")] {
        println!("cargo:rustc-env=RESTITUTION_{name}={}", env::var(variable).unwrap_or_default());
    }
    println!("cargo:rerun-if-changed=build.rs");
}
