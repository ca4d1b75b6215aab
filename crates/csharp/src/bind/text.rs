//! Interpolated texts.

use super::{Binder, Item, make};
use crate::bound::{Const, Expr, Kind, MethodRef};
use crate::sema::{Member, Ty};
use crate::source::Pos;
use crate::syntax::ast::{Passing, TextPiece};

impl Binder<'_> {
    pub(super) fn interpolated(&mut self, pos: Pos, pieces: &[TextPiece]) -> Expr {
        let string = self.sema.known.string;
        let mut parts = Vec::new();
        for piece in pieces {
            let part = match piece {
                TextPiece::Text(units) => make(string, pos, Kind::Const(Const::Str(units.clone()))),
                TextPiece::Hole(value, None, None) => {
                    let value = self.real_value(value);
                    if value.ty == Ty::ERROR {
                        return value;
                    }
                    self.as_text(value)
                }
                TextPiece::Hole(value, width, format) => {
                    let value = self.real_value(value);
                    let int = self.sema.known.int;
                    let width = match width {
                        Some(width) => {
                            let item = self.item(width);
                            self.convert(item, int, width.pos)
                        }
                        None => make(int, pos, Kind::Const(Const::Int(0))),
                    };
                    let format = match format {
                        Some(format) => Const::Str(format.encode_utf16().collect()),
                        None => Const::Null,
                    };
                    let format = make(string, pos, Kind::Const(format));
                    self.piece(pos, value, width, format)
                }
            };
            parts.push(part);
        }
        match parts.len() {
            0 => make(string, pos, Kind::Const(Const::Str([].into()))),
            _ => make(string, pos, Kind::Concat(parts)),
        }
    }

    /// A value with a width and a format, by a method of the library.
    fn piece(&mut self, pos: Pos, value: Expr, width: Expr, format: Expr) -> Expr {
        let string = self.sema.known.string;
        let object = self.sema.known.object;
        let members = self.sema.members(string, &"__Piece".into());
        let found = members.into_iter().find_map(|(owner, m)| match m {
            Member::Method(id) => Some(MethodRef { id, owner, args: Vec::new() }),
            _ => None,
        });
        let Some(method) = found else { return self.wrong(pos) };
        let value = self.convert(Item::Value(value), object, pos);
        let args = [value, width, format].into_iter().map(|v| (Passing::Value, v)).collect();
        make(string, pos, Kind::Call(None, method, args, false))
    }
}
