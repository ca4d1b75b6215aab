//! The ports of an object that is being built.

use uuid::Uuid;

use super::ast::{Argument, Given, Modifier, Name, Output};
use super::catalogue::{Expect, Facts, PortFacts};
use super::problem::{Fault, nearest};
use crate::document::{Access, Persistent, Side};

/// A port with what it is given.
#[derive(Debug, Default)]
pub(super) struct Slot<'a> {
    pub(super) id: Uuid,
    pub(super) name: String,
    pub(super) nickname: String,
    pub(super) description: String,
    pub(super) access: Access,
    pub(super) optional: bool,
    pub(super) expect: Expect,
    pub(super) type_id: Option<Uuid>,
    pub(super) default: Option<Persistent>,
    pub(super) given: Option<&'a Given>,
    pub(super) modifiers: &'a [Modifier],
}

impl Slot<'_> {
    fn of(facts: &PortFacts) -> Self {
        Self {
            name: facts.name.clone(),
            nickname: facts.nickname.clone(),
            description: facts.description.clone(),
            access: facts.access,
            optional: facts.optional,
            expect: facts.expect,
            type_id: facts.type_id,
            default: facts.default.clone(),
            ..Self::default()
        }
    }

    fn named(label: &str) -> Self {
        Self { name: label.to_owned(), nickname: label.to_owned(), ..Self::default() }
    }
}

/// The fixed ports of a side, and the one that stands for many.
pub(super) fn split(ports: &[PortFacts]) -> (&[PortFacts], Option<&PortFacts>) {
    match ports.split_last() {
        Some((last, fixed)) if last.many => (fixed, Some(last)),
        _ => (ports, None),
    }
}

/// The `k`-th of the ports that one stands for.
pub(super) fn one_of_many<'a>(many: &PortFacts, k: usize, label: Option<&str>) -> Slot<'a> {
    let mut slot = Slot::of(many);
    let usual = counted(&many.nickname, k);
    match label {
        Some(label) if label != usual => {
            // `Variable x` is followed by `Variable y`.
            let stem = many.name.strip_suffix(&many.nickname).filter(|_| !many.nickname.is_empty());
            slot.name = format!("{}{label}", stem.unwrap_or_default());
            slot.nickname = label.to_owned();
        }
        _ => {
            slot.name = counted(&many.name, k);
            slot.nickname = usual;
        }
    }
    slot
}

/// The name of the `k`-th port, counted from the first one's: its last number goes up, or else its last letter where
/// that stands alone.
pub fn counted(first: &str, k: usize) -> String {
    let digits = |c: char| c.is_ascii_digit();
    if let Some(end) = first.rfind(digits) {
        let head = first.get(..=end).unwrap_or_default();
        let start = head.rfind(|c| !digits(c)).map_or(0, |at| at + head.get(at..).map_or(1, first_len));
        let number = head.get(start..).and_then(|text| text.parse::<usize>().ok());
        if let Some(number) = number.and_then(|n| n.checked_add(k)) {
            let (before, after) = (first.get(..start), first.get(end + 1..));
            return format!("{}{number}{}", before.unwrap_or_default(), after.unwrap_or_default());
        }
    }
    let letters: Vec<char> = first.chars().collect();
    if let Some(at) = letters.iter().rposition(char::is_ascii_alphabetic) {
        let alone = at.checked_sub(1).and_then(|k| letters.get(k)).is_none_or(|c| !c.is_alphanumeric());
        let next = letters.get(at).and_then(|c| char::from_u32(u32::from(*c) + u32::try_from(k).ok()?));
        if let Some(next) = next.filter(|next| alone && next.is_ascii_alphabetic()) {
            let mut letters = letters;
            if let Some(letter) = letters.get_mut(at) {
                *letter = next;
            }
            return letters.into_iter().collect();
        }
    }
    if k == 0 { first.to_owned() } else { format!("{first}{}", k + 1) }
}

/// How many bytes the first character takes.
fn first_len(text: &str) -> usize {
    text.chars().next().map_or(1, char::len_utf8)
}

/// A port of an object whose ports are all written: what the catalogue says of a port of this name, where it does.
pub(super) fn exact<'a>(facts: Option<&Facts>, side: Side, variable: bool, label: &str) -> Slot<'a> {
    let ports =
        facts.map_or(&[][..], |facts| if side == Side::Input { &facts.inputs } else { &facts.outputs });
    match ports.iter().find(|port| !port.many && (port.nickname == label || port.name == label)) {
        Some(port) => Slot::of(port),
        // Ports that somebody added are optional as a rule.
        None => Slot { optional: side == Side::Input && variable, ..Slot::named(label) },
    }
}

/// A port as the catalogue has it.
pub(super) fn exact_of<'a>(facts: &PortFacts) -> Slot<'a> {
    Slot::of(facts)
}

/// Which port a name means: by name, then by nickname, then in any case, then by number.
pub(super) fn find<'a>(
    label: &Name,
    ports: impl Iterator<Item = (&'a str, &'a str)> + Clone,
) -> Option<usize> {
    let text = label.text.as_str();
    let by = |test: &dyn Fn(&str, &str) -> bool| ports.clone().position(|(name, nick)| test(name, nick));
    by(&|name, _| name == text)
        .or_else(|| by(&|_, nick| nick == text))
        .or_else(|| by(&|name, nick| name.eq_ignore_ascii_case(text) || nick.eq_ignore_ascii_case(text)))
        .or_else(|| {
            let k = text.parse().ok().filter(|_| !label.quoted)?;
            (k < ports.clone().count()).then_some(k)
        })
}

/// The ports there are, for a message.
pub(super) fn list<'a>(ports: impl Iterator<Item = (&'a str, &'a str)> + Clone) -> String {
    let names: Vec<String> = ports
        .take(30)
        .map(
            |(name, nick)| {
                if name == nick || nick.is_empty() { name.to_owned() } else { format!("{name} ({nick})") }
            },
        )
        .collect();
    if names.is_empty() { "it has none".to_owned() } else { names.join(", ") }
}

/// A fault about a port that is not there, with the nearest name or all of them.
pub(super) fn unknown<'a>(
    label: &Name,
    what: &str,
    ports: impl Iterator<Item = (&'a str, &'a str)> + Clone,
) -> Fault {
    let near =
        nearest(&label.text, ports.clone().flat_map(|(name, nick)| [name, nick]).filter(|n| n.len() > 2));
    let hint = match near {
        Some(name) => format!("did you mean {name}?"),
        None => format!("there are: {}", list(ports)),
    };
    Fault::new(label.span.at, label.span.len, format!("{what} has no port called {}", label.text)).hint(hint)
}

/// The inputs of an object.
pub(super) fn inputs<'a>(
    facts: Option<&Facts>,
    (all_written, variable): (bool, bool),
    title: &str,
    arguments: &[&'a Argument],
    faults: &mut Vec<Fault>,
) -> Vec<Slot<'a>> {
    let Some(facts) = facts.filter(|_| !all_written) else {
        let slot = |argument: &&'a Argument| {
            let label = argument.name.as_ref().map_or("", |name| name.text.as_str());
            Slot { given: Some(&argument.given), ..exact(facts, Side::Input, variable, label) }
        };
        return arguments.iter().map(slot).collect();
    };
    let (fixed, many) = split(&facts.inputs);
    let mut slots: Vec<Slot<'a>> = fixed.iter().map(Slot::of).collect();
    let mut position = 0;
    for argument in arguments {
        let span = argument.span;
        let names = || facts.inputs.iter().map(|port| (port.name.as_str(), port.nickname.as_str()));
        let k = match &argument.name {
            Some(label) => match find(label, names()).filter(|k| *k < fixed.len()) {
                Some(k) => k,
                None if many.is_some() => slots.len(),
                None => {
                    faults.push(unknown(label, title, names()));
                    continue;
                }
            },
            None => position,
        };
        position = k + 1;
        if k >= slots.len() {
            let Some(many) = many else {
                let message = format!("{title} has {} inputs, and this is one too many", fixed.len());
                faults.push(Fault::new(span.at, span.len, message).hint(list(names())));
                continue;
            };
            let label = argument.name.as_ref().map(|name| name.text.as_str());
            slots.push(one_of_many(many, slots.len() - fixed.len(), label));
        }
        if let Some(slot) = slots.get_mut(k) {
            if slot.given.is_some() {
                let message = format!("the input {} is given twice", slot.name);
                faults.push(Fault::new(span.at, span.len, message));
            }
            slot.given = Some(&argument.given);
        }
    }
    slots
}

/// The outputs of an object.
pub(super) fn outputs<'a>(
    facts: Option<&Facts>,
    (all_written, variable): (bool, bool),
    title: &str,
    written: Option<&'a [Output]>,
    faults: &mut Vec<Fault>,
) -> Vec<Slot<'a>> {
    let list = written.unwrap_or_default();
    let Some(facts) = facts.filter(|_| !all_written) else {
        let slot = |output: &'a Output| Slot {
            modifiers: &output.modifiers,
            ..exact(facts, Side::Output, variable, &output.name.text)
        };
        return list.iter().map(slot).collect();
    };
    let (fixed, many) = split(&facts.outputs);
    let mut slots: Vec<Slot<'a>> = fixed.iter().map(Slot::of).collect();
    if let (Some(many), None) = (many, written) {
        slots.push(one_of_many(many, 0, None));
    }
    for output in list {
        let names = || facts.outputs.iter().map(|port| (port.name.as_str(), port.nickname.as_str()));
        let k = match (find(&output.name, names()).filter(|k| *k < fixed.len()), many) {
            (Some(k), _) => k,
            (None, Some(many)) => {
                slots.push(one_of_many(many, slots.len() - fixed.len(), Some(&output.name.text)));
                slots.len() - 1
            }
            (None, None) => {
                faults.push(unknown(&output.name, title, names()));
                continue;
            }
        };
        if let Some(slot) = slots.get_mut(k) {
            slot.modifiers = &output.modifiers;
        }
    }
    slots
}

#[cfg(test)]
mod tests {
    use super::counted;

    #[test]
    fn ports_of_a_kind_are_counted_on() {
        for (first, k, name) in [
            ("Data 1", 0, "Data 1"),
            ("D1", 9, "D10"),
            ("{0;0}", 2, "{0;2}"),
            ("0", 3, "3"),
            ("A", 2, "C"),
            ("List (A)", 1, "List (B)"),
            ("Item", 0, "Item"),
            ("Item", 1, "Item2"),
            ("é9", 1, "é10"),
            ("z", 1, "z2"),
        ] {
            assert_eq!(counted(first, k), name);
        }
    }
}
