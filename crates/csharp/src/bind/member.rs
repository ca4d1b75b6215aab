//! Members behind a dot, elements, and `?.`.

use super::{Binder, Group, Item, make};
use crate::bound::{Arg, DynamicOp, Expr, Kind};
use crate::sema::{Member, Resolved, Ty};
use crate::source::Pos;
use crate::syntax::ast::{self, ExprKind, NamePart};

impl Binder<'_> {
    pub(super) fn member(&mut self, left: &ast::Expr, part: &NamePart) -> Item {
        let pos = part.pos;
        if matches!(left.kind, ExprKind::Base) {
            return self.base_member(pos, part);
        }
        let left_item = self.item(left);
        match left_item {
            Item::Namespace(name) => {
                let scope = self.name_scope();
                match self.sema.lookup_in(&Resolved::Namespace(name.clone()), part, &scope) {
                    Some(Resolved::Type(ty)) => Item::Type(ty),
                    Some(Resolved::Namespace(name)) => Item::Namespace(name),
                    None => Item::Value(self.error(pos, 234, format!("The type or namespace name '{}' does not exist in the namespace '{name}' (are you missing an assembly reference?)", part.name))),
                }
            }
            Item::Type(ty) => self.type_member(pos, ty, part),
            item => {
                let color = self.color_type(left, &item);
                let value = self.as_value(item, left.pos);
                if let Some(ty) = color
                    && self.is_static_of(ty, part)
                {
                    return self.type_member(pos, ty, part);
                }
                self.member_of(pos, value, part)
            }
        }
    }

    /// `Color Color`: a value whose name is also that of its type.
    fn color_type(&mut self, left: &ast::Expr, item: &Item) -> Option<Ty> {
        let (ExprKind::Name(part), Item::Value(value)) = (&left.kind, item) else { return None };
        let scope = self.name_scope();
        match self.sema.lookup(part, &scope) {
            Some(Resolved::Type(ty)) if ty == value.ty => Some(ty),
            _ => None,
        }
    }

    fn is_static_of(&mut self, ty: Ty, part: &NamePart) -> bool {
        let members = self.sema.members(ty, &part.name);
        members.first().is_some_and(|(_, m)| match m {
            Member::Field(f) => self.sema.field(*f).is_static,
            Member::Prop(p) => self.sema.prop(*p).is_static,
            Member::Method(m) => self.sema.method(*m).is_static,
            Member::Type(_) => true,
        })
    }

    fn base_member(&mut self, pos: Pos, part: &NamePart) -> Item {
        let this = self.this(pos);
        let Some(base) = self.sema.base_of(self.this) else { return Item::Value(this) };
        let members = self.sema.members(base, &part.name);
        if members.is_empty() {
            let shown = self.show(base);
            return Item::Value(self.error(
                pos,
                117,
                format!("'{shown}' does not contain a definition for '{}'", part.name),
            ));
        }
        let receiver = self.retyped(this, base);
        self.instance_member(pos, receiver, part, members, true, None)
    }

    fn type_member(&mut self, pos: Pos, ty: Ty, part: &NamePart) -> Item {
        if ty == Ty::ERROR {
            return Item::Value(self.wrong(pos));
        }
        let members = self.sema.members(ty, &part.name);
        if members.first().is_some_and(|m| !matches!(m.1, Member::Type(_))) {
            return self.static_member(pos, ty, part, members);
        }
        let scope = self.name_scope();
        match self.sema.lookup_in(&Resolved::Type(ty), part, &scope) {
            Some(Resolved::Type(inner)) => Item::Type(inner),
            _ => {
                let shown = self.show(ty);
                Item::Value(self.error(
                    pos,
                    117,
                    format!("'{shown}' does not contain a definition for '{}'", part.name),
                ))
            }
        }
    }

    pub(super) fn static_member(
        &mut self,
        pos: Pos,
        ty: Ty,
        part: &NamePart,
        members: Vec<(Ty, Member)>,
    ) -> Item {
        let Some((owner, first)) = members.first().copied() else { return Item::Value(self.wrong(pos)) };
        if !matches!(first, Member::Method(_)) && !self.check_access(pos, first) {
            return Item::Value(self.wrong(pos));
        }
        match first {
            Member::Field(f) if self.sema.field(f).is_static => Item::Value(self.field(pos, None, owner, f)),
            Member::Prop(p) if self.sema.prop(p).is_static => {
                Item::Value(self.prop(pos, None, owner, p, Vec::new(), false))
            }
            Member::Method(_) => self.methods_item(pos, None, Some(ty), part, members, false, None),
            other => Item::Value(self.no_instance(pos, other)),
        }
    }

    #[allow(clippy::too_many_arguments, reason = "a group of methods is all of these")]
    pub(super) fn methods_item(
        &mut self,
        pos: Pos,
        receiver: Option<Expr>,
        on: Option<Ty>,
        part: &NamePart,
        members: Vec<(Ty, Member)>,
        base: bool,
        color: Option<Ty>,
    ) -> Item {
        let candidates = members
            .into_iter()
            .filter_map(|(ty, m)| if let Member::Method(id) = m { Some((ty, id)) } else { None })
            .collect();
        let type_args = part.args.iter().map(|arg| self.resolve(arg)).collect();
        Item::Methods(Box::new(Group {
            pos,
            receiver,
            on,
            name: part.name.clone(),
            type_args,
            candidates,
            base,
            color,
        }))
    }

    pub(super) fn instance_member(
        &mut self,
        pos: Pos,
        receiver: Expr,
        part: &NamePart,
        members: Vec<(Ty, Member)>,
        base: bool,
        color: Option<Ty>,
    ) -> Item {
        let Some((owner, first)) = members.first().copied() else { return Item::Value(self.wrong(pos)) };
        if !matches!(first, Member::Method(_)) && !self.check_access(pos, first) {
            return Item::Value(self.wrong(pos));
        }
        match first {
            Member::Field(f) => {
                if self.sema.field(f).is_static && !matches!(receiver.kind, Kind::This) {
                    return Item::Value(self.through_instance(pos, first));
                }
                Item::Value(self.field(pos, Some(receiver), owner, f))
            }
            Member::Prop(p) => {
                if self.sema.prop(p).is_static && !matches!(receiver.kind, Kind::This) {
                    return Item::Value(self.through_instance(pos, first));
                }
                Item::Value(self.prop(pos, Some(receiver), owner, p, Vec::new(), !base))
            }
            Member::Method(_) => self.methods_item(pos, Some(receiver), None, part, members, base, color),
            Member::Type(_) => Item::Value(self.error(
                pos,
                572,
                format!("'{}': cannot reference a type through an expression", part.name),
            )),
        }
    }

    fn through_instance(&mut self, pos: Pos, member: Member) -> Expr {
        let (owner, name) = match member {
            Member::Field(f) => (self.sema.field(f).owner, self.sema.field(f).name.clone()),
            Member::Prop(p) => (self.sema.prop(p).owner, self.sema.prop(p).name.clone()),
            _ => return self.wrong(pos),
        };
        let owner = self.sema.def(owner).name.clone();
        self.error(pos, 176, format!("Member '{owner}.{name}' cannot be accessed with an instance reference; qualify it with a type name instead"))
    }

    /// A member of a value.
    pub(super) fn member_of(&mut self, pos: Pos, value: Expr, part: &NamePart) -> Item {
        if value.ty == Ty::ERROR {
            return Item::Value(value);
        }
        if value.ty == Ty::DYNAMIC {
            return Item::Value(make(
                Ty::DYNAMIC,
                pos,
                Kind::Dynamic(DynamicOp::Get(part.name.clone()), vec![value]),
            ));
        }
        if value.ty == Ty::VOID || value.ty == Ty::NULL {
            let shown = self.show(value.ty);
            return Item::Value(self.error(
                pos,
                23,
                format!("Operator '.' cannot be applied to operand of type '{shown}'"),
            ));
        }
        if let Some(item) = self.tuple_member(pos, &value, part) {
            return item;
        }
        let members = self.sema.members(value.ty, &part.name);
        if !members.is_empty() {
            return self.instance_member(pos, value, part, members, false, None);
        }
        let has_extension = self.sema.extensions.contains_key(&part.name);
        if has_extension {
            return self.methods_item(pos, Some(value), None, part, Vec::new(), false, None);
        }
        Item::Value(self.no_member(pos, value.ty, part))
    }

    pub(super) fn no_member(&mut self, pos: Pos, ty: Ty, part: &NamePart) -> Expr {
        let shown = self.show(ty);
        let name = &part.name;
        self.error(pos, 1061, format!("'{shown}' does not contain a definition for '{name}' and no accessible extension method '{name}' accepting a first argument of type '{shown}' could be found (are you missing a using directive or an assembly reference?)"))
    }

    pub(super) fn index(&mut self, pos: Pos, left: &ast::Expr, args: &[ast::Arg]) -> Expr {
        if matches!(left.kind, ExprKind::Base) {
            let this = self.this(pos);
            let Some(base) = self.sema.base_of(self.this) else { return this };
            let receiver = self.retyped(this, base);
            return self.indexer(pos, receiver, args, false);
        }
        let receiver = self.real_value(left);
        self.element(pos, receiver, args)
    }

    pub(super) fn element(&mut self, pos: Pos, receiver: Expr, args: &[ast::Arg]) -> Expr {
        if receiver.ty == Ty::ERROR {
            return receiver;
        }
        if receiver.ty == Ty::DYNAMIC {
            let mut values = vec![receiver];
            values.extend(args.iter().map(|arg| self.real_value(&arg.value)).collect::<Vec<_>>());
            return make(Ty::DYNAMIC, pos, Kind::Dynamic(DynamicOp::Index, values));
        }
        if let crate::sema::Kind::Array(element, rank) = self.sema.types.kind(receiver.ty).clone() {
            if args.len() != usize::from(rank) {
                return self.error(pos, 22, format!("Wrong number of indices inside []; expected {rank}"));
            }
            let indices = args.iter().map(|arg| self.array_index(&arg.value)).collect();
            return make(element, pos, Kind::Element(Box::new(receiver), indices));
        }
        self.indexer(pos, receiver, args, true)
    }

    /// An index or length: int, or a wider whole number that is checked.
    pub(super) fn array_index(&mut self, e: &ast::Expr) -> Expr {
        let value = self.real_value(e);
        let known = self.sema.known;
        for ty in [known.int, known.uint, known.long, known.ulong] {
            if self.sema.implicit(value.ty, ty).is_some() {
                let pos = value.pos;
                let value = self.convert(Item::Value(value), ty, pos);
                if ty == known.int {
                    return value;
                }
                let Some(prim) = self.sema.prim(ty) else { return value };
                return make(
                    known.int,
                    pos,
                    Kind::Convert(
                        crate::bound::Conv::Number(prim, crate::sema::Prim::I32, true),
                        Box::new(value),
                    ),
                );
            }
        }
        self.convert(Item::Value(value), known.int, e.pos)
    }

    fn indexer(&mut self, pos: Pos, receiver: Expr, args: &[ast::Arg], virtual_: bool) -> Expr {
        let ty = receiver.ty;
        let members = self.sema.members(ty, &"Item".into());
        let props: Vec<_> = members
            .into_iter()
            .filter_map(|(owner, m)| match m {
                Member::Prop(p) if !self.sema.prop(p).params.is_empty() => Some((owner, p)),
                _ => None,
            })
            .collect();
        if props.is_empty() {
            let shown = self.show(ty);
            return self.error(
                pos,
                21,
                format!("Cannot apply indexing with [] to an expression of type '{shown}'"),
            );
        }
        let candidates: Vec<_> = props
            .iter()
            .filter_map(|(owner, p)| {
                let prop = self.sema.prop(*p);
                prop.getter.or(prop.setter).map(|m| (*owner, m, *p, prop.getter.is_none()))
            })
            .collect();
        let items = self.argument_items(args);
        let Some((index, converted)) = self.resolve_indexer(pos, &candidates, args, items) else {
            return self.wrong(pos);
        };
        let Some((owner, _, prop, _)) = candidates.get(index).copied() else { return self.wrong(pos) };
        let args: Vec<Arg> = converted;
        self.prop(pos, Some(receiver), owner, prop, args, virtual_)
    }

    pub(super) fn conditional_access(&mut self, pos: Pos, receiver: &ast::Expr, chain: &ast::Expr) -> Expr {
        let value = self.real_value(receiver);
        if value.ty == Ty::ERROR {
            return value;
        }
        let inner = self.sema.nullable_of(value.ty).unwrap_or(value.ty);
        if self.sema.is_value_type(value.ty) && inner == value.ty {
            let shown = self.show(value.ty);
            return self.error(
                pos,
                23,
                format!("Operator '?' cannot be applied to operand of type '{shown}'"),
            );
        }
        let (number, held) = self.held(inner, pos);
        self.receivers.push(held);
        let result = self.value(chain);
        self.receivers.pop();
        if result.ty == Ty::ERROR || result.ty == Ty::VOID {
            let ty = result.ty;
            return make(ty, pos, Kind::Conditional(Box::new(value), number, Box::new(result)));
        }
        let ty = if self.sema.is_value_type(result.ty) && self.sema.nullable_of(result.ty).is_none() {
            self.sema.nullable(result.ty)
        } else {
            result.ty
        };
        let result = self.retyped(result, ty);
        make(ty, pos, Kind::Conditional(Box::new(value), number, Box::new(result)))
    }
}
