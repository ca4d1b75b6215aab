//! Filters for names, as Rhino and Grasshopper write them.

use katydid_component::Message;
use regex::{Regex, RegexBuilder};

/// A filter in which `*` stands for any text and `?` for any character; case does not matter.
#[derive(Debug)]
pub(crate) struct Wildcard(Regex);

impl Wildcard {
    pub(crate) fn new(pattern: &str) -> Result<Self, Message> {
        Self::of(pattern, "")
    }

    /// The filter that also takes the layers inside those that `pattern` names.
    pub(crate) fn with_sublayers(pattern: &str) -> Result<Self, Message> {
        Self::of(pattern, "(::.*)?")
    }

    fn of(pattern: &str, tail: &str) -> Result<Self, Message> {
        let pattern = regex::escape(pattern.trim()).replace(r"\*", ".*").replace(r"\?", ".");
        let regex = RegexBuilder::new(&format!("^(?s:{pattern}){tail}$")).case_insensitive(true).build();
        regex.map(Self).map_err(|error| Message::error(format!("The filter cannot be used: {error}")))
    }

    pub(crate) fn takes(&self, name: &str) -> bool {
        self.0.is_match(name)
    }

    /// Whether it takes a layer, by its path from the outermost layer in or by its own name.
    pub(crate) fn takes_layer(&self, path: &str) -> bool {
        self.takes(path) || last_names(path).any(|name| self.takes(name))
    }
}

/// The ends of a path that begin at one of its names: `b::c` and `c` of `a::b::c`.
fn last_names(path: &str) -> impl Iterator<Item = &str> {
    path.match_indices("::").filter_map(|(at, mark)| path.get(at + mark.len()..))
}

#[cfg(test)]
mod tests {
    use super::Wildcard;

    #[test]
    fn stars_and_question_marks_stand_for_what_they_do_in_grasshopper() {
        let takes = |pattern: &str, name: &str| Wildcard::new(pattern).unwrap().takes(name);
        assert!(takes("*", "") && takes("wall*", "Wall 3") && takes("w?ll", "well"));
        assert!(!takes("wall", "wall 3") && !takes("a.c", "abc"));
    }

    #[test]
    fn layers_are_named_whole_or_by_their_last_names() {
        let own = Wildcard::new("Walls").unwrap();
        assert!(
            own.takes_layer("walls") && own.takes_layer("House::Walls") && !own.takes_layer("Walls::Inner")
        );
        let all = Wildcard::with_sublayers("Walls").unwrap();
        assert!(all.takes_layer("House::Walls::Inner::Left") && !all.takes_layer("House::Roof"));
    }
}
