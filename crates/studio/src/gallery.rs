//! The definitions to start from: examples, and those of the book.

use std::sync::LazyLock;

use rust_embed::Embed;
use serde::Serialize;

#[derive(Embed)]
#[folder = "$CARGO_MANIFEST_DIR/../../book"]
#[include = "*/definition.kd"]
#[include = "README.md"]
struct Book;

#[derive(Embed)]
#[folder = "$CARGO_MANIFEST_DIR/../../examples"]
#[include = "*.kd"]
struct Examples;

/// A definition of the gallery.
#[derive(Debug, Clone, Serialize)]
pub struct Gallery {
    /// What it is asked for by.
    pub id: String,
    /// What a document is called that is opened from it.
    pub name: String,
    /// Its title.
    pub title: String,
    /// The heading that it stands under.
    pub group: String,
    /// A sentence about it.
    pub description: String,
}

impl Gallery {
    /// All of them: the examples, then the book in the order of its own table.
    pub fn all() -> &'static [Self] {
        static ALL: LazyLock<Vec<Gallery>> = LazyLock::new(|| {
            let text = Book::get("README.md").map(|file| file.data.into_owned()).unwrap_or_default();
            let mut all: Vec<Gallery> = Examples::iter().filter_map(|name| example(&name)).collect();
            all.extend(listed(&String::from_utf8_lossy(&text)));
            all
        });
        &ALL
    }

    /// The text of one.
    pub fn text(&self) -> Option<Vec<u8>> {
        let file = Book::get(&format!("{}/definition.kd", self.id));
        file.or_else(|| Examples::get(&format!("{}.kd", self.id))).map(|file| file.data.into_owned())
    }

    /// The one of that id.
    pub fn find(id: &str) -> Option<&'static Self> {
        Self::all().iter().find(|one| one.id == id)
    }
}

/// An example, by what its text says of it.
fn example(name: &str) -> Option<Gallery> {
    let text = Examples::get(name)?.data;
    let text = String::from_utf8_lossy(&text);
    let said = |what: &str| text.lines().find_map(|line| serde_json::from_str(line.strip_prefix(what)?).ok());
    let title: String = said("title ")?;
    Some(Gallery {
        id: name.strip_suffix(".kd")?.to_owned(),
        name: title.clone(),
        title,
        group: "Examples".to_owned(),
        description: said("about ")?,
    })
}

/// The rows of the tables under each heading.
fn listed(text: &str) -> Vec<Gallery> {
    let mut group = String::new();
    let mut all = Vec::new();
    for line in text.lines() {
        if let Some(heading) = line.strip_prefix("## ") {
            heading.trim().clone_into(&mut group);
        }
        let cells: Vec<&str> = line.trim().trim_matches('|').split('|').map(str::trim).collect();
        if let [link, title, description] = cells.as_slice()
            && let Some((id, target)) = link.strip_prefix('[').and_then(|link| link.split_once("]("))
            && target == format!("{id}/definition.kd)")
        {
            let [id, title, description] = [id, title, description].map(str::to_owned);
            let name = format!("{id} {title}");
            all.push(Gallery { id, name, title, group: group.clone(), description });
        }
    }
    all
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn every_row_of_the_book_can_be_opened() {
        katydid_components::link();
        assert!(Gallery::all().len() >= 40, "{}", Gallery::all().len());
        for one in Gallery::all() {
            let text = one.text().unwrap_or_default();
            assert!(crate::read(crate::Form::Kd, &text).is_ok(), "{}", one.id);
            assert!(!one.group.is_empty() && !one.title.is_empty());
        }
        assert!(Gallery::find("../V1").is_none());
        let tower = Gallery::find("tower").map(|one| one.title.as_str());
        assert_eq!(tower, Some("Twisted tower"), "examples are there too");
    }
}
