//! Path Mapper: paths rewritten by formulas.
//!
//! A rule `{A;B}(i) -> {B;A+1}(i)` names the elements of the paths it applies to, and tells each element of the
//! new path, and perhaps the new index, as a formula of these names.

use std::collections::HashMap;

use katydid_component::{Context, Message, component};
use katydid_data::{Path, Tree};
use katydid_definition::archive::Chunk;
use katydid_expression::{Expression, Program, Variant};

/// What formulas know besides the names of their rule: the length of the branch, the number of branches, and
/// the number of this branch.
const CONSTANTS: [&str; 3] = ["item_count", "path_count", "path_index"];

/// One rule, read.
struct Lexer {
    source: Vec<Element>,
    /// The names of path elements, then that of the index, then the constants.
    path: Vec<Program>,
    index: Option<Program>,
    /// Whether the new path is another for each item.
    by_item: bool,
    /// Which path element each value of the formulas is.
    slots: Vec<Slot>,
}

/// An element of a source mask.
enum Element {
    Name,
    Literal(i32),
}

/// Where the value of a name comes from.
#[derive(Clone, Copy)]
enum Slot {
    Element(usize),
    Item,
    ItemCount,
    PathCount,
    PathIndex,
}

/// The parts of a mask: path elements and the item part.
fn split(mask: &str) -> Result<(Vec<&str>, Option<&str>), Message> {
    let shown = || mask.chars().take(80).collect::<String>();
    let bad = |what: &str| Message::error(format!("Path Mapper: '{}' {what}", shown()));
    let text = mask.trim();
    let body = text.strip_prefix('{').ok_or_else(|| bad("does not begin with '{'"))?;
    let mut depth = 0_usize;
    let mut quoted = false;
    let mut from = 0;
    let mut elements = Vec::new();
    let mut end = None;
    for (at, c) in body.char_indices() {
        match c {
            '"' => quoted = !quoted,
            _ if quoted => {}
            '(' | '{' | '[' => depth += 1,
            ')' | ']' => depth = depth.saturating_sub(1),
            '}' if depth > 0 => depth -= 1,
            '}' | ';' if depth == 0 => {
                elements.push(body.get(from..at).unwrap_or_default().trim());
                from = at + 1;
                if c == '}' {
                    end = Some(at + 1);
                    break;
                }
            }
            _ => {}
        }
    }
    let end = end.ok_or_else(|| bad("has no '}' at the end of its path"))?;
    if elements.iter().any(|element| element.is_empty()) {
        return Err(bad("has an empty path element"));
    }
    let rest = body.get(end..).unwrap_or_default().trim();
    if rest.is_empty() {
        return Ok((elements, None));
    }
    let item = rest.strip_prefix('(').and_then(|rest| rest.strip_suffix(')')).map(str::trim);
    let item = item.filter(|item| !item.is_empty());
    Ok((elements, Some(item.ok_or_else(|| bad("has more than an item part in brackets behind its path"))?)))
}

fn is_name(text: &str) -> bool {
    let mut characters = text.chars();
    characters.next().is_some_and(|c| c.is_alphabetic() || c == '_')
        && characters.all(|c| c.is_alphanumeric() || c == '_')
}

impl Lexer {
    fn parse(source: &str, target: &str) -> Result<Self, Message> {
        let (elements, item) = split(source)?;
        let mut names: Vec<String> = Vec::new();
        let mut slots = Vec::new();
        let mut bind = |name: &str, slot: Slot| {
            // What a rule names itself hides what comes later.
            let name = name.to_lowercase();
            if !names.contains(&name) {
                names.push(name);
                slots.push(slot);
            }
        };
        let mut masks = Vec::with_capacity(elements.len());
        for (k, element) in elements.into_iter().enumerate() {
            if is_name(element) {
                bind(element, Slot::Element(k));
                masks.push(Element::Name);
            } else {
                let literal = element.parse().map_err(|_| {
                    let element: String = element.chars().take(80).collect();
                    Message::error(format!("Path Mapper: '{element}' is neither a name nor an integer"))
                })?;
                masks.push(Element::Literal(literal));
            }
        }
        if let Some(item) = item.filter(|item| is_name(item)) {
            bind(item, Slot::Item);
        }
        for (name, slot) in CONSTANTS.iter().zip([Slot::ItemCount, Slot::PathCount, Slot::PathIndex]) {
            bind(name, slot);
        }
        let names: Vec<&str> = names.iter().map(String::as_str).collect();
        let by_item = |expression: &Expression| {
            let variables = expression.variables();
            (names.iter().zip(&slots))
                .any(|(name, slot)| matches!(slot, Slot::Item) && variables.contains(name))
        };
        let mut varies = false;
        let mut program = |text: &str| {
            let expression = Expression::parse(text).map_err(|error| formula_error(&error, text))?;
            varies |= by_item(&expression);
            expression.bind(&names).map_err(|error| formula_error(&error, text))
        };
        let (elements, index) = split(target)?;
        let path = elements.into_iter().map(&mut program).collect::<Result<_, _>>()?;
        let by_item = varies;
        let mut program = |text: &str| {
            let expression = Expression::parse(text).map_err(|error| formula_error(&error, text))?;
            expression.bind(&names).map_err(|error| formula_error(&error, text))
        };
        let index = index.map(&mut program).transpose()?;
        Ok(Self { source: masks, path, index, by_item, slots })
    }

    fn fits(&self, path: &Path) -> bool {
        path.len() == self.source.len()
            && self.source.iter().zip(path.elements()).all(|(element, x)| match element {
                Element::Name => true,
                Element::Literal(literal) => literal == x,
            })
    }

    fn new_path(&self, values: &[Variant]) -> Result<Path, Message> {
        self.path.iter().map(|program| integer(program, values)).collect()
    }
}

fn formula_error(error: &dyn std::fmt::Display, text: &str) -> Message {
    let text: String = text.chars().take(80).collect();
    Message::error(format!("Path Mapper: {error} in '{text}'"))
}

/// The value of a formula as an integer, rounded.
fn integer(program: &Program, values: &[Variant]) -> Result<i32, Message> {
    let value = program.evaluate(values).map_err(|error| Message::error(format!("Path Mapper: {error}")))?;
    let number = match value {
        Variant::Integer(i) => return Ok(i),
        Variant::Boolean(b) => return Ok(i32::from(b)),
        Variant::Number(x) => Some(x.round_ties_even()),
        _ => None,
    };
    let whole = number.filter(|x| (f64::from(i32::MIN)..=f64::from(i32::MAX)).contains(x));
    whole.map(|x| x as i32).ok_or_else(|| {
        Message::error(format!("Path Mapper: a formula gives {value}, which is no element of a path"))
    })
}

/// The rules that an object has stored.
fn lexers(settings: &Chunk) -> Result<Vec<Lexer>, Message> {
    let Some(stored) = settings.child("lexers") else { return Ok(Vec::new()) };
    let text = |name: &str, k: i32| stored.str_at(name, k).or_else(|| stored.str(name).filter(|_| k == 0));
    let count = stored.i32("lexer_count").unwrap_or(i32::MAX);
    (0..count)
        .map_while(|k| Some((text("source", k)?, text("target", k)?)))
        .map(|(source, target)| Lexer::parse(source, target))
        .collect()
}

/// The new branches: for each path the items in their new order.
#[derive(Default)]
struct Mapped {
    branches: Vec<(Path, Vec<usize>)>,
    places: HashMap<Path, usize>,
    total: usize,
}

impl Mapped {
    fn branch(&mut self, path: Path) -> &mut Vec<usize> {
        let branches = &mut self.branches;
        let place = *self.places.entry(path).or_insert_with_key(|path| {
            branches.push((path.clone(), Vec::new()));
            branches.len() - 1
        });
        // The place was just looked up or made.
        &mut branches[place].1
    }

    /// Puts an item at the end of a branch, or at an index of it: gaps become nulls, and a later item takes the
    /// place of an earlier one.
    fn put(
        &mut self,
        context: &Context<'_>,
        path: Path,
        index: Option<i32>,
        item: usize,
    ) -> Result<(), Message> {
        let total = self.total;
        let branch = self.branch(path);
        let before = branch.len();
        match index {
            None => branch.push(item),
            Some(index) => {
                let at = usize::try_from(index)
                    .map_err(|_| Message::error(format!("Path Mapper: the index {index} is negative")))?;
                if at >= before {
                    context.items(total.saturating_add(at - before + 1))?;
                    // An index outside all items gathers a null.
                    branch.resize(at + 1, usize::MAX);
                }
                if let Some(place) = branch.get_mut(at) {
                    *place = item;
                }
            }
        }
        self.total += branch.len() - before;
        Ok(())
    }
}

/// Rewrites the paths of a tree by rules such as `{A;B}(i) -> {B;A}(i)`.
///
/// A rule applies to paths with as many elements as it names; the first that fits counts, and branches that fit
/// none are left out with a warning. The new elements are formulas of these names and of `item_count`,
/// `path_count` and `path_index`. With an index behind the new path each item goes to that place, and gaps become
/// nulls; without it items are put behind each other.
#[component(
    "f9b89a46-bc5d-4f7a-9a6f-134f93ac3af9",
    name = "Path Mapper",
    nick = "Path Mapper",
    at = "Sets/Tree",
    floating
)]
#[output("Data", "D", "The tree with the new paths.")]
fn path_mapper(
    context: &Context<'_>,
    /// The tree.
    #[port("Data", "D", optional)]
    data: &Tree,
) -> Result<Tree, Message> {
    let lexers = lexers(context.settings())?;
    if lexers.is_empty() {
        return Ok(data.clone());
    }
    context.items(data.item_count())?;
    let number = |n: usize| Variant::Integer(crate::sets::integer(n));
    let mut mapped = Mapped::default();
    for (b, branch) in data.branches().enumerate() {
        let Some(lexer) = lexers.iter().find(|lexer| lexer.fits(branch.path())) else {
            context.warn("Some paths fit no rule: their branches are left out");
            continue;
        };
        let elements = branch.path().elements();
        let value = |slot: &Slot| match *slot {
            Slot::Element(k) => elements.get(k).map_or(Variant::Null, |&x| Variant::Integer(x)),
            Slot::Item => Variant::Integer(0),
            Slot::ItemCount => number(branch.len()),
            Slot::PathCount => number(data.branch_count()),
            Slot::PathIndex => number(b),
        };
        let mut values: Vec<Variant> = lexer.slots.iter().map(value).collect();
        let item = lexer.slots.iter().position(|slot| matches!(slot, Slot::Item));
        if !lexer.by_item && (lexer.index.is_none() || branch.is_empty()) {
            let path = lexer.new_path(&values)?;
            mapped.branch(path).extend(branch.range());
            mapped.total += branch.len();
            continue;
        }
        let common = if lexer.by_item { None } else { Some(lexer.new_path(&values)?) };
        for (i, at) in branch.range().enumerate() {
            if i % 1024 == 0 {
                context.check()?;
            }
            if let Some(place) = item.and_then(|item| values.get_mut(item)) {
                *place = Variant::Integer(i32::try_from(i).unwrap_or(i32::MAX));
            }
            let path = match &common {
                Some(path) => path.clone(),
                None => lexer.new_path(&values)?,
            };
            let index = lexer.index.as_ref().map(|program| integer(program, &values)).transpose()?;
            mapped.put(context, path, index, at)?;
        }
    }
    let mut paths = Vec::with_capacity(mapped.branches.len());
    let mut ends = Vec::with_capacity(mapped.branches.len());
    let mut indices = Vec::with_capacity(mapped.total);
    for (path, branch) in mapped.branches {
        indices.extend(branch);
        paths.push(path);
        ends.push(indices.len());
    }
    Ok(Tree::from_parts(paths, ends, data.column().gather(&indices)))
}

#[cfg(test)]
mod tests {
    use katydid_component::testing::Trial;

    use super::*;

    fn settings(rules: &[(&str, &str)]) -> Chunk {
        let mut lexers = Chunk::new("lexers");
        lexers.set("lexer_count", i32::try_from(rules.len()).unwrap());
        for (k, (source, target)) in (0..).zip(rules) {
            lexers.set_at("source", k, *source);
            lexers.set_at("target", k, *target);
        }
        let mut settings = Chunk::default();
        settings.set_child(lexers);
        settings
    }

    fn mapper(rules: &[(&str, &str)]) -> Trial {
        let trial = Trial::of("Path Mapper").settings(settings(rules));
        trial.branches([("{0;0}", [1, 2]), ("{0;1}", [3, 4]), ("{1;0}", [5, 6])])
    }

    #[test]
    fn the_rules_of_the_menu() {
        let map = |source: &str, target: &str| mapper(&[(source, target)]).texts(0);
        assert_eq!(map("{A;B}", "{A;B}"), ["{0;0}: 1, 2", "{0;1}: 3, 4", "{1;0}: 5, 6"]);
        assert_eq!(map("{A;B}", "{0}"), ["{0}: 1, 2, 3, 4, 5, 6"]);
        assert_eq!(map("{A;B}(i)", "{A;B;i}")[..3], ["{0;0;0}: 1", "{0;0;1}: 2", "{0;1;0}: 3"]);
        assert_eq!(map("{A;B}", "{A}"), ["{0}: 1, 2, 3, 4", "{1}: 5, 6"]);
        assert_eq!(map("{A;B}", "{B;A}"), ["{0;0}: 1, 2", "{0;1}: 5, 6", "{1;0}: 3, 4"]);
        assert_eq!(map("{A;B}", "{path_index}"), ["{0}: 1, 2", "{1}: 3, 4", "{2}: 5, 6"]);
    }

    #[test]
    fn items_and_paths_change_places() {
        let flipped = mapper(&[("{A;B}(i)", "{A;i}(B)")]);
        assert_eq!(flipped.texts(0), ["{0;0}: 1, 3", "{0;1}: 2, 4", "{1;0}: 5", "{1;1}: 6"]);
        assert_eq!(mapper(&[("{A;B}(i)", "{A}(i)")]).texts(0), ["{0}: 3, 4", "{1}: 5, 6"]);
        assert_eq!(mapper(&[("{A;B}(i)", "{A;B}(2*i+1)")]).texts(0)[0], "{0;0}: null, 1, null, 2");
        let reversed = mapper(&[("{A;B}(i)", "{A;B}(item_count-1-i)")]);
        assert_eq!(reversed.texts(0)[0], "{0;0}: 2, 1");
    }

    #[test]
    fn formulas_and_several_rules() {
        let formula = mapper(&[("{a; b}", "{a;if(b=0,-1,pow(b+1,3))}")]);
        assert_eq!(formula.texts(0), ["{0;-1}: 1, 2", "{0;8}: 3, 4", "{1;-1}: 5, 6"]);
        let two = mapper(&[("{A}", "{A;9}"), ("{0;B}", "{B}"), ("{A;B}", "{7}")]);
        assert_eq!(two.texts(0), ["{0}: 1, 2", "{1}: 3, 4", "{7}: 5, 6"]);
        let own = Trial::of("Path Mapper").settings(settings(&[("{path_count}", "{path_count+1}")]));
        assert_eq!(own.branches([("{0}", [1]), ("{4}", [2])]).texts(0), ["{1}: 1", "{5}: 2"]);
        assert_eq!(
            mapper(&[("{A}", "{A}")]).message(),
            "Some paths fit no rule: their branches are left out (3 times)"
        );
        assert_eq!(mapper(&[]).texts(0).len(), 3);
    }

    #[test]
    fn what_is_wrong_is_said() {
        for (source, target) in [
            ("A;B", "{A}"),
            ("{A;B", "{A}"),
            ("{A;;B}", "{A}"),
            ("{A;B}", "{C}"),
            ("{A;B}", "{A}(i)"),
            ("{A;B}", "{A/0}"),
            ("{A;B}", "{\"x\"}"),
            ("{A;B}(i)", "{A}(i-1)"),
            ("{A;B}(i)", "{A}()"),
            ("{A;B}(i) x", "{A}"),
            ("{A+1;B}", "{A}"),
        ] {
            let message = mapper(&[(source, target)]).message();
            assert!(message.starts_with("Path Mapper: "), "{source} {target}: {message}");
        }
        assert!(mapper(&[("{A;B}(i)", "{A}(2000000000)")]).message().contains("items"));
    }

    #[test]
    fn an_empty_branch_goes_along() {
        let trial = Trial::of("Path Mapper").settings(settings(&[("{A}(i)", "{A+1}(i)")]));
        assert_eq!(trial.list::<f64>([]).texts(0), ["{1}:"]);
    }
}
