//! Strings: the characters of ISO 646, and control directives for all others (ISO 10303-21, 6.4.3).

/// A string as it stands between quotes.
pub(super) fn encoded(s: &str) -> String {
    let mut out = String::with_capacity(s.len());
    let mut wide: Option<u8> = None;
    for c in s.chars() {
        let width = match c {
            ' '..='~' => None,
            _ if (c as u32) <= 0xFFFF => Some(2),
            _ => Some(4),
        };
        if width != wide {
            if wide.is_some() {
                out.push_str("\\X0\\");
            }
            out.push_str(match width {
                Some(2) => "\\X2\\",
                Some(_) => "\\X4\\",
                None => "",
            });
            wide = width;
        }
        match width {
            Some(2) => out.push_str(&format!("{:04X}", c as u32)),
            Some(_) => out.push_str(&format!("{:08X}", c as u32)),
            None if c == '\'' => out.push_str("''"),
            None if c == '\\' => out.push_str("\\\\"),
            None => out.push(c),
        }
    }
    if wide.is_some() {
        out.push_str("\\X0\\");
    }
    out
}

/// The string that stands between quotes, those of its own already single. What is no directive is kept as it is;
/// bytes beyond ISO 646, which the standard forbids and programs write, are UTF-8 where they can be.
pub(super) fn decoded(bytes: &[u8]) -> String {
    let mut out: Vec<u8> = Vec::with_capacity(bytes.len());
    let mut rest = bytes;
    // The part of ISO 8859 that \S\ chooses from; letters A to I after \P.
    let push = |out: &mut Vec<u8>, c: char| out.extend_from_slice(c.encode_utf8(&mut [0; 4]).as_bytes());
    while let Some((&first, after)) = rest.split_first() {
        if first != b'\\' {
            out.push(first);
            rest = after;
        } else if let Some(after) = rest.strip_prefix(b"\\\\") {
            out.push(b'\\');
            rest = after;
        } else if let Some((digits, after)) = rest.strip_prefix(b"\\X2\\").and_then(wide) {
            let units: Vec<u16> = digits.chunks(4).filter_map(|d| hex(d).map(|n| n as u16)).collect();
            char::decode_utf16(units).for_each(|c| push(&mut out, c.unwrap_or(char::REPLACEMENT_CHARACTER)));
            rest = after;
        } else if let Some((digits, after)) = rest.strip_prefix(b"\\X4\\").and_then(wide) {
            let all = digits.chunks(8).filter_map(hex);
            all.for_each(|n| push(&mut out, char::from_u32(n).unwrap_or(char::REPLACEMENT_CHARACTER)));
            rest = after;
        } else if let Some((n, after)) = rest.strip_prefix(b"\\X\\").and_then(|r| {
            let (digits, after) = r.split_at_checked(2)?;
            Some((hex(digits)?, after))
        }) {
            push(&mut out, char::from_u32(n).unwrap_or(char::REPLACEMENT_CHARACTER));
            rest = after;
        } else if let Some((&c, after)) = rest.strip_prefix(b"\\S\\").and_then(<[u8]>::split_first) {
            push(&mut out, char::from(c | 0x80));
            rest = after;
        } else if let Some(after) = rest.strip_prefix(b"\\P").and_then(|r| r.get(1..)?.strip_prefix(b"\\")) {
            rest = after;
        } else {
            out.push(first);
            rest = after;
        }
    }
    match String::from_utf8(out) {
        Ok(text) => text,
        Err(error) => error.into_bytes().iter().map(|b| char::from(*b)).collect(),
    }
}

/// The digits up to the end of a wide directive, and what follows it.
fn wide(bytes: &[u8]) -> Option<(&[u8], &[u8])> {
    let end = bytes.windows(4).position(|w| w == b"\\X0\\")?;
    Some((bytes.get(..end)?, bytes.get(end + 4..)?))
}

fn hex(digits: &[u8]) -> Option<u32> {
    u32::from_str_radix(std::str::from_utf8(digits).ok()?, 16).ok()
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn any_text_comes_back() {
        for text in ["", "plain", "it's", "back\\slash", "bäll 球 𝄞 end", "tab\tnew\nline", "\\X2\\"] {
            let encoded = encoded(text);
            assert!(encoded.is_ascii() && !encoded.contains('\n'));
            assert_eq!(decoded(encoded.replace("''", "'").as_bytes()), text);
        }
    }

    #[test]
    fn directives_of_other_programs_are_read() {
        assert_eq!(decoded(b"\\X\\E4"), "ä");
        assert_eq!(decoded(b"\\S\\d"), "ä");
        assert_eq!(decoded(b"\\PA\\x"), "x");
        assert_eq!(decoded("ä".as_bytes()), "ä");
        assert_eq!(decoded(b"\xE4"), "ä");
        assert_eq!(decoded(b"\\X2\\00"), "\\X2\\00");
    }
}
