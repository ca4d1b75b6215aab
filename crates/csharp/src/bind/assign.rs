//! Assignments and steps.

use super::{Binder, Item, make};
use crate::bound::{Const, DynamicOp, Expr, Kind};
use crate::sema::{Conversion, Prim, Ty};
use crate::source::Pos;
use crate::syntax::ast::{self, BinaryOp, ExprKind, Passing};

impl Binder<'_> {
    pub(super) fn assign(
        &mut self,
        pos: Pos,
        op: Option<BinaryOp>,
        target: &ast::Expr,
        value: &ast::Expr,
    ) -> Expr {
        if op.is_none() && matches!(target.kind, ExprKind::Tuple(_) | ExprKind::Declare(..)) {
            return self.deconstruct(pos, target, value);
        }
        if let ExprKind::Name(part) = &target.kind
            && &*part.name == "_"
            && self.find(&part.name).is_none()
        {
            let item = self.item(value);
            let made = self.as_value(item, value.pos);
            let ty = made.ty;
            let (number, held) = self.held(ty, pos);
            return make(ty, pos, Kind::Deconstruct(Box::new(made), number, vec![held]));
        }
        let outer =
            std::mem::replace(&mut self.subscribing, matches!(op, Some(BinaryOp::Add | BinaryOp::Sub)));
        let place = self.value(target);
        self.subscribing = outer;
        match op {
            None => {
                if let ExprKind::ArrayInit(values) = &value.kind {
                    let ty = place.ty;
                    let array = self.array_of(value.pos, ty, values, &[]);
                    return self.assign_to(pos, place, Item::Value(array), value.pos);
                }
                let item = self.item(value);
                self.assign_to(pos, place, item, value.pos)
            }
            Some(op) => self.compound(pos, op, place, value),
        }
    }

    /// An assignment of an item to a place.
    pub(super) fn assign_to(&mut self, pos: Pos, place: Expr, item: Item, at: Pos) -> Expr {
        if place.ty == Ty::ERROR {
            if !matches!(item, Item::Lambda(..) | Item::Untyped(..)) {
                let _ = self.speculate(|b| b.as_value(item, at));
            }
            return place;
        }
        if let Kind::Dynamic(op, mut operands) = place.kind {
            let value = self.as_value(item, at);
            operands.push(value);
            let op = match op {
                DynamicOp::Get(name) => DynamicOp::Set(name),
                DynamicOp::Index => DynamicOp::SetIndex,
                _ => {
                    return self.error(
                        pos,
                        131,
                        "The left-hand side of an assignment must be a variable, property or indexer",
                    );
                }
            };
            return make(Ty::DYNAMIC, pos, Kind::Dynamic(op, operands));
        }
        if !self.check_place(pos, &place, true) {
            return self.wrong(pos);
        }
        let ty = place.ty;
        let value = self.convert(item, ty, at);
        if value.ty == Ty::ERROR {
            return value;
        }
        make(ty, pos, Kind::Assign(Box::new(place), Box::new(value)))
    }

    /// Whether something can be assigned to; a fault when not.
    pub(super) fn check_place(&mut self, pos: Pos, place: &Expr, _write: bool) -> bool {
        match &place.kind {
            Kind::Local(id) => {
                if self.locals.get(id.0 as usize).is_some_and(|l| l.passing == Passing::In) {
                    let name = self.locals[id.0 as usize].name.clone();
                    self.fault(
                        pos,
                        8331,
                        format!("Cannot assign to variable '{name}' because it is a readonly variable"),
                    );
                    return false;
                }
                if self.readonly_locals.contains(id) {
                    let name = self.locals[id.0 as usize].name.clone();
                    self.fault(
                        pos,
                        1656,
                        format!("Cannot assign to '{name}' because it is a 'foreach iteration variable'"),
                    );
                    return false;
                }
                true
            }
            Kind::Element(..) | Kind::Held(_) | Kind::Deref(_) => true,
            Kind::This if self.sema.is_value_type(self.this) => true,
            Kind::Field(receiver, field) => {
                let info = self.sema.field(field.id);
                let inside = self.constructor && info.owner == self.def;
                if info.readonly && !inside {
                    self.fault(pos, 191, "A readonly field cannot be assigned to (except in a constructor or a variable initializer)");
                    return false;
                }
                match receiver {
                    Some(receiver) => self.check_struct_part(pos, receiver),
                    None => true,
                }
            }
            Kind::Prop(receiver, _, _, setter, _) => {
                let Some(setter) = setter else {
                    if let Some(field) = self.automatic_field(place) {
                        let _ = field;
                        return true;
                    }
                    let name = self.prop_name(place);
                    self.fault(
                        pos,
                        200,
                        format!("Property or indexer '{name}' cannot be assigned to -- it is read only"),
                    );
                    return false;
                };
                let id = setter.id;
                let access = (self.sema.method(id).owner, self.sema.method(id).access);
                if !self.sema.may_use(Some(self.def), access.0, access.1) {
                    let name = self.prop_name(place);
                    self.fault(pos, 272, format!("The property or indexer '{name}' cannot be used in this context because the set accessor is inaccessible"));
                    return false;
                }
                match receiver {
                    Some(receiver) => self.check_struct_part(pos, receiver),
                    None => true,
                }
            }
            Kind::Error => false,
            _ => {
                self.fault(
                    pos,
                    131,
                    "The left-hand side of an assignment must be a variable, property or indexer",
                );
                false
            }
        }
    }

    /// The field of a property that only its own constructor sets.
    fn automatic_field(&self, place: &Expr) -> Option<crate::sema::FieldId> {
        let Kind::Prop(_, _, Some(getter), None, _) = &place.kind else { return None };
        let info = self.sema.method(getter.id);
        match info.body {
            crate::sema::Body::Auto(field, _) if self.constructor && info.owner == self.def => Some(field),
            _ => None,
        }
    }

    fn prop_name(&self, place: &Expr) -> String {
        let Kind::Prop(_, _, getter, setter, _) = &place.kind else { return String::new() };
        let Some(method) = getter.as_ref().or(setter.as_ref()) else { return String::new() };
        let info = self.sema.method(method.id);
        format!("{}.{}", self.sema.def(info.owner).name, &info.name[4..])
    }

    /// A part of a struct is set in place: the struct must be a variable.
    fn check_struct_part(&mut self, pos: Pos, receiver: &Expr) -> bool {
        if !self.sema.is_struct(receiver.ty) {
            return true;
        }
        match &receiver.kind {
            Kind::Prop(..) | Kind::Call(..) | Kind::Invoke(..) => {
                self.fault(pos, 1612, "Cannot modify the return value because it is not a variable");
                false
            }
            Kind::Local(id) if self.readonly_locals.contains(id) => {
                let name = self.locals[id.0 as usize].name.clone();
                self.fault(
                    pos,
                    1654,
                    format!("Cannot modify members of '{name}' because it is a 'foreach iteration variable'"),
                );
                false
            }
            Kind::Field(inner, field) => {
                let info = self.sema.field(field.id);
                if info.readonly && !(self.constructor && info.owner == self.def) {
                    self.fault(pos, 1648, "Members of a readonly field cannot be modified (except in a constructor or a variable initializer)");
                    return false;
                }
                inner.as_ref().is_none_or(|inner| self.check_struct_part(pos, inner))
            }
            _ => true,
        }
    }

    /// A variable that is handed over by reference.
    pub(super) fn variable(&mut self, passing: Passing, place: Expr) -> Expr {
        let fits = matches!(
            place.kind,
            Kind::Local(_) | Kind::Element(..) | Kind::Field(..) | Kind::Deref(_) | Kind::Error | Kind::This
        );
        if !fits {
            let pos = place.pos;
            let (code, message) = match place.kind {
                Kind::Prop(..) => (206, "A property or indexer may not be passed as an out or ref parameter"),
                _ => (1510, "A ref or out value must be an assignable variable"),
            };
            return self.error(pos, code, message);
        }
        let _ = passing;
        let pos = place.pos;
        if self.check_place(pos, &place, true) { place } else { self.wrong(pos) }
    }

    fn compound(&mut self, pos: Pos, op: BinaryOp, place: Expr, value: &ast::Expr) -> Expr {
        if place.ty == Ty::ERROR {
            return place;
        }
        if let Kind::Dynamic(..) = place.kind {
            let right = self.real_value(value);
            let sum = self.binary_values(pos, op, place.clone(), right);
            return self.assign_to(pos, place, Item::Value(sum), value.pos);
        }
        let delegate = self.delegate_operand(op, place.ty, value);
        if let Some(right) = &delegate
            && let Some(call) = self.subscribe(pos, op, &place, right.clone())
        {
            return call;
        }
        if !self.check_place(pos, &place, true) {
            return self.wrong(pos);
        }
        let ty = place.ty;
        let (number, held) = self.held(ty, pos);
        if let Some(right) = delegate {
            let made = self.binary_values(pos, op, held, right);
            return make(ty, pos, Kind::Update(Box::new(place), number, Box::new(made), false));
        }
        if op == BinaryOp::Coalesce {
            let item = self.item(value);
            let inner = self.sema.nullable_of(ty).unwrap_or(ty);
            let right = self.convert(item, inner, value.pos);
            let right = self.retyped(right, ty);
            let made = make(ty, pos, Kind::Coalesce(Box::new(held), Box::new(right)));
            return make(ty, pos, Kind::Update(Box::new(place), number, Box::new(made), false));
        }
        let right = self.real_value(value);
        let narrow = self.sema.implicit(right.ty, ty).is_some() || self.constant_fits(&right, ty);
        let made = self.binary_values(pos, op, held, right);
        let made = self.back_to(pos, made, ty, narrow || matches!(op, BinaryOp::Shl | BinaryOp::Shr));
        make(ty, pos, Kind::Update(Box::new(place), number, Box::new(made), false))
    }

    /// The result of a compound operator goes back into its variable, by a cast if the operand fits it.
    fn back_to(&mut self, pos: Pos, made: Expr, ty: Ty, narrow: bool) -> Expr {
        if made.ty == Ty::ERROR || self.sema.implicit(made.ty, ty).is_some() || !narrow {
            return self.convert(Item::Value(made), ty, pos);
        }
        match self.sema.explicit(made.ty, ty) {
            Some(conversion @ (Conversion::Numeric(..) | Conversion::Enum | Conversion::Lifted(_))) => {
                self.apply(made, &conversion, ty)
            }
            _ => self.convert(Item::Value(made), ty, pos),
        }
    }

    /// `++` and `--`
    pub(super) fn step(&mut self, pos: Pos, by: i8, post: bool, target: &ast::Expr) -> Expr {
        let place = self.value(target);
        if place.ty == Ty::ERROR {
            return place;
        }
        if let Kind::Dynamic(..) = place.kind {
            let one = make(self.sema.known.int, pos, Kind::Const(Const::Int(i128::from(by))));
            let sum = self.binary_values(pos, BinaryOp::Add, place.clone(), one);
            return self.assign_to(pos, place, Item::Value(sum), pos);
        }
        if !self.check_step_place(pos, &place) {
            return self.wrong(pos);
        }
        let ty = place.ty;
        let (number, held) = self.held(ty, pos);
        let made = if ty == Ty::DYNAMIC {
            let one = make(self.sema.known.int, pos, Kind::Const(Const::Int(i128::from(by))));
            self.binary_values(pos, BinaryOp::Add, held, one)
        } else {
            self.stepped(pos, by, held)
        };
        make(ty, pos, Kind::Update(Box::new(place), number, Box::new(made), post))
    }

    fn check_step_place(&mut self, pos: Pos, place: &Expr) -> bool {
        if matches!(place.kind, Kind::Const(_) | Kind::Binary(..) | Kind::Call(..) | Kind::Invoke(..)) {
            self.fault(
                pos,
                1059,
                "The operand of an increment or decrement operator must be a variable, property or indexer",
            );
            return false;
        }
        self.check_place(pos, place, true)
    }

    fn stepped(&mut self, pos: Pos, by: i8, held: Expr) -> Expr {
        let ty = held.ty;
        let name = if by > 0 { "op_Increment" } else { "op_Decrement" };
        if let Some(method) = self.user_unary(name, ty) {
            return self.call_operator(pos, method, vec![held]);
        }
        if let Some(inner) = self.sema.nullable_of(ty) {
            let (number, there) = self.held(inner, pos);
            let made = self.stepped(pos, by, there);
            let made = self.retyped(made, ty);
            return make(ty, pos, Kind::Conditional(Box::new(held), number, Box::new(made)));
        }
        let Some(prim) = self.sema.underlying(ty).filter(|p| p.is_numeric()) else {
            let shown = self.show(ty);
            let symbol = if by > 0 { "++" } else { "--" };
            return self.error(
                pos,
                23,
                format!("Operator '{symbol}' cannot be applied to operand of type '{shown}'"),
            );
        };
        let wide = match prim {
            Prim::Bool | Prim::Char | Prim::I8 | Prim::U8 | Prim::I16 | Prim::U16 => Prim::I32,
            other => other,
        };
        let number = self.prim_type(wide);
        let one = match wide {
            Prim::F64 => Const::Double(1.0),
            Prim::F32 => Const::Float(1.0),
            Prim::Decimal => Const::Decimal(crate::decimal::of_whole(1)),
            _ => Const::Int(1),
        };
        let one = make(number, pos, Kind::Const(one));
        let Some(conversion) = self.sema.explicit(ty, number) else { return self.wrong(pos) };
        let left = self.apply(held, &conversion, number);
        let op = if by > 0 { BinaryOp::Add } else { BinaryOp::Sub };
        let made = self.binary_values(pos, op, left, one);
        match self.sema.explicit(made.ty, ty) {
            Some(conversion) => self.apply(made, &conversion, ty),
            None => self.wrong(pos),
        }
    }
}
