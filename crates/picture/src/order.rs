//! The painter's order: from back to front, so that what is drawn later rightly covers what was drawn before.
//!
//! The plane of a face parts the others into those behind it and those before it; a face or line that crosses the plane
//! is split there (binary space partition: Fuchs, Kedem and Naylor, "On visible surface generation by a priori tree
//! structures", 1980). Unlike sorting by a middle depth this is right for faces that run through one another or overlap
//! in a ring.

use katydid_data::Colour;

use crate::drawing::{Face, Solids};

/// Something in the painter's order.
#[derive(Debug, Clone, PartialEq)]
pub(crate) enum Drawn {
    /// A face or a piece of one.
    Face {
        /// Its corners: x, y, depth.
        corners: Vec<[f64; 3]>,
        /// Its one colour.
        colour: Colour,
    },
    /// A straight piece of a line.
    Line {
        /// Where it begins.
        from: [f64; 3],
        /// Where it ends.
        to: [f64; 3],
        /// The index of the line.
        of: usize,
    },
}

/// What is nearer to a plane than this lies on it; in pixels.
const ON: f64 = 0.02;
/// How many faces are tried as the one that parts the others.
const TRIED: usize = 6;
/// How many of the others a trial looks at.
const SAMPLED: usize = 40;
/// Splitting ends when there are so many times more pieces than in the beginning; the rest is sorted by depth.
const MOST_SPLIT: usize = 6;

struct Piece {
    drawn: Drawn,
    /// The plane of a face that may part others: unit normal towards the viewer, and distance.
    plane: Option<([f64; 3], f64)>,
    /// The place in the beginning, for a stable order.
    at: usize,
}

enum Task {
    Part(Vec<Piece>),
    Draw(Vec<Piece>),
}

/// The faces and lines from back to front, split where they cross.
pub(crate) fn back_to_front(solids: &Solids) -> Vec<Drawn> {
    let pieces = pieces(solids);
    let mut left = pieces.len() * MOST_SPLIT + 1000;
    let mut out = Vec::with_capacity(pieces.len());
    let mut tasks = vec![Task::Part(pieces)];
    while let Some(task) = tasks.pop() {
        let pieces = match task {
            Task::Draw(pieces) => {
                out.extend(pieces.into_iter().map(|piece| piece.drawn));
                continue;
            }
            Task::Part(pieces) => pieces,
        };
        let plane = if left > 0 { parting_plane(&pieces) } else { None };
        let Some(plane) = plane else {
            tasks.push(Task::Draw(by_depth(pieces)));
            continue;
        };
        left = left.saturating_sub(pieces.len().ilog2() as usize + 1);
        let [behind, on, before] = part(pieces, plane);
        tasks.push(Task::Part(before));
        tasks.push(Task::Draw(on));
        tasks.push(Task::Part(behind));
    }
    out
}

fn pieces(solids: &Solids) -> Vec<Piece> {
    let faces = solids.faces.iter().enumerate().filter_map(|(at, face)| {
        let corners: Vec<[f64; 3]> = face.corners.iter().map(|corner| corner.at).collect();
        if corners.len() < 3 || !corners.iter().flatten().all(|x| x.is_finite()) {
            return None;
        }
        let plane = if face.sign { None } else { plane(face) };
        Some(Piece { drawn: Drawn::Face { corners, colour: face.colour() }, plane, at })
    });
    let lines = solids.lines.iter().enumerate().flat_map(|(of, line)| {
        line.points.windows(2).filter_map(move |w| {
            let [from, to] = *w else { return None };
            let drawn = Drawn::Line { from, to, of };
            from.iter().chain(&to).all(|x| x.is_finite()).then_some(Piece { drawn, plane: None, at: of })
        })
    });
    let mut all: Vec<Piece> = faces.collect();
    let count = all.len();
    all.extend(lines.map(|piece| Piece { at: count + piece.at, ..piece }));
    all
}

/// The plane of a face; `None` for one that is seen from the edge and covers nothing.
fn plane(face: &Face) -> Option<([f64; 3], f64)> {
    // Newell's normal: robust for corners in a row.
    let mut n = [0.0; 3];
    for (k, corner) in face.corners.iter().enumerate() {
        let (a, b) = (corner.at, face.corners[(k + 1) % face.corners.len()].at);
        for i in 0..3 {
            let (j, l) = ((i + 1) % 3, (i + 2) % 3);
            n[i] += (a[j] - b[j]) * (a[l] + b[l]);
        }
    }
    let length = dot(n, n).sqrt();
    if !(length > 1e-9) || n[2].abs() < 1e-9 * length {
        return None;
    }
    let sign = n[2].signum();
    let n = n.map(|x| x * sign / length);
    let middle = face.corners.iter().fold([0.0; 3], |sum, corner| [0, 1, 2].map(|i| sum[i] + corner.at[i]));
    Some((n, dot(n, middle) / face.corners.len() as f64))
}

fn dot(a: [f64; 3], b: [f64; 3]) -> f64 {
    a[0] * b[0] + a[1] * b[1] + a[2] * b[2]
}

/// Of a few faces the plane that splits least and parts most evenly.
fn parting_plane(pieces: &[Piece]) -> Option<([f64; 3], f64)> {
    let planes: Vec<([f64; 3], f64)> = pieces.iter().filter_map(|piece| piece.plane).collect();
    let step = planes.len().div_ceil(TRIED).max(1);
    let sample = pieces.len().div_ceil(SAMPLED).max(1);
    let cost = |plane: &([f64; 3], f64)| {
        let (mut split, mut balance) = (0_i64, 0_i64);
        for piece in pieces.iter().step_by(sample) {
            let (mut low, mut high) = (false, false);
            each_point(&piece.drawn, |p| {
                let d = dot(plane.0, p) - plane.1;
                low |= d < -ON;
                high |= d > ON;
            });
            split += i64::from(low && high);
            balance += i64::from(high) - i64::from(low);
        }
        4 * split + balance.abs()
    };
    planes.iter().step_by(step).min_by_key(|plane| cost(plane)).copied()
}

fn each_point(drawn: &Drawn, mut see: impl FnMut([f64; 3])) {
    match drawn {
        Drawn::Face { corners, .. } => corners.iter().for_each(|p| see(*p)),
        Drawn::Line { from, to, .. } => [*from, *to].into_iter().for_each(see),
    }
}

/// What is behind the plane, on it, and before it.
fn part(pieces: Vec<Piece>, (normal, distance): ([f64; 3], f64)) -> [Vec<Piece>; 3] {
    let [mut behind, mut on, mut before] = [Vec::new(), Vec::new(), Vec::new()];
    let height = |p: [f64; 3]| dot(normal, p) - distance;
    for piece in pieces {
        let (mut low, mut high) = (false, false);
        each_point(&piece.drawn, |p| {
            low |= height(p) < -ON;
            high |= height(p) > ON;
        });
        match (low, high) {
            (false, false) => on.push(piece),
            (true, false) => behind.push(piece),
            (false, true) => before.push(piece),
            (true, true) => {
                let (plane, at) = (piece.plane, piece.at);
                let [lower, upper] = split(piece.drawn, height);
                behind.extend(lower.map(|drawn| Piece { drawn, plane, at }));
                before.extend(upper.map(|drawn| Piece { drawn, plane, at }));
            }
        }
    }
    on.sort_by_key(|piece| piece.at);
    [behind, on, before]
}

/// The parts of something below and above height 0.
fn split(drawn: Drawn, height: impl Fn([f64; 3]) -> f64) -> [Option<Drawn>; 2] {
    let cut = |a: [f64; 3], b: [f64; 3]| {
        let (x, y) = (height(a), height(b));
        let t = x / (x - y);
        [0, 1, 2].map(|i| a[i] + (b[i] - a[i]) * t)
    };
    match drawn {
        Drawn::Face { corners, colour } => {
            let (mut lower, mut upper) = (Vec::new(), Vec::new());
            for (k, &a) in corners.iter().enumerate() {
                let b = corners[(k + 1) % corners.len()];
                let (x, y) = (height(a), height(b));
                if x <= 0.0 {
                    lower.push(a);
                }
                if x >= 0.0 {
                    upper.push(a);
                }
                if (x < 0.0 && y > 0.0) || (x > 0.0 && y < 0.0) {
                    lower.push(cut(a, b));
                    upper.push(cut(a, b));
                }
            }
            [lower, upper].map(|corners| (corners.len() > 2).then_some(Drawn::Face { corners, colour }))
        }
        Drawn::Line { from, to, of } => {
            let middle = cut(from, to);
            let (first, second) =
                (Drawn::Line { from, to: middle, of }, Drawn::Line { from: middle, to, of });
            if height(from) < 0.0 { [Some(first), Some(second)] } else { [Some(second), Some(first)] }
        }
    }
}

/// By the depth in the middle; of equal ones lines above faces, then as they came.
fn by_depth(mut pieces: Vec<Piece>) -> Vec<Piece> {
    let depth = |piece: &Piece| {
        let (mut sum, mut n) = (0.0, 0.0);
        each_point(&piece.drawn, |p| {
            sum += p[2];
            n += 1.0;
        });
        sum / f64::max(n, 1.0)
    };
    pieces.sort_by(|a, b| depth(a).total_cmp(&depth(b)).then(a.at.cmp(&b.at)));
    pieces
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::drawing::{Corner, SpaceLine};

    fn face(corners: [[f64; 3]; 4], grey: u8) -> Face {
        let colour = Colour::rgb(grey, grey, grey);
        Face { corners: corners.map(|at| Corner { at, colour }).to_vec(), sign: false }
    }

    fn flat(depth: f64, grey: u8) -> Face {
        let p = |x, y| [x, y, depth];
        face([p(0.0, 0.0), p(10.0, 0.0), p(10.0, 10.0), p(0.0, 10.0)], grey)
    }

    fn greys(solids: &Solids) -> Vec<u8> {
        let grey = |drawn: Drawn| match drawn {
            Drawn::Face { colour, .. } => colour.r,
            Drawn::Line { .. } => 255,
        };
        back_to_front(solids).into_iter().map(grey).collect()
    }

    #[test]
    fn the_nearest_comes_last() {
        let line = |depth| SpaceLine {
            points: vec![[1.0, 1.0, depth], [2.0, 2.0, depth]],
            colour: Colour::default(),
            width: 1.0,
        };
        let solids = Solids { faces: vec![flat(5.0, 3), flat(1.0, 1), flat(3.0, 2)], lines: vec![line(2.0)] };
        assert_eq!(greys(&solids), [1, 255, 2, 3]);
    }

    #[test]
    fn crossing_faces_are_split() {
        let p = |x, y, z| [x, y, z];
        let tilted = face([p(0.0, 0.0, 0.0), p(10.0, 0.0, 10.0), p(10.0, 10.0, 10.0), p(0.0, 10.0, 0.0)], 9);
        let order = greys(&Solids { faces: vec![flat(5.0, 1), tilted], lines: Vec::new() });
        assert!(order == [9, 1, 9] || order == [1, 9, 1], "{order:?}");
        // A line through a face: behind, the face, before.
        let line = SpaceLine {
            points: vec![[5.0, 5.0, 0.0], [5.0, 6.0, 9.0]],
            colour: Colour::default(),
            width: 1.0,
        };
        let drawn = back_to_front(&Solids { faces: vec![flat(5.0, 1)], lines: vec![line] });
        assert!(matches!(drawn[0], Drawn::Line { to, .. } if (to[2] - 5.0).abs() < 1e-9));
        assert!(matches!(drawn[1], Drawn::Face { .. }));
        assert_eq!(drawn.len(), 3);
    }

    #[test]
    fn broken_numbers_are_left_out() {
        let mut bad = flat(1.0, 1);
        bad.corners[0].at[0] = f64::NAN;
        assert_eq!(greys(&Solids { faces: vec![bad, flat(0.0, 7)], lines: Vec::new() }), [7]);
    }
}
