//! Drawings of objects: what is seen of them from a view, as curves in the plane, with what is hidden.

mod coincident;
mod crossing;
mod feature;
mod occluder;
mod pierce;
mod sheet;
mod thresholds;
mod view;

pub use view::View;

use std::sync::Arc as Shared;

use feature::Feature;
use occluder::{Occluders, Sight};

use crate::brep::ClosestOnBrep;
use crate::silhouette::{SilhouetteKind, SilhouettePart, each, go_on_or_stop, silhouettes_of};
use crate::{Brep, Curve, Error, Interval, Mesh, Plane, Result, Tolerance};

/// An object to be drawn.
#[derive(Debug, Clone)]
pub enum Drawn {
    /// A curve: drawn as it is, it hides nothing.
    Curve(Curve),
    /// A Brep.
    Brep(Shared<Brep>),
    /// A mesh.
    Mesh(Shared<Mesh>),
}

/// What is drawn, and how exactly.
#[derive(Debug, Clone, PartialEq)]
pub struct DrawingOptions {
    /// Whether edges without a crease are drawn.
    pub tangent_edges: bool,
    /// Whether seams without a crease are drawn.
    pub tangent_seams: bool,
    /// Planes that cut away what lies on their negative side.
    pub clipping: Vec<Plane>,
    /// How exactly curves are fitted and split; edges that turn by no more than its angle have no crease.
    pub tolerance: Tolerance,
}

/// Whether a curve of a drawing is seen.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash)]
pub enum Visibility {
    /// It is seen.
    Visible,
    /// Something lies before it.
    Hidden,
    /// A nearer curve has the same picture.
    Duplicate,
}

/// A curve of a drawing.
#[derive(Debug, Clone, PartialEq)]
pub struct DrawnCurve {
    /// The curve in the world's XY plane: the picture's coordinates.
    pub curve: Curve,
    /// Which object it comes from.
    pub object: usize,
    /// What it is for the object.
    pub kind: SilhouetteKind,
    /// Whether it is seen.
    pub visibility: Visibility,
}

/// A drawing.
#[derive(Debug, Clone, PartialEq, Default)]
pub struct Drawing {
    /// The curves, object by object.
    pub curves: Vec<DrawnCurve>,
    /// Whether the search for silhouettes came to its end on every face.
    pub complete: bool,
}

/// Silhouettes are found within this part of the tolerance.
const FINER: f64 = 0.05;
/// More curves than this in a drawing are refused.
const MOST_FEATURES: usize = 200_000;

/// A drawing of objects with hidden lines.
///
/// Silhouettes and edges of all objects (see [`Brep::silhouettes`]), curves, and the sections by the clipping planes are
/// projected into the picture and split where a nearer outline crosses them, where they go through a surface, and where a
/// silhouette turns back: only there can a curve become hidden (A. Appel, *The notion of quantitative invisibility and
/// the machine rendering of solids*, 1967). Whether a piece is seen is asked with lines of sight from three places of it
/// against the surfaces themselves: planes, spheres, cylinders and cones in closed form, others from meshes by Newton's
/// method. Where answers differ nonetheless, more places are asked, and the place of the change is halved for. Beside a
/// tangent outline lines of sight start a tenth of the tolerance to either side as well, so that it is not hidden by the
/// surface that it is the outline of. What is nearer behind than five tolerances counts as seen, unless another place of
/// its piece lies farther behind. Nothing fills the cut of a clipping plane.
///
/// `go_on` is asked again and again; where it says no the work stops.
///
/// # Errors
/// A number of the view, the planes or the tolerance is not finite, the tolerance not above 0, the camera lies in the
/// picture plane, an object has no faces, there are too many curves, or the work was stopped.
pub fn drawing(
    objects: &[Drawn],
    view: &View,
    options: &DrawingOptions,
    go_on: &(dyn Fn() -> bool + Sync),
) -> Result<Drawing> {
    options.tolerance.positive_distance()?;
    if options.clipping.iter().any(|p| !p.is_finite()) {
        return Err(Error::NotFinite("clipping plane"));
    }
    let mut out = Drawing { curves: Vec::new(), complete: true };
    let mut features: Vec<Feature> = Vec::new();
    let mut searches: Vec<Option<ClosestOnBrep>> = Vec::with_capacity(objects.len());
    for (object, drawn) in objects.iter().enumerate() {
        go_on_or_stop(go_on)?;
        let search = match drawn {
            Drawn::Brep(brep) => Some(ClosestOnBrep::new(Shared::clone(brep))?),
            Drawn::Curve(_) | Drawn::Mesh(_) => None,
        };
        let (found, complete) = curves_of(drawn, search.as_ref(), view, options, go_on)?;
        searches.push(search);
        out.complete &= complete;
        for (kind, curve, faces) in found {
            features.extend(Feature::new(object, kind, &curve, faces, view, options)?);
        }
        if features.len() > MOST_FEATURES {
            return Err(Error::OutOfRange {
                what: "number of curves",
                value: features.len() as f64,
                must: "at most 200 000",
            });
        }
    }
    let occluders = Occluders::new(objects, searches, view, options, go_on)?;
    let segments = crossing::Segments::new(&features, options.tolerance.absolute);
    let splits = crossing::splits(&features, &segments, &occluders, options.tolerance.absolute, go_on)?;
    let index: Vec<usize> = (0..features.len()).collect();
    let search = coincident::Pictures::new(&features, &segments, options.tolerance.absolute);
    let pieces = each(&index, |&i| {
        go_on_or_stop(go_on)?;
        let (Some(feature), Some(split)) = (features.get(i), splits.get(i)) else { return Ok(Vec::new()) };
        pieces(i, feature, split, &occluders, &search, options.tolerance.absolute)
    })?;
    for (feature, pieces) in features.iter().zip(pieces) {
        for (range, visibility) in pieces {
            let Some(curve) = feature.drawn(range, options.tolerance.absolute) else { continue };
            out.curves.push(DrawnCurve { curve, object: feature.object, kind: feature.kind, visibility });
        }
    }
    Ok(out)
}

/// A curve in space, what it is, and the faces that it lies on.
type Found = (SilhouetteKind, Curve, Vec<usize>);

/// The curves in space that are drawn of an object.
fn curves_of(
    drawn: &Drawn,
    search: Option<&ClosestOnBrep>,
    view: &View,
    options: &DrawingOptions,
    go_on: &(dyn Fn() -> bool + Sync),
) -> Result<(Vec<Found>, bool)> {
    let (found, mut sections, mut complete) = match drawn {
        Drawn::Curve(curve) => {
            return Ok((vec![(SilhouetteKind::MiscellaneousFeature, curve.clone(), Vec::new())], true));
        }
        Drawn::Brep(brep) => {
            let Some(search) = search else { return Ok((Vec::new(), true)) };
            // Lines of sight start beside outlines, and those must be told more exactly than they are drawn.
            let finer = Tolerance { absolute: FINER * options.tolerance.absolute, ..options.tolerance };
            let found = silhouettes_of(search, view.viewpoint(), &finer, go_on)?;
            let mut sections = Vec::new();
            let mut complete = found.complete;
            for plane in &options.clipping {
                go_on_or_stop(go_on)?;
                let section = brep.section(plane, &options.tolerance)?;
                complete &= section.complete;
                sections.extend(section.curves);
            }
            (found, sections, complete)
        }
        Drawn::Mesh(mesh) => {
            let found = mesh.silhouettes(view.viewpoint(), &options.tolerance)?;
            let mut sections = Vec::new();
            for plane in &options.clipping {
                for points in mesh.section(plane)? {
                    if let Ok(curve) = crate::PolylineCurve::new(points) {
                        sections.push(curve.into());
                    }
                }
            }
            (found, sections, true)
        }
    };
    complete &= found.complete;
    let shown = |kind: SilhouetteKind| match kind {
        SilhouetteKind::NonSilhouetteTangent => options.tangent_edges,
        SilhouetteKind::NonSilhouetteSeam => options.tangent_seams,
        _ => true,
    };
    let faces = |part: SilhouettePart| match (part, search) {
        (SilhouettePart::Face(face), _) => vec![face],
        (SilhouettePart::Edge(edge), Some(search)) => {
            let brep = search.brep();
            let trims = brep.edges().get(edge).map_or(&[] as &[usize], |own| &own.trims);
            trims.iter().filter_map(|t| brep.face_of(*t)).collect()
        }
        _ => Vec::new(),
    };
    let mut curves: Vec<Found> = found
        .curves
        .into_iter()
        .filter(|s| shown(s.kind))
        .map(|s| (s.kind, s.curve, faces(s.part)))
        .collect();
    curves.extend(sections.drain(..).map(|c| (SilhouetteKind::SectionCut, c, Vec::new())));
    Ok((curves, complete))
}

/// Places on a piece, as shares of it, at which it is asked whether it is seen: none of them in the middle, where what is
/// symmetric has its edges.
const PLACES: [f64; 3] = [0.483_7, 0.211_3, 0.793_1];
/// The most other places at which it is asked where those do not agree.
const MORE: usize = 24;
/// Halvings between two places with different answers.
const HALVINGS: usize = 30;

/// The pieces of a curve, joined where they are seen alike.
fn pieces(
    index: usize,
    feature: &Feature,
    split: &crossing::Split,
    occluders: &Occluders,
    search: &coincident::Pictures,
    tolerance: f64,
) -> Result<Vec<(Interval, Visibility)>> {
    let mut found: Vec<(Interval, Visibility)> = Vec::new();
    let mut add = |range: Interval, visibility: Visibility| match found.last_mut() {
        // What is too short to be drawn goes with the piece before it.
        Some((last, _)) if feature.picture_chord(range) <= tolerance && range.length() > 0.0 => {
            last.end = range.end;
        }
        Some((last, was)) if *was == visibility => last.end = range.end,
        _ => found.push((range, visibility)),
    };
    for w in split.stops.windows(2) {
        let range = Interval::new(w[0], w[1]);
        if !(range.length() > 0.0) {
            continue;
        }
        if search.is_covered(index, feature, range) {
            add(range, Visibility::Duplicate);
            continue;
        }
        for (range, seen) in seen(feature, range, split.complete, occluders, tolerance)? {
            add(range, if seen { Visibility::Visible } else { Visibility::Hidden });
        }
    }
    Ok(found)
}

/// Whether a range of a curve is seen, or its parts, where that changes within.
fn seen(
    feature: &Feature,
    range: Interval,
    is_split: bool,
    occluders: &Occluders,
    tolerance: f64,
) -> Result<Vec<(Interval, bool)>> {
    let ask = |t: f64| occluders.sees(feature, t);
    let short = feature.picture_chord(range) <= 4.0 * tolerance;
    let mut known: Vec<(f64, Sight)> = Vec::new();
    for x in PLACES.iter().take(if short { 1 } else { PLACES.len() }) {
        let t = range.at(*x);
        known.push((t, ask(t)?));
    }
    let agree = |known: &[(f64, Sight)]| {
        let told = |sight: Sight| known.iter().any(|k| k.1 == sight);
        !(told(Sight::Free) && told(Sight::Hidden))
    };
    let sure = short || (is_split && agree(&known));
    if !sure {
        for t in feature.sampled(range, MORE).chain([0.02, 0.98].map(|x| range.at(x))) {
            known.push((t, ask(t)?));
        }
    }
    if agree(&known) {
        return Ok(vec![(range, known.iter().all(|k| k.1 != Sight::Hidden))]);
    }
    known.retain(|k| k.1 != Sight::Close);
    known.sort_by(|a, b| a.0.total_cmp(&b.0));
    let mut out = Vec::new();
    let mut start = range.start;
    for pair in known.windows(2) {
        let ((mut low, was), (mut high, now)) = (pair[0], pair[1]);
        if was == now {
            continue;
        }
        let hidden = |sight: Sight| sight == Sight::Hidden;
        for _ in 0..HALVINGS {
            let middle = 0.5 * (low + high);
            if hidden(ask(middle)?) == hidden(was) { low = middle } else { high = middle }
        }
        let change = 0.5 * (low + high);
        out.push((Interval::new(start, change), !hidden(was)));
        start = change;
    }
    out.extend(known.last().map(|last| (Interval::new(start, range.end), last.1 != Sight::Hidden)));
    Ok(out)
}
