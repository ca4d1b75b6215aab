//! Texts and names between quotes.

/// A text in double quotes, or in quotes of another sort, on one line.
pub(super) fn quote(text: &str, quote: char) -> String {
    let mut out = String::with_capacity(text.len() + 2);
    out.push(quote);
    for c in text.chars() {
        match c {
            '\\' => out.push_str("\\\\"),
            '\n' => out.push_str("\\n"),
            '\r' => out.push_str("\\r"),
            '\t' => out.push_str("\\t"),
            _ if c == quote => {
                out.push('\\');
                out.push(c);
            }
            // Marks that turn the direction of writing round could hide what a text says.
            _ if c.is_control()
                || matches!(c, '\u{2028}' | '\u{2029}' | '\u{202a}'..='\u{202e}' | '\u{2066}'..='\u{2069}' | '\u{feff}') =>
            {
                out.push_str(&format!("\\u{{{:x}}}", u32::from(c)));
            }
            _ => out.push(c),
        }
    }
    out.push(quote);
    out
}

/// What a quoted text says; `Err` is the place of an escape that means nothing.
pub(super) fn unquote(token: &str) -> Result<String, usize> {
    let mut out = String::with_capacity(token.len());
    let inside = token.get(1..token.len().saturating_sub(1)).unwrap_or_default();
    let mut rest = inside.char_indices();
    while let Some((k, c)) = rest.next() {
        if c != '\\' {
            out.push(c);
            continue;
        }
        match rest.next().map(|(_, c)| c) {
            Some('n') => out.push('\n'),
            Some('r') => out.push('\r'),
            Some('t') => out.push('\t'),
            Some(c @ ('\\' | '"' | '`' | '\'')) => out.push(c),
            Some('u') => {
                let tail = inside.get(k + 2..).unwrap_or_default();
                let code = tail.strip_prefix('{').and_then(|tail| tail.split_once('}'));
                let digits = code.map(|(digits, _)| digits).filter(|d| (1..=6).contains(&d.len()));
                let c = digits.and_then(|d| u32::from_str_radix(d, 16).ok()).and_then(char::from_u32);
                out.push(c.ok_or(k + 1)?);
                // The brace, the digits, the brace.
                for _ in 0..digits.map_or(0, str::len) + 2 {
                    rest.next();
                }
            }
            _ => return Err(k + 1),
        }
    }
    Ok(out)
}

/// Whether a text reads better on lines of its own, and can stand there unchanged.
pub(super) fn suits_raw(text: &str) -> bool {
    let plain = |c: char| !c.is_control() || matches!(c, '\n' | '\t');
    let unix = text.replace("\r\n", "\n");
    let lines = unix.matches('\n').count();
    // Lines must all end alike, so that the mark for them suits all.
    let alike = !text.contains('\r') || text.matches("\r\n").count() == lines;
    lines > 0 && alike && unix.chars().all(plain) && !unix.contains(['\u{feff}', '\u{2028}', '\u{2029}'])
}

/// A text over several lines, the way [`unraw`] reads it. The closing line stands `indent` blanks in.
pub(super) fn raw(text: &str, indent: usize) -> String {
    let crlf = text.contains('\r');
    let unix = text.replace("\r\n", "\n");
    let mut quotes = 3;
    while unix.contains(&"\"".repeat(quotes)) {
        quotes += 1;
    }
    let fence = "\"".repeat(quotes);
    let margin = " ".repeat(indent);
    let mut out = fence.clone();
    out.push_str(if crlf { "crlf\n" } else { "\n" });
    for line in unix.split('\n') {
        if !line.is_empty() {
            out.push_str(&margin);
            out.push_str(line);
        }
        out.push('\n');
    }
    out.push_str(&margin);
    out.push_str(&fence);
    out
}

/// What a text over several lines says: its lines without the margin, which is what stands before the closing
/// quotes. `Err` is the place of a line that does not keep the margin, or of something behind the opening quotes.
pub(super) fn unraw(token: &str) -> Result<String, usize> {
    let quotes = token.len() - token.trim_start_matches('"').len();
    let (first, rest) = token.split_once('\n').ok_or(0usize)?;
    let crlf = match first.get(quotes..).unwrap_or_default().trim() {
        "" => false,
        "crlf" => true,
        _ => return Err(quotes),
    };
    let (body, last) = rest.rsplit_once('\n').unwrap_or(("", rest));
    let has_lines = rest.contains('\n');
    let margin = last.get(..last.len().saturating_sub(quotes)).unwrap_or_default();
    let mut out = String::with_capacity(body.len());
    let mut at = first.len() + 1;
    for (k, line) in body.split('\n').enumerate().take(if has_lines { usize::MAX } else { 0 }) {
        if k > 0 {
            out.push_str(if crlf { "\r\n" } else { "\n" });
        }
        let clean = line.strip_suffix('\r').unwrap_or(line);
        match clean.strip_prefix(margin) {
            Some(text) => out.push_str(text),
            None if clean.trim().is_empty() => {}
            None => return Err(at),
        }
        at += line.len() + 1;
    }
    Ok(out)
}

#[cfg(test)]
mod tests {
    use super::{quote, raw, suits_raw, unquote, unraw};

    #[test]
    fn quoted_texts_come_back() {
        for text in ["", "a", "\"", "\\", "a\nb\r\n\t", "é\u{7}\u{202e}", "'`", "\\u{41}"] {
            assert_eq!(unquote(&quote(text, '"')).as_deref(), Ok(text));
            assert_eq!(unquote(&quote(text, '`')).as_deref(), Ok(text));
        }
        assert_eq!(quote("a\n", '"'), "\"a\\n\"");
        assert_eq!(unquote("\"a\\q\""), Err(2));
        assert_eq!(unquote("\"\\u{d800}\""), Err(1));
    }

    #[test]
    fn texts_over_lines_come_back() {
        for text in
            ["a\nb", "\n", "a\n", "\n\n  x\n", "a\r\nb\r\n", "say \"\"\"\nx", "  a\n \n b", "\t\n\"\""]
        {
            assert!(suits_raw(text), "{text:?}");
            for indent in [0, 4, 9] {
                assert_eq!(unraw(&raw(text, indent)).as_deref(), Ok(text), "{text:?}");
            }
        }
        for text in ["a", "a\r\nb\nc", "a\rb\n", "\u{7}\n"] {
            assert!(!suits_raw(text), "{text:?}");
        }
        assert_eq!(unraw("\"\"\"\n  a\n b\n  \"\"\""), Err(8));
        assert_eq!(unraw("\"\"\"python\na\n\"\"\""), Err(3));
    }
}
