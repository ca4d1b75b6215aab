//! What a declaration must not say: operators without their partners, members named as their type, structs in
//! themselves, instance members of static classes (C# specification, classes and structs).

use super::{Access, Body, DefId, Member, MethodId, Sema, Ty};
use crate::syntax::ast::TypeKind;

/// Operators that are declared together.
const PAIRS: [(&str, &str, &str, &str); 4] = [
    ("op_Equality", "op_Inequality", "==", "!="),
    ("op_LessThan", "op_GreaterThan", "<", ">"),
    ("op_LessThanOrEqual", "op_GreaterThanOrEqual", "<=", ">="),
    ("op_True", "op_False", "true", "false"),
];

impl Sema {
    /// What the members of a type of the program must not be.
    pub(super) fn check_rules(&mut self, id: DefId) {
        self.check_operators(id);
        self.check_names(id);
        self.check_layout(id);
        self.check_constraints(id);
        for method in self.def(id).methods.clone() {
            self.check_parameters(method);
            let info = self.method(method);
            if info.is_static
                && (info.is_virtual || info.is_abstract || info.is_override)
                && self.def(id).kind != TypeKind::Interface
            {
                let (pos, shown) = (info.pos, self.show_method(method));
                let message =
                    format!("A static member '{shown}' cannot be marked as override, virtual, or abstract");
                self.fault(pos, 112, message);
                continue;
            }
            let info = self.method(method);
            let has_body = matches!(info.body, Body::Written(_) | Body::Accessor(..));
            if info.is_abstract && has_body && self.def(id).kind == TypeKind::Class {
                let (pos, shown) = (info.pos, self.show_method(method));
                self.fault(
                    pos,
                    500,
                    format!("'{shown}' cannot declare a body because it is marked abstract"),
                );
            }
        }
    }

    fn check_operators(&mut self, id: DefId) {
        let this = self.open(id);
        let owner = self.show_def(id);
        for (a, b, sign, other) in PAIRS {
            let members = &self.def(id).members;
            let (first, partner, found, missing) = match (members.get(a), members.get(b)) {
                (Some(list), None) => (list, b, sign, other),
                (None, Some(list)) => (list, a, other, sign),
                _ => continue,
            };
            let Some(Member::Method(method)) = first.first().copied() else { continue };
            let _ = partner;
            let pos = self.method(method).pos;
            self.fault(pos, 216, format!("The operator '{owner}.operator {found}' requires a matching operator '{missing}' to also be defined"));
        }
        let mut conversions: Vec<(Ty, Ty)> = Vec::new();
        for method in self.def(id).methods.clone() {
            let info = self.method(method).clone();
            if !info.name.starts_with("op_") {
                continue;
            }
            let shown = self.show_method(method);
            if !info.is_static || info.access != Access::Public {
                let message = format!("User-defined operator '{shown}' must be declared static and public");
                self.fault(info.pos, 558, message);
                continue;
            }
            let is_this = |sema: &Self, ty: Ty| ty == this || sema.nullable_of(ty) == Some(this);
            let takes = info.params.iter().any(|p| is_this(self, p.ty));
            if matches!(&*info.name, "op_Implicit" | "op_Explicit") {
                let pair = (info.params.first().map_or(Ty::ERROR, |p| p.ty), info.ret);
                if conversions.contains(&pair) {
                    self.fault(info.pos, 557, format!("Duplicate user-defined conversion in type '{owner}'"));
                }
                conversions.push(pair);
            } else if !takes {
                let (code, what) = if info.params.len() == 1 {
                    (562, "The parameter of a unary operator must be the containing type")
                } else {
                    (563, "One of the parameters of a binary operator must be the containing type")
                };
                self.fault(info.pos, code, what);
            }
        }
    }

    fn check_names(&mut self, id: DefId) {
        let def = self.def(id).clone();
        let owner = self.show_def(id);
        if let Some(list) = def.members.get(&def.name)
            && matches!(def.kind, TypeKind::Class | TypeKind::Struct)
            && let Some(member) = list.first()
        {
            let pos = self.member_pos(*member);
            let name = &def.name;
            self.fault(
                pos,
                542,
                format!("'{name}': member names cannot be the same as their enclosing type"),
            );
        }
        for prop in &def.props {
            let info = self.prop(*prop);
            if info.getter.is_none() && info.setter.is_none() {
                let message =
                    format!("'{owner}.{}': property or indexer must have at least one accessor", info.name);
                self.fault(def.pos, 548, message);
            }
        }
        if def.is_static && def.kind == TypeKind::Class {
            let methods = def.methods.iter().map(|m| Member::Method(*m));
            let all: Vec<_> = def.fields.iter().map(|f| Member::Field(*f)).chain(methods).collect();
            for member in all {
                let (is_static, name) = match member {
                    Member::Field(f) => (self.field(f).is_static, self.field(f).name.clone()),
                    Member::Method(m) => (self.method(m).is_static, self.method(m).name.clone()),
                    _ => continue,
                };
                if !is_static {
                    let pos = self.member_pos(member);
                    let message =
                        format!("'{owner}.{name}': cannot declare instance members in a static class");
                    self.fault(pos, 708, message);
                }
            }
        }
    }

    fn member_pos(&self, member: Member) -> u32 {
        match member {
            Member::Method(m) => self.method(m).pos,
            Member::Field(f) => self.field(f).pos,
            Member::Prop(p) => self.prop(p).getter.map_or(0, |m| self.method(m).pos),
            Member::Type(t) => self.def(t).pos,
        }
    }

    /// A struct that holds itself has no size.
    fn check_layout(&mut self, id: DefId) {
        if self.def(id).kind != TypeKind::Struct {
            return;
        }
        for field in self.def(id).fields.clone() {
            let (ty, pos, name) =
                (self.field(field).ty, self.field(field).pos, self.field(field).name.clone());
            let mut todo = vec![ty];
            let mut seen = Vec::new();
            while let Some(ty) = todo.pop() {
                let Some(def) = self.def_of(ty).filter(|_| self.is_struct(ty)) else { continue };
                if def == id {
                    let (owner, shown) = (self.show_def(id), self.show(ty));
                    self.fault(pos, 523, format!("Struct member '{owner}.{name}' of type '{shown}' causes a cycle in the struct layout"));
                    break;
                }
                if !self.def(def).library && !seen.contains(&def) {
                    seen.push(def);
                    let fields = self.def(def).fields.clone();
                    todo.extend(fields.into_iter().map(|f| self.field(f).ty));
                }
            }
        }
    }

    fn check_parameters(&mut self, method: MethodId) {
        let info = self.method(method);
        let pos = info.pos;
        let last = info.params.len().saturating_sub(1);
        let rest_early = info.params.iter().take(last).any(|p| p.rest);
        let first_optional = info.params.iter().position(|p| p.default.is_some());
        let required_late = first_optional
            .is_some_and(|at| info.params.iter().skip(at).any(|p| p.default.is_none() && !p.rest));
        // The last parameter of a setter is its value.
        let is_setter = info.name.starts_with("set_");
        if rest_early && !is_setter {
            self.fault(pos, 231, "A params parameter must be the last parameter in a formal parameter list");
        }
        if required_late && !is_setter {
            self.fault(pos, 1737, "Optional parameters must appear after all required parameters");
        }
    }
}
