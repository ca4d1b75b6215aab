use std::collections::HashMap;
use std::ops::{Deref, DerefMut};
use std::sync::Arc;

use uuid::Uuid;

use super::ids;
use super::persistent::Persistent;
use super::port::{Port, PortPlace, Side};
use crate::archive::{Chunk, Item};

/// One thing on the canvas: a component, a floating parameter, or an annotation.
///
/// The fields are read from the object's chunk, which stays the truth: [`set_nickname`](Self::set_nickname) and
/// its kin change both. After changing [`container_mut`](Self::container_mut) by hand call
/// [`refresh`](Self::refresh).
///
/// A clone is cheap: it shares everything until one of the two is changed.
#[derive(Debug, Clone)]
pub struct Object(Arc<Fields>);

/// What is read from an [`Object`]'s chunk, and the chunk.
#[derive(Debug, Clone, PartialEq)]
pub struct Fields {
    /// The component type.
    pub component: Uuid,
    /// The type's name when the file was saved; people may not change it, except of clusters.
    pub name: String,
    /// The add-on the type comes from; `None` for what Grasshopper brings along.
    pub lib: Option<Uuid>,
    /// The object's own id.
    pub id: Uuid,
    /// The name that its author gave it.
    pub nickname: String,
    /// What it does, in the file's words.
    pub description: String,
    /// What it is.
    pub kind: ObjectKind,
    /// Whether it is disabled: it acts as if it had no outputs.
    pub locked: bool,
    /// Whether its preview is off.
    pub hidden: bool,
    /// Where it stands on the canvas: x, y, width, height in pixels.
    pub bounds: Option<[f32; 4]>,
    /// The point it hangs from on the canvas.
    pub pivot: Option<[f32; 2]>,
    /// The inputs; a floating parameter has one, itself.
    pub inputs: Vec<Port>,
    /// The outputs; a floating parameter has one, itself after its modifiers.
    pub outputs: Vec<Port>,
    /// Whether ports can be added and removed.
    pub variable: bool,
    /// Which input's paths the outputs follow, where the author chose one.
    pub principal: Option<usize>,
    /// How many clusters the object is inside of.
    pub(super) nesting: usize,
    chunk: Chunk,
}

/// What an object is.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash)]
pub enum ObjectKind {
    /// It has inputs and outputs, and computes.
    Component,
    /// It holds data: a floating parameter, a slider, a panel.
    Parameter,
    /// It is there for the reader.
    Annotation(Annotation),
}

/// An object without data.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash)]
pub enum Annotation {
    /// A frame around objects.
    Group,
    /// A text.
    Scribble,
    /// Drawn lines.
    Sketch,
}

/// What a chunk without a container is read from.
static NOTHING: Chunk = Chunk { name: String::new(), index: None, items: Vec::new(), chunks: Vec::new() };

impl Deref for Object {
    type Target = Fields;

    fn deref(&self) -> &Fields {
        &self.0
    }
}

impl DerefMut for Object {
    fn deref_mut(&mut self) -> &mut Fields {
        Arc::make_mut(&mut self.0)
    }
}

impl PartialEq for Object {
    fn eq(&self, other: &Self) -> bool {
        self.is_same(other) || self.0 == other.0
    }
}

impl Object {
    /// Whether both are clones of one, and neither was changed since.
    pub fn is_same(&self, other: &Self) -> bool {
        Arc::ptr_eq(&self.0, &other.0)
    }

    /// Reads an object from its `Object` chunk. Whatever is missing reads as empty.
    pub fn from_chunk(chunk: Chunk) -> Self {
        let mut object = Self(Arc::new(Fields {
            component: Uuid::nil(),
            name: String::new(),
            lib: None,
            id: Uuid::nil(),
            nickname: String::new(),
            description: String::new(),
            kind: ObjectKind::Component,
            locked: false,
            hidden: false,
            bounds: None,
            pivot: None,
            inputs: Vec::new(),
            outputs: Vec::new(),
            variable: false,
            principal: None,
            nesting: 0,
            chunk,
        }));
        object.refresh();
        object
    }

    /// An object of a component type, without ports, place or id.
    pub fn new(component: Uuid, name: &str) -> Self {
        let mut chunk = Chunk::new("Object");
        chunk.items = vec![Item::new("GUID", component), Item::new("Name", name)];
        chunk.chunks = vec![Chunk::new("Container")];
        Self::from_chunk(chunk)
    }

    /// Reads the fields from the chunk again.
    pub fn refresh(&mut self) {
        Arc::make_mut(&mut self.0).refresh();
    }

    /// Whether the object is a parameter that stands on the canvas by itself: its own sources are its input,
    /// and it is its own output.
    pub fn is_floating(&self) -> bool {
        self.kind == ObjectKind::Parameter
    }

    /// Whether the object is there for the reader only.
    pub fn is_annotation(&self) -> bool {
        matches!(self.kind, ObjectKind::Annotation(_))
    }

    /// The object's own data in the file.
    pub fn container(&self) -> &Chunk {
        self.chunk.child("Container").unwrap_or(&NOTHING)
    }

    /// The object's own data, to be changed; call [`refresh`](Self::refresh) afterwards.
    pub fn container_mut(&mut self) -> &mut Chunk {
        let chunks = &mut self.chunk.chunks;
        let found = chunks.iter().position(|chunk| chunk.name == "Container" && chunk.index.is_none());
        let at = found.unwrap_or_else(|| {
            chunks.insert(0, Chunk::new("Container"));
            0
        });
        &mut chunks[at]
    }

    /// The whole chunk: type, add-on and container.
    pub fn chunk(&self) -> &Chunk {
        &self.chunk
    }

    /// The ports of one side.
    pub fn ports(&self, side: Side) -> &[Port] {
        match side {
            Side::Input => &self.inputs,
            Side::Output => &self.outputs,
        }
    }

    /// The name to call the object by: nickname, else type name.
    pub fn title(&self) -> &str {
        if self.nickname.trim().is_empty() { &self.name } else { &self.nickname }
    }

    /// The values kept in an input, where there are any.
    pub fn persistent(&self, port: &Port) -> Option<Persistent> {
        if port.has_persistent { Persistent::read(port.chunk(self.container())?) } else { None }
    }
}

impl Fields {
    /// Reads the fields from the chunk again.
    fn refresh(&mut self) {
        let chunk = &self.chunk;
        let container = chunk.child("Container").unwrap_or(&NOTHING);
        let text = |name| container.str(name).unwrap_or_default().to_owned();
        self.component = chunk.guid("GUID").unwrap_or_default();
        self.name = chunk.str("Name").unwrap_or_default().to_owned();
        // GhPython of Rhino 6 and 7 writes a zero id for itself.
        self.lib = chunk.guid("Lib").filter(|lib| !lib.is_nil());
        self.id = container.guid("InstanceGuid").unwrap_or_default();
        self.nickname = text("NickName");
        self.description = text("Description");
        self.locked = container.bool("Locked").unwrap_or(false);
        self.hidden = container.bool("Hidden").unwrap_or(false);
        let attributes = container.child("Attributes").unwrap_or(&NOTHING);
        self.bounds = attributes.canvas_rectangle("Bounds");
        self.pivot = attributes.canvas_point("Pivot");
        let parameters = container.child("ParameterData");
        self.variable = parameters.is_some();
        self.kind = kind(self.component, container);
        (self.inputs, self.outputs) = if self.kind == ObjectKind::Parameter {
            let port = Port::read(container, PortPlace::Own, None);
            let output = port.as_output();
            (vec![port], vec![output])
        } else {
            (ports(container, parameters, Side::Input), ports(container, parameters, Side::Output))
        };
        self.principal = container.i32("PrincipalIndex").and_then(|index| usize::try_from(index).ok());
    }
}

fn kind(component: Uuid, container: &Chunk) -> ObjectKind {
    match component {
        ids::GROUP => return ObjectKind::Annotation(Annotation::Group),
        ids::SCRIBBLE => return ObjectKind::Annotation(Annotation::Scribble),
        ids::SKETCH => return ObjectKind::Annotation(Annotation::Sketch),
        _ => {}
    }
    let ports = ["param_input", "param_output", "ParameterData"];
    let has_ports = container.chunks.iter().any(|chunk| ports.contains(&chunk.name.as_str()));
    // A trigger has neither ports nor sources of its own.
    let parameter = ["SourceCount", "Source", "Optional"];
    let has_sources = container.items.iter().any(|item| parameter.contains(&item.name.as_str()));
    if !has_ports && (has_sources || container.child("PersistentData").is_some()) {
        ObjectKind::Parameter
    } else {
        ObjectKind::Component
    }
}

fn ports(container: &Chunk, parameters: Option<&Chunk>, side: Side) -> Vec<Port> {
    let fixed = numbered(container, side.fixed())
        .into_iter()
        .map(|(at, k, chunk)| Port { at, ..Port::read(chunk, PortPlace::Fixed(side, k), None) });
    let variable = parameters.into_iter().flat_map(|parameters| {
        let types: HashMap<i32, _> = parameters.list(side.type_id()).into_iter().collect();
        numbered(parameters, side.variable()).into_iter().map(move |(at, k, chunk)| {
            let type_id = types.get(&k).and_then(|value| value.as_guid());
            Port { at, ..Port::read(chunk, PortPlace::Variable(side, k), type_id) }
        })
    });
    fixed.chain(variable).collect()
}

/// The chunks of a name with their position and index, by rising index.
fn numbered<'a>(parent: &'a Chunk, name: &str) -> Vec<(usize, i32, &'a Chunk)> {
    let chunks = parent.chunks.iter().enumerate().filter(|(_, chunk)| chunk.name == name);
    let mut numbered: Vec<_> =
        chunks.filter_map(|(at, chunk)| chunk.index.map(|index| (at, index, chunk))).collect();
    numbered.sort_by_key(|(_, index, _)| *index);
    numbered
}
