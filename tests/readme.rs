//! The README, so that its code runs as documentation tests.
#![doc = include_str!("../README.md")]
