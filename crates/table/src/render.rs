//! The forms of a table.

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
            Format::Lookup => self.lookup(),
        }
    }

    fn text(&self) -> String {
        let layout = self.layout();
        let mut out = self.title.iter().map(|title| format!("{title}\n\n")).collect::<String>();
        let mut line = String::new();
        let mut add = |cells: &mut dyn Iterator<Item = String>, header: bool| {
            line.clear();
            for (k, (cell, column)) in cells.zip(&layout).enumerate() {
                line.push_str(if k > 0 { "  " } else { "" });
                column.pad(&mut line, &cell, header);
            }
            out.push_str(line.trim_end());
            out.push('\n');
        };
        add(&mut self.columns.iter().cloned(), true);
        for row in &self.rows {
            add(&mut row.iter().map(Cell::plain), false);
        }
        let gap = if self.notes.is_empty() { "" } else { "\n" };
        out + gap + &self.notes.iter().map(|note| format!("{note}\n")).collect::<String>()
    }

    /// How wide each column is; the cells are made twice rather than kept, as there may be millions.
    fn layout(&self) -> Vec<Column> {
        let columns = self.columns.iter().enumerate().map(|(k, name)| {
            let numeric = self.is_numeric(k);
            let (mut before, mut after) = (0, 0);
            for row in &self.rows {
                let cell = row[k].plain();
                let behind = if numeric { behind(&cell) } else { 0 };
                before = before.max(length(&cell) - behind);
                after = after.max(behind);
            }
            Column { numeric, after, width: length(name).max(before + after) }
        });
        columns.collect()
    }

    fn lookup(&self) -> String {
        let comment = |text: &String| format!("# {}\n", text.replace('\n', "\n# "));
        let mut out = self.title.iter().map(comment).collect::<String>();
        out += &self.notes.iter().map(comment).collect::<String>();
        out += &comment(&self.columns.join(" "));
        let whole = |row: &&Vec<Cell>| !row.contains(&Cell::Empty);
        for row in self.rows.iter().filter(whole) {
            out += &row
                .iter()
                .map(|cell| cell.plain().replace(char::is_whitespace, "_"))
                .collect::<Vec<_>>()
                .join(" ");
            out.push('\n');
        }
        out
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
        let (open, inner) = if self.fields.is_empty() { ("[", "  ") } else { ("  \"rows\": [", "    ") };
        let mut out = String::new();
        if !self.fields.is_empty() {
            out += "{\n";
            for (name, value) in &self.fields {
                out += &format!("  {}: {},\n", Value::from(name.as_str()), value.json());
            }
        }
        out += open;
        // row by row, as a tree of a million rows is large
        for (k, row) in self.rows.iter().enumerate() {
            out += if k > 0 { ",\n" } else { "\n" };
            let cells = self.columns.iter().cloned().zip(row.iter().map(Cell::json)).collect::<Map<_, _>>();
            let object = format!("{:#}", Value::Object(cells));
            for (k, line) in object.lines().enumerate() {
                out += if k > 0 { "\n" } else { "" };
                out += inner;
                out += line;
            }
        }
        out += match (self.fields.is_empty(), self.rows.is_empty()) {
            (true, true) => "]\n",
            (true, false) => "\n]\n",
            (false, true) => "]\n}\n",
            (false, false) => "\n  ]\n}\n",
        };
        out
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

/// How a column of the text form is set: texts on the left, numbers with their decimal points in line.
struct Column {
    numeric: bool,
    /// The most characters from the decimal point on.
    after: usize,
    width: usize,
}

impl Column {
    fn pad(&self, line: &mut String, cell: &str, header: bool) {
        let missing = if self.numeric && !header { self.after - behind(cell) } else { 0 };
        // A width of format! ends at 65535, and digits do not.
        let rest = self.width - length(cell) - missing;
        let (left, right) = if self.numeric { (rest, missing) } else { (0, rest) };
        line.extend(std::iter::repeat_n(' ', left));
        line.push_str(cell);
        line.extend(std::iter::repeat_n(' ', right));
    }
}

fn length(text: &str) -> usize {
    text.chars().count()
}

/// The characters from the decimal point on.
fn behind(text: &str) -> usize {
    text.find(['.', 'e', '/']).map_or(0, |point| length(&text[point..]))
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
    fn lookup_has_numbers_alone() {
        let mut table = Table::new(&["velocity", "epsilon"]).titled("Law");
        table.push(vec![0.1.into(), Cell::digits("0.5")]);
        table.push(vec![0.2.into(), Cell::Empty]);
        table.note("Note.");
        assert_eq!(table.render(Format::Lookup), "# Law\n# Note.\n# velocity epsilon\n0.1 0.5\n");
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
