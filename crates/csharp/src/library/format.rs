//! Numbers as texts in .NET's standard and custom formats, in the invariant culture, as the Framework writes them:
//! at most 15 significant digits unless more are asked for, and no sign on zero.

use crate::decimal::Decimal;
use crate::vm::Raise;

/// A number by its decimal digits: 0.d1d2d3… × 10^point.
#[derive(Debug, Clone)]
pub(super) struct Digits {
    pub(super) negative: bool,
    pub(super) digits: Vec<u8>,
    pub(super) point: i32,
}

/// No double has more significant digits.
const EXACT: usize = 770;

impl Digits {
    /// So many significant digits of a finite number, halves rounded away from zero.
    pub(super) fn of_real(x: f64, precision: usize) -> Self {
        if x == 0.0 {
            return Self { negative: false, digits: Vec::new(), point: 0 };
        }
        let kept = precision.clamp(1, EXACT);
        let mut made = Self::written(x, kept + 1);
        if made.digits.get(kept) == Some(&5) {
            // Only all digits say whether it is a half, or a little less and rounded already.
            made = Self::written(x, EXACT);
        }
        let up = made.digits.get(kept).is_some_and(|digit| *digit >= 5);
        made.digits.truncate(kept);
        if up {
            made.increment();
        }
        made.trim();
        made
    }

    /// So many digits, with the zeros at the end.
    fn written(x: f64, digits: usize) -> Self {
        let text = format!("{:.*e}", digits - 1, x.abs());
        let (mantissa, exponent) = text.split_once('e').unwrap_or((&text, "0"));
        let digits = mantissa.bytes().filter(u8::is_ascii_digit).map(|b| b - b'0').collect();
        Self { negative: x < 0.0, digits, point: exponent.parse::<i32>().unwrap_or(0) + 1 }
    }

    /// The digits of a decimal, without the zeros behind them.
    fn of_decimal(x: Decimal) -> Self {
        let digits: Vec<u8> = x.mantissa().unsigned_abs().to_string().bytes().map(|b| b - b'0').collect();
        let point = digits.len() as i32 - x.scale() as i32;
        let mut made = Self { negative: x.is_sign_negative(), digits, point };
        if x.is_zero() {
            made.digits.clear();
        }
        made.trim();
        made
    }

    /// The digits of a whole number.
    pub(super) fn of_whole(n: i128) -> Self {
        let text = n.unsigned_abs().to_string();
        let digits: Vec<u8> = if n == 0 { Vec::new() } else { text.bytes().map(|b| b - b'0').collect() };
        let point = digits.len() as i32;
        let mut made = Self { negative: n < 0, digits, point };
        made.trim();
        made
    }

    fn trim(&mut self) {
        while self.digits.last() == Some(&0) {
            self.digits.pop();
        }
        if self.digits.is_empty() {
            self.point = 0;
        }
    }

    /// Rounds to so many digits behind the decimal point, halves away from zero.
    fn round(&mut self, decimals: i32) {
        let keep = self.point + decimals;
        if keep < 0 {
            self.digits.clear();
            self.point = 0;
        } else if (keep as usize) < self.digits.len() {
            let up = self.digits[keep as usize] >= 5;
            self.digits.truncate(keep as usize);
            if up {
                self.increment();
            }
        }
        self.trim();
    }

    fn increment(&mut self) {
        for digit in self.digits.iter_mut().rev() {
            if *digit < 9 {
                *digit += 1;
                return;
            }
            *digit = 0;
        }
        self.digits.insert(0, 1);
        self.point += 1;
    }

    fn digit(&self, place: i32) -> char {
        let value = usize::try_from(place).ok().and_then(|i| self.digits.get(i)).copied().unwrap_or(0);
        char::from(b'0' + value)
    }

    fn whole(&self) -> String {
        if self.point <= 0 { "0".to_owned() } else { (0..self.point).map(|i| self.digit(i)).collect() }
    }

    fn fixed(&self, decimals: i32) -> String {
        let mut text = self.whole();
        if decimals > 0 {
            text.push('.');
            text.extend((0..decimals).map(|i| self.digit(self.point + i)));
        }
        text
    }

    fn is_zero(&self) -> bool {
        self.digits.is_empty()
    }
}

fn bad_format() -> Raise {
    Raise::new("FormatException", "Format specifier was invalid.")
}

/// What a number is, for the formats that only some take.
#[derive(Debug, Clone, Copy)]
pub(super) enum Number {
    Whole(i128, u32),
    Double(f64),
    Float(f32),
    Decimal(Decimal),
}

impl Number {
    fn special(self) -> Option<&'static str> {
        let x = match self {
            Self::Whole(..) | Self::Decimal(_) => return None,
            Self::Double(x) => x,
            Self::Float(x) => f64::from(x),
        };
        if x.is_nan() {
            Some("NaN")
        } else if x == f64::INFINITY {
            Some("Infinity")
        } else if x == f64::NEG_INFINITY {
            Some("-Infinity")
        } else {
            None
        }
    }

    /// The significant digits that formats begin with, from which they round once more: 15 of a `double` and 7 of a
    /// `float`; 17 and 9, by which each can be told from its neighbours, where more are asked for.
    fn digits(self, asked: usize) -> Digits {
        match self {
            Self::Whole(n, _) => Digits::of_whole(n),
            Self::Double(x) => Digits::of_real(x, if asked > 15 { 17 } else { 15 }),
            Self::Float(x) => Digits::of_real(x.into(), if asked > 7 { 9 } else { 7 }),
            Self::Decimal(x) => Digits::of_decimal(x),
        }
    }

    fn default_precision(self) -> usize {
        match self {
            Self::Whole(..) => 40,
            Self::Double(_) => 15,
            Self::Float(_) => 7,
            Self::Decimal(_) => 29,
        }
    }
}

/// A number without a format.
pub(super) fn plain(number: Number) -> String {
    if let Some(special) = number.special() {
        return special.to_owned();
    }
    if let Number::Whole(n, _) = number {
        return n.to_string();
    }
    if let Number::Decimal(x) = number {
        // The scale is kept: `1.50` stays as it is, and there is no exponent.
        let d = Digits::of_decimal(x);
        let sign = if d.negative && !d.is_zero() { "-" } else { "" };
        return format!("{sign}{}", d.fixed(x.scale() as i32));
    }
    general(number.digits(number.default_precision()), number.default_precision() as i32, 'E', true)
}

/// `G`: plain between 10^-5 and 10^precision, else with an exponent.
fn general(d: Digits, precision: i32, letter: char, two: bool) -> String {
    let sign = if d.negative && !d.is_zero() { "-" } else { "" };
    let exponent = if d.is_zero() { 0 } else { d.point - 1 };
    if exponent >= precision || exponent < -4 {
        let mut text = format!("{sign}{}", d.digit(0));
        if d.digits.len() > 1 {
            text.push('.');
            text.extend((1..d.digits.len()).map(|i| d.digit(i as i32)));
        }
        text.push(letter);
        text.push(if exponent < 0 { '-' } else { '+' });
        let width = if two { 2 } else { 1 };
        text.push_str(&format!("{:0width$}", exponent.abs()));
        return text;
    }
    let decimals = (d.digits.len() as i32 - d.point).max(0);
    format!("{sign}{}", d.fixed(decimals))
}

/// A number in a format.
pub(super) fn formatted(number: Number, format: &str) -> Result<String, Raise> {
    if format.is_empty() {
        return Ok(plain(number));
    }
    let mut chars = format.chars();
    let letter = chars.next().unwrap_or('G');
    let rest = chars.as_str();
    let standard =
        letter.is_ascii_alphabetic() && rest.len() <= 2 && rest.bytes().all(|b| b.is_ascii_digit());
    if let Some(special) = number.special() {
        return Ok(special.to_owned());
    }
    if standard {
        let precision = if rest.is_empty() { None } else { rest.parse::<usize>().ok() };
        return standard_format(number, letter, precision);
    }
    Ok(custom(number, format))
}

fn group(whole: &str) -> String {
    let mut text = String::new();
    for (i, c) in whole.chars().enumerate() {
        if i > 0 && (whole.len() - i).is_multiple_of(3) {
            text.push(',');
        }
        text.push(c);
    }
    text
}

fn standard_format(number: Number, letter: char, precision: Option<usize>) -> Result<String, Raise> {
    let signed =
        |d: &Digits, text: String| if d.negative && !d.is_zero() { format!("-{text}") } else { text };
    match letter.to_ascii_uppercase() {
        'F' | 'N' | 'P' | 'C' => {
            let decimals = precision.unwrap_or(2);
            let mut d = number.digits(0);
            if letter.eq_ignore_ascii_case(&'P') && !d.is_zero() {
                d.point += 2;
            }
            d.round(decimals as i32);
            let text = d.fixed(decimals as i32);
            Ok(match letter.to_ascii_uppercase() {
                'F' => signed(&d, text),
                'C' => {
                    let (whole, part) = text.split_at(d.whole().len());
                    let body = format!("¤{}{part}", group(whole));
                    if d.negative && !d.is_zero() { format!("({body})") } else { body }
                }
                upper => {
                    let (whole, part) = text.split_at(d.whole().len());
                    let body = signed(&d, format!("{}{part}", group(whole)));
                    if upper == 'P' { format!("{body} %") } else { body }
                }
            })
        }
        'E' => {
            let decimals = precision.unwrap_or(6);
            let mut d = number.digits(decimals + 1);
            let exponent_before = d.point;
            if !d.is_zero() {
                d.round(decimals as i32 + 1 - exponent_before);
            }
            let exponent = if d.is_zero() { 0 } else { d.point - 1 };
            let mut text = d.digit(0).to_string();
            if decimals > 0 {
                text.push('.');
                text.extend((1..=decimals).map(|i| d.digit(i as i32)));
            }
            text.push(letter);
            text.push(if exponent < 0 { '-' } else { '+' });
            text.push_str(&format!("{:03}", exponent.abs()));
            Ok(signed(&d, text))
        }
        'G' => {
            let given = precision.filter(|p| *p > 0);
            // `G` alone keeps the scale of a decimal; `G0` does not.
            let bare = match number {
                Number::Whole(..) => given.is_none(),
                Number::Decimal(_) => precision.is_none(),
                _ => false,
            };
            if bare {
                return Ok(plain(number));
            }
            let precision = given.unwrap_or(number.default_precision());
            let mut d = number.digits(precision.max(1));
            if !d.is_zero() {
                let point = d.point;
                d.round(precision as i32 - point);
            }
            let letter = if letter == 'g' { 'e' } else { 'E' };
            Ok(general(d, precision as i32, letter, true))
        }
        'R' => Ok(match number {
            Number::Whole(..) | Number::Decimal(_) => return Err(bad_format()),
            Number::Double(x) => {
                let short = Digits::of_real(x, 15);
                let text = general(short, 15, 'E', true);
                if text.parse::<f64>() == Ok(x) {
                    text
                } else {
                    general(Digits::of_real(x, 17), 17, 'E', true)
                }
            }
            Number::Float(x) => {
                let text = general(Digits::of_real(x.into(), 7), 7, 'E', true);
                if text.parse::<f32>() == Ok(x) {
                    text
                } else {
                    general(Digits::of_real(x.into(), 9), 9, 'E', true)
                }
            }
        }),
        'D' | 'X' => {
            let Number::Whole(n, bits) = number else { return Err(bad_format()) };
            let width = precision.unwrap_or(0);
            if letter.eq_ignore_ascii_case(&'D') {
                let digits = format!("{:0width$}", n.unsigned_abs());
                return Ok(if n < 0 { format!("-{digits}") } else { digits });
            }
            let mask = if bits >= 64 { u64::MAX } else { (1_u64 << bits) - 1 };
            let raw = n as u64 & mask;
            Ok(if letter == 'X' { format!("{raw:0width$X}") } else { format!("{raw:0width$x}") })
        }
        _ => Err(bad_format()),
    }
}

/// The section of a custom format for a number.
fn section(format: &str, d: &Digits) -> (String, bool) {
    let mut sections = vec![String::new()];
    let mut chars = format.chars();
    let mut quote = None;
    while let Some(c) = chars.next() {
        let last = sections.len() - 1;
        match (quote, c) {
            (Some(q), _) => {
                sections[last].push(c);
                if c == q {
                    quote = None;
                }
            }
            (None, ';') => sections.push(String::new()),
            (None, '\\') => {
                sections[last].push(c);
                sections[last].extend(chars.next());
            }
            (None, _) => {
                if c == '\'' || c == '"' {
                    quote = Some(c);
                }
                sections[last].push(c);
            }
        }
    }
    let get = |i: usize| sections.get(i).filter(|s| !s.is_empty()).cloned();
    if d.is_zero() {
        return (get(2).unwrap_or_else(|| sections[0].clone()), false);
    }
    if d.negative
        && let Some(own) = get(1)
    {
        return (own, true);
    }
    (sections[0].clone(), false)
}

fn custom(number: Number, format: &str) -> String {
    let mut d = number.digits(0);
    let (mut body, mut own_sign) = section(format, &d);
    let mut shape = Shape::read(&body);
    let mut scaled = d.clone();
    shape.apply(&mut scaled);
    if scaled.is_zero() && !d.is_zero() {
        // What rounds to zero is written as zero is.
        let zero = Digits { negative: false, digits: Vec::new(), point: 0 };
        (body, own_sign) = section(format, &zero);
        shape = Shape::read(&body);
        d = zero.clone();
        scaled = zero;
    }
    let text = shape.write(&body, &scaled);
    if d.negative && !own_sign && !scaled.is_zero() { format!("-{text}") } else { text }
}

/// What a section of a custom format asks for.
#[derive(Debug, Default)]
struct Shape {
    before: i32,
    after: i32,
    first_zero: Option<i32>,
    last_zero: i32,
    grouped: bool,
    shift: i32,
    exponent: bool,
}

impl Shape {
    fn read(body: &str) -> Self {
        let mut s = Self::default();
        let chars: Vec<char> = body.chars().collect();
        let (mut i, mut point, mut commas) = (0, false, 0);
        while i < chars.len() {
            match chars[i] {
                '\\' => i += 1,
                q @ ('\'' | '"') => {
                    i += 1;
                    while i < chars.len() && chars[i] != q {
                        i += 1;
                    }
                }
                c @ ('0' | '#') => {
                    if commas > 0 && !point {
                        s.grouped = true;
                        commas = 0;
                    }
                    if point {
                        s.after += 1;
                        if c == '0' {
                            s.last_zero = s.after;
                        }
                    } else {
                        if c == '0' && s.first_zero.is_none() {
                            s.first_zero = Some(s.before);
                        }
                        s.before += 1;
                    }
                }
                '.' => point = true,
                ',' if !point && s.before > 0 => commas += 1,
                '%' => s.shift += 2,
                '\u{2030}' => s.shift += 3,
                'e' | 'E' if Self::is_exponent(&chars, i) => {
                    s.exponent = true;
                    i += 1;
                    while i + 1 < chars.len() && chars[i + 1] == '0' {
                        i += 1;
                    }
                }
                _ => {}
            }
            i += 1;
        }
        s.shift -= 3 * commas;
        s
    }

    fn is_exponent(chars: &[char], i: usize) -> bool {
        match chars.get(i + 1) {
            Some('0') => true,
            Some('+' | '-') => chars.get(i + 2) == Some(&'0'),
            _ => false,
        }
    }

    fn apply(&self, d: &mut Digits) {
        if d.is_zero() {
            return;
        }
        if self.exponent {
            let keep = self.before + self.after;
            let point = d.point;
            d.round(keep - point);
            return;
        }
        d.point += self.shift;
        d.round(self.after);
    }

    fn write(&self, body: &str, d: &Digits) -> String {
        let exponent = if d.is_zero() { 0 } else { d.point - self.before };
        let point = if self.exponent { self.before } else { d.point };
        let zeros_before = self.first_zero.map_or(0, |f| self.before - f);
        let shown = point.max(zeros_before).max(0);
        let mut out = String::new();
        let chars: Vec<char> = body.chars().collect();
        let (mut i, mut seen, mut after, mut behind, mut started) = (0, 0, 0, false, false);
        while i < chars.len() {
            match chars[i] {
                '\\' => {
                    i += 1;
                    out.extend(chars.get(i));
                }
                q @ ('\'' | '"') => {
                    i += 1;
                    while i < chars.len() && chars[i] != q {
                        out.push(chars[i]);
                        i += 1;
                    }
                }
                '0' | '#' if !behind => {
                    seen += 1;
                    // The first place takes all digits that are too many.
                    let until = shown - (self.before - seen);
                    let from = if started { until - 1 } else { 0 };
                    for at in from.max(0)..until {
                        let place = at - (shown - point);
                        out.push(if place < 0 { '0' } else { d.digit(place) });
                        started = true;
                        let left = shown - at - 1;
                        if self.grouped && left > 0 && left % 3 == 0 {
                            out.push(',');
                        }
                    }
                }
                '0' | '#' => {
                    after += 1;
                    let place = point + after - 1;
                    if after <= self.last_zero || (d.digits.len() as i32) > place {
                        if after == 1 {
                            out.push('.');
                        }
                        out.push(d.digit(place));
                    }
                }
                '.' => behind = true,
                ',' => {}
                'e' | 'E' if self.exponent && Self::is_exponent(&chars, i) => {
                    out.push(chars[i]);
                    let plus = chars[i + 1] == '+';
                    i += usize::from(matches!(chars[i + 1], '+' | '-'));
                    let mut width = 0;
                    while chars.get(i + 1) == Some(&'0') {
                        width += 1;
                        i += 1;
                    }
                    if exponent < 0 {
                        out.push('-');
                    } else if plus {
                        out.push('+');
                    }
                    out.push_str(&format!("{:0width$}", exponent.abs()));
                }
                c => out.push(c),
            }
            i += 1;
        }
        out
    }
}
