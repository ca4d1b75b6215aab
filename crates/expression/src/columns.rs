//! The same expression over whole columns of numbers.
//!
//! A program whose every step is about numbers runs as a stack machine over blocks: each step sweeps a block of
//! values that stays in the first-level cache, so that the cost of finding out what to do is shared by all of
//! them. Every operation is the one the single-value path uses, in the same order, so that the results are equal
//! bit for bit. Wherever a block meets something unusual it is done again value by value, which finds the error.

use crate::compare::near_numbers;
use crate::functions::Function;
use crate::functions::numeric::{self, OfMany, OfTwo};
use crate::operator::{Binary, Postfix, Prefix};
use crate::program::{Code, Step};
use crate::{EvalError, Program, Variant};

/// Values per sweep: 2 KiB a stack slot.
const BLOCK: usize = 256;

/// Deeper programs run value by value.
const MAX_SLOTS: usize = 64;

/// The first value of a column that has no result.
#[derive(Debug, Clone, PartialEq, thiserror::Error)]
#[error("value {index}: {error}")]
pub struct ColumnError {
    /// Which result, counted from 0.
    pub index: usize,
    /// What a single evaluation reports there.
    pub error: EvalError,
}

/// A program in which every step is about numbers.
#[derive(Debug, Clone)]
pub(crate) struct Lanes {
    steps: Vec<Lane>,
    slots: usize,
}

#[derive(Debug, Clone, Copy)]
enum Lane {
    Constant(f64),
    Variable(usize),
    Binary(Binary),
    Negate,
    Not,
    Square,
    Cube,
    Degree,
    Factorial,
    One(fn(f64) -> f64),
    All(fn(&mut [f64])),
    Abs,
    Sign,
    ToInteger,
    ToBoolean,
    Two(OfTwo),
    Many(OfMany, usize),
    If,
}

/// The type of a slot when every variable is a Number. `Either` is Integer or Number by the data.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
enum Kind {
    Boolean,
    Integer,
    Number,
    Either,
}

impl Lanes {
    /// The column form; `None` when some step is about another type, or the type of a number depends on the data.
    pub(crate) fn of(steps: &[Step]) -> Option<Self> {
        let mut lanes = Vec::with_capacity(steps.len());
        let mut stack: Vec<Kind> = Vec::new();
        let mut slots = 0;
        for step in steps {
            lanes.extend(lane(&step.code, &mut stack)?);
            slots = slots.max(stack.len());
        }
        (stack == [Kind::Number] && slots <= MAX_SLOTS).then_some(Self { steps: lanes, slots })
    }
}

/// The column form of a step, `None` inside when nothing has to be done, and the type it leaves.
fn lane(code: &Code, stack: &mut Vec<Kind>) -> Option<Option<Lane>> {
    use Kind::{Boolean, Either, Integer, Number};
    let (lane, kind) = match code {
        Code::Constant(Variant::Number(x)) => (Some(Lane::Constant(*x)), Number),
        Code::Constant(Variant::Integer(i)) => (Some(Lane::Constant(f64::from(*i))), Integer),
        Code::Constant(Variant::Boolean(b)) => (Some(Lane::Constant(f64::from(u8::from(*b)))), Boolean),
        Code::Variable(slot) => (Some(Lane::Variable(*slot)), Number),
        Code::Binary(operator) => {
            let (right, left) = (stack.pop()?, stack.pop()?);
            let kind = match operator {
                // Integer arithmetic may leave the 32 bits: only with a Number the type is certain.
                Binary::Add
                | Binary::Subtract
                | Binary::Multiply
                | Binary::Cross
                | Binary::Dot
                | Binary::IntegerDivide
                | Binary::Modulus
                    if left == Number || right == Number =>
                {
                    Number
                }
                Binary::Divide | Binary::Power => Number,
                Binary::Equal
                | Binary::NotEqual
                | Binary::Less
                | Binary::LessOrEqual
                | Binary::Greater
                | Binary::GreaterOrEqual
                | Binary::Near
                | Binary::And
                | Binary::Or
                | Binary::Xor => Boolean,
                _ => return None,
            };
            (Some(Lane::Binary(*operator)), kind)
        }
        Code::Prefix(operator) => {
            let operand = stack.pop()?;
            match operator {
                Prefix::Plus => (None, operand),
                Prefix::Not => (Some(Lane::Not), Boolean),
                Prefix::Minus if operand == Number => (Some(Lane::Negate), Number),
                Prefix::Minus => return None,
            }
        }
        Code::Postfix(operator) => {
            let operand = stack.pop()?;
            match operator {
                Postfix::Degree => (Some(Lane::Degree), Number),
                Postfix::Square if operand == Number => (Some(Lane::Square), Number),
                Postfix::Cube if operand == Number => (Some(Lane::Cube), Number),
                Postfix::Factorial if operand == Number => (Some(Lane::Factorial), Number),
                _ => return None,
            }
        }
        Code::Call(Function::If, 3) => {
            let (b, a, _) = (stack.pop()?, stack.pop()?, stack.pop()?);
            let kind = match (a, b) {
                _ if a == b => a,
                // A Boolean in arithmetic counts as an Integer, but a result or comparison would show it.
                (Boolean, _) | (_, Boolean) => return None,
                _ => Either,
            };
            (Some(Lane::If), kind)
        }
        Code::Call(function, 1) if numeric::of_one(*function).is_some() => {
            stack.pop()?;
            let one = Lane::One(numeric::of_one(*function)?);
            (Some(numeric::sweeping(*function).map_or(one, Lane::All)), Number)
        }
        Code::Call(Function::Abs, 1) => match stack.pop()? {
            Number => (Some(Lane::Abs), Number),
            _ => return None,
        },
        Code::Call(Function::Sign, 1) => {
            stack.pop()?;
            (Some(Lane::Sign), Integer)
        }
        Code::Call(Function::CInt, 1) => {
            stack.pop()?;
            (Some(Lane::ToInteger), Integer)
        }
        Code::Call(Function::CBool, 1) => {
            stack.pop()?;
            (Some(Lane::ToBoolean), Boolean)
        }
        Code::Call(function, 2) if numeric::of_two(*function).is_some() => {
            stack.pop()?;
            stack.pop()?;
            (Some(Lane::Two(numeric::of_two(*function)?)), Number)
        }
        Code::Call(function, count) => {
            let many = numeric::of_many(*function)?;
            let from = stack.len().checked_sub(*count)?;
            let certain =
                matches!(function, Function::Mean | Function::GMean | Function::HMean | Function::Median);
            let kinds: Vec<Kind> = stack.drain(from..).collect();
            if !certain && !kinds.contains(&Number) {
                return None;
            }
            (Some(Lane::Many(many, *count)), Number)
        }
        Code::Constant(_) | Code::Point(_) => return None,
    };
    stack.push(kind);
    Some(lane)
}

impl Program {
    /// Whether [`Program::evaluate_numbers`] runs this program: every step is about numbers, and the result is a
    /// Number whatever numbers the variables hold.
    pub fn is_numeric(&self) -> bool {
        self.lanes.is_some()
    }

    /// The results 0..`count` for columns of numbers, one column a variable in the order of
    /// [`Expression::bind`](crate::Expression::bind). A column shorter than `count` repeats its last value.
    /// The numbers are those of [`Program::evaluate`] with [`Variant::Number`]s, bit for bit.
    ///
    /// `None` when the program is not [numeric](Program::is_numeric), when a variable it uses has no column or an
    /// empty one, or when there is no memory for the results.
    ///
    /// # Errors
    /// The first value that has no result.
    pub fn evaluate_numbers(
        &self,
        columns: &[&[f64]],
        count: usize,
    ) -> Option<Result<Vec<f64>, ColumnError>> {
        let lanes = self.lanes.as_ref()?;
        for lane in &lanes.steps {
            if let Lane::Variable(slot) = lane {
                columns.get(*slot)?.last()?;
            }
        }
        let mut results: Vec<f64> = Vec::new();
        results.try_reserve_exact(count).ok()?;
        let mut machine = Machine { slots: vec![[0.0; BLOCK]; lanes.slots], scratch: Vec::new() };
        while results.len() < count {
            let start = results.len();
            let length = BLOCK.min(count - start);
            match machine.run(lanes, columns, start, length) {
                Some(block) if block.iter().all(|x| x.is_finite()) => results.extend_from_slice(block),
                _ => match self.one_by_one(columns, start, length, &mut results) {
                    Ok(()) => {}
                    Err(error) => return Some(Err(error)),
                },
            }
        }
        Some(Ok(results))
    }

    fn one_by_one(
        &self,
        columns: &[&[f64]],
        start: usize,
        length: usize,
        results: &mut Vec<f64>,
    ) -> Result<(), ColumnError> {
        let mut values: Vec<Variant> = Vec::with_capacity(columns.len());
        for index in start..start + length {
            values.clear();
            values.extend(columns.iter().map(|c| repeated(c, index).map_or(Variant::Null, Variant::Number)));
            match self.evaluate(&values) {
                Ok(Variant::Number(x)) => results.push(x),
                // The types were certain when the program was made.
                Ok(_) => {
                    let error = EvalError::new(crate::Span::default(), crate::EvalErrorKind::Damaged);
                    return Err(ColumnError { index, error });
                }
                Err(error) => return Err(ColumnError { index, error }),
            }
        }
        Ok(())
    }
}

fn repeated(column: &[f64], index: usize) -> Option<f64> {
    column.get(index).or(column.last()).copied()
}

struct Machine {
    slots: Vec<[f64; BLOCK]>,
    scratch: Vec<f64>,
}

impl Machine {
    /// The block of results, or `None` when some value is outside an operation's domain.
    fn run(&mut self, lanes: &Lanes, columns: &[&[f64]], start: usize, length: usize) -> Option<&[f64]> {
        let mut depth = 0;
        let mut fine = true;
        for lane in &lanes.steps {
            match *lane {
                Lane::Constant(x) => {
                    self.slots.get_mut(depth)?.get_mut(..length)?.fill(x);
                    depth += 1;
                }
                Lane::Variable(slot) => {
                    let column = columns.get(slot)?;
                    let block = self.slots.get_mut(depth)?.get_mut(..length)?;
                    let given = column.get(start..).unwrap_or_default();
                    let given = given.get(..length).unwrap_or(given);
                    let (copied, repeats) = block.split_at_mut(given.len());
                    copied.copy_from_slice(given);
                    if !repeats.is_empty() {
                        repeats.fill(*column.last()?);
                    }
                    depth += 1;
                }
                Lane::Binary(operator) => {
                    depth -= 1;
                    let (below, above) = self.slots.split_at_mut(depth);
                    let (a, b) = (below.last_mut()?.get_mut(..length)?, above.first()?.get(..length)?);
                    fine &= sweep_binary(operator, a, b);
                }
                Lane::Two(function) => {
                    depth -= 1;
                    let (below, above) = self.slots.split_at_mut(depth);
                    let (a, b) = (below.last_mut()?.get_mut(..length)?, above.first()?.get(..length)?);
                    for (x, y) in a.iter_mut().zip(b) {
                        match function(*x, *y) {
                            Some(value) => *x = value,
                            None => fine = false,
                        }
                    }
                }
                Lane::If => {
                    depth -= 2;
                    let (below, above) = self.slots.split_at_mut(depth);
                    let condition = below.last_mut()?.get_mut(..length)?;
                    let (a, b) = (above.first()?.get(..length)?, above.get(1)?.get(..length)?);
                    for ((c, a), b) in condition.iter_mut().zip(a).zip(b) {
                        *c = if *c != 0.0 { *a } else { *b };
                    }
                }
                Lane::Many(function, count) => {
                    let from = depth.checked_sub(count)?;
                    for i in 0..length {
                        self.scratch.clear();
                        self.scratch.extend(self.slots.get(from..depth)?.iter().filter_map(|s| s.get(i)));
                        match function(&mut self.scratch) {
                            Some(value) => *self.slots.get_mut(from)?.get_mut(i)? = value,
                            None => fine = false,
                        }
                    }
                    depth = from + 1;
                }
                _ => {
                    let block = self.slots.get_mut(depth.checked_sub(1)?)?.get_mut(..length)?;
                    fine &= sweep_one(*lane, block);
                }
            }
        }
        fine.then_some(self.slots.first()?.get(..length)?)
    }
}

#[inline]
fn each(block: &mut [f64], f: impl Fn(f64) -> f64) -> bool {
    for x in block {
        *x = f(*x);
    }
    true
}

/// Like [`each`] for operations with a domain: false when some value is outside.
fn each_within(block: &mut [f64], f: impl Fn(f64) -> Option<f64>) -> bool {
    block.iter_mut().all(|x| f(*x).map(|value| *x = value).is_some())
}

#[inline]
fn pairs(a: &mut [f64], b: &[f64], f: impl Fn(f64, f64) -> f64) -> bool {
    for (x, y) in a.iter_mut().zip(b) {
        *x = f(*x, *y);
    }
    true
}

#[inline]
fn test(a: &mut [f64], b: &[f64], f: impl Fn(f64, f64) -> bool) -> bool {
    pairs(a, b, |x, y| f64::from(u8::from(f(x, y))))
}

fn sweep_one(lane: Lane, block: &mut [f64]) -> bool {
    match lane {
        Lane::Negate => each(block, |x| -x),
        Lane::Not => each(block, |x| f64::from(u8::from(x == 0.0))),
        Lane::Square => each(block, |x| x * x),
        Lane::Cube => each(block, |x| x * x * x),
        Lane::Degree => each(block, f64::to_radians),
        Lane::Abs => each(block, f64::abs),
        Lane::One(function) => each(block, function),
        Lane::All(function) => {
            function(block);
            true
        }
        Lane::ToBoolean => each(block, |x| f64::from(u8::from(x != 0.0))),
        Lane::Factorial => each_within(block, numeric::factorial),
        Lane::Sign => each_within(block, |x| numeric::sign(x).map(f64::from)),
        Lane::ToInteger => each_within(block, |x| numeric::nearest_integer(x).map(f64::from)),
        Lane::Constant(_) | Lane::Variable(_) | Lane::Binary(_) => false,
        Lane::Two(_) | Lane::Many(..) | Lane::If => false,
    }
}

fn sweep_binary(operator: Binary, a: &mut [f64], b: &[f64]) -> bool {
    let divisor_is_fine = |b: &[f64]| !b.contains(&0.0);
    match operator {
        Binary::Add => pairs(a, b, |x, y| x + y),
        Binary::Subtract => pairs(a, b, |x, y| x - y),
        Binary::Multiply | Binary::Cross | Binary::Dot => pairs(a, b, |x, y| x * y),
        Binary::Divide => divisor_is_fine(b) && pairs(a, b, |x, y| x / y),
        Binary::IntegerDivide => divisor_is_fine(b) && pairs(a, b, |x, y| (x / y).trunc()),
        Binary::Modulus => divisor_is_fine(b) && pairs(a, b, |x, y| x % y),
        Binary::Power => pairs(a, b, numeric::power),
        Binary::Equal => test(a, b, |x, y| x == y),
        Binary::NotEqual => test(a, b, |x, y| x != y),
        Binary::Less => test(a, b, |x, y| x < y),
        Binary::LessOrEqual => test(a, b, |x, y| x <= y),
        Binary::Greater => test(a, b, |x, y| x > y),
        Binary::GreaterOrEqual => test(a, b, |x, y| x >= y),
        Binary::Near => test(a, b, near_numbers),
        Binary::And => test(a, b, |x, y| x != 0.0 && y != 0.0),
        Binary::Or => test(a, b, |x, y| x != 0.0 || y != 0.0),
        Binary::Xor => test(a, b, |x, y| (x != 0.0) != (y != 0.0)),
        Binary::Join | Binary::Angle => false,
    }
}
