//! Syntax trees to declarations: first the names of all types, then bases, then members.

use std::collections::HashMap;
use std::sync::Arc;

use super::{
    Access, Body, DefId, FieldDef, FieldId, Kind, Known, Member, MethodDef, MethodId, NameScope, ParamDef,
    ParamId, Prim, PropDef, PropId, Sema, Ty, TypeDef, TypeParamDef, UsingScope,
};
use crate::syntax::ast::{
    self, Member as Written, Modifiers, Name, Namespace, Passing, TypeDecl, TypeKind, TypeParam, TypeRef,
};

impl Sema {
    /// Declares all types of files. Faults are kept.
    pub fn declare(&mut self, files: &[Namespace], library: bool) {
        let first = self.defs.len();
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
            && let Some(before) = list
                .iter()
                .copied()
                .find(|d| self.def(*d).params.len() == own && (self.def(*d).library == library))
        {
            if decl.modifiers.has("partial") {
                self.fault(decl.pos, 0, "A partial type is not supported");
            } else {
                let _ = before;
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
                // The user's own types come before the library's.
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

    fn learn_known(&mut self) {
        let get = |namespace: &str, name: &str, arity: usize| {
            self.library(namespace, name, arity).unwrap_or(DefId(0))
        };
        let defs = [
            get("System", "Nullable", 1),
            get("System", "ArrayImpl", 1),
            get("System.Collections.Generic", "IEnumerable", 1),
            get("System.Collections.Generic", "IEnumerator", 1),
            get("System", "Iterator", 1),
        ];
        let plain: Vec<_> = [
            ("System", "Object"),
            ("System", "String"),
            ("System", "Boolean"),
            ("System", "Char"),
            ("System", "Int32"),
            ("System", "UInt32"),
            ("System", "Int64"),
            ("System", "UInt64"),
            ("System", "Single"),
            ("System", "Double"),
            ("System", "Decimal"),
            ("System", "Array"),
            ("System", "ValueType"),
            ("System", "Enum"),
            ("System", "Delegate"),
            ("System", "Exception"),
            ("System", "Type"),
            ("System.Collections", "IEnumerable"),
            ("System.Collections", "IEnumerator"),
            ("System", "IDisposable"),
        ]
        .iter()
        .map(|(namespace, name)| get(namespace, name, 0))
        .collect();
        let t: Vec<_> = plain.into_iter().map(|def| self.named(def, &[])).collect();
        self.known = super::Known_ {
            object: t[0],
            string: t[1],
            bool: t[2],
            char: t[3],
            int: t[4],
            uint: t[5],
            long: t[6],
            ulong: t[7],
            float: t[8],
            double: t[9],
            decimal: t[10],
            array: t[11],
            value_type: t[12],
            enumeration: t[13],
            delegate: t[14],
            exception: t[15],
            type_: t[16],
            plain_enumerable: t[17],
            plain_enumerator: t[18],
            disposable: t[19],
            nullable: defs[0],
            array_impl: defs[1],
            enumerable: defs[2],
            enumerator: defs[3],
            iterator: defs[4],
        };
    }

    /// Where names inside a type are looked up.
    pub fn scope_of(&self, def: DefId, params: &[ParamId]) -> NameScope {
        NameScope { def: Some(def), params: params.to_vec(), usings: self.def(def).scope.clone() }
    }

    fn declare_bases(&mut self, id: DefId) {
        let Some(decl) = self.def(id).decl.clone() else { return };
        let mut scope = self.scope_of(id, &[]);
        // Bases are looked up from outside, but see the type's own parameters.
        scope.params = self.def(id).params.clone();
        scope.def = self.def(id).outer;
        let params = self.def(id).params.clone();
        let own = params.len() - decl.type_params.len();
        for (param, written) in params.iter().skip(own).zip(&decl.type_params) {
            let bounds = written.bounds.iter().map(|b| self.resolve(b, &scope)).collect();
            self.params[param.0 as usize].bounds = bounds;
        }
        for (i, base) in decl.bases.iter().enumerate() {
            let ty = self.resolve(base, &scope);
            if ty == Ty::ERROR {
                continue;
            }
            let kind = self.type_kind(ty);
            let def = &mut self.defs[id.0 as usize];
            match (def.kind, kind) {
                (TypeKind::Enum, _) => def.base = Some(ty),
                (_, Some(TypeKind::Interface)) => def.interfaces.push(ty),
                (TypeKind::Class, Some(TypeKind::Class)) if i == 0 => def.base = Some(ty),
                _ => {
                    let shown = self.show(ty);
                    self.fault(
                        base.pos,
                        527,
                        format!("Type '{shown}' in interface list is not an interface"),
                    );
                    continue;
                }
            }
            if self.def(id).kind == TypeKind::Class && kind == Some(TypeKind::Class) && !self.def(id).library
            {
                self.check_base(id, ty, base.pos);
            }
        }
    }

    fn check_base(&mut self, id: DefId, base: Ty, pos: u32) {
        let Some(def) = self.def_of(base) else { return };
        let (mine, theirs) = (self.show_def(id), self.show(base));
        if self.def(def).is_sealed || self.def(def).is_static {
            self.fault(pos, 509, format!("'{mine}': cannot derive from sealed type '{theirs}'"));
        } else if self.def(def).native {
            self.fault(pos, 0, format!("A class derived from '{theirs}' is not supported"));
        }
    }

    fn show_def(&mut self, id: DefId) -> String {
        let open = self.open(id);
        self.show(open)
    }

    /// A class that is its own base would be gone through for ever.
    fn break_rings(&mut self, id: DefId) {
        let mut at = id;
        for _ in 0..64 {
            let Some(base) = self.def(at).base.and_then(|base| self.def_of(base)) else { return };
            if base == id {
                break;
            }
            at = base;
        }
        let shown = self.show_def(id);
        self.fault(self.def(id).pos, 146, format!("Circular base class dependency involving '{shown}'"));
        self.defs[id.0 as usize].base = None;
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
            let name: Name = format!("{}_{}", if set { "set" } else { "get" }, written.name).into();
            let mut params = params.clone();
            if set {
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
                ret: if set { Ty::VOID } else { ty },
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
            is_override: words.has("override"),
        });
        self.defs[owner.0 as usize].props.push(id);
        if explicit.is_none() {
            self.add_member(owner, &written.name, Member::Prop(id));
        }
    }

    /// What is declared twice, and what a class leaves undone.
    fn check_members(&mut self, id: DefId) {
        let members: Vec<_> = self.def(id).members.clone().into_iter().collect();
        let owner = self.show_def(id);
        for (name, list) in members {
            for (i, a) in list.iter().enumerate() {
                for b in &list[i + 1..] {
                    self.check_pair(&owner, &name, *a, *b);
                }
            }
        }
        self.check_implemented(id);
        let chain = self.def(id).methods.clone();
        for method in chain {
            if self.method(method).is_override {
                self.check_override(id, method);
            }
            let (abstract_, pos) = (self.method(method).is_abstract, self.method(method).pos);
            if abstract_ && self.def(id).kind == TypeKind::Class && !self.def(id).is_abstract {
                let shown = self.show_method(method);
                self.fault(
                    pos,
                    513,
                    format!("'{shown}' is abstract but it is contained in non-abstract class '{owner}'"),
                );
            }
            if matches!(self.method(method).body, Body::None)
                && !abstract_
                && self.def(id).kind != TypeKind::Interface
            {
                let shown = self.show_method(method);
                self.fault(
                    pos,
                    501,
                    format!(
                        "'{shown}' must declare a body because it is not marked abstract, extern, or partial"
                    ),
                );
            }
        }
    }

    fn check_pair(&mut self, owner: &str, name: &Name, a: Member, b: Member) {
        let (pos, clash) = match (a, b) {
            (Member::Method(a), Member::Method(b)) => {
                let (a, b) = (self.method(a), self.method(b));
                let same = a.params.len() == b.params.len()
                    && a.type_params.len() == b.type_params.len()
                    && a.params.iter().zip(&b.params).all(|(p, q)| {
                        p.ty == q.ty && (p.passing == Passing::Value) == (q.passing == Passing::Value)
                    })
                    && (!name.starts_with("op_") || a.ret == b.ret);
                if same && &**name != ".cctor" {
                    let message = format!(
                        "Type '{owner}' already defines a member called '{name}' with the same parameter types"
                    );
                    let pos = b.pos;
                    self.fault(pos, 111, message);
                }
                return;
            }
            (_, Member::Field(f)) => (self.field(f).pos, true),
            (Member::Prop(_), Member::Prop(p)) => (0, self.prop(p).params.is_empty()),
            (Member::Field(_), Member::Method(m)) => (self.method(m).pos, true),
            _ => (0, false),
        };
        if clash {
            self.fault(pos, 102, format!("The type '{owner}' already contains a definition for '{name}'"));
        }
    }

    fn check_override(&mut self, id: DefId, method: MethodId) {
        let name = self.method(method).name.clone();
        let open = self.open(id);
        let args: Vec<_> = self
            .method(method)
            .type_params
            .clone()
            .into_iter()
            .map(|p| self.types.intern(Kind::Param(p)))
            .collect();
        let mut chain = self.chain(open);
        chain.remove(0);
        for base in chain {
            let Some(def) = self.def_of(base) else { continue };
            for member in self.def(def).members.get(&name).cloned().unwrap_or_default() {
                if let Member::Method(other) = member {
                    let reference = crate::bound::MethodRef { id: other, owner: base, args: args.clone() };
                    if self.same_signature(method, open, &reference) {
                        if !self.method(other).is_virtual {
                            let (mine, theirs) = (self.show_method(method), self.show_method(other));
                            self.fault(self.method(method).pos, 506, format!("'{mine}': cannot override inherited member '{theirs}' because it is not marked virtual, abstract, or override"));
                        }
                        return;
                    }
                }
            }
        }
        let shown = self.show_method(method);
        self.fault(self.method(method).pos, 115, format!("'{shown}': no suitable method found to override"));
    }

    fn check_implemented(&mut self, id: DefId) {
        let def = self.def(id);
        if !matches!(def.kind, TypeKind::Class | TypeKind::Struct) {
            return;
        }
        let (is_abstract, pos) = (def.is_abstract, def.pos);
        let open = self.open(id);
        let owner = self.show(open);
        for interface in self.interfaces(open) {
            let Some(declared) = self.def_of(interface) else { continue };
            for method in self.def(declared).methods.clone() {
                if !self.method(method).is_abstract {
                    continue;
                }
                let args: Vec<_> = self
                    .method(method)
                    .type_params
                    .clone()
                    .into_iter()
                    .map(|p| self.types.intern(Kind::Param(p)))
                    .collect();
                let called = crate::bound::MethodRef { id: method, owner: interface, args };
                if self.find_override(open, &called).is_none() && !is_abstract {
                    let shown = self.show_method(method);
                    self.fault(pos, 535, format!("'{owner}' does not implement interface member '{shown}'"));
                }
            }
        }
        if is_abstract {
            return;
        }
        let mut chain = self.chain(open);
        chain.remove(0);
        for base in chain {
            let Some(def) = self.def_of(base) else { continue };
            for method in self.def(def).methods.clone() {
                if !self.method(method).is_abstract {
                    continue;
                }
                let args: Vec<_> = self
                    .method(method)
                    .type_params
                    .clone()
                    .into_iter()
                    .map(|p| self.types.intern(Kind::Param(p)))
                    .collect();
                let called = crate::bound::MethodRef { id: method, owner: base, args };
                if self.find_override(open, &called).is_none_or(|found| self.method(found.id).is_abstract) {
                    let shown = self.show_method(method);
                    self.fault(
                        pos,
                        534,
                        format!("'{owner}' does not implement inherited abstract member '{shown}'"),
                    );
                }
            }
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
