//! What makes one document of another, as data: what undo keeps, a journal writes and a solver takes in.

use std::collections::HashMap;
use std::collections::hash_map::Entry;
use std::sync::Arc;

use uuid::Uuid;

use super::{Document, Header, Library, Object, definition};
use crate::archive::Chunk;

/// The step from one state of a document to another: objects are taken out, then others put in. An object that is
/// changed is taken out and put in again; what stays is not named.
#[derive(Debug, Clone, PartialEq, Default)]
pub struct Difference {
    /// The places of the objects that go, before; rising.
    pub removed: Vec<usize>,
    /// The objects that come, by their places after; rising.
    pub put: Vec<(usize, Object)>,
    /// The tree without the objects, where it is another: settings, author, add-ons.
    pub frame: Option<Arc<Chunk>>,
}

/// A difference that does not belong to the document it is used on.
#[derive(Debug, Clone, Copy, PartialEq, Eq, thiserror::Error)]
#[error("the change does not fit the document")]
pub struct Misfit;

impl Difference {
    /// What makes `after` of `before`. The time is in proportion to the number of objects, most of which it only
    /// looks at from outside when the two documents were clones of one.
    pub fn between(before: &Document, after: &Document) -> Self {
        let frame = (!Arc::ptr_eq(&before.tree, &after.tree) && before.tree != after.tree)
            .then(|| Arc::clone(&after.tree));
        let (a, b) = (before.objects.as_slice(), after.objects.as_slice());
        let head = a.iter().zip(b).take_while(|(x, y)| x.is_same(y)).count();
        let (a, b) = (a.get(head..).unwrap_or_default(), b.get(head..).unwrap_or_default());
        let tail = a.iter().rev().zip(b.iter().rev()).take_while(|(x, y)| x.is_same(y)).count();
        let (a, b) =
            (a.get(..a.len() - tail).unwrap_or_default(), b.get(..b.len() - tail).unwrap_or_default());
        let kept = kept(a, b);
        let mut removed: Vec<usize> = (head..head + a.len()).collect();
        let mut stays = kept.iter().map(|(old, _)| head + old).peekable();
        removed.retain(|at| stays.next_if_eq(at).is_none());
        let mut stays = kept.iter().map(|(_, new)| *new).peekable();
        let put = b
            .iter()
            .enumerate()
            .filter(|(at, _)| stays.next_if_eq(at).is_none())
            .map(|(at, object)| (head + at, object.clone()))
            .collect();
        Self { removed, put, frame }
    }

    /// Whether it changes nothing.
    pub fn is_empty(&self) -> bool {
        self.removed.is_empty() && self.put.is_empty() && self.frame.is_none()
    }

    /// Whether as many objects come as go, in the same places: no other object moves. As a rule they are the same objects,
    /// changed; their ids tell.
    pub fn is_in_place(&self) -> bool {
        self.removed.iter().eq(self.put.iter().map(|(at, _)| at))
    }

    /// For every object that is put into `before`, the place of the one of the same id that goes, if there is one.
    /// Of several with the same id the first belongs to the first.
    pub fn counterparts(&self, before: &Document) -> Vec<Option<usize>> {
        let mut places: HashMap<Uuid, Vec<usize>> = HashMap::new();
        for &at in self.removed.iter().rev() {
            if let Some(object) = before.objects.get(at) {
                places.entry(object.id).or_default().push(at);
            }
        }
        let mut take = |id: Uuid| places.get_mut(&id).and_then(Vec::pop);
        self.put.iter().map(|(_, object)| take(object.id)).collect()
    }

    /// The ids of the objects that go and do not come again.
    pub fn gone(&self, before: &Document) -> Vec<Uuid> {
        let mut coming: HashMap<Uuid, usize> = HashMap::new();
        for (_, object) in &self.put {
            *coming.entry(object.id).or_default() += 1;
        }
        let objects = self.removed.iter().filter_map(|at| before.objects.get(*at));
        let mut gone = Vec::new();
        for object in objects {
            match coming.entry(object.id) {
                Entry::Occupied(mut left) if *left.get() > 0 => *left.get_mut() -= 1,
                _ => gone.push(object.id),
            }
        }
        gone
    }
}

/// The objects that are the same in both lists and stand in the same order, as pairs of places: those that are clones
/// of one. What stands elsewhere among them counts as taken out and put in again.
fn kept(a: &[Object], b: &[Object]) -> Vec<(usize, usize)> {
    // Changes in place need no search.
    if a.len() == b.len() && a.iter().zip(b).all(|(x, y)| x.id == y.id) {
        return a.iter().zip(b).enumerate().filter(|(_, (x, y))| x == y).map(|(at, _)| (at, at)).collect();
    }
    let mut places: HashMap<Uuid, Vec<usize>> = HashMap::with_capacity(a.len());
    for (at, object) in a.iter().enumerate().rev() {
        places.entry(object.id).or_default().push(at);
    }
    let mut pairs = Vec::new();
    for (new, object) in b.iter().enumerate() {
        let Some(old) = places.get_mut(&object.id).and_then(Vec::pop) else { continue };
        if a.get(old).is_some_and(|was| was == object) {
            pairs.push((old, new));
        }
    }
    longest_rise(&pairs)
}

/// The longest part of the pairs in which both places rise; the second rises already. (Patience sorting: C. Schensted,
/// "Longest increasing and decreasing subsequences", 1961.)
fn longest_rise(pairs: &[(usize, usize)]) -> Vec<(usize, usize)> {
    let mut ends: Vec<usize> = Vec::new();
    let mut before: Vec<Option<usize>> = Vec::with_capacity(pairs.len());
    let old = |k: usize| pairs.get(k).map_or(0, |pair| pair.0);
    for (k, pair) in pairs.iter().enumerate() {
        let length = ends.partition_point(|&end| old(end) < pair.0);
        before.push(length.checked_sub(1).and_then(|last| ends.get(last).copied()));
        match ends.get_mut(length) {
            Some(end) => *end = k,
            None => ends.push(k),
        }
    }
    let mut rise = Vec::with_capacity(ends.len());
    let mut next = ends.last().copied();
    while let Some(k) = next {
        rise.extend(pairs.get(k));
        next = before.get(k).copied().flatten();
    }
    rise.reverse();
    rise
}

/// Whether places rise and lie before the end.
fn rise(places: impl IntoIterator<Item = usize>, end: usize) -> bool {
    let mut least = 0;
    places.into_iter().all(|at| at >= std::mem::replace(&mut least, at.saturating_add(1)) && at < end)
}

impl Document {
    /// Takes a step, and gives the step back.
    ///
    /// # Errors
    /// When the difference was made for another document: nothing is changed then.
    pub fn apply(&mut self, difference: &Difference) -> Result<Difference, Misfit> {
        let Difference { removed, put, frame } = difference;
        let rest = self.objects.len().checked_sub(removed.len()).ok_or(Misfit)?;
        let total = rest + put.len();
        if !rise(removed.iter().copied(), self.objects.len()) || !rise(put.iter().map(|(at, _)| *at), total) {
            return Err(Misfit);
        }
        let mut back =
            Difference { removed: put.iter().map(|(at, _)| *at).collect(), ..Difference::default() };
        if difference.is_in_place() {
            for (at, object) in put {
                if let Some(slot) = self.objects.get_mut(*at) {
                    back.put.push((*at, std::mem::replace(slot, object.clone())));
                }
            }
        } else {
            let mut going = removed.iter().copied().peekable();
            let mut staying = Vec::with_capacity(rest);
            for (at, object) in std::mem::take(&mut self.objects).into_iter().enumerate() {
                if going.next_if_eq(&at).is_some() {
                    back.put.push((at, object));
                } else {
                    staying.push(object);
                }
            }
            let mut staying = staying.into_iter();
            let mut coming = put.iter().peekable();
            self.objects = (0..total)
                .filter_map(|at| match coming.next_if(|(place, _)| *place == at) {
                    Some((_, object)) => Some(object.clone()),
                    None => staying.next(),
                })
                .collect();
        }
        let nesting = self.nesting;
        for (at, _) in put {
            // What comes from elsewhere lies as deep as all others here.
            if let Some(object) = self.objects.get_mut(*at).filter(|object| object.nesting != nesting) {
                object.nesting = nesting;
            }
        }
        if let Some(frame) = frame {
            back.frame = Some(Arc::clone(&self.tree));
            self.set_frame(Arc::clone(frame));
        }
        Ok(back)
    }

    /// The tree without the objects, to be kept.
    pub fn frame(&self) -> &Arc<Chunk> {
        &self.tree
    }

    /// Gives the document another tree around its objects: [`header`](Self::header) and
    /// [`libraries`](Self::libraries) are read from it.
    pub fn set_frame(&mut self, frame: Arc<Chunk>) {
        self.header = Header::read(&frame, definition(&frame));
        self.libraries = Library::read_all(definition(&frame));
        self.tree = frame;
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn document(ids: &[u128]) -> Document {
        let mut document = Document::new();
        let object =
            |id: &u128| Object::new_component(Uuid::nil(), "A", &id.to_string(), Uuid::from_u128(*id));
        document.objects = ids.iter().map(object).collect();
        document
    }

    fn names(document: &Document) -> Vec<&str> {
        document.objects.iter().map(|object| object.nickname.as_str()).collect()
    }

    #[test]
    fn a_difference_leads_there_and_back() {
        let start = document(&[1, 2, 3, 4, 5, 5, 6]);
        let mut end = start.clone();
        end.objects.swap(0, 3);
        end.objects.remove(4);
        end.objects.insert(2, Object::new_component(Uuid::nil(), "A", "new", Uuid::from_u128(9)));
        if let Some(object) = end.objects.last_mut() {
            object.set_nickname("six");
        }
        end.tree_mut().set("Extra", 1);
        let difference = Difference::between(&start, &end);
        let mut walked = start.clone();
        let back = walked.apply(&difference);
        assert_eq!(names(&walked), names(&end));
        assert_eq!(walked, end);
        assert!(matches!(&back, Ok(back) if walked.apply(back).is_ok()));
        assert_eq!(walked, start);
        assert_eq!(difference.gone(&start), [Uuid::from_u128(5)]);
        assert!(difference.frame.is_some() && !difference.is_in_place());
    }

    #[test]
    fn only_what_stands_elsewhere_is_named() {
        let start = document(&[1, 2, 3, 4, 5]);
        let mut end = start.clone();
        let first = end.objects.remove(0);
        end.objects.push(first);
        let difference = Difference::between(&start, &end);
        assert_eq!((difference.removed.as_slice(), difference.put.len()), (&[0][..], 1));
        assert!(difference.gone(&start).is_empty());
    }

    #[test]
    fn what_does_not_fit_changes_nothing() {
        let mut document = document(&[1, 2]);
        for removed in [vec![2], vec![1, 0], vec![0, 0], vec![0, 1, 2]] {
            let wrong = Difference { removed, ..Difference::default() };
            assert_eq!(document.apply(&wrong), Err(Misfit));
        }
        let object = Object::new(Uuid::nil(), "A");
        let wrong = Difference { put: vec![(3, object)], ..Difference::default() };
        assert_eq!(document.apply(&wrong), Err(Misfit));
        assert_eq!(document.objects.len(), 2);
    }
}
