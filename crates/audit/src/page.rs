//! The audit as a page in Markdown.

use crate::{Judged, Verdict};
use std::fmt::Write;

const HEAD: &str = "# Audit of the paper

Written by `restitution audit --format markdown`; a test compares this file with what the command prints.

Every number and checkable statement of [RPBS1999] (equation numbers without a key), and the constants of [MP2011],
beside what this project computes; definitions, assumptions and intermediate steps are not listed. No verdict is
written down anywhere: what is printed is data, the true side comes from the certified and exact engines, and the
comparison decides.

* **holds**: true as it stands; formulas are tested exactly at random rational points, or in balls to 35 digits.
* **holds to its printed digits**: the true number, rounded (or, where it says so, cut off) after the last one.
* **imprecise**: true in a sense that the statement does not give.
* **wrong**: not true; where a slip is named, computing with it gives exactly the printed digits.

Computed numbers have 20 digits, all proved. `restitution audit NAME` shows the workings of one claim. The copy of
[RPBS1999] at hand is a scan, in which a lost sign or index can be the scanner's; where that matters it is said.
";

/// Returns the page.
pub fn markdown(sections: &[(&'static str, Vec<Judged>)]) -> String {
    let mut page = HEAD.to_owned();
    let _ = writeln!(page, "\n{}", count(sections));
    page += &wrong(sections);
    for (title, judged) in sections {
        let _ =
            write!(page, "\n## {title}\n\n| claim | statement | printed | computed | verdict | shown by |\n");
        page += "|:---|:---|:---|:---|:---|:---|\n";
        for Judged { claim, finding } in judged {
            let printed = code(&claim.printed);
            let (computed, verdict) = (escaped(&finding.computed), marked(&finding.verdict));
            let (statement, command) = (escaped(claim.statement), format!("`{}`", claim.command));
            let line = [claim.id, &statement, &printed, &computed, &verdict, &command];
            let _ = writeln!(page, "| {} |", line.join(" | "));
        }
        page += &notes(judged);
    }
    page
}

/// The closing count of verdicts, in one line.
pub fn count(sections: &[(&'static str, Vec<Judged>)]) -> String {
    let all = || sections.iter().flat_map(|(_, judged)| judged);
    let of = |word| all().filter(|judged| judged.finding.verdict.word() == word).count();
    format!(
        "{} claims: {} hold, {} wrong, {} imprecise.",
        all().count(),
        of("holds"),
        of("wrong"),
        of("imprecise")
    )
}

/// What is said of a claim besides its verdict.
pub fn remarks(judged: &Judged) -> Vec<String> {
    let slip = match &judged.finding.verdict {
        Verdict::Wrong(Some(slip)) => Some(slip.clone()),
        Verdict::Wrong(None) => Some("no slip is known that gives what is printed".to_owned()),
        _ => None,
    };
    slip.into_iter().chain(judged.finding.notes.iter().cloned()).collect()
}

fn wrong(sections: &[(&'static str, Vec<Judged>)]) -> String {
    let all = sections.iter().flat_map(|(_, judged)| judged);
    let mut list = String::from("\nWhat is wrong or imprecise:\n\n");
    for Judged { claim, finding } in all.filter(|judged| judged.finding.verdict.word() != "holds") {
        let printed = if claim.printed.contains('=') { String::new() } else { format!(" {}", claim.printed) };
        let _ = writeln!(
            list,
            "* {} ({}){printed}: {}",
            claim.id,
            escaped(claim.statement),
            finding.verdict.word()
        );
    }
    list
}

/// The remarks below a table, equal ones of neighbouring claims once.
fn notes(judged: &[Judged]) -> String {
    let mut groups: Vec<(Vec<&str>, Vec<String>)> = Vec::new();
    for one in judged {
        let remarks = remarks(one);
        match groups.last_mut() {
            Some((ids, known)) if *known == remarks => ids.push(one.claim.id),
            _ => groups.push((vec![one.claim.id], remarks)),
        }
    }
    let mut out = String::new();
    for (ids, remarks) in groups.iter().filter(|(_, remarks)| !remarks.is_empty()) {
        let _ = write!(out, "\n**{}**\n\n", ids.join(", "));
        for remark in remarks {
            let _ = writeln!(out, "* {}", escaped(remark));
        }
    }
    out
}

fn marked(verdict: &Verdict) -> String {
    if verdict.word() == "holds" { verdict.to_string() } else { format!("**{verdict}**") }
}

/// A number as it stands, a formula as code.
fn code(printed: &str) -> String {
    if printed.contains(['=', '^', '<']) {
        format!("`{}`", printed.replace("; ", "`<br>`"))
    } else {
        printed.to_owned()
    }
}

fn escaped(text: &str) -> String {
    text.replace('\\', "\\\\").replace('|', "\\|").replace('*', "\\*").replace('<', "\\<")
}
