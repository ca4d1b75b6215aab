//! The library that programs may use: declared and mostly written in C#, with what is left done here.

mod array;
mod clock;
mod culture;
mod decimal;
mod delegate;
mod format;
mod list;
mod math;
mod number;
mod object;
mod regex;
mod string;

use crate::program::Program;
use crate::sema::{Prim, Sema, Ty};
use crate::vm::elements::Elements;
use crate::vm::heap::Obj;
use crate::vm::value::{Handle, Value};
use crate::vm::{Raise, State};

pub(crate) use object::text_of;

/// The texts of the library.
pub(crate) const SOURCES: &[(&str, &str)] = &[
    ("core.cs", include_str!("cs/core.cs")),
    ("numbers.cs", include_str!("cs/numbers.cs")),
    ("decimal.cs", include_str!("cs/decimal.cs")),
    ("text.cs", include_str!("cs/text.cs")),
    ("collections.cs", include_str!("cs/collections.cs")),
    ("linq.cs", include_str!("cs/linq.cs")),
    ("comparer.cs", include_str!("cs/comparer.cs")),
    ("tuples.cs", include_str!("cs/tuples.cs")),
    ("time.cs", include_str!("cs/time.cs")),
    ("dates.cs", include_str!("cs/dates.cs")),
    ("regex.cs", include_str!("cs/regex.cs")),
    ("guid.cs", include_str!("cs/guid.cs")),
    ("drawing.cs", include_str!("cs/drawing.cs")),
    ("dynamic.cs", include_str!("cs/dynamic.cs")),
    ("vb.cs", include_str!("cs/vb.cs")),
];

/// A function of the library: it finds its arguments in the call.
pub(crate) type Native = fn(&mut Cx<'_>) -> Result<Value, Raise>;

/// The function of a key.
pub(crate) fn find(key: &str) -> Option<Native> {
    math::find(key)
        .or_else(|| number::find(key))
        .or_else(|| decimal::find(key))
        .or_else(|| string::find(key))
        .or_else(|| list::find(key))
        .or_else(|| array::find(key))
        .or_else(|| object::find(key))
        .or_else(|| clock::find(key))
        .or_else(|| delegate::find(key))
        .or_else(|| regex::find(key))
}

/// A call of the library or the host.
pub struct Cx<'a> {
    /// The machine.
    pub st: &'a mut State,
    pub(crate) program: &'a mut Program,
    pub(crate) at: usize,
    pub(crate) count: usize,
    pub(crate) references: u64,
    /// The type that the member belongs to, or the first type argument of its method.
    pub ty: Ty,
}

impl Cx<'_> {
    /// How many arguments there are.
    pub fn len(&self) -> usize {
        self.count
    }

    /// Whether there are none.
    pub fn is_empty(&self) -> bool {
        self.count == 0
    }

    /// An argument; of instance members the first is the object. Constructors begin at 1.
    pub fn arg(&self, i: usize) -> Value {
        self.st.stack.get(self.at + i).copied().unwrap_or(Value::Null)
    }

    /// Whether an argument is a reference to a variable, `ref` or `out`: a struct may stand for itself there.
    pub fn is_reference(&self, i: usize) -> bool {
        i < 64 && self.references >> i & 1 == 1
    }

    /// A whole number.
    pub fn int(&self, i: usize) -> i32 {
        self.arg(i).whole().unwrap_or(0) as i32
    }

    /// A number.
    pub fn real(&self, i: usize) -> f64 {
        self.arg(i).real().unwrap_or(0.0)
    }

    /// A truth value.
    pub fn truth(&self, i: usize) -> bool {
        self.arg(i) == Value::Bool(true)
    }

    /// The characters of a text; empty for null.
    pub fn units(&self, i: usize) -> &[u16] {
        self.st.heap.str(self.arg(i)).unwrap_or(&[])
    }

    /// A text.
    pub fn string(&self, i: usize) -> String {
        String::from_utf16_lossy(self.units(i))
    }

    /// The object of an argument.
    pub fn handle(&self, i: usize) -> Result<Handle, Raise> {
        match self.arg(i) {
            Value::Ref(handle) => Ok(handle),
            _ => Err(Raise::new(
                "NullReferenceException",
                "Object reference not set to an instance of an object",
            )),
        }
    }

    /// Sets the variable behind a `ref` or `out` argument.
    pub fn set(&mut self, i: usize, value: Value) {
        let reference = self.arg(i);
        self.st.write(reference, value, self.program);
    }

    /// The value behind a `ref` argument.
    pub fn read(&self, i: usize) -> Value {
        self.st.read(self.arg(i), self.program)
    }

    /// A text in the heap.
    pub fn text(&mut self, text: &str) -> Value {
        self.st.text(text)
    }

    /// The field of a struct or class of the host's declarations, by its place.
    pub fn field(&self, of: Value, i: usize) -> Value {
        match of {
            Value::Ref(handle) => match self.st.heap.get(handle) {
                Obj::Inst(_, fields) => fields.get(i).copied().unwrap_or(Value::Null),
                _ => Value::Null,
            },
            _ => Value::Null,
        }
    }

    /// Sets the first fields of a struct or class, in place.
    pub fn set_fields(&mut self, of: Value, values: &[Value]) {
        if let Value::Ref(handle) = of
            && let Some(Obj::Inst(_, fields)) = self.st.heap.get_mut(handle)
        {
            for (field, value) in fields.iter_mut().zip(values) {
                *field = *value;
            }
        }
    }

    /// A new object of a type with these fields.
    pub fn instance(&mut self, ty: Ty, fields: &[Value]) -> Value {
        self.program.layout(ty);
        Value::Ref(self.st.heap.add(Obj::Inst(ty, fields.into())))
    }

    /// A struct whose fields are all zero; null for any other type.
    pub fn default_of(&mut self, ty: Ty) -> Value {
        self.st.default_of(self.program, ty)
    }

    /// A new object of the host.
    pub fn host_object(&mut self, ty: Ty, data: Box<dyn std::any::Any + Send>) -> Value {
        Value::Ref(self.st.heap.add(Obj::Host(ty, data)))
    }

    /// An object of the host.
    pub fn host_data<T: 'static>(&self, of: Value) -> Option<&T> {
        match of {
            Value::Ref(handle) => match self.st.heap.get(handle) {
                Obj::Host(_, data) => data.downcast_ref(),
                _ => None,
            },
            _ => None,
        }
    }

    /// An object of the host, to change.
    pub fn host_data_mut<T: 'static>(&mut self, of: Value) -> Option<&mut T> {
        match of {
            Value::Ref(handle) => match self.st.heap.get_mut(handle) {
                Some(Obj::Host(_, data)) => data.downcast_mut(),
                _ => None,
            },
            _ => None,
        }
    }

    /// A declared type by its namespace and name.
    pub fn type_named(&mut self, namespace: &str, name: &str) -> Option<Ty> {
        let def = self.program.sema.library(namespace, name, 0)?;
        Some(self.program.sema.named(def, &[]))
    }

    /// What is declared.
    pub fn sema(&mut self) -> &mut Sema {
        &mut self.program.sema
    }

    pub(crate) fn array(&mut self, element: Ty, data: Vec<Value>) -> Result<Value, Raise> {
        self.array_of(element, data.into())
    }

    pub(crate) fn array_of(&mut self, element: Ty, data: Elements) -> Result<Value, Raise> {
        self.st.reserve(data.bytes())?;
        let ty = self.program.sema.array(element, 1);
        Ok(Value::Ref(self.st.heap.add(Obj::Array(ty, data, None))))
    }

    pub(crate) fn prim(&self, prim: Prim) -> Ty {
        self.st.prims[prim as usize]
    }
}
