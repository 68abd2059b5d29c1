//! Which numbers of the appendix of the 1999 paper are wrong, and what slip gives what is printed?

use restitution_audit::{AuditError, TrueValues, audit, remarks};

fn main() -> Result<(), AuditError> {
    let truth = TrueValues::new()?;
    let wanted = ["A26", "A27", "A32"].map(str::to_owned);
    for judged in audit(&truth, &wanted, &mut || ())?.iter().flat_map(|(_, judged)| judged) {
        let (claim, finding) = (&judged.claim, &judged.finding);
        println!(
            "{} {}: printed {}, computed {}",
            claim.id, finding.verdict, claim.printed, finding.computed
        );
        remarks(judged).iter().for_each(|remark| println!("    {remark}"));
    }
    Ok(())
}
