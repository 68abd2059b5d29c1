//! How large is the page, and does it ask for anything? Prints its size; with a file name, writes it there.

fn main() -> std::io::Result<()> {
    let page = restitution_page::page();
    println!("{} bytes, {} addresses of other places", page.len(), page.matches("://").count());
    std::env::args().nth(1).map_or(Ok(()), |file| std::fs::write(file, page))
}
