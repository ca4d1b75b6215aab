//! What a declaration promises and does not keep: members declared twice, methods left undone, overrides of nothing.

use super::{Body, DefId, Kind, Member, MethodId, Sema};
use crate::syntax::ast::{Name, Passing, TypeKind};

impl Sema {
    /// What is declared twice, and what a class leaves undone.
    pub(super) fn check_members(&mut self, id: DefId) {
        let members: Vec<_> = self.def(id).members.clone().into_iter().collect();
        let owner = self.show_def(id);
        for (name, list) in members {
            for (i, a) in list.iter().enumerate() {
                for b in &list[i + 1..] {
                    self.check_pair(&owner, &name, *a, *b);
                }
            }
        }
        self.check_implemented(id);
        self.check_rules(id);
        let chain = self.def(id).methods.clone();
        for method in chain {
            if self.method(method).is_override && !self.method(method).is_static {
                self.check_override(id, method);
            }
            let (abstract_, pos) = (self.method(method).is_abstract, self.method(method).pos);
            if abstract_ && self.def(id).kind == TypeKind::Class && !self.def(id).is_abstract {
                let shown = self.show_method(method);
                self.fault(
                    pos,
                    513,
                    format!("'{shown}' is abstract but it is contained in non-abstract class '{owner}'"),
                );
            }
            if matches!(self.method(method).body, Body::None)
                && !abstract_
                && self.def(id).kind != TypeKind::Interface
            {
                let shown = self.show_method(method);
                self.fault(
                    pos,
                    501,
                    format!(
                        "'{shown}' must declare a body because it is not marked abstract, extern, or partial"
                    ),
                );
            }
        }
    }

    fn check_pair(&mut self, owner: &str, name: &Name, a: Member, b: Member) {
        let (pos, clash) = match (a, b) {
            (Member::Method(a), Member::Method(b)) => {
                let (a, b) = (self.method(a), self.method(b));
                let same = a.params.len() == b.params.len()
                    && a.type_params.len() == b.type_params.len()
                    && a.params.iter().zip(&b.params).all(|(p, q)| {
                        p.ty == q.ty && (p.passing == Passing::Value) == (q.passing == Passing::Value)
                    })
                    && (!name.starts_with("op_") || a.ret == b.ret);
                if same && &**name != ".cctor" {
                    let message = format!(
                        "Type '{owner}' already defines a member called '{name}' with the same parameter types"
                    );
                    let pos = b.pos;
                    self.fault(pos, 111, message);
                }
                return;
            }
            (_, Member::Field(f)) => (self.field(f).pos, true),
            (Member::Prop(_), Member::Prop(p)) => (0, self.prop(p).params.is_empty()),
            (Member::Field(_), Member::Method(m)) => (self.method(m).pos, true),
            _ => (0, false),
        };
        if clash {
            self.fault(pos, 102, format!("The type '{owner}' already contains a definition for '{name}'"));
        }
    }

    fn check_override(&mut self, id: DefId, method: MethodId) {
        let name = self.method(method).name.clone();
        let open = self.open(id);
        let args: Vec<_> = self
            .method(method)
            .type_params
            .clone()
            .into_iter()
            .map(|p| self.types.intern(Kind::Param(p)))
            .collect();
        let mut chain = self.chain(open);
        chain.remove(0);
        for base in chain {
            let Some(def) = self.def_of(base) else { continue };
            for member in self.def(def).members.get(&name).cloned().unwrap_or_default() {
                if let Member::Method(other) = member {
                    let reference = crate::bound::MethodRef { id: other, owner: base, args: args.clone() };
                    if self.same_signature(method, open, &reference) {
                        if !self.method(other).is_virtual {
                            let (mine, theirs) = (self.show_method(method), self.show_method(other));
                            self.fault(self.method(method).pos, 506, format!("'{mine}': cannot override inherited member '{theirs}' because it is not marked virtual, abstract, or override"));
                        }
                        self.check_same_result(method, &reference);
                        return;
                    }
                }
            }
        }
        let shown = self.show_method(method);
        self.fault(self.method(method).pos, 115, format!("'{shown}': no suitable method found to override"));
    }

    /// An override gives what the method gives that it overrides, to the same callers.
    fn check_same_result(&mut self, method: MethodId, other: &crate::bound::MethodRef) {
        let ret = self.result_of(other);
        let info = self.method(method);
        let (pos, own, access) = (info.pos, info.ret, info.access);
        if access != self.method(other.id).access {
            let (mine, theirs) = (self.show_method(method), self.show_method(other.id));
            self.fault(
                pos,
                507,
                format!(
                    "'{mine}': cannot change access modifiers when overriding inherited member '{theirs}'"
                ),
            );
        }
        if self.types.erase(ret) != self.types.erase(own) && !self.is_subtype(own, ret) {
            let (mine, theirs, shown) =
                (self.show_method(method), self.show_method(other.id), self.show(ret));
            self.fault(
                pos,
                508,
                format!("'{mine}': return type must be '{shown}' to match overridden member '{theirs}'"),
            );
        }
    }

    /// What a method gives for the type arguments that it is named with.
    fn result_of(&mut self, method: &crate::bound::MethodRef) -> super::Ty {
        let mut by = self.substitution(method.owner);
        let info = self.method(method.id);
        let (ret, params) = (info.ret, info.type_params.clone());
        by.0.extend(super::Substitution::of(&params, &method.args).0);
        self.types.substitute(ret, &by)
    }

    /// Whether a type has a static method with the name and parameters of another.
    fn has_static(&self, id: DefId, method: MethodId) -> bool {
        let wanted = self.method(method);
        let list = self.def(id).members.get(&wanted.name);
        list.into_iter().flatten().any(|member| match member {
            Member::Method(own) => {
                let own = self.method(*own);
                let same = own.params.iter().map(|p| p.ty).eq(wanted.params.iter().map(|p| p.ty));
                own.is_static && same
            }
            _ => false,
        })
    }

    /// Whether a method cannot stand for one of an interface: a static one, or one that is not public.
    fn hides_from_interface(&self, method: MethodId) -> bool {
        let info = self.method(method);
        let own = self.def(info.owner);
        // `internal` is as good as public for everything else: there is one assembly.
        let internal = match &info.body {
            Body::Written(method) => method.modifiers.has("internal"),
            Body::Accessor(property, _) => property.modifiers.has("internal"),
            _ => false,
        };
        own.kind != TypeKind::Interface
            && !own.library
            && info.explicit.is_none()
            && (info.is_static || internal || info.access != super::Access::Public)
    }

    fn check_implemented(&mut self, id: DefId) {
        let def = self.def(id);
        if !matches!(def.kind, TypeKind::Class | TypeKind::Struct) {
            return;
        }
        let (is_abstract, pos) = (def.is_abstract, def.pos);
        let open = self.open(id);
        let owner = self.show(open);
        for interface in self.interfaces(open) {
            let Some(declared) = self.def_of(interface) else { continue };
            for method in self.def(declared).methods.clone() {
                if !self.method(method).is_abstract {
                    continue;
                }
                let args: Vec<_> = self
                    .method(method)
                    .type_params
                    .clone()
                    .into_iter()
                    .map(|p| self.types.intern(Kind::Param(p)))
                    .collect();
                let called = crate::bound::MethodRef { id: method, owner: interface, args };
                match self.find_override(open, &called) {
                    None if !is_abstract && self.has_static(id, method) => {
                        let shown = self.show_method(method);
                        self.fault(pos, 736, format!("'{owner}' does not implement instance interface member '{shown}'. The one of the class cannot implement it because it is static."));
                    }
                    None if !is_abstract => {
                        let shown = self.show_method(method);
                        self.fault(
                            pos,
                            535,
                            format!("'{owner}' does not implement interface member '{shown}'"),
                        );
                    }
                    Some(found) if self.hides_from_interface(found.id) => {
                        let info = self.method(found.id);
                        let (code, what) =
                            if info.is_static { (736, "is static") } else { (737, "is not public") };
                        let (shown, best) = (self.show_method(method), self.show_method(found.id));
                        self.fault(pos, code, format!("'{owner}' does not implement interface member '{shown}'. '{best}' cannot implement it because it {what}."));
                    }
                    Some(found) => {
                        let (wanted, given) = (self.result_of(&called), self.result_of(&found));
                        if self.types.erase(wanted) != self.types.erase(given) {
                            let (shown, best) = (self.show_method(method), self.show_method(found.id));
                            let ty = self.show(wanted);
                            self.fault(pos, 738, format!("'{owner}' does not implement interface member '{shown}'. '{best}' cannot implement it because it does not have the matching return type of '{ty}'"));
                        }
                    }
                    None => {}
                }
            }
        }
        if is_abstract {
            return;
        }
        let mut chain = self.chain(open);
        chain.remove(0);
        for base in chain {
            let Some(def) = self.def_of(base) else { continue };
            for method in self.def(def).methods.clone() {
                if !self.method(method).is_abstract {
                    continue;
                }
                let args: Vec<_> = self
                    .method(method)
                    .type_params
                    .clone()
                    .into_iter()
                    .map(|p| self.types.intern(Kind::Param(p)))
                    .collect();
                let called = crate::bound::MethodRef { id: method, owner: base, args };
                if self.find_override(open, &called).is_none_or(|found| self.method(found.id).is_abstract) {
                    let shown = self.show_method(method);
                    self.fault(
                        pos,
                        534,
                        format!("'{owner}' does not implement inherited abstract member '{shown}'"),
                    );
                }
            }
        }
    }
}
