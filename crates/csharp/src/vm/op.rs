//! Operations on registers. A register is one of a window of the stack; calls put their arguments into the first
//! registers of the callee's window, and find the result in the first of them.

use super::value::Value;
use crate::bound::Op as BinOp;
use crate::bound::Origin;
use crate::sema::{Prim, Ty};
use crate::source::Pos;

/// A register.
pub type Reg = u16;

/// How two numbers are compared in a jump.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
#[allow(missing_docs, reason = "their names say it")]
pub enum Cmp {
    Eq,
    Ne,
    Lt,
    Le,
    Gt,
    Ge,
}

/// An operation; `d` is where the result goes.
#[derive(Debug, Clone, Copy)]
#[allow(missing_docs, reason = "the names say what they do, and `run` how")]
pub enum Op {
    Move { d: Reg, a: Reg },
    Const { d: Reg, k: u32 },
    Int { d: Reg, v: i32 },
    Copy { d: Reg, a: Reg },
    AddI { d: Reg, a: Reg, b: Reg },
    SubI { d: Reg, a: Reg, b: Reg },
    MulI { d: Reg, a: Reg, b: Reg },
    AddIK { d: Reg, a: Reg, k: i32 },
    AddF { d: Reg, a: Reg, b: Reg },
    SubF { d: Reg, a: Reg, b: Reg },
    MulF { d: Reg, a: Reg, b: Reg },
    DivF { d: Reg, a: Reg, b: Reg },
    Arith { op: BinOp, prim: Prim, checked: bool, d: Reg, a: Reg, b: Reg },
    Neg { prim: Prim, checked: bool, d: Reg, a: Reg },
    Complement { prim: Prim, d: Reg, a: Reg },
    Not { d: Reg, a: Reg },
    Convert { from: Prim, to: Prim, checked: bool, d: Reg, a: Reg },
    ToEnum { d: Reg, a: Reg, ty: Ty },
    FromEnum { d: Reg, a: Reg, prim: Prim },
    Jump { to: u32 },
    JumpIf { a: Reg, to: u32 },
    JumpNot { a: Reg, to: u32 },
    JumpNull { a: Reg, to: u32 },
    JumpI { cmp: Cmp, a: Reg, b: Reg, to: u32 },
    JumpF { cmp: Cmp, a: Reg, b: Reg, to: u32 },
    IsNull { d: Reg, a: Reg },
    Same { d: Reg, a: Reg, b: Reg },
    NullCheck { a: Reg },
    FromNullable { d: Reg, a: Reg },
    LoadField { d: Reg, o: Reg, i: Reg },
    StoreField { o: Reg, i: Reg, v: Reg },
    LoadStatic { d: Reg, s: u32 },
    StoreStatic { s: u32, v: Reg },
    Init { i: u32 },
    LoadElem { d: Reg, a: Reg, i: Reg },
    StoreElem { a: Reg, i: Reg, v: Reg },
    LoadElems { d: Reg, a: Reg, first: Reg },
    StoreElems { a: Reg, first: Reg, v: Reg },
    Length { d: Reg, a: Reg },
    New { d: Reg, ty: Ty },
    NewArray { d: Reg, first: Reg, rank: u16, ty: Ty },
    ArrayOf { d: Reg, first: Reg, n: u16, ty: Ty },
    SetDims { a: Reg, k: u32 },
    NewEnv { d: Reg, n: u16, parent: Reg },
    Lambda { d: Reg, f: u32, env: Reg },
    SetType { a: Reg, ty: Ty },
    Call { f: u32, base: Reg },
    CallVirtual { site: u32, base: Reg },
    Dynamic { site: u32, base: Reg },
    Native { n: u32, base: Reg, ty: Ty },
    Invoke { base: Reg },
    GenNext { base: Reg },
    GenDispose { base: Reg },
    Return { a: Reg },
    ReturnVoid,
    Throw { a: Reg },
    Rethrow { a: Reg },
    Is { d: Reg, a: Reg, ty: Ty },
    As { d: Reg, a: Reg, ty: Ty },
    Cast { d: Reg, a: Reg, ty: Ty },
    Concat { d: Reg, first: Reg, n: u16 },
    Text { d: Reg, a: Reg },
    RefLocal { d: Reg, a: Reg },
    RefField { d: Reg, o: Reg, i: Reg },
    RefElem { d: Reg, a: Reg, i: Reg },
    RefElems { d: Reg, a: Reg, first: Reg },
    RefStatic { d: Reg, s: u32 },
    LoadRef { d: Reg, a: Reg },
    StoreRef { a: Reg, v: Reg },
    TypeOf { d: Reg, ty: Ty },
    Yield { a: Reg },
    NotSupported { k: u32 },
}

/// Where an exception goes from a range of operations.
#[derive(Debug, Clone, Copy)]
pub struct Handler {
    /// First operation.
    pub from: u32,
    /// The one behind the last.
    pub to: u32,
    /// Where it goes on.
    pub target: u32,
    /// The register for the exception.
    pub reg: Reg,
    /// Whether it only cleans up.
    pub finally: bool,
}

/// A function.
#[derive(Debug, Default)]
pub struct Function {
    /// Its name, for messages.
    pub name: String,
    /// Operations; none until it is compiled.
    pub code: Vec<Op>,
    /// Constants.
    pub consts: Vec<Value>,
    /// Messages of operations that are not supported.
    pub messages: Vec<String>,
    /// How many registers it uses.
    pub regs: u32,
    /// How many arguments it takes, the object itself among them.
    pub params: u32,
    /// The places of operations.
    pub places: Vec<(u32, Pos)>,
    /// Handlers, the innermost first.
    pub handlers: Vec<Handler>,
    /// Whether a call makes an iterator, of which type.
    pub generator: Option<Ty>,
    /// What the function of a delegate was made of.
    pub origin: Origin,
}

impl Function {
    /// The place of an operation.
    pub fn place(&self, pc: u32) -> Pos {
        let after = self.places.partition_point(|(at, _)| *at <= pc);
        after.checked_sub(1).and_then(|i| self.places.get(i)).map_or(0, |(_, pos)| *pos)
    }
}
