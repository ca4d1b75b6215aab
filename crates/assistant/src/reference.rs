//! Objects and ports by the words that an assistant uses: ids, or the names that the text form has for them.

use katydid_definition::document::{Document, Object, Port, Side};
use katydid_definition::kd;
use uuid::Uuid;

use crate::fault::Fault;

/// The names of a document's objects.
pub(crate) struct Names<'a> {
    document: &'a Document,
    labels: Vec<String>,
}

/// A port that was found.
#[derive(Debug, Clone, Copy)]
pub(crate) struct Found<'a> {
    /// The place of its object.
    pub(crate) object: usize,
    /// Its place among them.
    pub(crate) index: usize,
    /// The port.
    pub(crate) port: &'a Port,
}

impl<'a> Names<'a> {
    pub(crate) fn new(document: &'a Document) -> Self {
        Self { document, labels: kd::labels(document) }
    }

    /// The name of the object at a place.
    pub(crate) fn label(&self, index: usize) -> &str {
        self.labels.get(index).map_or("", String::as_str)
    }

    /// The place of an object, by its id, its name in the text, or that or its component's name in any case where only one
    /// object has it.
    pub(crate) fn object(&self, what: &str, name: &str) -> Result<usize, Fault> {
        let place = format!("object \"{}\"", crate::document::cut(name));
        self.find(name).map_err(|why| Fault::new(what, place, why))
    }

    fn find(&self, name: &str) -> Result<usize, String> {
        let name = name.trim().trim_matches('`');
        let objects = &self.document.objects;
        if let Ok(id) = Uuid::try_parse(name.trim_matches(['{', '}'])) {
            let found = objects.iter().position(|object| object.id == id);
            return found.ok_or_else(|| "there is no object with that id".to_owned());
        }
        let by_label = self.labels.iter().position(|label| label == name);
        if let Some(found) = by_label {
            return Ok(found);
        }
        let matching = |same: &dyn Fn(usize, &Object) -> bool| -> Vec<usize> {
            objects.iter().enumerate().filter(|(at, object)| same(*at, object)).map(|(at, _)| at).collect()
        };
        let mut found = matching(&|at, _| self.label(at).eq_ignore_ascii_case(name));
        if found.is_empty() {
            found = matching(&|_, object| object.name.eq_ignore_ascii_case(name));
        }
        match found.as_slice() {
            [one] => Ok(*one),
            [] => Err(match self.near(name) {
                Some(near) => format!("there is no such object: did you mean \"{near}\"?"),
                None => "there is no such object: list_objects tells what there is".to_owned(),
            }),
            many => Err(format!(
                "{} objects are called so: use one of their names, {}",
                many.len(),
                many.iter()
                    .take(5)
                    .map(|at| format!("\"{}\"", self.label(*at)))
                    .collect::<Vec<_>>()
                    .join(", ")
            )),
        }
    }

    /// A name that holds the word, or is held by it.
    fn near(&self, name: &str) -> Option<&str> {
        let wanted = name.to_lowercase();
        let is_near = |label: &&String| {
            let label = label.to_lowercase();
            wanted.len() > 1 && label.len() > 1 && (label.contains(&wanted) || wanted.contains(&label))
        };
        self.labels.iter().find(is_near).map(String::as_str)
    }

    /// A port by its id, or by its object's name alone or with a point and its name, nickname or number behind it
    /// (`A.Point`, `A.0`). Without a port the first output is meant, or the first input.
    pub(crate) fn port(&self, what: &str, side: Side, name: &str) -> Result<Found<'a>, Fault> {
        let place = format!("port \"{}\"", crate::document::cut(name));
        let told = |why: String| Fault::new(what, place.clone(), why);
        if let Ok(id) = Uuid::try_parse(name.trim()) {
            for (object, one) in self.document.objects.iter().enumerate() {
                if let Some(index) = one.ports(side).iter().position(|port| port.id == id)
                    && let Some(port) = one.ports(side).get(index)
                {
                    return Ok(Found { object, index, port });
                }
            }
        }
        let whole = self.find(name);
        let split = name.rsplit_once('.').map(|(object, port)| (object, Some(port)));
        let (object, port) = match (&whole, split) {
            (Ok(object), _) => (*object, None),
            (Err(_), Some((object, port))) => (self.find(object).map_err(&told)?, port),
            (Err(why), None) => return Err(told(why.clone())),
        };
        let Some(one) = self.document.objects.get(object) else { return Err(told("it is gone".to_owned())) };
        self.port_of(object, one, side, port).map_err(told)
    }

    /// The port of an object: by name, nickname or number, or the only one.
    fn port_of(
        &self,
        object: usize,
        one: &'a Object,
        side: Side,
        port: Option<&str>,
    ) -> Result<Found<'a>, String> {
        let ports = one.ports(side);
        let word = if side == Side::Input { "input" } else { "output" };
        let index = match port.map(|port| port.trim().trim_matches('`')) {
            None if ports.is_empty() => return Err(format!("it has no {word}")),
            None if side == Side::Input && ports.len() > 1 => {
                return Err(format!("which input is meant? It has {}", named(ports)));
            }
            None => Some(0),
            Some(port) => {
                let at = |same: &dyn Fn(&Port) -> bool| ports.iter().position(same);
                at(&|p| p.nickname == port || p.name == port)
                    .or_else(|| {
                        at(&|p| p.nickname.eq_ignore_ascii_case(port) || p.name.eq_ignore_ascii_case(port))
                    })
                    .or_else(|| port.parse().ok())
            }
        };
        let found = index.and_then(|index| Some(Found { object, index, port: ports.get(index)? }));
        found.ok_or_else(|| match ports.is_empty() {
            true => format!("it has no {word}"),
            false => format!("there is no such {word}: it has {}", named(ports)),
        })
    }

    /// The name of the output with that id, as the text form writes it.
    pub(crate) fn output(&self, id: Uuid, lookup: &katydid_definition::document::Lookup) -> String {
        let Some(port) = lookup.output(id) else { return format!("@{id}") };
        let label = self.label(port.object);
        match self.document.objects.get(port.object) {
            Some(object) if object.outputs.len() > 1 => {
                let name = object.outputs.get(port.port).map_or("", |output| output.name.as_str());
                format!("{label}.{name}")
            }
            _ => label.to_owned(),
        }
    }
}

/// The names of ports, for a message.
fn named(ports: &[Port]) -> String {
    let name = |port: &Port| match port.name.is_empty() {
        true => port.nickname.clone(),
        false => port.name.clone(),
    };
    ports.iter().take(20).map(name).collect::<Vec<_>>().join(", ")
}
