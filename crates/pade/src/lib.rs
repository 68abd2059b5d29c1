//! Pade approximants of exact and certified series.
