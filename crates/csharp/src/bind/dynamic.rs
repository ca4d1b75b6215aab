//! Operations on `dynamic` values, bound when they run for the types that the operands then have: so overloads,
//! operators and conversions are those that the compiler would take (C# specification, 12.3.2, dynamic binding).

use super::{Binder, Entry, Function, Item, Returns, make};
use crate::bound::{Body, Const, DynamicOp, Expr, Kind, LocalId, Stmt, StmtKind};
use crate::sema::{DefId, Sema, Ty};
use crate::source::Pos;
use crate::syntax::ast::{self, Arg, BinaryOp, NamePart, Passing};

/// A function that takes operands of these types and gives what the operation gives. The fault is the message of the
/// exception.
pub(crate) fn bind_dynamic(
    sema: &mut Sema,
    def: DefId,
    op: &DynamicOp,
    types: &[Ty],
    pos: Pos,
) -> Result<Body, String> {
    let faults = sema.faults.len();
    let mut binder = Binder::new(sema, def, true, &[]);
    let object = binder.sema.known.object;
    binder.functions.push(Function { returns: Returns::Type(object), yields: None, by_ref: false, base: 0 });
    let mut params = Vec::new();
    for (i, ty) in types.iter().enumerate() {
        let name = operand_name(i);
        let id = binder.new_local(&name, if *ty == Ty::NULL { object } else { *ty }, Passing::Value);
        binder.enter(&name, Entry::Local(id));
        params.push(id);
    }
    let value = binder.dynamic_value(pos, op, &params, types);
    let kind = if value.ty == Ty::VOID {
        StmtKind::Expr(value)
    } else {
        StmtKind::Return(Some(binder.convert(Item::Value(value), object, pos)))
    };
    let body = binder.finish_body(pos, params, vec![Stmt { pos, kind }], None);
    match sema.faults.get(faults).map(|fault| fault.message.clone()) {
        Some(message) => {
            sema.faults.truncate(faults);
            Err(message)
        }
        None => Ok(body),
    }
}

fn operand_name(i: usize) -> ast::Name {
    format!("<{i}>").into()
}

impl Binder<'_> {
    fn dynamic_value(&mut self, pos: Pos, op: &DynamicOp, params: &[LocalId], types: &[Ty]) -> Expr {
        let operands: Vec<Expr> = params
            .iter()
            .zip(types)
            .map(|(id, ty)| match *ty {
                Ty::NULL => make(Ty::NULL, pos, Kind::Const(Const::Null)),
                _ => self.local(*id, pos),
            })
            .collect();
        let args: Vec<Arg> = (1..types.len())
            .map(|i| {
                let kind = if types[i] == Ty::NULL {
                    ast::ExprKind::Lit(ast::Lit::Null)
                } else {
                    let part = NamePart { pos, name: operand_name(i), args: Vec::new(), open: 0 };
                    ast::ExprKind::Name(part)
                };
                Arg { name: None, passing: Passing::Value, value: ast::Expr { pos, kind } }
            })
            .collect();
        let Some(first) = operands.first().cloned() else { return self.wrong(pos) };
        let part = |name: &ast::Name| NamePart { pos, name: name.clone(), args: Vec::new(), open: 0 };
        match (op, operands.as_slice()) {
            (DynamicOp::Get(name), _) => {
                let item = self.member_of(pos, first, &part(name));
                self.as_value(item, pos)
            }
            (DynamicOp::Set(name), [_, value]) => {
                let item = self.member_of(pos, first, &part(name));
                let place = self.as_value(item, pos);
                self.assign_to(pos, place, Item::Value(value.clone()), pos)
            }
            (DynamicOp::Call(name), _) => match self.member_of(pos, first, &part(name)) {
                Item::Methods(group) => self.call_group(pos, *group, &args),
                item => {
                    let value = self.as_value(item, pos);
                    self.call_value(pos, value, &args)
                }
            },
            (DynamicOp::Invoke, _) => self.call_value(pos, first, &args),
            (DynamicOp::Index, _) => self.element(pos, first, &args),
            (DynamicOp::SetIndex, [.., value]) => {
                let place = self.element(pos, first, &args[..args.len().saturating_sub(1)]);
                self.assign_to(pos, place, Item::Value(value.clone()), pos)
            }
            (DynamicOp::Binary(op), [x, y]) => match self.basic_binary(pos, *op, x, y) {
                Some(value) => value,
                None => self.binary_values(pos, *op, x.clone(), y.clone()),
            },
            (DynamicOp::Unary(op), _) => self.unary(pos, *op, first),
            (DynamicOp::Convert(to), _) => self.cast(pos, Item::Value(first), *to),
            _ => self.wrong(pos),
        }
    }

    /// VB reads texts, truth values and nothing as numbers: those operators are the library's.
    fn basic_binary(&mut self, pos: Pos, op: BinaryOp, x: &Expr, y: &Expr) -> Option<Expr> {
        let name = match op {
            _ if !self.is_vb() => return None,
            BinaryOp::Add => "Plus",
            BinaryOp::Sub => "Minus",
            BinaryOp::Mul => "Times",
            BinaryOp::Div => "Divide",
            BinaryOp::Rem => "Rest",
            _ => return None,
        };
        let known = self.sema.known;
        let is_read = |e: &Expr| [known.string, known.bool, Ty::NULL].contains(&e.ty);
        if !is_read(x) && !is_read(y) {
            return None;
        }
        // Beside a type with operators of its own, a text is the number that it says.
        let is_own = |b: &Self, e: &Expr| b.sema.is_struct(e.ty) && b.sema.prim(e.ty).is_none();
        let (text, number) = (known.string, known.double);
        if x.ty == text && is_own(self, y) {
            let x = self.dynamic_as(pos, x.clone(), number);
            return Some(self.binary_values(pos, op, x, y.clone()));
        }
        if y.ty == text && is_own(self, x) {
            let y = self.dynamic_as(pos, y.clone(), number);
            return Some(self.binary_values(pos, op, x.clone(), y));
        }
        let method = self.function_of("__VB", name)?;
        let args = [x, y].map(|e| (Passing::Value, self.convert(Item::Value(e.clone()), known.object, pos)));
        Some(make(known.object, pos, Kind::Call(None, method, args.into(), false)))
    }
}
