//! What an assistant may read: the text form, the book, help of components, examples.

use std::path::{Component, Path, PathBuf};

use katydid_studio::Gallery;
use rmcp::model::{Resource, ResourceContents, ResourceTemplate};

use crate::tools;

/// How the text form is written.
const KD: &str = include_str!("../../../docs/kd.md");
const MARKDOWN: &str = "text/markdown";
const TEXT: &str = "text/plain";
/// The largest page of a book that is given, in bytes.
const LARGEST: u64 = 4 << 20;
/// The most pages of a book that are listed.
const MOST_PAGES: usize = 1_000;

/// All that can be read by a fixed address.
pub(crate) fn list(book: Option<&Path>) -> Vec<Resource> {
    let mut all = vec![
        Resource::new("katydid://kd", "kd")
            .with_title("The text form, .kd")
            .with_description(
                "How definitions are written as text: statements, inputs, values, clusters, groups",
            )
            .with_mime_type(MARKDOWN),
    ];
    all.extend(Gallery::all().iter().map(|one| {
        Resource::new(format!("katydid://definition/{}", one.id), one.id.clone())
            .with_title(one.title.clone())
            .with_description(format!("{}: {}", one.group, one.description))
            .with_mime_type(TEXT)
    }));
    all.extend(pages(book).into_iter().map(|name| {
        Resource::new(format!("katydid://book/{name}"), name.clone())
            .with_description("A page of the book")
            .with_mime_type(MARKDOWN)
    }));
    all
}

/// What can be read by an address with a name in it.
pub(crate) fn templates() -> Vec<ResourceTemplate> {
    vec![
        ResourceTemplate::new("katydid://component/{name}", "component")
            .with_title("Help of a component")
            .with_description("What a component does, its inputs and outputs, as `Divide Curve`")
            .with_mime_type(MARKDOWN),
        ResourceTemplate::new("katydid://definition/{id}", "definition")
            .with_title("An example or a definition of the book, as text in .kd")
            .with_mime_type(TEXT),
    ]
}

/// The names of the pages of a book: folders with a page.md in them.
fn pages(book: Option<&Path>) -> Vec<String> {
    let entries = book.and_then(|book| std::fs::read_dir(book).ok());
    let is_page = |path: &PathBuf| path.join("page.md").is_file();
    let paths = entries.into_iter().flatten().filter_map(|entry| Some(entry.ok()?.path())).filter(is_page);
    let name = |path: PathBuf| Some(path.file_name()?.to_str()?.to_owned());
    let mut all: Vec<String> = paths.filter_map(name).take(MOST_PAGES).collect();
    all.sort();
    all
}

/// What stands at an address.
///
/// # Errors
/// Nothing does.
pub(crate) fn read(book: Option<&Path>, uri: &str) -> Result<ResourceContents, String> {
    let missing = || format!("there is no resource {}", crate::document::cut(uri));
    let rest = uri.strip_prefix("katydid://").ok_or_else(missing)?;
    let (kind, name) = rest.split_once('/').unwrap_or((rest, ""));
    let name = decoded(name);
    let (text, form) = match kind {
        "kd" if name.is_empty() => (KD.to_owned(), MARKDOWN),
        "definition" => {
            let text = Gallery::find(&name).and_then(Gallery::text).ok_or_else(missing)?;
            (String::from_utf8(text).map_err(|_| missing())?, TEXT)
        }
        "component" => {
            (tools::component_help(&name).map_err(|why| format!("{}: {why}", missing()))?, MARKDOWN)
        }
        "book" => (page(book, &name).ok_or_else(missing)?, MARKDOWN),
        _ => return Err(missing()),
    };
    Ok(ResourceContents::text(text, uri).with_mime_type(form))
}

/// A page of the book: the name is that of one folder in it, and nothing else.
fn page(book: Option<&Path>, name: &str) -> Option<String> {
    let is_one =
        matches!(Path::new(name).components().collect::<Vec<_>>().as_slice(), [Component::Normal(_)]);
    let (book, path) = (book?.canonicalize().ok()?, book?.join(name).join("page.md"));
    let path = path.canonicalize().ok().filter(|path| is_one && path.starts_with(&book) && path.is_file())?;
    let size = path.metadata().ok()?.len();
    if size > LARGEST { None } else { std::fs::read_to_string(path).ok() }
}

/// A part of an address with `%20` and the like as what they stand for.
fn decoded(text: &str) -> String {
    let mut bytes = Vec::with_capacity(text.len());
    let mut rest = text.as_bytes();
    while let Some((&first, tail)) = rest.split_first() {
        let pair = tail.get(..2).and_then(|pair| std::str::from_utf8(pair).ok());
        match pair.and_then(|pair| u8::from_str_radix(pair, 16).ok()).filter(|_| first == b'%') {
            Some(byte) => {
                bytes.push(byte);
                rest = tail.get(2..).unwrap_or_default();
            }
            None => {
                bytes.push(first);
                rest = tail;
            }
        }
    }
    String::from_utf8_lossy(&bytes).into_owned()
}

#[cfg(test)]
mod tests {
    #![allow(clippy::unwrap_used, reason = "a test may fail")]

    use super::*;

    #[test]
    fn all_that_is_listed_can_be_read_and_nothing_else() {
        katydid_components::link();
        let folder = tempfile::tempdir().unwrap();
        let book = folder.path().join("book");
        std::fs::create_dir_all(book.join("A1")).unwrap();
        std::fs::write(book.join("A1/page.md"), "# Points").unwrap();
        std::fs::write(folder.path().join("page.md"), "secret").unwrap();
        let listed = list(Some(&book));
        assert!(listed.len() > 40 && listed.iter().any(|one| one.uri == "katydid://book/A1"));
        for one in &listed {
            assert!(read(Some(&book), &one.uri).is_ok(), "{}", one.uri);
        }
        for uri in ["katydid://component/Divide%20Curve", "katydid://component/Divide Curve"] {
            assert!(read(None, uri).is_ok(), "{uri}");
        }
        for uri in [
            "",
            "kd",
            "katydid://",
            "katydid://kd/x",
            "katydid://book/..",
            "katydid://book/%2e%2e",
            "katydid://book/",
            "katydid://book/A1/..",
            "katydid://book//etc",
            "katydid://definition/../V1",
            "katydid://component/Nothing",
            "file:///etc/passwd",
            "katydid://component/%ff%fe",
        ] {
            assert!(read(Some(&book), uri).is_err(), "{uri}");
        }
    }
}
