//! Certified direct integration of the equation of motion, for every velocity.
