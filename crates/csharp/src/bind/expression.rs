//! Expressions by their form.

use std::sync::Arc;

use super::{Binder, Item, LambdaSource, MAX_NESTING, MAX_WORK, make};
use crate::bound::{Const, Conv, Expr, Kind};
use crate::sema::{Conversion, Prim, Ty};
use crate::source::Pos;
use crate::syntax::ast::{self, Designation, ExprKind, IntSuffix, Lit, TypeRefKind};

impl Binder<'_> {
    /// An expression that has a value.
    pub(super) fn value(&mut self, e: &ast::Expr) -> Expr {
        let item = self.item(e);
        self.as_value(item, e.pos)
    }

    pub(super) fn as_value(&mut self, item: Item, pos: Pos) -> Expr {
        match item {
            Item::Value(value) => {
                if value.ty == Ty::VOID {
                    return value;
                }
                value
            }
            Item::Type(ty) => {
                let shown = self.show(ty);
                self.error(pos, 119, format!("'{shown}' is a type, which is not valid in the given context"))
            }
            Item::Namespace(name) => {
                self.error(pos, 118, format!("'{name}' is a namespace but is used like a variable"))
            }
            Item::Methods(group) => self.error(
                pos,
                428,
                format!("Cannot convert method group '{}' to non-delegate type. Did you intend to invoke the method?", group.name),
            ),
            Item::Lambda(pos, _) => self.error(pos, 1660, "Cannot convert lambda expression to a type because it is not a delegate type"),
            Item::Default(pos) => self.error(pos, 8716, "There is no target type for the default literal."),
            Item::OutVar(pos, _) => self.error(pos, 8197, "Cannot infer the type of implicitly-typed out variable."),
            Item::New(pos, _) => self.error(pos, 8754, "There is no target type for 'new(...)'"),
            Item::Throw(value) => {
                self.error(value.pos, 8115, "A throw expression is not allowed in this context.")
            }
            Item::Tuple(pos, parts) => self.natural_tuple(pos, parts),
            Item::Untyped(pos, _) => self.error(pos, 173, "Type of conditional expression cannot be determined because there is no implicit conversion between the branches"),
        }
    }

    /// An expression that must be a value and not `void`.
    pub(super) fn real_value(&mut self, e: &ast::Expr) -> Expr {
        let value = self.value(e);
        if value.ty == Ty::VOID {
            return self.error(e.pos, 815, "Cannot assign void to an implicitly-typed variable");
        }
        value
    }

    pub(super) fn item(&mut self, e: &ast::Expr) -> Item {
        self.work += 1;
        if self.work > MAX_WORK || self.nesting > MAX_NESTING {
            if self.work != u32::MAX {
                self.fault(e.pos, 8078, "An expression is too long or complex to compile");
                self.work = u32::MAX - 1_000_000;
            }
            return Item::Value(self.wrong(e.pos));
        }
        self.nesting += 1;
        let item = self.item_of(e);
        self.nesting -= 1;
        item
    }

    fn item_of(&mut self, e: &ast::Expr) -> Item {
        let pos = e.pos;
        match &e.kind {
            ExprKind::Name(part) => return self.name(part),
            ExprKind::Member(left, part) => return self.member(left, part),
            ExprKind::Call(callee, args) => return Item::Value(self.call(pos, callee, args)),
            ExprKind::Bracketed(inner) => return self.item(inner),
            ExprKind::Type(ty) => return Item::Type(self.resolve(ty)),
            ExprKind::Lambda(params, body) => {
                return Item::Lambda(
                    pos,
                    Arc::new(LambdaSource { params: params.clone(), body: body.clone() }),
                );
            }
            ExprKind::Default(None) => return Item::Default(pos),
            ExprKind::New(None, args, init) => return Item::New(pos, Arc::new((args.clone(), init.clone()))),
            ExprKind::Ref(_) => {
                let message =
                    "A reference to a variable stands only behind 'return', '=>' or the '=' of a reference";
                return Item::Value(self.error(pos, 1525, message));
            }
            ExprKind::Throw(inner) => return Item::Throw(self.throw_value(inner)),
            ExprKind::Tuple(parts) => return self.tuple_item(pos, parts),
            ExprKind::Choice(c, a, b) => return self.choice(e, c, a, b),
            ExprKind::Switch(subject, arms) => return self.switch_expression(e, subject, arms),
            ExprKind::Declare(ty, names) => return self.declared_out(pos, ty, names),
            _ => {}
        }
        Item::Value(self.value_of(e))
    }

    fn value_of(&mut self, e: &ast::Expr) -> Expr {
        let pos = e.pos;
        match &e.kind {
            ExprKind::Lit(lit) => self.literal(pos, lit),
            ExprKind::Interpolated(pieces) => self.interpolated(pos, pieces),
            ExprKind::Conditional(receiver, chain) => self.conditional_access(pos, receiver, chain),
            ExprKind::Receiver => self.receivers.last().cloned().unwrap_or_else(|| self.wrong(pos)),
            ExprKind::Index(left, args) => self.index(pos, left, args),
            ExprKind::New(Some(ty), args, init) => {
                let ty = self.resolve(ty);
                self.creation(pos, ty, args, init.as_ref())
            }
            ExprKind::NewArray(element, sizes, rank, init) => {
                self.new_array(pos, element.as_ref(), sizes, *rank, init.as_deref())
            }
            ExprKind::ArrayInit(_) => {
                self.error(pos, 622, "Can only use array initializer expressions to assign to array types. Try using a new expression instead.")
            }
            ExprKind::Anonymous(members) => self.anonymous(pos, members),
            ExprKind::Unary(op, inner) => {
                // The least whole number is written as minus one that does not fit alone.
                if *op == ast::UnaryOp::Minus
                    && let ExprKind::Lit(Lit::Int(value, suffix)) = &inner.kind
                {
                    match (value, suffix) {
                        (0x8000_0000, IntSuffix::None) => {
                            return make(self.sema.known.int, pos, Kind::Const(Const::Int(i32::MIN.into())));
                        }
                        (0x8000_0000_0000_0000, IntSuffix::None | IntSuffix::L) => {
                            return make(self.sema.known.long, pos, Kind::Const(Const::Int(i64::MIN.into())));
                        }
                        _ => {}
                    }
                }
                let operand = self.value(inner);
                self.unary(pos, *op, operand)
            }
            ExprKind::Step(by, post, target) => self.step(pos, *by, *post, target),
            ExprKind::Binary(op, a, b) => self.binary(pos, *op, a, b),
            ExprKind::Assign(op, target, value) => self.assign(pos, *op, target, value),
            ExprKind::Is(value, pattern) => self.is(pos, value, pattern),
            ExprKind::As(value, ty) => self.as_type(pos, value, ty),
            ExprKind::Cast(ty, value) => {
                let ty = self.resolve(ty);
                let item = self.item(value);
                self.cast(pos, item, ty)
            }
            ExprKind::TypeOf(ty) => {
                let ty = self.resolve(ty);
                make(self.sema.known.type_, pos, Kind::TypeOf(ty))
            }
            ExprKind::SizeOf(ty) => self.size_of(pos, ty),
            ExprKind::Default(Some(ty)) => {
                let ty = self.resolve(ty);
                make(ty, pos, Kind::Default(ty))
            }
            ExprKind::NameOf(name) => {
                let units: Arc<[u16]> = name.encode_utf16().collect();
                make(self.sema.known.string, pos, Kind::Const(Const::Str(units)))
            }
            ExprKind::Checked(on, inner) => {
                let outer = (self.checked, self.unchecked);
                (self.checked, self.unchecked) = (*on, !*on);
                let value = self.value(inner);
                (self.checked, self.unchecked) = outer;
                value
            }
            ExprKind::This => self.this(pos),
            ExprKind::Base => self.error(pos, 175, "Use of keyword 'base' is not valid in this context"),
            _ => self.wrong(pos),
        }
    }

    pub(super) fn this(&mut self, pos: Pos) -> Expr {
        if self.is_static {
            return self.error(pos, 26, "Keyword 'this' is not valid in a static property, static method, or static field initializer");
        }
        if self.functions.len() > 1 {
            self.captures_this = true;
        }
        make(self.this, pos, Kind::This)
    }

    fn literal(&mut self, pos: Pos, lit: &Lit) -> Expr {
        let known = self.sema.known;
        let (ty, value) = match lit {
            Lit::Null => (Ty::NULL, Const::Null),
            Lit::Bool(b) => (known.bool, Const::Bool(*b)),
            Lit::Char(c) => (known.char, Const::Int((*c).into())),
            Lit::Str(units) => (known.string, Const::Str(units.clone())),
            Lit::Double(x) => (known.double, Const::Double(*x)),
            Lit::Float(x) => (known.float, Const::Float(*x)),
            Lit::Decimal(text) => match crate::decimal::read(text, true) {
                Ok(x) => (known.decimal, Const::Decimal(x)),
                Err(_) => {
                    let message = "Floating-point constant is outside the range of type 'decimal'";
                    return self.error(pos, 594, message);
                }
            },
            Lit::Int(value, suffix) => {
                let small = *value <= i32::MAX as u64;
                let ty = match suffix {
                    IntSuffix::None if small => known.int,
                    IntSuffix::None | IntSuffix::U if *value <= u32::MAX.into() => known.uint,
                    IntSuffix::None | IntSuffix::L if *value <= i64::MAX as u64 => known.long,
                    _ => known.ulong,
                };
                (ty, Const::Int((*value).into()))
            }
        };
        make(ty, pos, Kind::Const(value))
    }

    fn throw_value(&mut self, inner: &ast::Expr) -> Expr {
        let value = self.real_value(inner);
        let exception = self.sema.known.exception;
        let value = self.convert(Item::Value(value), exception, inner.pos);
        make(Ty::NONE, inner.pos, Kind::Throw(Box::new(value)))
    }

    fn size_of(&mut self, pos: Pos, ty: &ast::TypeRef) -> Expr {
        let ty = self.resolve(ty);
        let size = match self.sema.underlying(ty) {
            Some(Prim::Bool | Prim::I8 | Prim::U8) => 1,
            Some(Prim::Char | Prim::I16 | Prim::U16) => 2,
            Some(Prim::I32 | Prim::U32 | Prim::F32) => 4,
            Some(Prim::I64 | Prim::U64 | Prim::F64) => 8,
            Some(Prim::Decimal) => 16,
            None => return self.error(pos, 233, format!("'{}' does not have a predefined size, therefore sizeof can only be used in an unsafe context", self.show(ty))),
        };
        make(self.sema.known.int, pos, Kind::Const(Const::Int(size)))
    }

    fn declared_out(&mut self, pos: Pos, ty: &ast::TypeRef, names: &Designation) -> Item {
        let (at, name) = match names {
            Designation::Name(at, name) => (*at, Some(name.clone())),
            Designation::Discard(at) => (*at, None),
            Designation::Several(..) => {
                return Item::Value(self.error(pos, 8185, "A declaration is not allowed in this context."));
            }
        };
        if matches!(ty.kind, TypeRefKind::Var) {
            return Item::OutVar(at, name);
        }
        let ty = self.resolve(ty);
        let local = match name {
            Some(name) => self.declare(at, &name, ty, ast::Passing::Value),
            None => self.new_local("_", ty, ast::Passing::Value),
        };
        Item::Value(self.local(local, at))
    }

    fn choice(&mut self, e: &ast::Expr, c: &ast::Expr, a: &ast::Expr, b: &ast::Expr) -> Item {
        let faults = self.sema.faults.len();
        let condition = self.condition(c);
        let yes = self.item(a);
        let no = self.item(b);
        if self.sema.faults.len() > faults {
            return Item::Value(self.wrong(e.pos));
        }
        let Some(ty) = self.common_type(&[yes.clone(), no.clone()]) else {
            // It may still fit where a type is expected.
            return match (&yes, &no) {
                (Item::Value(x), Item::Value(y)) if x.ty != Ty::NULL && y.ty != Ty::NULL => {
                    let (x, y) = (self.show(x.ty), self.show(y.ty));
                    Item::Value(self.error(e.pos, 173, format!("Type of conditional expression cannot be determined because there is no implicit conversion between '{x}' and '{y}'")))
                }
                _ => Item::Untyped(e.pos, Arc::new(e.clone())),
            };
        };
        Item::Value(self.choice_of(e.pos, condition, (yes, a.pos), (no, b.pos), ty))
    }

    pub(super) fn choice_of(&mut self, pos: Pos, c: Expr, yes: (Item, Pos), no: (Item, Pos), ty: Ty) -> Expr {
        let yes = self.convert(yes.0, ty, yes.1);
        let no = self.convert(no.0, ty, no.1);
        if let Kind::Const(Const::Bool(which)) = c.kind
            && matches!((&yes.kind, &no.kind), (Kind::Const(_), Kind::Const(_)))
        {
            return if which { yes } else { no };
        }
        make(ty, pos, Kind::Choice(Box::new(c), Box::new(yes), Box::new(no)))
    }

    /// The type of some of the items that all others convert to.
    pub(super) fn common_type(&mut self, items: &[Item]) -> Option<Ty> {
        let mut candidates = Vec::new();
        for item in items {
            if let Item::Value(value) = item {
                if value.ty == Ty::ERROR {
                    return Some(Ty::ERROR);
                }
                if value.ty != Ty::NULL
                    && value.ty != Ty::NONE
                    && value.ty != Ty::VOID
                    && !candidates.contains(&value.ty)
                {
                    candidates.push(value.ty);
                }
            } else if let Item::Tuple(pos, parts) = item {
                let parts = parts.clone();
                let tuple = self.speculate(|b| b.natural_tuple(*pos, parts));
                if let Some(tuple) = tuple {
                    candidates.push(tuple.ty);
                }
            }
        }
        candidates.into_iter().find(|ty| items.iter().all(|item| self.converts(item, *ty)))
    }

    pub(super) fn condition(&mut self, e: &ast::Expr) -> Expr {
        let value = self.real_value(e);
        self.truth(value)
    }

    /// A value as a truth value.
    pub(super) fn truth(&mut self, value: Expr) -> Expr {
        let bool_ = self.sema.known.bool;
        let pos = value.pos;
        if value.ty == bool_ || value.ty == Ty::ERROR {
            return value;
        }
        if self.sema.implicit(value.ty, bool_).is_none()
            && let Some(method) = self.user_unary("op_True", value.ty)
        {
            return self.call_operator(pos, method, vec![value]);
        }
        self.convert(Item::Value(value), bool_, pos)
    }

    fn as_type(&mut self, pos: Pos, value: &ast::Expr, ty: &ast::TypeRef) -> Expr {
        let value = self.real_value(value);
        let ty = self.resolve(ty);
        if value.ty == Ty::ERROR || ty == Ty::ERROR {
            return self.wrong(pos);
        }
        if self.sema.is_value_type(ty) && self.sema.nullable_of(ty).is_none() {
            let shown = self.show(ty);
            return self.error(pos, 77, format!("The as operator must be used with a reference type or nullable type ('{shown}' is a non-nullable value type)"));
        }
        if value.ty != Ty::DYNAMIC
            && value.ty != Ty::NULL
            && self.sema.explicit(value.ty, ty).is_none_or(|c| matches!(c, Conversion::User(_)))
        {
            let (from, to) = (self.show(value.ty), self.show(ty));
            return self.error(pos, 39, format!("Cannot convert type '{from}' to '{to}' via a reference conversion, boxing conversion, unboxing conversion, wrapping conversion, or null type conversion"));
        }
        if self.sema.is_param(ty) && !self.sema.is_reference(ty) {
            let shown = self.show(ty);
            let message = format!(
                "The type parameter '{shown}' cannot be used with the 'as' operator because it does not have a class type constraint nor a 'class' constraint"
            );
            return self.error(pos, 413, message);
        }
        make(ty, pos, Kind::As(Box::new(value), ty))
    }

    /// A value that is known to be of another type.
    pub(super) fn retyped(&self, value: Expr, ty: Ty) -> Expr {
        if value.ty == ty {
            return value;
        }
        let pos = value.pos;
        make(ty, pos, Kind::Convert(Conv::Same, Box::new(value)))
    }
}
