//! Views and named construction planes of version 1, restated as records of version 50.
//!
//! A view is a target that the camera looks at, three angles, a distance and a size; the window it was seen in is
//! not known, so the picture counts as square. Arithmetic as the official reader does it, to the last bit.

use katydid_geometry::Vector3;
use uuid::{Uuid, uuid};

use super::{text, typecode as code};
use crate::chunk::{Reader, Writer};
use crate::tables::{KeptRecord, Table};
use crate::version::Version;
use crate::views::{self, PlainPlane, PlainView, plane_of};
use crate::{Error, Result, StoredPlane, typecode};

const WHAT: &str = "view";
/// The version of the records: the first whose chunk lengths later ones share.
const VERSION: i32 = 50;
const PERSPECTIVE: i32 = 2;
/// What stands in for a distance and a size that cannot be any.
const DISTANCE: f64 = 100.0;
const SIZE: f64 = 0.125;
/// The sides of the window that a view counts as seen in, in pixels.
const SIDE: f64 = 100.0;
/// The near side is never farther away than this.
const FARTHEST_NEAR: f64 = 1.0;
/// Display modes: their numbers in archives before version 4, and their identifiers since.
const WIREFRAME: (i64, Uuid) = (1, uuid!("1311ADCB-D89E-4051-A3F0-F64441FB8EC6"));
const SHADED: (i64, Uuid) = (2, uuid!("8BC8DEBE-C83B-4C47-B13C-9DB074510CAC"));

/// The lists of views and construction planes.
#[derive(Debug, Default)]
pub(super) struct Views {
    views: Vec<PlainView>,
    named_views: Vec<PlainView>,
    named_planes: Vec<PlainPlane>,
}

impl Views {
    /// Adds what a chunk holds.
    pub(super) fn take(&mut self, typecode: u32, body: &mut Reader<'_>) -> Result<()> {
        match typecode {
            code::NAMED_VIEW => self.named_views.push(read_view(body)?),
            code::NAMED_PLANE => self.named_planes.push(read_named_plane(body)?),
            _ => self.views.push(read_view(body)?),
        }
        Ok(())
    }

    /// The records that later archives have for the lists, and the settings of pages, which version 1 has not.
    pub(super) fn into_records(self) -> Result<Vec<KeptRecord>> {
        let mut records = vec![record(typecode::SETTINGS_ATTRIBUTES, views::write_plain_page)?];
        if !self.named_planes.is_empty() {
            records.push(record(typecode::NAMED_PLANES, |w| {
                list(&self.named_planes, views::PLANE, w, |plane, w| plane.write(w))
            })?);
        }
        for (typecode, views) in [(typecode::NAMED_VIEWS, self.named_views), (typecode::VIEWS, self.views)] {
            if !views.is_empty() {
                records.push(record(typecode, |w| list(&views, views::VIEW, w, |view, w| view.write(w)))?);
            }
        }
        Ok(records)
    }
}

/// A count and a chunk an item.
fn list<T>(
    items: &[T],
    typecode: u32,
    w: &mut Writer,
    write: impl Fn(&T, &mut Writer) -> Result<()>,
) -> Result<()> {
    w.count(items.len(), "views")?;
    items.iter().try_for_each(|item| w.chunk(typecode, |w| write(item, w)))
}

/// A record of the settings table.
fn record(typecode: u32, body: impl FnOnce(&mut Writer) -> Result<()>) -> Result<KeptRecord> {
    let mut w = Writer::new(Version::for_writing(VERSION)?);
    w.chunk(typecode, body)?;
    Ok(KeptRecord::of_chunk(Table::Settings, typecode, w))
}

/// The chunks of a view up to the end of their table.
fn read_view(chunks: &mut Reader<'_>) -> Result<PlainView> {
    let mut view = PlainView::default();
    while chunks.left() >= 8 {
        if chunks.peek_typecode() == Some(code::HIDE_TRACE) {
            // A chunk of early programs that should have been a short one.
            chunks.take(8, WHAT)?;
            continue;
        }
        let chunk = chunks.chunk()?;
        let mut body = chunk.body;
        let on = chunk.value != 0;
        match chunk.typecode {
            code::NAME => view.name = text::counted(&mut body, WHAT)?,
            code::PLANE => read_plane(&mut body, &mut view.plane)?,
            code::VIEW => read_camera(&mut body, &mut view)?,
            code::SHOWS_GRID => view.shows_grid = on,
            code::SHOWS_GRID_AXES => view.shows_grid_axes = on,
            code::SHOWS_WORLD_AXES => view.shows_world_axes = on,
            code::VIEW_POSITION => {
                let [left, top, right, bottom] = quadruple(&mut body)?;
                view.position = [left, right, top, bottom];
            }
            code::MAXIMISED => view.maximised |= on,
            code::TRACE => {
                view.trace_plane = read_frame(&mut body)?;
                view.trace_size = [body.f64(WHAT)?, body.f64(WHAT)?];
                view.trace_file = text::counted(&mut body, WHAT)?;
            }
            code::WALLPAPER => view.wallpaper_file = text::counted(&mut body, WHAT)?,
            code::DISPLAY_MODE if view.display_mode.1.is_nil() => match chunk.value {
                0 => view.display_mode = WIREFRAME,
                1 => view.display_mode = SHADED,
                _ => {}
            },
            typecode::END_OF_TABLE => break,
            _ => {}
        }
    }
    Ok(view)
}

fn quadruple(body: &mut Reader<'_>) -> Result<[f64; 4]> {
    Ok([body.f64(WHAT)?, body.f64(WHAT)?, body.f64(WHAT)?, body.f64(WHAT)?])
}

fn read_named_plane(chunks: &mut Reader<'_>) -> Result<PlainPlane> {
    let mut plane = PlainPlane::default();
    while chunks.left() >= 8 {
        let mut chunk = chunks.chunk()?;
        match chunk.typecode {
            code::NAME => plane.name = text::counted(&mut chunk.body, WHAT)?,
            code::PLANE => read_plane(&mut chunk.body, &mut plane)?,
            typecode::END_OF_TABLE => break,
            _ => {}
        }
    }
    Ok(plane)
}

/// A construction plane and its grid.
fn read_plane(body: &mut Reader<'_>, plane: &mut PlainPlane) -> Result<()> {
    plane.plane = read_frame(body)?;
    plane.spacing = body.f64(WHAT)?;
    plane.lines = body.i32(WHAT)?;
    plane.thick_every = body.i32(WHAT)?;
    Ok(())
}

/// A plane by its origin and two axes.
fn read_frame(body: &mut Reader<'_>) -> Result<StoredPlane> {
    Ok(plane_of(body.point(WHAT)?, body.vector(WHAT)?, body.vector(WHAT)?))
}

/// Where the camera is, and what it sees.
fn read_camera(body: &mut Reader<'_>, view: &mut PlainView) -> Result<()> {
    let offset = body.offset();
    let projection = body.i32(WHAT)?;
    body.i32(WHAT)?;
    let target = body.point(WHAT)?;
    let angles = [body.f64(WHAT)?, body.f64(WHAT)?, body.f64(WHAT)?];
    let possible = |x: f64, instead: f64| if x > 0.0 && x < f64::MAX / 2.0 { x } else { instead };
    let size = possible(body.f64(WHAT)?, SIZE);
    let distance = possible(body.f64(WHAT)?, DISTANCE);
    let finite = [target.x, target.y, target.z].iter().chain(&angles).all(|x| x.is_finite());
    if !finite {
        return Err(Error::malformed(offset, WHAT, "its camera is nowhere"));
    }
    let [twist, elevation, fudge] = angles;
    let turn = product(product(about_z(fudge), about_x(elevation)), about_z(twist));
    let turned = |axis: usize| Vector3::new(turn[0][axis], turn[1][axis], turn[2][axis]);
    view.perspective = projection == PERSPECTIVE;
    view.up = turned(1);
    view.direction = -turned(2);
    view.camera = target - view.direction * distance;
    view.target = Some(target);
    let near = (distance / 64.0).min(FARTHEST_NEAR);
    let scale = if view.perspective { near } else { 1.0 };
    // The height follows from the width and the sides of the window, which rounds it.
    let [half, upright] = [size * scale, size * SIDE / SIDE * scale];
    view.frustum = [-half, half, -upright, upright, near, 4.0 * distance];
    Ok(())
}

/// Three rows of a rotation.
type Rotation = [[f64; 3]; 3];

/// Sine and cosine of an angle, their noise near right angles taken away.
fn sine_and_cosine(angle: f64) -> (f64, f64) {
    const NOISE: f64 = 1.490_116_119_385e-8;
    // The system's, as the official reader asks for them: its bits count here.
    let (sine, cosine) = angle.sin_cos();
    if cosine.abs() <= NOISE {
        (sine.signum(), 0.0)
    } else if sine.abs() <= NOISE {
        (0.0, cosine.signum())
    } else {
        (sine, cosine)
    }
}

fn about_z(angle: f64) -> Rotation {
    let (s, c) = sine_and_cosine(angle);
    [[c, -s, 0.0], [s, c, 0.0], [0.0, 0.0, (1.0 - c) + c]]
}

fn about_x(angle: f64) -> Rotation {
    let (s, c) = sine_and_cosine(angle);
    [[(1.0 - c) + c, 0.0, 0.0], [0.0, c, -s], [0.0, s, c]]
}

/// The rotation `b`, then `a`. No zero comes out below zero.
fn product(a: Rotation, b: Rotation) -> Rotation {
    a.map(|row| std::array::from_fn(|j| row[0] * b[0][j] + row[1] * b[1][j] + row[2] * b[2][j] + 0.0))
}
