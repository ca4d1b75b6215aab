//! The smallest boxes around breps.

use super::MeshSettings;
use crate::brep::Brep;
use crate::{Box3, Direction, Interval, Plane, Quadrant, Result, Surface, Vector3};

/// Faces are sampled this finely, in parts of the size of the brep, to find where they bulge out most.
const SAMPLED: f64 = 2e-3;
/// Steps of Newton's iteration from a sample to the place where the face bulges out most.
const STEPS: usize = 12;

impl Brep {
    /// The smallest box along a plane's axes around the brep. Exact where edges, flat faces and whole surfaces reach
    /// farthest; where a trimmed curved face bulges out beyond its edges, its farthest point is found from samples by
    /// Newton's iteration.
    ///
    /// # Errors
    /// There is no face with a surface, or a number overflows.
    pub fn bounding_box_in(&self, plane: &Plane) -> Result<Box3> {
        let mut ranges = [Interval::new(f64::INFINITY, f64::NEG_INFINITY); 3];
        let mut grow = |k: usize, x: Interval| {
            if let Some(own) = ranges.get_mut(k) {
                *own = Interval::new(own.start.min(x.start), own.end.max(x.end));
            }
        };
        let axes = [plane.x_axis, plane.y_axis, plane.z_axis];
        for edge in 0..self.edges().len() {
            if let Some(curve) = self.edge_as_curve(edge)? {
                axes.iter().enumerate().for_each(|(k, axis)| grow(k, curve.extent_along(*axis)));
            }
        }
        let bulging: Vec<usize> = (0..self.faces().len()).filter(|&face| self.may_bulge(face)).collect();
        if !bulging.is_empty() {
            let size = self.bounds_of_faces().map_or(1.0, |b| b.diagonal().length());
            let settings = MeshSettings { simple_planes: true, ..MeshSettings::within(SAMPLED * size) };
            let rest = self.sub_brep(&bulging)?;
            for face in rest.faces() {
                let Some(surface) = rest.parts().face_surface(face).filter(|_| rest.is_whole(face)) else {
                    continue;
                };
                for (k, axis) in axes.iter().enumerate() {
                    grow(k, surface.extent_along(*axis)?);
                }
            }
            let trimmed: Vec<usize> = (rest.faces().iter().enumerate())
                .filter(|(_, face)| !rest.is_whole(face))
                .map(|(place, _)| place)
                .collect();
            if !trimmed.is_empty() {
                let rest = rest.sub_brep(&trimmed)?;
                let mesh = rest.mesh(&settings)?;
                for face in mesh.faces() {
                    let Some(surface) = rest.face_surface(face.face) else { continue };
                    for (k, axis) in axes.iter().enumerate() {
                        for side in [*axis, -*axis] {
                            let height = |uv: [f64; 2]| surface.point_at(uv[0], uv[1]).to_vector().dot(side);
                            let all = face.parameters.iter().map(|p| [p.x, p.y]);
                            let best = all.max_by(|a, b| height(*a).total_cmp(&height(*b)));
                            let Some(best) = best else { continue };
                            let x = height(best).max(summit(surface, side, best, SAMPLED * size));
                            let x = if side == *axis { x } else { -x };
                            grow(k, Interval::new(x, x));
                        }
                    }
                }
            }
        }
        let origin = plane.origin.to_vector();
        if !ranges.iter().all(|r| r.is_finite()) {
            return Err(crate::Error::degenerate("brep", "it has no extent"));
        }
        let [x, y, z] = [0, 1, 2].map(|k: usize| {
            let (range, own) = (ranges[k], origin.dot(axes[k]));
            Interval::new(range.start - own, range.end - own)
        });
        Ok(Box3 { plane: *plane, x, y, z })
    }

    /// Whether a face may reach beyond its edges: it is not flat.
    fn may_bulge(&self, face: usize) -> bool {
        let live = self.faces().get(face).is_some_and(|face| !face.deleted);
        live && match self.face_surface(face) {
            None | Some(Surface::Plane(_)) => false,
            Some(surface) => surface.plane(0.0).is_none(),
        }
    }
}

/// The greatest height of a surface along a direction near some parameters, when there is one a little above.
fn summit(surface: &Surface, side: Vector3, start: [f64; 2], step: f64) -> f64 {
    let [u, v] = Direction::BOTH.map(|d| surface.domain(d));
    let height = |[a, b]: [f64; 2]| surface.point_at(a, b).to_vector().dot(side);
    let (low, mut at) = (height(start), start);
    for _ in 0..STEPS {
        let d = surface.derivatives(at[0], at[1], 2, Quadrant::default());
        let along = |i: usize, j: usize| d.get(i, j).dot(side);
        let (gu, gv) = (along(1, 0), along(0, 1));
        let (a, b, c) = (along(2, 0), along(1, 1), along(0, 2));
        let det = a * c - b * b;
        // Only towards a summit, where the height falls to all sides.
        if !(det > 0.0 && a < 0.0) {
            return low;
        }
        at = [u.clamp(at[0] - (c * gu - b * gv) / det), v.clamp(at[1] - (a * gv - b * gu) / det)];
    }
    let high = height(at);
    if high > low && high - low <= step { high } else { low }
}
