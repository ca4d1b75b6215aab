//! What there is to say of scripts without running them.

use katydid_definition::document::Document;

use crate::check;
use crate::protocol::ScriptView;

/// The scripts that run only where somebody lets them: those in Python, in clusters too. C# and VB can only compute.
pub fn scripts(document: &Document) -> Vec<ScriptView> {
    let found = check(document).scripts.into_iter();
    found
        .filter(|object| object.script.is_python())
        .map(|object| ScriptView {
            imports: imports(&object.script.text),
            title: object.title,
            language: object.script.language.to_string(),
            text: object.script.text,
        })
        .collect()
}

/// What a script in Python says that it imports, each once, in order: `rhinoscriptsyntax`, `os.path`; and the packages
/// of its `# r:` lines. What it imports by other means cannot be told.
pub fn imports(text: &str) -> Vec<String> {
    let mut found: Vec<String> = Vec::new();
    for line in text.lines().flat_map(|line| line.split(';')) {
        let line = line.trim();
        let names: Vec<&str> = if let Some(rest) = line.strip_prefix("import ") {
            rest.split(',').collect()
        } else if let Some(rest) = line.strip_prefix("from ") {
            rest.split_once(" import").map(|(module, _)| vec![module]).unwrap_or_default()
        } else if let Some(rest) = requirement(line) {
            rest.split(',').collect()
        } else {
            continue;
        };
        for name in names {
            let name = name.split_whitespace().next().unwrap_or_default();
            if !name.is_empty() && !found.iter().any(|own| own == name) {
                found.push(name.to_owned());
            }
        }
    }
    found
}

/// `# r: numpy, scipy`, as Rhino 8 reads it.
fn requirement(line: &str) -> Option<&str> {
    let comment = line.strip_prefix('#')?.trim_start();
    comment.strip_prefix("r:").or_else(|| comment.strip_prefix("requirements:"))
}

/// The line of a script that a message names: the last `line 12` of it, which is where a traceback ends.
pub(crate) fn line(message: &str) -> Option<u32> {
    let numbers = message
        .match_indices("line ")
        .filter(|(at, _)| !message.get(..*at).is_some_and(|before| before.ends_with(char::is_alphanumeric)));
    let number = |(at, word): (usize, &str)| {
        let digits = message.get(at + word.len()..)?;
        let end = digits.find(|c: char| !c.is_ascii_digit()).unwrap_or(digits.len());
        digits.get(..end)?.parse().ok().filter(|line| *line > 0)
    };
    numbers.filter_map(number).last()
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn imports_are_named_once() {
        let text = "# r: numpy==1.26, compas\nimport os.path as p, sys\n  from Rhino.Geometry import Point3d\nimport sys; import re\nx = 'from here'\nfrom . import a";
        let names = ["numpy==1.26", "compas", "os.path", "sys", "Rhino.Geometry", "re", "."];
        assert_eq!(imports(text), names);
    }

    #[test]
    fn the_line_of_a_message() {
        assert_eq!(line("line 2: division by zero"), Some(2));
        assert_eq!(line("Traceback: line 3, in f; line 12, in g: no"), Some(12));
        assert_eq!(line("a polyline 3 is no line"), None);
        assert_eq!(line("line 0"), None);
        assert_eq!(line("line 99999999999999999999"), None);
    }
}
