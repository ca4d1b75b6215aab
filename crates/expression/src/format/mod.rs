//! .NET composite format strings in the invariant culture: `"{0:0.00} of {1,8:N0}"`.
//!
//! Written from the public description of `String.Format`, standard and custom numeric format strings.

mod custom;
mod decimal;
mod fixed;
mod parse;
mod standard;

use crate::Variant;
pub use parse::parse_number;
pub use standard::number_text;

/// Which .NET writes the text.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default)]
pub enum Dialect {
    /// .NET 7, Rhino 8: numbers in the fewest digits that read back as the same number, exact decimals in `F`,
    /// `N`, `E` and `P`, and `-0` for negative zero.
    #[default]
    Modern,
    /// .NET Framework, Rhino 5 to 7: 15 significant digits, no sign on zero.
    Framework,
}

/// Why a format string cannot be applied.
#[derive(Debug, Clone, PartialEq, Eq, thiserror::Error)]
#[non_exhaustive]
pub enum FormatError {
    /// A `{` without its `}`, or the other way round.
    #[error("the '{brace}' at character {at} has no partner; write it twice to print it")]
    LoneBrace {
        /// The brace.
        brace: char,
        /// Its place, counted in characters from 1.
        at: usize,
    },
    /// Something other than a number behind `{`.
    #[error("the item at character {at} must begin with the number of a value, as in {{0}}")]
    BadIndex {
        /// The place of the brace, counted in characters from 1.
        at: usize,
    },
    /// An item without a value.
    #[error("the item {{{index}}} at character {at} has no value: {count} {} given", if *.count == 1 { "is" } else { "are" })]
    MissingValue {
        /// The number in the item.
        index: usize,
        /// How many values there are.
        count: usize,
        /// The place of the brace, counted in characters from 1.
        at: usize,
    },
    /// Something other than a width behind the comma.
    #[error("the width of the item at character {at} must be a whole number below {WIDTH_LIMIT}")]
    BadWidth {
        /// The place of the brace, counted in characters from 1.
        at: usize,
    },
    /// A form that does not exist or does not fit the value.
    #[error("'{format}' does not fit {value}: {reason}")]
    BadFormat {
        /// The form behind the colon.
        format: String,
        /// The type of the value, with its article.
        value: &'static str,
        /// The rule it breaks.
        reason: &'static str,
    },
    /// A text above [`crate::MAX_TEXT`].
    #[error("the text would be longer than {0} bytes")]
    TooLong(usize),
}

/// Widths from here on are refused.
const WIDTH_LIMIT: usize = 100_000;

/// Replaces `{index}`, `{index,width}` and `{index:format}` by the values; `{{` and `}}` print one brace.
///
/// The width pads with blanks on the left, a negative one on the right. Numbers take standard forms (`F2`, `N`,
/// `E`, `P`, `G`, `R`, `D`, `X`, `C`) and custom ones (`0.00`, `#,##0.0`); the coordinates of points each take
/// the form; texts, booleans and nulls (empty) ignore it.
///
/// # Errors
/// When the pattern is not well formed, names a value that is not there, or has a form unfit for the value.
pub fn format(pattern: &str, values: &[Variant], dialect: Dialect) -> Result<String, FormatError> {
    let mut out = String::with_capacity(pattern.len() + 16);
    let mut reader = Reader { pattern, at: 0 };
    while let Some(c) = reader.next() {
        match c {
            '{' if reader.eat('{') => out.push('{'),
            '}' if reader.eat('}') => out.push('}'),
            '{' => item(&mut reader, values, dialect, &mut out)?,
            '}' => return Err(FormatError::LoneBrace { brace: '}', at: reader.place() - 1 }),
            c => out.push(c),
        }
        if out.len() > crate::MAX_TEXT {
            return Err(FormatError::TooLong(crate::MAX_TEXT));
        }
    }
    Ok(out)
}

struct Reader<'a> {
    pattern: &'a str,
    at: usize,
}

impl Reader<'_> {
    fn peek(&self) -> Option<char> {
        self.pattern.get(self.at..).and_then(|r| r.chars().next())
    }

    fn next(&mut self) -> Option<char> {
        let c = self.peek()?;
        self.at += c.len_utf8();
        Some(c)
    }

    fn eat(&mut self, c: char) -> bool {
        let found = self.peek() == Some(c);
        if found {
            self.at += c.len_utf8();
        }
        found
    }

    fn blanks(&mut self) {
        while self.eat(' ') {}
    }

    /// A whole number below the limit, digits only.
    fn whole(&mut self, limit: usize) -> Option<usize> {
        let mut value: Option<usize> = None;
        while let Some(digit) = self.peek().and_then(|c| c.to_digit(10)) {
            self.at += 1;
            let next = value.unwrap_or(0).saturating_mul(10).saturating_add(digit as usize);
            value = Some(next.min(limit));
        }
        value.filter(|v| *v < limit)
    }

    /// The place of the next character, counted from 1.
    fn place(&self) -> usize {
        self.pattern.get(..self.at).map_or(0, |t| t.chars().count()) + 1
    }
}

/// What follows an opening brace, up to the closing one.
fn item(
    reader: &mut Reader<'_>,
    values: &[Variant],
    dialect: Dialect,
    out: &mut String,
) -> Result<(), FormatError> {
    let (pattern, opened) = (reader.pattern, reader.at);
    let at = || Reader { pattern, at: opened }.place() - 1;
    let lone = || FormatError::LoneBrace { brace: '{', at: at() };
    reader.blanks();
    if reader.peek().is_none() {
        return Err(lone());
    }
    let index = reader.whole(1_000_000).ok_or_else(|| FormatError::BadIndex { at: at() })?;
    reader.blanks();
    let mut width = 0;
    let mut left = false;
    if reader.eat(',') {
        reader.blanks();
        left = reader.eat('-');
        width = reader.whole(WIDTH_LIMIT).ok_or_else(|| FormatError::BadWidth { at: at() })?;
        reader.blanks();
    }
    let mut form = "";
    if reader.eat(':') {
        let rest = pattern.get(reader.at..).unwrap_or_default();
        form = rest.split_once('}').ok_or_else(lone)?.0;
        reader.at += form.len();
    }
    if !reader.eat('}') {
        return Err(if reader.peek().is_none() { lone() } else { FormatError::BadIndex { at: at() } });
    }
    let value = values.get(index).ok_or_else(|| FormatError::MissingValue {
        index,
        count: values.len(),
        at: at(),
    })?;
    if let (0, Variant::Number(x)) = (width, value)
        && fixed::push(*x, form, out)
    {
        return Ok(());
    }
    let text = format_value(value, form, dialect)?;
    let padding = width.saturating_sub(text.encode_utf16().count());
    if out.len().saturating_add(padding).saturating_add(text.len()) > crate::MAX_TEXT {
        return Err(FormatError::TooLong(crate::MAX_TEXT));
    }
    let blanks = std::iter::repeat_n(' ', padding);
    if left {
        out.push_str(&text);
        out.extend(blanks);
    } else {
        out.extend(blanks);
        out.push_str(&text);
    }
    Ok(())
}

/// One value in a form; the empty form is full precision.
///
/// # Errors
/// When the form does not exist or does not fit the value.
pub fn format_value(value: &Variant, form: &str, dialect: Dialect) -> Result<String, FormatError> {
    if form.is_empty() {
        return Ok(value.to_text(dialect));
    }
    let number = |x: f64| standard::format_number(x, form, dialect);
    Ok(match value {
        Variant::Null | Variant::Boolean(_) | Variant::Text(_) => value.to_text(dialect),
        Variant::Integer(i) => standard::format_integer(*i, form)?,
        Variant::Number(x) => number(*x)?,
        Variant::Point(p) => format!("{{{}, {}, {}}}", number(p.x)?, number(p.y)?, number(p.z)?),
        Variant::Plane(p) => format!(
            "O({}, {}, {}) Z({}, {}, {})",
            number(p.origin.x)?,
            number(p.origin.y)?,
            number(p.origin.z)?,
            number(p.z_axis.x)?,
            number(p.z_axis.y)?,
            number(p.z_axis.z)?
        ),
        Variant::Complex { re, im } => {
            let sign = if im.is_sign_negative() { "" } else { "+" };
            format!("{}{sign}{}i", number(*re)?, number(*im)?)
        }
    })
}

#[cfg(test)]
mod tests;
