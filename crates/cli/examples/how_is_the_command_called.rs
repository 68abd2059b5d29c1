//! How is the command called from a program? Prints two tables and what is said of a wrong argument.

use restitution_cli::{CliError, run};
use std::ffi::OsString;

fn main() -> Result<(), CliError> {
    let command = |line: &str| run(line.split(' ').map(OsString::from));
    command("restitution table --quantity C,a --order 4")?;
    command("restitution epsilon --u 0.5,1 --digits 20 --format csv")?;
    if let Err(refused) = command("restitution epsilon --u minus-one") {
        eprintln!("{refused}");
    }
    Ok(())
}
