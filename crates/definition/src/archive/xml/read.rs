use quick_xml::Reader as XmlReader;
use quick_xml::events::{BytesStart, Event};

use super::{text, value};
use crate::archive::{Archive, Chunk, Encoding, Limits};
use crate::{Error, Place, Result};

/// At most this many notes: a file where everything is odd need not say so a million times.
const MOST_NOTES: usize = 50;

/// An element has four attributes at most; leave room for what somebody adds.
const MOST_ATTRIBUTES: usize = 32;

pub(in crate::archive) fn read(bytes: &[u8], limits: &Limits) -> Result<Archive> {
    let text = text::decode(bytes, limits.max_inflated)?;
    let mut xml = XmlReader::from_str(&text);
    xml.config_mut().expand_empty_elements = true;
    let mut tree = Tree { limits, nodes: 0, open: Vec::new(), root: None, notes: Vec::new(), offset: 0 };
    loop {
        tree.offset = offset(xml.buffer_position());
        let event = xml.read_event();
        match event {
            Ok(Event::Start(element)) => tree.begin(&element)?,
            Ok(Event::End(_)) => tree.end()?,
            Ok(Event::Text(content)) => tree.text(&content.xml10_content())?,
            Ok(Event::CData(content)) => tree.text(&content.xml10_content())?,
            Ok(Event::GeneralRef(name)) => {
                let c = text::reference(&name)
                    .ok_or_else(|| tree.error(format!("&{}; is not a known character", &*name)))?;
                tree.text(c.encode_utf8(&mut [0; 4]))?;
            }
            Ok(Event::DocType(_)) => {
                return Err(tree.error("a document type (<!DOCTYPE>) does not belong into an archive"));
            }
            Ok(Event::Eof) => break,
            Ok(Event::Comment(_) | Event::Decl(_) | Event::PI(_) | Event::Empty(_)) => {}
            Err(error) => {
                return Err(Error::at(Place::Text, offset(xml.error_position()), error.to_string()));
            }
        }
    }
    if !tree.open.is_empty() {
        return Err(Error::at(Place::Text, text.len(), "it ends before the archive does"));
    }
    let Some(root) = tree.root else {
        return Err(Error::at(Place::Text, text.len(), "there is no <Archive> in it"));
    };
    Ok(Archive { root, encoding: Encoding::Xml, notes: tree.notes })
}

fn offset(position: u64) -> usize {
    usize::try_from(position).unwrap_or(usize::MAX)
}

/// An element that has begun and not ended.
enum Open {
    /// `<Archive>` or `<chunk>`.
    Chunk(Chunk),
    /// `<items>`, with the count it announces and how many came.
    Items { announced: Option<i64>, found: i64 },
    /// `<chunks>`, likewise.
    Chunks { announced: Option<i64>, found: i64 },
    /// `<item>`.
    Item(ItemParts),
    /// An element inside an item.
    Field { name: String, text: String },
    /// An element that does not belong here, and all in it.
    Foreign,
}

/// An item while its parts come in.
pub(super) struct ItemParts {
    pub(super) name: String,
    pub(super) index: Option<i32>,
    pub(super) code: i32,
    pub(super) text: String,
    pub(super) fields: Vec<(String, String)>,
}

struct Tree<'a> {
    limits: &'a Limits,
    nodes: usize,
    open: Vec<Open>,
    root: Option<Chunk>,
    notes: Vec<String>,
    offset: usize,
}

impl Tree<'_> {
    fn error(&self, reason: impl Into<String>) -> Error {
        Error::at(Place::Text, self.offset, reason)
    }

    fn note(&mut self, note: String) {
        if self.notes.len() < MOST_NOTES {
            self.notes.push(format!("byte {}: {note}", self.offset));
        }
    }

    fn begin(&mut self, element: &BytesStart<'_>) -> Result<()> {
        // A chunk takes two elements, <chunks> and <chunk>; an item three.
        if self.open.len() > 2 * self.limits.depth() + 3 {
            return Err(Error::Limit {
                place: Place::Text,
                offset: self.offset,
                what: "the depth of elements inside elements",
                limit: self.limits.depth(),
            });
        }
        self.check_attributes(element)?;
        let tag = element.name();
        let tag = tag.as_ref();
        let next = match (self.open.last(), tag) {
            (None, "Archive") if self.root.is_none() => {
                self.limits.count(&mut self.nodes, Place::Text, self.offset)?;
                let (name, index) = self.names(element)?;
                Open::Chunk(Chunk {
                    name: name.unwrap_or_else(|| "Root".to_owned()),
                    index,
                    ..Chunk::default()
                })
            }
            (None, _) if self.root.is_some() => return Err(self.error("there is more after the archive")),
            (None, _) => {
                return Err(self.error(format!("it begins with <{}>, not with <Archive>", clip(tag))));
            }
            (Some(Open::Chunk(_)), "items") => Open::Items { announced: self.announced(element)?, found: 0 },
            (Some(Open::Chunk(_)), "chunks") => {
                Open::Chunks { announced: self.announced(element)?, found: 0 }
            }
            (Some(Open::Items { .. }), "item") => {
                self.limits.count(&mut self.nodes, Place::Text, self.offset)?;
                self.item(element)?
            }
            (Some(Open::Chunks { .. }), "chunk") => {
                self.limits.count(&mut self.nodes, Place::Text, self.offset)?;
                if self.open.len() / 2 >= self.limits.depth() {
                    let limit = self.limits.depth();
                    let (place, offset) = (Place::Text, self.offset);
                    return Err(Error::Limit {
                        place,
                        offset,
                        what: "the depth of chunks inside chunks",
                        limit,
                    });
                }
                let (name, index) = self.names(element)?;
                let name = name.ok_or_else(|| self.error("a chunk has no name"))?;
                Open::Chunk(Chunk { name, index, ..Chunk::default() })
            }
            (Some(Open::Item(_)), _) => {
                self.limits.count(&mut self.nodes, Place::Text, self.offset)?;
                Open::Field { name: tag.to_owned(), text: String::new() }
            }
            (Some(Open::Field { name, .. }), _) => {
                return Err(self.error(format!("<{}> does not belong into <{}>", clip(tag), clip(name))));
            }
            (Some(Open::Foreign), _) => Open::Foreign,
            (Some(_), _) => {
                self.note(format!("the element <{}> is not known and was left out", clip(tag)));
                Open::Foreign
            }
        };
        self.open.push(next);
        Ok(())
    }

    fn end(&mut self) -> Result<()> {
        match self.open.pop() {
            Some(Open::Chunk(chunk)) => match self.open.pop() {
                Some(Open::Chunks { announced, found }) => {
                    self.open.push(Open::Chunks { announced, found: found + 1 });
                    // Below <chunks> there is always the chunk that it belongs to.
                    let parent = self.open.len().checked_sub(2).and_then(|at| self.open.get_mut(at));
                    if let Some(Open::Chunk(parent)) = parent {
                        parent.chunks.push(chunk);
                    }
                }
                _ => self.root = Some(chunk),
            },
            Some(Open::Item(parts)) => {
                let item = value::build(parts).map_err(|reason| self.error(reason))?;
                if let Some(Open::Items { found, .. }) = self.open.last_mut() {
                    *found += 1;
                }
                let parent = self.open.len().checked_sub(2).and_then(|at| self.open.get_mut(at));
                if let Some(Open::Chunk(parent)) = parent {
                    parent.items.push(item);
                }
            }
            Some(Open::Field { name, text }) => {
                if let Some(Open::Item(parts)) = self.open.last_mut() {
                    parts.fields.push((name, text));
                }
            }
            Some(Open::Items { announced, found }) => self.check_count("items", announced, found),
            Some(Open::Chunks { announced, found }) => self.check_count("chunks", announced, found),
            Some(Open::Foreign) | None => {}
        }
        Ok(())
    }

    fn text(&mut self, text: &str) -> Result<()> {
        match self.open.last_mut() {
            Some(Open::Item(parts)) => parts.text.push_str(text),
            Some(Open::Field { text: all, .. }) => all.push_str(text),
            Some(Open::Foreign) => {}
            _ if is_blank(text) => {}
            None => return Err(self.error("there is text outside the archive")),
            Some(_) => self.note("text between the elements was left out".to_owned()),
        }
        Ok(())
    }

    fn check_count(&mut self, what: &str, announced: Option<i64>, found: i64) {
        if let Some(announced) = announced
            && announced != found
        {
            self.note(format!("{announced} {what} were announced and {found} came"));
        }
    }

    /// No attribute twice, and few: comparing each with all others must not take long.
    fn check_attributes(&self, element: &BytesStart<'_>) -> Result<()> {
        let mut names = Vec::new();
        for attribute in element.attributes().with_checks(false) {
            let name = attribute.map_err(|error| self.error(error.to_string()))?.key;
            if names.contains(&name) {
                return Err(self.error(format!("the attribute {} comes twice", clip(name.as_ref()))));
            }
            if names.len() == MOST_ATTRIBUTES {
                return Err(self.error(format!("an element has more than {MOST_ATTRIBUTES} attributes")));
            }
            names.push(name);
        }
        Ok(())
    }

    fn attribute(&self, element: &BytesStart<'_>, name: &str) -> Result<Option<String>> {
        let found = element.try_get_attribute(name).map_err(|error| self.error(error.to_string()))?;
        found.map(|a| text::attribute(&a.value).map_err(|reason| self.error(reason))).transpose()
    }

    /// An attribute that is a whole number.
    fn number(&self, element: &BytesStart<'_>, name: &str) -> Result<Option<i32>> {
        let Some(text) = self.attribute(element, name)? else { return Ok(None) };
        let number = text.trim().parse();
        number.map(Some).map_err(|_| self.error(format!("{name} is \"{}\", not a whole number", clip(&text))))
    }

    fn names(&self, element: &BytesStart<'_>) -> Result<(Option<String>, Option<i32>)> {
        let index = self.number(element, "index")?.filter(|index| *index != -1);
        Ok((self.attribute(element, "name")?, index))
    }

    /// The `count` attribute: people edit these files by hand and forget it, so nothing depends on it.
    fn announced(&self, element: &BytesStart<'_>) -> Result<Option<i64>> {
        Ok(self.attribute(element, "count")?.and_then(|text| text.trim().parse().ok()))
    }

    fn item(&self, element: &BytesStart<'_>) -> Result<Open> {
        let (name, index) = self.names(element)?;
        let name = name.ok_or_else(|| self.error("an item has no name"))?;
        let code = match self.number(element, "type_code")? {
            Some(code) => code,
            None => {
                let type_name = self.attribute(element, "type_name")?;
                value::code_of(type_name.as_deref().unwrap_or_default())
                    .ok_or_else(|| self.error(format!("the item \"{}\" has no type_code", clip(&name))))?
            }
        };
        Ok(Open::Item(ItemParts { name, index, code, text: String::new(), fields: Vec::new() }))
    }
}

/// Whether a text is only what stands between elements, as most texts of a usual file are. They are told byte by byte.
fn is_blank(text: &str) -> bool {
    text.bytes().all(|b| matches!(b, b' ' | b'\t' | b'\r' | b'\n'))
        || text.chars().all(|c| matches!(c, '\u{feff}' | ' ' | '\t' | '\r' | '\n'))
}

/// Enough of a text to recognise it in a message.
pub(super) fn clip(text: &str) -> String {
    let mut clipped: String = text.chars().take(40).collect();
    if clipped.len() < text.len() {
        clipped.push('…');
    }
    clipped
}
