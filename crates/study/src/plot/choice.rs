//! Which columns a plot shows.

use katydid_session::nearest;

use crate::{Column, Kind, StudyError, StudyFolder};

/// The column of that name, with or without `in.`, `in:`, `out.` or `out:`.
///
/// # Errors
/// There is none, and the error has the names that there are; or there are two.
pub(super) fn find(folder: &StudyFolder, name: &str) -> Result<usize, StudyError> {
    let columns = folder.columns();
    let is_marked = |column: &Column, mark: &str| {
        let rest = name.strip_prefix(mark).and_then(|rest| rest.strip_prefix(['.', ':']));
        rest == Some(column.name.as_str())
    };
    let same = |column: &Column| match column.kind {
        _ if column.name == name => true,
        Kind::Input => is_marked(column, "in"),
        Kind::Output => is_marked(column, "out"),
    };
    let found: Vec<usize> =
        columns.iter().enumerate().filter(|(_, one)| same(one)).map(|(at, _)| at).collect();
    match found.as_slice() {
        [one] => Ok(*one),
        [] => {
            let names = || columns.iter().map(|column| column.name.as_str());
            let near = nearest(names(), name).map(|near| format!(": do you mean '{near}'?"));
            let all: Vec<&str> = names().take(40).collect();
            let near = near.unwrap_or_else(|| ".".to_owned());
            Err(StudyError::Unfit(format!(
                "the study has no column '{name}'{near} It has {}",
                all.join(", ")
            )))
        }
        _ => Err(StudyError::Unfit(format!(
            "an input and an output are called '{name}': say in.{name} or out.{name}"
        ))),
    }
}

/// The first column of a kind in which rows have different numbers; else the first of that kind with a number at all.
pub(super) fn usual(folder: &StudyFolder, kind: Kind) -> Option<usize> {
    let columns = folder.columns();
    let of_kind = || {
        (0..columns.len()).filter(|at| columns.get(*at).is_some_and(|one| one.kind == kind && one.is_number))
    };
    let numbers = |at: usize| folder.rows().iter().filter_map(move |row| row.number(at));
    let varies = |at: &usize| numbers(*at).next().is_some_and(|first| numbers(*at).any(|x| x != first));
    of_kind().find(varies).or_else(|| of_kind().find(|at| numbers(*at).next().is_some()))
}

/// The column that was asked for, else the usual one of a kind, else of the other.
///
/// # Errors
/// There is none.
pub(super) fn chosen(folder: &StudyFolder, name: Option<&str>, kind: Kind) -> Result<usize, StudyError> {
    if let Some(name) = name {
        return find(folder, name);
    }
    let other = if kind == Kind::Input { Kind::Output } else { Kind::Input };
    let none = || StudyError::Unfit("the study has no column with numbers".to_owned());
    usual(folder, kind).or_else(|| usual(folder, other)).ok_or_else(none)
}
