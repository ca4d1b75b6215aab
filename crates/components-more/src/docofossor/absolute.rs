//! Operations at heights of their own: points, paths and surfaces that the terrain is brought to.

use std::sync::Arc as Shared;

use katydid_component::{Context, List, Message, component};
use katydid_data::{Kind, Value};
use katydid_elementary::Elementary as _;
use katydid_geometry::{Curve, Mesh, MeshSettings, MeshTree, Point3, PolylineCurve, Vector3};

use super::path::{Near, Paths};
use super::{SLOPE, Terrain, length, rise};

/// What may happen to a terrain.
#[derive(Debug, Clone, Copy, PartialEq)]
struct Ways {
    cut: bool,
    fill: bool,
}

impl Ways {
    const BOTH: Self = Self { cut: true, fill: true };
    const CUT: Self = Self { cut: true, fill: false };
    const FILL: Self = Self { cut: false, fill: true };

    /// A height brought between the lowest that a fill makes and the highest that a cut leaves.
    fn bring(self, z: f64, target: f64, slope: f64) -> f64 {
        let z = if self.cut { z.min(target + slope) } else { z };
        if self.fill { z.max(target - slope) } else { z }
    }
}

/// Cones of cut or fill at points.
fn cones(
    context: &Context<'_>,
    grid: &List<'_, f64>,
    points: &List<'_, Point3>,
    degrees: f64,
    most: f64,
    ways: Ways,
) -> Result<(Vec<f64>, f64), Message> {
    let mut terrain = Terrain::of(context, grid)?;
    let (rise, most) = (rise(degrees)?, length(most, "The greatest distance")?);
    let points: Vec<Point3> = points.present().filter(|p| p.is_finite()).collect();
    let volume = terrain.change(context, |[x, y], z| {
        points.iter().fold(z, |z, p| {
            let far = (p.x - x).hypotenuse(p.y - y);
            if far <= most { ways.bring(z, p.z, far * rise) } else { z }
        })
    })?;
    Ok((terrain.list(), volume))
}

/// Cuts cones whose tips are points. Stands for Docofossor's Cut In Point; the straight sides are our reading.
#[component(
    "a457cd6d-5cc1-48b6-8942-e23db754cff7",
    name = "Cut In Point",
    nick = "dfCutInPoint",
    at = "Docofossor/Absolute"
)]
#[output("df", "df", "The grid, as a list of numbers.", kind = Number)]
#[output("vol", "vol", "The volume that is added: negative for a cut.")]
fn cut_in_point(
    context: &Context<'_>,
    /// The grid, as a list of numbers.
    #[port("df", "df")]
    grid: List<f64>,
    /// The deepest places.
    #[port("pt", "pt")]
    points: List<Point3>,
    /// The slope, in degrees.
    #[port("sa", "sa", default = SLOPE)]
    slope: f64,
    /// The greatest distance from a point, in units, seen from above.
    #[port("d", "d", default = 30.0)]
    most: f64,
) -> Result<(Vec<f64>, f64), Message> {
    cones(context, &grid, &points, slope, most, Ways::CUT)
}

/// Fills cones whose tips are points. Stands for Docofossor's Fill In Point.
#[component(
    "21cfa018-f35b-4cfd-8635-f426253d1880",
    name = "Fill In Point",
    nick = "dfFillInPoint",
    at = "Docofossor/Absolute"
)]
#[output("df", "df", "The grid, as a list of numbers.", kind = Number)]
#[output("vol", "vol", "The volume that is added.")]
fn fill_in_point(
    context: &Context<'_>,
    /// The grid, as a list of numbers.
    #[port("df", "df")]
    grid: List<f64>,
    /// The highest places.
    #[port("pt", "pt")]
    points: List<Point3>,
    /// The slope, in degrees.
    #[port("sa", "sa", default = SLOPE)]
    slope: f64,
    /// The greatest distance from a point, in units, seen from above.
    #[port("d", "d", default = 30.0)]
    most: f64,
) -> Result<(Vec<f64>, f64), Message> {
    cones(context, &grid, &points, slope, most, Ways::FILL)
}

/// A band along paths at the paths' heights, with slopes beside it.
struct Band {
    width: f64,
    rises: [f64; 2],
    most: f64,
}

impl Band {
    fn new(width: f64, left: f64, right: Option<f64>, most: f64) -> Result<Self, Message> {
        let rises = [rise(left)?, rise(right.unwrap_or(left))?];
        let (width, most) = (length(width, "The width")?, length(most, "The greatest distance")?);
        Ok(Self { width, rises, most })
    }

    fn slope(&self, near: &Near) -> f64 {
        let [left, right] = self.rises;
        (near.distance - self.width / 2.0).max(0.0) * if near.is_left { left } else { right }
    }

    fn along(
        &self,
        context: &Context<'_>,
        grid: &List<'_, f64>,
        curves: &List<'_, Shared<Curve>>,
        ways: Ways,
    ) -> Result<(Vec<f64>, f64), Message> {
        let mut terrain = Terrain::of(context, grid)?;
        let paths = Paths::of_list(context, curves, terrain.cell)?;
        let volume = terrain.change(context, |place, z| {
            paths.near(place, self.most).map_or(z, |near| ways.bring(z, near.height, self.slope(&near)))
        })?;
        Ok((terrain.list(), volume))
    }
}

/// Brings the terrain along paths to their heights, cut and filled, with slopes beside. Stands for Docofossor's Cut & Fill In Path.
#[component(
    "c710f587-ce79-487f-9c26-c555b5124a47",
    name = "Cut & Fill In Path",
    nick = "dfCutFillInPath",
    at = "Docofossor/Absolute"
)]
#[output("df", "df", "The grid, as a list of numbers.", kind = Number)]
#[output("vol", "vol", "The volume that is added, less what is cut.")]
fn cut_fill_in_path(
    context: &Context<'_>,
    /// The grid, as a list of numbers.
    #[port("df", "df")]
    grid: List<f64>,
    /// The paths.
    #[port("crv", "crv")]
    curves: List<Shared<Curve>>,
    /// The width of the band at the paths' heights, in units.
    #[port("w", "w", default = 1.0)]
    width: f64,
    /// The slope at the left, in degrees.
    #[port("sa", "sa", default = SLOPE)]
    slope: f64,
    /// The slope at the right; as at the left when nothing is given.
    #[port("sa2", "sa2", optional)]
    right: Option<f64>,
    /// The greatest distance from the paths, in units, seen from above.
    #[port("d", "d", default = 30.0)]
    most: f64,
) -> Result<(Vec<f64>, f64), Message> {
    Band::new(width, slope, right, most)?.along(context, &grid, &curves, Ways::BOTH)
}

/// Cuts the terrain along paths down to their heights, with slopes beside. Stands for Docofossor's Cut In Path.
#[component(
    "6b1c7c1e-0d4e-4e3a-9d5c-3f0a5a6f2a0f",
    name = "Cut In Path",
    nick = "dfCutInPath",
    at = "Docofossor/Absolute"
)]
#[output("df", "df", "The grid, as a list of numbers.", kind = Number)]
#[output("vol", "vol", "The volume that is added: negative for a cut.")]
fn cut_in_path(
    context: &Context<'_>,
    /// The grid, as a list of numbers.
    #[port("df", "df")]
    grid: List<f64>,
    /// The paths.
    #[port("crv", "crv")]
    curves: List<Shared<Curve>>,
    /// The width of the band at the paths' heights, in units.
    #[port("wb", "wb", default = 1.0)]
    width: f64,
    /// The slope at the left, in degrees.
    #[port("sa", "sa", default = SLOPE)]
    slope: f64,
    /// The slope at the right; as at the left when nothing is given.
    #[port("sa2", "sa2", optional)]
    right: Option<f64>,
    /// The greatest distance from the paths, in units, seen from above.
    #[port("d", "d", default = 30.0)]
    most: f64,
) -> Result<(Vec<f64>, f64), Message> {
    Band::new(width, slope, right, most)?.along(context, &grid, &curves, Ways::CUT)
}

/// Fills the terrain along paths up to their heights, with slopes beside. Stands for Docofossor's Fill In Path.
#[component(
    "6b1c7c1e-0d4e-4e3a-9d5c-3f0a5a6f2a10",
    name = "Fill In Path",
    nick = "dfFillInPath",
    at = "Docofossor/Absolute"
)]
#[output("df", "df", "The grid, as a list of numbers.", kind = Number)]
#[output("vol", "vol", "The volume that is added.")]
fn fill_in_path(
    context: &Context<'_>,
    /// The grid, as a list of numbers.
    #[port("df", "df")]
    grid: List<f64>,
    /// The paths.
    #[port("crv", "crv")]
    curves: List<Shared<Curve>>,
    /// The width of the band at the paths' heights, in units.
    #[port("wt", "wt", default = 1.0)]
    width: f64,
    /// The slope at the left, in degrees.
    #[port("sa", "sa", default = SLOPE)]
    slope: f64,
    /// The slope at the right; as at the left when nothing is given.
    #[port("sa2", "sa2", optional)]
    right: Option<f64>,
    /// The greatest distance from the paths, in units, seen from above.
    #[port("d", "d", default = 30.0)]
    most: f64,
) -> Result<(Vec<f64>, f64), Message> {
    Band::new(width, slope, right, most)?.along(context, &grid, &curves, Ways::FILL)
}

/// A surface as a mesh that strays less than a tenth of a cell, or the mesh that it is.
fn mesh_of(context: &Context<'_>, shape: &Value, cell: f64) -> Result<Shared<Mesh>, Message> {
    if let Value::Mesh(mesh) = shape {
        return Ok(mesh.clone());
    }
    let brep = katydid_data::cast::value(shape, Kind::Brep, context.rules()).and_then(|made| made.brep());
    match brep.transpose().map_err(Message::error)? {
        Some(brep) => {
            let settings = MeshSettings::within(cell * 0.1);
            Ok(Shared::new(brep.mesh_unless(&settings, &context.stop())?.welded()?))
        }
        None => Err(Message::error("Surfaces, polysurfaces and meshes are needed")),
    }
}

/// Brings the terrain below or above a surface to its heights, with slopes from its border.
fn surface(
    context: &Context<'_>,
    grid: &List<'_, f64>,
    shape: &Value,
    degrees: f64,
    most: f64,
    ways: Ways,
) -> Result<(Vec<f64>, f64), Message> {
    let mut terrain = Terrain::of(context, grid)?;
    let (rise, most) = (rise(degrees)?, length(most, "The greatest distance")?);
    let mesh = mesh_of(context, shape, terrain.cell[0].min(terrain.cell[1]))?;
    let edges = mesh.edges();
    let naked = edges.iter().filter(|edge| edge.faces == 1).filter_map(|edge| mesh.edge_line(edge));
    let border: Vec<Curve> =
        naked.filter_map(|line| PolylineCurve::new(vec![line.from, line.to]).ok()).map(Curve::from).collect();
    let paths = Paths::new(context, border.iter(), terrain.cell).ok();
    let tree = MeshTree::new(&mesh);
    let all = [f64::NEG_INFINITY, f64::INFINITY];
    let volume = terrain.change(context, |[x, y], z| {
        let hits = tree.line_hits(Point3::new(x, y, 0.0), Vector3::Z, all).unwrap_or_default();
        if let Some(top) = hits.iter().map(|hit| hit.point.z).reduce(f64::max) {
            return ways.bring(z, top, 0.0);
        }
        let near = paths.as_ref().and_then(|paths| paths.near([x, y], most));
        near.map_or(z, |near| ways.bring(z, near.height, near.distance * rise))
    })?;
    Ok((terrain.list(), volume))
}

macro_rules! surfaces {
    ($($(#[$help:meta])* $function:ident $guid:tt $name:tt $nick:tt $ways:expr;)*) => {$(
        $(#[$help])*
        #[component($guid, name = $name, nick = $nick, at = "Docofossor/Absolute")]
        #[output("df", "df", "The grid, as a list of numbers.", kind = Number)]
        #[output("vol", "vol", "The volume that is added, less what is cut.")]
        fn $function(
            context: &Context<'_>,
            /// The grid, as a list of numbers.
            #[port("df", "df")]
            grid: List<f64>,
            /// The surface, polysurface or mesh; of several heights above each other the highest counts.
            #[port("srf", "srf")]
            shape: Value,
            /// The slope from its border, in degrees.
            #[port("sa", "sa", default = SLOPE)]
            slope: f64,
            /// The greatest distance from its border, in units, seen from above.
            #[port("d", "d", default = 30.0)]
            most: f64,
        ) -> Result<(Vec<f64>, f64), Message> {
            surface(context, &grid, &shape, slope, most, $ways)
        }
    )*};
}

surfaces! {
    /// Brings the terrain to a surface, cut and filled, with slopes from its border. Stands for Docofossor's Cut & Fill In Surface.
    cut_fill_in_surface "6b1c7c1e-0d4e-4e3a-9d5c-3f0a5a6f2a11" "Cut & Fill In Surface" "dfCutFillInSurface" Ways::BOTH;
    /// Cuts the terrain down to a surface, with slopes from its border. Stands for Docofossor's Cut In Surface.
    cut_in_surface "6b1c7c1e-0d4e-4e3a-9d5c-3f0a5a6f2a12" "Cut In Surface" "dfCutInSurface" Ways::CUT;
    /// Fills the terrain up to a surface, with slopes from its border. Stands for Docofossor's Fill In Surface.
    fill_in_surface "6b1c7c1e-0d4e-4e3a-9d5c-3f0a5a6f2a13" "Fill In Surface" "dfFillInSurface" Ways::FILL;
}
