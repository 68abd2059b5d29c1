//! What does a report hold? Measures for some seconds and lists the files; the first lines of each table.

use restitution_report::{Effort, ReportError, make};

fn main() -> Result<(), ReportError> {
    for (name, content) in make(&Effort::quick(), &|| ())? {
        println!("{name}: {} bytes", content.len());
        if name.ends_with(".csv") {
            content.lines().take(2).for_each(|line| println!("    {line}"));
        }
    }
    Ok(())
}
