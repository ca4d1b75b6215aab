//! The values of all iterations as the trees of a component's outputs.

use std::sync::Arc;

use katydid_data::{Item, Path, Tree, TreeBuilder, Value as Data};
use katydid_geometry::{Point3, Vector3};
use katydid_members::Value;

use crate::from_script::Outward;
use crate::reply::Reply;
use crate::task::Prepared;

/// The trees of the component's outputs. An item goes to the path of its branch set; a list too, with the number of the
/// iteration behind it where an input takes items; a tree keeps its paths.
pub(crate) fn trees(prepared: &Prepared, reply: &Reply, outward: &mut Outward<'_>) -> Vec<Tree> {
    let places = prepared.places.iter();
    places
        .map(|place| match place {
            Some(place) => tree(prepared, reply, *place, outward),
            None => prints(prepared, reply),
        })
        .collect()
}

/// Each iteration with its branch set's path and its number within the set.
fn iterations(prepared: &Prepared) -> impl Iterator<Item = (&Path, usize)> {
    prepared.sets.iter().flat_map(|(path, count)| (0..*count).map(move |k| (path, k)))
}

fn tree(prepared: &Prepared, reply: &Reply, place: usize, outward: &mut Outward<'_>) -> Tree {
    if let Some(tree) = plain(prepared, reply, place) {
        return tree;
    }
    let mut branches: Vec<(Path, Vec<Option<Data>>)> = Vec::new();
    for ((path, k), row) in iterations(prepared).zip(&reply.iterations) {
        match row.get(place).unwrap_or(&Value::Null) {
            Value::Tree(own) => {
                for (path, items) in own {
                    let items = items.iter().map(|item| outward.item(item)).collect();
                    branches.push((Path::from(path.as_slice()), items));
                }
            }
            value => match value.items() {
                // A polyline is one curve, though its points are a list too.
                Some(items) if !matches!(value, Value::Polyline(_)) => {
                    let path = if prepared.grows { path.child(k) } else { path.clone() };
                    branches.push((path, items.iter().map(|item| outward.item(item)).collect()));
                }
                _ => {
                    let item = outward.item(value);
                    match branches.last_mut().filter(|(own, _)| own == path) {
                        Some((_, items)) => items.push(item),
                        None => branches.push((path.clone(), vec![item])),
                    }
                }
            },
        }
    }
    built(branches)
}

/// The one list of a script that ran once, where all its items are numbers, points or vectors: its column as it is.
fn plain(prepared: &Prepared, reply: &Reply, place: usize) -> Option<Tree> {
    let [row] = reply.iterations.as_slice() else { return None };
    let (path, _) = iterations(prepared).next()?;
    let column = match row.get(place)? {
        Value::Numbers(items) => f64::column(items.clone(), None),
        Value::Points(items) => Point3::column(items.clone(), None),
        Value::Vectors(items) => Vector3::column(items.clone(), None),
        _ => return None,
    };
    Some(Tree::branch_at(if prepared.grows { path.child(0) } else { path.clone() }, column))
}

/// What was printed, a line an item.
fn prints(prepared: &Prepared, reply: &Reply) -> Tree {
    let mut branches: Vec<(Path, Vec<Option<Data>>)> = Vec::new();
    for ((path, _), text) in iterations(prepared).zip(&reply.prints) {
        let lines = text.lines().map(|line| Some(Data::Text(Arc::from(line))));
        match branches.last_mut().filter(|(own, _)| own == path) {
            Some((_, items)) => items.extend(lines),
            None => branches.push((path.clone(), lines.collect())),
        }
    }
    built(branches)
}

/// Branches of one path are one branch.
fn built(mut branches: Vec<(Path, Vec<Option<Data>>)>) -> Tree {
    branches.sort_by(|a, b| a.0.cmp(&b.0));
    let mut builder = TreeBuilder::new();
    let mut last: Option<Path> = None;
    for (path, items) in branches {
        if last.as_ref() != Some(&path) {
            builder.branch(path.clone());
            last = Some(path);
        }
        items.into_iter().for_each(|item| builder.push(item));
    }
    builder.finish()
}
