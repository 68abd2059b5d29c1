//! Exported sources, in every language whose tools are there, with the flags people use, at hostile arguments.

mod language;

use crate::commands::quoted;
use crate::random::{Source, bits, by_ratio, choose, near};
use crate::sandbox::{Limits, Sandbox};
use crate::{Part, Size, Tally};
use language::{LANGUAGES, Language};
use rand::RngExt;
use restitution::{End, epsilon};
use std::ffi::OsString;
use std::path::{Path, PathBuf};
use std::process::{Command, Stdio};
use std::time::Duration;

/// Arguments of one source.
const ARGUMENTS: usize = 2000;
/// What the evaluator that judges may itself be off, relative: 2 ulp.
const JUDGE: f64 = 4.0 * f64::EPSILON;

/// Exports, compiles and runs sources.
#[derive(Debug)]
pub struct Exports {
    command: PathBuf,
}

impl Exports {
    /// Attacks what the executable `command` exports.
    pub fn new(command: PathBuf) -> Self {
        Self { command }
    }
}

/// What a source was asked to keep.
#[derive(Clone, Copy, Debug)]
struct Asked {
    tolerance: f64,
    low: f64,
    high: f64,
    end: End,
    law_beyond: bool,
}

impl Asked {
    fn new(random: &mut Source) -> Self {
        let low =
            if random.random_bool(0.7) { 0.0 } else { (by_ratio(random, 1e-3, 3.0) * 1e3).round() / 1e3 };
        let high = low + (by_ratio(random, 0.05, 60.0) * 1e2).round() / 1e2 + 0.01;
        Self {
            tolerance: 10f64.powi(-random.random_range(1..=14)),
            low,
            high: (high * 1e3).round() / 1e3,
            end: *choose(random, &[End::ZeroCompression, End::ZeroForce]),
            law_beyond: random.random_bool(0.3),
        }
    }

    fn line(&self, language: &Language) -> Vec<OsString> {
        let end = if self.end == End::ZeroForce { "zero-force" } else { "zero-compression" };
        let beyond = if self.law_beyond { " --beyond law" } else { "" };
        let line = format!(
            "export --lang {} --tolerance {:e} --range {},{} --end {end}{beyond} -o {}",
            language.name, self.tolerance, self.low, self.high, language.file
        );
        line.split(' ').map(OsString::from).collect()
    }

    /// In order within the range, then anything.
    fn arguments(&self, random: &mut Source) -> Vec<f64> {
        let within = |random: &mut Source| {
            let spread = self.low + (self.high - self.low) * random.random::<f64>();
            let grid = (spread * 64.0).round() / 64.0;
            let u = *choose(random, &[spread, grid, self.low, self.high]);
            near(random, u, 2).clamp(self.low, self.high)
        };
        let mut arguments: Vec<f64> = (0..ARGUMENTS / 2).map(|_| within(random)).collect();
        arguments.sort_by(f64::total_cmp);
        let corners = [
            f64::NAN,
            -f64::NAN,
            f64::INFINITY,
            f64::NEG_INFINITY,
            -0.0,
            -1.0,
            5e-324,
            -5e-324,
            f64::MAX,
            1e19,
        ];
        arguments.extend(corners);
        arguments.extend([self.low.next_down(), self.high.next_up()]);
        arguments.extend((0..ARGUMENTS / 2).map(|_| bits(random)));
        arguments
    }
}

impl Part for Exports {
    fn name(&self) -> &'static str {
        "exports"
    }

    fn about(&self) -> &'static str {
        "an exported source in one language, built with many flags, at 2000 arguments: in bounds, in tolerance, falling"
    }

    fn cases(&self, size: Size) -> u64 {
        match size {
            Size::Slice => 2,
            Size::Minutes => 60,
            Size::Full => 600,
        }
    }

    fn attack(&self, random: &mut Source, tally: &mut Tally) {
        let asked = Asked::new(random);
        let language = choose(random, &LANGUAGES);
        if let Err(error) = self.attack_one(language, asked, random, tally) {
            tally.fault(
                "an exported source can be built",
                format!("{}: {error}", quoted(&asked.line(language))),
            );
        }
    }
}

impl Exports {
    fn attack_one(
        &self,
        language: &Language,
        asked: Asked,
        random: &mut Source,
        tally: &mut Tally,
    ) -> std::io::Result<()> {
        let sandbox = Sandbox::new()?;
        let limits = Limits { time: Duration::from_secs(120), ..Limits::default() };
        let outcome = sandbox.run(&self.command, &asked.line(language), Stdio::null(), &limits)?;
        if outcome.code() == 1 {
            tally.example("exports refused: the tolerance cannot be kept", quoted(&asked.line(language)));
            return Ok(());
        }
        if outcome.code() != 0 {
            return Err(std::io::Error::other(outcome.stderr));
        }
        let arguments = asked.arguments(random);
        let text: String = arguments.iter().map(|u| format!("{:016x}\n", u.to_bits())).collect();
        std::fs::write(sandbox.folder().join("arguments"), text)?;
        std::fs::write(sandbox.folder().join(language.driver_file), language.driver)?;
        for build in language.builds {
            let mut built = true;
            for step in *build {
                let Some(output) = run(step, &sandbox.folder(), None)? else {
                    tally.count(
                        &format!("builds skipped: no {}", step.split(' ').next().unwrap_or_default()),
                        1,
                    );
                    built = false;
                    break;
                };
                if !output.status.success() {
                    return Err(std::io::Error::other(format!(
                        "{step}: {}",
                        String::from_utf8_lossy(&output.stderr)
                    )));
                }
            }
            if built && let Some(output) = run(language.run, &sandbox.folder(), Some("arguments"))? {
                tally.count(&format!("programs run, {}", language.name), 1);
                let how = || format!("{}, built by {build:?}", quoted(&asked.line(language)));
                if !output.status.success() {
                    let stderr =
                        String::from_utf8_lossy(&output.stderr).chars().take(300).collect::<String>();
                    tally
                        .fault("no argument and no flag makes a source fail", format!("{}: {stderr}", how()));
                    continue;
                }
                compare(&asked, &arguments, &String::from_utf8_lossy(&output.stdout), &how, tally);
            }
        }
        Ok(())
    }
}

/// Runs a line of words; `None` where the tool is missing.
fn run(line: &str, folder: &Path, input: Option<&str>) -> std::io::Result<Option<std::process::Output>> {
    let mut words = line.split(' ');
    let mut command = Command::new(words.next().unwrap_or_default());
    command.args(words).current_dir(folder).stdin(match input {
        Some(name) => std::fs::File::open(folder.join(name))?.into(),
        None => Stdio::null(),
    });
    match command.output() {
        Err(error) if error.kind() == std::io::ErrorKind::NotFound => Ok(None),
        output => output.map(Some),
    }
}

fn compare(asked: &Asked, arguments: &[f64], output: &str, how: &dyn Fn() -> String, tally: &mut Tally) {
    let values: Vec<f64> = output
        .lines()
        .filter_map(|line| u64::from_str_radix(line.trim(), 16).ok())
        .map(f64::from_bits)
        .collect();
    if values.len() != arguments.len() {
        return tally.fault("a value for every argument", format!("{}: {} values", how(), values.len()));
    }
    tally.count("values of exported sources", values.len() as u64);
    for (u, value) in arguments.iter().zip(&values) {
        let say = || format!("{}: epsilon({u:e} = {:#018x}) = {value:e}", how(), u.to_bits());
        let u = if *u == 0.0 { 0.0 } else { *u };
        if (asked.low..=asked.high).contains(&u) {
            let exact = epsilon(u, asked.end);
            let off = (value / exact - 1.0).abs();
            tally.measure("error of an exported source over its tolerance", off / asked.tolerance);
            tally.expect(off <= asked.tolerance + JUDGE, "a source keeps its tolerance", say);
            tally.expect((0.0..=1.0).contains(value), "0 <= epsilon <= 1", say);
            tally.expect(u != 0.0 || *value == 1.0, "epsilon(0) = 1", say);
        } else if !(u > asked.high && asked.law_beyond) {
            tally.expect(value.is_nan(), "NaN outside the range", say);
        } else if u.is_finite() {
            let exact = epsilon(u, asked.end);
            let off = (value / exact - 1.0).abs();
            let sound = !exact.is_normal() || off <= asked.tolerance + JUDGE;
            tally.expect(
                sound && (0.0..=1.0).contains(value),
                "a source keeps its tolerance beyond its range",
                say,
            );
        }
    }
    let within = arguments.iter().zip(&values).take(ARGUMENTS / 2).collect::<Vec<_>>();
    for pair in within.windows(2) {
        tally.expect(pair[1].1 <= pair[0].1, "a source falls", || {
            format!(
                "{}: from {:e} to {:e} it rises from {:e} to {:e}",
                how(),
                pair[0].0,
                pair[1].0,
                pair[0].1,
                pair[1].1
            )
        });
    }
}
