//! Solids cut by solids.

use katydid_geometry::brep::{Fuse, Made};
use katydid_geometry::{Brep, Tolerance};

use super::argument::{Some1, Within};
use super::table::Endpoints;
use crate::Fault;

pub(super) fn enter(table: &mut Endpoints) {
    table.add("brep/createbooleanunion-breparray_double", |b: Some1<Brep>, t: Within| union(&b.0, t));
    table.add("brep/createbooleanunion-breparray_double_bool", |b: Some1<Brep>, t: Within, _: bool| {
        union(&b.0, t)
    });
    table.add("brep/createbooleandifference-brep_brep_double", |a: Brep, b: Brep, t: Within| {
        difference(&[a], &[b], t)
    });
    table
        .add("brep/createbooleandifference-brep_brep_double_bool", |a: Brep, b: Brep, t: Within, _: bool| {
            difference(&[a], &[b], t)
        });
    table.add(
        "brep/createbooleandifference-breparray_breparray_double",
        |a: Some1<Brep>, b: Some1<Brep>, t: Within| difference(&a.0, &b.0, t),
    );
    table.add(
        "brep/createbooleandifference-breparray_breparray_double_bool",
        |a: Some1<Brep>, b: Some1<Brep>, t: Within, _: bool| difference(&a.0, &b.0, t),
    );
    table.add("brep/createbooleanintersection-brep_brep_double", |a: Brep, b: Brep, t: Within| {
        intersection(&[a], &[b], t)
    });
    table.add(
        "brep/createbooleanintersection-brep_brep_double_bool",
        |a: Brep, b: Brep, t: Within, _: bool| intersection(&[a], &[b], t),
    );
    table.add(
        "brep/createbooleanintersection-breparray_breparray_double",
        |a: Some1<Brep>, b: Some1<Brep>, t: Within| intersection(&a.0, &b.0, t),
    );
    table.add(
        "brep/createbooleanintersection-breparray_breparray_double_bool",
        |a: Some1<Brep>, b: Some1<Brep>, t: Within, _: bool| intersection(&a.0, &b.0, t),
    );
    table.add("brep/createbooleansplit-brep_brep_double", |a: Brep, b: Brep, t: Within| split(&[a], &[b], t));
    table.add(
        "brep/createbooleansplit-breparray_breparray_double",
        |a: Some1<Brep>, b: Some1<Brep>, t: Within| split(&a.0, &b.0, t),
    );
    table.add("brep/trim-brep_brep_double", |b: Brep, cutter: Brep, t: Within| {
        let parts = Fuse::new(&[b, cutter], &t.tolerance())?.faces_of(0)?;
        // What is trimmed away is what lies inside the cutter.
        let kept = parts.into_iter().filter(|(inside, _)| inside.get(1) != Some(&true));
        Ok(kept.map(|(_, part)| part.brep).collect::<Vec<_>>())
    });
}

fn breps(made: Vec<Made>) -> Vec<Brep> {
    made.into_iter().map(|m| m.brep).collect()
}

fn union(all: &[Brep], t: Within) -> Result<Vec<Brep>, Fault> {
    Ok(breps(Brep::union(all, &t.tolerance())?))
}

fn difference(a: &[Brep], b: &[Brep], t: Within) -> Result<Vec<Brep>, Fault> {
    Ok(breps(Brep::difference(a, b, &t.tolerance())?))
}

fn intersection(a: &[Brep], b: &[Brep], t: Within) -> Result<Vec<Brep>, Fault> {
    Ok(breps(Brep::intersection(a, b, &t.tolerance())?))
}

/// The parts of the first solids that the others divide.
fn split(a: &[Brep], b: &[Brep], t: Within) -> Result<Vec<Brep>, Fault> {
    let all: Vec<Brep> = a.iter().chain(b).cloned().collect();
    let tolerance: Tolerance = t.tolerance();
    let parts = Fuse::new(&all, &tolerance)?.volumes()?;
    let own = parts.into_iter().filter(|(inside, _)| inside.iter().take(a.len()).any(|x| *x));
    Ok(own.map(|(_, part)| part.brep).collect())
}
