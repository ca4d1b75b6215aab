//! Members of types by name.

use super::{Access, DefId, Kind, Member, Sema, Ty};
use crate::syntax::ast::{Name, TypeKind};

impl Sema {
    /// The types whose members a value of a type has, the most derived first.
    pub fn member_types(&mut self, ty: Ty) -> Vec<Ty> {
        let mut all = self.chain(ty);
        match self.types.kind(ty).clone() {
            Kind::Param(_) => all.extend(self.interfaces(ty)),
            Kind::Named(def, _) if self.def(def).kind == TypeKind::Interface => {
                all.extend(self.interfaces(ty).into_iter().filter(|i| *i != ty).collect::<Vec<_>>());
                all.push(self.known.object);
            }
            _ => {}
        }
        all
    }

    /// Members with a name, each with the type that has it.
    pub fn members(&mut self, ty: Ty, name: &Name) -> Vec<(Ty, Member)> {
        let mut found = Vec::new();
        for owner in self.member_types(ty) {
            let Some(def) = self.def_of(owner) else { continue };
            if let Some(list) = self.def(def).members.get(name) {
                found.extend(list.iter().map(|m| (owner, *m)));
            }
        }
        if found.is_empty()
            && self.vb
            && let Some(other) = self.in_any_case(ty, name)
        {
            return self.members(ty, &other);
        }
        found
    }

    /// The spelling of a public member whose name is the same but for capitals.
    fn in_any_case(&mut self, ty: Ty, name: &Name) -> Option<Name> {
        let types = self.member_types(ty);
        let defs = types.into_iter().filter_map(|owner| self.def_of(owner));
        let mut names: Vec<&Name> = defs.flat_map(|def| self.def(def).members.keys()).collect();
        names.retain(|own| own.eq_ignore_ascii_case(name) && *own != name);
        names.into_iter().min().cloned()
    }

    /// Whether code in a type may use a member.
    pub fn may_use(&mut self, from: Option<DefId>, owner: DefId, access: Access) -> bool {
        if access == Access::Public {
            return true;
        }
        let mut around = from;
        while let Some(def) = around {
            if def == owner {
                return true;
            }
            if access == Access::Protected {
                let open = self.open(def);
                if self.chain(open).into_iter().any(|t| self.def_of(t) == Some(owner)) {
                    return true;
                }
            }
            around = self.def(def).outer;
        }
        // A type may use what the types inside it keep private in messages of csc only; here it may not either.
        false
    }
}
