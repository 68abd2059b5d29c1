/// Where the contact ends.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Hash)]
pub enum End {
    /// At zero compression, after a spell of attraction: the definition of \[RPBS1999\].
    #[default]
    ZeroCompression,
    /// Where the force vanishes on the way out, delayed recovery (\[SP2008\]).
    ZeroForce,
}
