//! Something that gives a coefficient of restitution, in the two ways in which its speed is measured.

/// A function of `u`, called through a list of its own so that no call is paid for each value.
pub trait Kernel: Sync {
    /// Writes the value at each argument; these do not wait for one another.
    fn values(&self, u: &[f64], out: &mut [f64]);

    /// Computes the values one after the other, each argument waiting for the value before it.
    fn chain(&self, u: &[f64]) -> f64;
}

impl<F: Fn(f64) -> f64 + Sync> Kernel for F {
    fn values(&self, u: &[f64], out: &mut [f64]) {
        for (u, out) in u.iter().zip(out) {
            *out = self(*u);
        }
    }

    fn chain(&self, u: &[f64]) -> f64 {
        // A mask of zeros that the compiler does not know ties each argument to the last value.
        let mask = std::hint::black_box(0_u64);
        u.iter().fold(0.0, |value: f64, u| self(f64::from_bits(u.to_bits() | (value.to_bits() & mask))))
    }
}

/// A function that comes with a form for slices.
pub struct WithSlices<F, G> {
    pub one: F,
    pub many: G,
}

impl<F: Fn(f64) -> f64 + Sync, G: Fn(&[f64], &mut [f64]) + Sync> Kernel for WithSlices<F, G> {
    fn values(&self, u: &[f64], out: &mut [f64]) {
        (self.many)(u, out);
    }

    fn chain(&self, u: &[f64]) -> f64 {
        self.one.chain(u)
    }
}
