//! Groups, scripts and clusters.

use super::object::same;
use super::pairs::{Pairs, Source};
use super::{ChangeKind, List};
use crate::archive::Limits;
use crate::document::{ClusterContent, Object, Script, Special};

impl List {
    pub(super) fn group(&mut self, pairs: &Pairs<'_>, old: &Object, new: &Object, title: &str) {
        let (Some(Special::Group(before)), Some(Special::Group(after))) = (old.special(), new.special())
        else {
            return;
        };
        let a: Vec<(Source, String)> = before.members.iter().map(|id| pairs.old_member(*id)).collect();
        let b: Vec<(Source, String)> = after.members.iter().map(|id| pairs.new_member(*id)).collect();
        let missing = |from: &[(Source, String)], to: &[(Source, String)]| -> Vec<String> {
            let gone = from.iter().filter(|(x, _)| !to.iter().any(|(y, _)| x == y));
            gone.map(|(_, name)| name.clone()).collect()
        };
        for (names, word) in [(missing(&b, &a), "joined"), (missing(&a, &b), "left")] {
            if !names.is_empty() {
                let text = format!("{} {word} the group", names.join(", "));
                self.add(ChangeKind::Group, title, Some(new.id), text);
            }
        }
        if before.colour != after.colour {
            self.add(ChangeKind::Group, title, Some(new.id), "another colour");
        }
        if before.border != after.border {
            self.add(ChangeKind::Group, title, Some(new.id), "another frame");
        }
    }

    pub(super) fn script(&mut self, old: &Object, new: &Object, title: &str) {
        let (a, b) = (old.script(), new.script());
        if a == b {
            // A script that cannot be read is compared as it is.
            let chunks = old.container().child("Script").zip(new.container().child("Script"));
            if a.is_none() && chunks.is_some_and(|(a, b)| !same(a, b, "Text")) {
                self.add(ChangeKind::Script, title, Some(new.id), "script changed");
            }
            return;
        }
        let text = |script: &Option<Script>| {
            script.as_ref().map(|s| format!("{}\n{}\n{}", s.using, s.text, s.additional)).unwrap_or_default()
        };
        let (gone, come) = lines(&text(&a), &text(&b));
        let language =
            b.as_ref().or(a.as_ref()).map(|script| script.language.to_string()).unwrap_or_default();
        let text = format!("{language} script changed: {come} lines added, {gone} removed");
        self.add(ChangeKind::Script, title, Some(new.id), text);
    }

    pub(super) fn cluster(&mut self, old: &Object, new: &Object, title: &str) {
        let name = "ClusterDocument";
        if same(old.container(), new.container(), name) || !self.may_enter() {
            return;
        }
        let limits = Limits::default();
        match (old.cluster(&limits), new.cluster(&limits)) {
            (
                Some(Ok(ClusterContent::Open { document: a, .. })),
                Some(Ok(ClusterContent::Open { document: b, .. })),
            ) => {
                self.clusters.push(title.to_owned());
                self.documents(&a, &b);
                self.clusters.pop();
            }
            _ => self.add(ChangeKind::Cluster, title, Some(new.id), "another inside"),
        }
    }
}

/// How many lines are in one text and not in the other: gone, come.
fn lines(old: &str, new: &str) -> (usize, usize) {
    let mut counts: std::collections::HashMap<&str, (usize, usize)> = std::collections::HashMap::new();
    for line in old.lines() {
        counts.entry(line).or_default().0 += 1;
    }
    for line in new.lines() {
        counts.entry(line).or_default().1 += 1;
    }
    counts
        .values()
        .fold((0, 0), |(gone, come), (a, b)| (gone + a.saturating_sub(*b), come + b.saturating_sub(*a)))
}
