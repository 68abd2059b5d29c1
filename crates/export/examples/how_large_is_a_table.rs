//! How large is the table that gives epsilon to a tolerance for `0 <= u <= 2`, and what is its error?

use restitution::End;
use restitution_export::{Beyond, ExportError, InterpolatedCurve, Listing, Request};

fn main() -> Result<(), ExportError> {
    let reference = InterpolatedCurve::up_to(End::ZeroCompression, 2.5)?;
    for tolerance in [1e-2, 1e-4, 1e-8] {
        let request = Request { tolerance, range: (0.0, 2.0), beyond: Beyond::NotANumber };
        let listing = Listing::new(&reference, request)?;
        println!("{}", listing.options());
        listing.head().iter().for_each(|line| println!("    {line}"));
    }
    Ok(())
}
