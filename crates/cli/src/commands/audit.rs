//! `restitution audit`: the statements of the papers, one by one, with verdict.

use crate::output::Format;
use crate::progress::Progress;
use crate::{Cell, CliError, OutputArgs, Table};
use restitution_audit::{Judged, TrueValues, audit, check_names, count, markdown, remarks, sections};
use std::fmt::Write;

/// Arguments of `restitution audit`.
#[derive(Debug, clap::Args)]
#[command(after_help = "Examples:\n  restitution audit\n  restitution audit A26 A27 A32\n  \
    restitution audit --format markdown")]
pub struct AuditArgs {
    /// Show the workings of these claims only: equations such as A26, or TableI, Fig1, MP2011
    #[arg(value_name = "CLAIM")]
    claims: Vec<String>,
    #[command(flatten)]
    output: OutputArgs,
}

type Sections = [(&'static str, Vec<Judged>)];

impl AuditArgs {
    /// Judges the claims and prints them.
    ///
    /// # Errors
    ///
    /// Usage if a claim is not known; what the computations and the output say.
    pub fn run(&self) -> Result<(), CliError> {
        self.output.check()?;
        check_names(&self.claims)?;
        let total = sections().iter().map(|section| section.claims.len()).sum::<usize>();
        let progress = Progress::steps("claims", total as u64);
        let judged = audit(&TrueValues::new()?, &self.claims, &mut || progress.advance(1))?;
        drop(progress);
        match self.output.format {
            Format::Text if self.claims.is_empty() => self.output.target.write(&lines(&judged)),
            Format::Text => self.output.target.write(&workings(&judged)),
            Format::Markdown => self.output.target.write(&markdown(&judged)),
            _ => self.output.print(&table(&judged)),
        }
    }
}

/// One line for each claim, and the count.
fn lines(sections: &Sections) -> String {
    let mut out = String::new();
    for (title, judged) in sections {
        let _ = writeln!(out, "{title}");
        for Judged { claim, finding } in judged {
            let what = if claim.printed.contains(['=', '<']) {
                format!("{}: {}", claim.statement, finding.computed)
            } else {
                format!("{}: printed {}, computed {}", claim.statement, claim.printed, finding.computed)
            };
            let _ = writeln!(out, "  {:14}  {:9}  {what}", claim.id, finding.verdict.word());
        }
    }
    let _ = writeln!(out, "\n{}", count(sections));
    out + "'restitution audit NAME' shows the workings of a claim\n"
}

/// All there is to say about each claim.
fn workings(sections: &Sections) -> String {
    let mut out = String::new();
    for judged in sections.iter().flat_map(|(_, judged)| judged) {
        let Judged { claim, finding } = judged;
        let _ = writeln!(out, "{}: {}", claim.id, claim.statement);
        let _ = writeln!(out, "  printed   {}", claim.printed.replace("; ", "\n            "));
        let _ = writeln!(out, "  computed  {}", finding.computed);
        let _ = writeln!(out, "  verdict   {}", finding.verdict);
        for remark in remarks(judged) {
            let _ = writeln!(out, "            {remark}");
        }
        let _ = writeln!(out, "  shown by  {}\n", claim.command);
    }
    out + &count(sections) + "\n"
}

fn table(sections: &Sections) -> Table {
    let mut table =
        Table::new(&["claim", "statement", "printed", "computed", "verdict", "remarks", "command"])
            .titled("The statements of the papers");
    for judged in sections.iter().flat_map(|(_, judged)| judged) {
        let Judged { claim, finding } = judged;
        table.push(vec![
            claim.id.into(),
            claim.statement.into(),
            Cell::text(&claim.printed),
            Cell::text(&finding.computed),
            Cell::text(&finding.verdict),
            Cell::text(remarks(judged).join("; ")),
            claim.command.into(),
        ]);
    }
    table.note(count(sections));
    table
}
