/// Where a contact ends, and with it what the exit velocity is.
///
/// The paper ends it where the compression is zero again, after a spell of attraction that dry
/// bodies don't have; simulations usually end it where the force vanishes on the way out
/// (\[SP2008\]). The second is never smaller: at `u = 1` the coefficients are 0.331 and 0.394.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Hash)]
pub enum End {
    /// At zero compression, `x = 0` (\[RPBS1999\], eq. 5).
    #[default]
    ZeroCompression,
    /// At zero force, `x'' = 0` on the way out (\[SP2008\]).
    ZeroForce,
}
