//! One HTML file to play with ε(g): material, measurements, lines for simulation codes.
//!
//! The file needs no network and no server. `page.html` is its skeleton, `style.css` and `page.js` go into it, and so
//! do the evaluators `zero_compression.js` and `zero_force.js`, which the project's exporter writes (`make tables`): what
//! the page shows is what every exported source of that tolerance gives, bit by bit.

use restitution::{Course, End, epsilon, one_minus_epsilon};

/// The skeleton, with places for what is put in.
const SKELETON: &str = include_str!("page.html");
/// Formula (35) with the constants of Table I as printed, and the six-digit [3/6] formula that YADE inverts.
const PRINTED: &str = "printed: [2.5839, 3.5839, 2.9839, 1.1487, 0.3265], yade: [[1.0, 1.07232, 0.574198, 0.141552], \
    [1.0, 1.07232, 1.72765, 1.37842, 1.19449, 0.467273, 0.235585]]";

/// Returns the page: HTML with its style, its script and its evaluators inside.
///
/// # Examples
///
/// ```
/// let page = restitution_page::page();
/// assert!(page.starts_with("<!DOCTYPE html>") && page.len() < 200_000);
/// assert!(!page.contains("src=") && !page.contains("https://"), "it asks for nothing");
/// assert!(!page.contains("/*SCRIPT") && !page.contains("<!--VERSION"), "every place is filled");
/// ```
pub fn page() -> String {
    SKELETON
        .replace("/*STYLE*/", include_str!("style.css"))
        .replace(
            "/*EVALUATORS*/",
            &[include_str!("zero_compression.js"), include_str!("zero_force.js"), &theory()].join("\n"),
        )
        .replace("/*SCRIPT*/", include_str!("page.js"))
        .replace("<!--VERSION-->", env!("CARGO_PKG_VERSION"))
}

/// What the script knows of the theory besides the evaluators, in JavaScript.
fn theory() -> String {
    let slope = one_minus_epsilon(1e-200, End::ZeroCompression) / 1e-200;
    let saturation = epsilon(1e10, End::ZeroCompression) * 1e50;
    let elastic = Course::follow(0.0, End::ZeroCompression);
    let (duration, compression) =
        elastic.map_or((f64::NAN, f64::NAN), |course| (course.duration, course.maximal_compression));
    format!(
        "const theory = {{ slope: {slope:?}, saturation: {saturation:?}, elastic_duration: {duration:?}, \
         elastic_compression: {compression:?}, {PRINTED} }};\n"
    )
}

/// The README's code runs as a documentation test.
#[cfg(doctest)]
#[doc = include_str!("../README.md")]
struct ReadmeDoctests;
