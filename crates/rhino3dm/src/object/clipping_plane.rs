//! Class ClippingPlaneSurface (section 8): a plane surface that cuts the views.

use katydid_geometry::{Interval, PlaneSurface};
use uuid::Uuid;

use super::major_1;
use crate::chunk::{Reader, Writer};
use crate::{Result, StoredPlane, typecode};

/// A rectangle whose plane cuts away what lies before it in some views.
#[derive(Debug, Clone, PartialEq)]
pub struct ClippingPlane {
    /// The plane of the rectangle that is drawn.
    pub surface_plane: StoredPlane,
    /// The domains of the rectangle in u and v.
    pub domains: [Interval; 2],
    /// The ranges of the plane's coordinates that it covers.
    pub extents: [Interval; 2],
    /// The plane that cuts; its normal points to what stays.
    pub plane: StoredPlane,
    /// Whether it cuts at all.
    pub enabled: bool,
    /// The identifier under which views refer to it.
    pub id: Uuid,
    /// The views it cuts.
    pub viewports: Vec<Uuid>,
    /// How deep it cuts. A depth that is not in use is kept all the same.
    pub depth: f64,
    /// Whether the depth is in use.
    pub depth_enabled: bool,
    /// Which objects it cuts.
    pub participants: Participants,
}

/// The objects that a clipping plane cuts, or those it spares.
#[derive(Debug, Clone, PartialEq)]
pub struct Participants {
    /// Whether these lists are in use; else all objects are cut.
    pub enabled: bool,
    /// Whether the lists name what is spared, not what is cut.
    pub exclude: bool,
    /// Objects by their identifiers.
    pub objects: Vec<Uuid>,
    /// Layers as indices into [`Model::layers`](crate::Model::layers).
    pub layers: Vec<i32>,
}

impl ClippingPlane {
    /// The rectangle that is drawn.
    ///
    /// # Errors
    /// Its plane is not finite, or a range does not increase.
    pub fn surface(&self) -> katydid_geometry::Result<PlaneSurface> {
        PlaneSurface::with_domains(self.surface_plane.frame, self.extents, self.domains)
    }
}

impl Default for Participants {
    fn default() -> Self {
        Self { enabled: false, exclude: true, objects: Vec::new(), layers: Vec::new() }
    }
}

const WHAT: &str = "clipping plane";
/// The number that stands for none in single precision.
const UNSET: f32 = 1.234_321e38;

const OBJECTS: u8 = 10;
const LAYERS: u8 = 11;
const EXCLUDE: u8 = 12;
const ENABLED: u8 = 13;

pub(super) fn read(body: &mut Reader<'_>) -> Result<ClippingPlane> {
    let (mut outer, _) = body.versioned_1(WHAT)?;
    let mut inner = outer.anonymous(WHAT)?;
    let minor = major_1(&mut inner, WHAT)?;
    let surface_plane = inner.stored_plane(WHAT)?;
    let domains = [inner.interval(WHAT)?, inner.interval(WHAT)?];
    let extents = if minor >= 1 { [inner.interval(WHAT)?, inner.interval(WHAT)?] } else { domains };
    inner.finish();
    let (mut body, minor) = outer.versioned_1(WHAT)?;
    let single = body.uuid(WHAT)?;
    let mut clipping = ClippingPlane {
        surface_plane,
        domains,
        extents,
        id: body.uuid(WHAT)?,
        plane: body.stored_plane(WHAT)?,
        enabled: body.bool(WHAT)?,
        viewports: vec![single],
        depth: 0.0,
        depth_enabled: false,
        participants: Participants::default(),
    };
    if minor >= 1 {
        clipping.viewports = body.id_list(WHAT)?;
    }
    if minor >= 2 {
        let depth = body.f64(WHAT)?;
        // Before 1.4 the number alone says whether there is a depth.
        clipping.depth_enabled =
            if minor >= 4 { body.bool(WHAT)? } else { depth >= 0.0 && depth != f64::from(UNSET) };
        clipping.depth = if minor >= 4 || clipping.depth_enabled { depth } else { 0.0 };
    }
    if minor >= 5 {
        clipping.participants = read_participants(&mut body)?;
    }
    body.finish();
    Ok(clipping)
}

/// Items of a code and a value in ascending order, ended by 0 or by a code of a later version.
fn read_participants(body: &mut Reader<'_>) -> Result<Participants> {
    let mut list = Participants::default();
    loop {
        match body.u8(WHAT)? {
            OBJECTS => {
                let count = body.count(16, WHAT)?;
                list.objects = (0..count).map(|_| body.uuid(WHAT)).collect::<Result<_>>()?;
            }
            LAYERS => list.layers = body.ints(WHAT)?,
            EXCLUDE => list.exclude = body.bool(WHAT)?,
            ENABLED => list.enabled = body.bool(WHAT)?,
            _ => return Ok(list),
        }
    }
}

pub(super) fn write(clipping: &ClippingPlane, w: &mut Writer) -> Result<()> {
    w.versioned(1, 0, |w| {
        w.chunk(typecode::ANONYMOUS, |w| {
            w.packed_version(1, 1);
            w.stored_plane(&clipping.surface_plane);
            clipping.domains.into_iter().chain(clipping.extents).for_each(|range| w.interval(range));
            Ok(())
        })?;
        w.versioned(1, 5, |w| {
            w.uuid(clipping.viewports.first().copied().unwrap_or_default());
            w.uuid(clipping.id);
            w.stored_plane(&clipping.plane);
            w.bool(clipping.enabled);
            w.id_list(&clipping.viewports)?;
            w.f64(clipping.depth);
            w.bool(clipping.depth_enabled);
            write_participants(&clipping.participants, w)
        })
    })
}

fn write_participants(list: &Participants, w: &mut Writer) -> Result<()> {
    if !list.objects.is_empty() {
        w.u8(OBJECTS);
        w.count(list.objects.len(), "objects")?;
        list.objects.iter().for_each(|id| w.uuid(*id));
    }
    if !list.layers.is_empty() {
        w.u8(LAYERS);
        w.count(list.layers.len(), "layers")?;
        list.layers.iter().for_each(|number| w.i32(*number));
    }
    if !list.exclude {
        w.u8(EXCLUDE);
        w.bool(false);
    }
    if list.enabled {
        w.u8(ENABLED);
        w.bool(true);
    }
    w.u8(0);
    Ok(())
}
