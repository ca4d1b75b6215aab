//! Representations of shape, and how assemblies place them in each other.

use std::collections::{BTreeMap, HashMap, HashSet};

use super::entity::{File, Record};
use super::place::Space;
use super::unit::Units;
use crate::{Error, Result};
use katydid_geometry::Xform;

/// A representation: what it holds, and the context that tells its units.
pub(super) struct Representation {
    pub(super) items: Vec<u64>,
    pub(super) context: u64,
    pub(super) name: String,
}

/// Representations with their groups and where they stand.
pub(super) struct Placed {
    pub(super) representations: Vec<(u64, usize, Xform)>,
    /// Why some could not be placed.
    pub(super) errors: Vec<Error>,
}

/// One representation placed in another.
struct Link {
    child: usize,
    motion: Result<Xform>,
}

/// Representations in groups that share one space, and the groups placed in groups.
pub(super) struct Graph {
    pub(super) representations: BTreeMap<u64, Representation>,
    groups: HashMap<u64, usize>,
    members: Vec<Vec<u64>>,
    links: Vec<Vec<Link>>,
    roots: Vec<usize>,
    /// The names of products, by group.
    pub(super) names: HashMap<usize, String>,
}

fn representation(record: &Record<'_>) -> Option<Representation> {
    let wanted = record.keyword.ends_with("SHAPE_REPRESENTATION");
    let (Ok(items), Some(context)) = (record.references(1), record.maybe(2)) else { return None };
    wanted.then(|| Representation { items, context, name: record.text(0).to_owned() })
}

/// The name of the product that a definition of shape belongs to.
fn product_name(file: &File, definition: u64) -> Option<String> {
    let formation = file.record(definition).ok()?.maybe(2)?;
    let product = file.record(file.record(formation).ok()?.maybe(2)?).ok()?;
    let name = if product.text(1).is_empty() { product.text(0) } else { product.text(1) };
    (!name.is_empty()).then(|| name.to_owned())
}

impl Graph {
    /// The units of the first representation that has any.
    pub(super) fn units_of(file: &File) -> Result<Units> {
        let context = file.records().find_map(|record| Some(representation(&record)?.context));
        let usual = Units { metres: 1e-3, radians: 1.0, tolerance: None };
        context.map_or(Ok(usual), |context| Units::of(file, context))
    }

    /// The representations of a file; `space` gives that of a representation.
    pub(super) fn of<'a>(file: &'a File, space: &dyn Fn(u64) -> Result<Space<'a>>) -> Self {
        let mut graph = Self::plain(file);
        graph.name(file);
        graph.link(file, space);
        let mut inner: HashSet<usize> = graph.links.iter().flatten().map(|link| link.child).collect();
        let mapped = file.all("REPRESENTATION_MAP").filter_map(|record| record.maybe(1));
        inner.extend(mapped.filter_map(|id| graph.groups.get(&id)));
        graph.roots = (0..graph.members.len()).filter(|group| !inner.contains(group)).collect();
        graph
    }

    fn name(&mut self, file: &File) {
        for record in file.all("SHAPE_DEFINITION_REPRESENTATION") {
            let (Some(shape), Some(id)) = (record.maybe(0), record.maybe(1)) else { continue };
            let definition = file.record(shape).ok().and_then(|shape| shape.maybe(2));
            let name = definition.and_then(|definition| product_name(file, definition));
            if let (Some(group), Some(name)) = (self.groups.get(&id), name) {
                self.names.insert(*group, name);
            }
        }
    }

    /// For each definition of a product the group of its shape.
    fn of_products(&self, file: &File) -> HashMap<u64, usize> {
        let mut out = HashMap::new();
        for record in file.all("SHAPE_DEFINITION_REPRESENTATION") {
            let (Some(shape), Some(id)) = (record.maybe(0), record.maybe(1)) else { continue };
            let definition = file.record(shape).ok().and_then(|shape| shape.maybe(2));
            if let (Some(definition), Some(group)) = (definition, self.groups.get(&id)) {
                out.insert(definition, *group);
            }
        }
        out
    }

    fn link<'a>(&mut self, file: &'a File, space: &dyn Fn(u64) -> Result<Space<'a>>) {
        let products = self.of_products(file);
        let mut parents: HashMap<u64, usize> = HashMap::new();
        for record in file.all("CONTEXT_DEPENDENT_SHAPE_REPRESENTATION") {
            let usage = record.maybe(1).and_then(|id| file.record(id).ok()?.maybe(2));
            let parent = usage.and_then(|id| file.record(id).ok()?.maybe(3));
            let group = parent.and_then(|parent| products.get(&parent));
            if let (Some(relation), Some(group)) = (record.maybe(0), group) {
                parents.insert(relation, *group);
            }
        }
        for record in file.all("REPRESENTATION_RELATIONSHIP_WITH_TRANSFORMATION") {
            let Some(pair) = file.part(record.id, "REPRESENTATION_RELATIONSHIP") else { continue };
            let (Some(a), Some(b)) = (pair.maybe(2), pair.maybe(3)) else { continue };
            let (Some(first), Some(second)) = (self.groups.get(&a), self.groups.get(&b)) else { continue };
            // The first is placed in the second, unless the product says that the first is the assembly.
            let is_turned = parents.get(&record.id) == Some(first) && first != second;
            let of = |id: u64| self.representations.get(&id).map_or(0, |one| one.context);
            let motion = transformation(file, &record, space(of(a)), space(of(b)));
            let motion = motion.and_then(|motion| {
                if !is_turned {
                    return Ok(motion);
                }
                motion.inverse().ok_or_else(|| record.refuse("its transformation cannot be turned round"))
            });
            let (child, parent) = if is_turned { (*second, *first) } else { (*first, *second) };
            self.links[parent].push(Link { child, motion });
        }
    }

    /// All representations with where they stand, from the assemblies down.
    ///
    /// # Errors
    /// Assemblies hold each other in a circle, or there are too many parts.
    pub(super) fn placed(&self, most: usize) -> Result<Placed> {
        let mut out = Vec::new();
        let mut errors = Vec::new();
        let mut stack: Vec<(usize, Xform, usize)> =
            self.roots.iter().rev().map(|group| (*group, Xform::IDENTITY, 0)).collect();
        if stack.is_empty() && !self.members.is_empty() {
            let id = self.members.first().and_then(|ids| ids.first()).copied().unwrap_or_default();
            return Err(Error::entity(id, "assemblies hold each other in a circle"));
        }
        while let Some((group, motion, depth)) = stack.pop() {
            let ids = &self.members[group];
            if depth > super::entity::DEEPEST {
                let id = ids.first().copied().unwrap_or_default();
                return Err(Error::entity(id, "assemblies lie too deep in each other, or in a circle"));
            }
            out.extend(ids.iter().map(|id| (*id, group, motion)));
            if out.len() > most || stack.len() > most {
                return Err(Error::TooLarge(format!("assemblies of more than {most} representations")));
            }
            for link in self.links[group].iter().rev() {
                match &link.motion {
                    Ok(inner) => stack.push((link.child, motion * *inner, depth + 1)),
                    Err(error) => errors.push(Error::entity(
                        self.members[link.child].first().copied().unwrap_or_default(),
                        format!("it cannot be placed: {error}"),
                    )),
                }
            }
        }
        Ok(Placed { representations: out, errors })
    }

    /// The representations in groups, without links yet.
    fn plain(file: &File) -> Self {
        let representations: BTreeMap<u64, Representation> =
            file.records().filter_map(|record| Some((record.id, representation(&record)?))).collect();
        let places: Vec<u64> = representations.keys().copied().collect();
        let index: HashMap<u64, usize> = places.iter().enumerate().map(|(k, id)| (*id, k)).collect();
        let mut parents: Vec<usize> = (0..places.len()).collect();
        for keyword in ["SHAPE_REPRESENTATION_RELATIONSHIP", "REPRESENTATION_RELATIONSHIP"] {
            for record in file.all(keyword).filter(|record| !file.is_complex(record.id)) {
                let pair = [2, 3].map(|k| record.maybe(k).and_then(|id| index.get(&id).copied()));
                if let [Some(a), Some(b)] = pair {
                    let (a, b) = (root(&parents, a), root(&parents, b));
                    parents[a.max(b)] = a.min(b);
                }
            }
        }
        let mut numbers: HashMap<usize, usize> = HashMap::new();
        let mut members: Vec<Vec<u64>> = Vec::new();
        let mut groups = HashMap::new();
        for (k, id) in places.iter().enumerate() {
            let number = *numbers.entry(root(&parents, k)).or_insert_with(|| {
                members.push(Vec::new());
                members.len() - 1
            });
            members[number].push(*id);
            groups.insert(*id, number);
        }
        let links = members.iter().map(|_| Vec::new()).collect();
        Self { representations, groups, members, links, roots: Vec::new(), names: HashMap::new() }
    }
}

fn root(parents: &[usize], mut at: usize) -> usize {
    while let Some(&next) = parents.get(at).filter(|next| **next != at) {
        at = next;
    }
    at
}

/// From the space of the first representation to that of the second.
fn transformation(
    file: &File,
    record: &Record<'_>,
    first: Result<Space<'_>>,
    second: Result<Space<'_>>,
) -> Result<Xform> {
    let operator = file.record(record.reference(0)?)?;
    if operator.keyword != "ITEM_DEFINED_TRANSFORMATION" {
        return Err(operator.refuse("transformations of this type are not supported"));
    }
    let from = first?.frame(operator.reference(2)?)?;
    let to = second?.frame(operator.reference(3)?)?;
    Ok(Xform::plane_to_plane(&from, &to))
}
