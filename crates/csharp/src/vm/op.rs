//! Operations on registers. A register is one of a window of the stack; calls put their arguments into the first
//! registers of the callee's window, and find the result in the first of them.

use super::real::Real;
use super::value::Value;
use crate::bound::Op as BinOp;
use crate::bound::Origin;
use crate::sema::{Prim, Ty};
use crate::source::Pos;

/// A register.
pub type Reg = u16;

/// A register among the first 256 of its window: of most functions these are all.
pub type Low = u8;

/// How many registers a [`Low`] reaches.
pub const LOW: usize = 256;

/// How two numbers are compared in a jump: a bit for each relation between them in which the jump is taken.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub struct Cmp(u8);

#[allow(missing_docs, reason = "their names say it")]
impl Cmp {
    pub const LT: Self = Self(1);
    pub const EQ: Self = Self(2);
    pub const LE: Self = Self(3);
    pub const GT: Self = Self(4);
    pub const GE: Self = Self(6);
    /// Also where one is not a number, as IEEE 754 has it.
    pub const NE: Self = Self(13);

    /// The jump is taken where this one is not: also where one is not a number.
    pub fn opposite(self) -> Self {
        Self(self.0 ^ 15)
    }

    /// Whether the jump is taken.
    #[inline]
    pub fn holds<T: PartialOrd>(self, a: T, b: T) -> bool {
        let (lt, eq, gt) = (a < b, a == b, a > b);
        let relation = u8::from(lt) | u8::from(eq) << 1 | u8::from(gt) << 2 | u8::from(!(lt | eq | gt)) << 3;
        self.0 & relation != 0
    }
}

/// An operation; `d` is where the result goes. Those from `MoveLow` on do what one of the others does, for low registers
/// and usual types; `StepLtI` is `a += k` and a jump where `a` is then less than `b`, the end of most loops.
#[derive(Debug, Clone, Copy)]
#[allow(missing_docs, reason = "the names say what they do, and `run` how")]
pub enum Op {
    Move {
        d: Reg,
        a: Reg,
    },
    Const {
        d: Reg,
        k: u32,
    },
    Int {
        d: Reg,
        v: i32,
    },
    Copy {
        d: Reg,
        a: Reg,
    },
    Arith {
        op: BinOp,
        prim: Prim,
        checked: bool,
        d: Reg,
        a: Reg,
        b: Reg,
    },
    Neg {
        prim: Prim,
        checked: bool,
        d: Reg,
        a: Reg,
    },
    Complement {
        prim: Prim,
        d: Reg,
        a: Reg,
    },
    Not {
        d: Reg,
        a: Reg,
    },
    Convert {
        from: Prim,
        to: Prim,
        checked: bool,
        d: Reg,
        a: Reg,
    },
    /// The decimal of a number.
    DecimalOf {
        d: Reg,
        a: Reg,
    },
    /// A number of a decimal.
    DecimalTo {
        to: Prim,
        d: Reg,
        a: Reg,
    },
    Decimals {
        op: BinOp,
        d: Reg,
        a: Reg,
        b: Reg,
    },
    DecimalNeg {
        d: Reg,
        a: Reg,
    },
    /// Of two constants, of which the second has the upper half.
    DecimalConst {
        d: Reg,
        k: u32,
    },
    ToEnum {
        d: Reg,
        a: Reg,
        ty: Ty,
    },
    FromEnum {
        d: Reg,
        a: Reg,
        prim: Prim,
    },
    Jump {
        to: u32,
    },
    JumpIf {
        a: Reg,
        to: u32,
    },
    JumpNot {
        a: Reg,
        to: u32,
    },
    JumpNull {
        a: Reg,
        to: u32,
    },
    JumpCmp {
        cmp: Cmp,
        prim: Prim,
        a: Reg,
        b: Reg,
        to: u32,
    },
    IsNull {
        d: Reg,
        a: Reg,
    },
    Same {
        d: Reg,
        a: Reg,
        b: Reg,
    },
    NullCheck {
        a: Reg,
    },
    FromNullable {
        d: Reg,
        a: Reg,
    },
    LoadField {
        d: Reg,
        o: Reg,
        i: Reg,
    },
    StoreField {
        o: Reg,
        i: Reg,
        v: Reg,
    },
    LoadStatic {
        d: Reg,
        s: u32,
    },
    StoreStatic {
        s: u32,
        v: Reg,
    },
    Init {
        i: u32,
    },
    LoadElem {
        d: Reg,
        a: Reg,
        i: Reg,
    },
    StoreElem {
        a: Reg,
        i: Reg,
        v: Reg,
    },
    LoadElems {
        d: Reg,
        a: Reg,
        first: Reg,
    },
    StoreElems {
        a: Reg,
        first: Reg,
        v: Reg,
    },
    Length {
        d: Reg,
        a: Reg,
    },
    New {
        d: Reg,
        ty: Ty,
    },
    NewArray {
        d: Reg,
        first: Reg,
        rank: u16,
        ty: Ty,
    },
    ArrayOf {
        d: Reg,
        first: Reg,
        n: u16,
        ty: Ty,
    },
    SetDims {
        a: Reg,
        k: u32,
    },
    NewEnv {
        d: Reg,
        n: u16,
        parent: Reg,
    },
    Lambda {
        d: Reg,
        f: u32,
        env: Reg,
    },
    SetType {
        a: Reg,
        ty: Ty,
    },
    Call {
        f: u32,
        base: Reg,
    },
    CallVirtual {
        site: u32,
        base: Reg,
    },
    Dynamic {
        site: u32,
        base: Reg,
    },
    Native {
        n: u32,
        base: Reg,
        ty: Ty,
    },
    Invoke {
        base: Reg,
    },
    GenNext {
        base: Reg,
    },
    GenDispose {
        base: Reg,
    },
    Return {
        a: Reg,
    },
    ReturnVoid,
    Throw {
        a: Reg,
    },
    Rethrow {
        a: Reg,
    },
    Is {
        d: Reg,
        a: Reg,
        ty: Ty,
    },
    As {
        d: Reg,
        a: Reg,
        ty: Ty,
    },
    Cast {
        d: Reg,
        a: Reg,
        ty: Ty,
    },
    Concat {
        d: Reg,
        first: Reg,
        n: u16,
    },
    Text {
        d: Reg,
        a: Reg,
    },
    RefLocal {
        d: Reg,
        a: Reg,
    },
    RefField {
        d: Reg,
        o: Reg,
        i: Reg,
    },
    RefElem {
        d: Reg,
        a: Reg,
        i: Reg,
    },
    RefElems {
        d: Reg,
        a: Reg,
        first: Reg,
    },
    RefStatic {
        d: Reg,
        s: u32,
    },
    LoadRef {
        d: Reg,
        a: Reg,
    },
    StoreRef {
        a: Reg,
        v: Reg,
    },
    /// The `Put` operations set a place that holds a struct: its object stays and takes the fields of the new one, so that
    /// whoever is at the place sees them.
    PutField {
        o: Reg,
        i: Reg,
        v: Reg,
    },
    PutStatic {
        s: u32,
        v: Reg,
    },
    PutElem {
        a: Reg,
        i: Reg,
        v: Reg,
    },
    PutElems {
        a: Reg,
        first: Reg,
        v: Reg,
    },
    PutRef {
        a: Reg,
        v: Reg,
    },
    TypeOf {
        d: Reg,
        ty: Ty,
    },
    Yield {
        a: Reg,
    },
    NotSupported {
        k: u32,
    },
    Build {
        d: Reg,
        first: Reg,
        n: u16,
        ty: Ty,
    },
    Item {
        d: Low,
        l: Low,
        i: Low,
    },
    SetItem {
        l: Low,
        i: Low,
        v: Low,
    },
    AddItem {
        l: Low,
        v: Low,
    },
    Count {
        d: Low,
        l: Low,
    },
    TextLength {
        d: Low,
        t: Low,
    },
    TextItem {
        d: Low,
        t: Low,
        i: Low,
    },
    Real {
        f: Real,
        d: Low,
        a: Low,
    },
    MoveLow {
        d: Low,
        a: Low,
    },
    AddI {
        d: Low,
        a: Low,
        b: Low,
    },
    SubI {
        d: Low,
        a: Low,
        b: Low,
    },
    MulI {
        d: Low,
        a: Low,
        b: Low,
    },
    AddIK {
        d: Low,
        a: Low,
        k: i32,
    },
    AddL {
        d: Low,
        a: Low,
        b: Low,
    },
    SubL {
        d: Low,
        a: Low,
        b: Low,
    },
    MulL {
        d: Low,
        a: Low,
        b: Low,
    },
    AddF {
        d: Low,
        a: Low,
        b: Low,
    },
    SubF {
        d: Low,
        a: Low,
        b: Low,
    },
    MulF {
        d: Low,
        a: Low,
        b: Low,
    },
    DivF {
        d: Low,
        a: Low,
        b: Low,
    },
    ArithI {
        op: BinOp,
        d: Low,
        a: Low,
        b: Low,
    },
    IntToReal {
        d: Low,
        a: Low,
    },
    IntToLong {
        d: Low,
        a: Low,
    },
    LongToInt {
        d: Low,
        a: Low,
    },
    JumpI {
        cmp: Cmp,
        a: Low,
        b: Low,
        to: u32,
    },
    JumpLtI {
        a: Low,
        b: Low,
        to: u32,
    },
    JumpIK {
        cmp: Cmp,
        a: Low,
        k: i32,
        to: u32,
    },
    JumpL {
        cmp: Cmp,
        a: Low,
        b: Low,
        to: u32,
    },
    JumpF {
        cmp: Cmp,
        a: Low,
        b: Low,
        to: u32,
    },
    StepLtI {
        a: Low,
        k: i8,
        b: Low,
        to: u32,
    },
    LoadFieldLow {
        d: Low,
        o: Low,
        i: Low,
    },
    StoreFieldLow {
        o: Low,
        i: Low,
        v: Low,
    },
    LoadElemLow {
        d: Low,
        a: Low,
        i: Low,
    },
    StoreElemLow {
        a: Low,
        i: Low,
        v: Low,
    },
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
    /// Operations, until they stand with those of all other functions.
    pub code: Vec<Op>,
    /// Where it begins among them; none until it is compiled.
    pub entry: Option<u32>,
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
