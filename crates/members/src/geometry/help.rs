//! Pages that explain a path, from the table.

use std::fmt::Write as _;

use super::table::{Endpoints, Row};
use crate::Fault;

/// Text as HTML has it.
fn escaped(text: &str) -> String {
    text.replace('&', "&amp;").replace('<', "&lt;").replace('>', "&gt;").replace('"', "&quot;")
}

const HEAD: &str = "<!doctype html><html lang=\"en\"><meta charset=\"utf-8\"><title>Katydid</title>\
<style>body{font:16px/1.5 system-ui;margin:2rem auto;max-width:60rem;padding:0 1rem}code{background:#8882}</style>";

fn described(row: &Row, page: &mut String) {
    let arguments: Vec<String> = row.names.iter().map(|name| escaped(name)).collect();
    // Writing to a string cannot fail.
    let _ = write!(
        page,
        "<h2>{}</h2><p>POST a JSON list: <code>[{}]</code></p>",
        escaped(&row.path),
        arguments.join(", ")
    );
    let _ = match &row.entry {
        Some(_) => write!(page, "<p>Gives <code>{}</code>.</p>", escaped(&row.gives)),
        None => write!(page, "<p>Not supported yet.</p>"),
    };
}

impl Endpoints {
    /// The page of a path: an overload, or all of a method.
    ///
    /// # Errors
    /// `NotFound` for a path that nobody has.
    pub fn help(&self, path: &str) -> Result<String, Fault> {
        let mut page = String::from(HEAD);
        for row in self.rows_of(path)? {
            described(row, &mut page);
        }
        Ok(page)
    }

    /// The page that lists all paths.
    pub fn index(&self) -> String {
        let mut page = format!("{HEAD}<h1>Functions</h1><ul>");
        let answered: Vec<&str> = self.answered().collect();
        for path in self.paths() {
            let note = if answered.contains(&path) { "" } else { " (not supported yet)" };
            let path = escaped(path);
            let _ = write!(page, "<li><a href=\"/rhino/geometry/{path}\">{path}</a>{note}");
        }
        page.push_str("</ul>");
        page
    }
}
