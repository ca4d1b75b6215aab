//! What answers of booleans of two solids must keep to, whatever the solids are.

use std::sync::Arc;

use katydid_geometry::brep::{ClosestOnBrep, Made};
use katydid_geometry::{BoundingBox, Brep, Containment, Error, Point3, Tolerance};

type Answer = Result<Vec<Brep>, Error>;

/// The answers to four questions about two solids.
pub(crate) struct Answers {
    common: Answer,
    left: Answer,
    right: Answer,
    both: Answer,
}

impl Answers {
    pub(crate) fn of([a, b]: [&Brep; 2], tolerance: f64) -> Self {
        let limit = Tolerance { absolute: tolerance, ..Tolerance::default() };
        let [first, second] = [a, b].map(std::slice::from_ref);
        let breps = |made: Result<Vec<Made>, Error>| made.map(|m| m.into_iter().map(|m| m.brep).collect());
        Self {
            common: breps(Brep::intersection(first, second, &limit)),
            left: breps(Brep::difference(first, second, &limit)),
            right: breps(Brep::difference(second, first, &limit)),
            both: breps(Brep::union(&[a.clone(), b.clone()], &limit)),
        }
    }

    pub(crate) fn named(&self) -> [(&'static str, &Answer); 4] {
        [("A ∩ B", &self.common), ("A − B", &self.left), ("B − A", &self.right), ("A ∪ B", &self.both)]
    }
}

/// Volumes are measured to this part of themselves.
const MEASURED: f64 = 1e-7;
/// Volumes are one within this part of those of both solids, beside what the tolerance allows.
const SAME: f64 = 1e-5;
/// How many points are asked, and how many tolerances they must be from a boundary to tell anything.
const POINTS: u32 = 300;
const CLEAR: f64 = 50.0;

fn volume(of: &[Brep]) -> Result<f64, Error> {
    of.iter().map(|b| b.volume_properties(MEASURED, || true).map(|p| p.amount.abs())).sum()
}

/// The laws that answers break, in words.
pub(crate) fn broken([a, b]: [&Brep; 2], answers: &Answers, tolerance: f64) -> Vec<String> {
    let mut out = Vec::new();
    match volumes([a, b], answers, tolerance) {
        Ok(found) => out.extend(found),
        Err(why) => out.push(format!("a volume is not measured: {why}")),
    }
    match points([a, b], answers, tolerance) {
        Ok(found) => out.extend(found),
        Err(why) => out.push(format!("a solid is not prepared: {why}")),
    }
    out
}

/// V(A) + V(B) = V(A ∪ B) + V(A ∩ B), V(A) = V(A − B) + V(A ∩ B) and V(B) = V(B − A) + V(A ∩ B).
fn volumes([a, b]: [&Brep; 2], answers: &Answers, tolerance: f64) -> Result<Vec<String>, Error> {
    let Ok(common) = &answers.common else { return Ok(Vec::new()) };
    let own = [a, b].map(|x| volume(std::slice::from_ref(x)));
    let [Ok(va), Ok(vb)] = own else { return Ok(Vec::new()) };
    let common = volume(common)?;
    let area = |of: &Brep| of.area_properties(1e-3, || true).map(|p| p.amount);
    let near = SAME * (va + vb) + 2.0 * tolerance * (area(a)? + area(b)?);
    let laws = [
        ("V(A) = V(A − B) + V(A ∩ B)", va, &answers.left, common),
        ("V(B) = V(B − A) + V(A ∩ B)", vb, &answers.right, common),
        ("V(A ∪ B) = V(A) + V(B) − V(A ∩ B)", va + vb, &answers.both, common),
    ];
    let mut out = Vec::new();
    for (law, whole, part, other) in laws {
        let Ok(part) = part else { continue };
        let part = volume(part)?;
        if (whole - part - other).abs() > near {
            out.push(format!("{law}: {whole} beside {part} and {other}, {near} allowed"));
        }
    }
    Ok(out)
}

/// Of points in the common box of both solids: each is in an answer when it is in the solids as the question has it.
fn points([a, b]: [&Brep; 2], answers: &Answers, tolerance: f64) -> Result<Vec<String>, Error> {
    let boxes = [a, b].map(Brep::bounds_of_faces);
    let [Some(p), Some(q)] = boxes else { return Ok(Vec::new()) };
    let Some(within) = p.intersection(&q) else { return Ok(Vec::new()) };
    let search = |of: &Brep| ClosestOnBrep::new(Arc::new(of.clone()));
    let own = [search(a)?, search(b)?];
    let mut asked = Vec::new();
    for (name, answer) in answers.named() {
        let Ok(parts) = answer else { continue };
        asked.push((name, parts.iter().map(search).collect::<Result<Vec<_>, _>>()?));
    }
    let clear = CLEAR * tolerance;
    let is_in = |of: &ClosestOnBrep, p: Point3| match of.contains(p, clear) {
        Ok(Containment::Inside) => Some(true),
        Ok(Containment::Outside) => Some(false),
        _ => None,
    };
    let mut out = Vec::new();
    for k in 1..=POINTS {
        let p = point(&within, k);
        let [Some(in_a), Some(in_b)] = [0, 1].map(|k: usize| own.get(k).and_then(|of| is_in(of, p))) else {
            continue;
        };
        for (name, parts) in &asked {
            let wanted = match *name {
                "A ∩ B" => in_a && in_b,
                "A − B" => in_a && !in_b,
                "B − A" => in_b && !in_a,
                _ => in_a || in_b,
            };
            let found = parts.iter().map(|of| is_in(of, p)).try_fold(false, |any, x| x.map(|x| any || x));
            if found.is_some_and(|found| found != wanted) {
                out.push(format!("{name} at ({}, {}, {})", p.x, p.y, p.z));
                return Ok(out);
            }
        }
    }
    Ok(out)
}

/// The k-th point of a sequence that fills a box evenly: J. H. Halton's, in the bases 2, 3 and 5.
fn point(within: &BoundingBox, k: u32) -> Point3 {
    let share = |base: u32| {
        let (mut rest, mut unit, mut out) = (k, 1.0, 0.0);
        while rest > 0 {
            unit /= f64::from(base);
            out += unit * f64::from(rest % base);
            rest /= base;
        }
        out
    };
    let d = within.diagonal();
    within.min + katydid_geometry::Vector3::new(d.x * share(2), d.y * share(3), d.z * share(5))
}
