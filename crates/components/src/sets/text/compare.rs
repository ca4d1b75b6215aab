//! Sets / Text: matching, sorting and likeness.

use std::cell::RefCell;
use std::rc::Rc;
use std::sync::Arc;

use katydid_component::{Context, List, Message, component};
use katydid_data::{Column, Value};
use regex::{Regex, RegexBuilder};

use super::pattern::Pattern;
use crate::maths::comparison::dictionary;

/// The last patterns read, so that one that serves for a whole list is read once.
#[derive(Default)]
struct Last {
    pattern: Option<(Arc<str>, bool, Rc<Pattern>)>,
    expression: Option<(Arc<str>, bool, Regex)>,
}

impl Last {
    fn pattern(&mut self, text: &Arc<str>, case: bool) -> Rc<Pattern> {
        match &self.pattern {
            Some((known, c, pattern)) if known == text && *c == case => Rc::clone(pattern),
            _ => {
                let pattern = Rc::new(Pattern::new(text, case));
                self.pattern = Some((Arc::clone(text), case, Rc::clone(&pattern)));
                pattern
            }
        }
    }

    fn expression(&mut self, text: &Arc<str>, case: bool) -> Result<Regex, Message> {
        match &self.expression {
            Some((known, c, regex)) if known == text && *c == case => Ok(regex.clone()),
            _ => {
                let regex = RegexBuilder::new(text).case_insensitive(!case).build();
                let regex =
                    regex.map_err(|error| Message::error(format!("The regular expression: {error}")))?;
                self.expression = Some((Arc::clone(text), case, regex.clone()));
                Ok(regex)
            }
        }
    }
}

/// Whether a text fits a pattern, a regular expression, or both.
///
/// In a pattern, which has to fit the whole text, `*` stands for anything, `?` for one character, `#` for a digit
/// and `[a-z]` for one of some characters. A regular expression may fit anywhere in the text; it cannot look
/// ahead or back.
#[component("3756c55f-95c3-442c-a027-6b3ab0455a94", name = "Match Text", nick = "TMatch", at = "Sets/Text")]
#[output("Match", "M", "Whether the text fits.")]
fn match_text(
    context: &Context<'_>,
    /// The text.
    #[port("Text", "T")]
    text: Arc<str>,
    /// The pattern.
    #[port("Pattern", "P")]
    pattern: Option<Arc<str>>,
    /// The regular expression.
    #[port("RegEx", "R")]
    expression: Option<Arc<str>>,
    /// Whether capital and small letters differ.
    #[port("Case", "C", default = true)]
    case: bool,
) -> Result<bool, Message> {
    let last: &RefCell<Last> = context.prepared(|| Ok(RefCell::default()))?;
    let mut last = last.borrow_mut();
    if let Some(pattern) = pattern
        && !last.pattern(&pattern, case).fits(&text, || context.check())?
    {
        return Ok(false);
    }
    match expression {
        Some(expression) => Ok(last.expression(&expression, case)?.is_match(&text)),
        None => Ok(true),
    }
}

/// Sorts texts as a dictionary does: capital letters count only between texts that are otherwise the same.
///
/// Values are sorted along with their texts. Nulls among the texts come last.
#[component(
    "cec16c67-7b8b-41f7-a5a5-f675177e524b",
    name = "Sort Text",
    nick = "TSort",
    at = "Sets/Text",
    also("1ff80a00-1b1d-4fb3-926a-0c246261fc55")
)]
#[output("Keys", "K", "The texts in order.")]
#[output("Values", "V", "The values in the order of their texts.")]
fn sort_text(
    context: &Context<'_>,
    /// The texts.
    #[port("Keys", "K")]
    keys: List<Arc<str>>,
    /// Values to sort along, one a text.
    #[port("Values", "V", optional)]
    values: List<Value>,
    /// The language of the texts; only 127, no language, is known.
    #[port("Culture", "C", default = 127)]
    _culture: i32,
) -> Result<(Vec<Option<Arc<str>>>, Column), Message> {
    let texts = keys.to_vec();
    // The key of a text, and its places in three lists.
    let taken = |text: &Arc<str>| text.len().saturating_mul(2).saturating_add(128);
    context.bytes(texts.iter().flatten().map(taken).fold(0, usize::saturating_add))?;
    let mut order: Vec<usize> = (0..texts.len()).collect();
    order.sort_by_cached_key(|&i| {
        let text = texts.get(i).and_then(Option::as_deref);
        (text.is_none(), text.map(dictionary))
    });
    let values = if values.is_empty() { Column::nulls(0) } else { values.gather(&order) };
    Ok((order.iter().map(|&i| texts.get(i).cloned().flatten()).collect(), values))
}

/// How many single characters have to be put in, taken out or exchanged to turn one text into another.
#[component("f7608c4d-836c-4adf-9d1f-3b04e6a2647d", name = "Text Distance", nick = "TDist", at = "Sets/Text")]
#[output("Distance", "D", "The number of changes.")]
fn text_distance(
    context: &Context<'_>,
    /// A text.
    #[port("Text A", "A")]
    a: Arc<str>,
    /// Another text.
    #[port("Text B", "B")]
    b: Arc<str>,
    /// Whether capital and small letters differ.
    #[port("Case", "C", default = true)]
    case: bool,
) -> Result<i32, Message> {
    let characters = |text: &str| -> Vec<char> {
        if case { text.chars().collect() } else { text.chars().flat_map(char::to_lowercase).collect() }
    };
    let (a, b) = (characters(&a), characters(&b));
    // Wagner and Fischer, "The string-to-string correction problem" (1974), one row of the table at a time.
    let mut row: Vec<usize> = (0..=b.len()).collect();
    for (i, x) in a.iter().enumerate() {
        context.check()?;
        let mut diagonal = i;
        let mut left = i + 1;
        if let Some(first) = row.first_mut() {
            *first = left;
        }
        for (cell, y) in row.iter_mut().skip(1).zip(&b) {
            let above = *cell;
            left = (diagonal + usize::from(x != y)).min(above + 1).min(left + 1);
            diagonal = above;
            *cell = left;
        }
    }
    Ok(row.last().map_or(0, |n| i32::try_from(*n).unwrap_or(i32::MAX)))
}

#[cfg(test)]
mod tests {
    use katydid_component::testing::Trial;
    use katydid_data::Tree;

    #[test]
    fn patterns_and_expressions() {
        let texts = ["Box", "box 12", "a Box"];
        let fits = |pattern: &str, expression: &str, case: bool| {
            let side = |trial: Trial, text: &str| match text {
                "" => trial.tree(Tree::empty()),
                text => trial.item(text),
            };
            let trial = side(side(Trial::of("Match Text").list(texts), pattern), expression).item(case);
            trial.texts(0).concat().replace("False", "0").replace("True", "1")
        };
        assert_eq!(fits("Box", "", true), "{0}: 1, 0, 0");
        assert_eq!(fits("box*", "", false), "{0}: 1, 1, 0");
        assert_eq!(fits("", "[0-9]+$", true), "{0}: 0, 1, 0");
        assert_eq!(fits("*b*", "B", true), "{0}: 0, 0, 0");
        assert_eq!(fits("*x", "BO", false), "{0}: 1, 0, 1");
        assert_eq!(fits("", "", true), "{0}: 1, 1, 1");
        assert_eq!(fits("", "(", true), "{0}: null, null, null");
    }

    #[test]
    fn sorting_as_in_a_dictionary() {
        let sorted = || Trial::of("Sort Text").list(["beta", "Alpha", "alpha", "Gamma"]).list([1, 2, 3, 4]);
        assert_eq!(sorted().texts(0), ["{0;0}: alpha, Alpha, beta, Gamma"]);
        assert_eq!(sorted().texts(1), ["{0;0}: 3, 2, 1, 4"]);
        let gaps = Trial::of("Sort Text").gaps([Some("b"), None, Some("a")]).list([1, 2]);
        assert_eq!(gaps.texts(1), ["{0;0}: null, 1, 2"]);
    }

    #[test]
    fn distances() {
        let distance = |a: &str, b: &str, case: bool| {
            Trial::of("Text Distance").item(a).item(b).item(case).texts(0).concat().replace("{0}: ", "")
        };
        assert_eq!(distance("kitten", "sitting", true), "3");
        assert_eq!([distance("", "abc", true), distance("abc", "", true)], ["3", "3"]);
        assert_eq!([distance("AB", "ab", true), distance("AB", "ab", false)], ["2", "0"]);
    }
}
