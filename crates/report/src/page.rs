//! The page: sections with figures, captions and the data behind them.

use crate::chart::{self, Chart, escape};
use crate::machine::Machine;
use restitution_table::{Cell, Format, Table};
use std::fmt::Write as _;

const STYLE: &str = include_str!("page.css");
/// Shows values under the pointer.
const POINTER: &str = include_str!("pointer.js");
/// Marks a page, and with it a folder, as one of this command's.
pub const GENERATOR: &str = "<meta name=\"generator\" content=\"restitution report\">";

/// A table and the file that holds it.
pub struct Data {
    pub file: &'static str,
    pub table: Table,
    /// What the page shows instead, if the table is too long to read.
    pub shown: Option<Table>,
}

impl Data {
    /// Returns a table that the page shows whole.
    pub fn new(file: &'static str, table: Table) -> Self {
        Self { file, table, shown: None }
    }

    /// Returns a table of which the page shows an extract.
    pub fn long(file: &'static str, table: Table, shown: Table) -> Self {
        Self { file, table, shown: Some(shown) }
    }
}

/// A chart with its caption and data; or data alone.
pub struct Figure {
    pub chart: Option<Chart>,
    pub caption: String,
    pub data: Vec<Data>,
}

impl Figure {
    /// Returns a chart without data of its own.
    pub fn new(chart: Chart, caption: &str) -> Self {
        Self { chart: Some(chart), caption: caption.to_owned(), data: Vec::new() }
    }

    /// Returns a table that stands where a chart would.
    pub fn table(caption: &str, data: Data) -> Self {
        Self { chart: None, caption: caption.to_owned(), data: vec![data] }
    }

    /// Adds the data behind the chart.
    pub fn with(mut self, data: Data) -> Self {
        self.data.push(data);
        self
    }
}

/// A part of the page.
pub struct Section {
    pub title: String,
    pub text: String,
    pub figures: Vec<Figure>,
}

impl Section {
    /// Returns a section.
    pub fn new(title: &str, text: &str, figures: Vec<Figure>) -> Self {
        Self { title: title.to_owned(), text: text.to_owned(), figures }
    }
}

/// Returns the whole page.
pub fn html(machine: &Machine, sections: &[Section]) -> String {
    let mut out = format!(
        "<!DOCTYPE html>\n<html lang=\"en\">\n<head>\n<meta charset=\"utf-8\">\n{GENERATOR}\n<meta name=\"viewport\" content=\"width=device-width, initial-scale=1\">\n<meta name=\"color-scheme\" content=\"light dark\">\n<title>Coefficient of restitution: speed, error, stability</title>\n<style>\n{STYLE}{}</style>\n</head>\n<body>\n<main>\n<h1>The coefficient of restitution of viscoelastic spheres: speed, error, stability</h1>\n",
        chart::STYLE
    );
    let _ = writeln!(
        out,
        "<p class=\"lead\">Scaled collision <i>x</i>″ + <i>u</i> √<i>x</i> <i>x</i>′ + <i>x</i><sup>3/2</sup> = 0, <i>x</i>(0) = 0, <i>x</i>′(0) = 1; ε(<i>u</i>) is the speed at the end of contact. The damping <i>u</i> = (3/2) <i>A</i> (ρ/<i>m</i><sub>eff</sub>)<sup>2/5</sup> <i>g</i><sup>1/5</sup> has no unit. Formula and equation numbers are those of Ramírez, Pöschel, Brilliantov and Schwager, Phys. Rev. E 60, 4465 (1999).</p>\n<p>{}</p>",
        escape(&machine.sentence())
    );
    let mut number = 0;
    for section in sections {
        let _ =
            writeln!(out, "<section>\n<h2>{}</h2>\n<p>{}</p>", escape(&section.title), escape(&section.text));
        for figure in &section.figures {
            if figure.chart.is_some() {
                number += 1;
            }
            write_figure(&mut out, figure, number);
        }
        out += "</section>\n";
    }
    let _ = write!(out, "</main>\n<script>\n{POINTER}</script>\n</body>\n</html>\n");
    out
}

fn write_figure(out: &mut String, figure: &Figure, number: usize) {
    let caption = escape(&figure.caption);
    match &figure.chart {
        Some(chart) => {
            let svg = chart.svg();
            let _ = writeln!(
                out,
                "<figure>\n{svg}\n<figcaption><b>Figure {number}.</b> {caption}</figcaption>\n</figure>"
            );
            for data in &figure.data {
                let (file, rows) = (data.file, data.shown.as_ref().unwrap_or(&data.table));
                let part = if data.shown.is_some() { "extract of the " } else { "" };
                let _ = writeln!(
                    out,
                    "<details><summary>Data of figure {number}: {part}table</summary>\n<p><a href=\"{file}\" download>{file}</a></p>\n{}</details>",
                    rows_html(rows)
                );
            }
        }
        None => {
            let _ = writeln!(out, "<p>{caption}</p>");
            for data in &figure.data {
                let (file, rows) = (data.file, data.shown.as_ref().unwrap_or(&data.table));
                let _ = writeln!(
                    out,
                    "{}<p class=\"file\"><a href=\"{file}\" download>{file}</a></p>",
                    rows_html(rows)
                );
            }
        }
    }
}

fn rows_html(table: &Table) -> String {
    let mut out = "<div class=\"table\"><table>\n<thead><tr>".to_owned();
    for column in table.columns() {
        let _ = write!(out, "<th>{}</th>", escape(&column.replace('_', " ")));
    }
    out += "</tr></thead>\n<tbody>\n";
    for row in table.rows() {
        out += "<tr>";
        for cell in row {
            let class = if matches!(cell, Cell::Text(_)) { "" } else { " class=\"number\"" };
            let _ = write!(out, "<td{class}>{}</td>", escape(&cell.plain()));
        }
        out += "</tr>\n";
    }
    out + "</tbody></table></div>\n"
}

/// Returns the files of a report: the page, each chart, each table.
pub fn files(machine: &Machine, sections: &[Section]) -> Vec<(String, String)> {
    let figures = || sections.iter().flat_map(|section| &section.figures);
    let charts = figures().filter_map(|figure| figure.chart.as_ref());
    let charts = charts.map(|chart| (format!("{}.svg", chart.id), chart.file()));
    let data = figures().flat_map(|figure| &figure.data);
    let data = data.map(|data| (data.file.to_owned(), data.table.render(Format::Csv)));
    std::iter::once(("index.html".to_owned(), html(machine, sections))).chain(charts).chain(data).collect()
}
