//! Type inference for calls of generic methods (C# specification), in two phases: what arguments say, then what
//! lambdas give.

use super::{Binder, Item};
use crate::sema::{Kind, ParamId, Substitution, Ty};
use crate::syntax::ast::Passing;

#[derive(Default)]
struct Bounds {
    lower: Vec<Ty>,
    exact: Vec<Ty>,
}

impl Binder<'_> {
    /// Type arguments for a method's type parameters.
    pub(super) fn infer(
        &mut self,
        params: &[ParamId],
        open: &[(Passing, Ty)],
        pairs: &[(usize, usize)],
        items: &[Item],
    ) -> Option<Vec<Ty>> {
        let mut bounds: Vec<Bounds> = params.iter().map(|_| Bounds::default()).collect();
        let mut fixed = Substitution::default();
        for (arg, param) in pairs {
            let ty = open[*param].1;
            match &items[*arg] {
                Item::Value(value) if value.ty != Ty::NULL => self.lower(params, value.ty, ty, &mut bounds),
                Item::Tuple(_, parts) => {
                    if let Some(types) = self.sema.tuple_parts(ty) {
                        for ((_, part), ty) in parts.clone().iter().zip(types) {
                            if let Item::Value(value) = part {
                                self.lower(params, value.ty, ty, &mut bounds);
                            }
                        }
                    } else {
                        let item = items[*arg].clone();
                        if let Some(value) = self.speculate(|b| b.as_value(item, 0)) {
                            self.lower(params, value.ty, ty, &mut bounds);
                        }
                    }
                }
                _ => {}
            }
        }
        self.lambda_types(params, open, pairs, items, &mut bounds);
        let mut waiting: Vec<_> = pairs.to_vec();
        loop {
            let before = (fixed.0.len(), waiting.len());
            for (param, bound) in params.iter().zip(&bounds) {
                if fixed.get(*param).is_none()
                    && let Some(ty) = self.settle(bound)
                {
                    fixed.set(*param, ty);
                }
            }
            if fixed.0.len() == params.len() {
                break;
            }
            let mut later = Vec::new();
            for (arg, param) in std::mem::take(&mut waiting) {
                if !self.infer_output(params, &fixed, &items[arg], open[param].1, &mut bounds) {
                    later.push((arg, param));
                }
            }
            waiting = later;
            if (fixed.0.len(), waiting.len()) == before {
                return None;
            }
        }
        params.iter().map(|param| fixed.get(*param)).collect()
    }

    /// Parameters of lambdas with written types say what the delegate takes.
    fn lambda_types(
        &mut self,
        params: &[ParamId],
        open: &[(Passing, Ty)],
        pairs: &[(usize, usize)],
        items: &[Item],
        bounds: &mut [Bounds],
    ) {
        for (arg, param) in pairs {
            let Item::Lambda(_, source) = &items[*arg] else { continue };
            let Some(written) = source.params.clone() else { continue };
            let Some((takes, _)) = self.sema.invoke_of(open[*param].1) else { continue };
            for (own, (_, ty)) in written.iter().zip(takes) {
                if let Some(own) = &own.ty {
                    let own = self.resolve(own);
                    self.exact(params, own, ty, bounds);
                }
            }
        }
    }

    /// What a lambda or group of methods gives, once all that it takes is known.
    fn infer_output(
        &mut self,
        params: &[ParamId],
        fixed: &Substitution,
        item: &Item,
        ty: Ty,
        bounds: &mut [Bounds],
    ) -> bool {
        if !matches!(item, Item::Lambda(..) | Item::Methods(_)) {
            return true;
        }
        let Some((takes, gives)) = self.sema.invoke_of(ty) else { return true };
        let takes: Vec<_> =
            takes.into_iter().map(|(p, t)| (p, self.sema.types.substitute(t, fixed))).collect();
        let explicit = matches!(item, Item::Lambda(_, s) if s.params.as_ref().is_some_and(|p| p.iter().all(|p| p.ty.is_some())));
        if !explicit && takes.iter().any(|(_, t)| self.mentions(*t, params)) {
            return false;
        }
        let given = match item {
            Item::Lambda(_, source) => {
                let source = source.clone();
                self.lambda_returns(&source, &takes)
            }
            Item::Methods(group) => {
                let group = group.clone();
                self.group_returns(&group, &takes)
            }
            _ => None,
        };
        if let Some(given) = given
            && given != Ty::VOID
        {
            self.lower(params, given, gives, bounds);
        }
        true
    }

    pub(super) fn mentions(&self, ty: Ty, params: &[ParamId]) -> bool {
        match self.sema.types.kind(ty) {
            Kind::Param(p) => params.contains(p),
            Kind::Array(e, _) => self.mentions(*e, params),
            Kind::Named(_, args) => args.iter().any(|a| self.mentions(*a, params)),
            Kind::Tuple(inner, _) => self.mentions(*inner, params),
            Kind::Special(_) => false,
        }
    }

    fn settle(&mut self, bounds: &Bounds) -> Option<Ty> {
        if let Some(first) = bounds.exact.first() {
            return Some(*first);
        }
        let all = &bounds.lower;
        all.iter()
            .copied()
            .find(|candidate| all.iter().all(|b| self.sema.implicit_standard(*b, *candidate).is_some()))
    }

    fn lower(&mut self, params: &[ParamId], from: Ty, to: Ty, bounds: &mut [Bounds]) {
        if from == Ty::ERROR || from == Ty::NONE || from == Ty::VOID {
            return;
        }
        match self.sema.types.kind(to).clone() {
            Kind::Param(param) => {
                if let Some(i) = params.iter().position(|p| *p == param)
                    && !bounds[i].lower.contains(&from)
                {
                    bounds[i].lower.push(from);
                }
            }
            Kind::Array(element, rank) => {
                if let Kind::Array(source, n) = self.sema.types.kind(from).clone()
                    && n == rank
                {
                    if self.sema.is_reference(source) {
                        self.lower(params, source, element, bounds)
                    } else {
                        self.exact(params, source, element, bounds)
                    }
                }
            }
            Kind::Tuple(inner, _) => self.lower(params, from, inner, bounds),
            Kind::Named(def, args) => {
                if def == self.sema.known.nullable && self.sema.nullable_of(from).is_none() {
                    if let Some(inner) = args.first() {
                        self.lower(params, from, *inner, bounds);
                    }
                    return;
                }
                let Some(found) = self.sema.as_instance_of(from, def) else { return };
                let sources = self.sema.args_of(found);
                let name = self.sema.def(def).name.clone();
                let varies = matches!(
                    &*name,
                    "IEnumerable"
                        | "IEnumerator"
                        | "IReadOnlyList"
                        | "IReadOnlyCollection"
                        | "ValueTuple"
                        | "IGrouping"
                );
                for (source, target) in sources.iter().zip(args.iter()) {
                    if varies && (self.sema.is_reference(*source) || &*name == "ValueTuple") {
                        self.lower(params, *source, *target, bounds);
                    } else {
                        self.exact(params, *source, *target, bounds);
                    }
                }
            }
            Kind::Special(_) => {}
        }
    }

    fn exact(&mut self, params: &[ParamId], from: Ty, to: Ty, bounds: &mut [Bounds]) {
        match (self.sema.types.kind(from).clone(), self.sema.types.kind(to).clone()) {
            (_, Kind::Param(param)) => {
                if let Some(i) = params.iter().position(|p| *p == param)
                    && !bounds[i].exact.contains(&from)
                {
                    bounds[i].exact.push(from);
                }
            }
            (Kind::Array(a, n), Kind::Array(b, m)) if n == m => self.exact(params, a, b, bounds),
            (Kind::Tuple(inner, _), _) => self.exact(params, inner, to, bounds),
            (_, Kind::Tuple(inner, _)) => self.exact(params, from, inner, bounds),
            (Kind::Named(d, a), Kind::Named(e, b)) if d == e => {
                for (x, y) in a.iter().zip(b.iter()) {
                    self.exact(params, *x, *y, bounds);
                }
            }
            _ => {}
        }
    }

    /// Type arguments as far as the receiver of an extension method says them.
    pub(super) fn infer_from_receiver(
        &mut self,
        params: &[ParamId],
        open: Ty,
        from: Ty,
    ) -> Option<Substitution> {
        let mut bounds: Vec<Bounds> = params.iter().map(|_| Bounds::default()).collect();
        self.lower(params, from, open, &mut bounds);
        let mut by = Substitution::default();
        for (param, bound) in params.iter().zip(&bounds) {
            match self.settle(bound) {
                Some(ty) => by.set(*param, ty),
                None if self.mentions(open, &[*param]) => return None,
                None => {}
            }
        }
        Some(by)
    }
}
