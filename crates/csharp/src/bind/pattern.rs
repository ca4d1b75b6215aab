//! Patterns as tests of a value.

use super::{Binder, Item, make};
use crate::bound::{Const, Conv, Expr, Kind, Stmt, StmtKind};
use crate::sema::Ty;
use crate::source::Pos;
use crate::syntax::ast::{self, Designation, NamePart, Passing, Pattern, PatternKind, TypeRef};

impl Binder<'_> {
    pub(super) fn is(&mut self, pos: Pos, value: &ast::Expr, pattern: &Pattern) -> Expr {
        let value = self.real_value(value);
        if value.ty == Ty::ERROR {
            return value;
        }
        let ty = value.ty;
        let (number, held) = self.held(ty, pos);
        let test = self.test(&held, pattern);
        make(test.ty, pos, Kind::Deconstruct(Box::new(value), number, vec![test]))
    }

    fn yes(&self, pos: Pos) -> Expr {
        make(self.sema.known.bool, pos, Kind::Const(Const::Bool(true)))
    }

    fn both(&self, a: Expr, b: Expr) -> Expr {
        let (ty, pos) = (a.ty, a.pos);
        match (&a.kind, &b.kind) {
            (Kind::Const(Const::Bool(true)), _) => b,
            (_, Kind::Const(Const::Bool(true))) => a,
            _ => make(ty, pos, Kind::And(Box::new(a), Box::new(b))),
        }
    }

    /// Whether a value, which is at hand, fits a pattern; sets the pattern's variables.
    pub(super) fn test(&mut self, value: &Expr, pattern: &Pattern) -> Expr {
        let pos = pattern.pos;
        let bool_ = self.sema.known.bool;
        match &pattern.kind {
            PatternKind::Discard => self.yes(pos),
            PatternKind::Var(names) => self.name_it(pos, names, value.clone()),
            PatternKind::Type(written, name) => self.type_test(pos, value, written, name.as_ref()),
            PatternKind::Value(e) => self.value_test(pos, value, e),
            PatternKind::Relation(op, e) => {
                let limit = self.real_value(e);
                let number = self.as_number(value);
                let test = self.binary_values(pos, *op, number, limit);
                self.guard_null(pos, value, test)
            }
            PatternKind::Not(inner) => {
                let test = self.test(value, inner);
                make(bool_, pos, Kind::Not(Box::new(test)))
            }
            PatternKind::And(a, b) => {
                let a = self.test(value, a);
                let b = self.test(value, b);
                self.both(a, b)
            }
            PatternKind::Or(a, b) => {
                let a = self.test(value, a);
                let b = self.test(value, b);
                make(bool_, pos, Kind::Or(Box::new(a), Box::new(b)))
            }
            PatternKind::Recursive(ty, positions, members, name) => {
                self.recursive_test(pos, value, ty.as_ref(), positions.as_deref(), members, name.as_ref())
            }
        }
    }

    fn as_number(&mut self, value: &Expr) -> Expr {
        match self.sema.nullable_of(value.ty) {
            Some(inner) => make(inner, value.pos, Kind::Convert(Conv::FromNullable, Box::new(value.clone()))),
            None => value.clone(),
        }
    }

    fn guard_null(&mut self, pos: Pos, value: &Expr, test: Expr) -> Expr {
        if self.sema.nullable_of(value.ty).is_none() {
            return test;
        }
        let there = make(self.sema.known.bool, pos, Kind::IsNull(false, Box::new(value.clone())));
        self.both(there, test)
    }

    fn name_it(&mut self, pos: Pos, names: &Designation, value: Expr) -> Expr {
        match names {
            Designation::Discard(_) => self.yes(pos),
            Designation::Name(at, name) => {
                let ty = value.ty;
                let local = self.declare(*at, name, ty, Passing::Value);
                let place = self.local(local, *at);
                let set = make(ty, pos, Kind::Assign(Box::new(place), Box::new(value)));
                let yes = self.yes(pos);
                make(yes.ty, pos, Kind::Block(vec![Stmt { pos, kind: StmtKind::Expr(set) }], Box::new(yes)))
            }
            Designation::Several(..) => {
                let step = self.deconstruct_into(pos, names, value);
                let yes = self.yes(pos);
                make(yes.ty, pos, Kind::Block(vec![step], Box::new(yes)))
            }
        }
    }

    fn type_test(&mut self, pos: Pos, value: &Expr, written: &TypeRef, name: Option<&Designation>) -> Expr {
        let ty = self.resolve(written);
        self.is_type(pos, value, ty, name)
    }

    fn is_type(&mut self, pos: Pos, value: &Expr, ty: Ty, name: Option<&Designation>) -> Expr {
        if ty == Ty::ERROR {
            if let Some(Designation::Name(at, name)) = name {
                self.declare(*at, name, ty, Passing::Value);
            }
            return self.wrong(pos);
        }
        let possible = value.ty == Ty::NULL
            || self.sema.explicit(value.ty, ty).is_some_and(|c| {
                !matches!(c, crate::sema::Conversion::User(_) | crate::sema::Conversion::Numeric(..))
            })
            || self.sema.nullable_of(value.ty) == Some(ty);
        if !possible && name.is_some() {
            let (from, to) = (self.show(value.ty), self.show(ty));
            return self.error(
                pos,
                8121,
                format!("An expression of type '{from}' cannot be handled by a pattern of type '{to}'."),
            );
        }
        let test = make(self.sema.known.bool, pos, Kind::Is(Box::new(value.clone()), ty));
        match name {
            None => test,
            Some(name) => {
                let inner = make(ty, pos, Kind::Convert(Conv::Cast, Box::new(value.clone())));
                let named = self.name_it(pos, name, inner);
                self.both(test, named)
            }
        }
    }

    /// A value, or a type by its name.
    fn value_test(&mut self, pos: Pos, value: &Expr, e: &ast::Expr) -> Expr {
        let item = self.item(e);
        let constant = match item {
            Item::Type(ty) => return self.is_type(pos, value, ty, None),
            item => self.as_value(item, e.pos),
        };
        if constant.ty == Ty::ERROR {
            return constant;
        }
        if constant.ty == Ty::NULL {
            return make(self.sema.known.bool, pos, Kind::IsNull(true, Box::new(value.clone())));
        }
        if !matches!(constant.kind, Kind::Const(_)) {
            return self.error(pos, 150, "A constant value is expected");
        }
        let inner = self.sema.nullable_of(value.ty).unwrap_or(value.ty);
        let reference = inner == self.sema.known.object
            || inner == Ty::DYNAMIC
            || self.sema.is_param(inner)
            || self.sema.type_kind(inner) == Some(ast::TypeKind::Interface) && inner != constant.ty;
        if reference {
            // The value must be of the constant's type first.
            let ty = constant.ty;
            let test = make(self.sema.known.bool, pos, Kind::Is(Box::new(value.clone()), ty));
            let typed = make(ty, pos, Kind::Convert(Conv::Cast, Box::new(value.clone())));
            let same = self.binary_values(pos, ast::BinaryOp::Eq, typed, constant);
            return self.both(test, same);
        }
        let constant = self.convert(Item::Value(constant), inner, e.pos);
        let number = self.as_number(value);
        let same = self.binary_values(pos, ast::BinaryOp::Eq, number, constant);
        self.guard_null(pos, value, same)
    }

    fn recursive_test(
        &mut self,
        pos: Pos,
        value: &Expr,
        written: Option<&TypeRef>,
        positions: Option<&[Pattern]>,
        members: &[(Pos, ast::Name, Pattern)],
        name: Option<&Designation>,
    ) -> Expr {
        let inner = self.sema.nullable_of(value.ty).unwrap_or(value.ty);
        let ty = written.map_or(inner, |w| self.resolve(w));
        let mut test = if written.is_some() {
            make(self.sema.known.bool, pos, Kind::Is(Box::new(value.clone()), ty))
        } else if self.sema.is_value_type(value.ty) && inner == value.ty {
            self.yes(pos)
        } else {
            make(self.sema.known.bool, pos, Kind::IsNull(false, Box::new(value.clone())))
        };
        let typed = if value.ty == ty {
            value.clone()
        } else {
            make(ty, pos, Kind::Convert(Conv::Cast, Box::new(value.clone())))
        };
        if let Some(patterns) = positions {
            let one = self.positional(pos, &typed, patterns);
            test = self.both(test, one);
        }
        for (at, member, pattern) in members {
            let part = NamePart { pos: *at, name: member.clone(), args: Vec::new(), open: 0 };
            let item = self.member_of(*at, typed.clone(), &part);
            let found = self.as_value(item, *at);
            if found.ty == Ty::ERROR {
                return found;
            }
            let (number, held) = self.held(found.ty, *at);
            let inner = self.test(&held, pattern);
            let one = make(inner.ty, *at, Kind::Deconstruct(Box::new(found), number, vec![inner]));
            test = self.both(test, one);
        }
        if let Some(name) = name {
            let named = self.name_it(pos, name, typed);
            test = self.both(test, named);
        }
        test
    }

    fn positional(&mut self, pos: Pos, value: &Expr, patterns: &[Pattern]) -> Expr {
        let Some(types) = self.sema.tuple_parts(value.ty) else {
            return self.error(pos, 0, "A positional pattern of a type other than a tuple is not supported");
        };
        if types.len() != patterns.len() {
            return self.error(
                pos,
                8502,
                format!(
                    "Matching the tuple type requires '{}' subpatterns, but '{}' subpatterns are present.",
                    types.len(),
                    patterns.len()
                ),
            );
        }
        let mut test = self.yes(pos);
        for (i, (pattern, ty)) in patterns.iter().zip(types).enumerate() {
            let element = self.tuple_element(value.clone(), i, ty);
            let one = self.test(&element, pattern);
            test = self.both(test, one);
        }
        test
    }
}
