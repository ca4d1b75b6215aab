//! What the text says, before anybody asks whether such components exist.

use uuid::Uuid;

use crate::archive::{Chunk, ItemValue};

/// A place in the text, in bytes.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default)]
pub(super) struct Span {
    pub(super) at: usize,
    pub(super) len: usize,
}

/// A name as it is written.
#[derive(Debug, Clone, PartialEq, Default)]
pub(super) struct Name {
    pub(super) text: String,
    pub(super) quoted: bool,
    /// The number behind `'`, of labels only.
    pub(super) suffix: Option<u32>,
    pub(super) span: Span,
}

/// A document: a file, or the inside of a cluster.
#[derive(Debug, Clone, Default)]
pub(super) struct Module {
    pub(super) units: Option<Name>,
    pub(super) title: Option<String>,
    pub(super) about: Option<String>,
    pub(super) entries: Vec<Entry>,
    pub(super) layout: Vec<Place>,
    pub(super) ids: Vec<Ids>,
    pub(super) details: Vec<(Name, Vec<Edit>)>,
    pub(super) data: Vec<(u32, Vec<u8>)>,
    pub(super) file: Vec<Edit>,
}

#[derive(Debug, Clone)]
pub(super) enum Entry {
    Object(Statement),
    Group(Group),
}

/// `label = Component(inputs) flags -> outputs { settings } inside { … }`.
#[derive(Debug, Clone, Default)]
pub(super) struct Statement {
    pub(super) label: Option<Name>,
    pub(super) call: Call,
    pub(super) flags: Flags,
    pub(super) outputs: Option<Vec<Output>>,
    pub(super) settings: Vec<Edit>,
    pub(super) inside: Option<Box<Module>>,
}

#[derive(Debug, Clone, Default)]
pub(super) struct Group {
    pub(super) label: Name,
    pub(super) attributes: Vec<Argument>,
    pub(super) members: Vec<Target>,
}

#[derive(Debug, Clone, Copy, PartialEq, Eq, Default)]
pub(super) struct Flags {
    pub(super) disabled: bool,
    pub(super) hidden: bool,
    /// A floating parameter, where a component has the same name or nobody knows.
    pub(super) parameter: bool,
    /// Ports can be added and removed, where nobody knows.
    pub(super) variable: bool,
}

/// A component with its inputs.
#[derive(Debug, Clone, Default)]
pub(super) struct Call {
    pub(super) name: Name,
    pub(super) guid: Option<Uuid>,
    /// It has the ports that are written and no others.
    pub(super) exact: bool,
    pub(super) arguments: Vec<Argument>,
    pub(super) span: Span,
}

#[derive(Debug, Clone, Default)]
pub(super) struct Argument {
    pub(super) name: Option<Name>,
    /// `"name": expression`, an item of a Value List, and whether it is chosen.
    pub(super) choice: Option<(String, Lit, bool)>,
    pub(super) given: Given,
    pub(super) span: Span,
}

/// What an input has.
#[derive(Debug, Clone, Default)]
pub(super) struct Given {
    pub(super) wires: Vec<Wire>,
    pub(super) values: Values,
    pub(super) modifiers: Vec<Modifier>,
}

/// The values kept in an input.
#[derive(Debug, Clone, Default)]
pub(super) enum Values {
    /// Those that the component begins with.
    #[default]
    Default,
    /// `none`.
    None,
    /// One.
    One(Lit),
    /// A tree.
    Tree(Vec<(Vec<i32>, Vec<Lit>)>),
}

#[derive(Debug, Clone)]
pub(super) struct Wire {
    pub(super) target: Target,
    pub(super) port: Option<Name>,
    pub(super) span: Span,
}

/// What a wire or a group refers to.
#[derive(Debug, Clone)]
pub(super) enum Target {
    Label(Name),
    Guid(Uuid),
    Call(Box<Call>),
}

/// A value.
#[derive(Debug, Clone)]
pub(super) struct Lit {
    pub(super) kind: LitKind,
    pub(super) span: Span,
}

#[derive(Debug, Clone)]
pub(super) enum LitKind {
    /// A number, and how many digits stand after its point; an exponent counts as a point without digits.
    Number(f64, Option<u32>),
    Boolean(bool),
    Null,
    Text(String),
    /// Two numbers, and the most digits behind their points.
    Range(f64, f64, u32),
    /// `(1, 2, 3)`.
    Point([f64; 3]),
    Path(Vec<i32>),
    Guid(Uuid),
    Data(u32),
    /// `plane(…)`.
    Made(String, Vec<(Option<String>, Lit)>),
}

#[derive(Debug, Clone, PartialEq)]
pub(super) struct Modifier {
    pub(super) kind: ModifierKind,
    pub(super) span: Span,
}

#[derive(Debug, Clone, PartialEq)]
pub(super) enum ModifierKind {
    Flatten,
    Graft,
    Simplify,
    Reverse,
    Reparameterize,
    Unitize,
    Invert,
    Degrees,
    Faint,
    Wireless,
    Hidden,
    Expression(String),
}

impl ModifierKind {
    /// The words for all but expressions, in the order they are written in.
    pub(super) const WORDS: [(&'static str, Self); 11] = [
        ("reparameterize", Self::Reparameterize),
        ("unitize", Self::Unitize),
        ("invert", Self::Invert),
        ("degrees", Self::Degrees),
        ("simplify", Self::Simplify),
        ("flatten", Self::Flatten),
        ("graft", Self::Graft),
        ("reverse", Self::Reverse),
        ("faint", Self::Faint),
        ("wireless", Self::Wireless),
        ("hidden", Self::Hidden),
    ];

    /// The archive's name for it and its value.
    pub(super) fn item(&self) -> (&'static str, ItemValue) {
        match self {
            Self::Flatten => ("Mapping", 1.into()),
            Self::Graft => ("Mapping", 2.into()),
            Self::Simplify => ("SimplifyData", true.into()),
            Self::Reverse => ("ReverseData", true.into()),
            Self::Reparameterize => ("Reparameterize", true.into()),
            Self::Unitize => ("Unitize", true.into()),
            Self::Invert => ("InvertBooleans", true.into()),
            Self::Degrees => ("UseDegrees", true.into()),
            Self::Faint => ("WireDisplay", 1.into()),
            Self::Wireless => ("WireDisplay", 2.into()),
            Self::Hidden => ("Hidden", true.into()),
            Self::Expression(text) => ("InternalExpression", text.as_str().into()),
        }
    }

    /// The modifiers that a port's chunk holds, in the order they are written in.
    pub(super) fn read(port: &Chunk) -> Vec<Self> {
        let text = port.str("InternalExpression").map(|text| Self::Expression(text.to_owned()));
        let words = Self::WORDS.into_iter().map(|(_, kind)| kind).filter(|kind| {
            let (name, value) = kind.item();
            port.item(name) == Some(&value)
        });
        text.into_iter().chain(words).collect()
    }
}

/// An output that is named, with what is done to its data.
#[derive(Debug, Clone)]
pub(super) struct Output {
    pub(super) name: Name,
    pub(super) modifiers: Vec<Modifier>,
}

/// Where an object stands on the canvas.
#[derive(Debug, Clone)]
pub(super) struct Place {
    pub(super) label: Name,
    pub(super) pivot: Option<[f32; 2]>,
    pub(super) bounds: Option<[f32; 4]>,
}

/// The ids of an object and its ports; those that are derived from the label are left out.
#[derive(Debug, Clone)]
pub(super) struct Ids {
    pub(super) label: Name,
    pub(super) own: Option<Uuid>,
    pub(super) inputs: Vec<Option<Uuid>>,
    pub(super) outputs: Vec<Option<Uuid>>,
}

/// A change to the tree of an archive.
#[derive(Debug, Clone, PartialEq)]
pub(super) struct Edit {
    /// Whether the path begins at the object's chunk; else at its container.
    pub(super) top: bool,
    pub(super) path: Vec<Step>,
    pub(super) change: Change,
    pub(super) span: Span,
}

// A span is where something stands, not what it is.
impl Edit {
    pub(super) fn new(path: Vec<Step>, change: Change) -> Self {
        Self { top: false, path, change, span: Span::default() }
    }
}

/// A step of an [`Edit`]'s path: the name and index of a chunk or item, and which of several of the same.
#[derive(Debug, Clone, PartialEq, Eq)]
pub(super) struct Step {
    pub(super) name: String,
    pub(super) index: Option<i32>,
    pub(super) nth: usize,
}

#[derive(Debug, Clone, PartialEq)]
pub(super) enum Change {
    /// The item at the path gets a value.
    Set(RawValue),
    /// There shall be a chunk at the path.
    Add,
    /// The item at the path is taken out.
    Remove,
    /// The chunk at the path is taken out.
    RemoveChunk,
}

/// A value of the archive; bytes may stand in the data block.
#[derive(Debug, Clone, PartialEq)]
pub(super) enum RawValue {
    Value(ItemValue),
    Bytes(u32),
    Bitmap(u32),
}
