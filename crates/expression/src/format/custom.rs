//! Custom numeric forms: `0.00`, `#,##0.0`, `0.0m²`, `0%`, `0.0;(0.0);none`.
//!
//! A form has up to three sections between semicolons: for all numbers or those from zero on, for negative ones,
//! and for zero (also for what rounds to zero). In a section `0` and `#` are places for digits, `.` the decimal
//! point, `,` between places groups thousands and before the point divides by a thousand, `%` and `‰` multiply,
//! `E+0` asks for an exponent, quotes and `\` protect letters, and everything else stands for itself.

use super::Dialect;
use super::decimal::Decimal;
use super::standard::exponent_text;

/// A section with its sign rules worked out.
struct Section<'a> {
    chars: &'a [char],
    /// Places for digits.
    places: i32,
    /// Places before the decimal point.
    before: i32,
    /// First and last `0` as numbers of digits to print: before the point, and (negative) behind it.
    first_zero: i32,
    last_zero: i32,
    grouped: bool,
    scientific: bool,
    /// Powers of ten to multiply by.
    shift: i32,
}

/// A finite number in a custom form.
pub(super) fn format(mut decimal: Decimal, form: &str, dialect: Dialect) -> String {
    let chars: Vec<char> = form.chars().collect();
    let original = decimal.clone();
    let wanted = match (decimal.is_zero(), decimal.negative) {
        (true, _) => 2,
        (false, true) => 1,
        (false, false) => 0,
    };
    let (mut index, mut body) = section(&chars, wanted);
    let mut s = Section::read(body);
    if !decimal.is_zero() {
        s.round(&mut decimal);
        if decimal.is_zero() {
            let zero = section(&chars, 2);
            if zero.0 != index {
                (index, body) = zero;
                s = Section::read(body);
                decimal = Decimal { digits: Vec::new(), scale: 0, negative: original.negative };
            }
        }
    }
    if decimal.is_zero() && dialect == Dialect::Framework {
        decimal.negative = false;
    }
    let text = s.write(&decimal);
    // Only the first section leaves the sign to us.
    if decimal.negative && index == 0 && !text.is_empty() { format!("-{text}") } else { text }
}

/// The section of that number and its text; the first one where it is absent or empty.
fn section(chars: &[char], wanted: usize) -> (usize, &[char]) {
    let mut sections: Vec<&[char]> = Vec::new();
    let mut start = 0;
    let mut at = 0;
    while at < chars.len() {
        match chars.get(at) {
            Some('\\') => at += 1,
            Some(quote @ ('"' | '\'')) => at = after_quote(chars, at, *quote) - 1,
            Some(';') => {
                sections.push(chars.get(start..at).unwrap_or_default());
                start = at + 1;
            }
            _ => {}
        }
        at += 1;
    }
    sections.push(chars.get(start..).unwrap_or_default());
    match sections.get(wanted) {
        Some(body) if wanted > 0 && !body.is_empty() => (wanted, body),
        _ => (0, sections.first().copied().unwrap_or_default()),
    }
}

/// The place behind the quoted text that begins at `at`; the end when it does not close.
fn after_quote(chars: &[char], at: usize, quote: char) -> usize {
    let inside = chars.get(at + 1..).unwrap_or_default();
    inside.iter().position(|c| *c == quote).map_or(chars.len(), |i| at + i + 2)
}

/// Zeros of an exponent mark at `at` (behind the `E`) and whether a plus is printed; `None` when it is a letter.
fn exponent_mark(chars: &[char], at: usize) -> Option<(usize, bool, usize)> {
    let sign = matches!(chars.get(at), Some('+' | '-'));
    let from = at + usize::from(sign);
    let zeros = chars.get(from..).unwrap_or_default().iter().take_while(|c| **c == '0').count();
    (zeros > 0).then(|| (zeros.min(10), chars.get(at) == Some(&'+'), from + zeros))
}

impl<'a> Section<'a> {
    fn read(chars: &'a [char]) -> Self {
        let (mut places, mut point, mut first, mut last) = (0i32, None, None, 0i32);
        let (mut comma_at, mut commas, mut grouped) = (None, 0, false);
        let (mut scientific, mut shift) = (false, 0i32);
        let mut at = 0;
        while let Some(&c) = chars.get(at) {
            match c {
                '#' => places += 1,
                '0' => {
                    first.get_or_insert(places);
                    places += 1;
                    last = places;
                }
                '.' => {
                    point.get_or_insert(places);
                }
                ',' if places > 0 && point.is_none() => {
                    if comma_at == Some(places) {
                        commas += 1;
                    } else {
                        grouped |= comma_at.is_some();
                        comma_at = Some(places);
                        commas = 1;
                    }
                }
                '%' => shift += 2,
                '‰' => shift += 3,
                '"' | '\'' => at = after_quote(chars, at, c) - 1,
                '\\' => at += 1,
                'E' | 'e' => {
                    if let Some((_, _, after)) = exponent_mark(chars, at + 1) {
                        scientific = true;
                        at = after - 1;
                    }
                }
                _ => {}
            }
            at += 1;
        }
        let before = point.unwrap_or(places);
        match comma_at {
            // Commas right before the point divide; any other comma groups.
            Some(place) if place == before => shift -= commas * 3,
            Some(_) => grouped = true,
            None => {}
        }
        Self {
            chars,
            places,
            before,
            first_zero: first.map_or(0, |f| (before - f).max(0)),
            last_zero: (before - last).min(0),
            grouped,
            scientific,
            shift,
        }
    }

    fn round(&self, decimal: &mut Decimal) {
        decimal.scale = decimal.scale.saturating_add(self.shift);
        let count = if self.scientific { self.places } else { decimal.scale + self.places - self.before };
        decimal.round(count);
    }

    /// The section with the digits put in.
    fn write(&self, decimal: &Decimal) -> String {
        let mut out = Writer {
            text: String::new(),
            digits: decimal.digits.iter().map(|d| char::from(*d)),
            grouped: self.grouped,
        };
        // The place of the next digit, counted down to 1 before the point; and how many more (or fewer) digits
        // the number has before the point than the section has places.
        let (mut place, mut surplus) = if self.scientific {
            (self.before, 0)
        } else {
            (self.before.max(decimal.scale), decimal.scale - self.before)
        };
        let mut point_written = false;
        let mut scientific = self.scientific;
        let mut at = 0;
        while let Some(&c) = self.chars.get(at) {
            at += 1;
            if matches!(c, '#' | '0' | '.') {
                while surplus > 0 {
                    out.next_digit_or_zero(place);
                    place -= 1;
                    surplus -= 1;
                }
            }
            match c {
                '#' | '0' => {
                    if surplus < 0 {
                        surplus += 1;
                        if place <= self.first_zero {
                            out.put('0', place);
                        }
                    } else if let Some(digit) = out.digits.next() {
                        out.put(digit, place);
                    } else if place > self.last_zero {
                        out.put('0', place);
                    }
                    place -= 1;
                }
                '.' if place == 0 && !point_written => {
                    if self.last_zero < 0 || (self.before < self.places && out.digits.len() > 0) {
                        out.text.push('.');
                        point_written = true;
                    }
                }
                '.' | ',' => {}
                '"' | '\'' => {
                    let after = after_quote(self.chars, at - 1, c);
                    let inside = self.chars.get(at..after).unwrap_or_default();
                    out.text.extend(inside.strip_suffix(&[c]).unwrap_or(inside));
                    at = after;
                }
                '\\' => {
                    out.text.extend(self.chars.get(at));
                    at += 1;
                }
                'E' | 'e' => match exponent_mark(self.chars, at) {
                    Some((zeros, plus, after)) if scientific => {
                        let exponent = if decimal.is_zero() { 0 } else { decimal.scale - self.before };
                        out.text.push_str(&exponent_text(exponent, c, zeros, plus));
                        scientific = false;
                        at = after;
                    }
                    Some((_, _, after)) => {
                        out.text.extend(self.chars.get(at - 1..after).unwrap_or_default());
                        at = after;
                    }
                    None => out.text.push(c),
                },
                _ => out.text.push(c),
            }
        }
        out.text
    }
}

struct Writer<I> {
    text: String,
    digits: I,
    grouped: bool,
}

impl<I: Iterator<Item = char>> Writer<I> {
    /// A digit, and the comma behind it when three, six, … more come before the point.
    fn put(&mut self, digit: char, place: i32) {
        self.text.push(digit);
        if self.grouped && place > 1 && (place - 1) % 3 == 0 {
            self.text.push(',');
        }
    }

    fn next_digit_or_zero(&mut self, place: i32) {
        let digit = self.digits.next().unwrap_or('0');
        self.put(digit, place);
    }
}
