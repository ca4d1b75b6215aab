//! Views, construction planes and page settings written anew, with what programs take where nothing is said.

use katydid_geometry::{Plane, Point3, Vector3};
use uuid::Uuid;

use super::view::{NAME, PLANE, TARGET, VIEWPORT};
use crate::chunk::Writer;
use crate::{Result, StoredPlane, typecode};

/// The number that stands for none.
const UNSET: f64 = -1.234_321_012_343_21e308;

/// Chunks of a view beside those that are read.
const DISPLAY_MODE: u32 = typecode::SHORT | 0x2000_093B;
const POSITION: u32 = 0x2000_8B3B;
const SHOWS_GRID: u32 = typecode::SHORT | 0x2000_033B;
const SHOWS_GRID_AXES: u32 = typecode::SHORT | 0x2000_043B;
const SHOWS_WORLD_AXES: u32 = typecode::SHORT | 0x2000_053B;
const TRACE: u32 = 0x2000_863B;
const WALLPAPER_FILE: u32 = 0x2000_873B;
const WALLPAPER: u32 = 0x2000_874B;
const ATTRIBUTES: u32 = 0x2000_8C3B;

/// A view as far as version 1 knows it.
#[derive(Debug, Clone, PartialEq)]
pub(crate) struct PlainView {
    pub(crate) name: String,
    /// Whether it is the view of a detail on a page.
    pub(crate) nested: bool,
    pub(crate) perspective: bool,
    pub(crate) camera: Point3,
    pub(crate) direction: Vector3,
    pub(crate) up: Vector3,
    /// Nothing in a view that shows nothing in particular.
    pub(crate) target: Option<Point3>,
    /// Left, right, bottom, top, near, far.
    pub(crate) frustum: [f64; 6],
    pub(crate) plane: PlainPlane,
    /// Left, right, top and bottom as parts of the window.
    pub(crate) position: [f64; 4],
    pub(crate) maximised: bool,
    pub(crate) shows_grid: bool,
    pub(crate) shows_grid_axes: bool,
    pub(crate) shows_world_axes: bool,
    /// The display mode: its number in old archives, and its identifier.
    pub(crate) display_mode: (i64, Uuid),
    pub(crate) trace_plane: StoredPlane,
    pub(crate) trace_size: [f64; 2],
    pub(crate) trace_file: String,
    pub(crate) wallpaper_file: String,
}

/// A construction plane with its grid.
#[derive(Debug, Clone, PartialEq)]
pub(crate) struct PlainPlane {
    pub(crate) name: String,
    pub(crate) plane: StoredPlane,
    /// The distance of grid lines, to which points snap.
    pub(crate) spacing: f64,
    pub(crate) lines: i32,
    pub(crate) thick_every: i32,
}

impl Default for PlainView {
    /// The world from above.
    fn default() -> Self {
        Self {
            name: String::new(),
            nested: false,
            perspective: false,
            camera: Point3::new(0.0, 0.0, 100.0),
            direction: Vector3::new(-0.0, -0.0, -1.0),
            up: Vector3::new(0.0, 1.0, 0.0),
            target: None,
            frustum: [-20.0, 20.0, -20.0, 20.0, 1e-4, 1000.0],
            plane: PlainPlane::default(),
            position: [0.0, 1.0, 0.0, 1.0],
            maximised: false,
            shows_grid: true,
            shows_grid_axes: true,
            shows_world_axes: true,
            display_mode: (0, Uuid::nil()),
            trace_plane: from_frame(Plane::XY),
            trace_size: [0.0; 2],
            trace_file: String::new(),
            wallpaper_file: String::new(),
        }
    }
}

impl Default for PlainPlane {
    fn default() -> Self {
        let plane = from_frame(Plane::XY);
        Self { name: String::new(), plane, spacing: 1.0, lines: 70, thick_every: 5 }
    }
}

/// A plane with the equation that programs compute from a frame, its zeros below zero.
fn from_frame(frame: Plane) -> StoredPlane {
    let (n, o) = (frame.z_axis, frame.origin);
    StoredPlane { frame, equation: Some([n.x, n.y, n.z, -(n.x * o.x + n.y * o.y + n.z * o.z)]) }
}

/// The plane of an origin and two directions, the second made perpendicular to the first.
pub(crate) fn plane_of(origin: Point3, x: Vector3, y: Vector3) -> StoredPlane {
    let x_axis = unit(x);
    let y_axis = unit(y - x_axis * y.dot(x_axis));
    from_frame(Plane { origin, x_axis, y_axis, z_axis: unit(x_axis.cross(y_axis)) })
}

/// A vector made of length 1, to the last bit as programs do it: its length comes from the greatest component and
/// what the others are of that. One without length stays as it is.
fn unit(v: Vector3) -> Vector3 {
    let [x, y, z] = [v.x.abs(), v.y.abs(), v.z.abs()];
    let (greatest, first, second) = if y >= x && y >= z {
        (y, x, z)
    } else if z >= x && z >= y {
        (z, y, x)
    } else {
        (x, y, z)
    };
    let (a, b) = (first / greatest, second / greatest);
    let length = greatest * (1.0 + a * a + b * b).sqrt();
    if length >= f64::MIN_POSITIVE && length.is_finite() { v / length } else { v }
}

impl PlainView {
    /// Writes the chunks of a view.
    pub(crate) fn write(&self, w: &mut Writer) -> Result<()> {
        w.chunk(VIEWPORT, |w| {
            self.write_viewport(w);
            Ok(())
        })?;
        w.chunk(PLANE, |w| self.plane.write(w))?;
        w.chunk(TARGET, |w| {
            w.point(self.target_or_unset());
            Ok(())
        })?;
        w.short(DISPLAY_MODE, self.display_mode.0);
        w.chunk(POSITION, |w| {
            w.packed_version(1, 1);
            w.i32(i32::from(self.maximised));
            self.position.iter().for_each(|part| w.f64(*part));
            w.u8(0);
            Ok(())
        })?;
        w.short(SHOWS_GRID, i64::from(self.shows_grid));
        w.short(SHOWS_GRID_AXES, i64::from(self.shows_grid_axes));
        w.short(SHOWS_WORLD_AXES, i64::from(self.shows_world_axes));
        w.chunk(NAME, |w| w.string(&self.name))?;
        self.write_images(w)?;
        w.chunk(ATTRIBUTES, |w| self.write_attributes(w))?;
        w.short(typecode::END_OF_TABLE, 0);
        Ok(())
    }

    fn target_or_unset(&self) -> Point3 {
        self.target.unwrap_or(Point3::new(UNSET, UNSET, UNSET))
    }

    fn write_viewport(&self, w: &mut Writer) {
        w.packed_version(1, 5);
        // Camera and frustum are valid; where nothing is shown in particular, the port is not.
        let has_port = self.target.is_some();
        [1, 1, i32::from(has_port), 1 + i32::from(self.perspective)].iter().for_each(|number| w.i32(*number));
        w.point(self.camera);
        w.vector(self.direction);
        w.vector(self.up);
        let z = unit(-self.direction);
        let y = unit(self.up - z * self.up.dot(z));
        [unit(y.cross(z)), y, z].iter().for_each(|axis| w.vector(*axis));
        self.frustum.iter().for_each(|side| w.f64(*side));
        let port = if has_port { [0, 100, 100, 0, 0, 0xFFFF] } else { [0, 1000, 0, 1000, 0, 1] };
        port.iter().for_each(|edge| w.i32(*edge));
        w.uuid(Uuid::nil());
        // Locks of the camera, and symmetry of the frustum.
        w.bytes(&[0; 5]);
        w.point(self.target_or_unset());
        // The frame of the camera is valid; scales of the view.
        w.u8(1);
        [1.0, 1.0, 0.0].iter().for_each(|scale| w.f64(*scale));
    }

    fn write_images(&self, w: &mut Writer) -> Result<()> {
        w.chunk(TRACE, |w| {
            w.packed_version(1, 3);
            w.string(&self.trace_file)?;
            self.trace_size.iter().for_each(|side| w.f64(*side));
            w.stored_plane(&self.trace_plane);
            // In grey; neither hidden nor filtered.
            w.bytes(&[1, 0, 0]);
            Ok(())
        })?;
        w.chunk(WALLPAPER_FILE, |w| w.string(&self.wallpaper_file))?;
        w.chunk(WALLPAPER, |w| {
            w.packed_version(1, 1);
            w.string(&self.wallpaper_file)?;
            w.bytes(&[1, 0]);
            Ok(())
        })
    }

    fn write_attributes(&self, w: &mut Writer) -> Result<()> {
        w.packed_version(1, 3);
        const NESTED: i32 = 2;
        // A view of the model, without a page of old, a parent and a place in it.
        w.i32(if self.nested { NESTED } else { 0 });
        [0.0; 2].iter().for_each(|size| w.f64(*size));
        w.uuid(Uuid::nil());
        w.empty_box();
        w.uuid(self.display_mode.1);
        // A page without number, size, margins and printer.
        w.versioned(1, 0, |w| {
            w.i32(0);
            [0.0; 6].iter().for_each(|size| w.f64(*size));
            w.string("")
        })?;
        w.bool(false);
        Ok(())
    }
}

impl PlainPlane {
    /// Writes the body of a construction plane.
    pub(crate) fn write(&self, w: &mut Writer) -> Result<()> {
        w.packed_version(1, 1);
        w.stored_plane(&self.plane);
        // Points snap to grid lines.
        [self.spacing; 2].iter().for_each(|spacing| w.f64(*spacing));
        w.i32(self.lines);
        w.i32(self.thick_every);
        w.string(&self.name)?;
        w.bool(true);
        Ok(())
    }
}

/// Writes the body of page settings that say nothing: pages in millimetres, and no place on the Earth.
pub(crate) fn write_plain_page(w: &mut Writer) -> Result<()> {
    const MILLIMETRES: i32 = 2;
    w.packed_version(1, 3);
    w.f64(1.0);
    // No colour in print, and no linetype; both those of the layer.
    w.colour([255; 4]);
    [0, -1, 0].iter().for_each(|number| w.i32(*number));
    w.versioned(1, 0, |w| {
        w.i32(102);
        w.i32(MILLIMETRES);
        [0.001, std::f64::consts::PI / 180.0, 0.01].iter().for_each(|tolerance| w.f64(*tolerance));
        [0, 3].iter().for_each(|number| w.i32(*number));
        w.f64(0.001);
        w.string("")
    })?;
    w.uuid(Uuid::nil());
    w.point(Point3::ORIGIN);
    w.versioned(1, 1, |w| {
        [0.0; 3].iter().for_each(|number| w.f64(*number));
        w.point(Point3::ORIGIN);
        w.vector(Vector3::new(0.0, 1.0, 0.0));
        w.vector(Vector3::new(1.0, 0.0, 0.0));
        w.i32(0);
        w.uuid(Uuid::nil());
        (0..4).try_for_each(|_| w.string(""))
    })
}
