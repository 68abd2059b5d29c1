//! A folder that is written whole or not at all.

use crate::CliError;
use crate::interrupt::Pending;
use restitution_report::GENERATOR;
use std::fs;
use std::io::ErrorKind;
use std::path::{Path, PathBuf};

/// A place for a report: no folder yet, an empty one, or an earlier report.
#[derive(Debug)]
pub struct Folder {
    path: PathBuf,
    parent: PathBuf,
}

impl Folder {
    /// Checks that a report can be written to `path`; call it before the work starts.
    ///
    /// # Errors
    ///
    /// [`CliError::Failure`] if `path` is a file or a folder with other things in it, or cannot be made.
    pub fn at(path: &Path) -> Result<Self, CliError> {
        let Some(name) = path.file_name() else {
            return Err(failure(path, "give -o the name of a folder"));
        };
        let parent = path.parent().filter(|parent| !parent.as_os_str().is_empty()).unwrap_or(Path::new("."));
        if !parent.is_dir() {
            return Err(failure(path, &format!("there is no folder '{}': make it first", parent.display())));
        }
        let folder = Self { path: parent.join(name), parent: parent.to_owned() };
        if !folder.is_free()? {
            return Err(failure(
                path,
                "it holds something else than an earlier report: give the name of a new folder",
            ));
        }
        tempfile::tempdir_in(parent).map_err(|error| failure(path, &error.kind().to_string()))?;
        Ok(folder)
    }

    fn is_free(&self) -> Result<bool, CliError> {
        let mut entries = match fs::read_dir(&self.path) {
            Ok(entries) => entries,
            Err(error) if error.kind() == ErrorKind::NotFound => return Ok(true),
            Err(error) if error.kind() == ErrorKind::NotADirectory => return Ok(false),
            Err(error) => return Err(failure(&self.path, &error.kind().to_string())),
        };
        let page = fs::read_to_string(self.path.join("index.html")).unwrap_or_default();
        Ok(entries.next().is_none() || page.contains(GENERATOR))
    }

    /// Writes the files to a new folder, which then takes the place of what was there.
    ///
    /// # Errors
    ///
    /// [`CliError::Failure`] with the reason, one line; what was there is then as it was.
    pub fn write(&self, files: &[(String, String)]) -> Result<(), CliError> {
        let failed = |error: std::io::Error| failure(&self.path, &error.kind().to_string());
        let fresh =
            tempfile::Builder::new().prefix(".restitution-").tempdir_in(&self.parent).map_err(failed)?;
        let pending = Pending::nothing();
        pending.file(fresh.path());
        for (name, content) in files {
            fs::write(fresh.path().join(name), content).map_err(failed)?;
        }
        open_to_readers(fresh.path()).map_err(failed)?;
        let old =
            tempfile::Builder::new().prefix(".restitution-").tempdir_in(&self.parent).map_err(failed)?;
        let aside = old.path().join("old");
        let had_one = self.path.exists();
        if had_one {
            fs::rename(&self.path, &aside).map_err(failed)?;
        }
        let fresh = fresh.keep();
        fs::rename(&fresh, &self.path).map_err(|error| {
            let _ = fs::remove_dir_all(&fresh);
            if had_one {
                let _ = fs::rename(&aside, &self.path);
            }
            failed(error)
        })
    }
}

/// Gives a temporary folder, which is private, the permissions of any other.
fn open_to_readers(path: &Path) -> std::io::Result<()> {
    let probe = path.join("permissions");
    fs::create_dir(&probe)?;
    let permissions = fs::metadata(&probe)?.permissions();
    fs::remove_dir(&probe)?;
    fs::set_permissions(path, permissions)
}

fn failure(path: &Path, reason: &str) -> CliError {
    CliError::failure(format!("cannot write the report to '{}': {reason}", path.display()))
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_report_replaces_only_a_report() {
        let place = tempfile::tempdir().unwrap();
        let path = place.path().join("report");
        let page = |text: &str| {
            vec![
                ("index.html".to_owned(), format!("{GENERATOR}{text}")),
                (format!("{text}.csv"), String::new()),
            ]
        };
        Folder::at(&path).unwrap().write(&page("first")).unwrap();
        Folder::at(&path).unwrap().write(&page("second")).unwrap();
        assert!(path.join("second.csv").exists() && !path.join("first.csv").exists());
        assert_eq!(fs::read_dir(place.path()).unwrap().count(), 1, "nothing is left behind");
        fs::write(path.join("index.html"), "my thesis").unwrap();
        assert!(Folder::at(&path).unwrap_err().to_string().ends_with("give the name of a new folder"));
        assert!(Folder::at(&path.join("index.html")).is_err() && Folder::at(Path::new("/")).is_err());
    }
}
