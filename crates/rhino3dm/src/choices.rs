//! The choices that attributes offer, and their numbers in archives.

use uuid::Uuid;

use crate::Result;
use crate::chunk::Writer;
use crate::places::Numbers;

/// How an object takes part in a model.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default)]
pub enum ObjectMode {
    /// Seen and selectable.
    #[default]
    Normal,
    /// Hidden.
    Hidden,
    /// Seen but not selectable.
    Locked,
    /// Part of a block definition.
    InDefinition,
}

impl ObjectMode {
    pub(crate) fn from_code(code: u8) -> Self {
        // The upper four bits are a display mode of old, which nothing shows.
        match code & 15 {
            1 => Self::Hidden,
            2 => Self::Locked,
            3 => Self::InDefinition,
            _ => Self::Normal,
        }
    }

    pub(crate) fn code(self) -> u8 {
        match self {
            Self::Normal => 0,
            Self::Hidden => 1,
            Self::Locked => 2,
            Self::InDefinition => 3,
        }
    }
}

/// Where an object has a colour, linetype, material or plot setting from.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default)]
pub enum Source {
    /// Its layer.
    #[default]
    Layer,
    /// Itself.
    Object,
    /// Its material (of colours) or its colour on the screen (of colours in print).
    Display,
    /// The block reference it is shown in.
    Parent,
}

impl Source {
    pub(crate) fn from_code(code: u8) -> Self {
        match code {
            1 => Self::Object,
            2 => Self::Display,
            3 => Self::Parent,
            _ => Self::Layer,
        }
    }

    pub(crate) fn code(self) -> u8 {
        match self {
            Self::Layer => 0,
            Self::Object => 1,
            Self::Display => 2,
            Self::Parent => 3,
        }
    }
}

/// A linetype: one that every model has, or an entry of the table.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default)]
pub enum LinetypeChoice {
    /// A line without gaps.
    #[default]
    Continuous,
    /// That of the layer.
    ByLayer,
    /// That of the block reference.
    ByParent,
    /// Index into [`Model::linetypes`](crate::Model::linetypes).
    Entry(usize),
}

impl LinetypeChoice {
    pub(crate) fn from_number(number: i32) -> Self {
        match number {
            -2 => Self::ByLayer,
            -3 => Self::ByParent,
            number => usize::try_from(number).map_or(Self::Continuous, Self::Entry),
        }
    }

    /// A number of the archive made a place in the table.
    pub(crate) fn placed(self, numbers: &Numbers) -> Self {
        match self {
            Self::Entry(number) => numbers.find(number).map_or(Self::Continuous, Self::Entry),
            other => other,
        }
    }

    pub(crate) fn write(self, w: &mut Writer) -> Result<()> {
        match self {
            Self::Continuous => w.i32(-1),
            Self::ByLayer => w.i32(-2),
            Self::ByParent => w.i32(-3),
            Self::Entry(place) => w.count(place, "linetypes")?,
        }
        Ok(())
    }
}

/// Arrowheads on a curve.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default)]
#[allow(missing_docs, reason = "the names say it")]
pub struct Arrowheads {
    pub at_start: bool,
    pub at_end: bool,
}

const AT_START: u8 = 8;
const AT_END: u8 = 16;

impl Arrowheads {
    pub(crate) fn from_code(code: u8) -> Self {
        Self { at_start: code & AT_START != 0, at_end: code & AT_END != 0 }
    }

    pub(crate) fn code(self) -> u8 {
        (if self.at_start { AT_START } else { 0 }) | if self.at_end { AT_END } else { 0 }
    }
}

/// Where an object lies.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default)]
pub enum ActiveSpace {
    /// In the model.
    #[default]
    Model,
    /// On a page.
    Page,
    /// Elsewhere, by its number in archives.
    Other(u8),
}

impl ActiveSpace {
    pub(crate) fn from_code(code: u8) -> Self {
        match code {
            1 => Self::Model,
            2 => Self::Page,
            other => Self::Other(other),
        }
    }

    pub(crate) fn code(self) -> u8 {
        match self {
            Self::Model => 1,
            Self::Page => 2,
            Self::Other(code) => code,
        }
    }
}

/// Which clipping planes cut an object or the objects of a layer.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct Clipping {
    /// Whether none of them does.
    pub none: bool,
    /// Some of them.
    pub planes: Vec<Uuid>,
    /// Whether those are the ones that cut, not the ones that do not.
    pub planes_cut: bool,
}

impl Default for Clipping {
    fn default() -> Self {
        Self { none: false, planes: Vec::new(), planes_cut: true }
    }
}

/// Writes the place of an entry as its number, −1 for none.
pub(crate) fn write_place(place: Option<usize>, what: &str, w: &mut Writer) -> Result<()> {
    match place {
        Some(place) => w.count(place, what),
        None => {
            w.i32(-1);
            Ok(())
        }
    }
}
