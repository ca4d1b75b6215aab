//! Operations relative to the terrain: so deep or so high beside what is there.

use std::sync::Arc as Shared;

use katydid_component::{Context, List, Message, component};
use katydid_elementary::Elementary as _;
use katydid_geometry::{Curve, Point3};

use super::path::Paths;
use super::{SLOPE, Terrain, length, rise};

/// A wave of half a turn of a cosine round points: as high as `size` there, nowhere steeper than the slope.
fn bumps(
    context: &Context<'_>,
    grid: &List<'_, f64>,
    points: &List<'_, Point3>,
    size: f64,
    degrees: f64,
) -> Result<(Vec<f64>, f64), Message> {
    let mut terrain = Terrain::of(context, grid)?;
    // (1 + cos(πd/r))·s/2 is steepest in the middle: πs/2r.
    let reach = size.abs() * std::f64::consts::PI / (2.0 * rise(degrees)?);
    let points: Vec<Point3> = points.present().filter(|p| p.is_finite()).collect();
    let volume = terrain.change(context, |[x, y], z| {
        points.iter().fold(z, |z, p| {
            let far = (p.x - x).hypotenuse(p.y - y);
            if far < reach {
                z + size * (1.0 + (std::f64::consts::PI * far / reach).cosine()) / 2.0
            } else {
                z
            }
        })
    })?;
    Ok((terrain.list(), volume))
}

/// Cuts a round hollow at points: a wave that is nowhere steeper than the slope. Stands for Docofossor's Cut On Point.
#[component(
    "c9dceb4a-07b7-410d-a843-70bc57986095",
    name = "Cut On Point",
    nick = "dfCutOnPoint",
    at = "Docofossor/Relative"
)]
#[output("df", "df", "The grid, as a list of numbers.", kind = Number)]
#[output("vol", "vol", "The volume that is added: negative for a cut.")]
fn cut_on_point(
    context: &Context<'_>,
    /// The grid, as a list of numbers.
    #[port("df", "df")]
    grid: List<f64>,
    /// The places; their heights do not count.
    #[port("pt", "pt")]
    points: List<Point3>,
    /// The depth in the middle, in units.
    #[port("mxd", "mxd", default = 1.0)]
    depth: f64,
    /// The steepest slope, in degrees.
    #[port("sa", "sa", default = SLOPE)]
    slope: f64,
) -> Result<(Vec<f64>, f64), Message> {
    bumps(context, &grid, &points, -length(depth, "The depth")?, slope)
}

/// Fills a round heap at points: a wave that is nowhere steeper than the slope. Stands for Docofossor's Fill On Point.
#[component(
    "9340a1ae-73c0-43af-b39d-43ae2705f6bb",
    name = "Fill On Point",
    nick = "dfFillOnPoint",
    at = "Docofossor/Relative"
)]
#[output("df", "df", "The grid, as a list of numbers.", kind = Number)]
#[output("vol", "vol", "The volume that is added.")]
fn fill_on_point(
    context: &Context<'_>,
    /// The grid, as a list of numbers.
    #[port("df", "df")]
    grid: List<f64>,
    /// The places; their heights do not count.
    #[port("pt", "pt")]
    points: List<Point3>,
    /// The height in the middle, in units.
    #[port("mxh", "mxh", default = 1.0)]
    height: f64,
    /// The steepest slope, in degrees.
    #[port("sa", "sa", default = SLOPE)]
    slope: f64,
) -> Result<(Vec<f64>, f64), Message> {
    bumps(context, &grid, &points, length(height, "The height")?, slope)
}

/// What a trench or a bank beside a path is: its width where it is deepest, its slopes and how far it may go.
struct Profile {
    size: f64,
    width: f64,
    rises: [f64; 2],
    most: f64,
}

impl Profile {
    fn new(size: f64, width: f64, left: f64, right: Option<f64>, most: f64) -> Result<Self, Message> {
        Ok(Self {
            size: length(size, "The depth or height")?,
            width: length(width, "The width")?,
            rises: [rise(left)?, rise(right.unwrap_or(left))?],
            most: length(most, "The greatest distance")?,
        })
    }

    /// Adds the profile to the terrain along paths, up or down.
    fn along(
        &self,
        context: &Context<'_>,
        grid: &List<'_, f64>,
        curves: &List<'_, Shared<Curve>>,
        sign: f64,
    ) -> Result<(Vec<f64>, f64), Message> {
        let mut terrain = Terrain::of(context, grid)?;
        let paths = Paths::of_list(context, curves, terrain.cell)?;
        let volume = terrain.change(context, |place, z| {
            let Some(near) = paths.near(place, self.most) else { return z };
            let [left, right] = self.rises;
            let out = (near.distance - self.width / 2.0).max(0.0);
            let slope = if near.is_left { left } else { right };
            z + sign * (self.size - out * slope).max(0.0)
        })?;
        Ok((terrain.list(), volume))
    }
}

/// Cuts a trench along paths, so deep below what is there, with slopes at its sides. Stands for Docofossor's Cut On Path.
#[component(
    "3511f6d2-abdf-4749-b8d5-e89ea084c5f1",
    name = "Cut On Path",
    nick = "dfCutOnPath",
    at = "Docofossor/Relative"
)]
#[output("df", "df", "The grid, as a list of numbers.", kind = Number)]
#[output("vol", "vol", "The volume that is added: negative for a cut.")]
fn cut_on_path(
    context: &Context<'_>,
    /// The grid, as a list of numbers.
    #[port("df", "df")]
    grid: List<f64>,
    /// The paths; their heights do not count.
    #[port("crv", "crv")]
    curves: List<Shared<Curve>>,
    /// The depth, in units.
    #[port("mxd", "mxd", default = 1.0)]
    depth: f64,
    /// The width at the bottom, in units.
    #[port("wb", "wb", default = 1.0)]
    width: f64,
    /// The slope at the left, in degrees.
    #[port("sa", "sa", default = SLOPE)]
    slope: f64,
    /// The slope at the right; as at the left when nothing is given.
    #[port("sa2", "sa2", optional)]
    right: Option<f64>,
    /// The greatest distance from the path, in units.
    #[port("d", "d", default = 30.0)]
    most: f64,
) -> Result<(Vec<f64>, f64), Message> {
    Profile::new(depth, width, slope, right, most)?.along(context, &grid, &curves, -1.0)
}

/// Fills a bank along paths, so high above what is there, with slopes at its sides. Stands for Docofossor's Fill On Path.
#[component(
    "030d8c08-b4b7-42ae-a5f8-a8aaa47d2955",
    name = "Fill On Path",
    nick = "dfFillOnPath",
    at = "Docofossor/Relative"
)]
#[output("df", "df", "The grid, as a list of numbers.", kind = Number)]
#[output("vol", "vol", "The volume that is added.")]
fn fill_on_path(
    context: &Context<'_>,
    /// The grid, as a list of numbers.
    #[port("df", "df")]
    grid: List<f64>,
    /// The paths; their heights do not count.
    #[port("crv", "crv")]
    curves: List<Shared<Curve>>,
    /// The height, in units.
    #[port("mxh", "mxh", default = 1.0)]
    height: f64,
    /// The width at the top, in units.
    #[port("wt", "wt", default = 1.0)]
    width: f64,
    /// The slope at the left, in degrees.
    #[port("sa", "sa", default = SLOPE)]
    slope: f64,
    /// The slope at the right; as at the left when nothing is given.
    #[port("sa2", "sa2", optional)]
    right: Option<f64>,
    /// The greatest distance from the path, in units.
    #[port("d", "d", default = 30.0)]
    most: f64,
) -> Result<(Vec<f64>, f64), Message> {
    Profile::new(height, width, slope, right, most)?.along(context, &grid, &curves, 1.0)
}

/// A change inside closed curves that grows with the distance from them, up to a limit.
fn area(
    context: &Context<'_>,
    grid: &List<'_, f64>,
    curves: &List<'_, Shared<Curve>>,
    size: f64,
    degrees: f64,
) -> Result<(Vec<f64>, f64), Message> {
    let mut terrain = Terrain::of(context, grid)?;
    let rise = rise(degrees)?;
    let paths = Paths::of_list(context, curves, terrain.cell)?;
    let volume = terrain.change(context, |place, z| {
        if !paths.surround(place) {
            return z;
        }
        // Farther inside than this it is as deep as it gets.
        let far = paths.near(place, size.abs() / rise).map_or(f64::INFINITY, |near| near.distance);
        z + size.signum() * (far * rise).min(size.abs())
    })?;
    Ok((terrain.list(), volume))
}

/// Cuts a pit inside closed curves, with slopes at its sides. Stands for Docofossor's Cut On Area.
#[component(
    "6b1c7c1e-0d4e-4e3a-9d5c-3f0a5a6f2a0d",
    name = "Cut On Area",
    nick = "dfCutOnArea",
    at = "Docofossor/Relative"
)]
#[output("df", "df", "The grid, as a list of numbers.", kind = Number)]
#[output("vol", "vol", "The volume that is added: negative for a cut.")]
fn cut_on_area(
    context: &Context<'_>,
    /// The grid, as a list of numbers.
    #[port("df", "df")]
    grid: List<f64>,
    /// The closed curves; their heights do not count.
    #[port("crv", "crv")]
    curves: List<Shared<Curve>>,
    /// The greatest depth, in units.
    #[port("mxd", "mxd", default = 1.0)]
    depth: f64,
    /// The slope, in degrees.
    #[port("sa", "sa", default = SLOPE)]
    slope: f64,
) -> Result<(Vec<f64>, f64), Message> {
    area(context, &grid, &curves, -length(depth, "The depth")?, slope)
}

/// Fills a plateau inside closed curves, with slopes at its sides. Stands for Docofossor's Fill On Area.
#[component(
    "6b1c7c1e-0d4e-4e3a-9d5c-3f0a5a6f2a0e",
    name = "Fill On Area",
    nick = "dfFillOnArea",
    at = "Docofossor/Relative"
)]
#[output("df", "df", "The grid, as a list of numbers.", kind = Number)]
#[output("vol", "vol", "The volume that is added.")]
fn fill_on_area(
    context: &Context<'_>,
    /// The grid, as a list of numbers.
    #[port("df", "df")]
    grid: List<f64>,
    /// The closed curves; their heights do not count.
    #[port("crv", "crv")]
    curves: List<Shared<Curve>>,
    /// The greatest height, in units.
    #[port("mxh", "mxh", default = 1.0)]
    height: f64,
    /// The slope, in degrees.
    #[port("sa", "sa", default = SLOPE)]
    slope: f64,
) -> Result<(Vec<f64>, f64), Message> {
    area(context, &grid, &curves, length(height, "The height")?, slope)
}
