//! Constraints on type parameters (C# specification, 8.4.5 and 15.2.5): what they may say, and whether arguments meet them.

use super::{DefId, Kind, NameScope, ParamId, Sema, Substitution, Ty};
use crate::source::Pos;
use crate::syntax::ast::TypeKind;

impl Sema {
    /// Keeps a type that the program has written, to look at its arguments when everything is declared.
    pub(super) fn note(&mut self, pos: Pos, ty: Ty, scope: &NameScope) {
        let library = scope.def.is_some_and(|def| self.def(def).library);
        let has_args = self.types.named(ty).is_some_and(|(_, args)| !args.is_empty());
        if has_args && !library && !self.noted.contains(&(pos, ty)) {
            self.noted.push((pos, ty));
        }
    }

    /// Looks at the arguments of all types that were written.
    pub fn check_noted(&mut self) {
        for (pos, ty) in std::mem::take(&mut self.noted) {
            let Some((def, args)) = self.types.named(ty).map(|(def, args)| (def, args.to_vec())) else {
                continue;
            };
            let params = self.def(def).params.clone();
            let by = Substitution::of(&params, &args);
            let whole = self.show_def(def);
            for (param, arg) in params.iter().zip(args) {
                if let Some((code, message)) = self.unmet(*param, arg, &by, &whole) {
                    self.fault(pos, code, message);
                    break;
                }
            }
        }
    }

    /// Why an argument is none for a type parameter of something; none where it is.
    pub fn unmet(
        &mut self,
        param: ParamId,
        arg: Ty,
        by: &Substitution,
        whole: &str,
    ) -> Option<(u16, String)> {
        if arg == Ty::ERROR || *self.types.kind(arg) == Kind::Param(param) {
            return None;
        }
        let info = self.param(param).clone();
        let (shown, name) = (self.show(arg), info.name.clone());
        if self.def_of(arg).is_some_and(|def| self.def(def).is_static) {
            return Some((718, format!("'{shown}': static types cannot be used as type arguments")));
        }
        let nullable = self.nullable_of(arg).is_some();
        let of_param = |flag: fn(&super::TypeParamDef) -> bool| match self.types.kind(arg) {
            Kind::Param(own) => flag(self.param(*own)),
            _ => false,
        };
        let used =
            format!("in order to use it as parameter '{name}' in the generic type or method '{whole}'");
        if info.class && !self.is_reference(arg) && !of_param(|p| p.class) && arg != Ty::DYNAMIC {
            return Some((452, format!("The type '{shown}' must be a reference type {used}")));
        }
        if info.structure && (nullable || !self.is_value_type(arg) && !of_param(|p| p.structure)) {
            return Some((453, format!("The type '{shown}' must be a non-nullable value type {used}")));
        }
        if let Some(unmet) = info.bounds.iter().find_map(|bound| self.unbound(arg, *bound, by)) {
            let (code, reason) = unmet;
            let message = format!(
                "The type '{shown}' cannot be used as type parameter '{name}' in the generic type or method '{whole}'. {reason}"
            );
            return Some((code, message));
        }
        if info.creatable && !info.structure && !self.is_creatable(arg) {
            let what = "must be a non-abstract type with a public parameterless constructor";
            return Some((310, format!("The type '{shown}' {what} {used}")));
        }
        None
    }

    /// Why an argument does not convert to a bound.
    fn unbound(&mut self, arg: Ty, bound: Ty, by: &Substitution) -> Option<(u16, String)> {
        let bound = self.types.substitute(bound, by);
        if bound == Ty::ERROR || arg == Ty::DYNAMIC {
            return None;
        }
        let (from, to) = (self.show(arg), self.show(bound));
        if self.nullable_of(arg).is_some() && self.type_kind(bound) == Some(TypeKind::Interface) {
            let reason = format!("The nullable type '{from}' can not satisfy any interface constraints.");
            return Some((313, reason));
        }
        let converts = match (self.prim(arg), self.prim(bound)) {
            (Some(a), Some(b)) => a == b,
            _ => self.implicit_standard(arg, bound).is_some(),
        };
        if converts {
            return None;
        }
        let (code, what) = if self.is_param(arg) {
            (314, "boxing conversion or type parameter conversion")
        } else if self.nullable_of(arg).is_some() {
            (312, "boxing conversion")
        } else if self.is_value_type(arg) {
            (315, "boxing conversion")
        } else {
            (311, "implicit reference conversion")
        };
        Some((code, format!("There is no {what} from '{from}' to '{to}'.")))
    }

    /// Whether `new()` makes one.
    fn is_creatable(&self, ty: Ty) -> bool {
        if let Kind::Param(own) = self.types.kind(ty) {
            let own = self.param(*own);
            return own.creatable || own.structure;
        }
        if self.is_value_type(ty) || ty == Ty::DYNAMIC {
            return true;
        }
        let Some(def) = self.def_of(ty) else { return false };
        let info = self.def(def);
        if info.kind != TypeKind::Class || info.is_abstract || info.is_static || ty == self.known.string {
            return false;
        }
        // What the host declares may leave constructors out.
        info.library
            || info.members.get(".ctor").is_some_and(|list| {
                list.iter().any(|member| match member {
                    super::Member::Method(id) => {
                        let method = self.method(*id);
                        method.params.is_empty() && method.access == super::Access::Public
                    }
                    _ => false,
                })
            })
    }

    /// What the constraints of a type and of its methods say themselves.
    pub(super) fn check_constraints(&mut self, id: DefId) {
        let pos = self.def(id).pos;
        self.check_bounds(pos, &self.def(id).params.clone());
        for method in self.def(id).methods.clone() {
            let info = self.method(method);
            let (pos, params) = (info.pos, info.type_params.clone());
            self.check_bounds(pos, &params);
        }
    }

    fn check_bounds(&mut self, pos: Pos, params: &[ParamId]) {
        for (i, param) in params.iter().enumerate() {
            let info = self.param(*param).clone();
            if params[..i].iter().any(|other| self.param(*other).name == info.name) {
                self.fault(pos, 692, format!("Duplicate type parameter '{}'", info.name));
                return;
            }
            for (at, bound) in info.bounds.iter().enumerate() {
                if let Some((code, message)) = self.wrong_bound(&info, at, *bound) {
                    self.fault(pos, code, message);
                }
            }
            if let Some(other) = self.ring(*param) {
                let other = self.param(other).name.clone();
                let message =
                    format!("Circular constraint dependency involving '{}' and '{other}'", info.name);
                self.fault(pos, 454, message);
                return;
            }
        }
    }

    fn wrong_bound(&mut self, info: &super::TypeParamDef, at: usize, bound: Ty) -> Option<(u16, String)> {
        let shown = self.show(bound);
        if bound == Ty::ERROR {
            return None;
        }
        if info.bounds[..at].contains(&bound) {
            return Some((405, format!("Duplicate constraint '{shown}' for type parameter '{}'", info.name)));
        }
        if [self.known.object, self.known.array, self.known.value_type].contains(&bound) {
            return Some((702, format!("Constraint cannot be special class '{shown}'")));
        }
        let kind = self.type_kind(bound);
        let is_class = kind == Some(TypeKind::Class);
        let sealed = self.def_of(bound).is_some_and(|def| self.def(def).is_sealed || self.def(def).is_static);
        let fits = self.is_param(bound)
            || kind == Some(TypeKind::Interface)
            || is_class && !sealed && bound != self.known.string;
        if !fits {
            let what =
                "A type used as a constraint must be an interface, a non-sealed class or a type parameter";
            return Some((701, format!("'{shown}' is not a valid constraint. {what}.")));
        }
        if is_class && at > 0 {
            let message =
                format!("The class type constraint '{shown}' must come before any other constraints");
            return Some((406, message));
        }
        if is_class && (info.class || info.structure) {
            let message = format!(
                "'{shown}': cannot specify both a constraint class and the 'class' or 'struct' constraint"
            );
            return Some((450, message));
        }
        None
    }

    /// A parameter that a parameter is bound to, and that is bound to it.
    fn ring(&self, param: ParamId) -> Option<ParamId> {
        let next = |of: ParamId| {
            self.param(of).bounds.iter().find_map(|bound| match self.types.kind(*bound) {
                Kind::Param(other) => Some(*other),
                _ => None,
            })
        };
        let mut at = next(param)?;
        let first = at;
        for _ in 0..self.params.len() {
            if at == param {
                return Some(first);
            }
            at = next(at)?;
        }
        None
    }
}
