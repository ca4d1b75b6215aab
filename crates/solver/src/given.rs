//! Data from outside in place of what a definition keeps, and results that do not depend on it.

use katydid_component::Level;
use katydid_data::Tree;
use katydid_definition::document::Object;

use crate::{Engine, ObjectReport, Status};

impl Engine {
    /// Gives an input of the object at `index` its data, in place of what its wires bring and of what it keeps; `None`
    /// takes that back. A floating parameter has one input, and so has a slider or a toggle, that is wired from
    /// nowhere. The document stays as it is. Nothing happens when there is no such object.
    pub fn give(&mut self, index: usize, input: usize, tree: Option<Tree>) {
        if index >= self.reports.len() {
            return;
        }
        let before = match tree {
            Some(tree) => self.given.insert((index, input), tree),
            None => self.given.remove(&(index, input)),
        };
        if before.is_some() || self.given.contains_key(&(index, input)) {
            self.touch(index);
        }
    }

    /// Takes over the results of a clone of this that was solved, of those objects that are dirty here and do not hang
    /// on data that was given to the clone. What hangs on an object that is not `lasting`, as it asks the outside
    /// world, is left out too, and so is what failed: it may have been for want of time or memory that time. Gives the
    /// number of results taken.
    pub fn learn(&mut self, solved: &Self, lasting: impl Fn(&Object) -> bool) -> usize {
        let same = self.document.objects.len() == solved.document.objects.len()
            && self.reports.len() == solved.reports.len();
        if !same {
            return 0;
        }
        let mut passing = vec![false; self.reports.len()];
        let mut stack: Vec<usize> = solved.given.keys().map(|(object, _)| *object).collect();
        let others = self.document.objects.iter().enumerate().filter(|(_, object)| !lasting(object));
        stack.extend(others.map(|(at, _)| at));
        let failed =
            solved.reports.iter().enumerate().filter(|(_, report)| report.as_ref().is_some_and(has_failed));
        stack.extend(failed.map(|(at, _)| at));
        while let Some(object) = stack.pop() {
            let Some(seen) = passing.get_mut(object) else { continue };
            if !std::mem::replace(seen, true) {
                stack.extend(self.graph.hanging(object));
            }
        }
        let mut learnt = 0;
        for &object in &self.dirty {
            if passing.get(object) != Some(&false) {
                continue;
            }
            if let (Some(slot), Some(Some(report))) =
                (self.reports.get_mut(object), solved.reports.get(object))
            {
                *slot = Some(report.clone());
                learnt += 1;
            }
        }
        let reports = &self.reports;
        self.dirty.retain(|at| reports.get(*at).is_some_and(Option::is_none));
        learnt
    }

    /// About how many bytes the results take. Data that several outputs share is counted with each.
    pub fn weight(&self) -> usize {
        let reports = self.reports.iter().flatten();
        reports.flat_map(|report| &report.outputs).map(Tree::weight).sum()
    }
}

/// Whether an object, or one of those in it, reported an error.
fn has_failed(report: &ObjectReport) -> bool {
    report.status == Status::Error
        || report.messages.iter().any(|message| message.level == Level::Error)
        || report.inside.as_deref().is_some_and(|inside| inside.iter().any(has_failed))
}

#[cfg(test)]
mod tests {
    use katydid_data::Value;
    use katydid_definition::document::{Document, Object, ids};
    use uuid::Uuid;

    use super::*;
    use crate::Options;

    /// A toggle, and another that nobody touches.
    fn engine() -> Engine {
        let mut document = Document::new();
        for n in 1..=2 {
            let id = Uuid::from_u128(n);
            let mut toggle = Object::new_parameter(ids::BOOLEAN_TOGGLE, "Boolean Toggle", "T", id);
            toggle.set_toggle(true).unwrap();
            document.objects.push(toggle);
        }
        Engine::new(document, Options::default())
    }

    #[test]
    fn what_is_given_stays_in_the_clone() {
        let mut base = engine();
        let mut clone = base.clone();
        clone.give(0, 0, Some(Tree::item(Value::Boolean(false))));
        assert_eq!(clone.solve().solved, 2);
        assert_eq!(base.learn(&clone, |_| true), 1);
        assert!(base.report(0).is_none() && base.report(1).is_some());
        assert_eq!(base.dirty(), [0]);
        assert_eq!(base.learn(&clone, |_| true), 0);
        assert_eq!(base.solve().solved, 1);
        clone.give(0, 0, None);
        assert_eq!(clone.dirty(), [0]);
        clone.give(7, 0, Some(Tree::empty()));
    }
}
