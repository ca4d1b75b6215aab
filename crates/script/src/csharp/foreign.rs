//! Text of another language in a C# component, as a wire can bring it: that is said in plain words.

/// Whether a line stands in Python and in no C#.
fn is_python(line: &str) -> bool {
    let line = line.split('#').next().unwrap_or_default().trim();
    let begins = |word: &str| line.strip_prefix(word).is_some_and(|rest| rest.starts_with([' ', '(']));
    let is_import = (begins("import") || begins("from") && line.contains(" import "))
        && !line.ends_with(';')
        && !line.contains('=');
    let opens = line.ends_with(':')
        && ["def", "class", "if", "elif", "for", "while", "with", "except"].iter().any(|word| begins(word));
    let plain = matches!(line, "else:" | "try:" | "except:" | "finally:" | "pass");
    is_import || opens || plain
}

/// The line, from 1, on which a text that is no C# shows that it is Python.
///
/// Statements of C# end in `;` or stand in braces: a text with some of these is taken for C# with a fault in it.
pub(super) fn python_line(text: &str) -> Option<u32> {
    let ends_as_csharp = |line: &str| line.trim_end().ends_with([';', '{', '}']);
    if text.lines().any(ends_as_csharp) {
        return None;
    }
    let at = text.lines().position(is_python)?;
    u32::try_from(at + 1).ok()
}

#[cfg(test)]
mod tests {
    use super::python_line;

    #[test]
    fn python_is_told_from_csharp() {
        for (text, line) in [
            ("import rhinoscriptsyntax as rs\na = rs.AddPoint(0, 0, 0)", Some(1)),
            ("# a comment\nfrom math import sin\na = sin(x)", Some(2)),
            ("a = []\nfor i in range(3):\n    a.append(i)", Some(2)),
            ("def f(x):\n  return x", Some(1)),
            ("a = x + 1;", None),
            ("for (int i = 0; i < 3; i++)\n  a = i;", None),
            ("switch (x) {\n case 1:\n  break;\n}", None),
            ("a = x + 1", None),
            ("", None),
        ] {
            assert_eq!(python_line(text), line, "{text}");
        }
    }
}
