//! Which stretches of lines lie behind faces: each line is held against the faces that it crosses on the picture.

use katydid_elementary::Elementary;

use crate::drawing::{Face, Solids, SpaceLine};

/// The least and the greatest side of the cells of the index over the picture, in pixels.
const CELL: [f64; 2] = [3.0, 24.0];
/// There are about so many times more faces than cells.
const FACES_A_CELL: f64 = 8.0;
/// The index has no more cells than this in each direction.
const MOST_CELLS: f64 = 512.0;
/// Stretches shorter than this, in pixels, take the kind of what is beside them.
const SHORTEST: f64 = 2.0;

/// A face hides what lies beside it by less than this, in pixels: lines along the side of two faces are behind both.
const RIM: f64 = 0.01;
/// What is no farther behind the plane of a face than this, in pixels, lies on it.
const ON: f64 = 0.5;

/// A line that is no longer than this on the picture, in pixels, is a part of a sign, such as a cross: seen or hidden
/// as a whole.
const SIGN: f64 = 16.0;

/// The lines in stretches: those that nothing lies before, and those behind a face, clear or not. Lines are drawn
/// `nearer` than where they are.
pub(crate) fn part(solids: &Solids, nearer: f64) -> [Vec<SpaceLine>; 2] {
    let Some(index) = Index::new(&solids.faces) else { return [solids.lines.clone(), Vec::new()] };
    let [mut seen, mut hidden] = [Vec::new(), Vec::new()];
    let mut looked_at = vec![0_usize; index.covers.len()];
    let mut turn = 0;
    for line in &solids.lines {
        // The kind of the stretch before, so that a dash runs on round a corner.
        let mut last = None;
        let short = is_short(line);
        let mut lengths = [0.0; 2];
        for w in line.points.windows(2) {
            let [a, b] = *w else { continue };
            turn += 1;
            let mut behind = Vec::new();
            index.each_near(a, b, |k, cover| {
                if let Some(mark) = looked_at.get_mut(k)
                    && *mark != turn
                {
                    *mark = turn;
                    let at = |p: [f64; 3]| [p[0], p[1], p[2] - nearer];
                    behind.extend(cover.hides(at(a), at(b)));
                }
            });
            let length = (b[0] - a[0]).hypotenuse(b[1] - a[1]);
            for (from, to, is_hidden) in stretches(behind, SHORTEST / length.max(SHORTEST)) {
                if short {
                    lengths[usize::from(is_hidden)] += (to - from) * length;
                    continue;
                }
                let at = |t: f64| [0, 1, 2].map(|k| a[k] + (b[k] - a[k]) * t);
                let list = if is_hidden { &mut hidden } else { &mut seen };
                match list.last_mut() {
                    Some(SpaceLine { points, .. }) if last == Some(is_hidden) => points.push(at(to)),
                    _ => list.push(SpaceLine { points: vec![at(from), at(to)], ..*line }),
                }
                last = Some(is_hidden);
            }
        }
        if short {
            let list = if lengths[1] > lengths[0] { &mut hidden } else { &mut seen };
            list.push(line.clone());
        }
    }
    [seen, hidden]
}

/// Whether a line is a part of a sign.
pub(crate) fn is_short(line: &SpaceLine) -> bool {
    let length = |w: &[[f64; 3]]| match w {
        [a, b] => (b[0] - a[0]).hypotenuse(b[1] - a[1]),
        _ => 0.0,
    };
    line.points.windows(2).map(length).sum::<f64>() <= SIGN
}

/// The way from 0 to 1 in stretches in turn: where they begin and end, and whether they are hidden.
fn stretches(mut behind: Vec<[f64; 2]>, shortest: f64) -> Vec<(f64, f64, bool)> {
    behind.sort_by(|a, b| a[0].total_cmp(&b[0]));
    let mut joined: Vec<[f64; 2]> = Vec::new();
    for [from, to] in behind {
        match joined.last_mut() {
            Some(last) if from <= last[1] + shortest => last[1] = last[1].max(to),
            _ => joined.push([from, to]),
        }
    }
    joined.retain(|[from, to]| to - from > shortest.min(0.5));
    let mut out = Vec::new();
    let mut at = 0.0;
    for [from, to] in joined {
        let from = if from <= shortest { 0.0 } else { from };
        let to = if to >= 1.0 - shortest { 1.0 } else { to };
        if from > at {
            out.push((at, from, false));
        }
        out.push((from, to, true));
        at = to;
    }
    if at < 1.0 {
        out.push((at, 1.0, false));
    }
    out
}

/// A face as what it covers.
struct Cover<'a> {
    face: &'a Face,
    /// 1 where its corners run one way round on the picture, -1 for the other.
    sense: f64,
    /// How much it faces the viewer: 1 wholly, 0 not at all.
    facing: f64,
    /// Its depth: a constant, and how it grows along x and y.
    depth: [f64; 3],
}

impl<'a> Cover<'a> {
    /// `None` for a sign, and for a face that is seen from the edge.
    fn new(face: &'a Face) -> Option<Self> {
        let finite = face.corners.iter().all(|corner| corner.at.iter().all(|x| x.is_finite()));
        let first = face.corners.first().filter(|_| !face.sign && finite)?.at;
        // Newell's normal, from the first corner on.
        let mut n = [0.0; 3];
        for (k, corner) in face.corners.iter().enumerate() {
            let next = face.corners.get((k + 1) % face.corners.len())?.at;
            let (a, b) = (minus(corner.at, first), minus(next, first));
            n = [
                n[0] + a[1] * b[2] - a[2] * b[1],
                n[1] + a[2] * b[0] - a[0] * b[2],
                n[2] + a[0] * b[1] - a[1] * b[0],
            ];
        }
        let length = n.iter().map(|x| x * x).sum::<f64>().sqrt();
        if !(n[2].abs() > 1e-6 * length) {
            return None;
        }
        let (dx, dy) = (-n[0] / n[2], -n[1] / n[2]);
        let depth = [first[2] - dx * first[0] - dy * first[1], dx, dy];
        Some(Self { face, sense: n[2].signum(), facing: n[2].abs() / length, depth })
    }

    fn depth_at(&self, p: [f64; 3]) -> f64 {
        self.depth[0] + self.depth[1] * p[0] + self.depth[2] * p[1]
    }

    /// The part of the way from `a` to `b` that is behind the face.
    fn hides(&self, a: [f64; 3], b: [f64; 3]) -> Option<[f64; 2]> {
        let mut range = [0.0, 1.0];
        let corners = &self.face.corners;
        for (k, corner) in corners.iter().enumerate() {
            let (p, q) = (corner.at, corners.get((k + 1) % corners.len())?.at);
            let rim = RIM * (q[0] - p[0]).hypotenuse(q[1] - p[1]);
            let left = |x: [f64; 3]| (q[0] - p[0]) * (x[1] - p[1]) - (q[1] - p[1]) * (x[0] - p[0]);
            let inside = |x: [f64; 3]| self.sense * left(x) + rim;
            range = cut(range, inside(a), inside(b))?;
        }
        let behind = |p: [f64; 3]| self.facing * (self.depth_at(p) - p[2]) - ON;
        cut(range, behind(a), behind(b))
    }
}

fn minus(a: [f64; 3], b: [f64; 3]) -> [f64; 3] {
    [a[0] - b[0], a[1] - b[1], a[2] - b[2]]
}

/// The part of a range in which a quantity that goes evenly from `x` to `y` is above 0.
fn cut([from, to]: [f64; 2], x: f64, y: f64) -> Option<[f64; 2]> {
    let zero = x / (x - y);
    let range = match (x > 0.0, y > 0.0) {
        (true, true) => [from, to],
        (true, false) => [from, to.min(zero)],
        (false, true) => [from.max(zero), to],
        (false, false) => return None,
    };
    (range[0] < range[1]).then_some(range)
}

/// The faces by the cells of the picture that they lie in.
struct Index<'a> {
    covers: Vec<Cover<'a>>,
    cells: Vec<Vec<usize>>,
    low: [f64; 2],
    side: f64,
    count: [usize; 2],
}

impl<'a> Index<'a> {
    /// `None` where no face covers anything.
    fn new(faces: &'a [Face]) -> Option<Self> {
        let covers: Vec<Cover<'a>> = faces.iter().filter_map(Cover::new).collect();
        let [mut low, mut high] = [[f64::INFINITY; 2], [f64::NEG_INFINITY; 2]];
        for p in covers.iter().flat_map(|cover| &cover.face.corners) {
            low = [0, 1].map(|k| low[k].min(p.at[k]));
            high = [0, 1].map(|k| high[k].max(p.at[k]));
        }
        let size = f64::max(high[0] - low[0], high[1] - low[1]);
        if !size.is_finite() {
            return None;
        }
        let area = (high[0] - low[0]) * (high[1] - low[1]);
        let side = (area * FACES_A_CELL / covers.len() as f64).sqrt().clamp(CELL[0], CELL[1]);
        let side = side.max(size / MOST_CELLS);
        let count = [0, 1].map(|k| ((high[k] - low[k]) / side) as usize + 1);
        let mut index = Self { covers, cells: vec![Vec::new(); count[0] * count[1]], low, side, count };
        for k in 0..index.covers.len() {
            let Some(cover) = index.covers.get(k) else { continue };
            let range = |i: usize| {
                let places = cover.face.corners.iter().map(|corner| corner.at[i]);
                let [a, b] =
                    places.fold([f64::INFINITY, f64::NEG_INFINITY], |[a, b], x| [a.min(x), b.max(x)]);
                (index.cell(i, a), index.cell(i, b))
            };
            let ((x0, x1), (y0, y1)) = (range(0), range(1));
            for cell in (y0..=y1).flat_map(|y| (x0..=x1).map(move |x| (x, y))).map(|(x, y)| y * count[0] + x)
            {
                index.cells.get_mut(cell).into_iter().for_each(|list| list.push(k));
            }
        }
        Some(index)
    }

    /// The column, or row, of a place; the nearest for one beside the index.
    fn cell(&self, axis: usize, x: f64) -> usize {
        // `as` takes what is below 0, and NaN, to 0.
        (((x - self.low[axis]) / self.side) as usize).min(self.count[axis] - 1)
    }

    /// The faces in the cells along a line; some of them more than once.
    fn each_near(&self, a: [f64; 3], b: [f64; 3], mut see: impl FnMut(usize, &Cover<'a>)) {
        let (y0, y1) = (self.cell(1, a[1].min(b[1])), self.cell(1, a[1].max(b[1])));
        for y in y0..=y1 {
            // The part of the line in this row of cells.
            let edge = |row: usize| self.low[1] + self.side * row as f64;
            let x_at = |height: f64| {
                let t = if a[1] == b[1] { 0.0 } else { ((height - a[1]) / (b[1] - a[1])).clamp(0.0, 1.0) };
                a[0] + (b[0] - a[0]) * t
            };
            let ends = if a[1] == b[1] { [a[0], b[0]] } else { [x_at(edge(y)), x_at(edge(y + 1))] };
            let (x0, x1) = (self.cell(0, ends[0].min(ends[1])), self.cell(0, ends[0].max(ends[1])));
            for cell in (x0..=x1).map(|x| y * self.count[0] + x) {
                for &k in self.cells.get(cell).into_iter().flatten() {
                    self.covers.get(k).into_iter().for_each(|cover| see(k, cover));
                }
            }
        }
    }
}

#[cfg(test)]
mod tests {
    use katydid_data::Colour;

    use super::*;
    use crate::drawing::Corner;

    fn face(corners: &[[f64; 3]]) -> Face {
        let corners = corners.iter().map(|&at| Corner { at, colour: Colour::argb(90, 9, 9, 9) }).collect();
        Face { corners, sign: false }
    }

    fn line(points: &[[f64; 3]]) -> SpaceLine {
        SpaceLine { points: points.to_vec(), colour: Colour::rgb(0, 0, 0), width: 1.0 }
    }

    fn ends(lines: &[SpaceLine]) -> Vec<[f64; 2]> {
        let x = |p: Option<&[f64; 3]>| p.map_or(f64::NAN, |p| (p[0] * 10.0).round() / 10.0);
        lines.iter().map(|line| [x(line.points.first()), x(line.points.last())]).collect()
    }

    #[test]
    fn what_is_behind_a_face_is_told_either_way_round() {
        let square = [[20.0, 0.0, 5.0], [60.0, 0.0, 5.0], [60.0, 90.0, 5.0], [20.0, 90.0, 5.0]];
        let mut turned = square;
        turned.reverse();
        for square in [square, turned] {
            let behind = line(&[[0.0, 40.0, 0.0], [100.0, 50.0, 0.0]]);
            let before = line(&[[0.0, 40.0, 6.0], [100.0, 50.0, 6.0]]);
            let solids = Solids { faces: vec![face(&square)], lines: vec![behind, before] };
            let [seen, hidden] = part(&solids, 0.0);
            assert_eq!(ends(&hidden), [[20.0, 60.0]]);
            assert_eq!(ends(&seen), [[0.0, 20.0], [60.0, 100.0], [0.0, 100.0]]);
        }
    }

    #[test]
    fn a_line_through_a_face_is_hidden_from_there_on() {
        let slope = face(&[[0.0, 0.0, 0.0], [100.0, 0.0, 100.0], [100.0, 80.0, 100.0], [0.0, 80.0, 0.0]]);
        let solids =
            Solids { faces: vec![slope], lines: vec![line(&[[0.0, 9.0, 25.0], [100.0, 9.0, 25.0]])] };
        let [seen, hidden] = part(&solids, 0.0);
        assert_eq!((ends(&seen), ends(&hidden)), (vec![[0.0, 25.7]], vec![[25.7, 100.0]]));
    }

    #[test]
    fn neighbours_hide_as_one_and_stretches_run_on_round_corners() {
        let strip =
            |x: f64| face(&[[x, 0.0, 9.0], [x + 10.0, 0.0, 9.0], [x + 10.0, 90.0, 9.0], [x, 90.0, 9.0]]);
        let faces = (0..5).map(|k| strip(20.0 + 10.0 * f64::from(k))).collect();
        let bent = line(&[[0.0, 30.0, 0.0], [40.0, 30.0, 0.0], [40.0, 60.0, 0.0], [90.0, 60.0, 0.0]]);
        let [seen, hidden] = part(&Solids { faces, lines: vec![bent] }, 0.0);
        assert_eq!((ends(&seen), ends(&hidden)), (vec![[0.0, 20.0], [70.0, 90.0]], vec![[20.0, 70.0]]));
        assert_eq!(hidden[0].points.len(), 4);
    }

    #[test]
    fn signs_are_seen_or_hidden_as_a_whole() {
        let wall = face(&[[50.0, 0.0, 9.0], [90.0, 0.0, 9.0], [90.0, 90.0, 9.0], [50.0, 90.0, 9.0]]);
        let stroke = |x: f64| line(&[[x - 4.0, 20.0, 0.0], [x + 4.0, 28.0, 0.0]]);
        let lines = vec![stroke(48.0), stroke(52.0)];
        let [seen, hidden] = part(&Solids { faces: vec![wall], lines }, 0.0);
        assert_eq!((ends(&seen), ends(&hidden)), (vec![[44.0, 52.0]], vec![[48.0, 56.0]]));
    }

    #[test]
    fn signs_and_broken_faces_hide_nothing() {
        let corners = [[0.0, 0.0, 9.0], [90.0, 0.0, 9.0], [90.0, 90.0, 9.0]];
        let mut broken = face(&corners);
        broken.corners[0].at[2] = f64::NAN;
        let sign = Face { sign: true, ..face(&corners) };
        let edge = face(&[[0.0, 9.0, 0.0], [90.0, 9.0, 0.0], [90.0, 9.0, 90.0]]);
        let lines = vec![line(&[[1.0, 5.0, 0.0], [80.0, 20.0, 0.0]])];
        let [seen, hidden] = part(&Solids { faces: vec![broken, sign, edge], lines: lines.clone() }, 0.0);
        assert_eq!((seen, hidden), (lines, Vec::new()));
    }
}
