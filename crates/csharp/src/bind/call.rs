//! Calls of methods, delegates and constructors.

use super::overload::Chosen;
use super::{Binder, Group, Item, make};
use crate::bound::{Arg, DynamicOp, Expr, Kind, MethodRef};
use crate::sema::{Resolved, Ty};
use crate::source::Pos;
use crate::syntax::ast::{self, NamePart, Passing};

impl Binder<'_> {
    pub(super) fn call(&mut self, pos: Pos, callee: &ast::Expr, args: &[ast::Arg]) -> Expr {
        let callee_item = self.item(callee);
        match callee_item {
            Item::Methods(group) => self.call_group(pos, *group, args),
            item => {
                let value = self.as_value(item, callee.pos);
                if let Some(group) = self.extension_behind(callee, &value) {
                    return self.call_group(pos, group, args);
                }
                self.call_value(pos, value, args)
            }
        }
    }

    /// What is called where a property has the name of an extension method, such as `list.Count()`: members that cannot be
    /// called do not hide methods that can (C# specification, 12.8.7.1).
    fn extension_behind(&mut self, callee: &ast::Expr, value: &Expr) -> Option<Group> {
        let ast::ExprKind::Member(_, part) = &callee.kind else { return None };
        let Kind::Prop(Some(receiver), ..) = &value.kind else { return None };
        if self.is_vb() || value.ty == Ty::DYNAMIC || self.is_delegate(value.ty) {
            return None;
        }
        if self.visible_extensions(&part.name).is_empty() {
            return None;
        }
        Some(Group {
            pos: part.pos,
            receiver: Some((**receiver).clone()),
            on: None,
            name: part.name.clone(),
            type_args: Vec::new(),
            candidates: Vec::new(),
            base: false,
            color: None,
        })
    }

    /// The call of a delegate that is a value.
    pub(super) fn call_value(&mut self, pos: Pos, value: Expr, args: &[ast::Arg]) -> Expr {
        if self.is_vb() && value.ty != Ty::ERROR && value.ty != Ty::DYNAMIC && !self.is_delegate(value.ty) {
            // In VB parentheses stand for elements too, and behind a property for nothing.
            return if args.is_empty() { value } else { self.element(pos, value, args) };
        }
        if value.ty == Ty::ERROR {
            for arg in args {
                self.speculate(|b| b.item(&arg.value));
            }
            return value;
        }
        if value.ty == Ty::DYNAMIC {
            if let Kind::Dynamic(DynamicOp::Get(name), mut operands) = value.kind {
                operands.extend(args.iter().map(|arg| self.real_value(&arg.value)).collect::<Vec<_>>());
                return make(Ty::DYNAMIC, pos, Kind::Dynamic(DynamicOp::Call(name), operands));
            }
            let mut operands = vec![value];
            operands.extend(args.iter().map(|arg| self.real_value(&arg.value)).collect::<Vec<_>>());
            return make(Ty::DYNAMIC, pos, Kind::Dynamic(DynamicOp::Invoke, operands));
        }
        let Some(def) = self.sema.def_of(value.ty) else {
            return self.error(pos, 149, "Method name expected");
        };
        let Some(invoke) = self.sema.def(def).invoke else {
            return self.error(pos, 149, "Method name expected");
        };
        let owner = value.ty;
        let items = self.argument_items(args);
        let shown = self.show(owner);
        let Some(chosen) = self.choose(pos, &[(owner, invoke)], &[], args, items, &shown) else {
            return self.wrong(pos);
        };
        make(chosen.ret, pos, Kind::Invoke(Box::new(value), chosen.args))
    }

    pub(super) fn call_group(&mut self, pos: Pos, mut group: Group, args: &[ast::Arg]) -> Expr {
        let items = self.argument_items(args);
        if items.iter().any(|item| matches!(item, Item::Value(v) if v.ty == Ty::ERROR)) {
            return self.wrong(pos);
        }
        if self.is_local_function(&group) {
            let name = group.name.to_string();
            let Some(chosen) = self.choose(pos, &group.candidates, &group.type_args, args, items, &name)
            else {
                return self.wrong(pos);
            };
            let Some(function) = group.receiver else { return self.wrong(pos) };
            let id = chosen.method.id;
            let call = make(chosen.ret, pos, Kind::Invoke(Box::new(function), chosen.args));
            return self.behind(id, call);
        }
        let candidates = std::mem::take(&mut group.candidates);
        if let Some(receiver) = &group.receiver
            && !group.base
        {
            let own = if candidates.is_empty() {
                None
            } else {
                let (types, items) = (group.type_args.clone(), items.clone());
                self.speculate(|b| b.choose(pos, &candidates, &types, args, items, "")).flatten()
            };
            if own.is_none() {
                let receiver = receiver.clone();
                if let Some(call) =
                    self.call_extension(pos, &group, receiver, args, &items, candidates.is_empty())
                {
                    return call;
                }
            }
        }
        let name = group.name.to_string();
        let Some(chosen) = self.choose(pos, &candidates, &group.type_args, args, items, &name) else {
            return self.wrong(pos);
        };
        self.finish_call(pos, group, chosen)
    }

    fn is_local_function(&self, group: &Group) -> bool {
        group.candidates.len() == 1
            && group
                .candidates
                .first()
                .is_some_and(|(_, id)| self.sema.method(*id).name.starts_with("<local>"))
    }

    fn finish_call(&mut self, pos: Pos, group: Group, mut chosen: Chosen) -> Expr {
        if let (true, Some(receiver)) = (group.base, &group.receiver)
            && let Some(found) = self.sema.find_override(receiver.ty, &chosen.method)
        {
            // `base.F()` runs the last override above this class.
            chosen.method = found;
        }
        let id = chosen.method.id;
        if let (crate::sema::Body::Invoke, Some(receiver)) = (&self.sema.method(id).body, &group.receiver) {
            return make(chosen.ret, pos, Kind::Invoke(Box::new(receiver.clone()), chosen.args));
        }
        if !self.check_access(pos, crate::sema::Member::Method(id)) {
            return self.wrong(pos);
        }
        let info = self.sema.method(id);
        let (is_static, is_virtual) = (info.is_static, info.is_virtual);
        if is_static {
            let through_value = group.receiver.as_ref().is_some_and(|r| !matches!(r.kind, Kind::This))
                && group.color.is_none();
            if through_value && group.on.is_none() {
                let shown = self.sema.show_method(id);
                let is_color = self.same_name_as_type(&group);
                if !is_color {
                    return self.error(group.pos, 176, format!("Member '{shown}' cannot be accessed with an instance reference; qualify it with a type name instead"));
                }
            }
            let call = make(chosen.ret, pos, Kind::Call(None, chosen.method, chosen.args, false));
            return self.behind(id, call);
        }
        let Some(receiver) = group.receiver else {
            let shown = self.sema.show_method(id);
            return self.error(
                group.pos,
                120,
                format!(
                    "An object reference is required for the non-static field, method, or property '{shown}'"
                ),
            );
        };
        let receiver = self.unchanging(receiver);
        let is_abstract = self.sema.method(id).is_abstract;
        if group.base && is_abstract {
            let shown = self.sema.show_method(id);
            return self.error(group.pos, 205, format!("Cannot call an abstract base member: '{shown}'"));
        }
        let is_virtual = is_virtual && !group.base;
        let kind = Kind::Call(Some(Box::new(receiver)), chosen.method, chosen.args, is_virtual);
        let call = make(chosen.ret, pos, kind);
        self.behind(id, call)
    }

    /// A struct that may not be changed is copied before a method of it runs (C# specification, 12.8.7.2).
    fn unchanging(&mut self, receiver: Expr) -> Expr {
        if !self.sema.is_struct(receiver.ty) {
            return receiver;
        }
        let fixed = match &receiver.kind {
            Kind::Field(_, field) => {
                let info = self.sema.field(field.id);
                info.readonly && !(self.constructor && info.owner == self.def)
            }
            Kind::Local(id) => self.locals.get(id.0 as usize).is_some_and(|l| l.passing == Passing::In),
            _ => false,
        };
        if !fixed || self.sema.def(self.def).library {
            return receiver;
        }
        let (ty, pos) = (receiver.ty, receiver.pos);
        let copy = self.new_local("", ty, Passing::Value);
        let set = self.set_local(pos, copy, receiver);
        let copy = self.local(copy, pos);
        make(ty, pos, Kind::Block(vec![set], Box::new(copy)))
    }

    fn same_name_as_type(&mut self, group: &Group) -> bool {
        let Some(receiver) = &group.receiver else { return false };
        let Some(def) = self.sema.def_of(receiver.ty) else { return false };
        let name = self.sema.def(def).name.clone();
        let scope = self.name_scope();
        let part = NamePart { pos: group.pos, name, args: Vec::new(), open: 0 };
        matches!((&receiver.kind, self.sema.lookup(&part, &scope)), (Kind::Prop(..) | Kind::Field(..) | Kind::Local(_), Some(Resolved::Type(ty))) if ty == receiver.ty)
    }

    fn call_extension(
        &mut self,
        pos: Pos,
        group: &Group,
        receiver: Expr,
        args: &[ast::Arg],
        items: &[Item],
        sole: bool,
    ) -> Option<Expr> {
        let candidates = self.visible_extensions(&group.name);
        if candidates.is_empty() {
            return None;
        }
        let mut all_args = vec![ast::Arg {
            name: None,
            passing: Passing::Value,
            value: ast::Expr { pos: receiver.pos, kind: ast::ExprKind::Receiver },
        }];
        all_args.extend(args.iter().cloned());
        let mut all_items = vec![Item::Value(receiver.clone())];
        all_items.extend(items.iter().cloned());
        // Without an extension for this type the message is that there is no such member.
        let fits: Vec<_> = candidates
            .iter()
            .copied()
            .filter(|(owner, id)| self.receiver_fits(*owner, *id, &receiver))
            .collect();
        if fits.is_empty() {
            if sole {
                let part = NamePart { pos: group.pos, name: group.name.clone(), args: Vec::new(), open: 0 };
                return Some(self.no_member(group.pos, receiver.ty, &part));
            }
            return None;
        }
        let chosen = if sole {
            let name = group.name.to_string();
            match self.choose(pos, &fits, &group.type_args, &all_args, all_items, &name) {
                Some(chosen) => chosen,
                None => return Some(self.wrong(pos)),
            }
        } else {
            let types = group.type_args.clone();
            self.speculate(|b| b.choose(pos, &fits, &types, &all_args, all_items, "")).flatten()?
        };
        let id = chosen.method.id;
        let call = make(chosen.ret, pos, Kind::Call(None, chosen.method, chosen.args, false));
        Some(self.behind(id, call))
    }

    /// Whether the receiver could be the first argument, whatever the type arguments.
    fn receiver_fits(&mut self, owner: Ty, id: crate::sema::MethodId, receiver: &Expr) -> bool {
        let info = self.sema.method(id).clone();
        let Some(first) = info.params.first() else { return false };
        let _ = owner;
        let Some(by) = self.infer_from_receiver(&info.type_params, first.ty, receiver.ty) else {
            return false;
        };
        let ty = self.sema.types.substitute(first.ty, &by);
        match self.sema.implicit(receiver.ty, ty) {
            Some(c) => !matches!(c, crate::sema::Conversion::User(_) | crate::sema::Conversion::Numeric(..)),
            None => false,
        }
    }

    pub(super) fn visible_extensions(&mut self, name: &str) -> Vec<(Ty, crate::sema::MethodId)> {
        let Some(all) = self.sema.extensions.get(name).cloned() else { return Vec::new() };
        let mut spaces = Vec::new();
        let mut level = Some(self.name_scope().usings);
        while let Some(usings) = level {
            spaces.push(usings.namespace.clone());
            spaces.extend(usings.namespaces.iter().cloned());
            level = usings.outer.clone();
        }
        let mut visible = Vec::new();
        for id in all {
            let owner = self.sema.method(id).owner;
            if spaces.iter().any(|s| **s == *self.sema.def(owner).namespace) {
                visible.push((self.sema.open(owner), id));
            }
        }
        visible
    }

    /// The constructor for arguments, and the arguments converted.
    pub(super) fn constructor(
        &mut self,
        pos: Pos,
        ty: Ty,
        args: &[ast::Arg],
    ) -> Option<(MethodRef, Vec<Arg>)> {
        let items = self.argument_items(args);
        let def = self.sema.def_of(ty)?;
        let list = self.sema.def(def).members.get(".ctor").cloned().unwrap_or_default();
        let candidates: Vec<_> = list
            .into_iter()
            .filter_map(|m| if let crate::sema::Member::Method(id) = m { Some((ty, id)) } else { None })
            .collect();
        let name = self.sema.def(def).name.to_string();
        let chosen = self.choose(pos, &candidates, &[], args, items, &name)?;
        if !self.check_access(pos, crate::sema::Member::Method(chosen.method.id)) {
            return None;
        }
        Some((chosen.method, chosen.args))
    }
}
