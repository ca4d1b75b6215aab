use crate::{Direction, Error, Interval, NurbsSurface, Plane, Point3, Result, Vector3};

/// A rectangle of a plane: u and v are mapped linearly from their domains to ranges of the plane's coordinates.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct PlaneSurface {
    plane: Plane,
    extents: [Interval; 2],
    domains: [Interval; 2],
}

impl PlaneSurface {
    /// The rectangle between two ranges of a plane's coordinates; the parameters are the coordinates.
    ///
    /// # Errors
    /// The plane is not finite, or a range does not increase.
    pub fn new(plane: Plane, x: Interval, y: Interval) -> Result<Self> {
        Self::with_domains(plane, [x, y], [x, y])
    }

    /// The rectangle between two ranges of a plane's coordinates over other domains.
    ///
    /// # Errors
    /// The plane is not finite, or a range or domain does not increase.
    pub fn with_domains(plane: Plane, extents: [Interval; 2], domains: [Interval; 2]) -> Result<Self> {
        if !plane.is_finite() {
            return Err(Error::NotFinite("plane of the surface"));
        }
        for range in extents.iter().chain(&domains) {
            if !(range.is_increasing() && range.length().is_finite()) {
                return Err(Error::Invalid {
                    what: "range of a plane surface",
                    why: format!("{} to {} does not increase", range.start, range.end),
                });
            }
        }
        Ok(Self { plane, extents, domains })
    }

    /// The plane; its normal is the surface's.
    pub fn plane(&self) -> &Plane {
        &self.plane
    }

    /// The ranges of the plane's coordinates that the surface covers.
    pub fn extents(&self) -> [Interval; 2] {
        self.extents
    }

    /// The range of one parameter.
    pub fn domain(&self, direction: Direction) -> Interval {
        self.domains[direction.index()]
    }

    /// The plane coordinates of a pair of parameters.
    pub(super) fn coordinates(&self, u: f64, v: f64) -> [f64; 2] {
        let at = |d: usize, t: f64| {
            if self.extents[d] == self.domains[d] {
                t
            } else {
                self.extents[d].at(self.domains[d].normalized(t))
            }
        };
        [at(0, u), at(1, v)]
    }

    /// The parameters of a point's shadow on the plane; they may lie outside the domain.
    pub fn parameters_of(&self, p: Point3) -> [f64; 2] {
        let [x, y, _] = self.plane.coordinates(p);
        let at = |d: Direction, value: f64| self.domain(d).at(self.extents()[d.index()].normalized(value));
        [at(Direction::U, x), at(Direction::V, y)]
    }

    /// The point at (u, v).
    pub fn point_at(&self, u: f64, v: f64) -> Point3 {
        let [x, y] = self.coordinates(u, v);
        self.plane.at(x, y, 0.0)
    }

    /// The derivatives by u and by v, the same everywhere.
    pub(crate) fn partials(&self) -> [Vector3; 2] {
        let speed = |d: usize| self.extents[d].length() / self.domains[d].length();
        [self.plane.x_axis * speed(0), self.plane.y_axis * speed(1)]
    }

    /// The exact bilinear form over the same domains.
    ///
    /// # Errors
    /// A corner overflows.
    pub fn to_nurbs(&self) -> Result<NurbsSurface> {
        NurbsSurface::from_plane(&self.plane, self.extents, self.domains)
    }

    /// The same points with u and v exchanged.
    #[must_use]
    pub fn transposed(&self) -> Self {
        let swap = |[a, b]: [Interval; 2]| [b, a];
        Self { plane: self.plane.flipped(), extents: swap(self.extents), domains: swap(self.domains) }
    }

    /// The same points with one direction walked backwards; its domain a…b becomes −b…−a.
    #[must_use]
    pub fn reversed(&self, direction: Direction) -> Self {
        let negated = |r: Interval| Interval::new(-r.end, -r.start);
        let mut out = *self;
        let (p, d) = (&mut out.plane, direction.index());
        p.z_axis = -p.z_axis;
        match direction {
            Direction::U => p.x_axis = -p.x_axis,
            Direction::V => p.y_axis = -p.y_axis,
        }
        out.extents[d] = negated(out.extents[d]);
        out.domains[d] = negated(out.domains[d]);
        out
    }

    /// The part over a range of one parameter.
    pub(super) fn part(&self, direction: Direction, range: Interval) -> Result<Self> {
        let d = direction.index();
        let (mut extents, mut domains) = (self.extents, self.domains);
        let at = |t: f64| match direction {
            Direction::U => self.coordinates(t, self.domains[1].start)[0],
            Direction::V => self.coordinates(self.domains[0].start, t)[1],
        };
        extents[d] = Interval::new(at(range.start), at(range.end));
        domains[d] = range;
        Self::with_domains(self.plane, extents, domains)
    }

    /// The same points over another domain in one direction.
    pub(super) fn over_domain(&self, direction: Direction, domain: Interval) -> Result<Self> {
        let mut domains = self.domains;
        domains[direction.index()] = domain;
        Self::with_domains(self.plane, self.extents, domains)
    }
}
