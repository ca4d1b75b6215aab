//! Which voxels geometry fills.

use katydid_component::{Context, Message};
use katydid_data::Value;
use katydid_geometry::{BoundingBox, Brep, Curve, Mesh, MeshSettings, Point3, Vector3};

use super::Voxels;

/// The places of curves are taken at so many steps a voxel: fewer could step over the corner of one.
const STEPS: f64 = 8.0;
/// The most places of one curve.
const MOST_PLACES: f64 = 1e7;
/// Rays go beside the centres by this part of a voxel, so that they do not run along edges of geometry made on the same
/// grid; no two parts are alike.
const BESIDE: [f64; 2] = [1.37e-5, 2.91e-5];
/// How far the meshes of round solids stray from them, as a part of the smallest side of a voxel.
const STRAY: f64 = 0.02;
/// A box that ends this near a centre, in voxels, has it: what lies nearer is rounding.
const ROUNDING: f64 = 1e-9;

/// Numbers of cells along an axis whose centres lie in a range that is counted in cells.
fn centres(from: f64, to: f64, count: usize) -> std::ops::Range<usize> {
    let last = count as f64;
    let first = (from - 0.5).ceil().clamp(0.0, last) as usize;
    let end = ((to - 0.5).floor() + 1.0).clamp(0.0, last) as usize;
    first..end.max(first)
}

impl Voxels {
    fn least_side(&self) -> f64 {
        self.size.x.min(self.size.y).min(self.size.z)
    }

    /// Fills what geometry fills.
    pub(super) fn fill(
        &mut self,
        context: &Context<'_>,
        value: &Value,
        distance: f64,
    ) -> Result<(), Message> {
        let rules = context.rules();
        let cast = |kind| katydid_data::cast::value(value, kind, rules);
        match value {
            Value::Point(p) => self.fill_point(*p, distance),
            Value::Box(shape) if distance == 0.0 => {
                let bounds = shape.bounding_box();
                self.fill_near(context, &bounds, |p| Ok(shape.contains(p, 0.0)))?;
            }
            Value::Mesh(mesh) => self.fill_mesh(context, mesh, distance)?,
            Value::Curve(curve) => self.fill_curve(context, curve, distance)?,
            Value::Line(_) | Value::Circle(_) | Value::Arc(_) | Value::Rectangle(_) => {
                if let Some(Value::Curve(curve)) = cast(katydid_data::Kind::Curve) {
                    self.fill_curve(context, &curve, distance)?;
                }
            }
            _ => match cast(katydid_data::Kind::Brep).and_then(|made| made.brep()) {
                Some(brep) => {
                    let brep = brep.map_err(Message::error)?;
                    self.fill_brep(context, &brep, distance)?;
                }
                None => match cast(katydid_data::Kind::Mesh) {
                    Some(Value::Mesh(mesh)) => self.fill_mesh(context, &mesh, distance)?,
                    _ => context.warn(format!("{} is not supported here: it fills nothing", value.kind())),
                },
            },
        }
        Ok(())
    }

    fn fill_point(&mut self, p: Point3, distance: f64) {
        if let Some(cell) = self.cell_of(p).and_then(|i| self.cells.get_mut(i)) {
            *cell = true;
        }
        if distance > 0.0 {
            let reach = Vector3::new(distance, distance, distance);
            let Some(bounds) = BoundingBox::from_points([p + reach, p - reach]) else { return };
            for place in self.places_in(&bounds) {
                let number = self.number(place);
                if self.centre(place).distance_to(p) <= distance
                    && let Some(cell) = self.cells.get_mut(number)
                {
                    *cell = true;
                }
            }
        }
    }

    /// The cells whose centres lie in a box along the world's axes, or beside it where the grid is turned.
    fn places_in(&self, bounds: &BoundingBox) -> Vec<[usize; 3]> {
        let corners = bounds.corners().map(|p| self.coordinates(p));
        let range = |axis: usize| {
            let along = || corners.iter().filter_map(|c| c.get(axis)).copied();
            let (from, to) =
                (along().fold(f64::INFINITY, f64::min), along().fold(f64::NEG_INFINITY, f64::max));
            centres(from - ROUNDING, to + ROUNDING, self.counts.get(axis).copied().unwrap_or(0))
        };
        let (x, y, z) = (range(0), range(1), range(2));
        z.flat_map(|k| {
            let x = x.clone();
            y.clone().flat_map(move |j| x.clone().map(move |i| [i, j, k]))
        })
        .collect()
    }

    /// Fills the cells near a box whose centres a test takes.
    fn fill_near(
        &mut self,
        context: &Context<'_>,
        bounds: &BoundingBox,
        takes: impl Fn(Point3) -> Result<bool, Message>,
    ) -> Result<(), Message> {
        for (n, place) in self.places_in(bounds).into_iter().enumerate() {
            if n % 4096 == 0 {
                context.check()?;
            }
            let number = self.number(place);
            let full = self.cells.get(number).copied().unwrap_or(true);
            if !full
                && takes(self.centre(place))?
                && let Some(cell) = self.cells.get_mut(number)
            {
                *cell = true;
            }
        }
        Ok(())
    }

    fn fill_brep(&mut self, context: &Context<'_>, brep: &Brep, distance: f64) -> Result<(), Message> {
        let settings = MeshSettings::within(self.least_side() * STRAY);
        let mesh = brep.mesh_unless(&settings, &context.stop())?.welded()?;
        self.fill_mesh(context, &mesh, distance)
    }

    fn fill_mesh(&mut self, context: &Context<'_>, mesh: &Mesh, distance: f64) -> Result<(), Message> {
        let Some(bounds) = mesh.bounding_box() else { return Ok(()) };
        if distance > 0.0 {
            let rays = katydid_geometry::MeshTree::new(mesh);
            return self.fill_near(context, &bounds.inflated(distance), |p| {
                Ok(rays.closest(p)?.distance <= distance)
            });
        }
        if !mesh.is_closed() {
            context.warn("An open mesh has no inside: it fills nothing without a distance");
            return Ok(());
        }
        let rays = katydid_geometry::MeshTree::new(mesh);
        let up = self.frame.plane.z_axis;
        let [columns, rows, layers] = self.counts;
        let corners = bounds.corners().map(|p| self.coordinates(p));
        let range = |axis: usize, count: usize| {
            let along = || corners.iter().filter_map(|c| c.get(axis)).copied();
            centres(along().fold(f64::INFINITY, f64::min), along().fold(f64::NEG_INFINITY, f64::max), count)
        };
        let [beside_x, beside_y] = BESIDE;
        for j in range(1, rows) {
            context.check()?;
            for i in range(0, columns) {
                let (x, y) = (i as f64 + 0.5 + beside_x, j as f64 + 0.5 + beside_y);
                let start = self.at([x, y, 0.0]);
                let hits = rays.line_hits(start, up, [f64::NEG_INFINITY, f64::INFINITY])?;
                let mut heights: Vec<f64> =
                    hits.iter().map(|hit| self.coordinates(hit.point)).map(|[_, _, z]| z).collect();
                heights.sort_by(f64::total_cmp);
                // A closed mesh is entered as often as it is left.
                for pair in heights.chunks_exact(2) {
                    let [from, to] = *pair else { continue };
                    for k in centres(from, to, layers) {
                        let number = self.number([i, j, k]);
                        if let Some(cell) = self.cells.get_mut(number) {
                            *cell = true;
                        }
                    }
                }
            }
        }
        Ok(())
    }

    fn fill_curve(&mut self, context: &Context<'_>, curve: &Curve, distance: f64) -> Result<(), Message> {
        if distance > 0.0 {
            let bounds = curve.bounding_box().inflated(distance);
            let nearest = katydid_geometry::ClosestOnCurve::new(curve);
            return self.fill_near(context, &bounds, |p| {
                Ok(nearest.nearest_within(p, distance)?.is_some_and(|found| found.distance <= distance))
            });
        }
        let steps = (curve.length() / self.least_side() * STEPS).ceil();
        if !(steps <= MOST_PLACES) {
            return Err(Message::error("The curve is too long for voxels as small as these"));
        }
        let parameters = curve.divide_by_count((steps as usize).max(1))?;
        for p in curve.points_at(&parameters).into_iter().chain([curve.end()]) {
            if let Some(cell) = self.cell_of(p).and_then(|i| self.cells.get_mut(i)) {
                *cell = true;
            }
        }
        Ok(())
    }
}
