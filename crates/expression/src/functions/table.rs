//! The table of functions: names, arguments and help.

/// How a function is called and what it gives, for help pages and messages.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
#[non_exhaustive]
pub struct FunctionHelp {
    /// The name as the editor writes it; case does not matter in expressions.
    pub name: &'static str,
    /// Other names for the same function.
    pub aliases: &'static [&'static str],
    /// How it is called.
    pub signature: &'static str,
    /// What it gives, in one line.
    pub help: &'static str,
    /// The least number of arguments.
    pub least: usize,
    /// The greatest number of arguments; `usize::MAX` where there is no bound.
    pub most: usize,
}

impl FunctionHelp {
    /// The allowed number of arguments in words.
    pub(crate) fn count_in_words(&self) -> String {
        let noun = |n: usize| if n == 1 { "1 argument".to_string() } else { format!("{n} arguments") };
        match (self.least, self.most) {
            (least, usize::MAX) => format!("at least {}", noun(least)),
            (least, most) if least == most => noun(most),
            (least, most) => format!("{least} to {}", noun(most)),
        }
    }
}

impl Function {
    /// The function of that name; the name in lower case.
    pub(crate) fn named(name: &str) -> Option<Self> {
        let is = |n: &str| n.eq_ignore_ascii_case(name);
        TABLE.iter().find(|(_, h)| is(h.name) || h.aliases.iter().any(|a| is(a))).map(|(f, _)| *f)
    }

    /// Its row of the table.
    pub(crate) fn help(self) -> &'static FunctionHelp {
        // The enum and the table are written in the same order; the first row only answers a broken table.
        TABLE.get(self as usize).map_or(&TABLE[0].1, |(_, help)| help)
    }

    /// Its name as the editor writes it.
    pub(crate) fn name(self) -> &'static str {
        self.help().name
    }

    /// Every name a call may use.
    pub(crate) fn all_names() -> impl Iterator<Item = &'static str> {
        TABLE.iter().flat_map(|(_, h)| std::iter::once(h.name).chain(h.aliases.iter().copied()))
    }
}

/// Each function, in the order of [`TABLE`].
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(crate) enum Function {
    Sin,
    Cos,
    Tan,
    ASin,
    ACos,
    ATan,
    ATan2,
    Sec,
    Csc,
    Cot,
    Sinc,
    Sinh,
    Cosh,
    Tanh,
    Sqrt,
    Exp,
    Pow10,
    Pow,
    Ln,
    Log,
    Log10,
    LogN,
    Abs,
    Sign,
    Floor,
    Ceiling,
    Fix,
    Int,
    Trunc,
    Round,
    Min,
    Max,
    Sum,
    Mean,
    GMean,
    HMean,
    Median,
    Deg,
    Rad,
    CBool,
    CInt,
    CDbl,
    CStr,
    Distance,
    DistanceXY,
    Angle,
    CrossProduct,
    DotProduct,
    Length,
    Unitize,
    Format,
    Concat,
    Contains,
    StartsWith,
    EndsWith,
    IndexOf,
    Left,
    Right,
    Mid,
    Trim,
    LCase,
    UCase,
    Replace,
    If,
    IsNothing,
    Null,
}

/// A row: least and most are the bounds of the number of arguments.
const fn row(
    name: &'static str,
    aliases: &'static [&'static str],
    signature: &'static str,
    (least, most): (usize, usize),
    help: &'static str,
) -> FunctionHelp {
    FunctionHelp { name, aliases, signature, help, least, most }
}

const ANY: usize = usize::MAX;

#[rustfmt::skip]
pub(super) static TABLE: [(Function, FunctionHelp); 66] = [
    (Function::Sin, row("Sin", &[], "Sin(x)", (1, 1), "The sine of an angle in radians.")),
    (Function::Cos, row("Cos", &[], "Cos(x)", (1, 1), "The cosine of an angle in radians.")),
    (Function::Tan, row("Tan", &[], "Tan(x)", (1, 1), "The tangent of an angle in radians.")),
    (Function::ASin, row("ASin", &["ArcSin"], "ASin(x)", (1, 1), "The angle in -π/2..π/2 whose sine is x; x in -1..1.")),
    (Function::ACos, row("ACos", &["ArcCos"], "ACos(x)", (1, 1), "The angle in 0..π whose cosine is x; x in -1..1.")),
    (Function::ATan, row("ATan", &["ArcTan"], "ATan(x)", (1, 1), "The angle in -π/2..π/2 whose tangent is x.")),
    (Function::ATan2, row("ATan2", &[], "ATan2(y, x)", (2, 2), "The direction of the point (x, y) as an angle in -π..π.")),
    (Function::Sec, row("Sec", &[], "Sec(x)", (1, 1), "The secant, 1/Cos(x).")),
    (Function::Csc, row("Csc", &["CoSec"], "Csc(x)", (1, 1), "The cosecant, 1/Sin(x).")),
    (Function::Cot, row("Cot", &["CoTan"], "Cot(x)", (1, 1), "The cotangent, Cos(x)/Sin(x).")),
    (Function::Sinc, row("Sinc", &[], "Sinc(x)", (1, 1), "Sin(x)/x, and 1 at x = 0.")),
    (Function::Sinh, row("Sinh", &[], "Sinh(x)", (1, 1), "The hyperbolic sine.")),
    (Function::Cosh, row("Cosh", &[], "Cosh(x)", (1, 1), "The hyperbolic cosine.")),
    (Function::Tanh, row("Tanh", &[], "Tanh(x)", (1, 1), "The hyperbolic tangent.")),
    (Function::Sqrt, row("Sqrt", &[], "Sqrt(x)", (1, 1), "The square root; x not below zero.")),
    (Function::Exp, row("Exp", &[], "Exp(x)", (1, 1), "e to the power x.")),
    (Function::Pow10, row("Pow10", &[], "Pow10(x)", (1, 1), "10 to the power x.")),
    (Function::Pow, row("Pow", &[], "Pow(x, n)", (2, 2), "x to the power n.")),
    (Function::Ln, row("Ln", &[], "Ln(x)", (1, 1), "The natural logarithm; x above zero.")),
    (Function::Log, row("Log", &[], "Log(x)", (1, 1), "The logarithm to base 10; x above zero.")),
    (Function::Log10, row("Log10", &[], "Log10(x)", (1, 1), "The logarithm to base 10; x above zero.")),
    (Function::LogN, row("LogN", &[], "LogN(x, b)", (2, 2), "The logarithm of x to base b.")),
    (Function::Abs, row("Abs", &[], "Abs(x)", (1, 1), "The value without its sign; the modulus of a complex number.")),
    (Function::Sign, row("Sign", &["Sgn"], "Sign(x)", (1, 1), "-1, 0 or 1 as x is below, at or above zero.")),
    (Function::Floor, row("Floor", &[], "Floor(x)", (1, 1), "The nearest whole number not above x.")),
    (Function::Ceiling, row("Ceiling", &["Ceil"], "Ceiling(x)", (1, 1), "The nearest whole number not below x.")),
    (Function::Fix, row("Fix", &[], "Fix(x)", (1, 1), "x without its decimals: the next whole number towards zero.")),
    (Function::Int, row("Int", &[], "Int(x)", (1, 1), "The nearest whole number not above x.")),
    (Function::Trunc, row("Trunc", &["Truncate"], "Trunc(x)", (1, 1), "x without its decimals: the next whole number towards zero.")),
    (Function::Round, row("Round", &[], "Round(x) or Round(x, digits)", (1, 2), "The nearest whole number, or number of so many decimals (0 to 15); halves go to the even neighbour.")),
    (Function::Min, row("Min", &["Minimum"], "Min(a, b, …)", (1, ANY), "The smallest of the numbers.")),
    (Function::Max, row("Max", &["Maximum"], "Max(a, b, …)", (1, ANY), "The largest of the numbers.")),
    (Function::Sum, row("Sum", &[], "Sum(a, b, …)", (1, ANY), "The total of the numbers.")),
    (Function::Mean, row("Mean", &["Average"], "Mean(a, b, …)", (1, ANY), "The arithmetic mean: the total divided by the count.")),
    (Function::GMean, row("GMean", &[], "GMean(a, b, …)", (1, ANY), "The geometric mean: the n-th root of the product.")),
    (Function::HMean, row("HMean", &[], "HMean(a, b, …)", (1, ANY), "The harmonic mean: the count divided by the total of the reciprocals.")),
    (Function::Median, row("Median", &[], "Median(a, b, …)", (1, ANY), "The middle number in order of size, or the mean of the two middle ones.")),
    (Function::Deg, row("Deg", &["Degrees"], "Deg(x)", (1, 1), "Radians as degrees.")),
    (Function::Rad, row("Rad", &["Radians"], "Rad(x)", (1, 1), "Degrees as radians.")),
    (Function::CBool, row("CBool", &[], "CBool(x)", (1, 1), "x as True or False: numbers other than 0 are True.")),
    (Function::CInt, row("CInt", &[], "CInt(x)", (1, 1), "x as the nearest integer; halves go to the even neighbour.")),
    (Function::CDbl, row("CDbl", &[], "CDbl(x)", (1, 1), "x as a number; texts are read.")),
    (Function::CStr, row("CStr", &[], "CStr(x)", (1, 1), "x as text, numbers in full precision.")),
    (Function::Distance, row("Distance", &["Dist"], "Distance(P, Q)", (2, 2), "The distance between two points.")),
    (Function::DistanceXY, row("DistanceXY", &[], "DistanceXY(P, Q)", (2, 2), "The distance between two points seen from above, without z.")),
    (Function::Angle, row("Angle", &[], "Angle(A, B)", (2, 2), "The angle between two vectors, 0..π.")),
    (Function::CrossProduct, row("CrossProduct", &["Cross"], "CrossProduct(A, B)", (2, 2), "The vector perpendicular to both by the right-hand rule, |A||B| sin θ long.")),
    (Function::DotProduct, row("DotProduct", &["Dot"], "DotProduct(A, B)", (2, 2), "The scalar product |A||B| cos θ.")),
    (Function::Length, row("Length", &["Len"], "Length(v)", (1, 1), "The length of a vector, or the number of characters in a text.")),
    (Function::Unitize, row("Unitize", &["Unit"], "Unitize(v)", (1, 1), "The vector of length 1 in the same direction; short: [v].")),
    (Function::Format, row("Format", &[], "Format(\"pattern {0:0.00}\", a, …)", (1, ANY), "The pattern with {0}, {1}, … replaced by the values, each in the form behind its colon.")),
    (Function::Concat, row("Concat", &["Concatenate"], "Concat(a, b, …)", (1, ANY), "The values as text, one behind the other.")),
    (Function::Contains, row("Contains", &[], "Contains(text, part)", (2, 2), "Whether the part occurs in the text, letter for letter.")),
    (Function::StartsWith, row("StartsWith", &[], "StartsWith(text, part)", (2, 2), "Whether the text begins with the part.")),
    (Function::EndsWith, row("EndsWith", &[], "EndsWith(text, part)", (2, 2), "Whether the text ends with the part.")),
    (Function::IndexOf, row("IndexOf", &[], "IndexOf(text, part)", (2, 2), "Where the part begins, counted from 0; -1 when it does not occur.")),
    (Function::Left, row("Left", &[], "Left(text, count)", (2, 2), "The first characters of the text.")),
    (Function::Right, row("Right", &[], "Right(text, count)", (2, 2), "The last characters of the text.")),
    (Function::Mid, row("Mid", &[], "Mid(text, start) or Mid(text, start, count)", (2, 3), "The characters from a place on, counted from 0.")),
    (Function::Trim, row("Trim", &[], "Trim(text)", (1, 1), "The text without blanks at its ends.")),
    (Function::LCase, row("LCase", &["ToLower"], "LCase(text)", (1, 1), "The text in small letters.")),
    (Function::UCase, row("UCase", &["ToUpper"], "UCase(text)", (1, 1), "The text in capitals.")),
    (Function::Replace, row("Replace", &[], "Replace(text, old, new)", (3, 3), "The text with every occurrence of one part replaced by another.")),
    (Function::If, row("If", &["Iif"], "If(condition, a, b)", (3, 3), "a when the condition is true, else b. Both are computed.")),
    (Function::IsNothing, row("IsNothing", &["IsNull"], "IsNothing(x)", (1, 1), "Whether there is no value.")),
    (Function::Null, row("Null", &["Nothing"], "Null()", (0, 0), "No value.")),
];

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn enum_and_table_have_the_same_order() {
        for (place, (function, help)) in TABLE.iter().enumerate() {
            assert_eq!(*function as usize, place, "{}", help.name);
            assert_eq!(Function::named(&help.name.to_lowercase()), Some(*function));
            assert!(help.signature.contains(help.name) && help.help.ends_with('.'), "{}", help.name);
        }
    }

    #[test]
    fn no_name_is_used_twice() {
        let mut names: Vec<String> = Function::all_names().map(str::to_lowercase).collect();
        names.sort();
        let count = names.len();
        names.dedup();
        assert_eq!(names.len(), count);
    }
}
