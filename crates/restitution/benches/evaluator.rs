//! The evaluator beside the formulas it replaces, alternating in one run; `make bench` runs it.
//!
//! Latency: each argument depends on the previous result. Batch: 2048 arguments at a time. The figure
//! is the median of the rounds; the spread is how far it lies above the fastest.

use restitution::{
    End, Restitution, epsilon, epsilon_batch, fifth_root, one_minus_epsilon, one_minus_epsilon_batch, tiers,
    u_of_epsilon_batch, u_of_one_minus_epsilon_batch,
};
use std::hint::black_box;
use std::time::Instant;

const ROUNDS: usize = 60;
const LENGTH: usize = 2048;
/// `|C_1|`, in formula (35) of [RPBS1999] with the constants of its Table I.
const C1: f64 = 1.153_449;

/// `a b + c`, fused where the machine can: the formulas get what the evaluator gets.
#[inline(always)]
fn multiply_add(a: f64, b: f64, c: f64) -> f64 {
    if cfg!(target_feature = "fma") { a.mul_add(b, c) } else { a * b + c }
}

/// The six-constant formula (35), by Horner's rule.
#[inline(always)]
fn formula_35(u: f64) -> f64 {
    let s = C1 * u;
    let denominator = multiply_add(s, multiply_add(s, multiply_add(s, 0.3265, 1.1487), 2.9839), 3.5839);
    multiply_add(s, 2.5839, 1.0) / multiply_add(s, denominator, 1.0)
}

/// The [3/6] approximant of [MP2011] with a power per term, as YADE evaluates it, `v = (b g)^(1/10)`.
#[inline(always)]
fn three_six_with_powers(velocity: f64) -> f64 {
    let v = velocity.powf(0.1);
    (1.0 + 1.07232 * v + 0.574198 * v.powf(2.0) + 0.141552 * v.powf(3.0))
        / (1.0
            + 1.07232 * v
            + 1.72765 * v.powf(2.0)
            + 1.37842 * v.powf(3.0)
            + 1.19449 * v.powf(4.0)
            + 0.467273 * v.powf(5.0)
            + 0.235585 * v.powf(6.0))
}

type Contestant<'a> = (&'a str, Box<dyn Fn() -> f64 + 'a>);

/// Times a chain `x -> f(x) + next argument`.
fn chain<'a>(name: &'a str, arguments: &'a [f64], f: impl Fn(f64) -> f64 + 'a) -> Contestant<'a> {
    let run = move || {
        let start = Instant::now();
        let last = arguments.iter().fold(0.0, |value, argument| f(value + argument));
        black_box(last);
        start.elapsed().as_secs_f64() * 1e9 / arguments.len() as f64
    };
    (name, Box::new(run))
}

/// Times a slice at a time, after one that is not timed: what went before has taken the caches.
fn slices<'a>(name: &'a str, arguments: &'a [f64], f: impl Fn(&[f64], &mut [f64]) + 'a) -> Contestant<'a> {
    let run = move || {
        let mut out = vec![0.0; arguments.len()];
        f(black_box(arguments), &mut out);
        let start = Instant::now();
        for _ in 0..16 {
            f(black_box(arguments), &mut out);
            black_box(&out);
        }
        start.elapsed().as_secs_f64() * 1e9 / (16 * arguments.len()) as f64
    };
    (name, Box::new(run))
}

/// Lets the contestants take turns and prints their times and their ratios to the first.
fn compare(title: &str, contestants: &[Contestant]) {
    let mut times = vec![Vec::new(); contestants.len()];
    for _ in 0..ROUNDS {
        for ((_, run), times) in contestants.iter().zip(&mut times) {
            times.push(run());
        }
    }
    println!("\n{title}\n{:44} {:>9} {:>9} {:>7}", "", "ns", "spread", "ratio");
    let mut first = None;
    for ((name, _), times) in contestants.iter().zip(&mut times) {
        times.sort_by(f64::total_cmp);
        let (best, median) = (times[0], times[times.len() / 2]);
        let ratio = median / *first.get_or_insert(median);
        println!("{name:44} {median:9.2} {:8.0}% {ratio:7.2}", (median / best - 1.0) * 100.0);
    }
}

#[inline(never)]
fn formula_35_slice(u: &[f64], out: &mut [f64]) {
    for (u, out) in u.iter().zip(out) {
        *out = formula_35(*u);
    }
}

fn main() {
    let spread = |i: usize| (i as f64 * 0.618_033_988_749_894_9).fract();
    let u: Vec<f64> = (0..LENGTH).map(|i| 3.0 * spread(i)).collect();
    let fractions: Vec<f64> = (0..LENGTH).map(spread).collect();
    let small: Vec<f64> = u.iter().map(|u| u / 60.0).collect();
    let wide: Vec<f64> = (0..LENGTH).map(|i| 1e-8 * 1e11_f64.powf(spread(i))).collect();
    let (compression, force) = (End::ZeroCompression, End::ZeroForce);
    let features = if cfg!(target_feature = "fma") { "with" } else { "without" };
    println!("fused multiply-add: {features}");
    compare(
        "latency from u",
        &[
            chain("formula (35), six constants, 5 % off at u = 1", &u, formula_35),
            chain("epsilon, zero compression", &u, |u| epsilon(u, compression)),
            chain("epsilon, zero force", &u, |u| epsilon(u, force)),
            chain("1 - epsilon, zero compression", &u, |u| one_minus_epsilon(u, compression)),
            chain("1 - epsilon, zero force", &u, |u| one_minus_epsilon(u, force)),
            chain("tier 1e-3, zero compression", &u, |u| tiers::ZERO_COMPRESSION_1E3.epsilon(u)),
            chain("tier 1e-6, zero compression", &u, |u| tiers::ZERO_COMPRESSION_1E6.epsilon(u)),
            chain("tier 1e-9, zero compression", &u, |u| tiers::ZERO_COMPRESSION_1E9.epsilon(u)),
        ],
    );
    let law = |end| black_box(Restitution::from_u_at_unit_velocity(1.0, end));
    let (with_compression, with_force) = (law(compression), law(force));
    compare(
        "latency from a velocity",
        &[
            chain("[3/6] with a power per term, as YADE", &u, three_six_with_powers),
            chain("epsilon, zero compression", &u, |g| with_compression.epsilon(g)),
            chain("epsilon, zero force", &u, |g| with_force.epsilon(g)),
            chain("powf(0.2)", &u, |x| x.powf(0.2)),
            chain("fifth_root", &u, fifth_root),
        ],
    );
    compare(
        "batch of 2048, u to 3",
        &[
            slices("formula (35)", &u, formula_35_slice),
            slices("epsilon, zero compression", &u, |u, out| epsilon_batch(u, out, compression)),
            slices("epsilon, zero force", &u, |u, out| epsilon_batch(u, out, force)),
            slices("tier 1e-3, zero compression", &u, |u, out| {
                tiers::ZERO_COMPRESSION_1E3.epsilon_batch(u, out)
            }),
            slices("tier 1e-6, zero compression", &u, |u, out| {
                tiers::ZERO_COMPRESSION_1E6.epsilon_batch(u, out)
            }),
            slices("tier 1e-9, zero compression", &u, |u, out| {
                tiers::ZERO_COMPRESSION_1E9.epsilon_batch(u, out)
            }),
            slices("1 - epsilon, zero compression", &u, |u, out| {
                one_minus_epsilon_batch(u, out, compression)
            }),
            slices("1 - epsilon, zero force", &u, |u, out| one_minus_epsilon_batch(u, out, force)),
            slices("from a velocity, zero compression", &u, |g, out| with_compression.epsilon_batch(g, out)),
            slices("from a velocity, zero force", &u, |g, out| with_force.epsilon_batch(g, out)),
            slices("u of a velocity", &u, |g, out| with_force.u_batch(g, out)),
            slices("[3/6] with a power per term, as YADE", &u, |g, out| {
                g.iter().zip(out).for_each(|(g, out)| *out = three_six_with_powers(*g));
            }),
            slices("u of epsilon, zero compression", &fractions, |e, out| {
                u_of_epsilon_batch(e, out, compression)
            }),
            slices("u of epsilon, zero force", &fractions, |e, out| u_of_epsilon_batch(e, out, force)),
            slices("u of a small 1 - epsilon, zero compression", &small, |lost, out| {
                u_of_one_minus_epsilon_batch(lost, out, compression)
            }),
            slices("u of a small 1 - epsilon, zero force", &small, |lost, out| {
                u_of_one_minus_epsilon_batch(lost, out, force)
            }),
        ],
    );
    compare(
        "batch of 2048, u to 0.05",
        &[
            slices("formula (35)", &small, formula_35_slice),
            slices("epsilon, zero compression", &small, |u, out| epsilon_batch(u, out, compression)),
            slices("epsilon, zero force", &small, |u, out| epsilon_batch(u, out, force)),
        ],
    );
    compare(
        "batch of 2048, u from 1e-8 to 1e3 by ratio",
        &[
            slices("formula (35)", &wide, formula_35_slice),
            slices("epsilon, zero compression", &wide, |u, out| epsilon_batch(u, out, compression)),
            slices("epsilon, zero force", &wide, |u, out| epsilon_batch(u, out, force)),
        ],
    );
}
