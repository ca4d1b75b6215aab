//! `System.Text.RegularExpressions`: patterns are translated from .NET's syntax and matched by `fancy-regex`, with a
//! limit on its steps. Groups, replacements and the rest are C# (`cs/regex.cs`).

mod pattern;

use std::cell::RefCell;
use std::collections::HashMap;
use std::rc::Rc;

use fancy_regex::{Error, Regex, RegexBuilder, RuntimeError};

use self::pattern::{Translated, translate};
use super::{Cx, Native};
use crate::vm::value::Value;
use crate::vm::{Raise, Stop};

/// Steps back that one search may take.
const MAX_STEPS: usize = 2_000_000;
/// Patterns that are kept compiled.
const MAX_KEPT: usize = 64;

/// A pattern that is compiled.
struct Compiled {
    regex: Regex,
    /// Where .NET counts each group among those of the translated pattern, and its name where it has one.
    groups: Vec<(usize, Option<String>)>,
}

thread_local! {
    static KEPT: RefCell<HashMap<(String, i32), Rc<Compiled>>> = RefCell::default();
}

fn compiled(cx: &Cx<'_>, pattern: usize, options: usize) -> Result<Rc<Compiled>, Raise> {
    let key = (cx.string(pattern), cx.int(options));
    if let Some(found) = KEPT.with_borrow(|kept| kept.get(&key).cloned()) {
        return Ok(found);
    }
    let Translated { text, groups } = translate(&key.0, key.1).map_err(|fault| match fault {
        pattern::Fault::Wrong(message) => wrong(&key.0, &message),
        pattern::Fault::NotSupported(what) => Raise::Stop(Stop::NotSupported(what)),
    })?;
    let regex = RegexBuilder::new(&text)
        .backtrack_limit(MAX_STEPS)
        .build()
        .map_err(|error| wrong(&key.0, &error.to_string()))?;
    let made = Rc::new(Compiled { regex, groups });
    KEPT.with_borrow_mut(|kept| {
        if kept.len() >= MAX_KEPT {
            kept.clear();
        }
        kept.insert(key, made.clone());
    });
    Ok(made)
}

fn wrong(pattern: &str, message: &str) -> Raise {
    Raise::new("ArgumentException", format!("parsing \"{pattern}\" - {message}"))
}

/// A text as bytes, with the place of each byte among the characters of 16 bits and the other way round.
struct Places {
    text: String,
    /// For each 16-bit place the byte; the end is the last.
    bytes: Vec<usize>,
}

impl Places {
    fn of(units: &[u16]) -> Self {
        let mut text = String::with_capacity(units.len());
        let mut bytes = Vec::with_capacity(units.len() + 1);
        for c in char::decode_utf16(units.iter().copied()) {
            // A surrogate alone is one unit, and so is what stands for it.
            let c = c.unwrap_or(char::REPLACEMENT_CHARACTER);
            bytes.extend(std::iter::repeat_n(text.len(), c.len_utf16()));
            text.push(c);
        }
        bytes.push(text.len());
        Self { text, bytes }
    }

    fn unit(&self, byte: usize) -> i32 {
        self.bytes.partition_point(|b| *b < byte) as i32
    }
}

/// The spans of all groups of up to `count` matches from a place on: start and length, -1 for a group without a match.
fn find_all(cx: &mut Cx<'_>) -> Result<Value, Raise> {
    let regex = compiled(cx, 0, 1)?;
    let units = cx.units(2).to_vec();
    let (start, count) = (cx.int(3).max(0) as usize, cx.int(4).max(0) as usize);
    cx.st.reserve(units.len() * 16)?;
    cx.st.spend(units.len() / 16 + 16)?;
    let places = Places::of(&units);
    let mut found = Vec::new();
    let mut from = places.bytes.get(start).copied();
    let mut made = 0;
    while let Some(at) = from
        && made < count
    {
        let captures = match regex.regex.captures_from_pos(&places.text, at) {
            Ok(Some(captures)) => captures,
            Ok(None) => break,
            Err(Error::RuntimeError(RuntimeError::BacktrackLimitExceeded)) => {
                return Err(Raise::Stop(Stop::Refused(format!(
                    "a regular expression took more than {MAX_STEPS} steps"
                ))));
            }
            Err(error) => return Err(Raise::new("InvalidOperationException", error.to_string())),
        };
        for (group, _) in &regex.groups {
            let span = captures.get(*group).map(|m| (places.unit(m.start()), places.unit(m.end())));
            let (from, length) = span.map_or((-1, 0), |(from, to)| (from, to - from));
            found.extend([Value::I32(from), Value::I32(length)]);
        }
        cx.st.spend(regex.groups.len() + 16)?;
        cx.st.reserve(found.len() * 16)?;
        let (begin, end) = captures.get(0).map_or((at, at), |m| (m.start(), m.end()));
        made += 1;
        from = if end > begin {
            Some(end)
        } else {
            // Behind an empty match the search goes on one character later.
            places.text.get(end..).and_then(|rest| rest.chars().next()).map(|c| end + c.len_utf8())
        };
    }
    let int = cx.prim(crate::sema::Prim::I32);
    cx.array(int, found)
}

pub(super) fn find(key: &str) -> Option<Native> {
    Some(match key {
        "Regex.__All(String,Int32,String,Int32,Int32)" => find_all,
        // The names of the groups as .NET counts them: a number is the name of one without a name.
        "Regex.__Names(String,Int32)" => |cx| {
            let regex = compiled(cx, 0, 1)?;
            let names = regex
                .groups
                .iter()
                .enumerate()
                .map(|(i, (_, name))| cx.text(&name.clone().unwrap_or_else(|| i.to_string())))
                .collect();
            let string = cx.program.sema.known.string;
            cx.array(string, names)
        },
        _ => return None,
    })
}
