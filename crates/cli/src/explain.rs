//! The steps of `katydid run --explain`.

use katydid_session::{Session, explainable};

use crate::output::{BOLD, say};

/// Prints the steps of every object that has some, or of the one of that name by each of its algorithms.
pub(crate) fn explain(session: &Session, name: &str) -> Result<(), String> {
    let objects = session.document().objects.iter().enumerate();
    let mut told = 0;
    for (index, object) in objects.filter(|(_, object)| name.is_empty() || object.nickname == name) {
        for algorithm in explainable(session.engine(), index) {
            told += 1;
            let title = object.title();
            say(&format!("{BOLD}{title}{BOLD:#}: {}", algorithm.name()));
            match katydid_session::explain(session.engine(), index, Some(algorithm)) {
                Ok(steps) => say(&steps.to_string()),
                Err(reason) => say(&format!("  not told: {reason}\n")),
            }
        }
    }
    match (told, name) {
        (0, "") => Err("--explain: no object of this definition has steps that can be told".to_owned()),
        (0, name) => Err(format!("--explain={name}: there is no such object, or its steps cannot be told")),
        _ => Ok(()),
    }
}
