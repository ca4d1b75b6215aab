//! One object, before and after.

use super::pairs::{Pairs, port_name, ports};
use super::{ChangeKind, List, quoted, tree};
use crate::archive::Chunk;
use crate::document::{Mapping, Modifiers, Object, Persistent, Port, Side, WireDisplay, ids};
use crate::kd::{own_settings, values_form, values_words};

impl List {
    pub(super) fn objects(&mut self, pairs: &Pairs<'_>, old: &Object, new: &Object, title: &str) {
        if old == new && pairs.refers_alike(new) {
            return;
        }
        let mut add = |kind: ChangeKind, text: String| self.add(kind, title, Some(new.id), text);
        if old.component != new.component {
            add(ChangeKind::Setting, format!("was {}", old.name));
        }
        if old.nickname != new.nickname {
            add(ChangeKind::Name, format!("name {} → {}", quoted(&old.nickname), quoted(&new.nickname)));
        }
        if old.locked != new.locked {
            add(ChangeKind::State, if new.locked { "disabled" } else { "enabled" }.to_owned());
        }
        if old.hidden != new.hidden {
            add(ChangeKind::State, if new.hidden { "preview off" } else { "preview on" }.to_owned());
        }
        settings(old, new, &mut add);
        if self.options.layout {
            self.moved(old, new, title);
        }
        self.ports(pairs, old, new, title);
        self.group(pairs, old, new, title);
        self.script(old, new, title);
        self.cluster(old, new, title);
        self.others(old, new, title);
    }

    fn moved(&mut self, old: &Object, new: &Object, title: &str) {
        let text = match (old.pivot, new.pivot) {
            (Some([ax, ay]), Some([bx, by])) if ax != bx || ay != by => {
                format!("moved by ({}, {}) pixels", (bx - ax).round(), (by - ay).round())
            }
            (None, Some(_)) => "placed on the canvas".to_owned(),
            (Some(_), None) => "no longer placed on the canvas".to_owned(),
            _ => match (old.bounds, new.bounds) {
                (Some([_, _, aw, ah]), Some([_, _, bw, bh])) if aw != bw || ah != bh => {
                    format!("size {aw} × {ah} → {bw} × {bh}")
                }
                _ => return,
            },
        };
        self.add(ChangeKind::Layout, title, Some(new.id), text);
    }

    fn ports(&mut self, pairs: &Pairs<'_>, old: &Object, new: &Object, title: &str) {
        for side in [Side::Input, Side::Output] {
            // A floating parameter is its own output.
            if side == Side::Output && new.is_floating() {
                continue;
            }
            let word = if side == Side::Input { "input" } else { "output" };
            for (a, b) in ports(old, new, side) {
                let before = a.and_then(|k| old.ports(side).get(k));
                let after = b.and_then(|k| new.ports(side).get(k));
                match (before, after) {
                    (Some(before), Some(after)) => {
                        self.port(pairs, (old, before), (new, after), title, side);
                    }
                    (None, Some(after)) => {
                        let text = format!("{word} {} added", port_name(after));
                        self.add(ChangeKind::Ports, title, Some(new.id), text);
                        let wires: Vec<String> =
                            after.sources.iter().map(|id| pairs.new_source(*id).1).collect();
                        if !wires.is_empty() {
                            let text = format!("{} now from {}", port_name(after), wires.join(", "));
                            self.add(ChangeKind::Wires, title, Some(new.id), text);
                        }
                    }
                    (Some(before), None) => {
                        let text = format!("{word} {} removed", port_name(before));
                        self.add(ChangeKind::Ports, title, Some(new.id), text);
                    }
                    (None, None) => {}
                }
            }
        }
    }

    fn port(
        &mut self,
        pairs: &Pairs<'_>,
        (old, before): (&Object, &Port),
        (new, after): (&Object, &Port),
        title: &str,
        side: Side,
    ) {
        let floating = new.is_floating();
        let of = if floating { String::new() } else { format!("{} ", port_name(after)) };
        let mut add = |kind: ChangeKind, text: String| self.add(kind, title, Some(new.id), text);
        if !floating && before.nickname != after.nickname {
            let (a, b) = (quoted(&before.nickname), quoted(&after.nickname));
            add(ChangeKind::Name, format!("{of}name {a} → {b}"));
        }
        if let Some(text) = wires(pairs, before, after) {
            add(ChangeKind::Wires, format!("{of}{text}"));
        }
        if side == Side::Input {
            let (a, b) = (old.persistent(before), new.persistent(after));
            if a.as_ref().map(values_form) != b.as_ref().map(values_form) {
                let form = |values: Option<Persistent>| {
                    values.map_or_else(|| "none".to_owned(), |v| values_words(&v))
                };
                let (a, b) = (form(a), form(b));
                let behind = if after.sources.is_empty() { "" } else { " behind the wire" };
                add(ChangeKind::Value, format!("{of}value{behind} {} → {}", short(&a), short(&b)));
            }
        }
        let (a, b) = (words(&before.modifiers), words(&after.modifiers));
        for word in b.iter().filter(|word| !a.contains(word)) {
            add(ChangeKind::Modifier, format!("{of}{word} added"));
        }
        for word in a.iter().filter(|word| !b.contains(word)) {
            add(ChangeKind::Modifier, format!("{of}{word} removed"));
        }
        if before.wire_display != after.wire_display {
            let word = match after.wire_display {
                WireDisplay::Normal => "in full",
                WireDisplay::Faint => "faint",
                WireDisplay::Hidden => "hidden",
            };
            add(ChangeKind::Layout, format!("{of}wires shown {word}"));
        }
        if floating {
            return;
        }
        if before.hidden != after.hidden {
            add(ChangeKind::State, format!("{of}preview {}", if after.hidden { "off" } else { "on" }));
        }
        let chunks = before.chunk(old.container()).zip(after.chunk(new.container()));
        for difference in chunks.map(|(a, b)| tree::compare(a, b, &known_of_port)).unwrap_or_default() {
            add(ChangeKind::Setting, format!("{of}{}", told(&difference)));
        }
    }

    /// Settings that have no words of their own.
    fn others(&mut self, old: &Object, new: &Object, title: &str) {
        for difference in tree::compare(old.container(), new.container(), &known) {
            self.add(ChangeKind::Setting, title, Some(new.id), told(&difference));
        }
    }
}

fn told(difference: &tree::Difference) -> String {
    let form = |value: &Option<String>| value.as_deref().map_or_else(|| "none".to_owned(), short);
    format!("setting {} {} → {}", difference.path, form(&difference.old), form(&difference.new))
}

/// A value, cut where it is long.
fn short(text: &str) -> String {
    const LONGEST: usize = 60;
    let line: String = text.chars().map(|c| if c.is_control() { ' ' } else { c }).take(LONGEST + 1).collect();
    if line.chars().count() <= LONGEST {
        return line;
    }
    format!("{}…", line.chars().take(LONGEST - 1).collect::<String>().trim_end())
}

/// The settings that stand in the statement of the text form: slider, panel, toggle and the like.
fn settings(old: &Object, new: &Object, add: &mut dyn FnMut(ChangeKind, String)) {
    let (a, b) = (own_settings(old), own_settings(new));
    if a == b {
        return;
    }
    // What stands in a panel that shows what comes over a wire is a leftover.
    let wired = |object: &Object| object.inputs.iter().any(|port| !port.sources.is_empty());
    let leftover = new.component == ids::PANEL && wired(old) && wired(new);
    let first = |list: &[String]| list.first().cloned().unwrap_or_default();
    let valued = new.component != ids::VALUE_LIST;
    if valued && first(&a) != first(&b) && !leftover {
        let what = match new.component {
            ids::PANEL | ids::SCRIBBLE => "text",
            ids::EXPRESSION => "formula",
            _ => "value",
        };
        add(ChangeKind::Value, format!("{what} {} → {}", short(&first(&a)), short(&first(&b))));
    }
    let skip = usize::from(valued);
    let rest = |list: &[String]| list.iter().skip(skip).cloned().collect::<Vec<_>>().join(", ");
    if rest(&a) != rest(&b) && !leftover {
        add(ChangeKind::Value, format!("settings {} → {}", short(&rest(&a)), short(&rest(&b))));
    }
}

/// How the wires of an input changed; nothing when they did not.
fn wires(pairs: &Pairs<'_>, before: &Port, after: &Port) -> Option<String> {
    let old: Vec<_> = before.sources.iter().map(|id| pairs.old_source(*id)).collect();
    let new: Vec<_> = after.sources.iter().map(|id| pairs.new_source(*id)).collect();
    if old.iter().map(|(source, _)| source).eq(new.iter().map(|(source, _)| source)) {
        return None;
    }
    let names = |list: &[&(super::pairs::Source, String)]| {
        list.iter().map(|(_, name)| name.as_str()).collect::<Vec<_>>().join(", ")
    };
    let gone: Vec<_> = old.iter().filter(|(a, _)| !new.iter().any(|(b, _)| a == b)).collect();
    let come: Vec<_> = new.iter().filter(|(b, _)| !old.iter().any(|(a, _)| a == b)).collect();
    Some(match (gone.is_empty(), come.is_empty()) {
        (true, true) => format!("wires in another order: {}", names(&new.iter().collect::<Vec<_>>())),
        (true, false) => format!("now from {}", names(&come)),
        (false, true) => format!("{} unplugged", names(&gone)),
        (false, false) => format!("rewired from {} to {}", names(&gone), names(&come)),
    })
}

/// A word for each modifier.
fn words(modifiers: &Modifiers) -> Vec<String> {
    let mut words = Vec::new();
    match modifiers.mapping {
        Mapping::None => {}
        Mapping::Flatten => words.push("flatten".to_owned()),
        Mapping::Graft => words.push("graft".to_owned()),
    }
    for (on, word) in [
        (modifiers.reverse, "reverse"),
        (modifiers.simplify, "simplify"),
        (modifiers.reparameterize, "reparameterize"),
        (modifiers.unitize, "unitize"),
        (modifiers.invert, "invert"),
        (modifiers.degrees, "degrees"),
    ] {
        if on {
            words.push(word.to_owned());
        }
    }
    words.extend(modifiers.expression.as_ref().map(|text| format!("expression {{{}}}", short(text))));
    words
}

/// The items that are told in words, or say nothing about the design. Floating parameters have a port's items too.
fn known(path: &str) -> bool {
    const ITEMS: [&str; 30] = [
        "Name",
        "Locked",
        "ClusterDocument",
        "ID_Count",
        "ScrollRatio",
        "IconDisplay",
        "IconOverride",
        "UserText",
        "ToggleValue",
        "SwitchValue",
        "SwatchColor",
        "ListCount",
        "ListMode",
        "Expression",
        "Text",
        "Size",
        "Font",
        "Bold",
        "Italic",
        "Ca",
        "Cb",
        "Cc",
        "Cd",
        "ScriptSource",
        "AdditionalSource",
        "UsingSource",
        "CodeInput",
        "Border",
        "Colour",
        "PersistentCount",
    ];
    const INSIDE: [&str; 11] = [
        "param_input",
        "param_output",
        "ParameterData/",
        "ParamMap/",
        "Script/",
        "UserCode/",
        "ListItem",
        "Data[",
        "ID[",
        "Slider/",
        "PanelProperties/",
    ];
    // Of these some items have no words.
    const OUTSIDE: [&str; 8] = [
        "Script/LanguageSpec",
        "Script/Title",
        "Slider/",
        "Slider/Snap",
        "PanelProperties/",
        "PanelProperties/Stream",
        "PanelProperties/Special",
        "PanelProperties/Alignment",
    ];
    ITEMS.contains(&path)
        || known_of_port(path)
        || INSIDE.iter().any(|start| path.starts_with(start))
            && !OUTSIDE
                .iter()
                .any(|other| if other.ends_with('/') { path == *other } else { path.starts_with(other) })
            && path != "Script/"
}

/// The items of a port that are told in words, or say nothing about the design.
fn known_of_port(path: &str) -> bool {
    const ITEMS: [&str; 21] = [
        "Description",
        "InstanceGuid",
        "Name",
        "NickName",
        "SourceCount",
        "Optional",
        "Access",
        "Mutable",
        "Hidden",
        "Mapping",
        "ReverseData",
        "SimplifyData",
        "InternalExpression",
        "ParamExpression",
        "Reparameterize",
        "Unitize",
        "InvertBooleans",
        "NegateStream",
        "UseDegrees",
        "WireDisplay",
        "ToolTip",
    ];
    ITEMS.contains(&path)
        || path.starts_with("Source[")
        || path.starts_with("Attributes/")
        || path.starts_with("PersistentData/")
}

/// Whether two chunks have the same item.
pub(super) fn same(a: &Chunk, b: &Chunk, name: &str) -> bool {
    a.item(name) == b.item(name)
}
