//! What names mean: types, members, conversions.

mod bases;
mod check;
mod constraints;
mod convert;
mod declare;
mod defs;
mod display;
mod inherit;
mod members;
mod resolve;
mod rules;
mod types;

use std::collections::HashMap;
use std::sync::Arc;

pub use convert::{Conversion, UserConversion};
pub use defs::*;
pub use resolve::{NameScope, Resolved};
pub use types::{Kind, Substitution, Ty, Types};

use crate::diagnostic::Fault;
use crate::syntax::ast::{Name, Passing, TypeKind};

/// The most types that one program may make.
pub const MAX_TYPES: usize = 200_000;
/// How deep type arguments may stand in one another.
pub const MAX_TYPE_DEPTH: usize = 24;

/// All that is declared.
#[derive(Debug, Clone, Default)]
pub struct Sema {
    /// Types.
    pub types: Types,
    /// Declared types.
    pub defs: Vec<TypeDef>,
    /// Methods.
    pub methods: Vec<MethodDef>,
    /// Fields.
    pub fields: Vec<FieldDef>,
    /// Properties.
    pub props: Vec<PropDef>,
    /// Type parameters.
    pub params: Vec<TypeParamDef>,
    /// Types by namespace and name.
    pub by_name: HashMap<(String, Name), Vec<DefId>>,
    /// Names of namespaces, those around others too.
    pub namespaces: std::collections::HashSet<String>,
    /// Extension methods by name.
    pub extensions: HashMap<Name, Vec<MethodId>>,
    /// Anonymous types by the names of their members.
    pub anonymous: HashMap<Vec<Name>, DefId>,
    /// Types that the language knows.
    pub known: Known_,
    /// How many types there were before those that are being declared.
    pub declared_before: usize,
    /// Faults so far.
    pub faults: Vec<Fault>,
    /// Whether the program was written in VB: names are found in any case, and more.
    pub vb: bool,
    /// Types with arguments that the program has written, and where: their arguments are looked at in the end.
    noted: Vec<(crate::source::Pos, Ty)>,
}

/// Types that the language knows.
#[derive(Debug, Clone, Copy)]
#[allow(missing_docs, reason = "their names say it")]
pub struct Known_ {
    pub object: Ty,
    pub string: Ty,
    pub bool: Ty,
    pub char: Ty,
    pub int: Ty,
    pub uint: Ty,
    pub long: Ty,
    pub ulong: Ty,
    pub float: Ty,
    pub double: Ty,
    pub decimal: Ty,
    pub array: Ty,
    pub value_type: Ty,
    pub enumeration: Ty,
    pub delegate: Ty,
    pub exception: Ty,
    pub type_: Ty,
    pub nullable: DefId,
    pub array_impl: DefId,
    pub enumerable: DefId,
    pub enumerator: DefId,
    pub plain_enumerable: Ty,
    pub plain_enumerator: Ty,
    pub disposable: Ty,
    pub iterator: DefId,
}

impl Default for Known_ {
    fn default() -> Self {
        let (e, d) = (Ty::ERROR, DefId(0));
        Self {
            object: e,
            string: e,
            bool: e,
            char: e,
            int: e,
            uint: e,
            long: e,
            ulong: e,
            float: e,
            double: e,
            decimal: e,
            array: e,
            value_type: e,
            enumeration: e,
            delegate: e,
            exception: e,
            type_: e,
            nullable: d,
            array_impl: d,
            enumerable: d,
            enumerator: d,
            plain_enumerable: e,
            plain_enumerator: e,
            disposable: e,
            iterator: d,
        }
    }
}

impl Sema {
    /// Adds a fault.
    pub fn fault(&mut self, pos: u32, code: u16, message: impl Into<String>) {
        if self.faults.len() < 200 {
            self.faults.push(Fault::new(pos, code, message));
        }
    }

    /// A declared type.
    pub fn def(&self, id: DefId) -> &TypeDef {
        &self.defs[id.0 as usize]
    }

    /// A method.
    pub fn method(&self, id: MethodId) -> &MethodDef {
        &self.methods[id.0 as usize]
    }

    /// A field.
    pub fn field(&self, id: FieldId) -> &FieldDef {
        &self.fields[id.0 as usize]
    }

    /// A property.
    pub fn prop(&self, id: PropId) -> &PropDef {
        &self.props[id.0 as usize]
    }

    /// A type parameter.
    pub fn param(&self, id: ParamId) -> &TypeParamDef {
        &self.params[id.0 as usize]
    }

    /// The type that a declaration makes with arguments.
    pub fn named(&mut self, def: DefId, args: &[Ty]) -> Ty {
        self.types.intern(Kind::Named(def, args.into()))
    }

    /// A declared type with its own parameters as arguments.
    pub fn open(&mut self, def: DefId) -> Ty {
        let params = self.def(def).params.clone();
        let args: Vec<_> = params.into_iter().map(|param| self.types.intern(Kind::Param(param))).collect();
        self.named(def, &args)
    }

    /// An array.
    pub fn array(&mut self, element: Ty, rank: u8) -> Ty {
        self.types.intern(Kind::Array(element, rank))
    }

    /// `T?`
    pub fn nullable(&mut self, inner: Ty) -> Ty {
        let def = self.known.nullable;
        self.named(def, &[inner])
    }

    /// The declaration of a type.
    pub fn def_of(&self, ty: Ty) -> Option<DefId> {
        self.types.named(ty).map(|(def, _)| def)
    }

    /// The arguments of a type.
    pub fn args_of(&self, ty: Ty) -> Vec<Ty> {
        self.types.named(ty).map(|(_, args)| args.to_vec()).unwrap_or_default()
    }

    /// The kind of a declared type.
    pub fn type_kind(&self, ty: Ty) -> Option<TypeKind> {
        self.def_of(ty).map(|def| self.def(def).kind)
    }

    /// The predefined type that a type is.
    pub fn prim(&self, ty: Ty) -> Option<Prim> {
        self.def_of(ty).and_then(|def| self.def(def).prim)
    }

    /// The predefined type below an enum, or that a type is.
    pub fn underlying(&self, ty: Ty) -> Option<Prim> {
        if self.is_enum(ty) { self.enum_prim(ty) } else { self.prim(ty) }
    }

    /// Whether a type is an enum.
    pub fn is_enum(&self, ty: Ty) -> bool {
        self.type_kind(ty) == Some(TypeKind::Enum)
    }

    /// The predefined type below an enum.
    pub fn enum_prim(&self, ty: Ty) -> Option<Prim> {
        let def = self.def_of(ty)?;
        Some(self.def(def).base.and_then(|base| self.prim(base)).unwrap_or(Prim::I32))
    }

    /// What `T?` is of.
    pub fn nullable_of(&self, ty: Ty) -> Option<Ty> {
        let (def, args) = self.types.named(ty)?;
        if def == self.known.nullable { args.first().copied() } else { None }
    }

    /// Whether values are copied. Type parameters are when they say `struct`.
    pub fn is_value_type(&self, ty: Ty) -> bool {
        match self.types.kind(ty) {
            Kind::Named(..) | Kind::Tuple(..) => {
                matches!(self.type_kind(ty), Some(TypeKind::Struct | TypeKind::Enum))
            }
            Kind::Param(param) => self.param(*param).structure,
            _ => false,
        }
    }

    /// Whether values are references.
    pub fn is_reference(&self, ty: Ty) -> bool {
        match self.types.kind(ty) {
            Kind::Special(s) => *s == Ty::NULL.0 as u8 || *s == Ty::DYNAMIC.0 as u8,
            Kind::Array(..) => true,
            Kind::Named(..) | Kind::Tuple(..) => !self.is_value_type(ty),
            Kind::Param(param) => {
                let param = self.param(*param);
                param.class || param.bounds.iter().any(|b| self.type_kind(*b) == Some(TypeKind::Class))
            }
        }
    }

    /// Whether a type is a struct made of fields, which is copied when it is handed over.
    pub fn is_struct(&self, ty: Ty) -> bool {
        let Some(def) = self.def_of(ty) else { return false };
        let def = self.def(def);
        def.kind == TypeKind::Struct && def.prim.is_none() && def.name.as_ref() != "Nullable"
    }

    /// Whether a type parameter.
    pub fn is_param(&self, ty: Ty) -> bool {
        matches!(self.types.kind(ty), Kind::Param(_))
    }

    /// The invoke method of a delegate type, with its signature for the arguments.
    pub fn invoke_of(&mut self, ty: Ty) -> Option<(Vec<(Passing, Ty)>, Ty)> {
        let (def, args) = self.types.named(ty)?;
        let (def, args) = (def, args.clone());
        let invoke = self.def(def).invoke?;
        let by = Substitution::of(&self.def(def).params, &args);
        let method = self.method(invoke);
        let (params, ret) = (method.params.iter().map(|p| (p.passing, p.ty)).collect::<Vec<_>>(), method.ret);
        let params = params.into_iter().map(|(p, ty)| (p, self.types.substitute(ty, &by))).collect();
        Some((params, self.types.substitute(ret, &by)))
    }

    /// The substitution that a type makes for the parameters of its declaration.
    pub fn substitution(&self, ty: Ty) -> Substitution {
        match self.types.named(ty) {
            Some((def, args)) => Substitution::of(&self.def(def).params, args),
            None => Substitution::default(),
        }
    }

    /// Looks up a type of the library by namespace and name.
    pub fn library(&self, namespace: &str, name: &str, arity: usize) -> Option<DefId> {
        let list = self.by_name.get(&(namespace.to_owned(), Name::from(name)))?;
        list.iter().copied().find(|def| self.def(*def).params.len() == arity)
    }

    /// An empty scope.
    pub fn no_scope() -> Arc<UsingScope> {
        Arc::new(UsingScope::default())
    }
}

impl Sema {
    /// The type of a declaration without parameters, if it was ever named.
    pub fn types_of(&self, def: DefId) -> Option<Ty> {
        self.types.find(&Kind::Named(def, Vec::new().into()))
    }
}
