//! LunchBox Data: JSON written as XML, and XML as JSON.
//!
//! An attribute is a property with @ before its name, the text of an element with attributes or other elements is the property
//! `#text`, and elements of one name are a list. This convention is widely used; that LunchBox follows it is our reading.

use std::sync::Arc as Shared;

use katydid_component::{Context, Message, component};
use quick_xml::events::{BytesStart, Event};
use quick_xml::{Reader, XmlVersion, escape};

use crate::ghowl::broken;
use crate::jswan::Json;

/// Elements may stand so deep in one another.
const DEEPEST: usize = 120;
/// The property that the text of an element is.
const TEXT: &str = "#text";
/// The property that the head of a document is.
const HEAD: &str = "?xml";

/// Adds a property; of several of one name it makes a list.
fn add(properties: &mut Vec<(String, Json)>, name: String, value: Json) {
    match properties.iter_mut().find(|(known, _)| *known == name) {
        Some((_, Json::List(items))) => items.push(value),
        Some((_, known)) => {
            let first = std::mem::replace(known, Json::Null);
            *known = Json::List(vec![first, value]);
        }
        None => properties.push((name, value)),
    }
}

/// An element that is being read: its name, its properties, and its text.
#[derive(Default)]
struct Element {
    name: String,
    properties: Vec<(String, Json)>,
    text: String,
}

impl Element {
    fn new(start: &BytesStart<'_>) -> Result<Self, Message> {
        let mut element = Self { name: start.name().as_ref().to_owned(), ..Self::default() };
        element.read_attributes(start)?;
        Ok(element)
    }

    fn read_attributes(&mut self, start: &BytesStart<'_>) -> Result<(), Message> {
        for attribute in start.attributes() {
            let attribute = attribute.map_err(|error| broken(&error.to_string()))?;
            let value = attribute.normalized_value(XmlVersion::Implicit1_0);
            let value = value.map_err(|error| broken(&error.to_string()))?;
            add(&mut self.properties, format!("@{}", attribute.key.as_ref()), Json::Text(value.into_owned()));
        }
        Ok(())
    }

    fn finished(mut self) -> (String, Json) {
        let text = if self.text.trim().is_empty() { None } else { Some(Json::Text(self.text)) };
        let value = match text {
            None if self.properties.is_empty() => Json::Null,
            Some(text) if self.properties.is_empty() => text,
            text => {
                self.properties.extend(text.map(|text| (TEXT.to_owned(), text)));
                Json::Object(self.properties)
            }
        };
        (self.name, value)
    }
}

/// XML as an object in JSON.
fn read(context: &Context<'_>, xml: &str) -> Result<Json, Message> {
    // A value takes many times the bytes of its text.
    context.bytes(xml.len().saturating_mul(8))?;
    let mut reader = Reader::from_str(xml.trim_start_matches('\u{feff}'));
    // The document is the outermost element.
    let mut open = vec![Element::default()];
    loop {
        context.check()?;
        match reader.read_event().map_err(|error| broken(&error.to_string()))? {
            Event::Start(start) => {
                if open.len() > DEEPEST {
                    return Err(Message::error(format!("The elements stand more than {DEEPEST} deep")));
                }
                open.push(Element::new(&start)?);
            }
            Event::Empty(start) => {
                let (name, value) = Element::new(&start)?.finished();
                if let Some(parent) = open.last_mut() {
                    add(&mut parent.properties, name, value);
                }
            }
            Event::End(_) => {
                let closed = open.pop().map(Element::finished);
                if let (Some((name, value)), Some(parent)) = (closed, open.last_mut()) {
                    add(&mut parent.properties, name, value);
                }
            }
            Event::Text(text) => {
                open.last_mut().into_iter().for_each(|e| e.text.push_str(&text.xml10_content()))
            }
            Event::CData(text) => {
                open.last_mut().into_iter().for_each(|e| e.text.push_str(&text.xml10_content()))
            }
            Event::GeneralRef(name) => {
                let reference = format!("&{};", &*name);
                let known = escape::unescape(&reference).map_err(|error| broken(&error.to_string()))?;
                open.last_mut().into_iter().for_each(|element| element.text.push_str(&known));
            }
            Event::Eof => break,
            Event::Decl(_) | Event::Comment(_) | Event::PI(_) | Event::DocType(_) => {}
        }
    }
    let [document] = <[Element; 1]>::try_from(open).map_err(|_| broken("an element is not closed"))?;
    match document.properties.as_slice() {
        [] => Err(broken("it has no element")),
        [(_, root)] if !matches!(root, Json::List(_)) => Ok(Json::Object(document.properties)),
        _ => Err(broken("it has more than one outermost element")),
    }
}

/// The name of an element or an attribute.
///
/// # Errors
/// XML does not allow it.
fn checked(name: &str) -> Result<&str, Message> {
    let is_first = |c: char| c.is_alphabetic() || c == '_' || c == ':';
    let is_fine = |c: char| is_first(c) || c.is_numeric() || "-.".contains(c);
    if name.starts_with(is_first) && name.chars().all(is_fine) {
        Ok(name)
    } else {
        Err(Message::error(format!("XML does not allow the name {name}")))
    }
}

/// The text of a value that is neither an object nor a list.
fn plain(value: &Json) -> String {
    match value {
        Json::Null | Json::List(_) | Json::Object(_) => String::new(),
        Json::Text(text) => text.clone(),
        other => other.text(),
    }
}

/// Writes a value as elements of a name.
fn write(
    context: &Context<'_>,
    name: &str,
    value: &Json,
    xml: &mut String,
    depth: usize,
) -> Result<(), Message> {
    context.check()?;
    if depth > DEEPEST {
        return Err(Message::error(format!("The values stand more than {DEEPEST} deep")));
    }
    let name = checked(name)?;
    let no_properties = Vec::new();
    let properties = match value {
        Json::List(items) => {
            return items.iter().try_for_each(|item| write(context, name, item, xml, depth + 1));
        }
        Json::Object(properties) => properties,
        _ => &no_properties,
    };
    xml.push('<');
    xml.push_str(name);
    for (key, value) in properties {
        if let Some(attribute) = key.strip_prefix('@') {
            let value = plain(value);
            let value = escape::escape(value.as_str());
            xml.push_str(&format!(" {}=\"{value}\"", checked(attribute)?));
        }
    }
    let start = xml.len();
    xml.push('>');
    xml.push_str(&escape::escape(plain(value).as_str()));
    for (key, value) in properties {
        if key == TEXT {
            xml.push_str(&escape::escape(plain(value).as_str()));
        } else if !key.starts_with('@') {
            write(context, key, value, xml, depth + 1)?;
        }
    }
    if xml.len() == start + 1 {
        xml.truncate(start);
        xml.push_str(" />");
    } else {
        xml.push_str(&format!("</{name}>"));
    }
    context.bytes(xml.len() - start)
}

/// JSON as XML. The object has one property, which becomes the outermost element; properties become elements, lists one for each item,
/// and those that begin with @ attributes. Stands for LunchBox's Convert JSON to XML.
#[component(
    "6b1c7c1e-0d4e-4e3a-9d5c-3f0a5a6f1cb1",
    name = "Convert JSON to XML",
    nick = "JSON-XML",
    at = "LunchBox/Data"
)]
#[output("XML String", "XML", "The XML.")]
fn json_to_xml(
    context: &Context<'_>,
    /// The JSON.
    #[port("JSON String", "JSON")]
    json: Shared<str>,
) -> Result<Shared<str>, Message> {
    context.bytes(json.len().saturating_mul(8))?;
    let found = Json::parse(json.trim_start_matches('\u{feff}'));
    let found = found.map_err(|error| Message::error(format!("No JSON: {error}")))?;
    let Json::Object(properties) = found else {
        return Err(Message::error("The JSON is no object"));
    };
    let mut elements = properties.iter().filter(|(name, _)| name != HEAD);
    match (elements.next(), elements.next()) {
        (Some((name, value)), None) if !matches!(value, Json::List(_)) => {
            let mut xml = String::new();
            write(context, name, value, &mut xml, 0)?;
            Ok(xml.into())
        }
        _ => Err(Message::error(
            "XML has one outermost element: the object must have one property, and no list",
        )),
    }
}

/// XML as JSON. An element becomes a property, its attributes properties that begin with @, its text the property `#text` where there
/// is more in it, and elements of one name a list. Comments and the head of the document are left out. Stands for LunchBox's Convert
/// XML to JSON.
#[component(
    "6b1c7c1e-0d4e-4e3a-9d5c-3f0a5a6f1cb2",
    name = "Convert XML to JSON",
    nick = "XML-JSON",
    at = "LunchBox/Data"
)]
#[output("JSON String", "JSON", "The JSON.")]
fn xml_to_json(
    context: &Context<'_>,
    /// The XML.
    #[port("XML String", "XML")]
    xml: Shared<str>,
) -> Result<Shared<str>, Message> {
    let text = read(context, &xml)?.text();
    context.bytes(text.len())?;
    Ok(text.into())
}

#[cfg(test)]
mod tests {
    use katydid_component::testing::Trial;

    fn xml(json: &str) -> Trial {
        Trial::of("Convert JSON to XML").item(json)
    }

    fn json(xml: &str) -> Trial {
        Trial::of("Convert XML to JSON").item(xml)
    }

    #[test]
    fn objects_become_elements() {
        let told = xml(
            r##"{"house": {"@floors": 2, "room": ["hall", {"@id": "k", "#text": "a & b"}], "roof": null}}"##,
        );
        let wanted = r#"<house floors="2"><room>hall</room><room id="k">a &amp; b</room><roof /></house>"#;
        assert_eq!(told.texts(0), [format!("{{0}}: {wanted}")]);
        assert_eq!(xml(r#"{"a": true}"#).texts(0), ["{0}: <a>true</a>"]);
        assert_eq!(xml(r#"{"?xml": {"@version": "1.0"}, "a": ""}"#).texts(0), ["{0}: <a />"]);
    }

    #[test]
    fn elements_become_properties() {
        let told = json(
            "<?xml version=\"1.0\"?><!-- plan --><house floors=\"2\"><room>hall</room>\n<room id=\"k\">a &amp; b</room><roof/></house>",
        );
        let wanted = r##"{"house":{"@floors":"2","room":["hall",{"@id":"k","#text":"a & b"}],"roof":null}}"##;
        assert_eq!(told.texts(0), [format!("{{0}}: {wanted}")]);
        assert_eq!(json("<a><![CDATA[1 < 2]]></a>").texts(0), [r#"{0}: {"a":"1 < 2"}"#]);
    }

    #[test]
    fn there_and_back() {
        let source = r##"{"a":{"@k":"v","b":["1","2",{"c":null}],"#text":"t"}}"##;
        let there = xml(source).run().outputs[0].clone();
        let back = Trial::of("Convert XML to JSON").tree(there).texts(0);
        assert_eq!(back, [format!("{{0}}: {source}")]);
    }

    #[test]
    fn what_cannot_be_converted() {
        assert!(xml("[1, 2]").message().contains("no object"));
        assert!(xml(r#"{"a": 1, "b": 2}"#).message().contains("one property"));
        assert!(xml(r#"{"a": [1, 2]}"#).message().contains("one property"));
        assert!(xml("{}").message().contains("one property"));
        assert!(xml(r#"{"a b": 1}"#).message().contains("does not allow the name a b"));
        assert!(xml("{").message().starts_with("No JSON"));
        for broken in ["<a>", "", "<a/><b/>", "<a/><a/>", "text", "<a></b>"] {
            assert!(json(broken).message().contains("broken"), "{broken}");
        }
        let deep = format!("{}{}", "<a>".repeat(500), "</a>".repeat(500));
        assert!(json(&deep).message().contains("deep"));
    }
}
