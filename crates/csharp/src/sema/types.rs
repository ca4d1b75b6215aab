//! Types, each kept once: equal types have equal numbers.

use std::collections::HashMap;
use std::sync::Arc;

use super::defs::{DefId, ParamId};
use crate::syntax::ast::Name;

/// A type.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash, PartialOrd, Ord)]
pub struct Ty(pub u32);

impl Ty {
    /// What a fault left without a type; no further faults come of it.
    pub const ERROR: Self = Self(0);
    /// No value.
    pub const VOID: Self = Self(1);
    /// The type of `null`.
    pub const NULL: Self = Self(2);
    /// `dynamic`
    pub const DYNAMIC: Self = Self(3);
    /// A lambda, a group of methods or `default`, which has no type of its own.
    pub const NONE: Self = Self(4);
}

/// What a type is.
#[derive(Debug, Clone, PartialEq, Eq, Hash)]
pub enum Kind {
    /// One of the constants of [`Ty`].
    Special(u8),
    /// A declared type with its arguments.
    Named(DefId, Arc<[Ty]>),
    /// An array of so many dimensions.
    Array(Ty, u8),
    /// A type parameter.
    Param(ParamId),
    /// A tuple with names for its elements; the same at run time as the type that it names.
    Tuple(Ty, Arc<[Option<Name>]>),
}

/// All types.
#[derive(Debug, Clone)]
pub struct Types {
    kinds: Vec<Kind>,
    numbers: HashMap<Kind, Ty>,
}

impl Default for Types {
    fn default() -> Self {
        let mut types = Self { kinds: Vec::new(), numbers: HashMap::new() };
        for special in 0..5 {
            types.intern(Kind::Special(special));
        }
        types
    }
}

impl Types {
    /// The number of a type.
    pub fn intern(&mut self, kind: Kind) -> Ty {
        if let Some(ty) = self.numbers.get(&kind) {
            return *ty;
        }
        let ty = Ty(self.kinds.len() as u32);
        self.kinds.push(kind.clone());
        self.numbers.insert(kind, ty);
        ty
    }

    /// The number of a type that is there already.
    pub fn find(&self, kind: &Kind) -> Option<Ty> {
        self.numbers.get(kind).copied()
    }

    /// What a type is.
    pub fn kind(&self, ty: Ty) -> &Kind {
        self.kinds.get(ty.0 as usize).unwrap_or(&Kind::Special(0))
    }

    /// The declaration and arguments of a type.
    pub fn named(&self, ty: Ty) -> Option<(DefId, &Arc<[Ty]>)> {
        match self.kind(ty) {
            Kind::Named(def, args) => Some((*def, args)),
            Kind::Tuple(inner, _) => self.named(*inner),
            _ => None,
        }
    }

    /// A type with its parameters replaced.
    pub fn substitute(&mut self, ty: Ty, by: &Substitution) -> Ty {
        if by.0.is_empty() {
            return ty;
        }
        match self.kind(ty).clone() {
            Kind::Special(_) => ty,
            Kind::Param(param) => by.get(param).unwrap_or(ty),
            Kind::Array(element, rank) => {
                let element = self.substitute(element, by);
                self.intern(Kind::Array(element, rank))
            }
            Kind::Named(def, args) => {
                if args.is_empty() {
                    return ty;
                }
                let args = args.iter().map(|arg| self.substitute(*arg, by)).collect();
                self.intern(Kind::Named(def, args))
            }
            Kind::Tuple(inner, names) => {
                let inner = self.substitute(inner, by);
                self.intern(Kind::Tuple(inner, names))
            }
        }
    }

    /// A type without the names of tuple elements, as it is at run time.
    pub fn erase(&mut self, ty: Ty) -> Ty {
        match self.kind(ty).clone() {
            Kind::Tuple(inner, _) => self.erase(inner),
            Kind::Array(element, rank) => {
                let element = self.erase(element);
                self.intern(Kind::Array(element, rank))
            }
            Kind::Named(def, args) if !args.is_empty() => {
                let args = args.iter().map(|arg| self.erase(*arg)).collect();
                self.intern(Kind::Named(def, args))
            }
            _ => ty,
        }
    }

    /// Whether type parameters stand in a type.
    pub fn is_open(&self, ty: Ty) -> bool {
        match self.kind(ty) {
            Kind::Special(_) => false,
            Kind::Param(_) => true,
            Kind::Array(element, _) => self.is_open(*element),
            Kind::Named(_, args) => args.iter().any(|arg| self.is_open(*arg)),
            Kind::Tuple(inner, _) => self.is_open(*inner),
        }
    }

    /// How deep type arguments stand in one another.
    pub fn depth(&self, ty: Ty) -> usize {
        match self.kind(ty) {
            Kind::Special(_) | Kind::Param(_) => 1,
            Kind::Array(element, _) => self.depth(*element) + 1,
            Kind::Named(_, args) => args.iter().map(|arg| self.depth(*arg)).max().unwrap_or(0) + 1,
            Kind::Tuple(inner, _) => self.depth(*inner),
        }
    }
}

/// Types for type parameters.
#[derive(Debug, Clone, Default, PartialEq, Eq)]
pub struct Substitution(pub Vec<(ParamId, Ty)>);

impl Substitution {
    /// Pairs parameters with arguments.
    pub fn of(params: &[ParamId], args: &[Ty]) -> Self {
        Self(params.iter().copied().zip(args.iter().copied()).collect())
    }

    /// The type for a parameter.
    pub fn get(&self, param: ParamId) -> Option<Ty> {
        self.0.iter().find(|(p, _)| *p == param).map(|(_, ty)| *ty)
    }

    /// Adds a pair, or replaces the one that is there.
    pub fn set(&mut self, param: ParamId, ty: Ty) {
        match self.0.iter_mut().find(|(p, _)| *p == param) {
            Some(pair) => pair.1 = ty,
            None => self.0.push((param, ty)),
        }
    }
}
