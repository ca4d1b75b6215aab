//! The order of the pages.

use crate::fault::Fault;
use crate::front::Front;

/// The contents of a book.
#[derive(Debug, Clone)]
pub(crate) struct Contents {
    /// The title of the book.
    pub(crate) title: String,
    /// One sentence.
    pub(crate) summary: String,
    /// What stands before the list, in Markdown.
    pub(crate) text: String,
    /// The chapters.
    pub(crate) chapters: Vec<Chapter>,
}

/// A chapter.
#[derive(Debug, Clone)]
pub(crate) struct Chapter {
    /// Its name.
    pub(crate) title: String,
    /// The folders of its pages, each with its line in the file.
    pub(crate) pages: Vec<(String, usize)>,
}

impl Contents {
    pub(crate) fn read(file: &str, text: &str) -> Result<Self, Fault> {
        let (front, rest) = Front::read(file, text)?;
        let mut contents = Self {
            title: front.needed(file, "title")?,
            summary: front.needed(file, "summary")?,
            text: String::new(),
            chapters: Vec::new(),
        };
        for (offset, line) in rest.lines().enumerate() {
            let at = front.lines + offset + 1;
            if let Some(title) = line.strip_prefix("## ") {
                contents.chapters.push(Chapter { title: title.trim().to_owned(), pages: Vec::new() });
            } else if let Some(chapter) = contents.chapters.last_mut() {
                match line.trim().strip_prefix("- ") {
                    Some(folder) if is_folder(folder.trim()) => {
                        chapter.pages.push((folder.trim().to_owned(), at))
                    }
                    Some(other) => return Err(Fault::new(file, at, format!("'{other}' is no folder"))),
                    None if line.trim().is_empty() => {}
                    None => {
                        return Err(Fault::new(file, at, "below a chapter stands a list of folders: `- V4`"));
                    }
                }
            } else {
                contents.text.push_str(line);
                contents.text.push('\n');
            }
        }
        if contents.chapters.is_empty() {
            return Err(Fault::new(
                file,
                0,
                "there is no chapter: `## Name`, and a list of folders below it",
            ));
        }
        Ok(contents)
    }

    /// The folders of all pages in their order.
    pub(crate) fn pages(&self) -> impl Iterator<Item = &(String, usize)> {
        self.chapters.iter().flat_map(|chapter| &chapter.pages)
    }
}

fn is_folder(text: &str) -> bool {
    !text.is_empty()
        && text.split('/').all(|part| {
            !part.is_empty() && part.chars().all(|c| c.is_ascii_alphanumeric() || c == '-' || c == '_')
        })
}
