use std::sync::Arc;

use katydid_elementary::Elementary;
use katydid_geometry::Point3;

use super::{Function, numeric, text};
use crate::arithmetic::{self, Scalar, truth};
use crate::complex;
use crate::{Dialect, EvalErrorKind, Variant, format};

type Evaluated = Result<Variant, EvalErrorKind>;

/// Calls a function. Null among the arguments gives null, but for `If`, which looks at the chosen branch only,
/// and `IsNothing`. The number of arguments was checked by the parser.
pub(crate) fn call(function: Function, values: &[Variant]) -> Evaluated {
    let a = Arguments { function, values };
    match function {
        Function::Null => return Ok(Variant::Null),
        Function::IsNothing => return Ok(Variant::Boolean(a.value(0).is_null())),
        Function::If => {
            if a.value(0).is_null() {
                return Ok(Variant::Null);
            }
            let chosen = if a.truth(0)? { 1 } else { 2 };
            return Ok(a.value(chosen).clone());
        }
        _ => {}
    }
    if values.iter().any(Variant::is_null) {
        return Ok(Variant::Null);
    }
    if let Some(result) = text::call(function, &a) {
        return result;
    }
    match function {
        Function::CBool => a.truth(0).map(Variant::Boolean),
        Function::CStr => Ok(Variant::Text(Arc::from(a.value(0).to_text(Dialect::Modern)))),
        Function::CInt => match a.scalar(0)? {
            Scalar::Integer(i) => Ok(Variant::Integer(i)),
            _ => {
                let x = a.number(0)?;
                let too_big = || {
                    a.out_of_range(format!(
                        "{} does not fit an Integer",
                        crate::number_text(x, Dialect::Modern)
                    ))
                };
                numeric::nearest_integer(x).map(Variant::Integer).ok_or_else(too_big)
            }
        },
        Function::Sign => {
            let x = a.number(0)?;
            numeric::sign(x).map(Variant::Integer).ok_or_else(|| a.out_of_range("NaN has no sign".into()))
        }
        Function::Abs => Ok(match a.scalar(0)? {
            Scalar::Integer(i) => {
                i.checked_abs().map_or(Variant::Number(f64::from(i).abs()), Variant::Integer)
            }
            Scalar::Number(x) => Variant::Number(x.abs()),
            Scalar::Complex(re, im) => Variant::Number(complex::modulus((re, im))),
        }),
        Function::Length => match a.value(0) {
            Variant::Text(t) => Ok(Variant::Integer(i32::try_from(text::units(t)).unwrap_or(i32::MAX))),
            _ => Ok(Variant::Number(a.point(0)?.to_vector().length())),
        },
        Function::Distance => Ok(Variant::Number(a.point(0)?.distance_to(a.point(1)?))),
        Function::DistanceXY => {
            let (p, q) = (a.point(0)?, a.point(1)?);
            Ok(Variant::Number((q.x - p.x).hypotenuse(q.y - p.y)))
        }
        Function::Angle => arithmetic::angle(a.point(0)?, a.point(1)?),
        Function::CrossProduct => {
            Ok(Variant::Point(a.point(0)?.to_vector().cross(a.point(1)?.to_vector()).to_point()))
        }
        Function::DotProduct => Ok(Variant::Number(a.point(0)?.to_vector().dot(a.point(1)?.to_vector()))),
        Function::Unitize => arithmetic::unitize(a.point(0)?),
        Function::Concat => arithmetic::join(&values.iter().collect::<Vec<_>>()),
        Function::Format => {
            let pattern = a.text(0)?;
            let rest = values.get(1..).unwrap_or_default();
            Ok(Variant::Text(Arc::from(format::format(&pattern, rest, Dialect::Modern)?)))
        }
        Function::Min | Function::Max | Function::Sum => whole_statistic(&a).unwrap_or_else(|| statistic(&a)),
        Function::Mean | Function::GMean | Function::HMean | Function::Median => statistic(&a),
        _ => of_numbers(&a),
    }
}

/// Functions of one or two numbers.
fn of_numbers(a: &Arguments<'_>) -> Evaluated {
    if a.len() == 1
        && let Some(real) = numeric::of_one(a.function)
    {
        if let Scalar::Complex(re, im) = a.scalar(0)? {
            let (re, im) = match a.function {
                Function::Sin => complex::sin((re, im)),
                Function::Cos => complex::cos((re, im)),
                Function::Sqrt => complex::sqrt((re, im)),
                Function::Exp => complex::exp((re, im)),
                Function::Ln => complex::ln((re, im)),
                _ => return Err(a.wrong_type(0, "a number")),
            };
            return Ok(Variant::Complex { re, im });
        }
        return Ok(Variant::Number(real(a.number(0)?)));
    }
    if let Some(real) = numeric::of_two(a.function) {
        let (x, y) = (a.number(0)?, a.number(1)?);
        let out = || a.out_of_range("the number of digits must be 0 to 15".into());
        return real(x, y).map(Variant::Number).ok_or_else(out);
    }
    Err(EvalErrorKind::Damaged)
}

/// `Min`, `Max` and `Sum` of integers stay an integer, unless the sum does not fit.
fn whole_statistic(a: &Arguments<'_>) -> Option<Evaluated> {
    let integers = (0..a.len()).map(|i| match a.scalar(i) {
        Ok(Scalar::Integer(value)) => Some(value),
        _ => None,
    });
    let integers: Vec<i32> = integers.collect::<Option<_>>()?;
    let value = match a.function {
        Function::Min => *integers.iter().min()?,
        Function::Max => *integers.iter().max()?,
        _ => integers.iter().try_fold(0i32, |sum, &i| sum.checked_add(i))?,
    };
    Some(Ok(Variant::Integer(value)))
}

fn statistic(a: &Arguments<'_>) -> Evaluated {
    let mut numbers = (0..a.len()).map(|i| a.number(i)).collect::<Result<Vec<f64>, _>>()?;
    let function = numeric::of_many(a.function).ok_or(EvalErrorKind::Damaged)?;
    // Only the harmonic mean refuses: of zero.
    function(&mut numbers).map(Variant::Number).ok_or(EvalErrorKind::DivisionByZero)
}

/// The arguments of a call, read as what the function takes.
pub(super) struct Arguments<'a> {
    function: Function,
    values: &'a [Variant],
}

impl Arguments<'_> {
    pub(super) fn len(&self) -> usize {
        self.values.len()
    }

    pub(super) fn value(&self, i: usize) -> &Variant {
        self.values.get(i).unwrap_or(&Variant::Null)
    }

    fn wrong_type(&self, i: usize, expected: &'static str) -> EvalErrorKind {
        let found = self.value(i).type_name();
        EvalErrorKind::ArgumentType { function: self.function.name(), position: i + 1, expected, found }
    }

    fn out_of_range(&self, reason: String) -> EvalErrorKind {
        EvalErrorKind::OutOfRange { function: self.function.name(), reason }
    }

    fn scalar(&self, i: usize) -> Result<Scalar, EvalErrorKind> {
        Scalar::of(self.value(i)).ok_or_else(|| self.wrong_type(i, "a number"))
    }

    fn number(&self, i: usize) -> Result<f64, EvalErrorKind> {
        self.scalar(i)?.real().ok_or_else(|| self.wrong_type(i, "a real number"))
    }

    fn truth(&self, i: usize) -> Result<bool, EvalErrorKind> {
        truth(self.value(i)).ok_or_else(|| self.wrong_type(i, "true or false"))
    }

    fn point(&self, i: usize) -> Result<Point3, EvalErrorKind> {
        match self.value(i) {
            Variant::Point(p) => Ok(*p),
            Variant::Plane(p) => Ok(p.origin),
            _ => Err(self.wrong_type(i, "a point or vector")),
        }
    }

    /// Any value is a text where a text is wanted.
    pub(super) fn text(&self, i: usize) -> Result<Arc<str>, EvalErrorKind> {
        Ok(match self.value(i) {
            Variant::Text(t) => t.clone(),
            other => Arc::from(other.to_text(Dialect::Modern)),
        })
    }

    /// A count or place in a text, not below zero.
    pub(super) fn count(&self, i: usize) -> Result<usize, EvalErrorKind> {
        let x = self.number(i)?;
        let whole = numeric::nearest_integer(x).and_then(|n| usize::try_from(n).ok());
        whole.ok_or_else(|| {
            let n = crate::number_text(x, Dialect::Modern);
            self.out_of_range(format!("argument {} must be a count from 0 on, not {n}", i + 1))
        })
    }
}
