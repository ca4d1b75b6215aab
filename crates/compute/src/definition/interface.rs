//! What a definition asks for and gives: its contextual inputs and outputs, and groups marked `RH_IN` and `RH_OUT`.

use std::collections::HashSet;

use katydid_component::registry;
use katydid_data::Kind;
use katydid_definition::document::special::{Contextual, Group};
use katydid_definition::document::{Document, Lookup, Object, Special, ids};

/// How the data of an input is read from JSON.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash)]
pub enum Form {
    /// As its type is written. A text is in JSON, or has escapes; geometry may be of any class; what is of no type in
    /// particular is what it looks like.
    Of(Kind),
    /// A text as it stands.
    RawText,
}

/// An input.
#[derive(Debug, Clone, PartialEq)]
pub struct Input {
    /// Its name: that of a contextual input, or the label of a group, mark and all.
    pub name: String,
    /// The place of its object in the document.
    pub object: usize,
    /// Which input of the object it is.
    pub port: usize,
    /// How its data is read.
    pub form: Form,
    /// The name of its type, as Grasshopper has it.
    pub type_name: &'static str,
    /// What the caller is told; none for a group.
    pub prompt: Option<String>,
    /// The fewest items.
    pub at_least: i32,
    /// The most items; 2³¹ − 1 for any number.
    pub at_most: i32,
    /// Whether it takes a whole tree.
    pub tree_access: bool,
    /// The smallest number it takes, where there is one.
    pub minimum: Option<f64>,
    /// The largest number it takes, where there is one.
    pub maximum: Option<f64>,
    /// How far down the canvas it stands: what clients see is in this order.
    pub height: f32,
}

/// Where the data of an output is.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash)]
pub enum Data {
    /// What an object gives at an output.
    Given {
        /// The object.
        object: usize,
        /// Its output.
        output: usize,
    },
    /// What an object takes at an input.
    Taken {
        /// The object.
        object: usize,
        /// Its input.
        input: usize,
    },
}

/// An output.
#[derive(Debug, Clone, PartialEq)]
pub struct Output {
    /// Its name.
    pub name: String,
    /// Where its data is.
    pub data: Data,
    /// The name of its type.
    pub type_name: &'static str,
    /// How far down the canvas it stands.
    pub height: f32,
}

/// The inputs and outputs, in the order of the document.
#[derive(Debug, Clone, PartialEq, Default)]
pub struct Interface {
    /// The inputs.
    pub inputs: Vec<Input>,
    /// The outputs.
    pub outputs: Vec<Output>,
    /// What is wrong with them, in Rhino.Compute's words.
    pub problems: Vec<String>,
}

/// The most items of an input that takes a list.
pub(super) const ANY_NUMBER: i32 = i32::MAX;

impl Input {
    /// An input with nothing said of it.
    pub(crate) fn new(name: String, object: usize, port: usize, form: Form) -> Self {
        Self {
            name,
            object,
            port,
            form,
            type_name: Kind::Generic.name(),
            prompt: None,
            at_least: 1,
            at_most: ANY_NUMBER,
            tree_access: false,
            minimum: None,
            maximum: None,
            height: 0.0,
        }
    }
}

impl Interface {
    /// The interface of a document.
    pub fn of(document: &Document) -> Self {
        let mut finder =
            Finder { document, lookup: document.lookup(), names: Default::default(), found: Self::default() };
        for (index, object) in document.objects.iter().enumerate() {
            finder.look(index, object);
        }
        finder.found
    }

    /// The only input that has a name with or without the mark `RH_IN:`. Programs that stand between a caller and the
    /// server, as appserver does, put the mark before each name in some of their versions, and do not in others.
    pub(crate) fn input_but_for_the_mark(&self, name: &str) -> Option<&Input> {
        let plain = without_mark(name);
        let mut fitting = self.inputs.iter().filter(|input| without_mark(&input.name) == plain);
        let input = fitting.next()?;
        fitting.next().is_none().then_some(input)
    }
}

/// The name without the mark before it.
fn without_mark(name: &str) -> &str {
    name.strip_prefix("RH_IN:").unwrap_or(name)
}

/// Looks through a document.
struct Finder<'a> {
    document: &'a Document,
    lookup: Lookup,
    /// The names of inputs and of outputs so far.
    names: [HashSet<String>; 2],
    found: Interface,
}

impl Finder<'_> {
    fn look(&mut self, index: usize, object: &Object) {
        match object.special() {
            Some(Special::Contextual(contextual)) if object.is_floating() => {
                let input = self.contextual(index, object, contextual);
                self.add_input(input);
            }
            Some(Special::Group(group)) => self.group(&group),
            _ if [ids::CONTEXT_BAKE, ids::CONTEXT_PRINT].contains(&object.component) => {
                let Some(port) = object.inputs.first() else { return };
                let print = object.component == ids::CONTEXT_PRINT;
                self.add_output(Output {
                    name: port.nickname.clone(),
                    data: Data::Taken { object: index, input: 0 },
                    type_name: if print { Kind::Text.name() } else { Kind::Geometry.name() },
                    height: port_height(object, port).unwrap_or_else(|| height(object)),
                });
            }
            _ => {}
        }
    }

    fn contextual(&self, index: usize, object: &Object, contextual: Contextual) -> Input {
        let kind = kind(object);
        let slider = self.slider_before(object);
        let [minimum, maximum] = match slider {
            Some(limits) => limits.map(Some),
            None => [contextual.minimum.filter(is_limit), contextual.maximum.filter(is_limit)],
        };
        Input {
            type_name: kind.name(),
            prompt: Some(contextual.prompt),
            at_least: contextual.at_least,
            at_most: contextual.at_most,
            tree_access: contextual.tree_access,
            minimum,
            maximum,
            height: height(object),
            ..Input::new(object.nickname.clone(), index, 0, form(kind, Form::Of(Kind::Text)))
        }
    }

    /// The limits of the slider that is the only source of an object.
    fn slider_before(&self, object: &Object) -> Option<[f64; 2]> {
        let [source] = object.inputs.first()?.sources.as_slice() else { return None };
        limits(self.document.objects.get(self.lookup.output(*source)?.object)?)
    }

    /// A group counts by its first object; the others may be there for looks. Ids that lead nowhere are left over from
    /// objects that are gone.
    fn group(&mut self, group: &Group) {
        if !group.marks_input() && !group.marks_output() {
            return;
        }
        let Some(first) = group.members.iter().find_map(|id| self.lookup.object(*id)) else { return };
        let Some(object) = self.document.objects.get(first) else { return };
        if group.marks_input() && object.is_floating() {
            let input = self.grouped(group, first, object);
            self.add_input(input);
        }
        if !group.marks_output() || object.is_annotation() {
            return;
        }
        let several = object.outputs.len() > 1;
        for (output, port) in object.outputs.iter().enumerate() {
            let label = &group.label;
            self.add_output(Output {
                name: if several { format!("{label} ({})", port.nickname) } else { label.clone() },
                data: Data::Given { object: first, output },
                type_name: output_kind(object, output).name(),
                height: port_height(object, port).unwrap_or_else(|| height(object)),
            });
        }
    }

    fn grouped(&self, group: &Group, index: usize, object: &Object) -> Input {
        let kind = kind(object);
        let slider = limits(object);
        let texts = if object.component == ids::PANEL { Form::Of(Kind::Text) } else { Form::RawText };
        Input {
            type_name: kind.name(),
            at_most: if slider.is_some() { 1 } else { ANY_NUMBER },
            minimum: slider.map(|limits| limits[0]),
            maximum: slider.map(|limits| limits[1]),
            height: height(object),
            ..Input::new(group.label.clone(), index, 0, form(kind, texts))
        }
    }

    fn add_input(&mut self, input: Input) {
        if self.names[0].insert(input.name.clone()) {
            self.found.inputs.push(input);
        } else {
            self.complain("input");
        }
    }

    fn add_output(&mut self, output: Output) {
        if self.names[1].insert(output.name.clone()) {
            self.found.outputs.push(output);
        } else {
            self.complain("output");
        }
    }

    fn complain(&mut self, side: &str) {
        let text = format!(
            "Multiple {side} parameters with the same name were detected. Parameter names must be unique."
        );
        if !self.found.problems.contains(&text) {
            self.found.problems.push(text);
        }
    }
}

/// The limits of a slider.
fn limits(object: &Object) -> Option<[f64; 2]> {
    match object.special() {
        Some(Special::Slider(slider)) => Some([slider.min.min(slider.max), slider.min.max(slider.max)]),
        _ => None,
    }
}

/// Whether a number limits anything: inputs without limits have the largest numbers there are.
fn is_limit(x: &f64) -> bool {
    x.abs() < 1e300
}

/// The type of a floating parameter.
fn kind(object: &Object) -> Kind {
    if object.component == ids::PANEL { Kind::Text } else { output_kind(object, 0) }
}

fn output_kind(object: &Object, output: usize) -> Kind {
    let declared = registry::by_guid(object.component).and_then(|component| component.output(output));
    declared.map_or(Kind::Generic, |port| port.kind)
}

/// How data for an input of a type is read; `texts` tells how texts are.
pub(super) fn form(kind: Kind, texts: Form) -> Form {
    match kind {
        Kind::Text => texts,
        Kind::Surface | Kind::Brep | Kind::Mesh | Kind::SubD | Kind::PointCloud => Form::Of(Kind::Geometry),
        kind => Form::Of(kind),
    }
}

/// How far down the canvas an object stands.
fn height(object: &Object) -> f32 {
    object.pivot.map_or(0.0, |[_, y]| y)
}

/// How far down a port of a component stands.
fn port_height(object: &Object, port: &katydid_definition::document::Port) -> Option<f32> {
    if object.is_floating() {
        return None;
    }
    let [_, y] = port.chunk(object.container())?.child("Attributes")?.canvas_point("Pivot")?;
    Some(y)
}
