//! Objects, their bytes, and the collector: mark and sweep, only between two operations, when all that is alive is
//! reachable from registers, static fields and pins.

use std::any::Any;

use smallvec::SmallVec;

use super::elements::Elements;
use super::value::{Handle, Value};
use crate::decimal::Decimal;
use crate::sema::Ty;

/// Fields; few stand in the object itself.
pub type Fields = SmallVec<[Value; 3]>;

/// An object.
#[derive(Debug)]
pub enum Obj {
    /// Free; the next free one.
    Free(u32),
    /// A text.
    Str(Box<[u16]>),
    /// An instance of a class, a struct, or the captured variables of a block.
    Inst(Ty, Fields),
    /// An array, with its lengths where it has several dimensions.
    Array(Ty, Elements, Option<Box<[u32]>>),
    /// A list and how often it changed.
    List(Ty, Elements, u32),
    /// A `decimal`, which never changes: nobody copies it.
    Decimal(Decimal),
    /// A text that is being built.
    Builder(Vec<u16>),
    /// A delegate: its type, the function and its captured variables.
    Delegate(Ty, u32, Value),
    /// An iterator.
    Gen(Box<Generator>),
    /// A type.
    Type(Ty),
    /// An object of the host.
    Host(Ty, Box<dyn Any + Send>),
}

/// An iterator that stands still.
#[derive(Debug)]
pub struct Generator {
    /// Its type at run time.
    pub ty: Ty,
    /// The function.
    pub func: u32,
    /// The arguments that it began with.
    pub start: Vec<Value>,
    /// Its registers.
    pub regs: Vec<Value>,
    /// Where it goes on.
    pub pc: u32,
    /// How far it is.
    pub state: GenState,
    /// The last value.
    pub current: Value,
}

/// How far an iterator is.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum GenState {
    /// Nobody goes through it.
    Fresh,
    /// Its enumerator was handed out.
    Taken,
    /// It runs just now.
    Running,
    /// It waits.
    Suspended,
    /// It is at its end.
    Done,
}

/// All objects.
#[derive(Debug)]
pub struct Heap {
    objects: Vec<Obj>,
    marks: Vec<bool>,
    free: u32,
    /// Bytes in use, as of the last collection, and what came since.
    pub bytes: usize,
    /// The bytes at which the next collection is due.
    pub due: usize,
    /// The most bytes.
    pub limit: usize,
    /// Objects that stay, whoever reaches them: constants and what the host holds.
    pub pins: Vec<Handle>,
}

/// The decimal 0, with which variables begin: the first object of every heap.
pub(crate) const ZERO: Handle = Handle(0);

const NO_FREE: u32 = u32::MAX;
const OBJECT: usize = std::mem::size_of::<Obj>() + 1;
const FIRST_COLLECTION: usize = 8 << 20;

impl Heap {
    /// An empty heap.
    pub fn new(limit: usize) -> Self {
        Self {
            objects: vec![Obj::Decimal(Decimal::ZERO)],
            marks: vec![false],
            free: NO_FREE,
            bytes: 0,
            due: FIRST_COLLECTION,
            limit,
            pins: vec![ZERO],
        }
    }

    fn size(obj: &Obj) -> usize {
        OBJECT
            + match obj {
                Obj::Str(s) => s.len() * 2,
                Obj::Inst(_, fields) if fields.spilled() => fields.len() * 16,
                Obj::Array(_, data, _) => data.bytes(),
                Obj::List(_, data, _) => data.bytes(),
                Obj::Builder(b) => b.capacity() * 2,
                Obj::Gen(g) => (g.regs.len() + g.start.len()) * 16 + 96,
                Obj::Host(..) => 256,
                _ => 0,
            }
    }

    /// Puts an object into the heap.
    pub fn add(&mut self, obj: Obj) -> Handle {
        self.bytes += Self::size(&obj);
        if self.free != NO_FREE {
            let at = self.free;
            if let Some(slot) = self.objects.get_mut(at as usize) {
                if let Obj::Free(next) = slot {
                    self.free = *next;
                }
                *slot = obj;
            }
            return Handle(at);
        }
        self.objects.push(obj);
        self.marks.push(false);
        Handle(self.objects.len() as u32 - 1)
    }

    /// Whether so many more bytes go beyond the limit.
    pub fn exceeds(&self, more: usize) -> bool {
        self.bytes.saturating_add(more) > self.limit
    }

    /// An object.
    pub fn get(&self, handle: Handle) -> &Obj {
        self.objects.get(handle.0 as usize).unwrap_or(&Obj::Free(NO_FREE))
    }

    /// An object to change.
    pub fn get_mut(&mut self, handle: Handle) -> Option<&mut Obj> {
        self.objects.get_mut(handle.0 as usize)
    }

    /// A decimal.
    pub(crate) fn decimal(&self, value: Value) -> Option<Decimal> {
        match value {
            Value::Ref(handle) => match self.get(handle) {
                Obj::Decimal(x) => Some(*x),
                _ => None,
            },
            _ => None,
        }
    }

    /// A decimal as the nearest `double`; none for anything else.
    pub fn real_of_decimal(&self, value: Value) -> Option<f64> {
        self.decimal(value).map(crate::decimal::to_real)
    }

    /// A text.
    pub fn text(&mut self, units: &[u16]) -> Value {
        Value::Ref(self.add(Obj::Str(units.into())))
    }

    /// The characters of a text.
    pub fn str(&self, value: Value) -> Option<&[u16]> {
        match value {
            Value::Ref(handle) => match self.get(handle) {
                Obj::Str(units) => Some(units),
                _ => None,
            },
            _ => None,
        }
    }

    /// Frees what neither the roots nor the pins reach.
    pub fn collect<'r>(&mut self, roots: impl Iterator<Item = &'r Value>) {
        let mut todo: Vec<Handle> = self.pins.clone();
        let reach = |value: &Value, todo: &mut Vec<Handle>| {
            if let Value::Ref(h) | Value::PartRef(h, _) = value {
                todo.push(*h);
            }
        };
        for value in roots {
            reach(value, &mut todo);
        }
        while let Some(handle) = todo.pop() {
            match self.marks.get_mut(handle.0 as usize) {
                Some(mark) if !*mark => *mark = true,
                _ => continue,
            }
            match &self.objects[handle.0 as usize] {
                Obj::Inst(_, fields) => fields.iter().for_each(|v| reach(v, &mut todo)),
                Obj::Array(_, data, _) | Obj::List(_, data, _) => {
                    data.references().iter().for_each(|v| reach(v, &mut todo))
                }
                Obj::Delegate(_, _, env) => reach(env, &mut todo),
                Obj::Gen(g) => {
                    g.regs.iter().chain(&g.start).for_each(|v| reach(v, &mut todo));
                    reach(&g.current, &mut todo);
                }
                _ => {}
            }
        }
        self.sweep();
    }

    fn sweep(&mut self) {
        self.free = NO_FREE;
        self.bytes = 0;
        for at in (0..self.objects.len()).rev() {
            if std::mem::take(&mut self.marks[at]) {
                self.bytes += Self::size(&self.objects[at]);
            } else {
                self.objects[at] = Obj::Free(self.free);
                self.free = at as u32;
            }
        }
        self.due = (self.bytes * 2).max(FIRST_COLLECTION).min(self.limit.max(1));
        if self.due <= self.bytes {
            self.due = self.bytes + (self.bytes / 8).max(1 << 16);
        }
    }
}
