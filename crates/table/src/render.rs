//! The five forms of a table.

use crate::{Cell, Format, Table};
use serde_json::{Map, Value};

impl Table {
    /// Returns the table as it is printed in `format`, with a line break at its end.
    pub fn render(&self, format: Format) -> String {
        match format {
            Format::Text => self.text(),
            Format::Csv => self.csv(),
            Format::Json => self.json(),
            Format::Latex => self.latex(),
            Format::Markdown => self.markdown(),
        }
    }

    fn text(&self) -> String {
        let cells = self.rows.iter().map(|row| row.iter().map(Cell::plain).collect::<Vec<_>>());
        let mut lines = std::iter::once(self.columns.clone()).chain(cells).collect::<Vec<_>>();
        for column in 0..self.columns.len() {
            align(&mut lines, column, self.is_numeric(column));
        }
        let lines = lines.iter().map(|line| format!("{}\n", line.join("  ").trim_end())).collect::<String>();
        let title = self.title.iter().map(|title| format!("{title}\n\n")).collect::<String>();
        let gap = if self.notes.is_empty() { "" } else { "\n" };
        title + &lines + gap + &self.notes.iter().map(|note| format!("{note}\n")).collect::<String>()
    }

    fn csv(&self) -> String {
        let mut writer = csv::Writer::from_writer(Vec::new());
        let header = self.columns.clone();
        let rows = self.rows.iter().map(|row| row.iter().map(Cell::plain).collect());
        for record in std::iter::once(header).chain(rows) {
            writer.write_record(&record).expect("records of equal length go to memory");
        }
        let bytes = writer.into_inner().expect("memory takes every record");
        String::from_utf8(bytes).expect("only text was written")
    }

    fn json(&self) -> String {
        let object = |row: &Vec<Cell>| {
            Value::Object(self.columns.iter().cloned().zip(row.iter().map(Cell::json)).collect::<Map<_, _>>())
        };
        let rows = Value::Array(self.rows.iter().map(object).collect());
        if self.fields.is_empty() {
            return format!("{rows:#}\n");
        }
        let fields = self.fields.iter().map(|(name, value)| (name.clone(), value.json()));
        let whole = fields.chain([("rows".to_owned(), rows)]).collect::<Map<_, _>>();
        format!("{:#}\n", Value::Object(whole))
    }

    fn markdown(&self) -> String {
        let escape = |text: &str| text.replace('\\', "\\\\").replace('|', "\\|");
        let line = |cells: &[String]| format!("| {} |\n", cells.join(" | "));
        let rule = |numeric: bool| if numeric { "---:" } else { ":---" }.to_owned();
        let mut out = self.title.iter().map(|title| format!("**{title}**\n\n")).collect::<String>();
        out += &line(&self.columns.iter().map(|name| escape(name)).collect::<Vec<_>>());
        out += &line(&(0..self.columns.len()).map(|i| rule(self.is_numeric(i))).collect::<Vec<_>>());
        for row in &self.rows {
            out += &line(&row.iter().map(|cell| escape(&cell.plain())).collect::<Vec<_>>());
        }
        out + &self.notes.iter().map(|note| format!("\n{note}\n")).collect::<String>()
    }

    fn latex(&self) -> String {
        let line = |cells: Vec<String>| format!("{} \\\\\n", cells.join(" & "));
        let align = (0..self.columns.len()).map(|i| if self.is_numeric(i) { 'r' } else { 'l' });
        let comment = |text: &String| format!("% {}\n", text.replace('\n', "\n% "));
        let mut out = self.title.iter().map(comment).collect::<String>();
        out += &format!("\\begin{{tabular}}{{{}}}\n\\hline\n", align.collect::<String>());
        out += &line(self.columns.iter().map(|name| latex_text(name)).collect());
        out += "\\hline\n";
        for row in &self.rows {
            out += &line(row.iter().map(Cell::latex).collect());
        }
        out += "\\hline\n\\end{tabular}\n";
        out + &self.notes.iter().map(comment).collect::<String>()
    }

    fn is_numeric(&self, column: usize) -> bool {
        self.rows.iter().all(|row| !matches!(row[column], Cell::Text(_)))
    }
}

/// Pads a column to one width: texts on the left, numbers with their decimal points in line.
fn align(lines: &mut [Vec<String>], column: usize, numeric: bool) {
    let length = |text: &str| text.chars().count();
    let behind = |text: &str| text.find(['.', 'e', '/']).map_or(0, |point| length(&text[point..]));
    if numeric {
        let longest = lines[1..].iter().map(|line| behind(&line[column])).max().unwrap_or(0);
        for line in &mut lines[1..] {
            let missing = longest - behind(&line[column]);
            line[column].extend(std::iter::repeat_n(' ', missing));
        }
    }
    let width = lines.iter().map(|line| length(&line[column])).max().unwrap_or(0);
    for line in lines {
        let cell = &mut line[column];
        // A width of format! ends at 65535, and digits do not.
        let padding = " ".repeat(width - length(cell));
        if numeric { cell.insert_str(0, &padding) } else { cell.push_str(&padding) }
    }
}

impl Cell {
    /// Returns the cell as text and CSV have it.
    pub fn plain(&self) -> String {
        match self {
            Self::Integer(n) => n.to_string(),
            Self::Digits(text) | Self::Text(text) => text.clone(),
            Self::Float(x) if *x == 0.0 || (1e-5..1e16).contains(&x.abs()) => x.to_string(),
            Self::Float(x) => format!("{x:e}"),
            Self::Empty => String::new(),
        }
    }

    fn json(&self) -> Value {
        match self {
            Self::Integer(n) => Value::from(*n),
            Self::Digits(text) | Self::Text(text) => Value::from(text.as_str()),
            Self::Float(x) => Value::from(*x),
            Self::Empty => Value::Null,
        }
    }

    fn latex(&self) -> String {
        match self {
            Self::Text(text) => latex_text(text),
            Self::Empty => String::new(),
            number => match number.plain().split_once('e') {
                Some((mantissa, exponent)) => format!("${mantissa}\\cdot10^{{{exponent}}}$"),
                None => format!("${}$", number.plain()),
            },
        }
    }
}

fn latex_text(text: &str) -> String {
    let escape = |c: char| match c {
        '\\' => "\\textbackslash{}".to_owned(),
        '^' => "\\textasciicircum{}".to_owned(),
        '~' => "\\textasciitilde{}".to_owned(),
        '&' | '%' | '$' | '#' | '_' | '{' | '}' => format!("\\{c}"),
        _ => c.to_string(),
    };
    text.chars().map(escape).collect()
}

#[cfg(test)]
mod tests {
    use super::*;

    fn sample() -> Table {
        let mut table = Table::new(&["k", "value", "says"]).titled("Title");
        table.push(vec![1_usize.into(), Cell::digits("-1.5e-7"), "a|b, 100 % \"c\"".into()]);
        table.push(vec![10_usize.into(), Cell::Empty, 0.25.into()]);
        table.note("Note.");
        table
    }

    #[test]
    fn text_is_aligned() {
        let text = "Title\n\n k    value  says\n 1  -1.5e-7  a|b, 100 % \"c\"\n10           0.25\n\nNote.\n";
        assert_eq!(sample().render(Format::Text), text);
    }

    #[test]
    fn csv_quotes_what_it_must() {
        let csv = "k,value,says\n1,-1.5e-7,\"a|b, 100 % \"\"c\"\"\"\n10,,0.25\n";
        assert_eq!(sample().render(Format::Csv), csv);
    }

    #[test]
    fn json_keeps_digits_as_text() {
        let value: Value = serde_json::from_str(&sample().render(Format::Json)).unwrap();
        assert_eq!(value[0]["value"], "-1.5e-7");
        assert_eq!(value[0]["k"], 1);
        assert_eq!(value[1]["value"], Value::Null);
        assert_eq!(value[1]["says"], 0.25);
    }

    #[test]
    fn what_is_said_becomes_a_field() {
        let mut table = sample();
        table.said("poles", "real poles", 0_usize.into());
        let value: Value = serde_json::from_str(&table.render(Format::Json)).unwrap();
        assert_eq!((&value["poles"], &value["rows"][0]["k"]), (&0.into(), &1.into()));
        assert!(table.render(Format::Text).ends_with("\nNote.\nreal poles: 0\n"));
    }

    #[test]
    fn latex_and_markdown_escape() {
        let latex = sample().render(Format::Latex);
        assert!(latex.contains("$1$ & $-1.5\\cdot10^{-7}$ & a|b, 100 \\% \"c\" \\\\\n"), "{latex}");
        let markdown = sample().render(Format::Markdown);
        assert!(markdown.contains("| 1 | -1.5e-7 | a\\|b, 100 % \"c\" |\n"), "{markdown}");
    }
}
