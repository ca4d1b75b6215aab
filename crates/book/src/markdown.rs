//! Markdown, and the marks in it.

use pulldown_cmark::{CodeBlockKind, Event, Options, Parser, Tag, TagEnd};

/// The blocks that are more than code.
const BLOCKS: [&str; 4] = ["figure", "steps", "predict", "exercise"];
/// A mark goes through the reader of Markdown as its number between these.
const OPEN: char = '\u{e000}';
const CLOSE: char = '\u{e001}';

/// A block of a page.
#[derive(Debug, Clone, PartialEq, Eq)]
pub(crate) struct Part {
    /// `figure`, `steps`, `predict`, `exercise`.
    pub(crate) kind: String,
    /// The line of its fence in the file.
    pub(crate) line: usize,
    pub(crate) text: String,
}

pub(crate) fn options() -> Options {
    Options::ENABLE_TABLES | Options::ENABLE_MATH | Options::ENABLE_STRIKETHROUGH
}

/// The line of a place in a text that has so many lines before it.
pub(crate) fn line_at(text: &str, place: usize, before: usize) -> usize {
    let count = text.as_bytes().iter().take(place).filter(|byte| **byte == b'\n').count();
    before + count + 1
}

/// The name of a block that a fence begins; `None` for code.
pub(crate) fn block_kind<'a>(kind: &'a CodeBlockKind<'_>) -> Option<&'a str> {
    let CodeBlockKind::Fenced(info) = kind else { return None };
    let word = info.split_whitespace().next()?;
    BLOCKS.contains(&word).then_some(word)
}

/// The blocks of a text.
pub(crate) fn parts(text: &str, before: usize) -> Vec<Part> {
    let mut parts: Vec<Part> = Vec::new();
    let mut is_inside = false;
    for (event, range) in Parser::new_ext(text, options()).into_offset_iter() {
        match event {
            Event::Start(Tag::CodeBlock(kind)) => {
                if let Some(name) = block_kind(&kind) {
                    let line = line_at(text, range.start, before);
                    parts.push(Part { kind: name.to_owned(), line, text: String::new() });
                    is_inside = true;
                }
            }
            Event::End(TagEnd::CodeBlock) => is_inside = false,
            Event::Text(piece) if is_inside => {
                if let Some(part) = parts.last_mut() {
                    part.text.push_str(&piece);
                }
            }
            _ => {}
        }
    }
    parts
}

/// A text with its marks taken out.
#[derive(Debug, Default)]
pub(crate) struct Marked {
    pub(crate) text: String,
    /// What stood between the braces, with its line.
    pub(crate) marks: Vec<(String, usize)>,
}

impl Marked {
    /// Takes `{{ … }}` out of a text. The blanks inside the braces belong to the mark: formulas have double braces too.
    pub(crate) fn new(text: &str, before: usize) -> Self {
        let mut marked = Self::default();
        let mut rest = text;
        let mut line = before + 1;
        while let Some(place) = rest.find("{{ ") {
            let (head, tail) = rest.split_at(place);
            let end = tail[3..].find(" }}").map(|end| end + 3);
            let Some(end) = end.filter(|end| !tail[..*end].contains('\n')) else {
                let (kept, more) = rest.split_at(place + 3);
                line += kept.matches('\n').count();
                marked.text.push_str(kept);
                rest = more;
                continue;
            };
            line += head.matches('\n').count();
            marked.text.push_str(head);
            marked.text.push_str(&format!("{OPEN}{}{CLOSE}", marked.marks.len()));
            marked.marks.push((tail[3..end].to_owned(), line));
            rest = &tail[end + 3..];
        }
        marked.text.push_str(rest);
        marked
    }

    /// Calls `text` with each stretch of text and `mark` with each mark in it.
    pub(crate) fn each<S>(
        &self,
        piece: &str,
        state: &mut S,
        mut text: impl FnMut(&mut S, &str),
        mut mark: impl FnMut(&mut S, &str, usize),
    ) {
        let mut rest = piece;
        while let Some(place) = rest.find(OPEN) {
            let (head, tail) = rest.split_at(place);
            text(state, head);
            let Some((number, after)) = tail[OPEN.len_utf8()..].split_once(CLOSE) else { break };
            if let Some((what, line)) = number.parse().ok().and_then(|place: usize| self.marks.get(place)) {
                mark(state, what, *line);
            }
            rest = after;
        }
        text(state, rest);
    }

    /// The text as it was written.
    pub(crate) fn restored(&self, piece: &str) -> String {
        let mut out = String::new();
        self.each(
            piece,
            &mut out,
            |out, text| out.push_str(text),
            |out, mark, _| out.push_str(&format!("{{{{ {mark} }}}}")),
        );
        out
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn marks_are_found_with_their_lines() {
        let text = "a {{ sum }} b\n$x^{{2}}$ {{ drag t }}\n{{ open\n";
        let marked = Marked::new(text, 10);
        assert_eq!(marked.marks, [("sum".to_owned(), 11), ("drag t".to_owned(), 12)]);
        assert_eq!(marked.restored(&marked.text), text);
    }

    #[test]
    fn blocks_are_found_with_their_lines() {
        let parts = parts("one\n\n```figure\nid: a\n```\n\n```rust\nfn\n```\n", 5);
        assert_eq!(parts, [Part { kind: "figure".to_owned(), line: 8, text: "id: a\n".to_owned() }]);
    }
}
