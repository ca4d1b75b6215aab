//! Base classes and interfaces; which method runs for a type.

use super::{Body, DefId, Kind, Member, MethodId, Sema, Substitution, Ty};
use crate::bound::MethodRef;
use crate::syntax::ast::TypeKind;

const MAX_BASES: usize = 64;

impl Sema {
    /// The base class of a type; none for `object` and interfaces.
    pub fn base_of(&mut self, ty: Ty) -> Option<Ty> {
        match self.types.kind(ty).clone() {
            Kind::Array(..) => Some(self.known.array),
            Kind::Tuple(inner, _) => self.base_of(inner),
            Kind::Named(def, args) => {
                let info = self.def(def);
                match info.kind {
                    TypeKind::Interface => None,
                    TypeKind::Enum => Some(self.known.enumeration),
                    TypeKind::Struct => Some(self.known.value_type),
                    TypeKind::Delegate => Some(self.known.delegate),
                    TypeKind::Class => match info.base {
                        Some(base) => {
                            let by = Substitution::of(&info.params, &args);
                            Some(self.types.substitute(base, &by))
                        }
                        None if ty == self.known.object => None,
                        None => Some(self.known.object),
                    },
                }
            }
            Kind::Param(param) => {
                let bounds = self.param(param).bounds.clone();
                bounds
                    .into_iter()
                    .find(|b| self.type_kind(*b) == Some(TypeKind::Class))
                    .or(Some(self.known.object))
            }
            Kind::Special(_) => None,
        }
    }

    /// The type and its base classes, the most derived first.
    pub fn chain(&mut self, ty: Ty) -> Vec<Ty> {
        let mut chain = vec![ty];
        let mut at = ty;
        while let Some(base) = self.base_of(at) {
            chain.push(base);
            at = base;
            if chain.len() > MAX_BASES {
                break;
            }
        }
        chain
    }

    /// All interfaces of a type, also those of its base classes and of other interfaces.
    pub fn interfaces(&mut self, ty: Ty) -> Vec<Ty> {
        let mut found = Vec::new();
        let mut todo = self.chain(ty);
        if let Kind::Param(param) = self.types.kind(ty) {
            todo.extend(self.param(*param).bounds.clone());
        }
        while let Some(one) = todo.pop() {
            let declared = match self.types.kind(one).clone() {
                Kind::Named(def, args) => {
                    let info = self.def(def);
                    if info.kind == TypeKind::Interface && !found.contains(&one) {
                        found.push(one);
                    }
                    let by = Substitution::of(&info.params, &args);
                    let list = info.interfaces.clone();
                    list.into_iter().map(|i| self.types.substitute(i, &by)).collect()
                }
                Kind::Tuple(inner, _) => vec![inner],
                Kind::Array(element, 1) => {
                    let def = self.known.array_impl;
                    vec![self.named(def, &[element])]
                }
                _ => Vec::new(),
            };
            for interface in declared {
                if !found.contains(&interface) && found.len() < 400 {
                    todo.push(interface);
                }
            }
        }
        found
    }

    /// The type that a type is, or derives from, or implements, with a given declaration.
    pub fn as_instance_of(&mut self, ty: Ty, def: DefId) -> Option<Ty> {
        let chain = self.chain(ty);
        if let Some(found) = chain.into_iter().find(|t| self.def_of(*t) == Some(def)) {
            return Some(found);
        }
        if self.def(def).kind != TypeKind::Interface {
            return None;
        }
        self.interfaces(ty).into_iter().find(|t| self.def_of(*t) == Some(def))
    }

    /// The method that runs when a method is called on an object of a type.
    pub fn find_override(&mut self, runtime: Ty, called: &MethodRef) -> Option<MethodRef> {
        let interface = self.type_kind(called.owner) == Some(TypeKind::Interface);
        let mut chain = self.chain(runtime);
        if let Kind::Array(element, _) = self.types.kind(runtime).clone() {
            let def = self.known.array_impl;
            let helper = self.named(def, &[element]);
            chain.insert(1, helper);
        }
        for ty in chain {
            let Some(def) = self.def_of(ty) else { continue };
            if interface {
                if let Some(found) = self.implements(ty, def, called) {
                    return Some(found);
                }
                continue;
            }
            if def == self.method(called.id).owner {
                return Some(MethodRef { id: called.id, owner: ty, args: called.args.clone() });
            }
            if let Some(id) = self.overrides_in(ty, def, called) {
                return Some(MethodRef { id, owner: ty, args: called.args.clone() });
            }
        }
        if matches!(self.method(called.id).body, Body::None) {
            // Interfaces may differ in what their arguments vary by: IEnumerable<string> as IEnumerable<object>.
            return self.by_variance(runtime, called);
        }
        Some(called.clone())
    }

    fn by_variance(&mut self, runtime: Ty, called: &MethodRef) -> Option<MethodRef> {
        let def = self.def_of(called.owner)?;
        let other = self
            .interfaces(runtime)
            .into_iter()
            .find(|i| *i != called.owner && self.def_of(*i) == Some(def))?;
        let called = MethodRef { id: called.id, owner: other, args: called.args.clone() };
        let mut chain = self.chain(runtime);
        if let Kind::Array(element, _) = self.types.kind(runtime).clone() {
            let def = self.known.array_impl;
            let helper = self.named(def, &[element]);
            chain.insert(1, helper);
        }
        for ty in chain {
            let Some(def) = self.def_of(ty) else { continue };
            if let Some(found) = self.implements(ty, def, &called) {
                return Some(found);
            }
        }
        None
    }

    /// A method of a type that implements one of an interface: explicit ones first.
    fn implements(&mut self, ty: Ty, def: DefId, called: &MethodRef) -> Option<MethodRef> {
        let name = self.method(called.id).name.clone();
        let methods = self.def(def).methods.clone();
        let by = self.substitution(ty);
        let mut public = None;
        for id in methods {
            let method = self.method(id);
            if method.name != name
                || method.is_static
                || method.params.len() != self.method(called.id).params.len()
            {
                continue;
            }
            let explicit = method.explicit;
            if let Some(explicit) = explicit {
                if self.types.substitute(explicit, &by) != called.owner {
                    continue;
                }
                return Some(MethodRef { id, owner: ty, args: called.args.clone() });
            }
            if public.is_none() && self.same_signature(id, ty, called) && !self.method(id).is_abstract {
                public = Some(MethodRef { id, owner: ty, args: called.args.clone() });
            }
        }
        public
    }

    fn overrides_in(&mut self, ty: Ty, def: DefId, called: &MethodRef) -> Option<MethodId> {
        let name = self.method(called.id).name.clone();
        let list = self.def(def).members.get(&name)?.clone();
        list.into_iter().find_map(|member| match member {
            Member::Method(id) if self.method(id).is_override && self.same_signature(id, ty, called) => {
                Some(id)
            }
            _ => None,
        })
    }

    /// Whether a method of a type takes what another takes.
    pub fn same_signature(&mut self, id: MethodId, ty: Ty, other: &MethodRef) -> bool {
        let (mine, theirs) = (self.method(id), self.method(other.id));
        if mine.params.len() != theirs.params.len() || mine.type_params.len() != theirs.type_params.len() {
            return false;
        }
        let mut mine_by = self.substitution(ty);
        let mut their_by = self.substitution(other.owner);
        let (mine, theirs) = (self.method(id).clone(), self.method(other.id).clone());
        mine_by.0.extend(Substitution::of(&mine.type_params, &other.args).0);
        their_by.0.extend(Substitution::of(&theirs.type_params, &other.args).0);
        mine.params.iter().zip(&theirs.params).all(|(a, b)| {
            a.passing == b.passing && {
                let a = self.types.substitute(a.ty, &mine_by);
                let b = self.types.substitute(b.ty, &their_by);
                a == b || self.types.erase(a) == self.types.erase(b)
            }
        })
    }

    /// Whether a value of one run-time type is of another.
    pub fn is_subtype(&mut self, from: Ty, to: Ty) -> bool {
        if from == to || to == self.known.object || to == Ty::DYNAMIC {
            return true;
        }
        if let Some(inner) = self.nullable_of(to) {
            return self.is_subtype(from, inner);
        }
        match (self.types.kind(from).clone(), self.types.kind(to).clone()) {
            (Kind::Array(a, n), Kind::Array(b, m)) => {
                n == m && (a == b || self.is_reference(a) && self.is_subtype(a, b))
            }
            (_, Kind::Named(def, args)) => {
                if self.chain(from).contains(&to) {
                    return true;
                }
                match self.def(def).kind {
                    TypeKind::Interface => {
                        let all = self.interfaces(from);
                        all.contains(&to) || all.into_iter().any(|i| self.varies(i, def, &args))
                    }
                    TypeKind::Delegate => self.varies(from, def, &args),
                    _ => false,
                }
            }
            _ => false,
        }
    }

    /// Whether a type is one of the library's interfaces or delegates whose arguments may vary, by references alone.
    fn varies(&mut self, from: Ty, def: DefId, to: &[Ty]) -> bool {
        let Some((other, args)) = self.types.named(from) else { return false };
        if other != def || args.len() != to.len() {
            return false;
        }
        let (args, name, library) = (args.clone(), self.def(def).name.clone(), self.def(def).library);
        if !library {
            return false;
        }
        args.iter().zip(to).enumerate().all(|(i, (a, b))| {
            if a == b {
                return true;
            }
            let out = match &*name {
                "IEnumerable" | "IEnumerator" | "IReadOnlyList" | "IReadOnlyCollection" | "IGrouping" => true,
                "Func" | "Converter" => i + 1 == args.len(),
                "Action" | "IComparer" | "IEqualityComparer" | "Predicate" | "Comparison" | "IComparable" => {
                    false
                }
                _ => return false,
            };
            let (a, b) = if out { (*a, *b) } else { (*b, *a) };
            self.is_reference(a) && self.is_reference(b) && self.is_subtype(a, b)
        })
    }
}
