//! Which cells of operands a program keeps.

use std::collections::BTreeMap;

use katydid_geometry::Brep;
use katydid_geometry::brep::Fuse;
use serde_json::Value;

use crate::read::{Read, list, names, text};
use crate::shapes::{Failure, breps_of, tolerance};

/// A part of space, or of the faces of open operands: the operands in which it lies.
type Kind = Vec<bool>;

/// The cells that a program keeps: solids, and parts of the faces of open operands.
pub(crate) fn kept(
    step: &Value,
    fuse: &Fuse,
    all: &[Brep],
    groups: &BTreeMap<&str, Vec<usize>>,
) -> Result<Vec<Brep>, Failure> {
    let mut solids: Vec<Kind> = Vec::new();
    for (inside, _) in fuse.volumes()? {
        if inside.contains(&true) && !solids.contains(&inside) {
            solids.push(inside);
        }
    }
    let open = |k: &usize| all.get(*k).is_some_and(|b| !b.is_solid());
    let mut faces: Vec<Kind> = Vec::new();
    fuse.faces(|part| {
        let kind = kind(part.on, part.inside);
        if part.on.iter().enumerate().any(|(k, on)| *on && open(&k)) && !faces.contains(&kind) {
            faces.push(kind);
        }
        false
    })?;
    let material_of = |kinds: &[Kind]| materials(step, kinds, groups);
    let mut made = Vec::new();
    for (material, same) in material_of(&solids)? {
        if material.is_some() {
            // Cells of one material are one where they meet.
            if all.iter().all(Brep::is_solid) {
                made.extend(breps_of(fuse.solids(|inside| same.iter().any(|k| k.as_slice() == inside))?));
                continue;
            }
            let found = fuse.volumes()?.into_iter().filter(|(inside, _)| same.contains(inside));
            let parts: Vec<Brep> = found.map(|(_, m)| m.brep).collect();
            made.extend(breps_of(Brep::union(&parts, &tolerance(all))?));
        } else {
            let found = fuse.volumes()?.into_iter();
            made.extend(found.filter(|(inside, _)| same.contains(inside)).map(|(_, m)| m.brep));
        }
    }
    for (material, same) in material_of(&faces)? {
        let parts = breps_of(fuse.faces(|part| {
            part.on.iter().enumerate().any(|(k, on)| *on && open(&k))
                && same.contains(&kind(part.on, part.inside))
        })?);
        if material.is_some() {
            let t = tolerance(all);
            made.extend(
                parts.iter().map(|b| b.with_coplanar_faces_merged(&t)).collect::<Result<Vec<_>, _>>()?,
            );
        } else {
            made.extend(parts);
        }
    }
    Ok(made)
}

fn kind(on: &[bool], inside: &[bool]) -> Kind {
    on.iter().zip(inside).map(|(a, b)| *a || *b).collect()
}

/// The kept kinds of cells by their materials; those without one stay each for itself.
fn materials(
    step: &Value,
    kinds: &[Kind],
    groups: &BTreeMap<&str, Vec<usize>>,
) -> Read<Vec<(Option<u64>, Vec<Kind>)>> {
    // For each kind of cell: whether it is kept, with its material.
    let mut kept: Vec<Option<u64>> = vec![None; kinds.len()];
    for line in list(&step["program"])? {
        let which = |kind: &Kind| -> Read<bool> {
            let lies = |id: &str| {
                groups.get(id).is_some_and(|g| g.iter().any(|k| kind.get(*k).copied().unwrap_or(false)))
            };
            Ok(names(&line["in"])?.into_iter().all(lies) && !names(&line["out"])?.into_iter().any(lies))
        };
        let material = line["material"].as_u64().unwrap_or(0);
        let what = text(&line["do"])?;
        for (kind, state) in kinds.iter().zip(&mut kept) {
            match what {
                "remove_all" => *state = None,
                "add_all" => *state = Some(material),
                // What has been added keeps its material.
                "add" if state.is_none() && which(kind)? => *state = Some(material),
                "remove" if which(kind)? => *state = None,
                _ => {}
            }
        }
    }
    let mut out: Vec<(Option<u64>, Vec<Kind>)> = Vec::new();
    for (kind, state) in kinds.iter().zip(kept) {
        match state {
            None => {}
            Some(0) => out.push((None, vec![kind.clone()])),
            Some(own) => match out.iter_mut().find(|(material, _)| *material == Some(own)) {
                Some((_, same)) => same.push(kind.clone()),
                None => out.push((Some(own), vec![kind.clone()])),
            },
        }
    }
    Ok(out)
}
