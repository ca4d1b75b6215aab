//! Pieces of HTML.

/// A text as it stands in HTML, in attributes too.
pub(crate) fn escaped(text: &str) -> String {
    let mut out = String::with_capacity(text.len());
    for c in text.chars() {
        match c {
            '&' => out.push_str("&amp;"),
            '<' => out.push_str("&lt;"),
            '>' => out.push_str("&gt;"),
            '"' => out.push_str("&quot;"),
            '\'' => out.push_str("&#39;"),
            other => out.push(other),
        }
    }
    out
}

/// Attributes, each with a blank before it; those without a value are left out.
pub(crate) fn attributes(pairs: &[(&str, Option<String>)]) -> String {
    let told =
        pairs.iter().filter_map(|(name, value)| Some(format!(" {name}=\"{}\"", escaped(value.as_deref()?))));
    told.collect()
}

/// Data for the script: nothing in it ends the element that holds it.
pub(crate) fn data(value: &serde_json::Value) -> String {
    value.to_string().replace('<', "\\u003c")
}

/// A text as the id of a heading: small letters, digits and hyphens.
pub(crate) fn slug(text: &str) -> String {
    let mut out = String::new();
    for c in text.chars().flat_map(char::to_lowercase) {
        if c.is_alphanumeric() {
            out.push(c);
        } else if !out.ends_with('-') && !out.is_empty() {
            out.push('-');
        }
    }
    let out = out.trim_end_matches('-');
    if out.is_empty() { "part".to_owned() } else { out.to_owned() }
}
