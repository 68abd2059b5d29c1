//! Workspace tests, one binary.
