//! Names of types and namespaces (C# specification, namespace and type names).

use std::sync::Arc;

use super::{DefId, Kind, Member, ParamId, Sema, Ty, UsingScope};
use crate::source::Pos;
use crate::syntax::ast::{Name, NamePart, TypeRef, TypeRefKind};

/// More type arguments than any type of the library has.
const MOST_ARGUMENTS: usize = 8;

/// From where a name is looked up.
#[derive(Debug, Clone)]
pub struct NameScope {
    /// The type that it stands in.
    pub def: Option<DefId>,
    /// Type parameters of the method that it stands in.
    pub params: Vec<ParamId>,
    /// Namespaces that are used.
    pub usings: Arc<UsingScope>,
}

/// What a name stands for.
#[derive(Debug, Clone, PartialEq, Eq)]
pub enum Resolved {
    /// A type.
    Type(Ty),
    /// A namespace.
    Namespace(String),
}

impl Sema {
    /// The type that is written; a fault where there is none.
    pub fn resolve(&mut self, written: &TypeRef, scope: &NameScope) -> Ty {
        match &written.kind {
            TypeRefKind::Var => {
                self.fault(written.pos, 825, "The contextual keyword 'var' may only appear within a local variable declaration or in script code");
                Ty::ERROR
            }
            TypeRefKind::Array(element, rank) => {
                let element = self.resolve(element, scope);
                if element == Ty::ERROR { element } else { self.array(element, *rank) }
            }
            TypeRefKind::Nullable(inner) => {
                let inner = self.resolve(inner, scope);
                if self.is_value_type(inner) && self.nullable_of(inner).is_none() {
                    self.nullable(inner)
                } else {
                    inner
                }
            }
            TypeRefKind::Tuple(parts) => {
                let mut types = Vec::new();
                let mut names = Vec::new();
                for (ty, name) in parts {
                    types.push(self.resolve(ty, scope));
                    names.push(name.clone());
                }
                self.tuple(written.pos, &types, names)
            }
            TypeRefKind::Named(parts) => self.resolve_named(written.pos, parts, scope),
        }
    }

    /// A tuple type.
    pub fn tuple(&mut self, pos: Pos, types: &[Ty], names: Vec<Option<Name>>) -> Ty {
        let Some(def) = self.library("System", "ValueTuple", types.len()) else {
            self.fault(pos, 0, format!("A tuple of {} elements is not supported", types.len()));
            return Ty::ERROR;
        };
        if types.contains(&Ty::ERROR) {
            return Ty::ERROR;
        }
        let inner = self.named(def, types);
        if names.iter().all(Option::is_none) {
            return inner;
        }
        self.types.intern(Kind::Tuple(inner, names.into()))
    }

    fn resolve_named(&mut self, pos: Pos, parts: &[NamePart], scope: &NameScope) -> Ty {
        if let [system, one] = parts
            && &*system.name == "System"
            && &*one.name == "Void"
        {
            return Ty::VOID;
        }
        let mut at = None;
        for (i, part) in parts.iter().enumerate() {
            let found = match &at {
                None => self.lookup(part, scope),
                Some(left) => self.lookup_in(left, part, scope),
            };
            at = match found {
                Some(found) => Some(found),
                None => {
                    if !self.other_arity(part, at.as_ref(), scope) {
                        self.no_such_type(part, parts.get(i.wrapping_sub(1)), at.as_ref());
                    }
                    return Ty::ERROR;
                }
            };
        }
        match at {
            Some(Resolved::Type(ty)) => ty,
            Some(Resolved::Namespace(name)) => {
                self.fault(pos, 118, format!("'{name}' is a namespace but is used like a type"));
                Ty::ERROR
            }
            None => Ty::ERROR,
        }
    }

    /// A type of that name with another number of arguments: that is said.
    fn other_arity(&mut self, part: &NamePart, at: Option<&Resolved>, scope: &NameScope) -> bool {
        let given = part.args.len() + usize::from(part.open);
        for arity in (0..=MOST_ARGUMENTS).filter(|n| *n != given) {
            let open = u8::try_from(arity).unwrap_or(0);
            let other = NamePart { pos: part.pos, name: part.name.clone(), args: Vec::new(), open };
            let found = match at {
                None => self.lookup(&other, scope),
                Some(left) => self.lookup_in(left, &other, scope),
            };
            let Some(Resolved::Type(ty)) = found else { continue };
            let shown = self.show(ty);
            if arity == 0 {
                let message = format!("The non-generic type '{shown}' cannot be used with type arguments");
                self.fault(part.pos, 308, message);
            } else {
                let message = format!("Using the generic type '{shown}' requires {arity} type arguments");
                self.fault(part.pos, 305, message);
            }
            return true;
        }
        false
    }

    fn no_such_type(&mut self, part: &NamePart, before: Option<&NamePart>, at: Option<&Resolved>) {
        let arity = part.args.len() + usize::from(part.open);
        let shown = if arity > 0 {
            format!("{}<{}>", part.name, vec![""; arity].join(","))
        } else {
            part.name.to_string()
        };
        match (at, before) {
            (Some(Resolved::Namespace(namespace)), _) => self.fault(part.pos, 234, format!("The type or namespace name '{shown}' does not exist in the namespace '{namespace}' (are you missing an assembly reference?)")),
            (Some(Resolved::Type(ty)), _) => {
                let ty = self.show(*ty);
                self.fault(part.pos, 426, format!("The type name '{shown}' does not exist in the type '{ty}'"));
            }
            _ => self.fault(part.pos, 246, format!("The type or namespace name '{shown}' could not be found (are you missing a using directive or an assembly reference?)")),
        }
    }

    /// A name on its own, as a type or namespace.
    pub fn lookup(&mut self, part: &NamePart, scope: &NameScope) -> Option<Resolved> {
        let arity = part.args.len() + usize::from(part.open);
        if arity == 0 {
            if &*part.name == "dynamic" {
                return Some(Resolved::Type(Ty::DYNAMIC));
            }
            if let Some(param) = scope.params.iter().rev().find(|p| self.param(**p).name == part.name) {
                let param = *param;
                return Some(Resolved::Type(self.types.intern(Kind::Param(param))));
            }
        }
        let mut around = scope.def;
        while let Some(def) = around {
            if arity == 0 {
                let params = self.def(def).params.clone();
                if let Some(param) = params.into_iter().rev().find(|p| self.param(*p).name == part.name) {
                    return Some(Resolved::Type(self.types.intern(Kind::Param(param))));
                }
            }
            let open = self.open(def);
            if self.def(def).name == part.name && self.own_arity(def) == arity && arity == 0 {
                return Some(Resolved::Type(open));
            }
            if let Some(ty) = self.nested_type(open, part, arity, scope) {
                return Some(Resolved::Type(ty));
            }
            around = self.def(def).outer;
        }
        self.lookup_in_usings(part, arity, scope)
    }

    fn lookup_in_usings(&mut self, part: &NamePart, arity: usize, scope: &NameScope) -> Option<Resolved> {
        let mut usings = Some(scope.usings.clone());
        while let Some(level) = usings {
            if let Some(found) = self.in_namespace(&level.namespace, part, arity, scope) {
                return Some(found);
            }
            if arity == 0
                && let Some((_, target)) = level.aliases.iter().find(|(name, _)| *name == part.name)
            {
                let outer = NameScope { def: None, params: Vec::new(), usings: without_aliases(&level) };
                if let TypeRefKind::Named(parts) = &target.kind
                    && let Some(found) = self.lookup_path(parts, &outer)
                {
                    return Some(found);
                }
                return Some(Resolved::Type(self.resolve(target, &outer)));
            }
            for namespace in &level.namespaces {
                if let Some(Resolved::Type(ty)) = self.in_namespace(namespace, part, arity, scope) {
                    return Some(Resolved::Type(ty));
                }
            }
            usings = level.outer.clone();
        }
        None
    }

    fn lookup_path(&mut self, parts: &[NamePart], scope: &NameScope) -> Option<Resolved> {
        let (first, rest) = parts.split_first()?;
        let mut at = self.lookup(first, scope)?;
        for part in rest {
            at = self.lookup_in(&at, part, scope)?;
        }
        Some(at)
    }

    /// A name behind a dot.
    pub fn lookup_in(&mut self, left: &Resolved, part: &NamePart, scope: &NameScope) -> Option<Resolved> {
        let arity = part.args.len() + usize::from(part.open);
        match left {
            Resolved::Namespace(namespace) => self.in_namespace(namespace, part, arity, scope),
            Resolved::Type(ty) => self.nested_type(*ty, part, arity, scope).map(Resolved::Type),
        }
    }

    fn in_namespace(
        &mut self,
        namespace: &str,
        part: &NamePart,
        arity: usize,
        scope: &NameScope,
    ) -> Option<Resolved> {
        if let Some(list) = self.by_name.get(&(namespace.to_owned(), part.name.clone()))
            && let Some(def) = list.iter().copied().find(|def| self.def(*def).params.len() == arity)
        {
            let args: Vec<_> = part.args.iter().map(|arg| self.resolve(arg, scope)).collect();
            let ty = self.with_args(def, args);
            self.note(part.pos, ty, scope);
            return Some(Resolved::Type(ty));
        }
        if self.vb
            && let Some(name) = self.type_in_any_case(namespace, &part.name)
        {
            let part = NamePart { name, ..part.clone() };
            return self.in_namespace(namespace, &part, arity, scope);
        }
        if arity == 0 {
            let name = if namespace.is_empty() {
                part.name.to_string()
            } else {
                format!("{namespace}.{}", part.name)
            };
            if self.namespaces.contains(&name) {
                return Some(Resolved::Namespace(name));
            }
        }
        None
    }

    /// The spelling of a type whose name is the same but for capitals.
    fn type_in_any_case(
        &self,
        namespace: &str,
        name: &crate::syntax::ast::Name,
    ) -> Option<crate::syntax::ast::Name> {
        let all = self
            .by_name
            .keys()
            .filter(|(space, own)| space == namespace && own.eq_ignore_ascii_case(name) && own != name);
        all.map(|(_, own)| own.clone()).min()
    }

    /// A type inside another, or inside one of its base classes.
    fn nested_type(&mut self, ty: Ty, part: &NamePart, arity: usize, scope: &NameScope) -> Option<Ty> {
        let mut at = Some(ty);
        let mut steps = 0;
        while let Some(ty) = at {
            let def = self.def_of(ty)?;
            let nested = self.def(def).members.get(&part.name).and_then(|list| {
                list.iter().find_map(|m| match m {
                    Member::Type(inner) if self.own_arity(*inner) == arity => Some(*inner),
                    _ => None,
                })
            });
            if let Some(inner) = nested {
                let mut args = self.args_of(ty);
                args.extend(part.args.iter().map(|arg| self.resolve(arg, scope)).collect::<Vec<_>>());
                let ty = self.with_args(inner, args);
                self.note(part.pos, ty, scope);
                return Some(ty);
            }
            at = self.base_of(ty);
            steps += 1;
            if steps > 100 {
                return None;
            }
        }
        None
    }

    fn with_args(&mut self, def: DefId, mut args: Vec<Ty>) -> Ty {
        if args.contains(&Ty::ERROR) {
            return Ty::ERROR;
        }
        // `typeof(List<>)`: the parameters stand for themselves.
        let params = self.def(def).params.clone();
        for param in params.iter().skip(args.len()) {
            args.push(self.types.intern(Kind::Param(*param)));
        }
        self.named(def, &args)
    }

    /// The number of type parameters that a type has beyond those of types around it.
    pub fn own_arity(&self, def: DefId) -> usize {
        let def = self.def(def);
        def.params.len() - def.outer.map_or(0, |outer| self.def(outer).params.len())
    }
}

/// A name of a `using` is not looked up among the other names of its list.
fn without_aliases(level: &Arc<UsingScope>) -> Arc<UsingScope> {
    Arc::new(UsingScope { aliases: Vec::new(), ..(**level).clone() })
}
