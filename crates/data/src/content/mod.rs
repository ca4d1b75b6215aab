//! What a Rhino model holds beside plain geometry, as items of data: Grasshopper calls it content. And atoms, which
//! are geometry with attributes likewise.

mod atom;
mod attribute;
mod block;
mod filter;
mod object;
mod tables;
mod token;

pub use atom::Atom;
pub use block::{BlockDefinition, BlockInstance};
pub use filter::Filter;
pub use object::{ModelObject, Visibility};
pub use tables::{ModelLayer, ModelLinetype, ModelMaterial};
pub use token::{Keeper, Token};

use std::sync::Arc as Shared;

/// One item of a Rhino model, or a filter for such items.
#[derive(Debug, Clone, PartialEq)]
pub enum Content {
    /// Geometry with its attributes.
    Object(ModelObject),
    /// A block placed in space.
    Instance(BlockInstance),
    /// A block: objects under a name.
    Block(Shared<BlockDefinition>),
    /// A layer.
    Layer(Shared<ModelLayer>),
    /// A pattern of dashes and gaps.
    Linetype(Shared<ModelLinetype>),
    /// Which items pass.
    Filter(Filter),
    /// An atom of a molecule.
    Atom(Atom),
    /// An object of a script's own language.
    Token(Token),
}

impl Content {
    /// The name that messages use.
    pub const fn type_name(&self) -> &'static str {
        match self {
            Self::Object(_) => "Model Object",
            Self::Instance(_) => "Block Instance",
            Self::Block(_) => "Model Block Definition",
            Self::Layer(_) => "Model Layer",
            Self::Linetype(_) => "Model Linetype",
            Self::Filter(_) => "Content Filter",
            Self::Atom(_) => "Atom",
            Self::Token(_) => "Script Object",
        }
    }

    /// The path by which the model finds it: a layer's from the outermost in, else the name. None where it has none.
    pub fn path(&self) -> Option<&str> {
        let path = match self {
            Self::Object(object) => object.name.as_ref(),
            Self::Instance(_) | Self::Filter(_) | Self::Atom(_) | Self::Token(_) => return None,
            Self::Block(block) => block.name.as_ref(),
            Self::Layer(layer) => layer.path.as_ref(),
            Self::Linetype(linetype) => linetype.name.as_ref(),
        };
        Some(path).filter(|path| !path.is_empty())
    }
}

macro_rules! from {
    ($($type:ty, $variant:ident;)*) => {
        $(impl From<$type> for crate::Value {
            fn from(content: $type) -> Self {
                Self::Content(Shared::new(Content::$variant(content.into())))
            }
        })*
    };
}

from! {
    ModelObject, Object;
    BlockInstance, Instance;
    BlockDefinition, Block;
    Shared<BlockDefinition>, Block;
    ModelLayer, Layer;
    Shared<ModelLayer>, Layer;
    ModelLinetype, Linetype;
    Shared<ModelLinetype>, Linetype;
    Filter, Filter;
    Atom, Atom;
    Token, Token;
}
