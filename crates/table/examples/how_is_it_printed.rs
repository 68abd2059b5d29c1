//! How is a table of certified digits printed in each format?

use restitution_table::{Cell, Format, Table};

fn main() {
    let mut table = Table::new(&["k", "value"]).titled("Coefficients");
    table.push(vec![1_usize.into(), Cell::digits("-1.1534488580952888")]);
    table.push(vec![2_usize.into(), Cell::digits("0.79826656094479541")]);
    for format in [Format::Text, Format::Csv, Format::Json, Format::Latex, Format::Markdown] {
        println!("--- {format:?}\n{}", table.render(format));
    }
}
