use super::lattice::{Cross, Lattice};
use super::levels::{Hold, Level};
use crate::cancellation::check;
use crate::{Point3, Result, Vector3};

/// Rounds on each level of the hierarchy.
const ROUNDS: usize = 8;

/// Solves the fields of crosses and of lattices with cells of the places' sides, and gives of each place the lattice point
/// nearest to it.
pub(super) fn solve(finest: Level) -> Result<Vec<Point3>> {
    let mut levels = vec![finest];
    let mut parents: Vec<Vec<u32>> = Vec::new();
    while let Some(last) = levels.last() {
        check()?;
        let (coarse, up) = last.coarser();
        // Single places, one for each piece of the surface, do not become fewer.
        if 20 * coarse.len() > 19 * last.len() {
            break;
        }
        levels.push(coarse);
        parents.push(up);
    }
    let mut crosses: Vec<Vec<Vector3>> = Vec::new();
    let mut directions: Vec<Vector3> = levels.last().map(first_directions).unwrap_or_default();
    for (k, level) in levels.iter().enumerate().rev() {
        for _ in 0..ROUNDS {
            check()?;
            turn(level, &mut directions);
        }
        crosses.push(directions.clone());
        if let Some((finer, up)) = k.checked_sub(1).map(|j| (&levels[j], &parents[j])) {
            let taken = |(i, &p): (usize, &u32)| {
                finer.along[i].unwrap_or_else(|| level_with(finer.normals[i], directions[p as usize]))
            };
            directions = up.iter().enumerate().map(taken).collect();
        }
    }
    crosses.reverse();
    let mut places: Vec<Point3> = levels.last().map(|level| level.points.clone()).unwrap_or_default();
    for (k, level) in levels.iter().enumerate().rev() {
        for _ in 0..ROUNDS {
            check()?;
            shift(level, &crosses[k], &mut places);
        }
        if let Some((finer, up)) = k.checked_sub(1).map(|j| (&levels[j], &parents[j])) {
            let taken = |(i, &p): (usize, &u32)| {
                let (v, n, place) = (finer.points[i], finer.normals[i], places[p as usize]);
                place - n * n.dot(place - v)
            };
            places = up.iter().enumerate().map(taken).collect();
        }
    }
    Ok(places)
}

/// A unit vector at right angles to a unit normal, as near to a direction as can be.
fn level_with(normal: Vector3, direction: Vector3) -> Vector3 {
    (direction - normal * normal.dot(direction)).unitized().unwrap_or_else(|| any_across(normal))
}

/// Some unit vector at right angles to a unit normal, the same for the same normal.
fn any_across(normal: Vector3) -> Vector3 {
    let [x, y, z] = [normal.x.abs(), normal.y.abs(), normal.z.abs()];
    let axis = if x <= y && x <= z {
        Vector3::X
    } else if y <= z {
        Vector3::Y
    } else {
        Vector3::Z
    };
    (axis - normal * normal.dot(axis)).unitized().unwrap_or(Vector3::X)
}

fn first_directions(level: &Level) -> Vec<Vector3> {
    let first = |i: usize| {
        level.along[i].map_or_else(|| any_across(level.normals[i]), |d| level_with(level.normals[i], d))
    };
    (0..level.len()).map(first).collect()
}

/// Turns each cross to the mean of its neighbours', one after the other.
fn turn(level: &Level, directions: &mut [Vector3]) {
    for i in 0..level.len() {
        let normal = level.normals[i];
        if let Some(along) = level.along[i] {
            directions[i] = level_with(normal, along);
            continue;
        }
        let mut mean = Cross { direction: directions[i], normal };
        let mut weight = 0.0;
        for &(j, w) in level.links(i) {
            let other = Cross { direction: directions[j as usize], normal: level.normals[j as usize] };
            let (own, near) = mean.fitted(&other);
            let sum = own * weight + near * w;
            weight += w;
            // Where they cancel, the last one stays.
            if let Some(unit) = (sum - normal * normal.dot(sum)).unitized() {
                mean.direction = unit;
            }
        }
        directions[i] = mean.direction;
    }
}

/// Moves each lattice to the mean of its neighbours', one after the other.
fn shift(level: &Level, directions: &[Vector3], places: &mut [Point3]) {
    for i in 0..level.len() {
        let (v, normal, side) = (level.points[i], level.normals[i], level.sides[i]);
        if let Hold::Point(p) = level.held[i] {
            places[i] = p;
            continue;
        }
        let cross = Cross { direction: directions[i], normal };
        let (mut sum, mut weight) = (places[i], 0.0);
        for &(j, w) in level.links(i) {
            let j = j as usize;
            let other = Cross { direction: directions[j], normal: level.normals[j] };
            let (a, b) = cross.fitted(&other);
            let own = Lattice { place: sum, cross: Cross { direction: a, normal } };
            let near = Lattice { place: places[j], cross: Cross { direction: b, ..other } };
            let (p, q) = own.fitted(&near, [v, level.points[j]], 0.5 * (side + level.sides[j]));
            sum = p.lerp(q, w / (weight + w));
            weight += w;
            sum = sum - normal * normal.dot(sum - v);
        }
        places[i] = match level.held[i] {
            Hold::Line(origin, along) => {
                let on_line = origin + along * along.dot(sum - origin);
                on_line + along * ((along.dot(v - on_line) / side).round() * side)
            }
            _ => Lattice { place: sum, cross }.nearest(v, side),
        };
    }
}
