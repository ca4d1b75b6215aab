//! What changes while a program runs.

use super::heap::{Heap, Obj};
use super::value::{Handle, Value};
use crate::host::Host;
use crate::sema::{Prim, Sema, Ty};

/// What a run may use.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct Limits {
    /// Turns of loops and calls.
    pub steps: u64,
    /// Bytes of objects.
    pub bytes: usize,
    /// Calls in one another.
    pub depth: usize,
    /// Bytes of printed text.
    pub output: usize,
}

impl Default for Limits {
    fn default() -> Self {
        Self { steps: 20_000_000_000, bytes: 1 << 30, depth: 10_000, output: 16 << 20 }
    }
}

/// Why a run was stopped from outside the program.
#[derive(Debug, Clone, PartialEq, Eq, thiserror::Error)]
pub enum Stop {
    /// Too many turns.
    #[error("the script took more than {0} steps")]
    Steps(u64),
    /// Too many bytes.
    #[error("the script needed more than {0} bytes")]
    Bytes(usize),
    /// Too many calls in one another.
    #[error("calls stand more than {0} deep in one another")]
    Depth(usize),
    /// The host said so.
    #[error("cancelled")]
    Cancelled,
    /// Too much text.
    #[error("the script printed more than {0} bytes")]
    Output(usize),
    /// Something that is not here.
    #[error("{0} is not supported")]
    NotSupported(String),
    /// A fault in a function of the library, found when it was first called.
    #[error("{0}")]
    Refused(String),
}

/// An exception of the library, or a stop.
#[derive(Debug, Clone, PartialEq)]
pub enum Raise {
    /// An exception by the name of its class in `System`, and its message.
    Exception(&'static str, String),
    /// An exception that is an object.
    Object(Value),
    /// The end.
    Stop(Stop),
}

impl Raise {
    /// An exception.
    pub fn new(name: &'static str, message: impl Into<String>) -> Self {
        Self::Exception(name, message.into())
    }
}

/// A call that is under way.
#[derive(Debug, Clone, Copy)]
pub(crate) struct Frame {
    pub(crate) func: u32,
    pub(crate) pc: u32,
    pub(crate) base: u32,
    /// The iterator whose body runs.
    pub(crate) gen_: Option<Handle>,
}

/// What changes while a program runs.
pub struct State {
    /// Objects.
    pub heap: Heap,
    pub(crate) stack: Vec<Value>,
    pub(crate) frames: Vec<Frame>,
    /// Limits.
    pub limits: Limits,
    pub(crate) steps: u64,
    pub(crate) fuel: u32,
    pub(crate) printed: usize,
    pub(crate) host: Box<dyn Host>,
    /// Types of predefined values, by [`Prim`].
    pub(crate) prims: [Ty; 13],
    /// Where the last exception was thrown.
    pub(crate) thrown_at: u32,
}

pub(crate) const FUEL: u32 = 4096;

impl State {
    pub(crate) fn new(host: Box<dyn Host>, limits: Limits, sema: &mut Sema) -> Self {
        let mut prims = [Ty::ERROR; 13];
        for name in [
            "Boolean", "Char", "SByte", "Byte", "Int16", "UInt16", "Int32", "UInt32", "Int64", "UInt64",
            "Single", "Double", "Decimal",
        ] {
            if let (Some(prim), Some(def)) = (Prim::by_name(name), sema.library("System", name, 0)) {
                prims[prim as usize] = sema.named(def, &[]);
            }
        }
        Self {
            heap: Heap::new(limits.bytes),
            stack: vec![Value::Null; 256],
            frames: Vec::new(),
            steps: limits.steps,
            limits,
            fuel: FUEL,
            printed: 0,
            host,
            prims,
            thrown_at: 0,
        }
    }

    /// Steps and printed text count for each run anew.
    pub(crate) fn renew(&mut self) {
        self.steps = self.limits.steps;
        self.printed = 0;
    }

    /// The type of a value at run time.
    pub fn type_of(&self, value: Value, sema: &Sema) -> Ty {
        let prim = |p: Prim| self.prims[p as usize];
        match value {
            Value::Null | Value::StackRef(_) | Value::PartRef(..) | Value::StaticRef(_) => Ty::NULL,
            Value::Bool(_) => prim(Prim::Bool),
            Value::Char(_) => prim(Prim::Char),
            Value::I8(_) => prim(Prim::I8),
            Value::U8(_) => prim(Prim::U8),
            Value::I16(_) => prim(Prim::I16),
            Value::U16(_) => prim(Prim::U16),
            Value::I32(_) => prim(Prim::I32),
            Value::U32(_) => prim(Prim::U32),
            Value::I64(_) => prim(Prim::I64),
            Value::U64(_) => prim(Prim::U64),
            Value::F32(_) => prim(Prim::F32),
            Value::F64(_) => prim(Prim::F64),
            Value::Enum(ty, _) => ty,
            Value::Ref(handle) => match self.heap.get(handle) {
                Obj::Str(_) => sema.known.string,
                Obj::Decimal(_) => prim(Prim::Decimal),
                Obj::Inst(ty, _)
                | Obj::Array(ty, ..)
                | Obj::List(ty, ..)
                | Obj::Delegate(ty, ..)
                | Obj::Host(ty, _) => *ty,
                Obj::Gen(generator) => generator.ty,
                Obj::Builder(_) => self.builder_type(sema),
                Obj::Type(_) => sema.known.type_,
                Obj::Free(_) => Ty::NULL,
            },
        }
    }

    fn builder_type(&self, sema: &Sema) -> Ty {
        let def = sema.library("System.Text", "StringBuilder", 0);
        def.and_then(|d| sema.types_of(d)).unwrap_or(sema.known.object)
    }

    /// Counts work beyond turns of loops.
    pub fn spend(&mut self, steps: usize) -> Result<(), Raise> {
        match self.steps.checked_sub(steps as u64) {
            Some(left) => {
                self.steps = left;
                Ok(())
            }
            None => Err(Raise::Stop(Stop::Steps(self.limits.steps))),
        }
    }

    /// Asks for bytes before they are taken.
    pub fn reserve(&mut self, bytes: usize) -> Result<(), Raise> {
        if self.heap.exceeds(bytes) { Err(Raise::Stop(Stop::Bytes(self.limits.bytes))) } else { Ok(()) }
    }

    /// A text in the heap.
    pub fn text(&mut self, text: &str) -> Value {
        let units: Vec<u16> = text.encode_utf16().collect();
        self.heap.text(&units)
    }

    /// A text as Rust has them.
    pub fn string(&self, value: Value) -> Option<String> {
        self.heap.str(value).map(String::from_utf16_lossy)
    }

    /// Prints.
    pub fn print(&mut self, text: &str) -> Result<(), Raise> {
        self.printed += text.len();
        if self.printed > self.limits.output {
            return Err(Raise::Stop(Stop::Output(self.limits.output)));
        }
        self.host.write(text);
        Ok(())
    }
}
