//! Programs of their own that this one starts: the press and the reader of scans.

use std::path::{Path, PathBuf};

use super::setting;

/// A program that was found.
#[derive(Clone, Debug, PartialEq, Eq)]
pub(crate) enum Found {
    /// The one that a variable names, or the one beside this program.
    Own(PathBuf),
    /// The first one on the PATH, which may be another version's.
    OnPath(PathBuf),
}

/// The program that a variable names, else the one beside this program, else the first one on the PATH; none where the
/// variable is empty.
pub(crate) fn find(name: &str, variable: &str) -> Option<Found> {
    if let Some(named) = setting(variable) {
        return (!named.is_empty()).then(|| Found::Own(PathBuf::from(named)));
    }
    let name = format!("{name}{}", std::env::consts::EXE_SUFFIX);
    let own = std::env::current_exe().ok();
    let beside = own.as_deref().and_then(Path::parent);
    if let Some(program) = beside.map(|folder| folder.join(&name))
        && program.is_file()
    {
        return Some(Found::Own(program));
    }
    let path = setting("PATH").unwrap_or_default();
    std::env::split_paths(&path)
        .map(|folder| folder.join(&name))
        .find(|program| program.is_file())
        .map(Found::OnPath)
}
