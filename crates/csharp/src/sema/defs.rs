//! What is declared: types, methods, fields, properties.

use std::collections::HashMap;
use std::sync::Arc;

use super::types::Ty;
use crate::bound::Const;
use crate::source::Pos;
use crate::syntax::ast::{self, Name, Passing, TypeKind};

macro_rules! id {
    ($name:ident, $what:literal) => {
        #[doc = $what]
        #[derive(Debug, Clone, Copy, PartialEq, Eq, Hash, PartialOrd, Ord)]
        pub struct $name(pub u32);
    };
}
id!(DefId, "A declared type.");
id!(MethodId, "A declared method.");
id!(FieldId, "A declared field.");
id!(PropId, "A declared property.");
id!(ParamId, "A declared type parameter.");

/// Predefined value types with operators of their own.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash, PartialOrd, Ord)]
#[allow(missing_docs, reason = "their names say it")]
pub enum Prim {
    Bool,
    Char,
    I8,
    U8,
    I16,
    U16,
    I32,
    U32,
    I64,
    U64,
    F32,
    F64,
    Decimal,
}

impl Prim {
    /// The type of `System` with this name.
    pub fn by_name(name: &str) -> Option<Self> {
        Some(match name {
            "Boolean" => Self::Bool,
            "Char" => Self::Char,
            "SByte" => Self::I8,
            "Byte" => Self::U8,
            "Int16" => Self::I16,
            "UInt16" => Self::U16,
            "Int32" => Self::I32,
            "UInt32" => Self::U32,
            "Int64" => Self::I64,
            "UInt64" => Self::U64,
            "Single" => Self::F32,
            "Double" => Self::F64,
            "Decimal" => Self::Decimal,
            _ => return None,
        })
    }

    /// Whether it is a whole number.
    pub fn is_integral(self) -> bool {
        !matches!(self, Self::Bool | Self::F32 | Self::F64 | Self::Decimal)
    }

    /// Whether it is a number.
    pub fn is_numeric(self) -> bool {
        self != Self::Bool
    }

    /// The least and the greatest value of a whole number.
    pub fn range(self) -> (i128, i128) {
        match self {
            Self::I8 => (i8::MIN.into(), i8::MAX.into()),
            Self::U8 => (0, u8::MAX.into()),
            Self::I16 => (i16::MIN.into(), i16::MAX.into()),
            Self::U16 | Self::Char => (0, u16::MAX.into()),
            Self::I32 => (i32::MIN.into(), i32::MAX.into()),
            Self::U32 => (0, u32::MAX.into()),
            Self::I64 => (i64::MIN.into(), i64::MAX.into()),
            Self::U64 => (0, u64::MAX.into()),
            _ => (0, 0),
        }
    }
}

/// Where names are looked up in a file or namespace.
#[derive(Debug, Clone, Default)]
pub struct UsingScope {
    /// The namespace.
    pub namespace: String,
    /// Namespaces that are used.
    pub namespaces: Vec<String>,
    /// Names for other types.
    pub aliases: Vec<(Name, ast::TypeRef)>,
    /// Types whose static members are used.
    pub statics: Vec<ast::TypeRef>,
    /// The scope around it.
    pub outer: Option<Arc<UsingScope>>,
}

/// A type parameter.
#[derive(Debug, Clone)]
pub struct TypeParamDef {
    /// Its name.
    pub name: Name,
    /// Types that it must convert to.
    pub bounds: Vec<Ty>,
    /// `class`
    pub class: bool,
    /// `struct`
    pub structure: bool,
    /// `new()`
    pub creatable: bool,
}

/// A member by its kind.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash)]
pub enum Member {
    /// A method.
    Method(MethodId),
    /// A field.
    Field(FieldId),
    /// A property or indexer.
    Prop(PropId),
    /// A type.
    Type(DefId),
}

/// Who may use a member.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Access {
    /// Everybody.
    Public,
    /// The type and what derives from it.
    Protected,
    /// The type.
    Private,
}

/// A declared type.
#[derive(Debug, Clone)]
pub struct TypeDef {
    /// The name without namespace.
    pub name: Name,
    /// The namespace.
    pub namespace: Name,
    /// The type around it.
    pub outer: Option<DefId>,
    /// The kind.
    pub kind: TypeKind,
    /// Type parameters, those of types around it first.
    pub params: Vec<ParamId>,
    /// `static`
    pub is_static: bool,
    /// `abstract`
    pub is_abstract: bool,
    /// `sealed`
    pub is_sealed: bool,
    /// Whether the library or the host declares it.
    pub library: bool,
    /// The predefined type that it is.
    pub prim: Option<Prim>,
    /// The base class; the type below an enum.
    pub base: Option<Ty>,
    /// Interfaces as declared.
    pub interfaces: Vec<Ty>,
    /// Members by name.
    pub members: HashMap<Name, Vec<Member>>,
    /// Fields of an instance in order, without those of base classes.
    pub fields: Vec<FieldId>,
    /// Static fields in order.
    pub statics: Vec<FieldId>,
    /// All methods in order.
    pub methods: Vec<MethodId>,
    /// All properties in order.
    pub props: Vec<PropId>,
    /// The method of a delegate.
    pub invoke: Option<MethodId>,
    /// How it was written.
    pub decl: Option<Arc<ast::TypeDecl>>,
    /// Where its names are looked up.
    pub scope: Arc<UsingScope>,
    /// The place.
    pub pos: Pos,
    /// Whether instances are made by the library or the host, and not of fields.
    pub native: bool,
}

/// A parameter.
#[derive(Debug, Clone)]
pub struct ParamDef {
    /// The name.
    pub name: Name,
    /// The type.
    pub ty: Ty,
    /// How it is handed over.
    pub passing: Passing,
    /// `params`
    pub rest: bool,
    /// The value when it is left out.
    pub default: Option<Arc<ast::Expr>>,
}

impl ParamDef {
    /// Whether it takes a value, and no reference to a variable.
    pub fn is_value(&self) -> bool {
        self.passing == Passing::Value
    }
}

/// What a method does.
#[derive(Debug, Clone)]
pub enum Body {
    /// Nothing: abstract.
    None,
    /// What the library or host does under this key.
    Extern(Name),
    /// What is written.
    Written(Arc<ast::Method>),
    /// The accessor of a property.
    Accessor(Arc<ast::Property>, bool),
    /// A constructor without a declaration.
    Default,
    /// A delegate's call.
    Invoke,
    /// An accessor that reads or writes the field of an automatic property.
    Auto(FieldId, bool),
}

/// A method.
#[derive(Debug, Clone)]
pub struct MethodDef {
    /// The name.
    pub name: Name,
    /// The type that declares it.
    pub owner: DefId,
    /// Parameters.
    pub params: Vec<ParamDef>,
    /// What it gives.
    pub ret: Ty,
    /// Whether it gives a reference to a variable.
    pub by_ref: bool,
    /// Type parameters.
    pub type_params: Vec<ParamId>,
    /// `static`
    pub is_static: bool,
    /// Whether it may be overridden.
    pub is_virtual: bool,
    /// `override`
    pub is_override: bool,
    /// `abstract`
    pub is_abstract: bool,
    /// Whether the first parameter is the receiver.
    pub extends: bool,
    /// Who may use it.
    pub access: Access,
    /// The interface of an explicit implementation.
    pub explicit: Option<Ty>,
    /// What it does.
    pub body: Body,
    /// Whether `yield` stands in it.
    pub iterator: bool,
    /// The place.
    pub pos: Pos,
}

/// A field.
#[derive(Debug, Clone)]
pub struct FieldDef {
    /// The name.
    pub name: Name,
    /// The type that declares it.
    pub owner: DefId,
    /// The type.
    pub ty: Ty,
    /// `static` or `const`
    pub is_static: bool,
    /// `const`, and members of enums
    pub constant: bool,
    /// `readonly`
    pub readonly: bool,
    /// Who may use it.
    pub access: Access,
    /// The first value.
    pub value: Option<Arc<ast::Expr>>,
    /// The member of an enum before this one.
    pub previous: Option<FieldId>,
    /// The value of a constant, once it is known.
    pub known: Known,
    /// Its place among the fields of its type.
    pub index: u32,
    /// The place.
    pub pos: Pos,
}

/// How far a constant has been worked out.
#[derive(Debug, Clone)]
pub enum Known {
    /// Not yet.
    No,
    /// Just now.
    Busy,
    /// It is known.
    Yes(Const),
}

/// A property or indexer.
#[derive(Debug, Clone)]
pub struct PropDef {
    /// The name.
    pub name: Name,
    /// The type that declares it.
    pub owner: DefId,
    /// The type.
    pub ty: Ty,
    /// Parameters of an indexer.
    pub params: Vec<ParamDef>,
    /// `static`
    pub is_static: bool,
    /// `get`
    pub getter: Option<MethodId>,
    /// `set`
    pub setter: Option<MethodId>,
    /// The field of an automatic property.
    pub field: Option<FieldId>,
    /// Who may use it.
    pub access: Access,
    /// The interface of an explicit implementation.
    pub explicit: Option<Ty>,
    /// Whether it is an event.
    pub is_event: bool,
    /// Whether it replaces one of a base class.
    pub is_override: bool,
}
