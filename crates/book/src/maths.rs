//! Formulas as MathML.

use pulldown_latex::config::DisplayMode;
use pulldown_latex::{Parser, RenderConfig, Storage, push_mathml};

/// What a formula is tied to. Symbols travel through the converter as text of a colour that stands for their place in this list.
#[derive(Debug, Clone, PartialEq, Eq)]
pub(crate) enum Tie {
    /// `\link{object}{symbol}`.
    Link(String),
    /// `\live{value}`.
    Live(String),
}

/// A formula has no more ties.
const MOST_TIES: usize = 4_000;
/// The third part of the colours that stand for ties.
const MARK: usize = 251;

/// A formula as MathML; `attributes` gives the attributes of a tie's elements, with a blank before them, and the text of a
/// live value.
pub(crate) fn mathml(
    latex: &str,
    is_display: bool,
    mut attributes: impl FnMut(&Tie) -> Result<(String, Option<String>), String>,
) -> Result<String, String> {
    let (plain, ties) = without_ties(latex)?;
    let storage = Storage::new();
    let config = RenderConfig {
        display_mode: if is_display { DisplayMode::Block } else { DisplayMode::Inline },
        ..RenderConfig::default()
    };
    // The converter writes faults into the formula: they are found by reading it first.
    for event in Parser::new(&plain, &storage) {
        if let Err(error) = event {
            let text = error.to_string();
            return Err(text
                .lines()
                .map(str::trim)
                .filter(|line| !line.is_empty())
                .collect::<Vec<_>>()
                .join(" "));
        }
    }
    let mut out = String::new();
    push_mathml(&mut out, Parser::new(&plain, &storage), config).map_err(|error| error.to_string())?;
    for (place, tie) in ties.iter().enumerate() {
        let (own, text) = attributes(tie)?;
        let style = format!(" style=\"color: rgb({} {} {MARK})\"", place >> 8, place & 255);
        if let Some(text) = text {
            let made = format!("<mtext{own}>{}</mtext>", crate::html::escaped(&text));
            for marked in [
                format!("<mrow{style}><mrow><mtext>live</mtext></mrow></mrow>"),
                format!("<mrow{style}><mtext>live</mtext></mrow>"),
                format!("<mtext{style}>live</mtext>"),
            ] {
                out = out.replace(&marked, &made);
            }
        }
        out = out.replace(&style, &own);
    }
    // The converter escapes its own blanks once too often.
    Ok(out.replace("&amp;nbsp;", "&#160;"))
}

/// The formula with colours in the place of ties.
fn without_ties(latex: &str) -> Result<(String, Vec<Tie>), String> {
    let (mut out, mut ties, mut rest) = (String::new(), Vec::new(), latex);
    loop {
        let found =
            ["\\link{", "\\live{"].into_iter().filter_map(|name| Some((rest.find(name)?, name))).min();
        let Some((place, name)) = found else {
            out.push_str(rest);
            return Ok((out, ties));
        };
        out.push_str(&rest[..place]);
        let (first, after) = argument(&rest[place + name.len() - 1..]).ok_or("a brace is not closed")?;
        if ties.len() >= MOST_TIES {
            return Err("a formula has no more symbols".to_owned());
        }
        let colour = format!("#{:02x}{:02x}{MARK:02x}", ties.len() >> 8, ties.len() & 255);
        if name == "\\link{" {
            let (symbol, after) = argument(after.trim_start()).ok_or("\\link has two arguments in braces")?;
            ties.push(Tie::Link(first.trim().to_owned()));
            // Ties within ties are found in their turn.
            let (inner, more) = without_ties(symbol)?;
            if !more.is_empty() {
                return Err("\\link and \\live do not stand in one another".to_owned());
            }
            out.push_str(&format!("\\textcolor{{{colour}}}{{{inner}}}"));
            rest = after;
        } else {
            ties.push(Tie::Live(first.trim().to_owned()));
            out.push_str(&format!("\\textcolor{{{colour}}}{{\\text{{live}}}}"));
            rest = after;
        }
    }
}

/// The text between a brace at the start and the one that closes it, and what comes after.
fn argument(text: &str) -> Option<(&str, &str)> {
    let mut depth = 0_usize;
    let mut is_escaped = false;
    for (place, c) in text.char_indices() {
        match c {
            _ if is_escaped => is_escaped = false,
            '\\' => is_escaped = true,
            '{' => depth += 1,
            '}' => {
                depth = depth.checked_sub(1)?;
                if depth == 0 {
                    return Some((&text[1..place], &text[place + 1..]));
                }
            }
            _ if place == 0 => return None,
            _ => {}
        }
    }
    None
}

#[cfg(test)]
mod tests {
    use super::*;

    fn told(latex: &str) -> Result<String, String> {
        mathml(latex, true, |tie| match tie {
            Tie::Link(name) => Ok((format!(" data-link=\"{name}\""), None)),
            Tie::Live(name) => Ok((format!(" data-live=\"{name}\""), Some("7".to_owned()))),
        })
    }

    #[test]
    fn symbols_are_tied_to_objects() {
        let out = told(r"\link{arrow a}{\vec a} =\ \live{sum | 2}").unwrap();
        assert!(
            out.contains("data-link=\"arrow a\"") && out.contains("<mtext data-live=\"sum | 2\">7</mtext>"),
            "{out}"
        );
        assert!(out.starts_with("<math") && !out.contains("rgb(") && !out.contains("&amp;"), "{out}");
    }

    #[test]
    fn faults_are_told() {
        for bad in [r"\frac{1}", r"\nosuchcommand", r"\link{a}", r"\link{a}{\live{b}}", r"{", r"\live{"] {
            assert!(told(bad).is_err(), "{bad}");
        }
    }
}
