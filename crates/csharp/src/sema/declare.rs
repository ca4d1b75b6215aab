//! Syntax trees to declarations: first the names of all types, then bases, then members.

use std::collections::HashMap;
use std::sync::Arc;

use super::{
    Access, Body, DefId, FieldDef, FieldId, Known, Member, MethodDef, MethodId, NameScope, ParamDef, ParamId,
    Prim, PropDef, PropId, Sema, Ty, TypeDef, TypeParamDef, UsingScope,
};
use crate::syntax::ast::{
    self, Member as Written, Modifiers, Name, Namespace, Passing, TypeDecl, TypeKind, TypeParam, TypeRef,
};

impl Sema {
    /// Declares all types of files. Faults are kept.
    pub fn declare(&mut self, files: &[Namespace], library: bool) {
        let first = self.defs.len();
        self.declared_before = first;
        for file in files {
            self.declare_names(file, "", None, library);
        }
        let new: Vec<_> = (first..self.defs.len()).map(|i| DefId(i as u32)).collect();
        if self.known.object == Ty::ERROR {
            self.learn_known();
        }
        for def in &new {
            self.declare_bases(*def);
        }
        for def in &new {
            self.break_rings(*def);
        }
        for def in &new {
            self.declare_members(*def);
        }
        for def in new {
            if !library {
                self.check_members(def);
            }
        }
        if library {
            self.noted.clear();
        }
    }

    fn declare_names(
        &mut self,
        space: &Namespace,
        outer: &str,
        scope: Option<Arc<UsingScope>>,
        library: bool,
    ) {
        let name = match (outer.is_empty(), space.name.is_empty()) {
            (_, true) => outer.to_owned(),
            (true, false) => space.name.clone(),
            (false, false) => format!("{outer}.{}", space.name),
        };
        let mut around = String::new();
        for part in name.split('.').filter(|p| !p.is_empty()) {
            if !around.is_empty() {
                around.push('.');
            }
            around.push_str(part);
            self.namespaces.insert(around.clone());
        }
        let mut level = UsingScope { namespace: name.clone(), outer: scope, ..UsingScope::default() };
        // Inside a.b.c also a.b and a are looked in.
        let mut parent = name.rsplit_once('.').map(|(before, _)| before.to_owned());
        while let Some(before) = parent {
            parent = before.rsplit_once('.').map(|(b, _)| b.to_owned());
            level.namespaces.push(before);
        }
        for using in &space.usings {
            if using.statics {
                level.statics.push(using.target.clone());
            } else if let Some(alias) = &using.alias {
                level.aliases.push((alias.clone(), using.target.clone()));
            } else if let ast::TypeRefKind::Named(parts) = &using.target.kind {
                let name = parts.iter().map(|p| &*p.name).collect::<Vec<_>>().join(".");
                level.namespaces.push(name);
            }
        }
        let scope = Arc::new(level);
        for decl in &space.types {
            self.declare_type(decl, &name, None, &scope, library);
        }
        for inner in &space.inner {
            self.declare_names(inner, &name, Some(scope.clone()), library);
        }
    }

    fn declare_type(
        &mut self,
        decl: &Arc<TypeDecl>,
        namespace: &str,
        outer: Option<DefId>,
        scope: &Arc<UsingScope>,
        library: bool,
    ) {
        let key = (namespace.to_owned(), decl.name.clone());
        let own = decl.type_params.len();
        let outer_params = outer.map(|o| self.def(o).params.clone()).unwrap_or_default();
        if outer.is_none()
            && let Some(list) = self.by_name.get(&key)
            && list.iter().any(|d| d.0 as usize >= self.declared_before && self.def(*d).params.len() == own)
        {
            if decl.modifiers.has("partial") {
                self.fault(decl.pos, 0, "A partial type is not supported");
            } else {
                let space = if namespace.is_empty() { "<global namespace>" } else { namespace };
                self.fault(
                    decl.pos,
                    101,
                    format!("The namespace '{space}' already contains a definition for '{}'", decl.name),
                );
            }
            return;
        }
        let mut params = outer_params;
        for param in &decl.type_params {
            params.push(self.new_param(param));
        }
        let id = DefId(self.defs.len() as u32);
        let is_system = library && outer.is_none() && namespace == "System";
        self.defs.push(TypeDef {
            name: decl.name.clone(),
            namespace: namespace.into(),
            outer,
            kind: decl.kind,
            params,
            is_static: decl.modifiers.has("static"),
            is_abstract: decl.modifiers.has("abstract"),
            is_sealed: decl.modifiers.has("sealed"),
            library,
            prim: if is_system { Prim::by_name(&decl.name) } else { None },
            base: None,
            interfaces: Vec::new(),
            members: HashMap::new(),
            fields: Vec::new(),
            statics: Vec::new(),
            methods: Vec::new(),
            props: Vec::new(),
            invoke: None,
            decl: Some(decl.clone()),
            scope: scope.clone(),
            pos: decl.pos,
            native: decl.attributes.iter().any(|a| &**a == "Native"),
        });
        match outer {
            None => {
                // The user's own types come before the host's, the host's before the library's.
                self.by_name.entry(key).or_default().insert(0, id);
            }
            Some(outer) => self.add_member(outer, &decl.name, Member::Type(id)),
        }
        for member in &decl.members {
            if let Written::Type(inner) = member {
                self.declare_type(inner, namespace, Some(id), scope, library);
            }
        }
    }

    fn new_param(&mut self, param: &TypeParam) -> ParamId {
        let id = ParamId(self.params.len() as u32);
        self.params.push(TypeParamDef {
            name: param.name.clone(),
            bounds: Vec::new(),
            class: param.class,
            structure: param.structure,
            creatable: param.creatable || param.structure,
        });
        id
    }

    fn add_member(&mut self, def: DefId, name: &Name, member: Member) {
        self.defs[def.0 as usize].members.entry(name.clone()).or_default().push(member);
    }

    /// Where names inside a type are looked up.
    pub fn scope_of(&self, def: DefId, params: &[ParamId]) -> NameScope {
        NameScope { def: Some(def), params: params.to_vec(), usings: self.def(def).scope.clone() }
    }

    fn declare_members(&mut self, id: DefId) {
        let Some(decl) = self.def(id).decl.clone() else { return };
        if let Some(invoke) = &decl.invoke {
            let method = self.declare_method(id, invoke);
            self.methods[method.0 as usize].body = Body::Invoke;
            self.defs[id.0 as usize].invoke = Some(method);
        }
        let mut previous = None;
        for value in &decl.values {
            let ty = self.open(id);
            let field = self.new_field(FieldDef {
                name: value.name.clone(),
                owner: id,
                ty,
                is_static: true,
                constant: true,
                readonly: true,
                access: Access::Public,
                value: value.value.clone().map(Arc::new),
                previous,
                known: Known::No,
                index: 0,
                pos: value.pos,
            });
            previous = Some(field);
        }
        for member in &decl.members {
            match member {
                Written::Field(words, ty, variables) => self.declare_fields(id, *words, ty, variables),
                Written::Method(method) => {
                    self.declare_method(id, method);
                }
                Written::Property(property) => self.declare_property(id, property),
                Written::Type(_) => {}
            }
        }
        let has_constructor = self.def(id).members.contains_key(".ctor");
        if !has_constructor && self.def(id).kind == TypeKind::Class && !self.def(id).is_static {
            self.default_constructor(id, &decl);
        }
    }

    fn default_constructor(&mut self, id: DefId, decl: &TypeDecl) {
        self.new_method(MethodDef {
            name: ".ctor".into(),
            owner: id,
            params: Vec::new(),
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
            pos: decl.pos,
        });
    }

    fn declare_fields(&mut self, id: DefId, words: Modifiers, ty: &TypeRef, variables: &[ast::Variable]) {
        let scope = self.scope_of(id, &[]);
        let ty = self.resolve(ty, &scope);
        if ty == Ty::VOID {
            self.fault(variables.first().map_or(0, |v| v.pos), 670, "Field cannot have void type");
        }
        let access = access(words, Access::Private);
        for variable in variables {
            self.new_field(FieldDef {
                name: variable.name.clone(),
                owner: id,
                ty,
                is_static: words.has("static") || words.has("const"),
                constant: words.has("const"),
                readonly: words.has("readonly"),
                access,
                value: variable.value.clone().map(Arc::new),
                previous: None,
                known: Known::No,
                index: 0,
                pos: variable.pos,
            });
        }
    }

    fn new_field(&mut self, mut field: FieldDef) -> FieldId {
        let id = FieldId(self.fields.len() as u32);
        let def = &mut self.defs[field.owner.0 as usize];
        if !field.constant {
            let list = if field.is_static { &mut def.statics } else { &mut def.fields };
            field.index = list.len() as u32;
            list.push(id);
        }
        let (owner, name) = (field.owner, field.name.clone());
        self.fields.push(field);
        self.add_member(owner, &name, Member::Field(id));
        id
    }

    fn new_method(&mut self, method: MethodDef) -> MethodId {
        let id = MethodId(self.methods.len() as u32);
        let (owner, name) = (method.owner, method.name.clone());
        if method.extends {
            self.extensions.entry(name.clone()).or_default().push(id);
        }
        let explicit = method.explicit.is_some();
        self.methods.push(method);
        self.defs[owner.0 as usize].methods.push(id);
        if !explicit {
            self.add_member(owner, &name, Member::Method(id));
        }
        id
    }

    fn params_of(&mut self, written: &[ast::Param], scope: &NameScope) -> Vec<ParamDef> {
        written
            .iter()
            .map(|param| ParamDef {
                name: param.name.clone(),
                ty: self.resolve(&param.ty, scope),
                passing: param.passing,
                rest: param.rest,
                default: param.default.clone().map(Arc::new),
            })
            .collect()
    }

    /// Declares a method.
    pub fn declare_method(&mut self, owner: DefId, written: &Arc<ast::Method>) -> MethodId {
        let mut type_params = Vec::new();
        for param in &written.type_params {
            type_params.push(self.new_param(param));
        }
        let scope = self.scope_of(owner, &type_params);
        for (param, written) in type_params.iter().zip(&written.type_params) {
            let bounds = written.bounds.iter().map(|b| self.resolve(b, &scope)).collect();
            self.params[param.0 as usize].bounds = bounds;
        }
        let params = self.params_of(&written.params, &scope);
        let ret = match &written.ret {
            Some(ret) => self.resolve(ret, &scope),
            None => Ty::VOID,
        };
        let explicit = written.explicit.as_ref().map(|i| self.resolve(i, &scope));
        let words = written.modifiers;
        let interface = self.def(owner).kind == TypeKind::Interface;
        let body = if words.has("extern") {
            Body::Extern(self.extern_key(owner, &written.name, &written.params))
        } else if written.body.is_none() {
            Body::None
        } else {
            Body::Written(written.clone())
        };
        if written.iterator && params.iter().any(|p| p.passing != Passing::Value) {
            self.fault(written.pos, 1623, "Iterators cannot have ref, in or out parameters");
        }
        self.new_method(MethodDef {
            name: written.name.clone(),
            owner,
            extends: written.params.first().is_some_and(|p| p.extends),
            params,
            ret,
            by_ref: words.has("ref"),
            type_params,
            is_static: words.has("static"),
            is_virtual: words.has("virtual") || words.has("abstract") || words.has("override") || interface,
            is_override: words.has("override"),
            is_abstract: words.has("abstract") || (interface && written.body.is_none()),
            access: if interface || explicit.is_some() {
                Access::Public
            } else {
                access(words, Access::Private)
            },
            explicit,
            body,
            iterator: written.iterator,
            pos: written.pos,
        })
    }

    /// Declares the signature of a function in a function: it is no member of its type.
    pub fn declare_local(
        &mut self,
        owner: DefId,
        written: &Arc<ast::Method>,
        params: &[ParamId],
    ) -> MethodId {
        let scope = self.scope_of(owner, params);
        let id = MethodId(self.methods.len() as u32);
        let list = self.params_of(&written.params, &scope);
        let ret = written.ret.as_ref().map_or(Ty::VOID, |ret| self.resolve(ret, &scope));
        self.methods.push(MethodDef {
            name: written.name.clone(),
            owner,
            params: list,
            ret,
            by_ref: written.modifiers.has("ref"),
            type_params: Vec::new(),
            is_static: true,
            is_virtual: false,
            is_override: false,
            is_abstract: false,
            extends: false,
            access: Access::Public,
            explicit: None,
            body: Body::None,
            iterator: false,
            pos: written.pos,
        });
        id
    }

    /// The key under which the library or the host does what a member does: `Math.Abs(int)`.
    fn extern_key(&self, owner: DefId, name: &str, params: &[ast::Param]) -> Name {
        let types: Vec<_> = params.iter().map(|p| key_of(&p.ty)).collect();
        let name = if name == ".ctor" { "new" } else { name };
        format!("{}.{name}({})", self.def(owner).name, types.join(",")).into()
    }

    fn declare_property(&mut self, owner: DefId, written: &Arc<ast::Property>) {
        let scope = self.scope_of(owner, &[]);
        let ty = self.resolve(&written.ty, &scope);
        let params = self.params_of(&written.params, &scope);
        let explicit = written.explicit.as_ref().map(|i| self.resolve(i, &scope));
        let words = written.modifiers;
        let interface = self.def(owner).kind == TypeKind::Interface;
        let is_static = words.has("static");
        let empty = |accessor: &Option<(u32, Modifiers, Option<ast::FnBody>)>| {
            accessor.as_ref().is_none_or(|(_, _, body)| body.is_none())
        };
        let automatic = !interface
            && !words.has("abstract")
            && !words.has("extern")
            && empty(&written.getter)
            && empty(&written.setter)
            && written.getter.is_some();
        let member_access =
            if interface || explicit.is_some() { Access::Public } else { access(words, Access::Private) };
        let field = automatic.then(|| {
            self.new_field(FieldDef {
                name: format!("<{}>", written.name).into(),
                owner,
                ty,
                is_static,
                constant: false,
                readonly: false,
                access: Access::Private,
                value: written.value.clone().map(Arc::new),
                previous: None,
                known: Known::No,
                index: 0,
                pos: written.pos,
            })
        });
        let accessor = |sema: &mut Self, set: bool| {
            let side = if set { &written.setter } else { &written.getter };
            let (pos, own, body) = side.as_ref()?;
            let subscribes = words.has("event") && body.is_some();
            let word = match (subscribes, set) {
                (true, false) => "add",
                (true, true) => "remove",
                (false, false) => "get",
                (false, true) => "set",
            };
            let name: Name = format!("{word}_{}", written.name).into();
            let mut params = params.clone();
            if set || subscribes {
                params.push(ParamDef {
                    name: "value".into(),
                    ty,
                    passing: Passing::Value,
                    rest: false,
                    default: None,
                });
            }
            let kind = if words.has("extern") {
                Body::Extern(sema.extern_key(owner, &name, &written.params))
            } else if body.is_some() {
                Body::Accessor(written.clone(), set)
            } else if let Some(field) = field {
                Body::Auto(field, set)
            } else {
                Body::None
            };
            Some(sema.new_method(MethodDef {
                name,
                owner,
                params,
                ret: if set || subscribes { Ty::VOID } else { ty },
                by_ref: !set && words.has("ref"),
                type_params: Vec::new(),
                is_static,
                is_virtual: words.has("virtual")
                    || words.has("abstract")
                    || words.has("override")
                    || interface,
                is_override: words.has("override"),
                is_abstract: words.has("abstract") || (interface && body.is_none()),
                extends: false,
                access: if interface { Access::Public } else { access(*own, member_access) },
                explicit,
                body: kind,
                iterator: !set && written.iterator,
                pos: *pos,
            }))
        };
        let getter = accessor(self, false);
        let setter = accessor(self, true);
        let id = PropId(self.props.len() as u32);
        self.props.push(PropDef {
            name: written.name.clone(),
            owner,
            ty,
            params,
            is_static,
            getter,
            setter,
            field,
            access: member_access,
            explicit,
            is_event: words.has("event"),
            is_override: words.has("override"),
        });
        self.defs[owner.0 as usize].props.push(id);
        if explicit.is_none() {
            self.add_member(owner, &written.name, Member::Prop(id));
        }
    }
}

fn access(words: Modifiers, otherwise: Access) -> Access {
    if words.has("public") || words.has("internal") {
        Access::Public
    } else if words.has("protected") {
        Access::Protected
    } else if words.has("private") {
        Access::Private
    } else {
        otherwise
    }
}

/// A parameter's type as keys spell it: the last part of its name.
fn key_of(ty: &TypeRef) -> String {
    match &ty.kind {
        ast::TypeRefKind::Named(parts) => {
            let Some(last) = parts.last() else { return String::new() };
            if last.args.is_empty() {
                return last.name.to_string();
            }
            let args: Vec<_> = last.args.iter().map(key_of).collect();
            format!("{}<{}>", last.name, args.join(","))
        }
        ast::TypeRefKind::Array(element, rank) => {
            format!("{}[{}]", key_of(element), ",".repeat(usize::from(*rank) - 1))
        }
        ast::TypeRefKind::Nullable(inner) => format!("{}?", key_of(inner)),
        ast::TypeRefKind::Tuple(_) => "tuple".to_owned(),
        ast::TypeRefKind::Var => "var".to_owned(),
    }
}
