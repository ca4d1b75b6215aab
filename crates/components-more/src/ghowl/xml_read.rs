//! XML taken apart into trees.

use std::sync::Arc as Shared;

use katydid_component::{Context, Message, component};
use katydid_data::{Path, Tree, TreeBuilder, Value};
use quick_xml::events::{BytesStart, Event};
use quick_xml::{Reader, XmlVersion, escape};

use crate::branches::items;

/// Elements may stand so deep in one another; a path has a number for each.
const DEEPEST: usize = 256;

/// What was read last, which decides where the next element goes.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
enum Last {
    Nothing,
    Start,
    End,
}

/// Texts at paths, in the order in which they come. A path that comes again goes on with its branch.
#[derive(Default)]
struct Texts {
    branches: Vec<(Path, Vec<Shared<str>>)>,
    places: std::collections::HashMap<Path, usize>,
}

impl Texts {
    fn add(&mut self, path: &Path, text: &str) {
        let place = *self.places.entry(path.clone()).or_insert_with(|| {
            self.branches.push((path.clone(), Vec::new()));
            self.branches.len() - 1
        });
        if let Some((_, texts)) = self.branches.get_mut(place) {
            texts.push(text.into());
        }
    }

    fn tree(mut self) -> Tree {
        self.branches.sort_by(|(a, _), (b, _)| a.cmp(b));
        let mut builder = TreeBuilder::<Shared<str>>::new();
        for (path, texts) in self.branches {
            builder.branch(path);
            texts.into_iter().for_each(|text| builder.push(Some(text)));
        }
        builder.finish()
    }
}

/// XML while it is taken apart.
struct Parts<'a> {
    context: &'a Context<'a>,
    /// The path of the element that is being read.
    numbers: Vec<i32>,
    last: Last,
    /// Text that goes on over references to characters.
    text: String,
    elements: Texts,
    values: Texts,
    names: Texts,
    attributes: Texts,
    data: Texts,
}

impl<'a> Parts<'a> {
    fn new(context: &'a Context<'a>) -> Self {
        Self {
            context,
            numbers: vec![0],
            last: Last::Nothing,
            text: String::new(),
            elements: Texts::default(),
            values: Texts::default(),
            names: Texts::default(),
            attributes: Texts::default(),
            data: Texts::default(),
        }
    }

    fn path(&self) -> Path {
        Path::from(self.numbers.as_slice())
    }

    fn room(&self, text: &str) -> Result<(), Message> {
        self.context.items(1)?;
        self.context.bytes(text.len())
    }

    fn begin(&mut self, element: &BytesStart<'_>, is_empty: bool) -> Result<(), Message> {
        self.end_text()?;
        match self.last {
            Last::Nothing => {}
            Last::Start if self.numbers.len() >= DEEPEST => {
                return Err(Message::error(format!("The elements stand more than {DEEPEST} deep")));
            }
            Last::Start => self.numbers.push(0),
            Last::End => {
                if let Some(number) = self.numbers.last_mut() {
                    *number = number.saturating_add(1);
                }
            }
        }
        let path = self.path();
        let name = element.name();
        let name = name.as_ref();
        self.room(name)?;
        self.elements.add(&path, name);
        let mut has_attributes = false;
        for attribute in element.attributes() {
            let attribute = attribute.map_err(|error| broken(&error.to_string()))?;
            let value = attribute
                .normalized_value(XmlVersion::Implicit1_0)
                .map_err(|error| broken(&error.to_string()))?;
            self.room(&value)?;
            self.names.add(&path, attribute.key.as_ref());
            self.attributes.add(&path, &value);
            has_attributes = true;
        }
        // The plug-in looks whether an element is empty after it has gone to the last attribute, and takes it for open.
        self.last = if is_empty && !has_attributes { Last::End } else { Last::Start };
        Ok(())
    }

    fn end(&mut self) -> Result<(), Message> {
        self.end_text()?;
        // The outermost element keeps its number.
        if self.last == Last::End && self.numbers.len() > 1 {
            self.numbers.pop();
        }
        self.last = Last::End;
        Ok(())
    }

    /// White space between elements is no value.
    fn end_text(&mut self) -> Result<(), Message> {
        let text = std::mem::take(&mut self.text);
        if text.trim().is_empty() {
            return Ok(());
        }
        self.room(&text)?;
        self.values.add(&self.path(), &text);
        Ok(())
    }
}

pub(crate) fn broken(why: &str) -> Message {
    Message::error(format!("The XML is broken: {why}"))
}

/// The XML that a text is, or the file that it names.
fn found(context: &Context<'_>, text: &str) -> Result<String, Message> {
    let plain = text.trim_start_matches('\u{feff}');
    if plain.contains('<') {
        return Ok(plain.to_owned());
    }
    let lower = plain.trim().to_lowercase();
    if lower.starts_with("http://") || lower.starts_with("https://") {
        return Err(Message::error("XML is not fetched from the network: save it as a file"));
    }
    let bytes = context.read_file(plain.trim())?;
    let text = String::from_utf8(bytes).map_err(|_| Message::error("The file is no text in UTF-8"))?;
    Ok(text.trim_start_matches('\u{feff}').to_owned())
}

/// Takes XML apart into trees of the same paths: a number for each depth, counted among the elements of one parent. The text is the
/// XML, or the path of a file. Stands for gHowl's Xml Parser: as there, an element with attributes and nothing in it counts as
/// open, so that what follows stands a step deeper. Addresses of the network are not supported.
#[component("1987c033-10c3-4259-85e2-8da173856eb4", name = "Xml Parser", nick = "XML", at = "gHowl/XML")]
#[output("Elements", "E", "The names of the elements.", kind = Text)]
#[output("Values", "V", "The texts in the elements.", kind = Text)]
#[output("Attribute Names", "A", "The names of the attributes of each element.", kind = Text)]
#[output("Attribute Values", "V", "The values of the attributes.", kind = Text)]
#[output("CData", "CD", "The texts that are marked as plain.", kind = Text)]
fn parse(
    context: &Context<'_>,
    /// The XML, or the path of a file of it.
    #[port("Path", "P", kind = Text)]
    text: &Tree,
) -> Result<(Tree, Tree, Tree, Tree, Tree), Message> {
    let mut parts = Parts::new(context);
    let texts: Vec<Value> = items(text).flatten().collect();
    let Some(Value::Text(text)) = texts.last() else {
        return Ok((Tree::empty(), Tree::empty(), Tree::empty(), Tree::empty(), Tree::empty()));
    };
    if texts.len() > 1 {
        context.warn("Of several texts the last one is taken apart");
    }
    let text = found(context, text)?;
    let mut reader = Reader::from_str(&text);
    loop {
        context.check()?;
        match reader.read_event().map_err(|error| broken(&error.to_string()))? {
            Event::Start(element) => parts.begin(&element, false)?,
            Event::Empty(element) => parts.begin(&element, true)?,
            Event::End(_) => parts.end()?,
            Event::Text(text) => parts.text.push_str(&text.xml10_content()),
            Event::GeneralRef(name) => {
                let reference = format!("&{};", &*name);
                let known = escape::unescape(&reference);
                parts.text.push_str(&known.map_err(|error| broken(&error.to_string()))?);
            }
            Event::CData(data) => {
                parts.end_text()?;
                let data = data.xml10_content();
                parts.room(&data)?;
                parts.data.add(&parts.path(), &data);
            }
            Event::Eof => break,
            Event::Comment(_) | Event::Decl(_) | Event::PI(_) | Event::DocType(_) => {}
        }
    }
    parts.end_text()?;
    let Parts { elements, values, names, attributes, data, .. } = parts;
    Ok((elements.tree(), values.tree(), names.tree(), attributes.tree(), data.tree()))
}
