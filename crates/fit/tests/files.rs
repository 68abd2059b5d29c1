//! Files as spreadsheets, digitisers, loggers and simulations write them.

use restitution_fit::sheet::{Decimal, Dialect, Separator};
use restitution_fit::{Data, DataOptions, Method};

fn read(text: &[u8]) -> Result<Data, String> {
    Data::read(text.to_vec(), &DataOptions::default()).map_err(|error| error.to_string())
}

/// The pairs in m/s.
fn pairs(data: &Data) -> Vec<(f64, f64)> {
    let rounded = |x: f64| format!("{x:.9e}").parse::<f64>().unwrap();
    data.rows.iter().map(|row| (rounded(row.velocity() * data.unit_size), rounded(row.epsilon()))).collect()
}

#[test]
fn one_table_in_many_hands() {
    let wanted = [(0.01, 0.5), (0.0203, 0.4), (1.2, 0.25)];
    let files: &[&[u8]] = &[
        b"g[cm/s],epsilon\n1,0.5\n2.03,0.4\n120,0.25\n",
        b"g[cm/s];epsilon\r\n1;0,5\r\n2,03;0,4\r\n120;0,25\r\n",
        b"v (cm/s)\te\r1\t0.5\r2.03\t0.4\r120\t0.25",
        b"  v / cm/s    COR\n  1.0D+00  5.0D-01\n  2.03D0   4.0D-01\n  1.2d2  0.25\n",
        b"# digitised\n% again\n0.01 0.5\n\n0.0203 0.4   # second\n1.2 0.25\n",
        b"\xef\xbb\xbf\"impact velocity, mm/s\",\"coefficient of restitution\"\n\"10\",\"0.5\"\n\"20.3\",\"0.4\"\n\"1,200.0\",\"0.25\"\n",
        b"run;impact_velocity_cm_s;remark;eps;\na;1;first;50%;\nb;2.03;;40%;\nc;120;last;25%;\n",
        b"velocity\trestitution\nm s-1\t-\n1e-2\t0.5\n2.03e-2\t0.4\n1.2\t0.25\n",
        b"| v [m\xb7s^-1] | e [%] |\n|---|---|\n| 0.01 | 50 |\n| 0.0203 | 40 |\n| 1.2 | 25 |\n",
        b"# v[cm/s] epsilon\n1 0.5\n2.03 0.4\n120 0.25\n",
        b"Logger 3000\nDate: today\nspeed [km/h],COR\n0.036,1/2\n0.07308,2/5\n4.32,1/4\n",
        b"\xff\xfeg\x00\t\x00e\x00\n\x000\x00,\x000\x001\x00\t\x000\x00,\x005\x00\n\x000\x00,\x000\x002\x000\x003\x00\t\x000\x00,\x004\x00\n\x001\x00,\x002\x00\t\x000\x00,\x002\x005\x00\n\x00",
        b"g, e\n0.01, 0.5\n0.0203, 0.4\n1.2, 0.25",
        b"g, e\n0,01, 0,5\n0,0203, 0,4\n1,2, 0,25",
        b"v;e\n1cm/s;0.5\n2.03 cm/s;0.4\n120cm/s;0.25\n",
        b"0,01 0,5\n0,0203 0,4\n1,2 0,25\n",
        b"sep=;\r\nGeschwindigkeit [cm/s];Sto\xdfzahl\r\n1,0;0,5\r\n2,03;0,4\r\n120;0,25\r\n",
        b"Vn_impact (mm s^{-1}),Coeff. of Restitution\n10,0.5\n20.3,0.4\n1'200,0.25\n",
        b"v\xa0e\n0.01\xa00.5\n0.0203\xa00.4\n1.2\xa00.25\n",
        b"velocity (cm per s);restitution coeff\n1;0.5\n2.03;0.4\n120;0.25\n",
        "v₀ (m·s⁻¹)\tε\n0.01\t0.5\n0.0203\t0.4\n1.2\t0.25\n".as_bytes(),
        "vitesse d'impact (m/s);coefficient de restitution\n0,01;0,5\n0,0203;0,4\n1,2;0,25\n".as_bytes(),
    ];
    for file in files {
        let data = read(file).unwrap_or_else(|error| panic!("{}: {error}", String::from_utf8_lossy(file)));
        assert_eq!(pairs(&data), wanted, "{}", String::from_utf8_lossy(file));
    }
    assert_eq!(pairs(&read("v [ft/s];ε\n1;0,9\n".as_bytes()).unwrap()), [(0.3048, 0.9)]);
    assert_eq!(pairs(&read("v [µm/s];ε\n1;0,9\n".as_bytes()).unwrap()), [(1e-6, 0.9)]);
}

#[test]
fn what_can_be_read_in_two_ways_is_asked_about() {
    for (text, part) in [
        (
            "g;epsilon\n1,203;1/2\n",
            "line 2: '1,203' may mean 1.203 or 1203: give --decimal point or --decimal comma",
        ),
        ("g;epsilon\n1,203;0.5\n", "'1,203' may mean"),
        ("1,203\n2,406\n", "the commas of '1,203' may separate columns or decimals"),
        ("0,5\n0,6\n", "the commas of '0,5' may separate columns or decimals"),
        ("0,1, 0,5\n0,2, 0,4\n", "may separate columns or decimals"),
        ("g;e\n1.203;0,5\n", "'1.203' may mean"),
        ("g;e\n1,5;0.5\n", "'1,5' has a decimal comma and '0.5' in line 2 a decimal point"),
    ] {
        let message = read(text.as_bytes()).unwrap_err();
        assert!(message.contains(part), "{text:?}: {message}");
    }
    // what decides: a leading zero, more or fewer than three digits, or the option
    assert_eq!(pairs(&read(b"g;epsilon\n1,203;0,512\n").unwrap()), [(1.203, 0.512)]);
    let told = |decimal| {
        let dialect = Dialect { decimal: Some(decimal), separator: None };
        let options = DataOptions { dialect, ..DataOptions::default() };
        pairs(&Data::read(b"g;epsilon\n1,203;1/2\n".to_vec(), &options).unwrap())
    };
    assert_eq!((told(Decimal::Comma), told(Decimal::Point)), (vec![(1.203, 0.5)], vec![(1203.0, 0.5)]));
    let dialect = Dialect { separator: Some(Separator::Comma), decimal: None };
    let options = DataOptions { dialect, ..DataOptions::default() };
    assert_eq!(pairs(&Data::read(b"2,1\n3,1\n".to_vec(), &options).unwrap()), [(2.0, 1.0), (3.0, 1.0)]);
}

#[test]
fn columns_are_picked_by_name_or_number() {
    let table = b"time,x,y,err\n1,0.1,0.9,0.01\n2,0.2,0.8,0.02\n";
    let with = |columns: &str| {
        let options = DataOptions { columns: Some(columns.into()), ..DataOptions::default() };
        Data::read(table.to_vec(), &options).map_err(|error| error.to_string())
    };
    let wanted = [(0.1, 0.9), (0.2, 0.8)];
    for columns in ["2,3", "x,y", "x,3", "epsilon=3,velocity=x", "X,Y", "2,3,4", "x,y,sigma=err"] {
        assert_eq!(pairs(&with(columns).unwrap()), wanted, "{columns}");
    }
    assert_eq!(with("2,3,4").unwrap().rows[1].sigma(), Some(0.02));
    for (columns, part) in [
        ("2", "names no column for the coefficient"),
        ("2,9", "there is no column 9: give a number from 1 to 4"),
        ("2,z", "no column is called 'z'"),
        ("2,2", "gives a column twice"),
        ("colour=2,3", "names a column for nothing that is used"),
    ] {
        let message = with(columns).unwrap_err();
        assert!(
            message.contains(part) && message.contains("'time', 'x', 'y', 'err'"),
            "{columns}: {message}"
        );
    }
    let message = read(table).unwrap_err();
    assert!(
        message.contains(
            "line 1 has 4 columns separated by commas: 'time', 'x', 'y', 'err'; no column holds the velocity"
        ),
        "{message}"
    );
    assert!(message.contains("--columns VELOCITY,EPSILON by name or number"), "{message}");
}

#[test]
fn other_measurements_become_coefficients() {
    let drops = read(b"drop height [cm],rebound height [cm]\n20,5\n80,7.2\n").unwrap();
    assert_eq!(drops.method, Method::Heights);
    let fallen = (2.0 * 9.80665 * 0.2_f64).sqrt();
    assert!((drops.rows[0].velocity() - fallen).abs() < 1e-12 && drops.rows[0].epsilon() == 0.5);
    assert!((drops.rows[1].epsilon() - 0.3).abs() < 1e-12);

    let speeds = read(b"v before [mm/s];v after [cm/s]\n-200;10,5\n-400;8\n").unwrap();
    assert_eq!((speeds.method, speeds.unit.as_str()), (Method::Speeds, "mm/s"));
    assert_eq!(pairs(&speeds), [(0.2, 0.525), (0.4, 0.2)]);

    let bounces = read(b"t [ms]\n0\n400\n700\n900\n0\n500\n900\n").unwrap();
    assert_eq!((bounces.method, bounces.lines.as_slice()), (Method::Bounces, &[3, 4, 7][..]));
    assert_eq!(pairs(&bounces)[2], (0.25 * 9.80665, 0.8));
    assert!(bounces.remarks.iter().any(|remark| remark.starts_with("2 series")), "{:?}", bounces.remarks);

    let timed = read(b"v,e,contact time [us]\n1,0.5,120\n").unwrap();
    assert!((timed.durations[0] - 1.2e-4).abs() < 1e-18);
}

#[test]
fn faults_are_named_with_their_line() {
    for (text, part) in [
        ("", "is empty"),
        ("# only\n% remarks\n", "is empty"),
        ("g,epsilon\n", "has no row below the header in line 1"),
        (
            "g,epsilon\n1,0.5\n,0.4\n",
            "line 3: the velocity is blank: fill it in, delete the line or give --skip-missing",
        ),
        ("g,epsilon\n1,NaN\n", "line 2: the coefficient 'NaN' is not a number"),
        ("g,epsilon\n1,fast\n", "line 2: the coefficient 'fast' is not a number"),
        ("g,epsilon\n1,0.5,3\n", "line 2: there are 3 cells under 2 columns"),
        ("g,epsilon\n0,1,0,5\n", "if commas are decimal signs"),
        ("g[cm/s],epsilon\n1,0.5\n1mm/s,0.5\n", "line 3: the velocity '1mm/s' is in another unit"),
        ("g,v,epsilon\n1,1,0.5\n", "more than one column could hold the velocity"),
        ("time,epsilon\n1,0.5\n", "no column holds the velocity"),
        ("1 2 3\n4 5 6\n", "there is no header and 3 columns separated by blanks"),
        ("0.5 30\n0.4 50\n", "if the columns are exchanged, give --columns 2,1"),
        ("v [cm];e\n1;0,5\n", "line 1: 'cm' is a unit of length, not of velocity"),
        ("v [furlong];e\n1;0,5\n", "line 1: 'furlong' is not a unit of velocity"),
        ("g,e [J]\n1,0.5\n", "give them as plain numbers or in %"),
        ("hello\n", "line 1 reads 'hello'"),
        ("g,epsilon\n-1,0.5\n", "line 2: an impact velocity of -1.0 cannot be used"),
        ("v,e,sigma\n1,0.5,0\n", "a standard deviation of 0.0 cannot be used"),
        ("t\n1\n2\n", "2 times of impacts make no collision"),
        ("v,e\n0.1,0.81±0.01\n", "'0.81±0.01' has its uncertainty beside it"),
        ("v e\n0.1 0.81(1)\n", "'0.81(1)' has its uncertainty beside it"),
        ("[[0.1,0.81],[0.5,0.72]]\n", "line 1 reads '[[0.1,0.81],[0.5,0.72]]'"),
        ("   v   e\n0  0.1  0.81\n1  0.5  0.72\n", "name each column, that of row numbers too"),
        ("bounce,time (s)\n1,0.0\n2,0.4\n3,0.7\n", "--measured-as for speeds, heights or times of bounces"),
    ] {
        let message = read(text.as_bytes()).unwrap_err();
        assert!(message.contains(part), "{text:?}: {message}");
    }
    let options = DataOptions { skip_missing: true, ..DataOptions::default() };
    let data = Data::read(b"g,epsilon\n1,0.5\n,0.4\nn/a,1\n2,0.4\n".to_vec(), &options).unwrap();
    assert_eq!(data.lines, [2, 5]);
    assert!(
        data.remarks.contains(&"2 rows without a value left out, the first in line 3.".to_owned()),
        "{:?}",
        data.remarks
    );
}

#[test]
fn a_first_row_without_a_value_is_a_row() {
    for (first, says) in [
        ("0.1,", "line 2: the coefficient is blank"),
        (",0.9", "line 2: the velocity is blank"),
        ("inf,0.9", "'inf' is not a number"),
    ] {
        let text = format!("v,e\n{first}\n0.2,0.85\n0.5,0.8\n");
        let message = read(text.as_bytes()).unwrap_err();
        assert!(message.contains(says), "{message}");
        let options = DataOptions { skip_missing: true, ..DataOptions::default() };
        let data = Data::read(text.into_bytes(), &options).unwrap();
        assert_eq!((data.rows.len(), data.lines[0]), (2, 3), "{first}");
    }
    // separators that end each line make no column
    assert_eq!(read(b"v,e,\n0.1,0.9,\n0.2,0.8,\n").unwrap().rows.len(), 2);
}

proptest::proptest! {
    #[test]
    fn any_bytes_are_read_or_refused(bytes in proptest::collection::vec(proptest::prelude::any::<u8>(), 0..200)) {
        let _ = Data::read(bytes, &DataOptions::default());
    }

    #[test]
    fn any_text_is_read_or_refused(text in "[ge,;\t .0-9%#\"'/\\[\\]\n\r()|µ-]{0,120}") {
        let _ = Data::read(text.into_bytes(), &DataOptions::default());
    }

    #[test]
    fn what_was_written_is_read(
        rows in proptest::collection::vec((1e-6..1e3_f64, 0.01..1.5_f64), 1..30),
        separator in 0..3_usize, comma: bool, unit in 0..3_usize, end in 0..3_usize, header: bool,
    ) {
        let (separator, end) = ([";", "\t", " "][separator], ["\n", "\r\n", "\r"][end]);
        let (unit, size) = [("m/s", 1.0), ("mm s-1", 1e-3), ("cm·s⁻¹", 1e-2)][unit];
        let number = |x: f64| if comma { format!("{x:.5}").replace('.', ",") } else { format!("{x:.5}") };
        let head = if header { format!("v [{unit}]{separator}epsilon{end}") } else { String::new() };
        let size = if header { size } else { 1.0 };
        let lines = rows.iter().map(|(g, e)| format!("{}{separator}{}{end}", number(*g + 1e-4), number(*e))).collect::<String>();
        let data = read(format!("{head}{lines}").as_bytes()).map_err(proptest::test_runner::TestCaseError::fail)?;
        for (row, (g, e)) in data.rows.iter().zip(&rows) {
            proptest::prop_assert!((row.velocity() - (g + 1e-4)).abs() <= 0.6e-5, "{row:?}");
            proptest::prop_assert!((row.epsilon() - e).abs() <= 0.6e-5);
        }
        proptest::prop_assert_eq!((data.rows.len(), data.unit_size), (rows.len(), size));
    }
}
