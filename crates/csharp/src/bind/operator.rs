//! Operators (C# specification, operator overload resolution and the predefined operators).

use super::{Binder, Item, make};
use crate::bound::{Const, Conv, DynamicOp, Expr, Kind, MethodRef, Op};
use crate::sema::{Member, Prim, Ty};
use crate::source::Pos;
use crate::syntax::ast::{self, BinaryOp, Passing};

fn op_of(op: BinaryOp) -> Option<Op> {
    Some(match op {
        BinaryOp::Add => Op::Add,
        BinaryOp::Sub => Op::Sub,
        BinaryOp::Mul => Op::Mul,
        BinaryOp::Div => Op::Div,
        BinaryOp::Rem => Op::Rem,
        BinaryOp::Shl => Op::Shl,
        BinaryOp::Shr => Op::Shr,
        BinaryOp::And => Op::And,
        BinaryOp::Or => Op::Or,
        BinaryOp::Xor => Op::Xor,
        BinaryOp::Eq => Op::Eq,
        BinaryOp::Ne => Op::Ne,
        BinaryOp::Lt => Op::Lt,
        BinaryOp::Le => Op::Le,
        BinaryOp::Gt => Op::Gt,
        BinaryOp::Ge => Op::Ge,
        BinaryOp::AndAlso | BinaryOp::OrElse | BinaryOp::Coalesce => return None,
    })
}

fn method_of(op: BinaryOp) -> &'static str {
    match op {
        BinaryOp::Add => "op_Addition",
        BinaryOp::Sub => "op_Subtraction",
        BinaryOp::Mul => "op_Multiply",
        BinaryOp::Div => "op_Division",
        BinaryOp::Rem => "op_Modulus",
        BinaryOp::Shl => "op_LeftShift",
        BinaryOp::Shr => "op_RightShift",
        BinaryOp::And | BinaryOp::AndAlso => "op_BitwiseAnd",
        BinaryOp::Or | BinaryOp::OrElse => "op_BitwiseOr",
        BinaryOp::Xor => "op_ExclusiveOr",
        BinaryOp::Eq => "op_Equality",
        BinaryOp::Ne => "op_Inequality",
        BinaryOp::Lt => "op_LessThan",
        BinaryOp::Le => "op_LessThanOrEqual",
        BinaryOp::Gt => "op_GreaterThan",
        BinaryOp::Ge => "op_GreaterThanOrEqual",
        BinaryOp::Coalesce => "",
    }
}

/// Binary numeric promotion; none where the operands do not go together.
pub(super) fn promoted(a: Prim, b: Prim) -> Option<Prim> {
    use Prim::*;
    if a == Bool || b == Bool {
        return None;
    }
    let has = |p| a == p || b == p;
    if has(Decimal) {
        return if has(F64) || has(F32) { None } else { Some(Decimal) };
    }
    if has(F64) {
        return Some(F64);
    }
    if has(F32) {
        return Some(F32);
    }
    let signed = |p| matches!(p, I8 | I16 | I32 | I64);
    if has(U64) {
        return if signed(a) || signed(b) { None } else { Some(U64) };
    }
    if has(I64) {
        return Some(I64);
    }
    if has(U32) {
        return Some(if signed(a) || signed(b) { I64 } else { U32 });
    }
    Some(I32)
}

impl Binder<'_> {
    pub(super) fn binary(&mut self, pos: Pos, op: BinaryOp, a: &ast::Expr, b: &ast::Expr) -> Expr {
        match op {
            BinaryOp::Coalesce => return self.coalesce(pos, a, b),
            BinaryOp::AndAlso | BinaryOp::OrElse => {
                let x = self.real_value(a);
                let y = self.real_value(b);
                return self.logical(pos, op, x, y);
            }
            _ => {}
        }
        let x = self.operand(a, op);
        let y = match self.delegate_operand(op, x.ty, b) {
            Some(y) => y,
            None => self.operand(b, op),
        };
        self.binary_values(pos, op, x, y)
    }

    /// An operand; `default` takes the type of the other one, which is rarely written.
    fn operand(&mut self, e: &ast::Expr, op: BinaryOp) -> Expr {
        let value = self.value(e);
        if value.ty == Ty::VOID {
            return self.error(
                e.pos,
                19,
                format!("Operator '{}' cannot be applied to operands of type 'void'", op.symbol()),
            );
        }
        value
    }

    fn logical(&mut self, pos: Pos, op: BinaryOp, x: Expr, y: Expr) -> Expr {
        let bool_ = self.sema.known.bool;
        if x.ty == Ty::ERROR || y.ty == Ty::ERROR {
            return self.wrong(pos);
        }
        let to_bool = |b: &mut Self, e: &Expr| b.sema.implicit(e.ty, bool_).is_some() || e.ty == Ty::DYNAMIC;
        if !to_bool(self, &x) || !to_bool(self, &y) {
            // `&&` of types with `&`, `true` and `false` of their own.
            if let Some(method) = self.user_binary(op, &x, &y) {
                let false_name = if op == BinaryOp::AndAlso { "op_False" } else { "op_True" };
                if let Some(test) = self.user_unary(false_name, x.ty) {
                    let ty = x.ty;
                    let (number, held) = self.held(ty, pos);
                    let tested = self.call_operator(pos, test, vec![held.clone()]);
                    let both = self.call_operator(pos, method, vec![held.clone(), y]);
                    let choice =
                        make(both.ty, pos, Kind::Choice(Box::new(tested), Box::new(held), Box::new(both)));
                    return make(choice.ty, pos, Kind::Deconstruct(Box::new(x), number, vec![choice]));
                }
            }
            return self.no_operator(pos, op, &x, &y);
        }
        let x = self.truth(x);
        let y = self.truth(y);
        if let (Kind::Const(Const::Bool(p)), Kind::Const(Const::Bool(q))) = (&x.kind, &y.kind) {
            let result = if op == BinaryOp::AndAlso { *p && *q } else { *p || *q };
            return make(bool_, pos, Kind::Const(Const::Bool(result)));
        }
        let kind = if op == BinaryOp::AndAlso {
            Kind::And(Box::new(x), Box::new(y))
        } else {
            Kind::Or(Box::new(x), Box::new(y))
        };
        make(bool_, pos, kind)
    }

    fn no_operator(&mut self, pos: Pos, op: BinaryOp, x: &Expr, y: &Expr) -> Expr {
        let (a, b) = (self.show(x.ty), self.show(y.ty));
        self.error(
            pos,
            19,
            format!("Operator '{}' cannot be applied to operands of type '{a}' and '{b}'", op.symbol()),
        )
    }

    pub(super) fn binary_values(&mut self, pos: Pos, op: BinaryOp, x: Expr, y: Expr) -> Expr {
        if x.ty == Ty::ERROR || y.ty == Ty::ERROR {
            return self.wrong(pos);
        }
        if x.ty == Ty::DYNAMIC || y.ty == Ty::DYNAMIC {
            let comparison = matches!(op, BinaryOp::Eq | BinaryOp::Ne);
            if comparison && (x.ty == Ty::NULL || y.ty == Ty::NULL) {
                return self.same_object(pos, op, x, y);
            }
            return make(Ty::DYNAMIC, pos, Kind::Dynamic(DynamicOp::Binary(op), vec![x, y]));
        }
        if let Some(method) = self.user_binary(op, &x, &y) {
            return self.user_call(pos, op, method, x, y);
        }
        let (mut x, mut y) = (x, y);
        if op == BinaryOp::Div && self.is_vb() {
            // VB divides whole numbers to a number with decimals.
            let double = self.sema.known.double;
            let is_whole = |b: &Self, e: &Expr| b.sema.prim(e.ty).is_some_and(crate::sema::Prim::is_integral);
            if is_whole(self, &x) && is_whole(self, &y) {
                x = self.numeric_operand(x, double).unwrap_or_else(|| self.wrong(pos));
                y = self.numeric_operand(y, double).unwrap_or_else(|| self.wrong(pos));
            }
        }
        let string = self.sema.known.string;
        if self.is_vb() && (x.ty == string) != (y.ty == string) {
            // VB reads a text beside a number as a number.
            let double = self.sema.known.double;
            let is_number = |b: &Self, ty| b.sema.prim(ty).is_some_and(|p| p.is_numeric() && p != Prim::Char);
            if x.ty == string && is_number(self, y.ty) {
                x = self.dynamic_as(pos, x, double);
            } else if y.ty == string && is_number(self, x.ty) {
                y = self.dynamic_as(pos, y, double);
            }
        }
        if op == BinaryOp::Add && (x.ty == string || y.ty == string) {
            return self.concat(pos, x, y);
        }
        let Some(operation) = op_of(op) else { return self.wrong(pos) };
        if let Some(result) = self.predefined(pos, operation, &x, &y) {
            return result;
        }
        if matches!(op, BinaryOp::Eq | BinaryOp::Ne) {
            return self.equality(pos, op, x, y);
        }
        if let Some(result) = self.delegate_sum(pos, op, &x, &y) {
            return result;
        }
        self.no_operator(pos, op, &x, &y)
    }

    /// A value whose type is known when it runs, as another type: numbers widen, objects are cast.
    pub(super) fn dynamic_as(&mut self, pos: Pos, value: Expr, to: Ty) -> Expr {
        let object = self.sema.known.object;
        let value = self.retyped(value, object);
        // VB reads texts as numbers.
        let method = if self.is_vb() { "ReadDouble" } else { "ToDouble" };
        match self.dynamic_method(method) {
            Some(method) if to == self.sema.known.double => {
                make(to, pos, Kind::Call(None, method, vec![(ast::Passing::Value, value)], false))
            }
            _ if (self.sema.is_value_type(to) || !self.is_vb()) && !self.sema.types.is_open(to) => {
                make(to, pos, Kind::Dynamic(DynamicOp::Convert(to), vec![value]))
            }
            _ => self.cast(pos, super::Item::Value(value), to),
        }
    }

    fn dynamic_method(&mut self, name: &str) -> Option<MethodRef> {
        self.function_of("__Dynamic", name)
    }

    /// A function of one of the library's own classes.
    pub(super) fn function_of(&mut self, class: &str, name: &str) -> Option<MethodRef> {
        let name: ast::Name = name.into();
        let found = self.sema.library("", class, 0).map(|def| self.sema.named(def, &[]));
        found.and_then(|owner| {
            self.sema.members(owner, &name).into_iter().find_map(|(_, member)| match member {
                crate::sema::Member::Method(id) => Some(MethodRef { id, owner, args: Vec::new() }),
                _ => None,
            })
        })
    }

    /// Predefined operators on numbers, truth values and enums, lifted where a value may be missing.
    fn predefined(&mut self, pos: Pos, op: Op, x: &Expr, y: &Expr) -> Option<Expr> {
        let (xn, yn) = (self.sema.nullable_of(x.ty), self.sema.nullable_of(y.ty));
        let is_null = |e: &Expr| e.ty == Ty::NULL;
        if xn.is_some() || yn.is_some() {
            if is_null(x) || is_null(y) {
                return match op {
                    Op::Eq | Op::Ne => {
                        let value = if is_null(x) { y } else { x };
                        Some(make(
                            self.sema.known.bool,
                            pos,
                            Kind::IsNull(op == Op::Eq, Box::new(value.clone())),
                        ))
                    }
                    _ => None,
                };
            }
            if matches!(op, Op::And | Op::Or) && self.sema.prim(xn.unwrap_or(x.ty)) == Some(Prim::Bool) {
                return self.three_valued(pos, op, x, y);
            }
            return self.lifted(pos, op, x, y, xn, yn);
        }
        let (ty, prim, by) = self.operand_type(op, x, y)?;
        let by_ty = if by == prim { ty } else { self.prim_type(by) };
        let left = self.numeric_operand(x.clone(), ty)?;
        let right = self.numeric_operand(y.clone(), by_ty)?;
        let result = self.result_type(op, x, y, ty);
        if let Some(folded) = self.fold(pos, op, prim, &left, &right) {
            return Some(make(result, pos, Kind::Const(folded)));
        }
        let made = make(result, pos, Kind::Binary(op, prim, self.checked, Box::new(left), Box::new(right)));
        if self.sema.is_enum(result) {
            let number = self.prim_type(prim);
            let bare = Expr { ty: number, ..made };
            return Some(make(result, pos, Kind::Convert(Conv::ToEnum, Box::new(bare))));
        }
        Some(made)
    }

    /// The type in which an operation is done, its predefined kind, and that of the right operand.
    fn operand_type(&mut self, op: Op, x: &Expr, y: &Expr) -> Option<(Ty, Prim, Prim)> {
        let (xe, ye) = (self.sema.is_enum(x.ty), self.sema.is_enum(y.ty));
        if xe || ye {
            let ty = if xe { x.ty } else { y.ty };
            let prim = self.sema.enum_prim(ty)?;
            let same = xe && ye && x.ty == y.ty;
            let with_zero = |e: &Expr| matches!(e.kind, Kind::Const(Const::Int(0)));
            let fits = match op {
                Op::Add => {
                    xe != ye && (self.sema.prim(x.ty).or(self.sema.prim(y.ty))).is_some_and(Prim::is_integral)
                }
                Op::Sub => same || xe && self.sema.prim(y.ty).is_some_and(Prim::is_integral),
                Op::Eq | Op::Ne | Op::Lt | Op::Le | Op::Gt | Op::Ge | Op::And | Op::Or | Op::Xor => {
                    same || with_zero(x) || with_zero(y)
                }
                _ => false,
            };
            let number = self.prim_type(prim);
            return fits.then_some((number, prim, prim));
        }
        let (a, b) = (self.sema.prim(x.ty)?, self.sema.prim(y.ty)?);
        if a == Prim::Bool && b == Prim::Bool {
            let fits = matches!(op, Op::And | Op::Or | Op::Xor | Op::Eq | Op::Ne);
            return fits.then_some((x.ty, a, a));
        }
        if matches!(op, Op::Shl | Op::Shr) {
            let left = promoted(a, a).filter(|p| p.is_integral())?;
            return (b.is_integral() && b != Prim::U32 && b != Prim::I64 && b != Prim::U64).then(|| {
                let ty = self.prim_type(left);
                (ty, left, Prim::I32)
            });
        }
        // A constant takes the other's type where it fits: `ulong + 1`.
        let mut prim = promoted(a, b);
        if prim.is_none() || matches!((a, b), (Prim::U32, Prim::I32) | (Prim::I32, Prim::U32)) {
            for (constant, other) in [(x, y), (y, x)] {
                if self.constant_fits(constant, other.ty) {
                    prim = promoted(self.sema.prim(other.ty)?, self.sema.prim(other.ty)?);
                }
            }
        }
        let prim = prim?;
        if matches!(op, Op::And | Op::Or | Op::Xor) && !prim.is_integral() {
            return None;
        }
        let ty = self.prim_type(prim);
        Some((ty, prim, prim))
    }

    pub(super) fn numeric_operand(&mut self, value: Expr, ty: Ty) -> Option<Expr> {
        if value.ty == ty {
            return Some(value);
        }
        if self.constant_fits(&value, ty) {
            return Some(make(ty, value.pos, value.kind));
        }
        let conversion = self.sema.explicit(value.ty, ty)?;
        let outer = std::mem::replace(&mut self.checked, false);
        let made = self.apply(value, &conversion, ty);
        self.checked = outer;
        Some(made)
    }

    fn result_type(&mut self, op: Op, x: &Expr, y: &Expr, ty: Ty) -> Ty {
        if matches!(op, Op::Eq | Op::Ne | Op::Lt | Op::Le | Op::Gt | Op::Ge) {
            return self.sema.known.bool;
        }
        match (self.sema.is_enum(x.ty), self.sema.is_enum(y.ty)) {
            (true, true) if op == Op::Sub => ty,
            (true, _) => x.ty,
            (_, true) => y.ty,
            _ => ty,
        }
    }

    /// `&` and `|` of truth values that may be missing: one that decides is enough.
    fn three_valued(&mut self, pos: Pos, op: Op, x: &Expr, y: &Expr) -> Option<Expr> {
        let bool_ = self.sema.known.bool;
        let ty = self.sema.nullable(bool_);
        let method = self.function_of("__Nullable", if op == Op::And { "And" } else { "Or" })?;
        if [x, y].iter().any(|e| self.sema.implicit(e.ty, ty).is_none()) {
            return None;
        }
        let args = [x, y].map(|e| (Passing::Value, self.convert(Item::Value(e.clone()), ty, pos)));
        Some(make(ty, pos, Kind::Call(None, method, args.into(), false)))
    }

    fn lifted(
        &mut self,
        pos: Pos,
        op: Op,
        x: &Expr,
        y: &Expr,
        xn: Option<Ty>,
        yn: Option<Ty>,
    ) -> Option<Expr> {
        let (first, left) = self.held(xn.unwrap_or(x.ty), x.pos);
        let (_, right) = self.held(yn.unwrap_or(y.ty), y.pos);
        let mut left = left;
        let mut right = right;
        // A constant stays one, so that it takes the other's type.
        if matches!(x.kind, Kind::Const(_)) {
            left = x.clone()
        }
        if matches!(y.kind, Kind::Const(_)) {
            right = y.clone()
        }
        let inner = self.predefined(pos, op, &left, &right)?;
        let comparison = matches!(op, Op::Eq | Op::Ne | Op::Lt | Op::Le | Op::Gt | Op::Ge);
        let (ty, missing) = match op {
            // With both missing `==` holds; the emitter looks at that when the constant says so.
            Op::Eq => (inner.ty, Const::Bool(false)),
            Op::Ne => (inner.ty, Const::Bool(true)),
            _ if comparison => (inner.ty, Const::Bool(false)),
            _ => (self.sema.nullable(inner.ty), Const::Null),
        };
        let inner = if comparison { inner } else { self.retyped(inner, ty) };
        Some(make(
            ty,
            pos,
            Kind::Lifted(Box::new(x.clone()), Box::new(y.clone()), first, Box::new(inner), missing),
        ))
    }

    fn equality(&mut self, pos: Pos, op: BinaryOp, x: Expr, y: Expr) -> Expr {
        if let (Some(a), Some(b)) = (self.sema.tuple_parts(x.ty), self.sema.tuple_parts(y.ty))
            && a.len() == b.len()
        {
            return self.tuple_equality(pos, op, x, y, &a, &b);
        }
        let reference = |b: &Self, e: &Expr| {
            e.ty == Ty::NULL
                || b.sema.is_reference(e.ty)
                || b.sema.is_param(e.ty) && !b.sema.is_value_type(e.ty)
        };
        let related = x.ty == Ty::NULL
            || y.ty == Ty::NULL
            || self.sema.explicit(x.ty, y.ty).is_some()
            || self.sema.explicit(y.ty, x.ty).is_some();
        let params = self.sema.is_param(x.ty) && self.sema.is_param(y.ty) && !self.sema.is_reference(x.ty);
        if !reference(self, &x) || !reference(self, &y) || !related || params {
            return self.no_operator(pos, op, &x, &y);
        }
        self.same_object(pos, op, x, y)
    }

    fn same_object(&mut self, pos: Pos, op: BinaryOp, x: Expr, y: Expr) -> Expr {
        let bool_ = self.sema.known.bool;
        let equal = op == BinaryOp::Eq;
        if y.ty == Ty::NULL {
            return make(bool_, pos, Kind::IsNull(equal, Box::new(x)));
        }
        if x.ty == Ty::NULL {
            return make(bool_, pos, Kind::IsNull(equal, Box::new(y)));
        }
        if self.is_delegate(x.ty) && self.is_delegate(y.ty) {
            return self.same_delegate(pos, equal, x, y);
        }
        make(bool_, pos, Kind::SameObject(equal, Box::new(x), Box::new(y)))
    }

    fn tuple_equality(&mut self, pos: Pos, op: BinaryOp, x: Expr, y: Expr, a: &[Ty], b: &[Ty]) -> Expr {
        let (xn, xh) = self.held(x.ty, pos);
        let (yn, yh) = self.held(y.ty, pos);
        let mut all: Option<Expr> = None;
        for i in 0..a.len() {
            let left = self.tuple_element(xh.clone(), i, a[i]);
            let right = self.tuple_element(yh.clone(), i, b[i]);
            let one = self.binary_values(pos, op, left, right);
            all = Some(match all {
                None => one,
                Some(before) => {
                    let join = if op == BinaryOp::Eq { BinaryOp::AndAlso } else { BinaryOp::OrElse };
                    self.logical(pos, join, before, one)
                }
            });
        }
        let Some(all) = all else { return self.wrong(pos) };
        let ty = all.ty;
        let inner = make(ty, pos, Kind::Deconstruct(Box::new(y), yn, vec![all]));
        make(ty, pos, Kind::Deconstruct(Box::new(x), xn, vec![inner]))
    }

    fn concat(&mut self, pos: Pos, x: Expr, y: Expr) -> Expr {
        let string = self.sema.known.string;
        if let (Kind::Const(Const::Str(a)), Kind::Const(Const::Str(b))) = (&x.kind, &y.kind) {
            let joined: Vec<u16> = a.iter().chain(b.iter()).copied().collect();
            return make(string, pos, Kind::Const(Const::Str(joined.into())));
        }
        let mut parts = match x.kind {
            Kind::Concat(parts) => parts,
            _ => vec![self.as_text(x)],
        };
        parts.push(self.as_text(y));
        make(string, pos, Kind::Concat(parts))
    }

    /// The text of a value, empty where it is null.
    pub(super) fn as_text(&mut self, value: Expr) -> Expr {
        let string = self.sema.known.string;
        if value.ty == string {
            return value;
        }
        let pos = value.pos;
        make(string, pos, Kind::Text(Box::new(value)))
    }

    fn coalesce(&mut self, pos: Pos, a: &ast::Expr, b: &ast::Expr) -> Expr {
        let x = self.real_value(a);
        let item = self.item(b);
        if x.ty == Ty::ERROR {
            return x;
        }
        if let Some(inner) = self.sema.nullable_of(x.ty)
            && self.converts(&item, inner)
        {
            let y = self.convert(item, inner, b.pos);
            return make(inner, pos, Kind::Coalesce(Box::new(x), Box::new(y)));
        }
        if self.sema.is_value_type(x.ty) && self.sema.nullable_of(x.ty).is_none() {
            let shown = self.show(x.ty);
            let right = if let Item::Value(y) = &item { self.show(y.ty) } else { "?".to_owned() };
            return self.error(
                pos,
                19,
                format!("Operator '??' cannot be applied to operands of type '{shown}' and '{right}'"),
            );
        }
        if x.ty != Ty::NULL && self.converts(&item, x.ty) {
            let ty = x.ty;
            let y = self.convert(item, ty, b.pos);
            return make(ty, pos, Kind::Coalesce(Box::new(x), Box::new(y)));
        }
        let y = self.as_value(item, b.pos);
        let ty = y.ty;
        let x = self.convert(Item::Value(x), ty, a.pos);
        make(ty, pos, Kind::Coalesce(Box::new(x), Box::new(y)))
    }

    fn user_binary(&mut self, op: BinaryOp, x: &Expr, y: &Expr) -> Option<MethodRef> {
        let name = method_of(op);
        let mut candidates = Vec::new();
        for ty in [x.ty, y.ty] {
            let inner = self.sema.nullable_of(ty).unwrap_or(ty);
            for owner in self.sema.declaring(inner) {
                let Some(def) = self.sema.def_of(owner) else { continue };
                for member in self.sema.def(def).members.get(name).cloned().unwrap_or_default() {
                    if let Member::Method(id) = member
                        && !candidates.contains(&(owner, id))
                    {
                        candidates.push((owner, id));
                    }
                }
            }
        }
        if candidates.is_empty() {
            return None;
        }
        let (xt, yt) = (self.unwrapped(x), self.unwrapped(y));
        self.pick_operator(&candidates, &[xt, yt])
    }

    fn unwrapped(&mut self, e: &Expr) -> Expr {
        match self.sema.nullable_of(e.ty) {
            Some(inner) => make(inner, e.pos, Kind::Error),
            None => e.clone(),
        }
    }

    fn user_call(&mut self, pos: Pos, op: BinaryOp, method: MethodRef, x: Expr, y: Expr) -> Expr {
        let (xn, yn) = (self.sema.nullable_of(x.ty), self.sema.nullable_of(y.ty));
        let by = self.sema.substitution(method.owner);
        let takes: Vec<_> = self.sema.method(method.id).params.iter().map(|p| p.ty).collect();
        let takes: Vec<_> = takes.into_iter().map(|t| self.sema.types.substitute(t, &by)).collect();
        let takes_nullable = takes.iter().any(|t| self.sema.nullable_of(*t).is_some());
        if (xn.is_some() || yn.is_some()) && !takes_nullable {
            let (first, left) = self.held(xn.unwrap_or(x.ty), x.pos);
            let (_, right) = self.held(yn.unwrap_or(y.ty), y.pos);
            let inner = self.call_operator(pos, method, vec![left, right]);
            let (ty, missing) = match op {
                BinaryOp::Ne => (inner.ty, Const::Bool(true)),
                BinaryOp::Eq | BinaryOp::Lt | BinaryOp::Le | BinaryOp::Gt | BinaryOp::Ge => {
                    (inner.ty, Const::Bool(false))
                }
                _ => (self.sema.nullable(inner.ty), Const::Null),
            };
            let inner = self.retyped(inner, ty);
            return make(ty, pos, Kind::Lifted(Box::new(x), Box::new(y), first, Box::new(inner), missing));
        }
        self.call_operator(pos, method, vec![x, y])
    }

    /// The call of an operator's method, with arguments converted.
    pub(super) fn call_operator(&mut self, pos: Pos, method: MethodRef, args: Vec<Expr>) -> Expr {
        let by = self.sema.substitution(method.owner);
        let info = self.sema.method(method.id);
        let (params, ret): (Vec<_>, _) = (info.params.iter().map(|p| p.ty).collect(), info.ret);
        let ret = self.sema.types.substitute(ret, &by);
        let mut converted = Vec::new();
        for (arg, ty) in args.into_iter().zip(params) {
            let ty = self.sema.types.substitute(ty, &by);
            let at = arg.pos;
            converted.push((Passing::Value, self.convert(Item::Value(arg), ty, at)));
        }
        make(ret, pos, Kind::Call(None, method, converted, false))
    }
}
