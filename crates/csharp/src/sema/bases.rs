//! Bases of declared types, and the types that the language knows.

use super::{DefId, Sema, Ty};
use crate::syntax::ast::TypeKind;

impl Sema {
    pub(super) fn learn_known(&mut self) {
        let get = |namespace: &str, name: &str, arity: usize| {
            self.library(namespace, name, arity).unwrap_or(DefId(0))
        };
        let defs = [
            get("System", "Nullable", 1),
            get("System", "ArrayImpl", 1),
            get("System.Collections.Generic", "IEnumerable", 1),
            get("System.Collections.Generic", "IEnumerator", 1),
            get("System", "Iterator", 1),
        ];
        let plain: Vec<_> = [
            ("System", "Object"),
            ("System", "String"),
            ("System", "Boolean"),
            ("System", "Char"),
            ("System", "Int32"),
            ("System", "UInt32"),
            ("System", "Int64"),
            ("System", "UInt64"),
            ("System", "Single"),
            ("System", "Double"),
            ("System", "Decimal"),
            ("System", "Array"),
            ("System", "ValueType"),
            ("System", "Enum"),
            ("System", "Delegate"),
            ("System", "Exception"),
            ("System", "Type"),
            ("System.Collections", "IEnumerable"),
            ("System.Collections", "IEnumerator"),
            ("System", "IDisposable"),
        ]
        .iter()
        .map(|(namespace, name)| get(namespace, name, 0))
        .collect();
        let t: Vec<_> = plain.into_iter().map(|def| self.named(def, &[])).collect();
        self.known = super::Known_ {
            object: t[0],
            string: t[1],
            bool: t[2],
            char: t[3],
            int: t[4],
            uint: t[5],
            long: t[6],
            ulong: t[7],
            float: t[8],
            double: t[9],
            decimal: t[10],
            array: t[11],
            value_type: t[12],
            enumeration: t[13],
            delegate: t[14],
            exception: t[15],
            type_: t[16],
            plain_enumerable: t[17],
            plain_enumerator: t[18],
            disposable: t[19],
            nullable: defs[0],
            array_impl: defs[1],
            enumerable: defs[2],
            enumerator: defs[3],
            iterator: defs[4],
        };
    }

    pub(super) fn declare_bases(&mut self, id: DefId) {
        let Some(decl) = self.def(id).decl.clone() else { return };
        let mut scope = self.scope_of(id, &[]);
        // Bases are looked up from outside, but see the type's own parameters.
        scope.params = self.def(id).params.clone();
        scope.def = self.def(id).outer;
        let params = self.def(id).params.clone();
        let own = params.len() - decl.type_params.len();
        for (param, written) in params.iter().skip(own).zip(&decl.type_params) {
            let bounds = written.bounds.iter().map(|b| self.resolve(b, &scope)).collect();
            self.params[param.0 as usize].bounds = bounds;
        }
        for (i, base) in decl.bases.iter().enumerate() {
            let ty = self.resolve(base, &scope);
            if ty == Ty::ERROR {
                continue;
            }
            let kind = self.type_kind(ty);
            let def = &mut self.defs[id.0 as usize];
            match (def.kind, kind) {
                (TypeKind::Enum, _) => def.base = Some(ty),
                (_, Some(TypeKind::Interface)) => def.interfaces.push(ty),
                (TypeKind::Class, Some(TypeKind::Class)) if i == 0 => def.base = Some(ty),
                _ => {
                    let shown = self.show(ty);
                    self.fault(
                        base.pos,
                        527,
                        format!("Type '{shown}' in interface list is not an interface"),
                    );
                    continue;
                }
            }
            if self.def(id).kind == TypeKind::Class && kind == Some(TypeKind::Class) && !self.def(id).library
            {
                self.check_base(id, ty, base.pos);
            }
        }
    }

    fn check_base(&mut self, id: DefId, base: Ty, pos: u32) {
        let Some(def) = self.def_of(base) else { return };
        let (mine, theirs) = (self.show_def(id), self.show(base));
        let special = [self.known.enumeration, self.known.value_type, self.known.delegate, self.known.array];
        if special.contains(&base) {
            let at = self.def(id).pos;
            self.fault(at, 644, format!("'{mine}' cannot derive from special class '{theirs}'"));
        } else if self.def(def).is_sealed || self.def(def).is_static {
            self.fault(pos, 509, format!("'{mine}': cannot derive from sealed type '{theirs}'"));
        } else if self.def(def).native {
            self.fault(pos, 0, format!("A class derived from '{theirs}' is not supported"));
        }
    }

    pub(super) fn show_def(&mut self, id: DefId) -> String {
        let open = self.open(id);
        self.show(open)
    }

    /// A class that is its own base would be gone through for ever.
    pub(super) fn break_rings(&mut self, id: DefId) {
        let mut at = id;
        for _ in 0..64 {
            let Some(base) = self.def(at).base.and_then(|base| self.def_of(base)) else { return };
            if base == id {
                break;
            }
            at = base;
        }
        let shown = self.show_def(id);
        self.fault(self.def(id).pos, 146, format!("Circular base class dependency involving '{shown}'"));
        self.defs[id.0 as usize].base = None;
    }
}
