use crate::{Point3, Vector3};

/// How a lattice point is held where the shape has an edge that stays.
#[derive(Debug, Clone, Copy)]
pub(super) enum Hold {
    /// Not at all.
    Free,
    /// On a line through a point, along a unit vector.
    Line(Point3, Vector3),
    /// In its place.
    Point(Point3),
}

impl Hold {
    fn stronger(self, other: Self) -> Self {
        match (self, other) {
            (Self::Point(_), _) | (Self::Line(..), Self::Line(..) | Self::Free) => self,
            (_, other) => other,
        }
    }
}

/// Places on a surface with the fields on it.
pub(super) struct Places {
    pub(super) points: Vec<Point3>,
    /// Unit normals.
    pub(super) normals: Vec<Vector3>,
    pub(super) areas: Vec<f64>,
    /// The sides of the lattices' cells.
    pub(super) sides: Vec<f64>,
    /// Directions that are fixed.
    pub(super) along: Vec<Option<Vector3>>,
    pub(super) held: Vec<Hold>,
}

/// A graph of places.
pub(super) struct Level {
    places: Places,
    /// Where the links of each place begin in the list of all, and where the last ones end.
    starts: Vec<u32>,
    links: Vec<(u32, f64)>,
}

impl std::ops::Deref for Level {
    type Target = Places;

    fn deref(&self) -> &Places {
        &self.places
    }
}

impl Level {
    pub(super) fn new(places: Places, lists: impl Iterator<Item = Vec<(u32, f64)>>) -> Self {
        let (mut starts, mut links) = (vec![0], Vec::new());
        for list in lists {
            links.extend(list);
            starts.push(links.len() as u32);
        }
        Self { places, starts, links }
    }

    pub(super) fn len(&self) -> usize {
        self.points.len()
    }

    /// The places that one is linked to, each with the weight of the link.
    pub(super) fn links(&self, i: usize) -> &[(u32, f64)] {
        &self.links[self.starts[i] as usize..self.starts[i + 1] as usize]
    }

    /// With directions fixed where guides are nearest.
    pub(super) fn guided(mut self, guides: &[(Point3, Vector3)]) -> Self {
        for &(p, direction) in guides {
            let places = self.points.iter().enumerate();
            let nearest = places.min_by(|a, b| a.1.distance_to(p).total_cmp(&b.1.distance_to(p)));
            let Some(i) = nearest.map(|(i, _)| i).filter(|i| self.along[*i].is_none()) else { continue };
            let normal = self.normals[i];
            self.places.along[i] = (direction - normal * normal.dot(direction)).unitized();
        }
        self
    }

    /// A graph of about half as many places, and to which of them each of these belongs. Neighbours that face the same
    /// way become one.
    pub(super) fn coarser(&self) -> (Self, Vec<u32>) {
        let mut pairs: Vec<(f64, u32, u32)> = Vec::new();
        for i in 0..self.len() {
            for &(j, _) in self.links(i).iter().filter(|(j, _)| *j as usize > i) {
                let (a, b) = (self.areas[i], self.areas[j as usize]);
                let ratio = a.max(b) / a.min(b).max(f64::MIN_POSITIVE);
                let score = self.normals[i].dot(self.normals[j as usize]) / ratio.min(1e9);
                pairs.push((score, i as u32, j));
            }
        }
        pairs.sort_by(|a, b| b.0.total_cmp(&a.0).then((a.1, a.2).cmp(&(b.1, b.2))));
        let mut parents = vec![u32::MAX; self.len()];
        let mut members: Vec<[u32; 2]> = Vec::new();
        for (_, i, j) in pairs {
            if parents[i as usize] == u32::MAX && parents[j as usize] == u32::MAX {
                (parents[i as usize], parents[j as usize]) = (members.len() as u32, members.len() as u32);
                members.push([i, j]);
            }
        }
        for i in 0..self.len() {
            if parents[i] == u32::MAX {
                parents[i] = members.len() as u32;
                members.push([i as u32; 2]);
            }
        }
        let coarse = self.joined(&members, &parents);
        (coarse, parents)
    }

    fn joined(&self, members: &[[u32; 2]], parents: &[u32]) -> Self {
        let pair = |m: &[u32; 2]| m.map(|i| i as usize);
        let share = |[i, j]: [usize; 2]| {
            let whole = self.areas[i] + self.areas[j];
            if whole > 0.0 { self.areas[j] / whole } else { 0.5 }
        };
        let points =
            members.iter().map(pair).map(|[i, j]| self.points[i].lerp(self.points[j], share([i, j])));
        let normals = members.iter().map(pair).map(|[i, j]| {
            let t = share([i, j]);
            let sum = self.normals[i] * (1.0 - t) + self.normals[j] * t;
            sum.unitized().unwrap_or(self.normals[i])
        });
        let areas = members
            .iter()
            .map(pair)
            .map(|[i, j]| if i == j { self.areas[i] } else { self.areas[i] + self.areas[j] });
        let sides = members.iter().map(pair).map(|[i, j]| {
            let t = share([i, j]);
            self.sides[i] * (1.0 - t) + self.sides[j] * t
        });
        let along = members.iter().map(pair).map(|[i, j]| self.along[i].or(self.along[j]));
        let held = members.iter().map(pair).map(|[i, j]| self.held[i].stronger(self.held[j]));
        let lists = members.iter().zip(0_u32..).map(|(m, own)| {
            let ends = if m[0] == m[1] { &m[..1] } else { &m[..] };
            let all = ends.iter().flat_map(|&i| self.links(i as usize));
            let mut list: Vec<(u32, f64)> =
                all.map(|&(j, w)| (parents[j as usize], w)).filter(|(k, _)| *k != own).collect();
            list.sort_by_key(|(k, _)| *k);
            list.dedup_by(|b, a| {
                let same = a.0 == b.0;
                if same {
                    a.1 += b.1;
                }
                same
            });
            list
        });
        let lists: Vec<_> = lists.collect();
        let places = Places {
            points: points.collect(),
            normals: normals.collect(),
            areas: areas.collect(),
            sides: sides.collect(),
            along: along.collect(),
            held: held.collect(),
        };
        Self::new(places, lists.into_iter())
    }
}
