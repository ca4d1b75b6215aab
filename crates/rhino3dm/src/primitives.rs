//! Numbers, points, planes, colours, identifiers, text and arrays (section 3). All little-endian.

use std::f64::consts::{FRAC_PI_2, PI};

use katydid_geometry::{Arc, BoundingBox, Circle, Interval, Line, Plane, Point3, Vector3};
use uuid::Uuid;

use crate::chunk::{Reader, Writer};
use crate::{Error, Result};

/// The corners of the box that openNURBS calls empty.
const EMPTY_BOX: [Point3; 2] = [Point3::new(1.0, 0.0, 0.0), Point3::new(-1.0, 0.0, 0.0)];

/// The d of a plane's equation n·p + d = 0, which is −n·origin.
fn plane_offset(plane: &Plane) -> f64 {
    let (n, o) = (plane.z_axis, plane.origin);
    let d = -(n.x * o.x + n.y * o.y + n.z * o.z);
    // The plane of the world's x and y is a constant there, with a d of 0 and not −0.
    let is_world = [plane.x_axis, plane.y_axis, n] == [Vector3::X, Vector3::Y, Vector3::Z]
        && [n.x, n.y].iter().all(|x| x.is_sign_positive());
    if is_world && d == 0.0 { 0.0 } else { d }
}

/// Read side. Every `what` names the thing for the error message.
impl Reader<'_> {
    pub(crate) fn u8(&mut self, what: &'static str) -> Result<u8> {
        Ok(u8::from_le_bytes(self.array(what)?))
    }

    pub(crate) fn bool(&mut self, what: &'static str) -> Result<bool> {
        Ok(self.u8(what)? != 0)
    }

    pub(crate) fn u16(&mut self, what: &'static str) -> Result<u16> {
        Ok(u16::from_le_bytes(self.array(what)?))
    }

    pub(crate) fn i32(&mut self, what: &'static str) -> Result<i32> {
        Ok(i32::from_le_bytes(self.array(what)?))
    }

    pub(crate) fn u32(&mut self, what: &'static str) -> Result<u32> {
        Ok(u32::from_le_bytes(self.array(what)?))
    }

    pub(crate) fn f64(&mut self, what: &'static str) -> Result<f64> {
        Ok(f64::from_le_bytes(self.array(what)?))
    }

    /// A version byte: major number times 16 plus minor.
    pub(crate) fn packed_version(&mut self, what: &'static str) -> Result<(u8, u8)> {
        let byte = self.u8(what)?;
        Ok((byte >> 4, byte & 15))
    }

    pub(crate) fn point(&mut self, what: &'static str) -> Result<Point3> {
        Ok(Point3::new(self.f64(what)?, self.f64(what)?, self.f64(what)?))
    }

    pub(crate) fn vector(&mut self, what: &'static str) -> Result<Vector3> {
        Ok(Vector3::new(self.f64(what)?, self.f64(what)?, self.f64(what)?))
    }

    pub(crate) fn interval(&mut self, what: &'static str) -> Result<Interval> {
        Ok(Interval::new(self.f64(what)?, self.f64(what)?))
    }

    pub(crate) fn line(&mut self, what: &'static str) -> Result<Line> {
        Ok(Line::new(self.point(what)?, self.point(what)?))
    }

    /// Origin, three axes and the plane equation, which follows from them.
    pub(crate) fn plane(&mut self, what: &'static str) -> Result<Plane> {
        let plane = Plane {
            origin: self.point(what)?,
            x_axis: self.vector(what)?,
            y_axis: self.vector(what)?,
            z_axis: self.vector(what)?,
        };
        self.take(32, what)?;
        Ok(plane)
    }

    /// A plane, and the last number of its equation where it is not the one that is written for the plane: it was
    /// computed another way, down to the sign of zero.
    pub(crate) fn plane_and_offset(&mut self, what: &'static str) -> Result<(Plane, Option<f64>)> {
        let plane = self.plane(what)?;
        let end = self.offset();
        let stored = self.between(end.saturating_sub(8), end).first_chunk();
        let offset = stored.map(|bytes| f64::from_le_bytes(*bytes));
        Ok((plane, offset.filter(|d| d.to_bits() != plane_offset(&plane).to_bits())))
    }

    /// A circle, its three stored points passed over (they are redundant), and an angle range; with the offset of
    /// the circle's plane.
    pub(crate) fn arc(&mut self, what: &'static str) -> Result<(Arc, Option<f64>)> {
        let (plane, offset) = self.plane_and_offset(what)?;
        let radius = self.f64(what)?;
        self.take(72, what)?;
        Ok((Arc { circle: Circle { plane, radius }, angle: self.interval(what)? }, offset))
    }

    /// A box; nothing for the one that openNURBS calls empty.
    pub(crate) fn bounds(&mut self, what: &'static str) -> Result<Option<BoundingBox>> {
        let bounds = BoundingBox { min: self.point(what)?, max: self.point(what)? };
        let [min, max] = EMPTY_BOX;
        Ok((bounds.min != min || bounds.max != max).then_some(bounds))
    }

    /// Red, green, blue and transparency (0 is opaque).
    pub(crate) fn colour(&mut self, what: &'static str) -> Result<[u8; 4]> {
        self.array(what)
    }

    pub(crate) fn uuid(&mut self, what: &'static str) -> Result<Uuid> {
        Ok(Uuid::from_bytes_le(self.array(what)?))
    }

    /// UTF-16 text that counts its closing zero. Broken surrogates become U+FFFD.
    pub(crate) fn string(&mut self, what: &'static str) -> Result<String> {
        let offset = self.offset();
        let count = self.u32(what)?;
        let count = usize::try_from(count).map_err(|_| Error::malformed(offset, what, "it is too long"))?;
        self.check_count(count, 2, what)?;
        let bytes = self.take(count.saturating_mul(2), what)?;
        let units = bytes.as_chunks::<2>().0.iter().map(|unit| u16::from_le_bytes(*unit));
        let text = char::decode_utf16(units.take_while(|unit| *unit != 0));
        Ok(text.map(|c| c.unwrap_or(char::REPLACEMENT_CHARACTER)).collect())
    }

    pub(crate) fn points(&mut self, what: &'static str) -> Result<Vec<Point3>> {
        let count = self.count(24, what)?;
        let bytes = self.take(count.saturating_mul(24), what)?;
        let point = |bytes: &[u8; 24]| {
            let [x, y, z] = bytes.as_chunks::<8>().0 else { return Point3::ORIGIN };
            Point3::new(f64::from_le_bytes(*x), f64::from_le_bytes(*y), f64::from_le_bytes(*z))
        };
        Ok(bytes.as_chunks::<24>().0.iter().map(point).collect())
    }

    pub(crate) fn doubles(&mut self, what: &'static str) -> Result<Vec<f64>> {
        let count = self.count(8, what)?;
        self.doubles_of(count, what)
    }

    /// `count` numbers without a count of their own.
    pub(crate) fn doubles_of(&mut self, count: usize, what: &'static str) -> Result<Vec<f64>> {
        let bytes = self.take(count.saturating_mul(8), what)?;
        Ok(bytes.as_chunks::<8>().0.iter().map(|eight| f64::from_le_bytes(*eight)).collect())
    }

    pub(crate) fn ints(&mut self, what: &'static str) -> Result<Vec<i32>> {
        let count = self.count(4, what)?;
        let bytes = self.take(count.saturating_mul(4), what)?;
        Ok(bytes.as_chunks::<4>().0.iter().map(|four| i32::from_le_bytes(*four)).collect())
    }
}

/// Write side.
impl Writer {
    pub(crate) fn u8(&mut self, value: u8) {
        self.bytes(&[value]);
    }

    pub(crate) fn bool(&mut self, value: bool) {
        self.u8(u8::from(value));
    }

    pub(crate) fn u16(&mut self, value: u16) {
        self.bytes(&value.to_le_bytes());
    }

    pub(crate) fn i32(&mut self, value: i32) {
        self.bytes(&value.to_le_bytes());
    }

    pub(crate) fn u32(&mut self, value: u32) {
        self.bytes(&value.to_le_bytes());
    }

    pub(crate) fn f32(&mut self, value: f32) {
        self.bytes(&value.to_le_bytes());
    }

    pub(crate) fn f64(&mut self, value: f64) {
        self.bytes(&value.to_le_bytes());
    }

    pub(crate) fn packed_version(&mut self, major: u8, minor: u8) {
        self.u8(major << 4 | minor & 15);
    }

    pub(crate) fn point(&mut self, p: Point3) {
        self.f64(p.x);
        self.f64(p.y);
        self.f64(p.z);
    }

    pub(crate) fn vector(&mut self, v: Vector3) {
        self.f64(v.x);
        self.f64(v.y);
        self.f64(v.z);
    }

    pub(crate) fn interval(&mut self, interval: Interval) {
        self.f64(interval.start);
        self.f64(interval.end);
    }

    pub(crate) fn line(&mut self, line: &Line) {
        self.point(line.from);
        self.point(line.to);
    }

    /// A plane, with another last number in its equation than the one that follows from it.
    pub(crate) fn plane_and_offset(&mut self, plane: &Plane, offset: Option<f64>) {
        self.point(plane.origin);
        self.vector(plane.x_axis);
        self.vector(plane.y_axis);
        self.vector(plane.z_axis);
        self.vector(plane.z_axis);
        self.f64(offset.unwrap_or_else(|| plane_offset(plane)));
    }

    /// A circle with its three redundant points at 0, π/2 and π, then the angle range.
    pub(crate) fn arc(&mut self, arc: &Arc, offset: Option<f64>) {
        self.plane_and_offset(&arc.circle.plane, offset);
        self.f64(arc.circle.radius);
        // At the rounded angles, as openNURBS computes them.
        for angle in [0.0, FRAC_PI_2, PI] {
            self.point(arc.circle.at(angle));
        }
        self.interval(arc.angle);
    }

    /// The box openNURBS calls empty, which it also writes where it keeps none.
    pub(crate) fn empty_box(&mut self) {
        EMPTY_BOX.into_iter().for_each(|corner| self.point(corner));
    }

    /// A box, or the empty one.
    pub(crate) fn bounds(&mut self, bounds: Option<BoundingBox>) {
        match bounds {
            Some(bounds) => [bounds.min, bounds.max].into_iter().for_each(|corner| self.point(corner)),
            None => self.empty_box(),
        }
    }

    pub(crate) fn colour(&mut self, colour: [u8; 4]) {
        self.bytes(&colour);
    }

    pub(crate) fn uuid(&mut self, id: Uuid) {
        self.bytes(&id.to_bytes_le());
    }

    /// UTF-16 with a closing zero; empty text has neither.
    pub(crate) fn string(&mut self, text: &str) -> Result<()> {
        let units: Vec<u16> = text.encode_utf16().take_while(|unit| *unit != 0).collect();
        if units.is_empty() {
            self.u32(0);
            return Ok(());
        }
        self.count(units.len() + 1, "characters")?;
        for unit in units {
            self.u16(unit);
        }
        self.u16(0);
        Ok(())
    }

    pub(crate) fn points(&mut self, points: &[Point3]) -> Result<()> {
        self.count(points.len(), "points")?;
        points.iter().for_each(|p| self.point(*p));
        Ok(())
    }

    pub(crate) fn doubles(&mut self, numbers: &[f64]) -> Result<()> {
        self.count(numbers.len(), "numbers")?;
        numbers.iter().for_each(|x| self.f64(*x));
        Ok(())
    }
}
