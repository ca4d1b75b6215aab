//! Views and construction planes (section 5).

use katydid_geometry::{Plane, Point3, Vector3};
use uuid::Uuid;

use crate::Result;
use crate::chunk::Reader;

/// The chunk of a view in a list of views.
pub(crate) const VIEW: u32 = 0x2000_803B;
/// The chunk of a construction plane in a list or a view.
pub(crate) const PLANE: u32 = 0x2000_813B;
pub(crate) const VIEWPORT: u32 = 0x2000_823B;
pub(crate) const TARGET: u32 = 0x2000_883B;
pub(crate) const NAME: u32 = 0x2000_8A3B;

/// A view of the model.
#[derive(Debug, Clone, PartialEq)]
pub struct View {
    /// Its name.
    pub name: String,
    /// Identifies its viewport; nil in old archives.
    pub id: Uuid,
    /// Parallel or in perspective.
    pub projection: ViewProjection,
    /// Where the camera is.
    pub camera: Point3,
    /// Where it looks.
    pub direction: Vector3,
    /// What it takes for up.
    pub up: Vector3,
    /// What it looks at.
    pub target: Point3,
    /// Left, right, bottom, top, near and far side of what is seen; the sides at the near distance.
    pub frustum: [f64; 6],
    /// Left, right, bottom and top edge on the screen in pixels.
    pub port: [i32; 4],
    /// Its construction plane.
    pub construction_plane: Option<ConstructionPlane>,
}

/// How a view shows depth.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum ViewProjection {
    /// Not at all.
    Parallel,
    /// What is far is small.
    Perspective,
    /// Another number.
    Other(i32),
}

/// A plane to draw on, with its grid.
#[derive(Debug, Clone, PartialEq)]
pub struct ConstructionPlane {
    /// Its name; may be empty.
    pub name: String,
    /// The plane.
    pub plane: Plane,
    /// The distance of grid lines.
    pub grid_spacing: f64,
    /// The distance of the points that points snap to.
    pub snap_spacing: f64,
    /// How many grid lines there are to each side.
    pub grid_lines: i32,
    /// Every how many of them one is thick.
    pub thick_every: i32,
}

const WHAT: &str = "view";

impl View {
    pub(crate) fn read(body: &mut Reader<'_>) -> Result<Self> {
        let (origin, none) = (Point3::ORIGIN, Vector3::new(0.0, 0.0, 0.0));
        let mut view = Self {
            name: String::new(),
            id: Uuid::nil(),
            projection: ViewProjection::Parallel,
            camera: origin,
            direction: none,
            up: none,
            target: origin,
            frustum: [0.0; 6],
            port: [0; 4],
            construction_plane: None,
        };
        while !body.is_at_end() {
            let mut chunk = body.chunk()?;
            match chunk.typecode {
                VIEWPORT => view.read_viewport(&mut chunk.body)?,
                PLANE => view.construction_plane = Some(ConstructionPlane::read(&mut chunk.body)?),
                TARGET => view.target = chunk.body.point(WHAT)?,
                NAME => view.name = chunk.body.string(WHAT)?,
                _ => {}
            }
        }
        Ok(view)
    }

    fn read_viewport(&mut self, body: &mut Reader<'_>) -> Result<()> {
        let (_, minor) = body.packed_version(WHAT)?;
        // Whether camera, frustum and port are valid.
        body.take(12, WHAT)?;
        self.projection = match body.i32(WHAT)? {
            1 => ViewProjection::Parallel,
            2 => ViewProjection::Perspective,
            other => ViewProjection::Other(other),
        };
        self.camera = body.point(WHAT)?;
        self.direction = body.vector(WHAT)?;
        self.up = body.vector(WHAT)?;
        // The axes, which follow from those.
        body.take(72, WHAT)?;
        for side in &mut self.frustum {
            *side = body.f64(WHAT)?;
        }
        for edge in &mut self.port {
            *edge = body.i32(WHAT)?;
        }
        // The near and far end of the port.
        body.take(8, WHAT)?;
        if minor >= 1 {
            self.id = body.uuid(WHAT)?;
        }
        Ok(())
    }
}

impl ConstructionPlane {
    pub(crate) fn read(body: &mut Reader<'_>) -> Result<Self> {
        const WHAT: &str = "construction plane";
        body.packed_version(WHAT)?;
        let plane = body.plane(WHAT)?;
        let (grid_spacing, snap_spacing) = (body.f64(WHAT)?, body.f64(WHAT)?);
        let (grid_lines, thick_every) = (body.i32(WHAT)?, body.i32(WHAT)?);
        Ok(Self { plane, grid_spacing, snap_spacing, grid_lines, thick_every, name: body.string(WHAT)? })
    }
}
