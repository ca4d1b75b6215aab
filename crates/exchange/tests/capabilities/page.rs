//! The page of the table.

use std::fmt::Write;

use crate::operations::{Cell, OPERATIONS};

const HEAD: &str = "\
# What the kernel does with which surface

Written by a test (`crates/exchange/tests/capabilities`), which runs each operation on a surface of each kind, or on a solid that has
such faces, and holds what comes of it to a law. Trimmed is a ball that is cut by a plane: its solid's round face is trimmed.

";

pub(crate) fn written(names: &[&str], cells: &[Vec<Cell>]) -> String {
    let mut page = HEAD.to_owned();
    writeln!(page, "| operation | {} |", names.join(" | ")).unwrap();
    writeln!(page, "| --- |{}", " --- |".repeat(names.len())).unwrap();
    let mut notes: Vec<&str> = Vec::new();
    for ((name, _, _), row) in OPERATIONS.iter().zip(cells) {
        write!(page, "| {name} |").unwrap();
        for cell in row {
            match cell {
                Cell::Works => page.push_str(" yes |"),
                Cell::Refused(why) | Cell::Wrong(why) => {
                    let number = notes.iter().position(|note| note == why).unwrap_or_else(|| {
                        notes.push(why);
                        notes.len() - 1
                    });
                    write!(page, " no ({}) |", number + 1).unwrap();
                }
            }
        }
        page.push('\n');
    }
    for (number, note) in notes.iter().enumerate() {
        write!(page, "\n{}. {}", number + 1, note.replace('|', "\\|")).unwrap();
    }
    if !notes.is_empty() {
        page.push('\n');
    }
    page.push_str("\n## The laws\n\n| operation | what is asked of the result |\n| --- | --- |\n");
    for (name, law, _) in OPERATIONS {
        writeln!(page, "| {name} | {law} |").unwrap();
    }
    page
}
