//! The coefficient of restitution of viscoelastic spheres in f64: fast, with a proved bound.
