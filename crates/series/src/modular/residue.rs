use crate::kernels::{Prime, Roots, size_for};
use crate::{Field, ZeroTest};
use num_bigint::BigInt;
use num_integer::Integer;
use num_rational::BigRational;
use num_traits::{One, ToPrimitive, Zero};
use std::cell::{Cell, RefCell};
use std::ops::{Add, Div, Mul, Neg, Sub};
use std::rc::Rc;

/// Length up to which products are taken term by term.
const SHORT: usize = 24;

/// A rational number modulo the word-size prime that the thread works with, in Montgomery's form.
///
/// The prime is set for the length of a computation by [`modulo`] and must not divide a denominator.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) struct Residue(u64);

thread_local! {
    static PRIME: Cell<Option<Prime>> = const { Cell::new(None) };
}

/// Runs a computation modulo a prime.
pub(super) fn modulo<R>(prime: Prime, computation: impl FnOnce() -> R) -> R {
    let before = PRIME.replace(Some(prime));
    let result = computation();
    PRIME.set(before);
    result
}

fn prime() -> Prime {
    PRIME.get().expect("residues exist inside `modulo` only")
}

impl Residue {
    /// The residue in `0 .. p`.
    pub fn value(self) -> u64 {
        prime().value(self.0)
    }
}

macro_rules! operation {
    ($trait:ident, $method:ident, |$prime:ident, $x:ident, $y:ident| $value:expr) => {
        impl $trait for Residue {
            type Output = Self;
            fn $method(self, other: Self) -> Self {
                let ($prime, $x, $y) = (prime(), self.0, other.0);
                Self($value)
            }
        }
        impl $trait<&Self> for Residue {
            type Output = Self;
            fn $method(self, other: &Self) -> Self {
                self.$method(*other)
            }
        }
    };
}

operation!(Add, add, |prime, x, y| prime.add(x, y));
operation!(Sub, sub, |prime, x, y| prime.sub(x, y));
operation!(Mul, mul, |prime, x, y| prime.mul(x, y));
operation!(Div, div, |prime, x, y| prime.mul(x, prime.inverse(y)));

impl Neg for Residue {
    type Output = Self;
    fn neg(self) -> Self {
        Self(prime().sub(0, self.0))
    }
}

impl Zero for Residue {
    fn zero() -> Self {
        Self(0)
    }

    fn is_zero(&self) -> bool {
        self.0 == 0
    }
}

impl One for Residue {
    fn one() -> Self {
        Self(prime().one)
    }
}

/// The forms of a series and, if it is long, their transform.
#[derive(Clone, Debug)]
pub(super) struct Transformed {
    forms: Vec<u64>,
    values: Vec<u64>,
}

thread_local! {
    static LATEST: RefCell<Option<(u64, usize, Rc<Roots>)>> = const { RefCell::new(None) };
}

/// The roots for a prime and a size, kept for the next call of the thread.
fn roots(prime: Prime, size: usize) -> Rc<Roots> {
    LATEST.with(|latest| {
        let mut latest = latest.borrow_mut();
        match latest.as_ref() {
            Some((p, known, roots)) if *p == prime.p && *known == size => Rc::clone(roots),
            _ => {
                let roots = Rc::new(Roots::new(prime, size));
                *latest = Some((prime.p, size, Rc::clone(&roots)));
                roots
            }
        }
    })
}

fn transformed(prime: Prime, forms: &[u64], size: usize) -> Vec<u64> {
    let mut values = forms.to_vec();
    values.resize(size, 0);
    roots(prime, size).forward(&mut values);
    values
}

/// The first `len` forms of a sum of products, by transforms.
fn long_sum(prime: Prime, terms: &[(i64, &Transformed, &Transformed)], len: usize) -> Vec<u64> {
    let size = size_for(2 * len);
    let mut sum = vec![0; size];
    for (weight, a, b) in terms {
        let weight = prime.form(*weight);
        let fresh = |x: &Transformed| transformed(prime, &x.forms[..x.forms.len().min(len)], size);
        let (fresh_a, fresh_b);
        let a = if a.values.len() == size {
            &a.values
        } else {
            fresh_a = fresh(a);
            &fresh_a
        };
        let b = if b.values.len() == size {
            &b.values
        } else {
            fresh_b = fresh(b);
            &fresh_b
        };
        for ((s, &x), &y) in sum.iter_mut().zip(a).zip(b) {
            *s = prime.add(*s, prime.mul(prime.mul(x, y), weight));
        }
    }
    roots(prime, size).backward(&mut sum);
    sum.truncate(len);
    sum
}

fn short_sum(prime: Prime, terms: &[(i64, &Transformed, &Transformed)], len: usize) -> Vec<u64> {
    let mut sum = vec![0; len];
    for (weight, a, b) in terms {
        let weight = prime.form(*weight);
        for (i, &x) in a.forms.iter().enumerate().take(len) {
            let x = prime.mul(x, weight);
            for (s, &y) in sum[i..].iter_mut().zip(&b.forms) {
                *s = prime.add(*s, prime.mul(x, y));
            }
        }
    }
    sum
}

impl Field for Residue {
    type Factor = Transformed;

    fn rational(&self, value: &BigRational) -> Self {
        let prime = prime();
        let residue = |n: &BigInt| prime.form(n.mod_floor(&prime.p.into()).to_i64().unwrap_or(0));
        Self(prime.mul(residue(value.numer()), prime.inverse(residue(value.denom()))))
    }

    fn ratio(&self, numerator: i64, denominator: i64) -> Self {
        let prime = prime();
        Self(prime.mul(prime.form(numerator), prime.inverse(prime.form(denominator))))
    }

    fn zero_test(&self) -> ZeroTest {
        if self.is_zero() { ZeroTest::Zero } else { ZeroTest::NonZero }
    }

    fn power(&self, _: &BigRational) -> Option<Self> {
        self.is_one().then_some(*self)
    }

    fn factor(series: &[Self], len: usize) -> Self::Factor {
        let forms: Vec<u64> = series.iter().take(len).map(|x| x.0).collect();
        let values = if len > SHORT { transformed(prime(), &forms, size_for(2 * len)) } else { Vec::new() };
        Transformed { forms, values }
    }

    fn sum_of_products(terms: &[(i64, &Self::Factor, &Self::Factor)], len: usize) -> Vec<Self> {
        let prime = prime();
        let forms = if len > SHORT { long_sum(prime, terms, len) } else { short_sum(prime, terms, len) };
        forms.into_iter().map(Self).collect()
    }

    /// All denominators are inverted together: `1/x = y/(x y)` (Montgomery's trick).
    fn scale_each(series: &[Self], weights: &dyn Fn(usize) -> (i64, i64)) -> Vec<Self> {
        let prime = prime();
        let weights: Vec<(u64, u64)> =
            (0..series.len()).map(weights).map(|(n, d)| (prime.form(n), prime.form(d))).collect();
        let mut before = Vec::with_capacity(series.len());
        let all = weights.iter().fold(prime.one, |product, (_, d)| {
            before.push(product);
            prime.mul(product, *d)
        });
        let mut after = prime.inverse(all);
        let mut scaled = series.to_vec();
        for (i, x) in scaled.iter_mut().enumerate().rev() {
            let (numerator, denominator) = weights[i];
            let inverse = prime.mul(after, before[i]);
            after = prime.mul(after, denominator);
            x.0 = prime.mul(x.0, prime.mul(numerator, inverse));
        }
        scaled
    }
}
