/// A stretch of the expression's text: byte offsets, the end not included.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default)]
pub struct Span {
    /// Offset of the first byte.
    pub start: usize,
    /// Offset after the last byte.
    pub end: usize,
}

/// Characters of context kept on each side of the place when a line is long.
const CONTEXT: usize = 60;

impl Span {
    /// The stretch from `start` up to `end`.
    pub const fn new(start: usize, end: usize) -> Self {
        Self { start, end }
    }

    /// The stretch from the start of this one to the end of `other`.
    #[must_use]
    pub fn to(self, other: Self) -> Self {
        Self { start: self.start, end: other.end.max(self.end) }
    }

    /// The text under this stretch; empty when the offsets do not fit the text.
    pub fn text<'a>(&self, source: &'a str) -> &'a str {
        source.get(self.start..self.end).unwrap_or("")
    }

    /// Three lines: the message, the line of the text that holds the place, and carets under the place.
    /// Long lines are cut to the neighbourhood of the place.
    pub fn render(&self, source: &str, message: &str) -> String {
        let start = floor_boundary(source, self.start);
        let end = floor_boundary(source, self.end).max(start);
        let (before, after) = source.split_at(start);
        let line_start = before.rfind(['\n', '\r']).map_or(0, |i| i + 1);
        let line_end = after.find(['\n', '\r']).map_or(source.len(), |i| start + i);
        let head = source.get(line_start..start).unwrap_or("");
        let body = source.get(start..end.min(line_end)).unwrap_or("");
        let tail = source.get(end.min(line_end).max(start)..line_end).unwrap_or("");

        let head_count = head.chars().count();
        let cut_head = head_count > CONTEXT;
        let shown_head: String = head.chars().skip(if cut_head { head_count - CONTEXT } else { 0 }).collect();
        let shown_body: String = body.chars().take(CONTEXT).collect();
        let shown_tail: String = tail.chars().take(CONTEXT).collect();
        let cut_tail = tail.chars().nth(CONTEXT).is_some() || body.chars().nth(CONTEXT).is_some();

        let mut out = String::with_capacity(message.len() + 4 * CONTEXT);
        out.push_str(message);
        out.push_str("\n  ");
        let mut under = String::from("  ");
        if cut_head {
            out.push('…');
            under.push(' ');
        }
        out.push_str(&shown_head);
        // A tab stays a tab, so that the caret stands under its place whatever a tab's width.
        under.extend(shown_head.chars().map(|c| if c == '\t' { '\t' } else { ' ' }));
        out.push_str(&shown_body);
        under.extend(std::iter::repeat_n('^', shown_body.chars().count().max(1)));
        out.push_str(&shown_tail);
        if cut_tail {
            out.push('…');
        }
        out.push('\n');
        out.push_str(&under);
        out
    }
}

/// The nearest character boundary at or before `at`.
fn floor_boundary(source: &str, at: usize) -> usize {
    let mut at = at.min(source.len());
    while !source.is_char_boundary(at) {
        at -= 1;
    }
    at
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_caret_stands_under_the_place_in_characters_not_bytes() {
        let source = "π + ?";
        let at = source.find('?').unwrap();
        assert_eq!(Span::new(at, at + 1).render(source, "bad"), "bad\n  π + ?\n      ^");
    }

    #[test]
    fn only_the_line_of_the_place_is_shown() {
        assert_eq!(Span::new(4, 5).render("a +\n? +\nc", "bad"), "bad\n  ? +\n  ^");
    }

    #[test]
    fn long_lines_are_cut_and_wild_offsets_do_not_panic() {
        let source = format!("{}?{}", "a".repeat(500), "b".repeat(500));
        let drawn = Span::new(500, 501).render(&source, "m");
        assert!(drawn.lines().all(|l| l.chars().count() < 140));
        let text = "é";
        for start in 0..9 {
            for end in 0..9 {
                let _ = Span::new(start, end).render(text, "m");
            }
        }
    }
}
