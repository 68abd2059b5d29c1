//! How many digits of sqrt(2) + 1/3 are proved at a precision of so many bits?

use restitution_real::Ball;

fn main() {
    for bits in [24, 53, 113, 200] {
        let sum = Ball::from_integer(2, bits).sqrt() + Ball::from_ratio(1, 3, bits);
        let proved = (1..).take_while(|&digits| sum.to_digits(digits).is_some()).last().unwrap_or(0);
        let digits = sum.to_digits(proved).unwrap_or_default();
        println!("{bits:4} bits prove {proved:2} digits: {digits}, radius {}", sum.radius_text());
    }
}
