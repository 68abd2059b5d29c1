//! `restitution pade`: places of zeros, and series from files.

use crate::support::{fail, succeed};
use std::fs;

/// What stands behind a label below the table.
fn said<'a>(out: &'a str, label: &str) -> &'a str {
    let line = out.lines().find_map(|line| line.strip_prefix(label)?.strip_prefix(": "));
    line.unwrap_or_else(|| panic!("no {label} in {out}"))
}

#[test]
fn zeros_come_with_their_places() {
    // the numerator of [2/1] is a quadratic, whose zeros are known in closed form
    let out = succeed("pade 2 1 --digits 15");
    let constant = |k: usize| {
        let row = out.lines().filter(|line| line.starts_with("num")).nth(k).unwrap();
        row.split_whitespace().last().unwrap().parse::<f64>().unwrap()
    };
    let (a, b) = (constant(2), constant(1));
    let root = (b * b - 4.0 * a).sqrt();
    let found =
        said(&out, "zeros at u").split(", ").map(|place| place.parse::<f64>().unwrap()).collect::<Vec<_>>();
    for (place, wanted) in found.iter().zip([(-b - root) / (2.0 * a), (-b + root) / (2.0 * a)]) {
        assert!((place / wanted - 1.0).abs() < 1e-9, "{place} {wanted}");
    }
    assert_eq!(found.len(), 2);
    assert!(!succeed("pade 0 3").contains("zeros at"));
}

#[test]
fn a_series_of_ones_own() {
    let folder = tempfile::tempdir().unwrap();
    let path = folder.path().join("series.txt");
    let name = path.display();
    // exp(-x): [2/2] is (1 - x/2 + x^2/12)/(1 + x/2 + x^2/12)
    fs::write(&path, "\u{feff}1 -1\r\n0.5; -1/6,1/24 # exp\n").unwrap();
    let out = succeed(&format!("pade 2 2 --series {name} --format csv"));
    let wanted = "part,k,value,decimal\nnum,0,1,1\nnum,1,-1/2,-0.50000000000000000\nnum,2,1/12,0.083333333333333333\n\
        den,0,1,1\nden,1,1/2,0.50000000000000000\nden,2,1/12,0.083333333333333333\n";
    assert_eq!(out, wanted);
    // tan x/x in x^2: [1/1] = (1 - x/15)/(1 - 2 x/5), a pole at 5/2 (near (pi/2)^2), a zero at 15
    fs::write(&path, "1\n1/3\n2/15\n").unwrap();
    let out = succeed(&format!("pade 1 1 --series {name}"));
    assert_eq!((said(&out, "poles at x"), said(&out, "zeros at x")), ("2.500000000", "15"), "{out}");
    // a double zero: (1 - x)^2
    fs::write(&path, "1 -2 1").unwrap();
    assert!(said(&succeed(&format!("pade 2 0 --series {name}")), "zeros at x").starts_with('1'));
    for (content, remedy) in [
        (&b"1 2,5 x"[..], "line 1: 'x' is not a number"),
        (b"1\n2\n3/0", "line 3: '3/0' is not a number"),
        (b"1 2", "has 2 coefficients, and [1/1] needs 3"),
        (b"# nothing", "has no coefficient"),
        (b"\xff\xfe\x00", "is not text"),
        (b"1 1e999999999 1", "more than 10000 digits"),
    ] {
        fs::write(&path, content).unwrap();
        let (code, message) = fail(&format!("pade 1 1 --series {name}"));
        assert!(code == 2 && message.contains(remedy), "{message}");
    }
    assert!(fail("pade 1 1 --series /no/such/file").1.contains("no such file"));
    assert!(fail(&format!("pade 1 1 --series {name} --law 1,0")).1.contains("cannot be used with"));
    assert!(fail("pade --table 3 --series x").0 == 2);
}

#[test]
fn tables_to_look_up_are_numbers_in_si() {
    let out = succeed("epsilon --velocity 1cm/s,1m/s --g-star 1cm/s --digits 8 --format lookup");
    let rows = out.lines().filter(|line| !line.starts_with('#')).collect::<Vec<_>>();
    assert_eq!(rows, ["0.01 0.38410920", "1 0.073882358"], "{out}");
    assert!(out.contains("# velocity_in_m_per_s epsilon\n"));
    assert!(out.contains("neighbouring rows is off by at most 2.1e-1 where epsilon bends one way, as it was seen to (docs/codes.md)"), "{out}");
    let fine = succeed("epsilon --velocity 1cm/s:1m/s:40log --g-star 1cm/s --digits 8 --format lookup");
    assert!(fine.contains("is off by at most 1.8e-4"), "{fine}");
    let coarse_digits =
        succeed("epsilon --velocity 1cm/s:1m/s:40log --g-star 1cm/s --digits 3 --format lookup");
    assert!(coarse_digits.contains("is off by at most 1.2e-3"), "{coarse_digits}");
    assert!(
        succeed("epsilon --velocity 1cm/s --g-star 1cm/s --format lookup").contains("nothing to interpolate")
    );
    for line in ["epsilon --u 1e999999999", "epsilon --u 1 --law 1e999999999,1"] {
        assert!(fail(line).1.contains("a number has more than 10000 digits"), "{line}");
    }
}
