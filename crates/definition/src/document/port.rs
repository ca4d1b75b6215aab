use uuid::Uuid;

use crate::archive::Chunk;

/// An input or output of an object, or a floating parameter as both.
#[derive(Debug, Clone, PartialEq)]
pub struct Port {
    /// The id that wires and the outside use. A floating parameter's is the object's own.
    pub id: Uuid,
    /// The name in full.
    pub name: String,
    /// The short name that the canvas shows.
    pub nickname: String,
    /// What it takes or gives, in the file's words.
    pub description: String,
    /// The outputs it is wired to, in wire order.
    pub sources: Vec<Uuid>,
    /// How much of a tree the object takes at once.
    pub access: Access,
    /// Whether the object runs when no data comes.
    pub optional: bool,
    /// The parameter type; the file names it only where the signature is variable.
    pub type_id: Option<Uuid>,
    /// A script input's type hint.
    pub type_hint: Option<Uuid>,
    /// What is done to the data on the way.
    pub modifiers: Modifiers,
    /// Whether values are kept in the port itself; [`Object::persistent`](super::Object::persistent) reads them.
    pub has_persistent: bool,
    /// Whether its preview is off.
    pub hidden: bool,
    /// How its wires are drawn.
    pub wire_display: WireDisplay,
    /// Where in the object's container the port stands.
    pub place: PortPlace,
    /// The position of its chunk when it was read, to find it without a search.
    pub(super) at: usize,
}

/// How much of a tree an object takes at once.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default)]
pub enum Access {
    /// One item.
    #[default]
    Item,
    /// A whole list.
    List,
    /// The whole tree.
    Tree,
}

/// How wires into a port are drawn.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default)]
pub enum WireDisplay {
    /// In full.
    #[default]
    Normal,
    /// Thin.
    Faint,
    /// Only while selected.
    Hidden,
}

/// What a port does to the branches of its data.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default)]
pub enum Mapping {
    /// Nothing.
    #[default]
    None,
    /// All items into one list.
    Flatten,
    /// Each item into a branch of its own.
    Graft,
}

/// What a port does to its data after collecting it.
#[derive(Debug, Clone, PartialEq, Eq, Default)]
pub struct Modifiers {
    /// Flatten or graft.
    pub mapping: Mapping,
    /// Each list back to front.
    pub reverse: bool,
    /// Shortest paths.
    pub simplify: bool,
    /// An expression in `x`, applied to each item.
    pub expression: Option<String>,
    /// Curve and surface domains become 0 to 1.
    pub reparameterize: bool,
    /// Vectors get length 1.
    pub unitize: bool,
    /// Booleans are inverted.
    pub invert: bool,
    /// Angles are given in degrees.
    pub degrees: bool,
}

/// Where in an object's container a port stands.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum PortPlace {
    /// The container itself: a floating parameter.
    Own,
    /// `param_input` or `param_output` with this index.
    Fixed(Side, i32),
    /// `InputParam` or `OutputParam` with this index inside `ParameterData`.
    Variable(Side, i32),
}

/// Which side of an object a port is on.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash)]
pub enum Side {
    /// Where data enters.
    Input,
    /// Where data leaves.
    Output,
}

impl Side {
    pub(super) fn fixed(self) -> &'static str {
        match self {
            Self::Input => "param_input",
            Self::Output => "param_output",
        }
    }

    pub(super) fn variable(self) -> &'static str {
        match self {
            Self::Input => "InputParam",
            Self::Output => "OutputParam",
        }
    }

    pub(super) fn type_id(self) -> &'static str {
        match self {
            Self::Input => "InputId",
            Self::Output => "OutputId",
        }
    }
}

impl PortPlace {
    /// The port's chunk in its object's container.
    pub fn find(self, container: &Chunk) -> Option<&Chunk> {
        match self {
            Self::Own => Some(container),
            Self::Fixed(side, k) => container.child_at(side.fixed(), k),
            Self::Variable(side, k) => container.child("ParameterData")?.child_at(side.variable(), k),
        }
    }

    /// As [`find`](Self::find), to be changed.
    pub fn find_mut(self, container: &mut Chunk) -> Option<&mut Chunk> {
        match self {
            Self::Own => Some(container),
            Self::Fixed(side, k) => container.child_at_mut(side.fixed(), k),
            Self::Variable(side, k) => container.child_mut("ParameterData")?.child_at_mut(side.variable(), k),
        }
    }
}

impl Port {
    /// Reads a port from its chunk.
    pub(super) fn read(chunk: &Chunk, place: PortPlace, type_id: Option<Uuid>) -> Self {
        let text = |name| chunk.str(name).unwrap_or_default().to_owned();
        let flag = |name| chunk.bool(name).unwrap_or(false);
        let mut sources: Vec<Uuid> =
            chunk.list("Source").into_iter().filter_map(|(_, value)| value.as_guid()).collect();
        // Grasshopper reads as many as the count says.
        if let Some(count) = chunk.i32("SourceCount") {
            sources.truncate(usize::try_from(count).unwrap_or(0));
        }
        let expression = chunk.str("InternalExpression").or_else(|| chunk.str("ParamExpression"));
        Self {
            id: chunk.guid("InstanceGuid").unwrap_or_default(),
            name: text("Name"),
            nickname: text("NickName"),
            description: text("Description"),
            sources,
            access: match chunk.i32("Access").or_else(|| chunk.i32("ScriptParamAccess")) {
                Some(1) => Access::List,
                Some(2) => Access::Tree,
                _ => Access::Item,
            },
            optional: flag("Optional"),
            type_id,
            type_hint: chunk.guid("TypeHintID"),
            modifiers: Modifiers {
                mapping: match chunk.i32("Mapping") {
                    Some(1) => Mapping::Flatten,
                    Some(2) => Mapping::Graft,
                    _ => Mapping::None,
                },
                reverse: flag("ReverseData"),
                simplify: flag("SimplifyData"),
                expression: expression.filter(|text| !text.trim().is_empty()).map(str::to_owned),
                reparameterize: flag("Reparameterize"),
                unitize: flag("Unitize"),
                // Grasshopper 0.8 wrote the second name.
                invert: flag("InvertBooleans") || flag("NegateStream"),
                degrees: flag("UseDegrees"),
            },
            has_persistent: chunk.child("PersistentData").is_some()
                || chunk.i32("PersistentCount").is_some_and(|count| count > 0),
            hidden: flag("Hidden"),
            wire_display: match chunk.i32("WireDisplay") {
                Some(1) => WireDisplay::Faint,
                Some(2) => WireDisplay::Hidden,
                _ => WireDisplay::Normal,
            },
            place,
            at: 0,
        }
    }

    /// The port's chunk in its object's container.
    pub fn chunk<'a>(&self, container: &'a Chunk) -> Option<&'a Chunk> {
        let (parent, name, k) = match self.place {
            PortPlace::Own => return Some(container),
            PortPlace::Fixed(side, k) => (container, side.fixed(), k),
            PortPlace::Variable(side, k) => (container.child("ParameterData")?, side.variable(), k),
        };
        let hinted = parent.chunks.get(self.at).filter(|chunk| chunk.index == Some(k) && chunk.name == name);
        hinted.or_else(|| parent.child_at(name, k))
    }

    /// The same port as it faces the other way: what a floating parameter gives, after all its modifiers.
    pub(super) fn as_output(&self) -> Self {
        Self { sources: Vec::new(), modifiers: Modifiers::default(), has_persistent: false, ..self.clone() }
    }
}
