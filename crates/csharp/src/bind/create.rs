//! New objects, arrays, initialisers, anonymous objects, tuples.

use std::collections::HashMap;
use std::sync::Arc;

use super::{Binder, Group, Item, make};
use crate::bound::{Const, Expr, FieldRef, Kind, MethodRef};
use crate::sema::{Access, Body, DefId, FieldId, Known, Member, ParamDef, Sema, Ty, TypeDef, TypeParamDef};
use crate::source::Pos;
use crate::syntax::ast::{self, ExprKind, Init, InitTarget, InitValue, Name, NamePart, Passing, TypeKind};

impl Binder<'_> {
    /// `new T(...) { ... }`
    pub(super) fn creation(&mut self, pos: Pos, ty: Ty, args: &[ast::Arg], init: Option<&Init>) -> Expr {
        if ty == Ty::ERROR {
            for arg in args {
                self.speculate(|b| b.item(&arg.value));
            }
            return self.wrong(pos);
        }
        let object = self.new_object(pos, ty, args);
        match init {
            Some(init) if object.ty != Ty::ERROR => {
                let (number, held) = self.held(ty, pos);
                let steps = self.initialiser(held, init);
                make(ty, pos, Kind::Initialise(Box::new(object), number, steps))
            }
            _ => object,
        }
    }

    fn new_object(&mut self, pos: Pos, ty: Ty, args: &[ast::Arg]) -> Expr {
        if self.sema.is_param(ty) {
            let crate::sema::Kind::Param(param) = self.sema.types.kind(ty).clone() else {
                return self.wrong(pos);
            };
            if !self.sema.param(param).creatable {
                let shown = self.show(ty);
                return self.error(pos, 304, format!("Cannot create an instance of the variable type '{shown}' because it does not have the new() constraint"));
            }
            return make(
                ty,
                pos,
                Kind::New(
                    MethodRef { id: crate::sema::MethodId(u32::MAX), owner: ty, args: Vec::new() },
                    Vec::new(),
                ),
            );
        }
        let Some(def) = self.sema.def_of(ty) else {
            return self.error(pos, 1526, "A new expression requires a type");
        };
        let info = self.sema.def(def);
        let shown = self.sema.show(ty);
        match info.kind {
            TypeKind::Interface => {
                return self.error(
                    pos,
                    144,
                    format!("Cannot create an instance of the abstract type or interface '{shown}'"),
                );
            }
            TypeKind::Class if info.is_static => {
                return self.error(
                    pos,
                    712,
                    format!("Cannot create an instance of the static class '{shown}'"),
                );
            }
            TypeKind::Class if info.is_abstract => {
                return self.error(
                    pos,
                    144,
                    format!("Cannot create an instance of the abstract type or interface '{shown}'"),
                );
            }
            TypeKind::Delegate => {
                let [arg] = args else { return self.error(pos, 149, "Method name expected") };
                let item = self.item(&arg.value);
                return self.convert(item, ty, arg.value.pos);
            }
            TypeKind::Struct | TypeKind::Enum if args.is_empty() && self.no_empty_constructor(def) => {
                return make(ty, pos, Kind::Default(ty));
            }
            _ => {}
        }
        if let (Some(inner), [arg]) = (self.sema.nullable_of(ty), args) {
            let item = self.item(&arg.value);
            let value = self.convert(item, inner, arg.value.pos);
            return self.retyped(value, ty);
        }
        match self.constructor(pos, ty, args) {
            Some((method, args)) => make(ty, pos, Kind::New(method, args)),
            None => self.wrong(pos),
        }
    }

    pub(super) fn no_empty_constructor(&self, def: DefId) -> bool {
        let list = self.sema.def(def).members.get(".ctor");
        !list.is_some_and(|l| {
            l.iter().any(|m| matches!(m, Member::Method(id) if self.sema.method(*id).params.is_empty()))
        })
    }

    fn initialiser(&mut self, held: Expr, init: &Init) -> Vec<Expr> {
        match init {
            Init::Members(list) => {
                list.iter().map(|(target, value)| self.set_member(&held, target, value)).collect()
            }
            Init::Elements(list) => list.iter().map(|values| self.add_element(&held, values)).collect(),
        }
    }

    fn set_member(&mut self, held: &Expr, target: &InitTarget, value: &InitValue) -> Expr {
        let (pos, place) = match target {
            InitTarget::Member(pos, name) => {
                let part = NamePart { pos: *pos, name: name.clone(), args: Vec::new(), open: 0 };
                let members = self.sema.members(held.ty, name);
                if members.is_empty() {
                    let shown = self.show(held.ty);
                    return self.error(
                        *pos,
                        117,
                        format!("'{shown}' does not contain a definition for '{name}'"),
                    );
                }
                let item = self.member_of(*pos, held.clone(), &part);
                (*pos, self.as_value(item, *pos))
            }
            InitTarget::Index(pos, args) => (*pos, self.element(*pos, held.clone(), args)),
        };
        match value {
            InitValue::Value(e) => {
                let item = self.item(e);
                self.assign_to(pos, place, item, e.pos)
            }
            InitValue::Nested(init) => {
                let ty = place.ty;
                let (number, inner) = self.held(ty, pos);
                let steps = self.initialiser(inner, init);
                make(ty, pos, Kind::Initialise(Box::new(place), number, steps))
            }
        }
    }

    fn add_element(&mut self, held: &Expr, values: &[ast::Expr]) -> Expr {
        let pos = values.first().map_or(held.pos, |v| v.pos);
        let part = NamePart { pos, name: "Add".into(), args: Vec::new(), open: 0 };
        let args: Vec<_> = values
            .iter()
            .map(|value| ast::Arg { name: None, passing: Passing::Value, value: value.clone() })
            .collect();
        match self.member_of(pos, held.clone(), &part) {
            Item::Methods(group) => self.call_group(pos, Group::clone(&group), &args),
            item => {
                let value = self.as_value(item, pos);
                if value.ty != Ty::ERROR {
                    self.error(pos, 1922, "Cannot initialize type with a collection initializer because it does not implement 'System.Collections.IEnumerable'")
                } else {
                    value
                }
            }
        }
    }

    pub(super) fn new_array(
        &mut self,
        pos: Pos,
        element: Option<&ast::TypeRef>,
        sizes: &[ast::Expr],
        rank: u8,
        init: Option<&ast::Expr>,
    ) -> Expr {
        let element = match element {
            Some(element) => self.resolve(element),
            None => match init.map(|i| &i.kind) {
                Some(ExprKind::ArrayInit(values)) => {
                    let items: Vec<_> = values.iter().map(|v| self.item(v)).collect();
                    match self.common_type(&items) {
                        Some(ty) => ty,
                        None => return self.error(pos, 826, "No best type found for implicitly-typed array"),
                    }
                }
                _ => Ty::ERROR,
            },
        };
        if element == Ty::ERROR {
            return self.wrong(pos);
        }
        let ty = self.sema.array(element, rank);
        if let Some(init) = init {
            let ExprKind::ArrayInit(values) = &init.kind else { return self.wrong(pos) };
            return self.array_of(pos, ty, values, sizes);
        }
        let sizes = sizes.iter().map(|s| self.array_index(s)).collect();
        make(ty, pos, Kind::NewArray(element, sizes))
    }

    /// `{ 1, 2 }` for an array type.
    pub(super) fn array_of(&mut self, pos: Pos, ty: Ty, values: &[ast::Expr], sizes: &[ast::Expr]) -> Expr {
        let crate::sema::Kind::Array(element, rank) = self.sema.types.kind(ty).clone() else {
            return self.error(pos, 622, "Can only use array initializer expressions to assign to array types. Try using a new expression instead.");
        };
        let mut lengths = Vec::new();
        let mut made = Vec::new();
        self.array_values(values, element, rank, 0, &mut lengths, &mut made);
        for (size, length) in sizes.iter().zip(&lengths) {
            let given = self.value(size);
            if given.kind_const() != Some(i128::from(*length)) {
                self.fault(size.pos, 847, format!("An array initializer of length '{length}' is expected"));
            }
        }
        let lengths = if rank == 1 { Vec::new() } else { lengths };
        make(ty, pos, Kind::ArrayOf(element, made, lengths))
    }

    fn array_values(
        &mut self,
        values: &[ast::Expr],
        element: Ty,
        rank: u8,
        at: u8,
        lengths: &mut Vec<u32>,
        made: &mut Vec<Expr>,
    ) {
        if lengths.len() <= usize::from(at) {
            lengths.push(values.len() as u32);
        } else if lengths[usize::from(at)] != values.len() as u32 {
            let expected = lengths[usize::from(at)];
            self.fault(
                values.first().map_or(0, |v| v.pos),
                847,
                format!("An array initializer of length '{expected}' is expected"),
            );
        }
        for value in values {
            match (&value.kind, at + 1 < rank) {
                (ExprKind::ArrayInit(inner), true) => {
                    self.array_values(inner, element, rank, at + 1, lengths, made)
                }
                (_, true) => self.fault(value.pos, 846, "A nested array initializer is expected"),
                (ExprKind::ArrayInit(inner), false) => {
                    let array = self.array_of(value.pos, element, inner, &[]);
                    made.push(array);
                }
                (_, false) => {
                    let item = self.item(value);
                    made.push(self.convert(item, element, value.pos));
                }
            }
        }
    }

    pub(super) fn tuple_item(&mut self, pos: Pos, parts: &[(Option<Name>, ast::Expr)]) -> Item {
        let items = parts
            .iter()
            .map(|(name, part)| {
                let name = name.clone().or_else(|| match &part.kind {
                    ExprKind::Name(p) | ExprKind::Member(_, p) => Some(p.name.clone()),
                    _ => None,
                });
                (name, self.item(part))
            })
            .collect();
        Item::Tuple(pos, items)
    }

    pub(super) fn natural_tuple(&mut self, pos: Pos, parts: Vec<(Option<Name>, Item)>) -> Expr {
        let (mut types, mut names, mut values) = (Vec::new(), Vec::new(), Vec::new());
        for (name, part) in parts {
            let value = self.as_value(part, pos);
            if value.ty == Ty::NULL {
                return self.error(pos, 815, "Cannot assign (<null>) to an implicitly-typed variable");
            }
            types.push(value.ty);
            names.push(name);
            values.push(value);
        }
        let ty = self.sema.tuple(pos, &types, names);
        make(ty, pos, Kind::Tuple(values))
    }

    pub(super) fn tuple_as(&mut self, pos: Pos, parts: Vec<(Option<Name>, Item)>, to: Ty) -> Expr {
        let target = self.sema.nullable_of(to).unwrap_or(to);
        match self.sema.tuple_parts(target) {
            Some(types) if types.len() == parts.len() => {
                let values =
                    parts.into_iter().zip(types).map(|((_, part), ty)| self.convert(part, ty, pos)).collect();
                let tuple = make(target, pos, Kind::Tuple(values));
                self.retyped(tuple, to)
            }
            _ => {
                let value = self.natural_tuple(pos, parts);
                self.convert(Item::Value(value), to, pos)
            }
        }
    }

    /// A field of a tuple by its place.
    pub(super) fn tuple_element(&mut self, tuple: Expr, i: usize, ty: Ty) -> Expr {
        let pos = tuple.pos;
        let owner = tuple.ty;
        let Some(def) = self.sema.def_of(owner) else { return self.wrong(pos) };
        let Some(id) = self.sema.def(def).fields.get(i).copied() else { return self.wrong(pos) };
        make(ty, pos, Kind::Field(Some(Box::new(tuple)), FieldRef { id, owner }))
    }

    /// A tuple's element by the name that its type gives it.
    pub(super) fn tuple_member(&mut self, pos: Pos, value: &Expr, part: &NamePart) -> Option<Item> {
        let crate::sema::Kind::Tuple(_, names) = self.sema.types.kind(value.ty).clone() else { return None };
        let i = names.iter().position(|n| n.as_ref() == Some(&part.name))?;
        let ty = self.sema.tuple_parts(value.ty)?.get(i).copied()?;
        let mut element = self.tuple_element(value.clone(), i, ty);
        element.pos = pos;
        Some(Item::Value(element))
    }

    pub(super) fn anonymous(&mut self, pos: Pos, members: &[(Name, ast::Expr)]) -> Expr {
        let mut values = Vec::new();
        for (_, e) in members {
            values.push(self.real_value(e));
        }
        if values.iter().any(|v| v.ty == Ty::ERROR) {
            return self.wrong(pos);
        }
        let names: Vec<_> = members.iter().map(|(name, _)| name.clone()).collect();
        let def = match self.sema.anonymous.get(&names) {
            Some(def) => *def,
            None => declare_anonymous(self.sema, &names, pos),
        };
        let types: Vec<_> = values.iter().map(|v| v.ty).collect();
        let ty = self.sema.named(def, &types);
        let Some(Member::Method(id)) =
            self.sema.def(def).members.get(".ctor").and_then(|l| l.first()).copied()
        else {
            return self.wrong(pos);
        };
        let args = values.into_iter().map(|v| (Passing::Value, v)).collect();
        make(ty, pos, Kind::New(MethodRef { id, owner: ty, args: Vec::new() }, args))
    }
}

impl Expr {
    /// The whole number that an expression is.
    pub(crate) fn kind_const(&self) -> Option<i128> {
        match &self.kind {
            Kind::Const(Const::Int(n)) => Some(*n),
            _ => None,
        }
    }
}

/// A class with a readable field for each name; equality, hash and text are the library's.
fn declare_anonymous(sema: &mut Sema, names: &[Name], pos: Pos) -> DefId {
    let def = DefId(sema.defs.len() as u32);
    let mut params = Vec::new();
    let mut types = Vec::new();
    for name in names {
        let id = crate::sema::ParamId(sema.params.len() as u32);
        sema.params.push(TypeParamDef {
            name: format!("<{name}>").into(),
            bounds: Vec::new(),
            class: false,
            structure: false,
            creatable: false,
        });
        params.push(id);
        types.push(sema.types.intern(crate::sema::Kind::Param(id)));
    }
    let base = sema.library("System", "AnonymousObject", 0).map(|d| sema.named(d, &[]));
    let mut members: HashMap<Name, Vec<Member>> = HashMap::new();
    let mut fields = Vec::new();
    for (i, (name, ty)) in names.iter().zip(&types).enumerate() {
        let id = FieldId(sema.fields.len() as u32);
        sema.fields.push(crate::sema::FieldDef {
            name: name.clone(),
            owner: def,
            ty: *ty,
            is_static: false,
            constant: false,
            readonly: true,
            access: Access::Public,
            value: None,
            previous: None,
            known: Known::No,
            index: i as u32,
            pos,
        });
        members.entry(name.clone()).or_default().push(Member::Field(id));
        fields.push(id);
    }
    let ctor = crate::sema::MethodId(sema.methods.len() as u32);
    sema.methods.push(crate::sema::MethodDef {
        name: ".ctor".into(),
        owner: def,
        params: names
            .iter()
            .zip(&types)
            .map(|(name, ty)| ParamDef {
                name: name.clone(),
                ty: *ty,
                passing: Passing::Value,
                rest: false,
                default: None,
            })
            .collect(),
        ret: Ty::VOID,
        by_ref: false,
        type_params: Vec::new(),
        is_static: false,
        is_virtual: false,
        is_override: false,
        is_abstract: false,
        extends: false,
        access: Access::Public,
        explicit: None,
        body: Body::Default,
        iterator: false,
        pos,
    });
    members.entry(".ctor".into()).or_default().push(Member::Method(ctor));
    sema.defs.push(TypeDef {
        name: "<>__AnonType".into(),
        namespace: "".into(),
        outer: None,
        kind: TypeKind::Class,
        params,
        is_static: false,
        is_abstract: false,
        is_sealed: true,
        library: true,
        prim: None,
        base,
        interfaces: Vec::new(),
        members,
        fields,
        statics: Vec::new(),
        methods: vec![ctor],
        props: Vec::new(),
        invoke: None,
        decl: None,
        scope: Arc::new(crate::sema::UsingScope::default()),
        pos,
        native: false,
    });
    sema.anonymous.insert(names.to_vec(), def);
    def
}
