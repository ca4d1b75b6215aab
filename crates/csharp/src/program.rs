//! A program that is being run: declarations, functions compiled as they are called, layouts of objects.

use std::collections::HashMap;
use std::sync::Arc;

use crate::bind;
use crate::bound::{self, MethodRef};
use crate::sema::{Body, DefId, Kind, MAX_TYPE_DEPTH, MAX_TYPES, MethodId, Sema, Ty};
use crate::syntax::ast::{Name, Passing, TypeKind};
use crate::vm::heap::ZERO;
use crate::vm::op::{Function, Op};
use crate::vm::value::{Handle, Value};

/// What a function is compiled from.
#[derive(Debug, Clone, PartialEq, Eq, Hash)]
pub(crate) enum Key {
    /// A method for types.
    Method(MethodId, Ty, Vec<Ty>),
    /// First values of static fields.
    Statics(Ty),
    /// An operation on `dynamic` values, by its site, for operands of these types.
    Dynamic(u32, Vec<Ty>),
}

/// An operation on `dynamic` values.
#[derive(Debug, Clone)]
pub(crate) struct DynamicSite {
    pub(crate) op: bound::DynamicOp,
    /// The class that it stands in: what it may use.
    pub(crate) def: DefId,
    pub(crate) operands: usize,
    pub(crate) pos: crate::source::Pos,
    /// The last kinds of operands and their functions.
    pub(crate) cache: Vec<(Vec<Ty>, u32)>,
}

/// Texts, each with its place among the constants of a function.
pub(crate) type PlacedTexts = Vec<(u32, Arc<[u16]>)>;

/// What a new object begins with.
#[derive(Debug, Clone, Copy)]
pub(crate) enum Start {
    Value(Value),
    Struct(Ty),
}

/// How an object is made.
#[derive(Debug, Clone)]
pub(crate) struct Layout {
    pub(crate) fields: Vec<Start>,
    /// Which fields are structs, that are copied with it.
    pub(crate) structs: Vec<u16>,
    pub(crate) is_struct: bool,
}

/// Something that only the host or the library does.
#[derive(Debug, Clone)]
pub(crate) struct NativeRef {
    pub(crate) key: Name,
    pub(crate) params: u16,
    /// A bit for each argument that is a reference to a variable, from the lowest.
    pub(crate) references: u64,
    pub(crate) kind: NativeKind,
}

#[derive(Debug, Clone, Copy)]
pub(crate) enum NativeKind {
    Library(crate::library::Native),
    Host(u32),
    Missing,
}

/// A call whose method depends on the object.
#[derive(Debug, Clone)]
pub(crate) struct Site {
    pub(crate) method: MethodRef,
    /// The last two types and what they called.
    pub(crate) cache: [(Ty, Target); 2],
}

/// What runs for a type.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(crate) enum Target {
    Function(u32),
    Native(u32, Ty),
    GenNext,
    GenDispose,
    None,
}

/// A program.
pub(crate) struct Program {
    /// Declarations.
    pub sema: Sema,
    pub(crate) funcs: Vec<Function>,
    /// The code of all functions that are compiled.
    pub(crate) code: Vec<Op>,
    pub(crate) keys: HashMap<Key, u32>,
    pub(crate) sources: Vec<Option<Key>>,
    pub(crate) bodies: HashMap<MethodId, Option<Arc<bound::Body>>>,
    /// Methods that only compute, of those that were asked for.
    pub(crate) quiet: HashMap<MethodId, Option<crate::emit::Quiet>>,
    /// Methods of structs that are short enough to stand in place of their calls, as far as they were asked for.
    pub(crate) steps: HashMap<MethodId, Option<Arc<bound::Body>>>,
    pub(crate) inits: HashMap<DefId, Option<Arc<bound::Body>>>,
    pub(crate) layouts: Vec<Option<Arc<Layout>>>,
    pub(crate) natives: Vec<NativeRef>,
    pub(crate) native_keys: HashMap<Name, u32>,
    pub(crate) sites: Vec<Site>,
    pub(crate) dynamics: Vec<DynamicSite>,
    pub(crate) dynamic_bodies: HashMap<u32, Arc<bound::Body>>,
    /// Static fields by their type and number.
    pub(crate) statics: HashMap<Ty, u32>,
    pub(crate) static_values: Vec<Value>,
    /// For each type with static fields: its function, and whether it ran.
    pub(crate) static_inits: Vec<(u32, bool)>,
    pub(crate) init_keys: HashMap<Ty, Option<u32>>,
    pub(crate) subtypes: HashMap<(Ty, Ty), bool>,
    /// Texts of constants.
    pub(crate) texts: HashMap<Arc<[u16]>, Handle>,
    /// Texts of lambdas that wait to be put into the heap.
    pub(crate) pending_texts: Vec<(u32, PlacedTexts)>,
    /// The host's numbers for its members.
    pub(crate) host_keys: HashMap<Name, u32>,
}

impl Program {
    /// A program of what is declared.
    pub(crate) fn new(sema: Sema) -> Self {
        Self {
            sema,
            funcs: Vec::new(),
            code: Vec::new(),
            keys: HashMap::new(),
            sources: Vec::new(),
            bodies: HashMap::new(),
            quiet: HashMap::new(),
            steps: HashMap::new(),
            inits: HashMap::new(),
            layouts: Vec::new(),
            natives: Vec::new(),
            native_keys: HashMap::new(),
            sites: Vec::new(),
            dynamics: Vec::new(),
            dynamic_bodies: HashMap::new(),
            statics: HashMap::new(),
            static_values: Vec::new(),
            static_inits: Vec::new(),
            init_keys: HashMap::new(),
            subtypes: HashMap::new(),
            texts: HashMap::new(),
            pending_texts: Vec::new(),
            host_keys: HashMap::new(),
        }
    }

    /// The number of a function, which is compiled when it is first called.
    pub(crate) fn function(&mut self, key: Key) -> u32 {
        if let Some(number) = self.keys.get(&key) {
            return *number;
        }
        let number = self.funcs.len() as u32;
        self.funcs.push(Function::default());
        self.sources.push(Some(key.clone()));
        self.keys.insert(key, number);
        number
    }

    /// The bound body of a method.
    pub(crate) fn body(&mut self, id: MethodId) -> Option<Arc<bound::Body>> {
        if let Some(body) = self.bodies.get(&id) {
            return body.clone();
        }
        let body = bind::bind_method(&mut self.sema, id).map(Arc::new);
        self.bodies.insert(id, body.clone());
        body
    }

    /// The bound first values of a type's static fields.
    pub(crate) fn static_body(&mut self, def: DefId) -> Option<Arc<bound::Body>> {
        if let Some(body) = self.inits.get(&def) {
            return body.clone();
        }
        let body = bind::bind_static_init(&mut self.sema, def).map(Arc::new);
        self.inits.insert(def, body.clone());
        body
    }

    /// The number of what runs the static fields of a type.
    pub(crate) fn static_init(&mut self, ty: Ty) -> Option<u32> {
        if let Some(known) = self.init_keys.get(&ty) {
            return *known;
        }
        let def = self.sema.def_of(ty)?;
        let init = self.static_body(def).map(|_| {
            let function = self.function(Key::Statics(ty));
            self.static_inits.push((function, false));
            self.static_inits.len() as u32 - 1
        });
        self.init_keys.insert(ty, init);
        init
    }

    /// The number of a type's first static field.
    pub(crate) fn static_base(&mut self, ty: Ty) -> u32 {
        if let Some(base) = self.statics.get(&ty) {
            return *base;
        }
        let base = self.static_values.len() as u32;
        self.statics.insert(ty, base);
        let fields = self.sema.def_of(ty).map(|d| self.sema.def(d).statics.clone()).unwrap_or_default();
        for field in fields {
            let field_ty = self.field_type(ty, field);
            let start = match self.start(field_ty) {
                Start::Value(value) => value,
                // A struct is made when the first who comes needs it.
                Start::Struct(_) => Value::Null,
            };
            self.static_values.push(start);
        }
        base
    }

    /// The type of a field of a type.
    pub(crate) fn field_type(&mut self, owner: Ty, field: crate::sema::FieldId) -> Ty {
        let by = self.sema.substitution(owner);
        let ty = self.sema.field(field).ty;
        let ty = self.sema.types.substitute(ty, &by);
        self.sema.types.erase(ty)
    }

    /// What a variable of a type begins with.
    pub(crate) fn start(&mut self, ty: Ty) -> Start {
        use crate::sema::Prim;
        if self.sema.is_enum(ty) {
            return Start::Value(Value::Enum(ty, 0));
        }
        if let Some(prim) = self.sema.prim(ty) {
            return Start::Value(match prim {
                Prim::Bool => Value::Bool(false),
                Prim::Char => Value::Char(0),
                Prim::I8 => Value::I8(0),
                Prim::U8 => Value::U8(0),
                Prim::I16 => Value::I16(0),
                Prim::U16 => Value::U16(0),
                Prim::I32 => Value::I32(0),
                Prim::U32 => Value::U32(0),
                Prim::I64 => Value::I64(0),
                Prim::U64 => Value::U64(0),
                Prim::F32 => Value::F32(0.0),
                Prim::F64 => Value::F64(0.0),
                Prim::Decimal => Value::Ref(ZERO),
            });
        }
        if self.sema.is_struct(ty) { Start::Struct(ty) } else { Start::Value(Value::Null) }
    }

    /// The layout of a type's objects: fields of base classes first.
    pub(crate) fn layout(&mut self, ty: Ty) -> Arc<Layout> {
        if let Some(Some(layout)) = self.layouts.get(ty.0 as usize) {
            return layout.clone();
        }
        let mut chain = self.sema.chain(ty);
        chain.reverse();
        let mut fields = Vec::new();
        for owner in chain {
            let list = self.sema.def_of(owner).map(|d| self.sema.def(d).fields.clone()).unwrap_or_default();
            for field in list {
                let field_ty = self.field_type(owner, field);
                let start = if field_ty == ty { Start::Value(Value::Null) } else { self.start(field_ty) };
                fields.push(start);
            }
        }
        let structs =
            (0..fields.len()).filter(|i| matches!(fields[*i], Start::Struct(_))).map(|i| i as u16).collect();
        let layout = Arc::new(Layout { fields, structs, is_struct: self.sema.is_struct(ty) });
        if self.layouts.len() <= ty.0 as usize {
            self.layouts.resize(ty.0 as usize + 1, None);
        }
        self.layouts[ty.0 as usize] = Some(layout.clone());
        for start in &layout.fields {
            if let Start::Struct(inner) = start {
                self.layout(*inner);
            }
        }
        layout
    }

    /// The layout of a type that values are copied of.
    pub(crate) fn layout_if_struct(&mut self, ty: Ty) {
        if self.sema.is_struct(ty) {
            self.layout(ty);
        }
    }

    /// The place of a field among all fields of an object.
    pub(crate) fn field_index(&mut self, owner: Ty, field: crate::sema::FieldId) -> u16 {
        let mut before = 0;
        let mut chain = self.sema.chain(owner);
        let declaring = self.sema.field(field).owner;
        // The owner may be a derived type: fields of the bases of the declaring type come first.
        while let Some(first) = chain.first()
            && self.sema.def_of(*first) != Some(declaring)
        {
            chain.remove(0);
        }
        for base in chain.into_iter().skip(1) {
            before += self.sema.def_of(base).map_or(0, |d| self.sema.def(d).fields.len());
        }
        (before + self.sema.field(field).index as usize) as u16
    }

    /// The number of something the library or host does. `references` are the places of arguments that are `ref` or `out`.
    pub(crate) fn native(&mut self, key: &Name, params: usize, references: &[usize]) -> u32 {
        if let Some(number) = self.native_keys.get(key) {
            return *number;
        }
        let kind = match (self.host_keys.get(key), crate::library::find(key)) {
            (Some(number), _) => NativeKind::Host(*number),
            (None, Some(native)) => NativeKind::Library(native),
            (None, None) => NativeKind::Missing,
        };
        let number = self.natives.len() as u32;
        let references = references.iter().filter(|i| **i < 64).fold(0, |bits, i| bits | 1 << i);
        self.natives.push(NativeRef { key: key.clone(), params: params as u16, references, kind });
        self.native_keys.insert(key.clone(), number);
        number
    }

    /// What runs when a method is called that does not depend on the object any more.
    pub(crate) fn target(&mut self, method: &MethodRef) -> Target {
        let info = self.sema.method(method.id);
        let (owner, params, is_static) = (info.owner, info.params.len(), info.is_static);
        match info.body.clone() {
            Body::Extern(key) => match &*key {
                "Iterator.MoveNext()" => Target::GenNext,
                "Iterator.Dispose()" => Target::GenDispose,
                _ => {
                    let first = usize::from(!is_static);
                    let params_of = self.sema.method(method.id).params.iter().enumerate();
                    let references: Vec<usize> = params_of
                        .filter(|(_, p)| matches!(p.passing, Passing::Ref | Passing::Out))
                        .map(|(i, _)| first + i)
                        .collect();
                    let number = self.native(&key, first + params, &references);
                    let ty = method.args.first().copied().unwrap_or(method.owner);
                    Target::Native(number, ty)
                }
            },
            Body::None | Body::Invoke => Target::None,
            _ => {
                let _ = owner;
                Target::Function(self.function(Key::Method(method.id, method.owner, method.args.clone())))
            }
        }
    }

    /// What runs for an object of a type at a site.
    pub(crate) fn resolve_site(&mut self, site: u32, ty: Ty) -> Target {
        let Some(found) = self.sites.get(site as usize) else { return Target::None };
        let method = found.method.clone();
        let target = match self.sema.find_override(ty, &method) {
            Some(found) => self.target(&found),
            None => Target::None,
        };
        if let Some(found) = self.sites.get_mut(site as usize) {
            found.cache[1] = found.cache[0];
            found.cache[0] = (ty, target);
        }
        target
    }

    /// A new site of calls of a method.
    pub(crate) fn site(&mut self, method: MethodRef) -> u32 {
        self.sites.push(Site { method, cache: [(Ty::ERROR, Target::None); 2] });
        self.sites.len() as u32 - 1
    }

    /// Whether values of a type are of another.
    pub(crate) fn is_subtype(&mut self, from: Ty, to: Ty) -> bool {
        if from == to {
            return true;
        }
        if let Some(known) = self.subtypes.get(&(from, to)) {
            return *known;
        }
        let is = self.sema.is_subtype(from, to);
        self.subtypes.insert((from, to), is);
        is
    }

    /// Whether types have grown beyond what is allowed.
    pub(crate) fn too_many_types(&self, ty: Ty) -> bool {
        self.sema.types.depth(ty) > MAX_TYPE_DEPTH || ty.0 as usize > MAX_TYPES
    }

    /// Whether a type is a class that its objects are made of by fields.
    pub(crate) fn is_native_type(&self, ty: Ty) -> bool {
        match self.sema.types.kind(ty) {
            Kind::Named(def, _) => {
                let def = self.sema.def(*def);
                def.native && def.kind != TypeKind::Interface
            }
            _ => false,
        }
    }
}
