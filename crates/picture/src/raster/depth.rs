//! The software renderer: a depth buffer with nine samples a pixel, a band of rows at a time.

use katydid_data::Colour;
use katydid_elementary::Elementary;
use tiny_skia::{Pixmap, PremultipliedColorU8};

use crate::drawing::{Corner, Face, Solids, SpaceLine};

/// Samples a pixel, each way.
const FINE: usize = 3;
/// Rows of pixels a band: with three samples and eight bytes each, a band of 16 384 pixels takes 76 MB.
const BAND: usize = 64;

/// A corner of a triangle in samples, with its colour.
#[derive(Clone, Copy)]
struct Spot {
    x: f64,
    y: f64,
    depth: f64,
    colour: [f64; 4],
}

struct Triangle {
    spots: [Spot; 3],
    plain: Option<[u8; 4]>,
}

/// The faces and lines on a clear ground.
pub(super) fn render(solids: &Solids, width: u32, height: u32) -> Option<Pixmap> {
    let mut pixels = Pixmap::new(width, height)?;
    let mut solid: Vec<Triangle> = Vec::new();
    let mut clear: Vec<(f64, &Face)> = Vec::new();
    for face in &solids.faces {
        if face.is_opaque() {
            triangles(face, &mut solid);
        } else {
            clear.push((face.depth(), face));
        }
    }
    solids.lines.iter().for_each(|line| ribbon(line, &mut solid));
    // What is clear is laid over what is not, the farthest first: lines behind it shine through.
    clear.sort_by(|a, b| a.0.total_cmp(&b.0));
    let mut glass = Vec::with_capacity(clear.len());
    clear.iter().for_each(|(_, face)| triangles(face, &mut glass));

    let (w, h) = (width as usize, height as usize);
    let mut band = Band { width: w * FINE, top: 0, rows: 0, depth: Vec::new(), colour: Vec::new() };
    let bands = h.div_ceil(BAND);
    let [solid_in, glass_in] = [&solid, &glass].map(|list| by_band(list, bands));
    for b in 0..bands {
        let rows = BAND.min(h - b * BAND);
        let (Some(first), Some(second)) = (solid_in.get(b), glass_in.get(b)) else { continue };
        if first.is_empty() && second.is_empty() {
            continue;
        }
        band.clear(b * BAND * FINE, rows * FINE);
        for &k in first {
            solid.get(k).into_iter().for_each(|triangle| band.fill(triangle, true));
        }
        for &k in second {
            glass.get(k).into_iter().for_each(|triangle| band.fill(triangle, false));
        }
        let out = pixels.pixels_mut().get_mut(b * BAND * w..(b * BAND + rows) * w)?;
        band.resolve(out, w);
    }
    Some(pixels)
}

/// For each band, the triangles that touch it, in order.
fn by_band(triangles: &[Triangle], bands: usize) -> Vec<Vec<usize>> {
    let mut lists = vec![Vec::new(); bands];
    let band = (BAND * FINE) as f64;
    for (k, triangle) in triangles.iter().enumerate() {
        let ys = triangle.spots.map(|s| s.y);
        let low = ys.iter().copied().fold(f64::INFINITY, f64::min);
        let high = ys.iter().copied().fold(f64::NEG_INFINITY, f64::max);
        if high < 0.0 {
            continue;
        }
        let (from, to) = ((low.max(0.0) / band) as usize, (high / band) as usize);
        lists.iter_mut().take(to.saturating_add(1)).skip(from).for_each(|list| list.push(k));
    }
    lists
}

fn spot(at: [f64; 3], c: Colour) -> Spot {
    let fine = FINE as f64;
    let colour = [c.r, c.g, c.b, c.a].map(f64::from);
    Spot { x: at[0] * fine, y: at[1] * fine, depth: at[2], colour }
}

/// A face as a fan of triangles.
fn triangles(face: &Face, out: &mut Vec<Triangle>) {
    let spots: Vec<Spot> = face.corners.iter().map(|Corner { at, colour }| spot(*at, *colour)).collect();
    if !spots.iter().all(|s| s.x.is_finite() && s.y.is_finite() && s.depth.is_finite()) {
        return;
    }
    let first = face.corners.first().map(|corner| corner.colour);
    let same = face.corners.iter().all(|corner| Some(corner.colour) == first);
    let plain = first.filter(|_| same).map(|c| [c.r, c.g, c.b, c.a]);
    // The colours of a quad run into one another alike along both diagonals.
    if plain.is_none() && spots.len() == 4 {
        let middle = middle(&spots);
        for (k, &a) in spots.iter().enumerate() {
            if let Some(&b) = spots.get((k + 1) % spots.len()) {
                out.push(Triangle { spots: [middle, a, b], plain });
            }
        }
        return;
    }
    let Some(&a) = spots.first() else { return };
    for pair in spots.get(1..).unwrap_or(&[]).windows(2) {
        let [b, c] = *pair else { continue };
        out.push(Triangle { spots: [a, b, c], plain });
    }
}

/// The mean of some places and their colours.
fn middle(spots: &[Spot]) -> Spot {
    let n = spots.len().max(1) as f64;
    let mean = |of: &dyn Fn(&Spot) -> f64| spots.iter().map(of).sum::<f64>() / n;
    Spot {
        x: mean(&|s| s.x),
        y: mean(&|s| s.y),
        depth: mean(&|s| s.depth),
        colour: [0, 1, 2, 3].map(|k| mean(&|s| s.colour.get(k).copied().unwrap_or(0.0))),
    }
}

/// A line as a ribbon that faces the viewer, with round ends and corners.
fn ribbon(line: &SpaceLine, out: &mut Vec<Triangle>) {
    let colour = Colour { a: 255, ..line.colour };
    let radius = 0.5 * line.width;
    let mut add = |corners: &[[f64; 3]]| {
        let corners = corners.iter().map(|&at| Corner { at, colour }).collect();
        triangles(&Face { corners, sign: true }, out);
    };
    for w in line.points.windows(2) {
        let [a, b] = *w else { continue };
        let (dx, dy) = (b[0] - a[0], b[1] - a[1]);
        let length = dx.hypotenuse(dy);
        if length > 0.0 {
            let (nx, ny) = (-dy / length * radius, dx / length * radius);
            let at = |p: [f64; 3], side: f64| [p[0] + side * nx, p[1] + side * ny, p[2]];
            add(&[at(a, 1.0), at(b, 1.0), at(b, -1.0), at(a, -1.0)]);
        }
    }
    // Thin lines have no corners to see.
    if line.width >= 0.8 {
        for p in &line.points {
            let disc: Vec<[f64; 3]> = (0..8)
                .map(|k| {
                    let (sin, cos) = (f64::from(k) * std::f64::consts::FRAC_PI_4).sine_cosine();
                    [p[0] + radius * cos, p[1] + radius * sin, p[2]]
                })
                .collect();
            add(&disc);
        }
    }
}

/// Some rows of samples.
struct Band {
    width: usize,
    top: usize,
    rows: usize,
    depth: Vec<f32>,
    /// Red, green, blue, times alpha; and alpha.
    colour: Vec<[u8; 4]>,
}

impl Band {
    fn clear(&mut self, top: usize, rows: usize) {
        (self.top, self.rows) = (top, rows);
        let n = rows * self.width;
        self.depth.clear();
        self.depth.resize(n, f32::NEG_INFINITY);
        self.colour.clear();
        self.colour.resize(n, [0; 4]);
    }

    /// Fills a triangle row by row: a sample belongs to it when its middle does, and to one of two neighbours only.
    fn fill(&mut self, triangle: &Triangle, opaque: bool) {
        let [a, b, c] = triangle.spots;
        let area = (b.x - a.x) * (c.y - a.y) - (c.x - a.x) * (b.y - a.y);
        if !(area.abs() > 1e-12) {
            return;
        }
        // How a quantity that has these values at the corners changes along x and along y.
        let slopes = |p: f64, q: f64, r: f64| {
            let (u, v) = (q - p, r - p);
            ((u * (c.y - a.y) - v * (b.y - a.y)) / area, (v * (b.x - a.x) - u * (c.x - a.x)) / area)
        };
        let depth = slopes(a.depth, b.depth, c.depth);
        let shades: [(f64, f64); 4] = [0, 1, 2, 3].map(|k| {
            if triangle.plain.is_some() { (0.0, 0.0) } else { slopes(a.colour[k], b.colour[k], c.colour[k]) }
        });
        let ys = [a.y, b.y, c.y];
        let low = ys.iter().copied().fold(f64::INFINITY, f64::min);
        let high = ys.iter().copied().fold(f64::NEG_INFINITY, f64::max);
        let first = ((low - 0.5).ceil().max(self.top as f64)) as usize;
        let end = ((high - 0.5).ceil().clamp(0.0, (self.top + self.rows) as f64)) as usize;
        for row in first..end {
            let y = row as f64 + 0.5;
            let (mut left, mut right) = (f64::INFINITY, f64::NEG_INFINITY);
            for (p, q) in [(a, b), (b, c), (c, a)] {
                if (p.y <= y) != (q.y <= y) {
                    // From the lower end always, so that neighbours find the same place.
                    let (p, q) = if p.y < q.y { (p, q) } else { (q, p) };
                    let x = p.x + (q.x - p.x) * ((y - p.y) / (q.y - p.y));
                    left = left.min(x);
                    right = right.max(x);
                }
            }
            if left > right {
                continue;
            }
            let from = (left - 0.5).ceil().max(0.0) as usize;
            let to = (right - 0.5).ceil().clamp(0.0, self.width as f64) as usize;
            let start = (row - self.top) * self.width;
            let (dx, dy) = (from as f64 + 0.5 - a.x, y - a.y);
            let mut z = a.depth + depth.0 * dx + depth.1 * dy;
            let mut shade = [0, 1, 2, 3].map(|k| a.colour[k] + shades[k].0 * dx + shades[k].1 * dy);
            let range = start + from.min(to)..start + to;
            let (Some(depths), Some(colours)) =
                (self.depth.get_mut(range.clone()), self.colour.get_mut(range))
            else {
                continue;
            };
            for (old, pixel) in depths.iter_mut().zip(colours) {
                if z as f32 >= *old {
                    let [r, g, b, alpha] = triangle.plain.unwrap_or_else(|| shade.map(|x| x as u8));
                    if opaque {
                        *old = z as f32;
                        *pixel = [r, g, b, 255];
                    } else {
                        *pixel = over([r, g, b], alpha, *pixel);
                    }
                }
                z += depth.0;
                if triangle.plain.is_none() {
                    (0..4).for_each(|k| shade[k] += shades[k].0);
                }
            }
        }
    }

    /// The mean of each pixel's samples.
    fn resolve(&self, out: &mut [PremultipliedColorU8], width: usize) {
        let samples = (FINE * FINE) as u32;
        for (row, pixels) in out.chunks_mut(width.max(1)).enumerate() {
            for (column, pixel) in pixels.iter_mut().enumerate() {
                let mut sum = [0_u32; 4];
                for j in 0..FINE {
                    let start = (row * FINE + j) * self.width + column * FINE;
                    for colour in self.colour.get(start..start + FINE).unwrap_or(&[]) {
                        sum.iter_mut().zip(colour).for_each(|(s, c)| *s += u32::from(*c));
                    }
                }
                let [r, g, b, a] = sum.map(|s| ((s + samples / 2) / samples) as u8);
                if let Some(colour) = PremultipliedColorU8::from_rgba(r.min(a), g.min(a), b.min(a), a) {
                    *pixel = colour;
                }
            }
        }
    }
}

/// A clear colour laid over what is there.
fn over(rgb: [u8; 3], alpha: u8, below: [u8; 4]) -> [u8; 4] {
    let a = u32::from(alpha);
    let mix = |top: u32, below: u8| ((top * a + u32::from(below) * (255 - a) + 127) / 255) as u8;
    let [r, g, b, old] = below;
    [mix(u32::from(rgb[0]), r), mix(u32::from(rgb[1]), g), mix(u32::from(rgb[2]), b), mix(255, old)]
}

#[cfg(test)]
mod tests {
    use super::*;

    fn face(corners: [[f64; 3]; 3], colour: Colour) -> Face {
        Face { corners: corners.map(|at| Corner { at, colour }).to_vec(), sign: false }
    }

    fn at(pixels: &Pixmap, x: u32, y: u32) -> [u8; 4] {
        let c = pixels.pixel(x, y).unwrap();
        [c.red(), c.green(), c.blue(), c.alpha()]
    }

    #[test]
    fn the_nearer_face_is_seen_whichever_comes_first() {
        let near = face([[0.0, 0.0, 2.0], [20.0, 0.0, 2.0], [0.0, 20.0, 2.0]], Colour::rgb(255, 0, 0));
        let far = face([[0.0, 0.0, 1.0], [20.0, 0.0, 1.0], [0.0, 20.0, 1.0]], Colour::rgb(0, 0, 255));
        for faces in [vec![near.clone(), far.clone()], vec![far, near]] {
            let pixels = render(&Solids { faces, lines: Vec::new() }, 20, 20).unwrap();
            assert_eq!(at(&pixels, 5, 5), [255, 0, 0, 255]);
            assert_eq!(at(&pixels, 19, 19), [0; 4]);
        }
    }

    #[test]
    fn neighbours_leave_no_gap_and_do_not_overlap() {
        let glass = Colour::argb(128, 0, 0, 0);
        let corners = [[0.0, 0.0, 0.0], [10.0, 0.3, 0.0], [9.7, 10.0, 0.0], [0.2, 9.9, 0.0]];
        let [a, b, c, d] = corners;
        let faces = vec![face([a, b, c], glass), face([a, c, d], glass)];
        let pixels = render(&Solids { faces, lines: Vec::new() }, 10, 10).unwrap();
        for k in 1..9 {
            assert_eq!(at(&pixels, k, k), [0, 0, 0, 128], "{k}");
        }
    }

    #[test]
    fn lines_behind_glass_shine_through_and_before_it_do_not() {
        let glass =
            face([[0.0, 0.0, 1.0], [40.0, 0.0, 1.0], [0.0, 40.0, 1.0]], Colour::argb(128, 255, 255, 255));
        let line = |depth| SpaceLine {
            points: vec![[0.0, 5.0, depth], [20.0, 5.0, depth]],
            colour: Colour::rgb(0, 0, 0),
            width: 4.0,
        };
        let seen = |depth| {
            at(
                &render(&Solids { faces: vec![glass.clone()], lines: vec![line(depth)] }, 20, 20).unwrap(),
                10,
                5,
            )
        };
        assert_eq!(seen(2.0), [0, 0, 0, 255]);
        assert_eq!(seen(0.0), [128, 128, 128, 255]);
    }
}
