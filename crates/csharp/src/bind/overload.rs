//! Overload resolution (C# specification).

use std::sync::Arc;

use super::refusal::Refusal;
use super::{Binder, Item, make};
use crate::bound::{Arg, Expr, Kind, MethodRef};
use crate::sema::{MethodId, PropId, Substitution, Ty};
use crate::source::Pos;
use crate::syntax::ast::{self, Passing};

/// The method that was chosen, with arguments for all its parameters.
pub(super) struct Chosen {
    pub(super) method: MethodRef,
    pub(super) args: Vec<Arg>,
    pub(super) ret: Ty,
    pub(super) index: usize,
}

/// Where a parameter's value comes from.
#[derive(Debug, Clone)]
pub(super) enum Source {
    Arg(usize),
    Default(Arc<ast::Expr>),
    Rest(Vec<usize>),
}

#[derive(Debug, Clone)]
struct Applicable {
    index: usize,
    method: MethodRef,
    sources: Vec<Source>,
    params: Vec<(Passing, Ty)>,
    ret: Ty,
    expanded: bool,
    defaults: bool,
    generic: bool,
}

impl Binder<'_> {
    pub(super) fn argument_items(&mut self, args: &[ast::Arg]) -> Vec<Item> {
        args.iter()
            .map(|arg| {
                if let (Passing::Out, ast::ExprKind::Name(part)) = (arg.passing, &arg.value.kind)
                    && &*part.name == "_"
                    && self.find(&part.name).is_none()
                {
                    return Item::OutVar(arg.value.pos, None);
                }
                let item = self.item(&arg.value);
                match item {
                    Item::Value(value) if value.ty == Ty::VOID => {
                        Item::Value(self.error(arg.value.pos, 1503, "Argument: cannot convert from 'void'"))
                    }
                    // A type or namespace is no argument.
                    Item::Type(_) | Item::Namespace(_) => Item::Value(self.as_value(item, arg.value.pos)),
                    item => item,
                }
            })
            .collect()
    }

    /// Chooses among candidates; a fault when none or several fit.
    pub(super) fn choose(
        &mut self,
        pos: Pos,
        candidates: &[(Ty, MethodId)],
        type_args: &[Ty],
        args: &[ast::Arg],
        items: Vec<Item>,
        name: &str,
    ) -> Option<Chosen> {
        if items.iter().any(|item| matches!(item, Item::Value(v) if v.ty == Ty::ERROR)) {
            return None;
        }
        let mut fits: Vec<Applicable> = Vec::new();
        let mut refused: Option<(MethodId, Refusal)> = None;
        let mut level: Option<Ty> = None;
        for (index, (owner, id)) in candidates.iter().enumerate() {
            let method = self.sema.method(*id);
            if method.is_override
                && candidates.iter().any(|(o, other)| {
                    o != owner && other != id && self.sema.method(*other).params.len() == method.params.len()
                })
            {
                continue;
            }
            // What is found in a derived type hides what its bases have.
            if level.is_some_and(|level| level != *owner)
                && self.sema.type_kind(*owner) != Some(ast::TypeKind::Interface)
            {
                break;
            }
            match self.applicable(index, *owner, *id, type_args, args, &items) {
                Ok(fit) => {
                    level = Some(*owner);
                    fits.push(fit);
                }
                Err(why) => {
                    let better = matches!(
                        (&refused, &why),
                        (None, _)
                            | (
                                Some((_, Refusal::Count | Refusal::Missing(_))),
                                Refusal::Type(..)
                                    | Refusal::Infer
                                    | Refusal::Passing(..)
                                    | Refusal::Bound(..)
                            )
                    );
                    if better {
                        refused = Some((*id, why));
                    }
                }
            }
        }
        let best = match fits.len() {
            0 => {
                self.refuse(pos, candidates, refused, args, &items, name);
                return None;
            }
            1 => fits.pop()?,
            _ => self.best(pos, fits, args, &items)?,
        };
        Some(self.finish(best, args, items))
    }

    fn applicable(
        &mut self,
        index: usize,
        owner: Ty,
        id: MethodId,
        type_args: &[Ty],
        args: &[ast::Arg],
        items: &[Item],
    ) -> Result<Applicable, Refusal> {
        let first = self.applicable_in(index, owner, id, type_args, args, items, false);
        let rest = self.sema.method(id).params.last().is_some_and(|p| p.rest);
        match first {
            Err(_) if rest => self.applicable_in(index, owner, id, type_args, args, items, true),
            other => other,
        }
    }

    #[allow(clippy::too_many_arguments, reason = "a candidate and its form")]
    fn applicable_in(
        &mut self,
        index: usize,
        owner: Ty,
        id: MethodId,
        type_args: &[Ty],
        args: &[ast::Arg],
        items: &[Item],
        expanded: bool,
    ) -> Result<Applicable, Refusal> {
        let info = self.sema.method(id).clone();
        let count = info.params.len();
        let mut sources: Vec<Option<Source>> = vec![None; count];
        let mut named = false;
        for (i, arg) in args.iter().enumerate() {
            let place = match &arg.name {
                Some(name) => {
                    named = true;
                    info.params.iter().position(|p| p.name == *name).ok_or(Refusal::Name(name.to_string()))?
                }
                None if named && i >= count => return Err(Refusal::Count),
                None => i,
            };
            if expanded && place + 1 >= count && arg.name.is_none() {
                match &mut sources[count - 1] {
                    Some(Source::Rest(list)) => list.push(i),
                    slot => *slot = Some(Source::Rest(vec![i])),
                }
                continue;
            }
            let Some(slot) = sources.get_mut(place) else { return Err(Refusal::Count) };
            if slot.is_some() {
                return Err(Refusal::Count);
            }
            *slot = Some(Source::Arg(i));
        }
        let mut filled = Vec::new();
        let mut defaults = false;
        for (slot, param) in sources.into_iter().zip(&info.params) {
            filled.push(match (slot, &param.default) {
                (Some(source), _) => source,
                (None, _) if expanded && param.rest => Source::Rest(Vec::new()),
                (None, Some(default)) => {
                    defaults = true;
                    Source::Default(default.clone())
                }
                (None, None) if args.len() > count => return Err(Refusal::Count),
                (None, None) => return Err(Refusal::Missing(param.name.to_string())),
            });
        }
        let mut by = self.sema.substitution(owner);
        let open: Vec<_> = info
            .params
            .iter()
            .map(|p| {
                let ty = self.sema.types.substitute(p.ty, &by);
                let element = if expanded && p.rest { self.element_of(ty) } else { ty };
                (p.passing, element)
            })
            .collect();
        let mut method_args = Vec::new();
        let mut own = Substitution::default();
        if !info.type_params.is_empty() {
            method_args = if type_args.is_empty() {
                self.infer(&info.type_params, &open, &pairs(&filled), items).ok_or(Refusal::Infer)?
            } else if type_args.len() == info.type_params.len() {
                type_args.to_vec()
            } else {
                return Err(Refusal::Count);
            };
            own = Substitution::of(&info.type_params, &method_args);
            by.0.extend(own.0.clone());
            if let Some((code, message)) = self.unmet_bound(id, &info.type_params, &by) {
                return Err(Refusal::Bound(code, message));
            }
        } else if !type_args.is_empty() {
            return Err(Refusal::Count);
        }
        let params: Vec<_> = open.iter().map(|(p, ty)| (*p, self.sema.types.substitute(*ty, &own))).collect();
        for (i, param) in pairs(&filled) {
            let (passing, ty) = params[param];
            let given = args.get(i).map_or(Passing::Value, |a| a.passing);
            // VB hands variables over by reference without a word.
            let silent = given == Passing::Value
                && self.is_vb()
                && matches!(items.get(i), Some(Item::Value(v)) if matches!(v.kind, Kind::Local(_) | Kind::Field(..) | Kind::Element(..)));
            if given != passing && !silent && !(passing == Passing::In && given == Passing::Value) {
                return Err(Refusal::Passing(i, passing));
            }
            let Some(item) = items.get(i) else { return Err(Refusal::Count) };
            let fits = match (passing, item) {
                (Passing::Ref | Passing::Out, Item::Value(v)) => {
                    v.ty == ty
                        || v.ty == Ty::ERROR
                        || self.sema.types.erase(v.ty) == self.sema.types.erase(ty)
                        || ty == self.sema.known.object && v.ty == Ty::DYNAMIC
                }
                _ => self.converts(item, ty),
            };
            if !fits {
                return Err(Refusal::Type(i, ty));
            }
        }
        let ret = self.sema.types.substitute(info.ret, &by);
        let method = MethodRef { id, owner, args: method_args };
        let generic = !info.type_params.is_empty();
        Ok(Applicable { index, method, sources: filled, params, ret, expanded, defaults, generic })
    }

    pub(super) fn element_of(&self, ty: Ty) -> Ty {
        match self.sema.types.kind(ty) {
            crate::sema::Kind::Array(element, _) => *element,
            _ => ty,
        }
    }

    /// Why the type arguments of a method do not meet its constraints.
    fn unmet_bound(
        &mut self,
        id: MethodId,
        params: &[crate::sema::ParamId],
        by: &Substitution,
    ) -> Option<(u16, String)> {
        let whole = self.sema.show_method(id);
        params.iter().find_map(|param| {
            let ty = by.get(*param)?;
            self.sema.unmet(*param, ty, by, &whole)
        })
    }

    fn best(
        &mut self,
        pos: Pos,
        fits: Vec<Applicable>,
        args: &[ast::Arg],
        items: &[Item],
    ) -> Option<Applicable> {
        for (i, a) in fits.iter().enumerate() {
            let wins = fits.iter().enumerate().all(|(j, b)| i == j || self.is_better(a, b, args, items));
            if wins {
                return Some(a.clone());
            }
        }
        let (a, b) = (self.sema.show_method(fits[0].method.id), self.sema.show_method(fits[1].method.id));
        self.fault(
            pos,
            121,
            format!("The call is ambiguous between the following methods or properties: '{a}' and '{b}'"),
        );
        None
    }

    fn is_better(&mut self, a: &Applicable, b: &Applicable, args: &[ast::Arg], items: &[Item]) -> bool {
        let (mut better, mut worse) = (false, false);
        let (ap, bp) = (pairs(&a.sources), pairs(&b.sources));
        for (i, item) in items.iter().enumerate().take(args.len()) {
            let ty = |pairs: &[(usize, usize)], of: &Applicable| {
                pairs.iter().find(|(arg, _)| *arg == i).map(|(_, p)| of.params[*p].1)
            };
            let (Some(x), Some(y)) = (ty(&ap, a), ty(&bp, b)) else { continue };
            match self.compare(item, x, y) {
                std::cmp::Ordering::Greater => better = true,
                std::cmp::Ordering::Less => worse = true,
                std::cmp::Ordering::Equal => {}
            }
        }
        if better != worse {
            return better;
        }
        if better {
            return false;
        }
        // All the same: not generic, not expanded, without defaults, more parameters, more specific.
        if a.generic != b.generic {
            return !a.generic;
        }
        if a.expanded != b.expanded {
            return !a.expanded;
        }
        if a.defaults != b.defaults {
            return !a.defaults;
        }
        if a.expanded && a.sources.len() != b.sources.len() {
            return a.sources.len() > b.sources.len();
        }
        self.more_specific(a, b)
    }

    fn more_specific(&mut self, a: &Applicable, b: &Applicable) -> bool {
        let (x, y) = (self.sema.method(a.method.id), self.sema.method(b.method.id));
        let (x, y): (Vec<_>, Vec<_>) =
            (x.params.iter().map(|p| p.ty).collect(), y.params.iter().map(|p| p.ty).collect());
        let (mut more, mut less) = (false, false);
        for (p, q) in x.into_iter().zip(y) {
            let (dp, dq) = (self.specific(p), self.specific(q));
            more |= dp > dq;
            less |= dp < dq;
        }
        if more != less { more } else { a.index < b.index && a.method.owner != b.method.owner }
    }

    /// A type parameter is less specific than anything else, also inside a type.
    fn specific(&self, ty: Ty) -> u32 {
        match self.sema.types.kind(ty) {
            crate::sema::Kind::Param(_) => 0,
            crate::sema::Kind::Array(e, _) => 1 + self.specific(*e),
            crate::sema::Kind::Named(_, args) => 1 + args.iter().map(|a| self.specific(*a)).sum::<u32>(),
            _ => 1,
        }
    }

    /// Which of two types is the better target of an argument.
    fn compare(&mut self, item: &Item, x: Ty, y: Ty) -> std::cmp::Ordering {
        use std::cmp::Ordering;
        if x == y {
            return Ordering::Equal;
        }
        match item {
            Item::Value(value) => {
                if value.ty == x {
                    return Ordering::Greater;
                }
                if value.ty == y {
                    return Ordering::Less;
                }
                if value.ty == Ty::DYNAMIC {
                    // The choice belongs to the run: here what takes most values is taken.
                    let known = self.sema.known;
                    let rank = |ty: Ty| usize::from(ty == known.double) + 2 * usize::from(ty == known.object);
                    return rank(x).cmp(&rank(y));
                }
            }
            Item::Lambda(_, source) => {
                let source = source.clone();
                return self.compare_lambda(&source, x, y);
            }
            _ => {}
        }
        self.compare_targets(x, y)
    }

    pub(super) fn compare_targets(&mut self, x: Ty, y: Ty) -> std::cmp::Ordering {
        use std::cmp::Ordering;
        let down = self.sema.implicit(x, y).is_some();
        let up = self.sema.implicit(y, x).is_some();
        match (down, up) {
            (true, false) => Ordering::Greater,
            (false, true) => Ordering::Less,
            _ => match (self.sema.prim(x), self.sema.prim(y)) {
                (Some(p), Some(q)) if p.is_integral() && q.is_integral() => {
                    // A signed type is better than an unsigned one.
                    let signed = |p: crate::sema::Prim| p.range().0 < 0;
                    match (signed(p), signed(q)) {
                        (true, false) => Ordering::Greater,
                        (false, true) => Ordering::Less,
                        _ => Ordering::Equal,
                    }
                }
                // VB takes a number without a word about it as a `Double`.
                (Some(p), Some(q)) if self.is_vb() => {
                    let decimal = |p| p == crate::sema::Prim::Decimal;
                    decimal(q).cmp(&decimal(p))
                }
                _ => Ordering::Equal,
            },
        }
    }

    fn finish(&mut self, best: Applicable, args: &[ast::Arg], items: Vec<Item>) -> Chosen {
        let mut items: Vec<Option<Item>> = items.into_iter().map(Some).collect();
        let mut converted = Vec::new();
        let mut take = |i: usize| items.get_mut(i).and_then(Option::take);
        for (source, (passing, ty)) in best.sources.iter().zip(&best.params) {
            let value = match source {
                Source::Arg(i) => {
                    let at = args.get(*i).map_or(0, |a| a.value.pos);
                    let Some(item) = take(*i) else { continue };
                    match (passing, item) {
                        (Passing::Ref | Passing::Out, Item::Value(value)) => self.variable(*passing, value),
                        (_, item) => self.convert(item, *ty, at),
                    }
                }
                Source::Default(default) => {
                    let (default, ty) = (default.clone(), *ty);
                    self.default_value(&default, ty)
                }
                Source::Rest(list) => {
                    let mut values = Vec::new();
                    for i in list {
                        let at = args.get(*i).map_or(0, |a| a.value.pos);
                        if let Some(item) = take(*i) {
                            values.push(self.convert(item, *ty, at));
                        }
                    }
                    let array = self.sema.array(*ty, 1);
                    make(
                        array,
                        args.first().map_or(0, |a| a.value.pos),
                        Kind::ArrayOf(*ty, values, Vec::new()),
                    )
                }
            };
            converted.push((*passing, value));
        }
        self.in_written_order(&best.sources, &mut converted);
        Chosen { method: best.method, args: converted, ret: best.ret, index: best.index }
    }

    pub(super) fn resolve_indexer(
        &mut self,
        pos: Pos,
        candidates: &[(Ty, MethodId, PropId, bool)],
        args: &[ast::Arg],
        items: Vec<Item>,
    ) -> Option<(usize, Vec<Arg>)> {
        // A setter has the value as one more parameter; indexers are asked by their getters.
        let list: Vec<_> = candidates.iter().map(|(owner, m, ..)| (*owner, *m)).collect();
        let chosen = self.choose(pos, &list, &[], args, items, "this")?;
        Some((chosen.index, chosen.args))
    }

    pub(super) fn pick_operator(
        &mut self,
        candidates: &[(Ty, MethodId)],
        operands: &[Expr],
    ) -> Option<MethodRef> {
        let args: Vec<_> = operands
            .iter()
            .map(|e| ast::Arg {
                name: None,
                passing: Passing::Value,
                value: ast::Expr { pos: e.pos, kind: ast::ExprKind::Receiver },
            })
            .collect();
        let items: Vec<_> = operands.iter().cloned().map(Item::Value).collect();
        let mut fits = Vec::new();
        for (index, (owner, id)) in candidates.iter().enumerate() {
            if let Ok(fit) = self.applicable(index, *owner, *id, &[], &args, &items) {
                fits.push(fit);
            }
        }
        for (i, a) in fits.iter().enumerate() {
            if fits.iter().enumerate().all(|(j, b)| i == j || self.is_better(a, b, &args, &items)) {
                return Some(a.method.clone());
            }
        }
        fits.into_iter().next().map(|f| f.method)
    }
}

/// Arguments with their parameters.
fn pairs(sources: &[Source]) -> Vec<(usize, usize)> {
    let mut found = Vec::new();
    for (param, source) in sources.iter().enumerate() {
        match source {
            Source::Arg(i) => found.push((*i, param)),
            Source::Rest(list) => found.extend(list.iter().map(|i| (*i, param))),
            Source::Default(_) => {}
        }
    }
    found
}
