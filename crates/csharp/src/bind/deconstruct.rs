//! `(a, b) = value` and `var (a, b) = value`.

use super::{Binder, Item, make};
use crate::bound::{Expr, Kind, Stmt, StmtKind};
use crate::sema::{Member, Ty};
use crate::source::Pos;
use crate::syntax::ast::{self, Designation, ExprKind, Passing, TypeRefKind};

/// What an element is set to.
enum Target {
    Place(Expr),
    New(Pos, ast::Name, Option<Ty>),
    Several(Vec<Target>),
    Dropped,
}

impl Binder<'_> {
    pub(super) fn deconstruct(&mut self, pos: Pos, target: &ast::Expr, value: &ast::Expr) -> Expr {
        let target = self.target(target);
        let item = self.item(value);
        // Elements of a written tuple take the types of what they are set to.
        if let (Target::Several(targets), Item::Tuple(at, parts)) = (&target, &item)
            && targets.len() == parts.len()
        {
            let wanted: Vec<_> = targets
                .iter()
                .map(|t| match t {
                    Target::Place(e) => Some(e.ty),
                    Target::New(_, _, ty) => *ty,
                    _ => None,
                })
                .collect();
            let mut values = Vec::new();
            let mut types = Vec::new();
            for ((_, part), ty) in parts.clone().into_iter().zip(wanted) {
                let value = match ty {
                    Some(ty) => self.convert(part, ty, *at),
                    None => self.as_value(part, *at),
                };
                if value.ty == Ty::ERROR {
                    return self.wrong(pos);
                }
                types.push(value.ty);
                values.push(value);
            }
            let ty = self.sema.tuple(pos, &types, vec![None; types.len()]);
            let tuple = make(ty, pos, Kind::Tuple(values));
            return self.spread(pos, tuple, target);
        }
        let value = self.as_value(item, value.pos);
        self.spread(pos, value, target)
    }

    /// The names of `foreach (var (a, b) in ...)`, as statements before the body.
    pub(super) fn deconstruct_into(&mut self, pos: Pos, names: &Designation, value: Expr) -> Stmt {
        let target = self.designated(names);
        let made = self.spread(pos, value, target);
        Stmt { pos, kind: StmtKind::Expr(made) }
    }

    fn target(&mut self, e: &ast::Expr) -> Target {
        match &e.kind {
            ExprKind::Tuple(parts) => Target::Several(parts.iter().map(|(_, p)| self.target(p)).collect()),
            ExprKind::Declare(ty, names) => {
                if matches!(ty.kind, TypeRefKind::Var) {
                    return self.designated(names);
                }
                let ty = self.resolve(ty);
                match names {
                    Designation::Name(pos, name) => Target::New(*pos, name.clone(), Some(ty)),
                    _ => Target::Dropped,
                }
            }
            ExprKind::Name(part) if &*part.name == "_" && self.find(&part.name).is_none() => Target::Dropped,
            _ => Target::Place(self.value(e)),
        }
    }

    fn designated(&mut self, names: &Designation) -> Target {
        match names {
            Designation::Name(pos, name) => Target::New(*pos, name.clone(), None),
            Designation::Discard(_) => Target::Dropped,
            Designation::Several(_, list) => {
                Target::Several(list.iter().map(|n| self.designated(n)).collect())
            }
        }
    }

    fn spread(&mut self, pos: Pos, value: Expr, target: Target) -> Expr {
        if value.ty == Ty::ERROR {
            self.declare_all(target);
            return value;
        }
        let Target::Several(targets) = target else { return self.wrong(pos) };
        let ty = value.ty;
        let (number, held) = self.held(ty, pos);
        let mut steps = Vec::new();
        let Some(types) = self.sema.tuple_parts(ty) else {
            return self.spread_by_method(pos, value, targets);
        };
        if types.len() != targets.len() {
            return self.error(
                pos,
                8132,
                format!(
                    "Cannot deconstruct a tuple of '{}' elements into '{}' variables.",
                    types.len(),
                    targets.len()
                ),
            );
        }
        for (i, (target, element)) in targets.into_iter().zip(types).enumerate() {
            let element = self.tuple_element(held.clone(), i, element);
            self.set(pos, element, target, &mut steps);
        }
        steps.push(held);
        make(ty, pos, Kind::Deconstruct(Box::new(value), number, steps))
    }

    fn set(&mut self, pos: Pos, value: Expr, target: Target, steps: &mut Vec<Expr>) {
        match target {
            Target::Dropped => {}
            Target::Place(place) => {
                let step = self.assign_to(pos, place, Item::Value(value), pos);
                steps.push(step);
            }
            Target::New(at, name, ty) => {
                let local = self.declare(at, &name, ty.unwrap_or(value.ty), Passing::Value);
                let place = self.local(local, at);
                let step = self.assign_to(at, place, Item::Value(value), at);
                steps.push(step);
            }
            several => {
                let step = self.spread(pos, value, several);
                steps.push(step);
            }
        }
    }

    /// By a method `Deconstruct(out ..., out ...)`.
    fn spread_by_method(&mut self, pos: Pos, value: Expr, targets: Vec<Target>) -> Expr {
        let ty = value.ty;
        let members = self.sema.members(ty, &"Deconstruct".into());
        let count = targets.len();
        let found = members.into_iter().find_map(|(owner, m)| match m {
            Member::Method(id)
                if self.sema.method(id).params.len() == count
                    && self.sema.method(id).params.iter().all(|p| p.passing == Passing::Out) =>
            {
                Some((owner, id))
            }
            _ => None,
        });
        let Some((owner, id)) = found else {
            let shown = self.show(ty);
            return self.error(pos, 8129, format!("No suitable 'Deconstruct' instance or extension method was found for type '{shown}', with {count} out parameters and a void return type."));
        };
        let by = self.sema.substitution(owner);
        let types: Vec<_> = self.sema.method(id).params.iter().map(|p| p.ty).collect();
        let (number, held) = self.held(ty, pos);
        let mut args = Vec::new();
        let mut outs = Vec::new();
        for ty in types {
            let ty = self.sema.types.substitute(ty, &by);
            let local = self.new_local("", ty, Passing::Value);
            let place = self.local(local, pos);
            args.push((Passing::Out, place.clone()));
            outs.push(place);
        }
        let method = crate::bound::MethodRef { id, owner, args: Vec::new() };
        let is_virtual = self.sema.method(id).is_virtual;
        let mut steps =
            vec![make(Ty::VOID, pos, Kind::Call(Some(Box::new(held.clone())), method, args, is_virtual))];
        for (out, target) in outs.into_iter().zip(targets) {
            self.set(pos, out, target, &mut steps);
        }
        steps.push(held);
        make(ty, pos, Kind::Deconstruct(Box::new(value), number, steps))
    }

    fn declare_all(&mut self, target: Target) {
        match target {
            Target::New(pos, name, ty) => {
                self.declare(pos, &name, ty.unwrap_or(Ty::ERROR), Passing::Value);
            }
            Target::Several(list) => list.into_iter().for_each(|t| self.declare_all(t)),
            _ => {}
        }
    }
}
