//! Names on their own: variables, members, types (C# specification, simple names).

use super::{Binder, Entry, Group, Item, make};
use crate::bound::{Expr, FieldRef, Kind, MethodRef};
use crate::sema::{Member, MethodId, Resolved, Ty};
use crate::source::Pos;
use crate::syntax::ast::{Name, NamePart};

impl Binder<'_> {
    pub(super) fn name(&mut self, part: &NamePart) -> Item {
        let pos = part.pos;
        let entry = self.find(&part.name);
        if let Some(entry) = entry.filter(|e| part.args.is_empty() || matches!(e, Entry::Lifted(_))) {
            return match entry {
                Entry::Lifted(method) => {
                    let receiver = if self.is_static { None } else { Some(self.this(pos)) };
                    let member = (self.this, Member::Method(method));
                    self.methods_item(pos, receiver, None, part, vec![member], false, None)
                }
                Entry::Local(id) => Item::Value(self.local(id, pos)),
                Entry::Constant(value) => Item::Value(Expr { pos, ..value }),
                Entry::Carried(id, name) => {
                    let carrier = self.local(id, pos);
                    self.member_of(pos, carrier, &NamePart { pos, name, args: Vec::new(), open: 0 })
                }
                Entry::Function(function) => Item::Methods(Box::new(Group {
                    pos,
                    receiver: Some(self.local(function.local, pos)),
                    on: None,
                    name: part.name.clone(),
                    type_args: Vec::new(),
                    candidates: vec![(self.this, function.method)],
                    base: false,
                    color: None,
                })),
            };
        }
        // Members of this type and of those around it.
        let mut around = Some(self.def);
        while let Some(def) = around {
            let ty = self.sema.open(def);
            if let Some(item) = self.own_member(pos, ty, part, def == self.def) {
                return item;
            }
            around = self.sema.def(def).outer;
        }
        if let Some(item) = self.static_using(part) {
            return item;
        }
        let scope = self.name_scope();
        match self.sema.lookup(part, &scope) {
            Some(Resolved::Type(ty)) => Item::Type(ty),
            Some(Resolved::Namespace(name)) => Item::Namespace(name),
            None => {
                let fault = if part.args.is_empty() {
                    (103, format!("The name '{}' does not exist in the current context", part.name))
                } else {
                    (305, format!("The name '{}' does not exist in the current context", part.name))
                };
                let code = if fault.0 == 305 { 103 } else { fault.0 };
                Item::Value(self.error(pos, code, fault.1))
            }
        }
    }

    fn own_member(&mut self, pos: Pos, ty: Ty, part: &NamePart, innermost: bool) -> Option<Item> {
        let members = self.sema.members(ty, &part.name);
        let first = members.first()?.1;
        if matches!(first, Member::Type(_)) {
            return None;
        }
        let is_static = self.all_static(first);
        if is_static {
            return Some(self.static_member(pos, ty, part, members));
        }
        if !innermost {
            return Some(Item::Value(self.no_instance(pos, first)));
        }
        let color = self.color(part);
        if self.is_static {
            // A static method may be among instance methods of the name.
            if let Member::Method(_) = first {
                return Some(self.methods_item(pos, None, Some(ty), part, members, false, color));
            }
            if let Some(ty) = color {
                return Some(Item::Type(ty));
            }
            return Some(Item::Value(self.no_instance(pos, first)));
        }
        let this = self.this(pos);
        Some(self.instance_member(pos, this, part, members, false, color))
    }

    /// A type with the same name as a member.
    fn color(&mut self, part: &NamePart) -> Option<Ty> {
        let scope = self.name_scope();
        match self.sema.lookup(part, &scope) {
            Some(Resolved::Type(ty)) => Some(ty),
            _ => None,
        }
    }

    fn all_static(&self, member: Member) -> bool {
        match member {
            Member::Field(f) => self.sema.field(f).is_static,
            Member::Prop(p) => self.sema.prop(p).is_static,
            Member::Method(m) => self.sema.method(m).is_static,
            Member::Type(_) => true,
        }
    }

    pub(super) fn no_instance(&mut self, pos: Pos, member: Member) -> Expr {
        let (owner, name) = match member {
            Member::Field(f) => (self.sema.field(f).owner, self.sema.field(f).name.clone()),
            Member::Prop(p) => (self.sema.prop(p).owner, self.sema.prop(p).name.clone()),
            Member::Method(m) => {
                let shown = self.sema.show_method(m);
                return self.error(pos, 120, format!("An object reference is required for the non-static field, method, or property '{shown}'"));
            }
            Member::Type(_) => return self.wrong(pos),
        };
        let owner = self.sema.def(owner).name.clone();
        if self.in_field_value {
            return self.error(pos, 236, format!("A field initializer cannot reference the non-static field, method, or property '{owner}.{name}'"));
        }
        self.error(pos, 120, format!("An object reference is required for the non-static field, method, or property '{owner}.{name}'"))
    }

    fn static_using(&mut self, part: &NamePart) -> Option<Item> {
        let scope = self.name_scope();
        let mut level = Some(scope.usings.clone());
        while let Some(usings) = level {
            for target in &usings.statics {
                let ty = self.sema.resolve(target, &scope);
                let members = self.sema.members(ty, &part.name);
                if members.first().is_some_and(|m| self.all_static(m.1) && !matches!(m.1, Member::Type(_))) {
                    return Some(self.static_member(part.pos, ty, part, members));
                }
            }
            level = usings.outer.clone();
        }
        None
    }

    pub(super) fn field(
        &mut self,
        pos: Pos,
        receiver: Option<Expr>,
        owner: Ty,
        id: crate::sema::FieldId,
    ) -> Expr {
        let by = self.sema.substitution(owner);
        let field = self.sema.field(id);
        let (ty, constant) = (field.ty, field.constant);
        let ty = self.sema.types.substitute(ty, &by);
        if constant {
            let value = super::constant_of(self.sema, id);
            return make(ty, pos, Kind::Const(value));
        }
        let receiver = if self.sema.field(id).is_static { None } else { receiver.map(Box::new) };
        make(ty, pos, Kind::Field(receiver, FieldRef { id, owner }))
    }

    pub(super) fn prop(
        &mut self,
        pos: Pos,
        receiver: Option<Expr>,
        owner: Ty,
        id: crate::sema::PropId,
        args: Vec<crate::bound::Arg>,
        virtual_: bool,
    ) -> Expr {
        self.check_event(pos, id);
        let by = self.sema.substitution(owner);
        let prop = self.sema.prop(id).clone();
        let ty = self.sema.types.substitute(prop.ty, &by);
        let (mut getter, mut setter) = (prop.getter, prop.setter);
        if prop.is_override && (getter.is_none() || setter.is_none()) {
            // The half that is not overridden is that of the base class.
            let chain = self.sema.chain(owner);
            for base in chain.into_iter().skip(1) {
                let Some(def) = self.sema.def_of(base) else { continue };
                for member in self.sema.def(def).members.get(&prop.name).cloned().unwrap_or_default() {
                    if let Member::Prop(other) = member {
                        getter = getter.or(self.sema.prop(other).getter);
                        setter = setter.or(self.sema.prop(other).setter);
                    }
                }
            }
        }
        let reference = |id: Option<MethodId>| id.map(|id| MethodRef { id, owner, args: Vec::new() });
        let is_virtual =
            virtual_ && [getter, setter].into_iter().flatten().any(|m| self.sema.method(m).is_virtual);
        let receiver = if prop.is_static { None } else { receiver.map(Box::new) };
        let made =
            make(ty, pos, Kind::Prop(receiver, args, reference(getter), reference(setter), is_virtual));
        match getter {
            Some(getter) => self.behind(getter, made),
            None => made,
        }
    }

    /// Whether what is declared may be used here; a fault when not.
    pub(super) fn check_access(&mut self, pos: Pos, member: Member) -> bool {
        let (owner, access, name): (_, _, Name) = match member {
            Member::Field(f) => {
                (self.sema.field(f).owner, self.sema.field(f).access, self.sema.field(f).name.clone())
            }
            Member::Prop(p) => {
                (self.sema.prop(p).owner, self.sema.prop(p).access, self.sema.prop(p).name.clone())
            }
            Member::Method(m) => {
                (self.sema.method(m).owner, self.sema.method(m).access, self.sema.method(m).name.clone())
            }
            Member::Type(_) => return true,
        };
        if self.sema.may_use(Some(self.def), owner, access) {
            return true;
        }
        let shown = match member {
            Member::Method(m) => self.sema.show_method(m),
            _ => format!("{}.{name}", self.sema.def(owner).name),
        };
        self.fault(pos, 122, format!("'{shown}' is inaccessible due to its protection level"));
        false
    }
}
