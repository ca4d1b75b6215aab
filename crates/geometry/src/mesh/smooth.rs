//! Vertices and colours drawn towards their neighbours.

use super::Mesh;
use super::neighbours::Neighbours;
use crate::mesh::thresholds::SMOOTHED;
use crate::{Error, Point3, Result, Vector3};

/// How a mesh is smoothed.
#[derive(Debug, Clone, Copy, PartialEq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
pub struct Smoothing {
    /// How far each step goes towards the middle of the neighbours: 0 stays, 1 goes all the way.
    pub strength: f64,
    /// Whether vertices on naked edges stay.
    pub skip_naked: bool,
    /// The number of steps.
    pub iterations: usize,
    /// The greatest distance of a vertex from where it was at first, in model units.
    pub limit: Option<f64>,
}

impl Mesh {
    /// The mesh with every vertex drawn towards the mean of its neighbours along edges, all at once in each step
    /// (Laplacian smoothing: D. A. Field, *Laplacian smoothing and Delaunay triangulations*, Comm. Appl. Numer.
    /// Methods 4, 1988). Vertices in the same place move together. Normals are computed anew.
    ///
    /// `go_on` is asked before each step; the steps end when it says no, or when nothing moves any more.
    ///
    /// # Errors
    /// The strength or the limit is not finite, the limit is negative, or vertices leave for infinity.
    pub fn smoothed(&self, options: &Smoothing, mut go_on: impl FnMut() -> bool) -> Result<Self> {
        if !options.strength.is_finite() {
            return Err(Error::NotFinite("smoothing strength"));
        }
        if let Some(value) = options.limit.filter(|l| !(*l >= 0.0 && l.is_finite())) {
            return Err(Error::OutOfRange { what: "limit", value, must: "finite and not negative" });
        }
        let near = Neighbours::new(self);
        let mut at = self.vertices.clone();
        let mut next = at.clone();
        let stays = |i: usize| {
            near.place(i) != i || (options.skip_naked && near.naked.get(i).copied().unwrap_or(false))
        };
        let moving: Vec<usize> = (0..at.len()).filter(|&i| !stays(i) && !near.of(i).is_empty()).collect();
        for _ in 0..options.iterations {
            if moving.is_empty() || !go_on() {
                break;
            }
            let mut moved = false;
            for &i in &moving {
                let others = near.of(i);
                let place = |k: usize| at.get(k).map_or(Vector3::ZERO, |p| p.to_vector());
                let sum: Vector3 = others.iter().map(|&k| place(k as usize)).sum();
                let (here, mean) = (place(i), sum / others.len() as f64);
                let mut new = here + (mean - here) * options.strength;
                if let (Some(limit), Some(first)) = (options.limit, self.vertices.get(i)) {
                    let away = new - first.to_vector();
                    let length = away.length();
                    if length > limit {
                        new = first.to_vector() + away * (limit / length);
                    }
                }
                if let Some(slot) = next.get_mut(i) {
                    *slot = new.to_point();
                    moved |= new != here;
                }
            }
            // Both lists hold those that stay.
            std::mem::swap(&mut at, &mut next);
            if !moved {
                break;
            }
        }
        let at: Vec<Point3> = near.spread(at);
        Ok(Self::from_parts(at, self.faces.to_vec(), Vec::new(), self.colours.clone())?.with_normals())
    }

    /// The mesh with each vertex colour the mean of itself and those of the neighbours along edges, `iterations`
    /// times over. Vertices in the same place share their mean. A mesh without colours stays as it is. `go_on` as for
    /// [`Mesh::smoothed`].
    #[must_use]
    pub fn blurred(&self, iterations: usize, mut go_on: impl FnMut() -> bool) -> Self {
        if self.colours.is_empty() || iterations == 0 {
            return self.clone();
        }
        let near = Neighbours::new(self);
        // Vertices in one place begin with the mean of their colours.
        let mut sums = vec![([0.0_f64; 4], 0.0_f64); self.colours.len()];
        for (i, colour) in self.colours.iter().enumerate() {
            if let Some((sum, count)) = sums.get_mut(near.place(i)) {
                *count += 1.0;
                sum.iter_mut().zip(colour).for_each(|(s, &c)| *s += f64::from(c));
            }
        }
        let mut at: Vec<[f64; 4]> = sums.iter().map(|(s, n)| s.map(|x| x / n.max(1.0))).collect();
        for _ in 0..iterations {
            if !go_on() {
                break;
            }
            let mut change = 0.0_f64;
            let mut next = at.clone();
            for (i, slot) in next.iter_mut().enumerate().filter(|(i, _)| near.place(*i) == *i) {
                let others = near.of(i);
                for (channel, value) in slot.iter_mut().enumerate() {
                    let of =
                        |k: &u32| at.get(*k as usize).and_then(|c| c.get(channel)).copied().unwrap_or(0.0);
                    let mean = (*value + others.iter().map(of).sum::<f64>()) / (others.len() + 1) as f64;
                    change = change.max((mean - *value).abs());
                    *value = mean;
                }
            }
            at = next;
            // What is left cannot change a channel of 8 bits any more.
            if change < SMOOTHED {
                break;
            }
        }
        let colours =
            near.spread(at).into_iter().map(|c| c.map(|x| x.round().clamp(0.0, 255.0) as u8)).collect();
        Self { colours, ..self.clone() }
    }
}

#[cfg(test)]
mod tests {
    use super::Smoothing;
    use crate::{Interval, Mesh, Plane, Point3, Rectangle};

    fn sheet() -> Mesh {
        let side = Interval::new(0.0, 4.0);
        let flat = Mesh::plane(&Rectangle { plane: Plane::XY, x: side, y: side }, 4, 4).unwrap();
        let mut points = flat.vertices().to_vec();
        points[12].z = 1.0;
        Mesh::new(points, flat.faces().to_vec()).unwrap()
    }

    #[test]
    fn a_peak_sinks_and_the_rim_stays() {
        let step = |strength: f64, iterations, limit| {
            let options = Smoothing { strength, skip_naked: true, iterations, limit };
            sheet().smoothed(&options, || true).unwrap()
        };
        let once = step(0.5, 1, None);
        assert_eq!(once.vertices()[12], Point3::new(2.0, 2.0, 0.5));
        assert_eq!(once.vertices()[11], Point3::new(1.0, 2.0, 0.125));
        assert_eq!(once.vertices()[..5], sheet().vertices()[..5]);
        assert!(step(0.5, 400, None).vertices().iter().all(|p| p.z < 1e-9));
        assert_eq!(step(1.0, 50, Some(0.25)).vertices()[12], Point3::new(2.0, 2.0, 0.75));
        assert_eq!(step(0.0, 9, None).vertices(), sheet().vertices());
        let bad = Smoothing { strength: f64::NAN, skip_naked: true, iterations: 1, limit: None };
        assert!(sheet().smoothed(&bad, || true).is_err());
    }

    #[test]
    fn vertices_in_one_place_stay_together() {
        let side = Interval::new(-1.0, 1.0);
        let cube = crate::Box3 { plane: Plane::XY, x: side, y: side, z: side };
        let cube = Mesh::cuboid(&cube, 2, 2, 2).unwrap();
        let options = Smoothing { strength: 0.7, skip_naked: true, iterations: 3, limit: None };
        let smooth = cube.smoothed(&options, || true).unwrap();
        assert!(smooth.is_closed());
        assert!(smooth.volume() > 0.0 && smooth.volume() < cube.volume());
        let mut asked = 0;
        let stopped = cube.smoothed(&Smoothing { iterations: usize::MAX, ..options }, || {
            asked += 1;
            asked <= 2
        });
        assert!(stopped.is_ok() && asked == 3);
    }

    #[test]
    fn colours_spread() {
        let mut colours = vec![[0, 0, 0, 255]; 25];
        colours[12] = [250, 0, 0, 255];
        let sheet = Mesh::from_parts(sheet().vertices().to_vec(), sheet().faces().to_vec(), vec![], colours);
        let sheet = sheet.unwrap();
        let blurred = sheet.blurred(1, || true);
        assert_eq!(blurred.colours()[12], [50, 0, 0, 255]);
        assert_eq!(blurred.colours()[11], [50, 0, 0, 255]);
        assert_eq!(blurred.colours()[0], [0, 0, 0, 255]);
        let even = sheet.blurred(usize::MAX, || true);
        assert!(even.colours().iter().all(|c| *c == even.colours()[0]));
        assert_eq!(Mesh::default().blurred(3, || true), Mesh::default());
    }
}
