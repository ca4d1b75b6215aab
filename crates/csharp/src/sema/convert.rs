//! Conversions between types (C# specification, conversions).

use super::{Kind, Member, Prim, Sema, Substitution, Ty};
use crate::bound::MethodRef;
use crate::syntax::ast::TypeKind;

/// How a value of one type becomes one of another.
#[derive(Debug, Clone, PartialEq, Eq)]
pub enum Conversion {
    /// It is the same type.
    Identity,
    /// Between numbers.
    Numeric(Prim, Prim),
    /// A number to an enum, an enum to a number or another enum.
    Enum,
    /// `null` to a reference or a nullable.
    Null,
    /// A reference to one of its bases or interfaces.
    Up,
    /// A value to a reference.
    Box,
    /// A reference to a more derived one or to a value.
    Down,
    /// To a nullable: what is done with the value inside.
    ToNullable(Box<Conversion>),
    /// From a nullable.
    FromNullable(Box<Conversion>),
    /// Between nullables: the inside, when it is there.
    Lifted(Box<Conversion>),
    /// By a method.
    User(UserConversion),
    /// To `dynamic`, or from it when it runs.
    Dynamic,
    /// Element by element.
    Tuple(Vec<Conversion>),
}

/// A conversion that a type declares, with what is done before and behind.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct UserConversion {
    /// The method.
    pub method: MethodRef,
    /// What it takes.
    pub takes: Ty,
    /// What it gives.
    pub gives: Ty,
}

/// Whether a number fits another type without a loss of size.
pub(super) fn widens(from: Prim, to: Prim) -> bool {
    use Prim::*;
    match from {
        I8 => matches!(to, I16 | I32 | I64 | F32 | F64 | Decimal),
        U8 => matches!(to, I16 | U16 | I32 | U32 | I64 | U64 | F32 | F64 | Decimal),
        I16 => matches!(to, I32 | I64 | F32 | F64 | Decimal),
        U16 | Char if to == U16 => from == Char,
        U16 | Char => matches!(to, I32 | U32 | I64 | U64 | F32 | F64 | Decimal),
        I32 => matches!(to, I64 | F32 | F64 | Decimal),
        U32 => matches!(to, I64 | U64 | F32 | F64 | Decimal),
        I64 | U64 => matches!(to, F32 | F64 | Decimal),
        F32 => to == F64,
        _ => false,
    }
}

impl Sema {
    /// The implicit conversion between two types, without those that types declare.
    pub fn implicit_standard(&mut self, from: Ty, to: Ty) -> Option<Conversion> {
        if from == to || from == Ty::ERROR || to == Ty::ERROR {
            return Some(Conversion::Identity);
        }
        if self.types.erase(from) == self.types.erase(to) {
            return Some(Conversion::Identity);
        }
        if to == Ty::DYNAMIC && from != Ty::VOID && from != Ty::NONE {
            return Some(Conversion::Box);
        }
        if from == Ty::DYNAMIC {
            return Some(if to == self.known.object { Conversion::Identity } else { Conversion::Dynamic });
        }
        if from == Ty::NULL {
            let fits = self.is_reference(to) || self.nullable_of(to).is_some();
            return fits.then_some(Conversion::Null);
        }
        if from == Ty::VOID || to == Ty::VOID || from == Ty::NONE {
            return None;
        }
        if let (Some(a), Some(b)) = (self.prim(from), self.prim(to)) {
            // In VB a decimal widens to the real numbers.
            let in_vb = self.vb && a == Prim::Decimal && matches!(b, Prim::F32 | Prim::F64);
            return (widens(a, b) || in_vb).then_some(Conversion::Numeric(a, b));
        }
        if let Some(inner) = self.nullable_of(to) {
            if let Some(source) = self.nullable_of(from) {
                return Some(Conversion::Lifted(Box::new(self.implicit_standard(source, inner)?)));
            }
            if self.is_value_type(from) || self.is_param(from) {
                return Some(Conversion::ToNullable(Box::new(self.implicit_standard(from, inner)?)));
            }
            return None;
        }
        if let (Some(a), Some(b)) = (self.tuple_parts(from), self.tuple_parts(to)) {
            return self.tuple_conversion(&a, &b, true);
        }
        if self.is_value_type(from) {
            let from = self.nullable_of(from).unwrap_or(from);
            // Nothing is boxed to become another value: `T?` becomes `T` by a cast alone.
            return (!self.is_value_type(to) && self.is_subtype(from, to)).then_some(Conversion::Box);
        }
        if self.is_param(from) {
            let bounds = self.interfaces(from);
            let fits = to == self.known.object
                || bounds.contains(&to)
                || self.chain(from).contains(&to)
                || self.param_converts(from, to);
            return fits.then_some(Conversion::Box);
        }
        (self.is_reference(from) && self.is_subtype(from, to)).then_some(Conversion::Up)
    }

    fn param_converts(&mut self, from: Ty, to: Ty) -> bool {
        let Kind::Param(param) = self.types.kind(from).clone() else { return false };
        let bounds = self.param(param).bounds.clone();
        bounds.into_iter().any(|b| b == to || self.is_param(b) && self.param_converts(b, to))
    }

    /// The elements of a tuple type.
    pub fn tuple_parts(&self, ty: Ty) -> Option<Vec<Ty>> {
        let def = self.def_of(ty)?;
        let info = self.def(def);
        (&*info.name == "ValueTuple" && info.library && !info.params.is_empty()).then(|| self.args_of(ty))
    }

    fn tuple_conversion(&mut self, a: &[Ty], b: &[Ty], implicit: bool) -> Option<Conversion> {
        if a.len() != b.len() {
            return None;
        }
        let parts: Option<Vec<_>> = a
            .iter()
            .zip(b)
            .map(|(a, b)| if implicit { self.implicit(*a, *b) } else { self.explicit(*a, *b) })
            .collect();
        Some(Conversion::Tuple(parts?))
    }

    /// The implicit conversion between two types.
    pub fn implicit(&mut self, from: Ty, to: Ty) -> Option<Conversion> {
        if let Some(found) = self.implicit_standard(from, to) {
            return Some(found);
        }
        self.user_conversion(from, to, false)
    }

    /// The conversion that a cast makes.
    pub fn explicit(&mut self, from: Ty, to: Ty) -> Option<Conversion> {
        if let Some(found) = self.implicit_standard(from, to) {
            return Some(found);
        }
        let (a, b) = (self.underlying(from), self.underlying(to));
        if let (Some(a), Some(b)) = (a, b) {
            if a == Prim::Bool || b == Prim::Bool {
                return None;
            }
            if self.is_enum(from) || self.is_enum(to) {
                return Some(Conversion::Enum);
            }
            return Some(Conversion::Numeric(a, b));
        }
        let (from_inner, to_inner) = (self.nullable_of(from), self.nullable_of(to));
        match (from_inner, to_inner) {
            (Some(a), Some(b)) => return Some(Conversion::Lifted(Box::new(self.explicit(a, b)?))),
            (Some(a), None) if self.is_value_type(to) => {
                return Some(Conversion::FromNullable(Box::new(self.explicit(a, to)?)));
            }
            (None, Some(b)) if self.is_value_type(from) => {
                return Some(Conversion::ToNullable(Box::new(self.explicit(from, b)?)));
            }
            _ => {}
        }
        self.standard_explicit(from, to).or_else(|| self.user_conversion(from, to, true))
    }

    /// Casts between references, and out of boxes.
    fn standard_explicit(&mut self, from: Ty, to: Ty) -> Option<Conversion> {
        if let (Some(a), Some(b)) = (self.tuple_parts(from), self.tuple_parts(to)) {
            return self.tuple_conversion(&a, &b, false);
        }
        if self.is_value_type(from) && self.is_value_type(to) {
            return None;
        }
        if self.is_subtype(to, from) || self.is_param(from) || self.is_param(to) {
            return Some(Conversion::Down);
        }
        let interface = |sema: &Self, ty| sema.type_kind(ty) == Some(TypeKind::Interface);
        let open = |sema: &Self, ty| {
            sema.def_of(ty).is_none_or(|def| !sema.def(def).is_sealed) && !sema.is_value_type(ty)
        };
        if (interface(self, from) && (open(self, to) || self.is_subtype(to, from)))
            || (interface(self, to) && open(self, from))
        {
            return Some(Conversion::Down);
        }
        match (self.types.kind(from).clone(), self.types.kind(to).clone()) {
            (Kind::Array(a, n), Kind::Array(b, m))
                if n == m && self.is_reference(a) && self.is_reference(b) =>
            {
                self.explicit(a, b).map(|_| Conversion::Down)
            }
            (Kind::Array(..), _) | (_, Kind::Array(..)) if interface(self, from) || interface(self, to) => {
                Some(Conversion::Down)
            }
            _ => None,
        }
    }

    /// A conversion that one of the two types declares: of those that fit, the one closest to both types.
    fn user_conversion(&mut self, from: Ty, to: Ty, explicit: bool) -> Option<Conversion> {
        let (source, target) = (self.nullable_of(from).unwrap_or(from), self.nullable_of(to).unwrap_or(to));
        let mut found: Vec<UserConversion> = Vec::new();
        let mut owners = self.declaring(source);
        owners.extend(self.declaring(target));
        owners.dedup();
        let names: &[&str] = if explicit { &["op_Implicit", "op_Explicit"] } else { &["op_Implicit"] };
        for owner in owners {
            let Some(def) = self.def_of(owner) else { continue };
            let by = self.substitution(owner);
            for name in names {
                for member in self.def(def).members.get(*name).cloned().unwrap_or_default() {
                    if let Member::Method(id) = member {
                        self.consider(id, owner, &by, (source, target), explicit, &mut found);
                    }
                }
            }
        }
        // Exact types first, then the order of declaration.
        let rank = |c: &UserConversion| usize::from(c.takes != source) + usize::from(c.gives != target);
        let best = found.into_iter().min_by_key(rank)?;
        Some(Conversion::User(best))
    }

    fn consider(
        &mut self,
        id: super::MethodId,
        owner: Ty,
        by: &Substitution,
        (source, target): (Ty, Ty),
        explicit: bool,
        found: &mut Vec<UserConversion>,
    ) {
        let method = self.method(id);
        let Some(first) = method.params.first() else { return };
        let (takes, gives) = (first.ty, method.ret);
        let takes = self.types.substitute(takes, by);
        let gives = self.types.substitute(gives, by);
        let reaches = |sema: &mut Self, a, b| {
            sema.implicit_standard(a, b).is_some()
                || explicit
                    && (sema.implicit_standard(b, a).is_some()
                        || sema.prim(a).is_some() && sema.prim(b).is_some())
        };
        if reaches(self, source, takes) && reaches(self, gives, target) && source != target {
            let method = MethodRef { id, owner, args: Vec::new() };
            found.push(UserConversion { method, takes, gives });
        }
    }

    /// Types that may declare operators for a type: it and its base classes.
    pub fn declaring(&mut self, ty: Ty) -> Vec<Ty> {
        if self.prim(ty).is_some_and(|p| p != Prim::Decimal)
            || matches!(self.types.kind(ty), Kind::Array(..) | Kind::Special(_))
        {
            return Vec::new();
        }
        let object = self.known.object;
        self.chain(ty).into_iter().filter(|t| *t != object).collect()
    }
}
