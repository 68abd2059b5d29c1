//! Pieces that the exponent and leading bits of a shifted argument number.

/// Where the pieces lie: `2^-bits` of a factor of two each, in `v = u + shift`.
///
/// `v` is rounded to an f64, and its bits are all that an evaluation sees: those in front number the piece, the
/// others say how far the end of the piece is. So neighbouring arguments give the same distance or distances
/// `2^-(52 - bits)` apart, however small they are.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Grid {
    /// What is added to `u`, a power of two.
    pub shift: f64,
    /// Leading bits of the significand of `u + shift` that number the pieces.
    pub bits: u32,
}

impl Grid {
    /// The bits of `u + shift` that say where in its piece `u` lies.
    pub fn rest(&self) -> u32 {
        52 - self.bits
    }

    /// The number of the piece that `u` lies in.
    pub fn number(&self, u: f64) -> u64 {
        (u + self.shift).to_bits() >> self.rest()
    }

    /// Where piece `number` starts.
    pub fn start(&self, number: u64) -> f64 {
        f64::from_bits(number << self.rest()) - self.shift
    }

    /// The width of piece `number`, a power of two.
    pub fn width(&self, number: u64) -> f64 {
        2.0_f64.powi(self.exponent(number) - self.bits as i32)
    }

    /// The distance from `u` to the end of its piece, as a part of the piece's width: from `2^-rest` to 1.
    pub fn distance(&self, u: f64) -> f64 {
        let fraction = (u + self.shift).to_bits() << self.bits & (u64::MAX >> 12);
        2.0 - f64::from_bits(1.0_f64.to_bits() | fraction)
    }

    /// The distance in `u` that the rounding of `u + shift` can amount to in piece `number`: half a unit of its last
    /// place, and nothing where `u` itself is as coarse, as the shift is then a multiple of that unit.
    pub fn rounding(&self, number: u64) -> f64 {
        let power = 2.0_f64.powi(self.exponent(number));
        let multiple = self.start(number) >= power && self.shift >= power * f64::EPSILON;
        if self.shift == 0.0 || multiple { 0.0 } else { power * f64::EPSILON / 2.0 }
    }

    /// The exponent of `u + shift` in piece `number`.
    fn exponent(&self, number: u64) -> i32 {
        (number >> self.bits) as i32 - 1023
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn an_argument_is_its_piece_and_its_distance() {
        for grid in
            [Grid { shift: 8.0, bits: 4 }, Grid { shift: 0.25, bits: 7 }, Grid { shift: 1.0, bits: 0 }]
        {
            for i in 0..3000 {
                let u = f64::from(i) * 0.003;
                let number = grid.number(u);
                let end = grid.start(number) + grid.width(number);
                assert_eq!(end, grid.start(number + 1));
                let distance = (end - u) / grid.width(number);
                let error = (distance - grid.distance(u)).abs() * grid.width(number);
                assert!(error <= grid.rounding(number) + 1e-15, "{grid:?}, {u}");
            }
        }
        let grid = Grid { shift: 8.0, bits: 4 };
        assert_eq!((grid.distance(0.0), grid.start(grid.number(0.0))), (1.0, 0.0));
        assert_eq!(grid.distance(0.5_f64.next_down()), grid.distance(0.0));
        assert_eq!(grid.distance(1.0_f64.next_down()), 1.0, "rounded up to the next piece");
    }
}
