//! Why a call fits none of the methods with its name, in csc's words.

use super::{Binder, Item};
use crate::sema::{MethodId, Ty};
use crate::source::Pos;
use crate::syntax::ast::{self, Passing};

/// Why a candidate does not take the arguments.
pub(super) enum Refusal {
    Count,
    Missing(String),
    Name(String),
    Infer,
    Type(usize, Ty),
    Passing(usize, Passing),
    /// A type argument that does not meet a constraint.
    Bound(u16, String),
}

impl Binder<'_> {
    /// Tells why none of the candidates takes the arguments: of the one that came closest.
    pub(super) fn refuse(
        &mut self,
        pos: Pos,
        candidates: &[(Ty, MethodId)],
        refused: Option<(MethodId, Refusal)>,
        args: &[ast::Arg],
        items: &[Item],
        name: &str,
    ) {
        let count = args.len();
        let Some((id, why)) = refused else {
            self.fault(pos, 1501, format!("No overload for method '{name}' takes {count} arguments"));
            return;
        };
        let constructor = &*self.sema.method(id).name == ".ctor";
        match why {
            Refusal::Count | Refusal::Missing(_) if candidates.len() > 1 => {
                if constructor {
                    self.fault(
                        pos,
                        1729,
                        format!("'{name}' does not contain a constructor that takes {count} arguments"),
                    );
                } else {
                    self.fault(pos, 1501, format!("No overload for method '{name}' takes {count} arguments"));
                }
            }
            Refusal::Count if constructor => self.fault(
                pos,
                1729,
                format!("'{name}' does not contain a constructor that takes {count} arguments"),
            ),
            Refusal::Count => {
                self.fault(pos, 1501, format!("No overload for method '{name}' takes {count} arguments"))
            }
            Refusal::Missing(param) => {
                let shown = self.sema.show_method(id);
                self.fault(pos, 7036, format!("There is no argument given that corresponds to the required formal parameter '{param}' of '{shown}'"));
            }
            Refusal::Name(param) => self.fault(
                pos,
                1739,
                format!("The best overload for '{name}' does not have a parameter named '{param}'"),
            ),
            Refusal::Infer => {
                let shown = self.sema.show_method(id);
                self.fault(pos, 411, format!("The type arguments for method '{shown}' cannot be inferred from the usage. Try specifying the type arguments explicitly."));
            }
            Refusal::Passing(i, passing) => {
                let word = match passing {
                    Passing::Ref => "ref",
                    Passing::Out => "out",
                    Passing::In | Passing::Value => "in",
                };
                let at = args.get(i).map_or(pos, |a| a.value.pos);
                if passing == Passing::Value {
                    self.fault(
                        at,
                        1615,
                        format!("Argument {} should not be passed with the 'ref' or 'out' keyword", i + 1),
                    );
                } else {
                    self.fault(
                        at,
                        1620,
                        format!("Argument {} must be passed with the '{word}' keyword", i + 1),
                    );
                }
            }
            Refusal::Type(i, ty) => self.refuse_type(pos, i, ty, args, items),
            Refusal::Bound(code, message) => self.fault(pos, code, message),
        }
    }

    fn refuse_type(&mut self, pos: Pos, i: usize, ty: Ty, args: &[ast::Arg], items: &[Item]) {
        let at = args.get(i).map_or(pos, |a| a.value.pos);
        let to = self.show(ty);
        match items.get(i) {
            Some(Item::Value(value)) => {
                let from = self.show(value.ty);
                self.fault(at, 1503, format!("Argument {}: cannot convert from '{from}' to '{to}'", i + 1));
            }
            Some(item @ (Item::Lambda(..) | Item::Methods(_))) => {
                let item = item.clone();
                let faults = self.sema.faults.len();
                self.convert(item, ty, at);
                if self.sema.faults.len() == faults {
                    self.fault(at, 1503, format!("Argument {}: cannot convert to '{to}'", i + 1));
                }
            }
            _ => self.fault(at, 1503, format!("Argument {}: cannot convert to '{to}'", i + 1)),
        }
    }
}
