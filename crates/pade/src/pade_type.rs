use std::fmt;

/// The degrees of numerator and denominator, written `[L/M]`.
///
/// # Examples
///
/// ```
/// use restitution_pade::PadeType;
///
/// let asked = PadeType::new(3, 8);
/// assert_eq!((asked.to_string().as_str(), asked.conditions()), ("[3/8]", 12));
/// assert_eq!(PadeType::new(usize::MAX, 1).conditions(), usize::MAX); // more than any series has
/// ```
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash, PartialOrd, Ord)]
pub struct PadeType {
    /// The degree `L` of the numerator.
    pub numerator: usize,
    /// The degree `M` of the denominator.
    pub denominator: usize,
}

impl PadeType {
    /// Returns the type `[numerator/denominator]`.
    pub fn new(numerator: usize, denominator: usize) -> Self {
        Self { numerator, denominator }
    }

    /// The conditions that fix an approximant of this type: `L + M + 1`.
    pub fn conditions(self) -> usize {
        self.numerator.saturating_add(self.denominator).saturating_add(1)
    }
}

impl fmt::Display for PadeType {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        write!(f, "[{}/{}]", self.numerator, self.denominator)
    }
}
