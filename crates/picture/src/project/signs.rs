//! Signs of one size on the picture: crosses, dots, symbols, heads of arrows. They have the depth of their place.

use katydid_data::{Colour, Symbol};
use katydid_elementary::Elementary;
use katydid_geometry::{Plane, Point3, Vector3};

use super::{BEFORE, Canvas, PLANE};
use crate::camera::Camera;
use crate::drawing::{Corner, Face, SpaceLine};
use katydid_scene::Form;

/// The arms of a cross, in pixels.
const ARM: f64 = 4.0;
/// The length and half the width of an arrow's head, in pixels, for a line of width 1.5.
const HEAD: [f64; 2] = [11.0, 4.0];
/// No dot is smaller or larger on the picture than this, in pixels.
const DOT: [f64; 2] = [1.5, 400.0];
/// An arrow shorter than this in space, in pixels, has no direction that could be seen.
const SHORT: f64 = 3.0;
/// No symbol has a larger radius on the picture, in pixels.
const SYMBOL: f64 = 500.0;

/// The corners of a plane's square.
pub(super) fn corners(camera: &Camera, plane: &Plane, sign_size: f64) -> [Point3; 4] {
    let r = PLANE * sign_size * camera.unit(plane.origin);
    [(-1.0, -1.0), (1.0, -1.0), (1.0, 1.0), (-1.0, 1.0)].map(|(u, v)| plane.at(u * r, v * r, 0.0))
}

/// Adds how far a sign of one size on the picture reaches, as points of the model.
pub(super) fn reach(camera: &Camera, form: &Form, sign_size: f64, out: &mut Vec<Point3>) {
    match form {
        Form::Plane(plane) => out.extend(corners(camera, plane, sign_size).iter().filter(|p| p.is_finite())),
        Form::Symbol(p, symbol) => {
            let r = 0.5 * symbol.size[0];
            // A symbol that fills the picture leaves no room to step back to.
            if p.is_finite() && r.is_finite() && r > 0.0 {
                out.extend(camera.around(*p, r.min(0.2 * SYMBOL)));
            }
        }
        _ => {}
    }
}

impl Canvas {
    pub(super) fn cross(&mut self, p: Point3, colour: Colour, width: f64) {
        let Some([x, y, z]) = self.camera.project(p) else { return };
        let arm = ARM * self.sign_size;
        for (dx, dy) in [(arm, arm), (arm, -arm)] {
            let at = |s: f64| [x + s * dx, y + s * dy, z + 2.0 * BEFORE];
            self.stroke(vec![at(-1.0), at(1.0)], colour, width);
        }
    }

    /// A line in the space of the picture.
    fn stroke(&mut self, points: Vec<[f64; 3]>, colour: Colour, width: f64) {
        let colour = self.solid(colour);
        self.solids.lines.push(SpaceLine { points, colour, width });
    }

    /// A flat outline that faces the viewer.
    fn sign(&mut self, corners: impl IntoIterator<Item = [f64; 3]>, colour: Colour) {
        let corners = corners.into_iter().map(|at| Corner { at, colour }).collect();
        self.solids.faces.push(Face { corners, sign: true });
    }

    fn disc(&mut self, [x, y, z]: [f64; 3], radius: f64, colour: Colour) {
        self.sign(ring(20).map(|[c, s]| [x + radius * c, y + radius * s, z]), colour);
    }

    pub(super) fn dot(&mut self, p: Point3, size: f64, colour: Colour) {
        let Some([x, y, z]) = self.camera.project(p) else { return };
        let pixels = (size / self.camera.unit(p)).clamp(DOT[0], DOT[1]);
        if pixels.is_finite() {
            self.disc([x, y, z + 2.0 * BEFORE], 0.5 * pixels, colour);
        }
    }

    pub(super) fn arrow(&mut self, from: Point3, along: Vector3, colour: Colour, width: f64) {
        let tip = from + along;
        let parts = self.camera.polyline(&[from, tip]);
        let (Some([a, b]), Some(end)) =
            (parts.first().and_then(|p| p.first_chunk::<2>()), self.camera.project(tip))
        else {
            return;
        };
        let [a, b] = [*a, *b].map(|p| [p[0], p[1], p[2] + BEFORE]);
        let (dx, dy) = (b[0] - a[0], b[1] - a[1]);
        let length = dx.hypotenuse(dy);
        if along.length() < SHORT * self.camera.unit(tip) {
            self.stroke(vec![a, b], colour, width);
            return;
        }
        if length < 1.0 {
            // Seen along its direction: a dot in a ring comes to the viewer, a ring with a cross goes away.
            let z = end[2] + 2.0 * BEFORE;
            let mut ring: Vec<[f64; 3]> =
                ring(24).map(|[c, s]| [b[0] + 5.0 * c, b[1] + 5.0 * s, z]).collect();
            ring.extend(ring.first().copied());
            self.stroke(ring, colour, width);
            if self.camera.direction(along)[2] > 0.0 {
                self.disc([b[0], b[1], z], 1.8, colour);
            } else {
                for s in [1.0, -1.0] {
                    self.stroke(
                        vec![[b[0] - 3.0, b[1] - 3.0 * s, z], [b[0] + 3.0, b[1] + 3.0 * s, z]],
                        colour,
                        width,
                    );
                }
            }
            return;
        }
        let scale = self.head_size(width).min(0.6 * length / HEAD[0]);
        let (ux, uy) = (dx / length, dy / length);
        let back = (HEAD[0] * scale / length).min(1.0);
        let base = [0, 1, 2].map(|k| b[k] - (b[k] - a[k]) * back);
        let side =
            |s: f64| [base[0] - s * uy * HEAD[1] * scale, base[1] + s * ux * HEAD[1] * scale, base[2] + 0.5];
        let shaft = [0, 1, 2].map(|k| b[k] - (b[k] - a[k]) * back * 0.8);
        self.stroke(vec![a, shaft], colour, width);
        let colour = self.solid(colour);
        self.sign([[b[0], b[1], b[2] + 0.5], side(1.0), side(-1.0)], colour);
    }

    /// How large the head of an arrow is, over its full size.
    fn head_size(&self, width: f64) -> f64 {
        (self.sign_size.max(0.75) * width / 1.5).clamp(0.6, 4.0)
    }

    /// The head of an arrow alone; none where there is no room for one.
    pub(super) fn tip(&mut self, at: Point3, way: Vector3, colour: Colour, width: f64) {
        let (Some(a), Some(b)) = (self.camera.project(at - way), self.camera.project(at)) else { return };
        let length = (b[0] - a[0]).hypotenuse(b[1] - a[1]);
        let scale = self.head_size(width).min(length / HEAD[0]);
        if !(scale > 0.2) {
            return;
        }
        let [ux, uy] = [(b[0] - a[0]) / length, (b[1] - a[1]) / length];
        let (long, wide) = (HEAD[0] * scale, HEAD[1] * scale);
        let z = b[2] + BEFORE + 0.5;
        let side = |s: f64| [b[0] - ux * long - s * uy * wide, b[1] - uy * long + s * ux * wide, z];
        let colour = self.solid(colour);
        self.sign([[b[0], b[1], z], side(1.0), side(-1.0)], colour);
    }

    pub(super) fn symbol(&mut self, p: Point3, symbol: &Symbol) {
        let Some([x, y, z]) = self.camera.project(p) else { return };
        let z = z + 2.0 * BEFORE;
        let r = 0.5 * symbol.size[0];
        if !(r.is_finite() && r > 0.0) {
            return;
        }
        let r = r.min(SYMBOL);
        let turned = |u: f64, v: f64| {
            let (sin, cos) = symbol.rotation.sine_cosine();
            [x + r * (u * cos - v * sin), y + r * (u * sin + v * cos), z]
        };
        let square = |r: f64, nearer: f64| {
            [[-r, -r], [r, -r], [r, r], [-r, r]].map(|[u, v]| {
                let [x, y, z] = turned(u, v);
                [x, y, z + nearer]
            })
        };
        match symbol.style {
            // Rhino's points: plain, of a border, and of a border with a core.
            0 => return self.sign(square(1.0, 0.0), symbol.fill),
            1 | 2 => {
                self.sign(square(1.0, 0.0), symbol.edge);
                self.sign(square(0.7, 0.2), self.ground);
                if symbol.style == 2 {
                    self.sign(square(0.4, 0.4), symbol.fill);
                }
                return;
            }
            _ => {}
        }
        let outline: Vec<[f64; 3]> = match symbol.style {
            // Crosses of two kinds have no inside.
            3 | 6 => {
                let arms =
                    if symbol.style == 3 { [[1.0, 1.0], [1.0, -1.0]] } else { [[1.0, 0.0], [0.0, 1.0]] };
                for [u, v] in arms {
                    let points = vec![turned(-u, -v), turned(u, v)];
                    self.stroke(points, symbol.edge, symbol.width.clamp(1.0, 50.0));
                }
                return;
            }
            4 | 5 | 9 | 10 => ring(24).map(|[c, s]| turned(c, s)).collect(),
            7 => [[0.0, -1.0], [0.87, 0.5], [-0.87, 0.5]].map(|[u, v]| turned(u, v)).to_vec(),
            8 => heart().into_iter().map(|[u, v]| turned(u, v)).collect(),
            _ => [[-1.0, -1.0], [1.0, -1.0], [1.0, 1.0], [-1.0, 1.0]].map(|[u, v]| turned(u, v)).to_vec(),
        };
        // A heart is not convex: its middle and each side are faces of their own.
        let middle = turned(0.0, 0.0);
        if symbol.style == 8 {
            for w in outline.windows(2) {
                self.sign([middle, w[0], w[1]], symbol.fill);
            }
            self.sign(
                [middle].into_iter().chain(outline.last().copied()).chain(outline.first().copied()),
                symbol.fill,
            );
        } else {
            self.sign(outline.iter().copied(), symbol.fill);
        }
        if symbol.width > 0.0 {
            let closed = outline.iter().chain(outline.first()).map(|p| [p[0], p[1], p[2] + 0.5]).collect();
            self.stroke(closed, symbol.edge, symbol.width.clamp(0.3, 50.0));
        }
    }
}

/// Cosine and sine around a circle.
fn ring(n: u32) -> impl Iterator<Item = [f64; 2]> {
    (0..n).map(move |k| {
        let (sin, cos) = (std::f64::consts::TAU * f64::from(k) / f64::from(n)).sine_cosine();
        [cos, sin]
    })
}

/// A heart of about size 1 around the middle, star-shaped from there, y down.
fn heart() -> Vec<[f64; 2]> {
    (0..24)
        .map(|k| {
            let t = std::f64::consts::TAU * f64::from(k) / 24.0;
            let x = t.sine().powi(3);
            let y =
                13.0 * t.cosine() - 5.0 * (2.0 * t).cosine() - 2.0 * (3.0 * t).cosine() - (4.0 * t).cosine();
            [x, -y / 16.0]
        })
        .collect()
}
