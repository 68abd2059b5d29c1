//! The state of a campaign in a file, written whole, from which it goes on.

use crate::Tally;
use serde::{Deserialize, Serialize};
use std::collections::BTreeMap;
use std::io::{self, Write};
use std::path::Path;

/// How far every part has come.
#[derive(Clone, Debug, Default, PartialEq, Serialize, Deserialize)]
pub struct State {
    /// The seed of the campaign.
    pub seed: u64,
    /// By the name of the part.
    pub parts: BTreeMap<String, Progress>,
}

/// How far a part has come.
#[derive(Clone, Debug, Default, PartialEq, Serialize, Deserialize)]
pub struct Progress {
    /// The cases `0..done` have been attacked.
    pub done: u64,
    /// Seconds spent on them.
    pub seconds: f64,
    /// The case that took longest, and its seconds: what hardly ends is found by it.
    #[serde(default)]
    pub slowest: (u64, f64),
    /// What they gave.
    pub tally: Tally,
}

impl State {
    /// Reads the state at `path`; a new one if there is none or it belongs to another seed.
    ///
    /// # Errors
    ///
    /// If the file cannot be read or is no state.
    pub fn open(path: &Path, seed: u64) -> io::Result<Self> {
        let fresh = Self { seed, ..Self::default() };
        let text = match std::fs::read_to_string(path) {
            Err(error) if error.kind() == io::ErrorKind::NotFound => return Ok(fresh),
            text => text?,
        };
        let state: Self = serde_json::from_str(&text)?;
        Ok(if state.seed == seed { state } else { fresh })
    }

    /// Writes the state to `path`, whole or not at all.
    ///
    /// # Errors
    ///
    /// If the file or its folder cannot be written.
    pub fn save(&self, path: &Path) -> io::Result<()> {
        let folder = path.parent().filter(|folder| !folder.as_os_str().is_empty()).unwrap_or(Path::new("."));
        std::fs::create_dir_all(folder)?;
        let mut file = tempfile::NamedTempFile::new_in(folder)?;
        file.write_all(serde_json::to_string_pretty(self)?.as_bytes())?;
        file.persist(path)?;
        Ok(())
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_state_comes_back_for_its_own_seed_only() {
        let folder = tempfile::tempdir().unwrap();
        let path = folder.path().join("deep/state.json");
        let mut state = State::open(&path, 3).unwrap();
        state.parts.entry("f64".into()).or_default().done = 9;
        state.save(&path).unwrap();
        assert_eq!(State::open(&path, 3).unwrap(), state);
        assert_eq!(State::open(&path, 4).unwrap().parts.len(), 0);
        std::fs::write(&path, "{").unwrap();
        assert!(State::open(&path, 3).is_err());
    }
}
