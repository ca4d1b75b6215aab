//! Operators of one operand.

use super::operator::promoted;
use super::{Binder, make};
use crate::bound::{Const, Conv, DynamicOp, Expr, Kind, MethodRef};
use crate::sema::{Member, Prim, Ty};
use crate::source::Pos;
use crate::syntax::ast::UnaryOp;

impl Binder<'_> {
    pub(super) fn unary(&mut self, pos: Pos, op: UnaryOp, operand: Expr) -> Expr {
        if operand.ty == Ty::ERROR {
            return operand;
        }
        if operand.ty == Ty::DYNAMIC {
            return make(Ty::DYNAMIC, pos, Kind::Dynamic(DynamicOp::Unary(op), vec![operand]));
        }
        let name = match op {
            UnaryOp::Plus => "op_UnaryPlus",
            UnaryOp::Minus => "op_UnaryNegation",
            UnaryOp::Not => "op_LogicalNot",
            UnaryOp::Complement => "op_OnesComplement",
        };
        if let Some(method) = self.user_unary(name, operand.ty) {
            return self.call_operator(pos, method, vec![operand]);
        }
        if let Some(inner) = self.sema.nullable_of(operand.ty) {
            let (number, held) = self.held(inner, pos);
            let result = self.unary(pos, op, held);
            let ty = self.sema.nullable(result.ty);
            let result = self.retyped(result, ty);
            return make(ty, pos, Kind::Conditional(Box::new(operand), number, Box::new(result)));
        }
        self.predefined_unary(pos, op, operand)
    }

    fn predefined_unary(&mut self, pos: Pos, op: UnaryOp, operand: Expr) -> Expr {
        let prim = self.sema.underlying(operand.ty);
        match (op, prim) {
            (UnaryOp::Not, Some(Prim::Bool)) => {
                if let Kind::Const(Const::Bool(b)) = operand.kind {
                    return make(operand.ty, pos, Kind::Const(Const::Bool(!b)));
                }
                make(operand.ty, pos, Kind::Not(Box::new(operand)))
            }
            (UnaryOp::Complement, Some(prim)) if prim.is_integral() => {
                let wide = promoted(prim, Prim::I32)
                    .filter(|_| !matches!(prim, Prim::U32 | Prim::U64))
                    .unwrap_or(prim);
                let number = self.prim_type(wide);
                let ty = operand.ty;
                let Some(value) = self.numeric_operand(operand, number) else { return self.wrong(pos) };
                if let Kind::Const(Const::Int(n)) = value.kind {
                    let flipped = super::constant::wrap(!n, wide);
                    return make(
                        if self.sema.is_enum(ty) { ty } else { number },
                        pos,
                        Kind::Const(Const::Int(flipped)),
                    );
                }
                let made = make(number, pos, Kind::Complement(wide, Box::new(value)));
                if self.sema.is_enum(ty) {
                    return make(ty, pos, Kind::Convert(Conv::ToEnum, Box::new(made)));
                }
                made
            }
            (UnaryOp::Plus | UnaryOp::Minus, Some(prim))
                if prim.is_numeric() && !self.sema.is_enum(operand.ty) =>
            {
                let wide = match prim {
                    Prim::U32 if op == UnaryOp::Minus => Prim::I64,
                    Prim::U32 | Prim::F32 | Prim::F64 | Prim::Decimal | Prim::I64 => prim,
                    Prim::U64 if op == UnaryOp::Plus => prim,
                    Prim::U64 => return self.no_unary(pos, op, operand.ty),
                    _ => Prim::I32,
                };
                let ty = self.prim_type(wide);
                let Some(value) = self.numeric_operand(operand, ty) else { return self.wrong(pos) };
                if op == UnaryOp::Plus {
                    return value;
                }
                let folded = match &value.kind {
                    Kind::Const(Const::Int(n)) => Some(Const::Int(super::constant::wrap(-n, wide))),
                    Kind::Const(Const::Double(x)) => Some(Const::Double(-x)),
                    Kind::Const(Const::Float(x)) => Some(Const::Float(-x)),
                    Kind::Const(Const::Decimal(x)) => Some(Const::Decimal(crate::decimal::negated(*x))),
                    _ => None,
                };
                match folded {
                    Some(folded) => make(ty, pos, Kind::Const(folded)),
                    None => make(ty, pos, Kind::Negate(wide, self.checked, Box::new(value))),
                }
            }
            _ => self.no_unary(pos, op, operand.ty),
        }
    }

    fn no_unary(&mut self, pos: Pos, op: UnaryOp, ty: Ty) -> Expr {
        let symbol = match op {
            UnaryOp::Plus => "+",
            UnaryOp::Minus => "-",
            UnaryOp::Not => "!",
            UnaryOp::Complement => "~",
        };
        let shown = self.show(ty);
        self.error(pos, 23, format!("Operator '{symbol}' cannot be applied to operand of type '{shown}'"))
    }

    pub(super) fn user_unary(&mut self, name: &str, ty: Ty) -> Option<MethodRef> {
        for owner in self.sema.declaring(ty) {
            let def = self.sema.def_of(owner)?;
            let list = self.sema.def(def).members.get(name).cloned().unwrap_or_default();
            for member in list {
                if let Member::Method(id) = member
                    && self.sema.method(id).params.len() == 1
                {
                    return Some(MethodRef { id, owner, args: Vec::new() });
                }
            }
        }
        None
    }
}
