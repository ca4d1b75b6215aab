//! Items to values of a type.

use super::{Binder, Item, make};
use crate::bound::{Const, Conv, Expr, Kind};
use crate::sema::{Conversion, Prim, Ty, UserConversion};
use crate::source::Pos;
use crate::syntax::ast::Passing;

impl Binder<'_> {
    /// Whether an item converts to a type without a cast.
    pub(super) fn converts(&mut self, item: &Item, to: Ty) -> bool {
        match item {
            Item::Value(value) => {
                value.ty == Ty::ERROR
                    || self.sema.implicit(value.ty, to).is_some()
                    || self.constant_fits(value, to)
            }
            Item::Lambda(pos, source) => {
                let source = source.clone();
                let pos = *pos;
                self.speculate(|b| b.lambda_as(pos, &source, to)).is_some()
            }
            Item::Methods(group) => {
                let group = group.clone();
                self.speculate(|b| b.group_as(&group, to)).is_some()
            }
            Item::Default(_) | Item::Throw(_) | Item::OutVar(..) => true,
            Item::New(pos, source) => {
                let (pos, source) = (*pos, source.clone());
                self.speculate(|b| b.creation(pos, to, &source.0, source.1.as_ref())).is_some()
            }
            Item::Tuple(_, parts) => {
                let Some(types) = self.sema.tuple_parts(to) else {
                    let object = self.sema.known.object;
                    return to == object || to == Ty::DYNAMIC || to == self.sema.known.value_type;
                };
                types.len() == parts.len()
                    && parts.iter().zip(types).all(|((_, part), ty)| self.converts(part, ty))
            }
            Item::Untyped(_, e) => {
                let e = e.clone();
                self.speculate(|b| b.untyped(&e, to)).is_some()
            }
            Item::Type(_) | Item::Namespace(_) => false,
        }
    }

    /// Whether a constant fits a smaller type, or zero an enum.
    pub(super) fn constant_fits(&self, value: &Expr, to: Ty) -> bool {
        let Kind::Const(Const::Int(n)) = &value.kind else { return false };
        let to = self.sema.nullable_of(to).unwrap_or(to);
        if self.sema.is_enum(to) {
            return *n == 0 && self.sema.prim(value.ty).is_some_and(|p| p != Prim::Char);
        }
        let (Some(from), Some(target)) = (self.sema.prim(value.ty), self.sema.prim(to)) else { return false };
        let (least, most) = target.range();
        target.is_integral()
            && target != Prim::Char
            && (from == Prim::I32 || from == Prim::I64 && target == Prim::U64)
            && (least..=most).contains(n)
    }

    /// An item as a value of a type; a fault when it does not convert by itself.
    pub(super) fn convert(&mut self, item: Item, to: Ty, pos: Pos) -> Expr {
        if to == Ty::ERROR {
            return self.wrong(pos);
        }
        let value = match item {
            Item::Value(value) => value,
            Item::Lambda(at, source) => return self.lambda_as(at, &source, to),
            Item::Methods(group) => return self.group_as(&group, to),
            Item::Default(at) => return make(to, at, Kind::Default(to)),
            Item::New(at, source) => return self.creation(at, to, &source.0, source.1.as_ref()),
            Item::Throw(mut value) => {
                value.ty = to;
                return value;
            }
            Item::OutVar(at, name) => {
                let local = match name {
                    Some(name) => self.declare(at, &name, to, Passing::Value),
                    None => self.new_local("_", to, Passing::Value),
                };
                return self.local(local, at);
            }
            Item::Tuple(at, parts) => return self.tuple_as(at, parts, to),
            Item::Untyped(_, e) => return self.untyped(&e, to),
            other => self.as_value(other, pos),
        };
        if value.ty == Ty::ERROR {
            return value;
        }
        if self.constant_fits(&value, to) {
            return self.constant_as(value, to);
        }
        match self.sema.implicit(value.ty, to) {
            Some(conversion) => self.apply(value, &conversion, to),
            None => {
                if let Kind::Const(Const::Int(n)) = value.kind
                    && self.sema.prim(value.ty) == Some(Prim::I32)
                    && self.sema.prim(to).is_some_and(|p| p.is_integral() && p != Prim::Char)
                {
                    let shown = self.show(to);
                    return self.error(
                        pos,
                        31,
                        format!("Constant value '{n}' cannot be converted to a '{shown}'"),
                    );
                }
                if let (Kind::Const(Const::Double(_)), Some(prim @ (Prim::F32 | Prim::Decimal))) =
                    (&value.kind, self.sema.prim(to))
                {
                    let (shown, suffix) = (self.show(to), if prim == Prim::F32 { 'F' } else { 'M' });
                    return self.error(pos, 664, format!("Literal of type double cannot be implicitly converted to type '{shown}'; use an '{suffix}' suffix to create a literal of this type"));
                }
                self.no_conversion(pos, value.ty, to)
            }
        }
    }

    fn no_conversion(&mut self, pos: Pos, from: Ty, to: Ty) -> Expr {
        if from == Ty::NULL && self.sema.is_param(to) {
            let to = self.show(to);
            let message = format!(
                "Cannot convert null to type parameter '{to}' because it could be a non-nullable value type. Consider using 'default({to})' instead."
            );
            return self.error(pos, 403, message);
        }
        if from == Ty::NULL {
            let to = self.show(to);
            return self.error(
                pos,
                37,
                format!("Cannot convert null to '{to}' because it is a non-nullable value type"),
            );
        }
        let exists = from != Ty::VOID && self.sema.explicit(from, to).is_some();
        let (from, to) = (self.show(from), self.show(to));
        if exists {
            self.error(pos, 266, format!("Cannot implicitly convert type '{from}' to '{to}'. An explicit conversion exists (are you missing a cast?)"))
        } else {
            self.error(pos, 29, format!("Cannot implicitly convert type '{from}' to '{to}'"))
        }
    }

    fn constant_as(&mut self, value: Expr, to: Ty) -> Expr {
        let inner = self.sema.nullable_of(to).unwrap_or(to);
        let made = make(inner, value.pos, value.kind);
        self.retyped(made, to)
    }

    /// A value through a conversion.
    pub(super) fn apply(&mut self, value: Expr, conversion: &Conversion, to: Ty) -> Expr {
        let pos = value.pos;
        let checked = self.checked;
        let conv = |conv, value| make(to, pos, Kind::Convert(conv, Box::new(value)));
        match conversion {
            Conversion::Identity | Conversion::Box | Conversion::Up => self.retyped(value, to),
            Conversion::Null => make(to, pos, Kind::Const(Const::Null)),
            Conversion::Numeric(a, b) => match self.fold_number(&value, *b, checked) {
                Some(folded) => make(to, pos, Kind::Const(folded)),
                None => conv(Conv::Number(*a, *b, checked), value),
            },
            Conversion::Enum => self.enum_conversion(value, to),
            Conversion::Down => conv(Conv::Cast, value),
            Conversion::Dynamic => self.dynamic_as(pos, value, to),
            Conversion::ToNullable(inner) => {
                let target = self.sema.nullable_of(to).unwrap_or(to);
                let value = self.apply(value, inner, target);
                self.retyped(value, to)
            }
            Conversion::FromNullable(inner) => {
                let source = self.sema.nullable_of(value.ty).unwrap_or(value.ty);
                let there = make(source, pos, Kind::Convert(Conv::FromNullable, Box::new(value)));
                self.apply(there, inner, to)
            }
            Conversion::Lifted(inner) => self.lifted_conversion(value, inner, to),
            Conversion::User(user) => self.user(value, user, to),
            Conversion::Tuple(parts) => self.tuple_conversion(value, parts, to),
        }
    }

    fn enum_conversion(&mut self, value: Expr, to: Ty) -> Expr {
        let pos = value.pos;
        let checked = self.checked;
        let (Some(from_prim), Some(to_prim)) = (self.sema.underlying(value.ty), self.sema.underlying(to))
        else {
            return self.wrong(pos);
        };
        if matches!(value.kind, Kind::Const(_))
            && let Some(folded) = self.fold_number(&value, to_prim, checked)
        {
            return make(to, pos, Kind::Const(folded));
        }
        let mut value = value;
        if self.sema.is_enum(value.ty) {
            let number = self.prim_type(from_prim);
            value = make(number, pos, Kind::Convert(Conv::FromEnum(from_prim), Box::new(value)));
        }
        if from_prim != to_prim {
            let number = self.prim_type(to_prim);
            value =
                make(number, pos, Kind::Convert(Conv::Number(from_prim, to_prim, checked), Box::new(value)));
        }
        if self.sema.is_enum(to) {
            value = make(to, pos, Kind::Convert(Conv::ToEnum, Box::new(value)));
        }
        value
    }

    /// The type of a predefined kind.
    pub(super) fn prim_type(&mut self, prim: Prim) -> Ty {
        let k = self.sema.known;
        match prim {
            Prim::Bool => k.bool,
            Prim::Char => k.char,
            Prim::I32 => k.int,
            Prim::U32 => k.uint,
            Prim::I64 => k.long,
            Prim::U64 => k.ulong,
            Prim::F32 => k.float,
            Prim::F64 => k.double,
            Prim::Decimal => k.decimal,
            Prim::I8 => self.system("SByte"),
            Prim::U8 => self.system("Byte"),
            Prim::I16 => self.system("Int16"),
            Prim::U16 => self.system("UInt16"),
        }
    }

    /// A type of `System`.
    pub(super) fn system(&mut self, name: &str) -> Ty {
        match self.sema.library("System", name, 0) {
            Some(def) => self.sema.named(def, &[]),
            None => Ty::ERROR,
        }
    }

    fn lifted_conversion(&mut self, value: Expr, inner: &Conversion, to: Ty) -> Expr {
        let pos = value.pos;
        let source = self.sema.nullable_of(value.ty).unwrap_or(value.ty);
        let target = self.sema.nullable_of(to).unwrap_or(to);
        if matches!(inner, Conversion::Identity) {
            return self.retyped(value, to);
        }
        let (number, held) = self.held(source, pos);
        let converted = self.apply(held, inner, target);
        let converted = self.retyped(converted, to);
        make(to, pos, Kind::Conditional(Box::new(value), number, Box::new(converted)))
    }

    fn user(&mut self, value: Expr, user: &UserConversion, to: Ty) -> Expr {
        let pos = value.pos;
        if let Some(inner) = self.sema.nullable_of(value.ty)
            && self.sema.nullable_of(user.takes).is_none()
            && self.sema.is_value_type(user.takes)
        {
            let Some(target) = self.sema.nullable_of(to) else {
                let there = make(inner, pos, Kind::Convert(Conv::FromNullable, Box::new(value)));
                return self.user(there, user, to);
            };
            let (number, held) = self.held(inner, pos);
            let converted = self.user(held, user, target);
            let converted = self.retyped(converted, to);
            return make(to, pos, Kind::Conditional(Box::new(value), number, Box::new(converted)));
        }
        let taken = match self.sema.explicit(value.ty, user.takes) {
            Some(before) if !matches!(before, Conversion::User(_)) => self.apply(value, &before, user.takes),
            _ => value,
        };
        let given = make(
            user.gives,
            pos,
            Kind::Call(None, user.method.clone(), vec![(Passing::Value, taken)], false),
        );
        match self.sema.explicit(user.gives, to) {
            Some(behind) if !matches!(behind, Conversion::User(_)) => self.apply(given, &behind, to),
            _ => given,
        }
    }

    fn tuple_conversion(&mut self, value: Expr, parts: &[Conversion], to: Ty) -> Expr {
        let pos = value.pos;
        let from = self.sema.tuple_parts(value.ty).unwrap_or_default();
        let targets = self.sema.tuple_parts(to).unwrap_or_default();
        let ty = value.ty;
        let (number, held) = self.held(ty, pos);
        let mut made = Vec::new();
        for (i, conversion) in parts.iter().enumerate() {
            let (Some(source), Some(target)) = (from.get(i), targets.get(i)) else { return self.wrong(pos) };
            let item = self.tuple_element(held.clone(), i, *source);
            made.push(self.apply(item, conversion, *target));
        }
        let tuple = make(to, pos, Kind::Tuple(made));
        make(to, pos, Kind::Conditional(Box::new(value), number, Box::new(tuple)))
    }

    /// A cast.
    pub(super) fn cast(&mut self, pos: Pos, item: Item, to: Ty) -> Expr {
        let value = match item {
            Item::Value(value) => value,
            other => return self.convert(other, to, pos),
        };
        if value.ty == Ty::ERROR || to == Ty::ERROR {
            return self.wrong(pos);
        }
        if value.ty == Ty::DYNAMIC && to != Ty::DYNAMIC && to != self.sema.known.object {
            return self.dynamic_as(pos, value, to);
        }
        if self.constant_fits(&value, to) {
            return self.constant_as(value, to);
        }
        let Some(conversion) = self.sema.explicit(value.ty, to) else {
            let (from, shown) = (self.show(value.ty), self.show(to));
            return if value.ty == Ty::NULL {
                self.error(
                    pos,
                    37,
                    format!("Cannot convert null to '{shown}' because it is a non-nullable value type"),
                )
            } else {
                self.error(pos, 30, format!("Cannot convert type '{from}' to '{shown}'"))
            };
        };
        if let (Kind::Const(Const::Double(_) | Const::Float(_)), Some(target)) =
            (&value.kind, self.sema.prim(to))
            && target.is_integral()
            && !self.unchecked
            && self.fold_number(&value, target, false).is_none()
        {
            let shown = self.show(to);
            return self.error(
                pos,
                221,
                format!(
                    "Constant value cannot be converted to a '{shown}' (use 'unchecked' syntax to override)"
                ),
            );
        }
        if let (Kind::Const(Const::Int(n)), Some(target)) = (&value.kind, self.sema.prim(to)) {
            let (least, most) = target.range();
            if target.is_integral() && !(least..=most).contains(n) && !self.unchecked_cast() {
                let shown = self.show(to);
                return self.error(pos, 221, format!("Constant value '{n}' cannot be converted to a '{shown}' (use 'unchecked' syntax to override)"));
            }
        }
        self.apply(value, &conversion, to)
    }

    fn unchecked_cast(&self) -> bool {
        self.unchecked
    }
}
