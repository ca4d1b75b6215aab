//! What changed between two documents, in the words of whoever made them.
//!
//! ```
//! use katydid_definition::diff::{Options, compare};
//! use katydid_definition::kd::{NoCatalogue, read};
//!
//! let old = read("r = Number Slider(5, 0..10)\nshown = Panel(r)\n", &NoCatalogue)?.document;
//! let new = read("r = Number Slider(7, 0..10)\nshown = Panel()\n", &NoCatalogue)?.document;
//! let words: Vec<String> = compare(&old, &new, &Options::default()).iter().map(ToString::to_string).collect();
//! assert_eq!(words, ["r (Number Slider): value 5 → 7", "shown (Panel): r unplugged"]);
//! # Ok::<(), katydid_definition::kd::Problems>(())
//! ```

mod inside;
mod object;
mod pairs;
mod tree;

use std::fmt;

use uuid::Uuid;

use self::pairs::Pairs;
use crate::document::{Document, MOST_NESTED, Object};

/// What is compared.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default)]
pub struct Options {
    /// Whether places on the canvas count.
    pub layout: bool,
}

/// One thing that changed.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct Change {
    /// What sort of change it is.
    pub kind: ChangeKind,
    /// The clusters that it is in, from the outside in.
    pub clusters: Vec<String>,
    /// The object, as its author calls it; empty when the change is the document's.
    pub object: String,
    /// The object's id, in the new document if it is there.
    pub id: Option<Uuid>,
    /// What happened to it.
    pub text: String,
}

/// Sorts of changes.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash)]
#[non_exhaustive]
pub enum ChangeKind {
    /// An object that was not there.
    Added,
    /// An object that is gone.
    Removed,
    /// Wires into an input.
    Wires,
    /// A value: of a slider, in a panel, kept in an input.
    Value,
    /// What a port does to its data.
    Modifier,
    /// A nickname.
    Name,
    /// A setting of an object's own kind.
    Setting,
    /// The text of a script.
    Script,
    /// The members or the look of a group.
    Group,
    /// Disabled or enabled, preview on or off.
    State,
    /// Ports that came or went.
    Ports,
    /// A cluster that cannot be looked into.
    Cluster,
    /// A place on the canvas.
    Layout,
    /// Title and description.
    Document,
}

impl ChangeKind {
    /// One word for it.
    pub const fn name(self) -> &'static str {
        match self {
            Self::Added => "added",
            Self::Removed => "removed",
            Self::Wires => "wires",
            Self::Value => "value",
            Self::Modifier => "modifier",
            Self::Name => "name",
            Self::Setting => "setting",
            Self::Script => "script",
            Self::Group => "group",
            Self::State => "state",
            Self::Ports => "ports",
            Self::Cluster => "cluster",
            Self::Layout => "layout",
            Self::Document => "document",
        }
    }
}

impl fmt::Display for Change {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        for cluster in &self.clusters {
            write!(f, "{cluster} › ")?;
        }
        if self.object.is_empty() {
            f.write_str(&self.text)
        } else {
            write!(f, "{}: {}", self.object, self.text)
        }
    }
}

/// What changed, in the order of the new document; what is gone comes last. Objects are the same when their ids are,
/// or else when type and name are.
pub fn compare(old: &Document, new: &Document, options: &Options) -> Vec<Change> {
    let mut list = List { changes: Vec::new(), clusters: Vec::new(), options: *options };
    list.documents(old, new);
    list.changes
}

/// The changes so far, and where they are.
struct List {
    changes: Vec<Change>,
    clusters: Vec<String>,
    options: Options,
}

impl List {
    fn add(&mut self, kind: ChangeKind, object: &str, id: Option<Uuid>, text: impl Into<String>) {
        let clusters = self.clusters.clone();
        self.changes.push(Change { kind, clusters, object: object.to_owned(), id, text: text.into() });
    }

    fn documents(&mut self, old: &Document, new: &Document) {
        for (what, a, b) in [
            ("title", &old.header.name, &new.header.name),
            ("description", &old.header.description, &new.header.description),
        ] {
            if a != b {
                self.add(ChangeKind::Document, "", None, format!("{what} {} → {}", quoted(a), quoted(b)));
            }
        }
        let pairs = Pairs::of(old, new);
        for (at, object) in new.objects.iter().enumerate() {
            let title = pairs.new_title(at);
            match pairs.old_of(at).and_then(|k| old.objects.get(k)) {
                Some(before) => self.objects(&pairs, before, object, &title),
                None => self.add(ChangeKind::Added, &title, Some(object.id), "added"),
            }
        }
        for (at, object) in old.objects.iter().enumerate() {
            if !pairs.is_kept(at) {
                self.add(ChangeKind::Removed, &pairs.old_title(at), Some(object.id), "removed");
            }
        }
    }

    /// Whether clusters may be looked into here.
    fn may_enter(&self) -> bool {
        self.clusters.len() < MOST_NESTED
    }
}

/// A text, shortened, in quotes.
fn quoted(text: &str) -> String {
    const LONGEST: usize = 60;
    let line: String = text.chars().map(|c| if c.is_control() { ' ' } else { c }).take(LONGEST + 1).collect();
    if line.chars().count() > LONGEST {
        let cut: String = line.chars().take(LONGEST - 1).collect();
        return format!("“{}…”", cut.trim_end());
    }
    format!("“{line}”")
}

/// How an object is called: by its author, and what it is.
fn title(object: &Object) -> String {
    let name = object.title();
    let name: String = name.chars().map(|c| if c.is_control() { ' ' } else { c }).take(80).collect();
    if name == object.name || object.name.is_empty() { name } else { format!("{name} ({})", object.name) }
}

#[cfg(test)]
mod tests {
    use super::{Options, compare};
    use crate::kd::{NoCatalogue, read};

    #[test]
    fn what_an_unchanged_object_refers_to_may_be_gone() {
        let text = "r = Number Slider(5, 0..10)\ns = Number Slider(6, 0..10)\nshown = Panel(r)\nother = Panel(s)\ngroup both: r, s\n";
        let old = read(text, &NoCatalogue).unwrap().document;
        let mut new = old.clone();
        new.objects.remove(0);
        let told = |a, b| -> Vec<String> {
            compare(a, b, &Options::default()).iter().map(ToString::to_string).collect()
        };
        // The panel and the group are as they were, and name an id that is nobody's.
        let gone = told(&old, &new);
        for words in
            ["shown (Panel): rewired from r to nothing", "both (Group): r (Number Slider) left the group"]
        {
            assert!(gone.iter().any(|line| line == words), "{gone:#?}");
        }
        let come = told(&new, &old);
        for words in
            ["shown (Panel): rewired from nothing to r", "both (Group): r (Number Slider) joined the group"]
        {
            assert!(come.iter().any(|line| line == words), "{come:#?}");
        }
        assert!(told(&old, &old.clone()).is_empty());
    }
}
