//! Trees written as XML.

use std::collections::{BTreeMap, BTreeSet};
use std::sync::Arc as Shared;

use katydid_component::{Context, Message, component};
use katydid_data::{Path, Tree, Value, text};
use quick_xml::escape::escape;

/// Elements may stand so deep in one another.
const DEEPEST: usize = 256;

/// What is written: the first item at each path, and which paths stand in which.
struct Source {
    texts: BTreeMap<Path, Shared<str>>,
    names: BTreeMap<Path, Shared<str>>,
    /// The paths right below each path, those of no data of their own among them, in the order in which they are met.
    below: BTreeMap<Path, Vec<Path>>,
}

impl Source {
    fn new(context: &Context<'_>, data: &Tree, names: &Tree) -> Result<Self, Message> {
        let mut source = Self {
            texts: first_texts(context, data),
            names: first_texts(context, names),
            below: BTreeMap::new(),
        };
        let mut met = BTreeSet::new();
        for branch in data.branches() {
            context.check()?;
            if branch.path().len() > DEEPEST {
                return Err(Message::error(format!("The paths have more than {DEEPEST} numbers")));
            }
            if branch.len() > 1 {
                context.warn(format!("{} has several items: the first one is written", branch.path()));
            }
            // Each path stands in the one before its last number; the outermost ones stand in {0}.
            for length in 1..=branch.path().len() {
                let path = Path::from(branch.path().elements().get(..length).unwrap_or_default());
                let parent = if length == 1 { Path::zero() } else { path.parent() };
                if path != Path::zero() && met.insert(path.clone()) {
                    source.below.entry(parent).or_default().push(path);
                }
            }
        }
        Ok(source)
    }

    /// An element with what stands in it, each on a line of its own; in an element with a text nothing is set apart.
    fn write(
        &self,
        context: &Context<'_>,
        path: &Path,
        indent: Option<usize>,
        xml: &mut String,
    ) -> Result<(), Message> {
        context.check()?;
        let name = match self.names.get(path) {
            Some(name) => checked(name)?,
            None => format!(
                "GHPath_{}",
                path.elements().iter().map(ToString::to_string).collect::<Vec<_>>().join("-")
            ),
        };
        let text = self.texts.get(path);
        let mut below = self.below.get(path).cloned().unwrap_or_default();
        // Where something stands in an element of the plug-in, the path that ends with 0 is written first, be there data or not.
        if *path != Path::zero() || below.iter().any(|path| path.len() > 1) {
            let first = path.child(0);
            if !below.is_empty() {
                below.retain(|path| *path != first);
                below.insert(0, first);
            }
        }
        let before = xml.len();
        if text.is_none() && below.is_empty() {
            xml.push_str(&format!("<{name} />"));
        } else {
            xml.push_str(&format!("<{name}>"));
            if let Some(text) = text {
                xml.push_str(&escape(text.as_ref()));
            }
            let inner = indent.filter(|_| text.is_none()).map(|depth| depth + 1);
            for path in &below {
                start_line(xml, inner);
                self.write(context, path, inner, xml)?;
            }
            if !below.is_empty() {
                start_line(xml, inner.map(|depth| depth - 1));
            }
            xml.push_str(&format!("</{name}>"));
        }
        context.bytes(xml.len() - before)
    }
}

fn start_line(xml: &mut String, depth: Option<usize>) {
    if let Some(depth) = depth {
        xml.push('\n');
        xml.push_str(&"  ".repeat(depth));
    }
}

/// A name that an element may have.
fn checked(name: &str) -> Result<String, Message> {
    let begins = |c: char| c.is_alphabetic() || c == '_';
    let goes_on = |c: char| begins(c) || c.is_numeric() || "-.·".contains(c);
    let is_name = name.starts_with(begins) && name.chars().all(goes_on);
    is_name.then(|| name.to_owned()).ok_or_else(|| {
        Message::error(format!(
            "'{name}' is no name of an element: letters, digits, _, - and . are, without blanks"
        ))
    })
}

/// The text of the first item of each branch.
fn first_texts(context: &Context<'_>, tree: &Tree) -> BTreeMap<Path, Shared<str>> {
    let style = context.style();
    let first = |branch: katydid_data::Branch<'_>| {
        let text = match branch.iter().next()?? {
            Value::Text(text) => text,
            Value::Number(number) => number.to_string().into(),
            other => text::value(&other, &style).into(),
        };
        Some((branch.path().clone(), text))
    };
    tree.branches().filter_map(first).collect()
}

/// Writes a tree as XML: an element for each path, in that of the path before its last number; {0} is the outermost one. The text of
/// an element is the first item at its path. Stands for gHowl's Write XML. Elements stand on lines of their own, set in by two
/// blanks.
#[component("d2c5be07-759c-482c-a488-a5ded179989e", name = "Write XML", nick = "XML", at = "gHowl/XML")]
#[output("XML", "X", "The XML.")]
fn write(
    context: &Context<'_>,
    /// The data.
    #[port("Data", "D", kind = Generic)]
    data: &Tree,
    /// The names of the elements, at the paths that they are for; `GHPath_0-1` is that of {0;1} where none is given.
    #[port("Element Names", "E", kind = Text, optional)]
    names: &Tree,
) -> Result<Tree, Message> {
    let source = Source::new(context, data, names)?;
    let mut xml = String::new();
    source.write(context, &Path::zero(), Some(0), &mut xml)?;
    Ok(Tree::item(Value::from(xml)))
}
