//! What `restitution pade` prints: regenerated constants, verdicts, maps and recommendations.

use crate::pade_series::delayed_recovery;
use crate::support::in_snapshots;
use num_rational::BigRational;
use restitution_direct::{Collision, End};
use restitution_law::ForceLaw;
use restitution_pade::table_one;
use restitution_real::{Ball, Balls};
use restitution_series::{DelayedRecovery, Quantity, coefficients};
use std::ffi::OsString;

/// What the command prints for the words of `line`.
fn printed(line: &str) -> String {
    let folder = tempfile::tempdir().unwrap();
    let file = folder.path().join("table");
    let words = ["restitution", "pade"].into_iter().chain(line.split_whitespace()).chain(["-o"]);
    let words = words.map(OsString::from).chain([file.clone().into_os_string()]);
    restitution_cli::run(words).unwrap();
    std::fs::read_to_string(file).unwrap()
}

/// What the command says when it refuses.
fn refused(line: &str) -> String {
    let words = ["restitution", "pade"].into_iter().chain(line.split_whitespace()).map(OsString::from);
    restitution_cli::run(words).unwrap_err().to_string()
}

/// Rows of a CSV table, header left out.
fn rows(csv: &str) -> Vec<Vec<String>> {
    let mut reader = csv.lines().skip(1).map(|line| line.split(',').map(str::to_owned).collect());
    std::iter::from_fn(move || reader.next()).collect()
}

/// Whether `value` rounds to `printed`, to as many decimals as `printed` has.
fn rounds_to(value: &str, printed: &str) -> bool {
    let decimals = printed.split_once('.').map_or(0, |(_, fraction)| fraction.len());
    format!("{:.decimals$}", value.parse::<f64>().unwrap()) == printed
}

#[test]
fn constants_of_the_literature() {
    let table = printed("--list literature --digits 40");
    in_snapshots("pade", || insta::assert_snapshot!("literature", table));
    let csv = printed("--list literature --digits 20 --format csv");
    let mut compared = 0;
    for line in csv.lines().skip(1) {
        let cells: Vec<_> = line.rsplitn(3, ',').collect();
        let (value, printed) = (cells[0], cells[1]);
        if !printed.is_empty() {
            // Six digits of a_3 and a_4 leave the last digit of Table I open: see the next test.
            assert!(rounds_to(value, printed) || line.contains("printed a_3"), "{line}");
            compared += 1;
        }
    }
    assert_eq!(compared, 7 + 7 + 11, "Table I, [1/4] and [3/6]");
}

/// The closed formulas with a_3 and a_4 anywhere within their last printed digit.
#[test]
fn table_one_as_printed() {
    let within = |millionths: i64| {
        let half_unit = rug::Float::with_val(32, 5e-7);
        Ball::from_ratio(millionths, 1_000_000, 100).widened(&half_unit)
    };
    let closed =
        table_one(&Balls::new(100), &Ball::from_ratio(3, 5, 100), &within(315_119), &within(161_167))
            .unwrap();
    let enclosures = closed.num()[1..].iter().chain(&closed.den()[1..]);
    for (enclosure, ten_thousandths) in enclosures.zip([25_839, 35_839, 29_839, 11_487, 3_265]) {
        let rounding = rug::Float::with_val(32, 5e-5);
        let printed = Ball::from_ratio(ten_thousandths, 10_000, 100).widened(&rounding);
        assert!(printed.overlaps(enclosure), "{printed:?} {enclosure:?}");
        assert!(enclosure.rad().to_f64() < 2e-3, "{enclosure:?}");
    }
}

#[test]
fn honest_counterparts_of_table_one() {
    let csv = printed("--list literature --digits 20 --format csv");
    let values = |what: &str| -> Vec<f64> {
        let lines = csv.lines().filter(|line| line.contains(what));
        lines.map(|line| line.rsplit(',').next().unwrap().parse().unwrap()).collect()
    };
    // Solved with another program from the coefficients of section 4 of the derivation.
    let expected: [(&str, [f64; 5]); 2] = [
        ("exact a_3, a_4, a_5 = 0", [2.2667616, 3.2667616, 2.6667616, 1.0474337, 0.36343657]),
        ("\"[1/4] in s\"", [-0.30244058, 0.69755942, 0.097559415, 0.019752793, 0.001875247]),
    ];
    for (what, expected) in expected {
        let what = if csv.contains(what) { what } else { ",[1/4] in s," };
        let values: Vec<f64> = values(what).into_iter().filter(|v| *v != 1.0).collect();
        assert_eq!(values.len(), 5, "{what}");
        for (value, expected) in values.iter().zip(expected) {
            assert!((value - expected).abs() < 1e-7, "{what}: {value} {expected}");
        }
    }
}

#[test]
fn two_point_constants() {
    let lines = [
        "1 6 --at-infinity",
        "2 7 --at-infinity=2",
        "3 8 --variable s --at-infinity",
        "0 5 --at-infinity=2 --form continued-fraction",
    ];
    let tables: Vec<_> = lines.iter().map(|line| printed(&format!("{line} --digits 30"))).collect();
    in_snapshots("pade", || insta::assert_snapshot!("two_point", tables.join("\n\n")));
    // p_L/q_M = R^5, printed by an integration that shares nothing with the series.
    let csv = rows(&printed("1 6 --at-infinity --format csv"));
    let last = |part: &str| csv.iter().rfind(|row| row[0] == part).unwrap()[2].parse::<f64>().unwrap();
    assert!((last("num") / last("den") - 5.158_381_704_267_685).abs() < 1e-14);
}

#[test]
fn maps_of_the_table() {
    let tables = [
        printed("--table 5"),
        printed("--table 4 --end zero-force"),
        printed("--table 3 --variable sqrt-u --range 0,1"),
    ];
    in_snapshots("pade", || insta::assert_snapshot!("maps", tables.join("\n\n")));
}

#[test]
fn verdicts_are_fields_in_json() {
    let json: serde_json::Value = serde_json::from_str(&printed("1 4 --variable s --format json")).unwrap();
    assert_eq!((&json["exact_type"], &json["zeros"]), (&"[1/4]".into(), &1.into()));
    assert_eq!(json["rows"][1]["part"], "num");
    assert_eq!(json["bounds"], "not positive everywhere");
    let healthy: serde_json::Value =
        serde_json::from_str(&printed("3 6 --end zero-force --format json")).unwrap();
    assert_eq!((&healthy["poles"], &healthy["bounds"]), (&0.into(), &"within (0, 1]".into()));
}

#[test]
fn other_laws() {
    // Hertzian discs with viscous damping: u ~ g^(1/3), so eps falls off like u^(-3).
    let csv = rows(&printed("0 3 --law 2,1 --at-infinity --format csv"));
    assert_eq!(csv.len(), 5);
    assert!(refused("1 6 --law 2,1 --at-infinity").contains("denominator 3 degrees above"));
    assert!(refused("1 6 --law 1,0 --at-infinity").contains("leave --at-infinity out"));
}

#[test]
fn requests_that_make_no_sense() {
    let cases = [
        ("-1 4", "give one from 0 to 300"),
        ("1 -4", "give one from 0 to 300"),
        ("1 100000000000000000000000", "give one from 0 to 300"),
        ("1.5 4", "give one from 0 to 300"),
        ("1", "<M>"),
        ("--table 1000", "give one from 0 to 40"),
        ("--table 3 1 4", "cannot be used with"),
        ("1 4 --at-infinity", "denominator 5 degrees above"),
        ("1 6 --at-infinity=9", "at most 6 conditions"),
        ("1 6 --at-infinity=0", "give one from 1 to 300"),
        ("1 11 --end zero-force --at-infinity", "leave --at-infinity out"),
        ("1 4 --end zero-force --variable u", "give --variable sqrt-u"),
        ("1 4 --range 2,2", "0 <= LOW < HIGH"),
        ("1 4 --range 2,1", "0 <= LOW < HIGH"),
        ("1 4 --range -1,1", "0 <= LOW < HIGH"),
        ("1 4 --range 0,1e9", "0 <= LOW < HIGH"),
        ("1 4 --range 1", "LOW,HIGH"),
        ("1 4 --error 0", "1e-24 to below 1"),
        ("1 4 --error x", "write it as"),
        ("1 4 --digits 0", "give one from 1"),
        ("1 4 --variable w", "possible values"),
        ("1 4 --law 1,2 --end zero-force", "A > GAMMA"),
    ];
    for (line, remedy) in cases {
        let message = refused(line);
        assert!(message.contains(remedy), "{line}: {message}");
    }
}

/// `sum h_k u^(k/2)` at `u = 1/100` against direct integration to the point of zero force.
#[test]
fn half_powers_agree_with_direct_integration() {
    let spheres = ForceLaw::viscoelastic_spheres();
    let h = coefficients(Quantity::DelayedRecovery, &spheres, 24, 30).unwrap();
    let root = Ball::from_ratio(1, 10, 200);
    let sum = h.iter().rev().fold(Ball::from_integer(0, 200), |sum, h| sum * &root + h);
    let direct = Collision::new(&spheres, End::ZeroForce).unwrap();
    let certified = direct.epsilon(&BigRational::new(1.into(), 100.into()), 30).unwrap();
    let gap = (sum - certified).abs().upper().to_f64();
    assert!(gap < 1e-24, "{gap}"); // the next terms, below 0.1 * 10^-25 each
    assert!(gap > 1e-28, "the cut-off shows: {gap}");
}

#[test]
fn the_gain_of_delayed_recovery() {
    let gain = DelayedRecovery::new(&ForceLaw::viscoelastic_spheres()).unwrap().psi(12);
    assert_eq!(gain, delayed_recovery(13), "from the phase plane");
    let lines: Vec<_> = gain.iter().enumerate().map(|(k, c)| format!("{k:>2}  {c}")).collect();
    in_snapshots("pade", || insta::assert_snapshot!("recovery_gain", lines.join("\n")));
}

#[test]
fn recommended_approximants() {
    let table = printed("--list recommended");
    in_snapshots("pade", || insta::assert_snapshot!("recommended", table));
}

/// The lines of a table that carry constants.
fn constants_of(line: &str) -> Vec<Vec<String>> {
    rows(&printed(&format!("{line} --digits 20 --format csv")))
}

/// Time reversal makes the coefficient of `u^10` in `1/eps` exactly zero, which no enclosure shows.
#[test]
fn a_block_that_time_reversal_makes() {
    let expected = constants_of("0 9");
    assert_eq!(expected.len(), 11);
    for same in ["0 10", "1 9", "1 10"] {
        assert_eq!(constants_of(same), expected, "{same}");
    }
    let table = printed("1 10");
    assert!(table.contains("exact type: [0/9]") && table.contains("order of contact at 0: 11"), "{table}");
    assert_eq!(constants_of("2 10").len(), 14);
    // Viscoelastic bodies with a = 2 have p = 1/3: the coefficient of u^6.
    assert_eq!(constants_of("0 6 --law 2,1"), constants_of("0 5 --law 2,1"));
}

#[test]
fn a_range_beyond_critical_damping_is_cut_short() {
    for (line, end) in
        [("1 2 --law 1,0", 1.99), ("2 1 --law 1,0", 1.99), ("0 1 --law 3,1/2 --range 1,9", 1.3)]
    {
        let table = printed(line);
        let note =
            table.lines().find(|l| l.contains("critical damping")).unwrap_or_else(|| panic!("{table}"));
        let shown: f64 = note.rsplit(' ').next().unwrap().parse().unwrap();
        assert!(shown >= end && shown < end + 0.04, "{note}");
        assert!(table.contains(&format!("<= u <= {shown}:")), "{table}");
    }
    let beyond = refused("1 2 --law 1,0 --range 2,3");
    assert!(beyond.contains("give --range with a smaller end"), "{beyond}");
}
