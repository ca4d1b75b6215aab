//! Grid, axes and legends.

use katydid_data::Colour;
use katydid_elementary::Elementary;
use katydid_geometry::{BoundingBox, Point3, Vector3};

use super::Canvas;
use crate::camera::View;
use crate::drawing::{Anchor, Item, Label, Path, Shape, blend};
use crate::{Options, font};
use katydid_scene::Legend;

pub(super) const RED: Colour = Colour::rgb(199, 48, 38);
pub(super) const GREEN: Colour = Colour::rgb(44, 138, 58);
const BLUE: Colour = Colour::rgb(46, 96, 196);
/// The colours and letters of x, y and z.
const AXES: [(Colour, &str); 3] = [(RED, "x"), (GREEN, "y"), (BLUE, "z")];

/// Cells of a grid along its longer side, about.
const CELLS: f64 = 14.0;
/// Lines on the world plane of the view, around everything, and the axes through the origin where they are near. They
/// lie below all else: a ground to measure on, not a part of the model.
pub(super) fn grid(canvas: &Canvas, view: View, points: &[Point3], options: &Options) -> Vec<Item> {
    let plane = view.grid_axes();
    let coordinates = |p: Point3| {
        let all = [p.x, p.y, p.z];
        plane.map(|axis| all.get(axis).copied().unwrap_or(0.0))
    };
    let mut items = Vec::new();
    let Some(bounds) = BoundingBox::from_points(points.iter().copied()) else { return items };
    let (min, max) = (coordinates(bounds.min), coordinates(bounds.max));
    let extent = f64::max(max[0] - min[0], max[1] - min[1]);
    let extent = if extent > 0.0 { extent } else { bounds.diagonal().length().max(1.0) };
    let step = round_step(extent / CELLS);
    let ends = [0, 1].map(|k| [(min[k] / step).floor() - 1.0, (max[k] / step).ceil() + 1.0]);
    let at = |u: f64, v: f64| {
        let mut p = [0.0; 3];
        plane.iter().zip([u * step, v * step]).for_each(|(axis, x)| p[*axis] = x);
        Point3::from(p)
    };
    let [[u0, u1], [v0, v1]] = ends;
    // Far from the origin a step may be less than the numbers can tell apart.
    if !(u0 + 1.0 > u0 && v0 + 1.0 > v0) || u1 - u0 > 200.0 || v1 - v0 > 200.0 {
        return items;
    }
    let add = |path: &mut Path, a: Point3, b: Point3| {
        for part in canvas.camera.polyline(&[a, b]) {
            path.add_polyline(part.iter().map(|p| [p[0], p[1]]));
        }
    };
    if options.grid {
        // Every fifth line is stronger.
        for (strong, strength) in [(false, 0.09), (true, 0.2)] {
            let mut path = Path::default();
            for (from, to, is_u) in [(u0, u1, true), (v0, v1, false)] {
                let places = (0..=((to - from) as u32)).map(|k| from + f64::from(k));
                for x in places.filter(|x| (x % 5.0 == 0.0) == strong) {
                    let (a, b) = if is_u { (at(x, v0), at(x, v1)) } else { (at(u0, x), at(u1, x)) };
                    add(&mut path, a, b);
                }
            }
            items.push(Shape::stroked(path, blend(canvas.ground, canvas.ink, strength), 0.8).into());
        }
    }
    if options.axes {
        let [first, second] = plane.map(|axis| AXES.get(axis).map_or(RED, |a| a.0));
        let near = |low: f64, high: f64| low <= 0.0 && high >= 0.0;
        for (a, b, colour, near) in [
            (at(u0, 0.0), at(u1, 0.0), first, near(v0, v1)),
            (at(0.0, v0), at(0.0, v1), second, near(u0, u1)),
        ] {
            let mut path = Path::default();
            add(&mut path, a, b);
            if near {
                items.push(Shape::stroked(path, blend(canvas.ground, colour, 0.65), 1.2).into());
            }
        }
    }
    items
}

/// 1, 2 or 5 times a power of ten, not less than `x`.
fn round_step(x: f64) -> f64 {
    let power = 10.0_f64.raised_to(x.logarithm_10().floor());
    let step = [1.0, 2.0, 5.0].map(|k| k * power).into_iter().find(|step| *step >= x * (1.0 - 1e-9));
    step.unwrap_or(10.0 * power)
}

/// The world's directions, in the corner.
pub(super) fn triad(canvas: &mut Canvas) {
    const LENGTH: f64 = 26.0;
    let origin = [40.0, canvas.size[1] - 40.0];
    let mut arms: Vec<([f64; 3], (Colour, &str))> = [Vector3::X, Vector3::Y, Vector3::Z]
        .into_iter()
        .map(|v| canvas.camera.direction(v))
        .zip(AXES)
        .filter(|([x, y, _], _)| x.hypotenuse(*y) > 0.05)
        .collect();
    // The one that comes nearest is on top.
    arms.sort_by(|a, b| a.0[2].total_cmp(&b.0[2]));
    let mut items = Vec::new();
    for ([x, y, _], (colour, letter)) in arms {
        let at = |k: f64| [origin[0] + k * LENGTH * x, origin[1] + k * LENGTH * y];
        items.push(Shape::stroked(Path::polyline([origin, at(1.0)]), colour, 1.8).into());
        let reach = x.hypotenuse(y);
        let [u, v] = [x / reach, y / reach];
        let tip = at(1.0);
        let head = [
            [tip[0] + 6.0 * u, tip[1] + 6.0 * v],
            [tip[0] - 3.0 * v, tip[1] + 3.0 * u],
            [tip[0] + 3.0 * v, tip[1] - 3.0 * u],
        ];
        items.push(Shape::filled(Path::polygon(head), colour).into());
        let place = [tip[0] + 12.0 * u, tip[1] + 12.0 * v + 4.0];
        items.push(Label::new(place, letter, 12.0, colour).anchored(Anchor::Middle).into());
    }
    canvas.above.push(Item::Group("Axes".to_owned(), items));
}

/// The legends, one below the other along the right side. Those of gradients only where they are asked for.
pub(super) fn legends(canvas: &mut Canvas, legends: &[Legend], scales: bool) {
    const SIZE: f64 = 11.0;
    let right = canvas.size[0] - 14.0;
    let mut top = 16.0;
    for legend in legends {
        let mut items: Vec<Item> = Vec::new();
        match legend {
            Legend::List(entries) => {
                for (colour, text) in entries {
                    let swatch = Path::rectangle([right - 14.0, top, 14.0, 14.0]);
                    items.push(Shape::filled(swatch, *colour).outlined(canvas.ink, 0.5).into());
                    items.push(text_left_of(canvas, text, [right - 20.0, top + 11.0], SIZE));
                    top += 18.0;
                }
            }
            Legend::Scale { name, grips, low, high } if scales => {
                let height = (0.45 * canvas.size[1]).min(180.0);
                if !name.is_empty() {
                    items.push(text_left_of(canvas, name, [right, top + 9.0], SIZE));
                    top += 16.0;
                }
                let rows = 64;
                for row in 0..rows {
                    let at = 1.0 - (f64::from(row) + 0.5) / f64::from(rows);
                    let (y, h) = (top + height * f64::from(row) / f64::from(rows), height / f64::from(rows));
                    // A little higher than it is, so that no ground shines through.
                    let bar = Path::rectangle([right - 14.0, y, 14.0, h + 0.4]);
                    items.push(Shape::filled(bar, gradient(grips, at)).into());
                }
                let frame = Path::rectangle([right - 14.0, top, 14.0, height]);
                items.push(Shape::stroked(frame, canvas.ink, 0.7).into());
                items.push(text_left_of(canvas, high, [right - 20.0, top + 9.0], SIZE));
                items.push(text_left_of(canvas, low, [right - 20.0, top + height], SIZE));
                top += height + 18.0;
            }
            Legend::Scale { .. } => {}
        }
        if !items.is_empty() {
            canvas.above.push(Item::Group("Legend".to_owned(), items));
            top += 8.0;
        }
    }
}

fn text_left_of(canvas: &Canvas, text: &str, at: [f64; 2], size: f64) -> Item {
    let text = font::fitted(text, size, 0.5 * canvas.size[0]);
    let halo = Colour { a: 210, ..canvas.ground };
    Label::new(at, text, size, canvas.ink).anchored(Anchor::End).with_halo(halo).into()
}

/// The colour of a gradient at a place from 0 to 1.
pub(crate) fn gradient(grips: &[(f64, Colour, Colour)], at: f64) -> Colour {
    let before = grips.iter().filter(|grip| grip.0 <= at).max_by(|a, b| a.0.total_cmp(&b.0));
    let behind = grips.iter().filter(|grip| grip.0 > at).min_by(|a, b| a.0.total_cmp(&b.0));
    match (before, behind) {
        (Some(a), Some(b)) => blend(a.2, b.1, (at - a.0) / (b.0 - a.0)),
        (Some(one), None) => one.2,
        (None, Some(one)) => one.1,
        (None, None) => Colour::rgb(128, 128, 128),
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn steps_are_round() {
        assert_eq!([0.7, 1.0, 1.1, 3.0, 7.0, 0.03].map(round_step), [1.0, 1.0, 2.0, 5.0, 10.0, 0.05]);
    }

    #[test]
    fn gradients_run_between_grips() {
        let (black, white) = (Colour::rgb(0, 0, 0), Colour::rgb(255, 255, 255));
        let grips = [(0.0, black, black), (1.0, white, white)];
        assert_eq!(gradient(&grips, 0.2), Colour::rgb(51, 51, 51));
        assert_eq!((gradient(&grips, -1.0), gradient(&grips, 2.0)), (black, white));
    }
}
