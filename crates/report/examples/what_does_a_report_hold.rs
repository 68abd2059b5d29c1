//! What does a report hold? Measures for some seconds, lists the files and the first lines of each table; with a folder as argument,
//! writes them there.

use restitution_report::{Effort, make};

fn main() -> Result<(), Box<dyn std::error::Error>> {
    let folder = std::env::args().nth(1).map(std::path::PathBuf::from);
    for (name, content) in make(&Effort::quick(), None, &|| ())? {
        println!("{name}: {} bytes", content.len());
        if let Some(folder) = &folder {
            std::fs::write(folder.join(&name), &content)?;
        }
        if name.ends_with(".csv") {
            content.lines().take(2).for_each(|line| println!("    {line}"));
        }
    }
    Ok(())
}
