//! Entities as text.

use std::fmt;

use super::text;

/// The name of an entity in the file that is being written.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash)]
pub(crate) struct Id(u64);

impl fmt::Display for Id {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        write!(f, "#{}", self.0)
    }
}

/// The data section that is being written.
#[derive(Debug, Default)]
pub(crate) struct Sheet {
    text: String,
    count: u64,
}

impl Sheet {
    /// Writes an entity; gives its name.
    pub(crate) fn put(&mut self, body: impl fmt::Display) -> Id {
        use fmt::Write;
        self.count += 1;
        // Writing to a string does not fail.
        let _ = writeln!(self.text, "#{}={body};", self.count);
        Id(self.count)
    }

    /// What was written.
    pub(crate) fn into_text(self) -> String {
        self.text
    }

    /// How much was written, to come back to with [`Sheet::back_to`].
    pub(crate) fn mark(&self) -> (usize, u64) {
        (self.text.len(), self.count)
    }

    /// Forgets what was written since.
    pub(crate) fn back_to(&mut self, (length, count): (usize, u64)) {
        self.text.truncate(length);
        self.count = count;
    }
}

/// A real: always with a point, the exponent in capitals.
pub(crate) fn real(x: f64) -> String {
    let plain = format!("{x:?}");
    match plain.split_once('e') {
        Some((mantissa, exponent)) if mantissa.contains('.') => format!("{mantissa}E{exponent}"),
        Some((mantissa, exponent)) => format!("{mantissa}.E{exponent}"),
        None => plain,
    }
}

/// A list of anything.
pub(crate) fn list<T: fmt::Display>(items: impl IntoIterator<Item = T>) -> String {
    let mut out = String::from("(");
    for (place, item) in items.into_iter().enumerate() {
        use fmt::Write;
        let _ = write!(out, "{}{item}", if place == 0 { "" } else { "," });
    }
    out.push(')');
    out
}

/// A string in quotes.
pub(crate) fn quoted(s: &str) -> String {
    format!("'{}'", text::encoded(s))
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn reals_have_a_point() {
        let all = [0.0, -1.0, 1e-7, 2.5e300, 1e16, 0.1].map(real);
        assert_eq!(all, ["0.0", "-1.0", "1.E-7", "2.5E300", "1.E16", "0.1"]);
    }

    #[test]
    fn entities_are_numbered_and_forgotten() {
        let mut sheet = Sheet::default();
        let first = sheet.put("A()");
        let mark = sheet.mark();
        sheet.put(format_args!("B({first})"));
        sheet.back_to(mark);
        sheet.put("C()");
        assert_eq!(sheet.into_text(), "#1=A();\n#2=C();\n");
    }
}
