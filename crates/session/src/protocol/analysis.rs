use serde::{Deserialize, Serialize};
use uuid::Uuid;

/// What of the form of curves and surfaces a client wants to see beside the model. It comes as
/// [`Event::Analysed`](super::Event::Analysed) and is kept up to date until the client asks for something else.
#[derive(Debug, Clone, PartialEq, Default, Serialize, Deserialize)]
#[cfg_attr(feature = "typescript", derive(ts_rs::TS))]
#[serde(rename_all = "camelCase")]
pub struct AnalysisView {
    /// The objects that are looked at; none for all that are shown.
    pub objects: Option<Vec<Uuid>>,
    /// Curvature combs.
    pub comb: Option<CombView>,
    /// Osculating circles along each curve: so many, at even steps of its length.
    pub circles: u32,
    /// The control polygons of curves and control nets of surfaces, with degrees and with weights other than 1.
    pub controls: bool,
    /// More isocurves than those at the knots.
    pub isocurves: Option<IsocurvesView>,
    /// Whether surfaces keep their own normals and curvatures while something is dragged: for colours and zebra
    /// stripes.
    pub colours: bool,
}

/// How curvature combs are drawn.
#[derive(Debug, Clone, Copy, PartialEq, Serialize, Deserialize)]
#[cfg_attr(feature = "typescript", derive(ts_rs::TS))]
#[serde(rename_all = "camelCase")]
pub struct CombView {
    /// Teeth in each span between knots, and in each quarter of an arc.
    pub teeth: u32,
    /// How long the longest tooth is about, as a part of the size of what is looked at.
    pub length: f64,
    /// Whether the isocurves of surfaces have combs too.
    pub surfaces: bool,
}

/// Which isocurves are drawn.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Serialize, Deserialize)]
#[cfg_attr(feature = "typescript", derive(ts_rs::TS))]
#[serde(rename_all = "camelCase")]
pub struct IsocurvesView {
    /// So many between two knots of each direction.
    pub between: u32,
    /// Whether those along u are red and those along v green.
    pub directions: bool,
}

/// What combs show in numbers.
#[derive(Debug, Clone, Copy, PartialEq, Serialize, Deserialize)]
#[cfg_attr(feature = "typescript", derive(ts_rs::TS))]
#[serde(rename_all = "camelCase")]
pub struct CombMeasure {
    /// The length of a tooth over the curvature at its foot, in units².
    pub scale: f64,
    /// The greatest curvature, in 1/units.
    pub sharpest: f64,
    /// Where that is.
    pub at: [f64; 3],
}

/// A place of a curve or a surface whose curvature is asked for.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
#[cfg_attr(feature = "typescript", derive(ts_rs::TS))]
#[serde(rename_all = "camelCase")]
pub struct Probe {
    /// The object.
    pub object: Uuid,
    /// The index of its output.
    pub output: u32,
    /// The path of the item's branch.
    pub path: String,
    /// The index of the item in it.
    pub index: u32,
    /// Where on the item.
    pub at: ProbePlace,
}

/// Where on a curve or surface.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
#[cfg_attr(feature = "typescript", derive(ts_rs::TS))]
#[serde(tag = "is", rename_all = "camelCase")]
pub enum ProbePlace {
    /// Nearest to a point.
    Near { point: [f64; 3] },
    /// At a parameter of the item, or of one of its members where it is a group. A parameter beyond the ends is moved
    /// there: a curve may have become another.
    Parameter { member: u32, parameter: Vec<f64> },
}

/// What was found at a place.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
#[cfg_attr(feature = "typescript", derive(ts_rs::TS))]
#[serde(rename_all = "camelCase")]
pub struct Probed {
    /// Which member of the item, where it is a group; else 0.
    pub member: u32,
    /// The parameter: t of a curve, u and v of a surface.
    pub parameter: Vec<f64>,
    /// The point there.
    pub point: [f64; 3],
    /// How the curve or surface bends there.
    pub bend: BendView,
}

/// How a curve or a surface bends at a place.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
#[cfg_attr(feature = "typescript", derive(ts_rs::TS))]
#[serde(tag = "is", rename_all = "camelCase")]
pub enum BendView {
    /// A curve: the unit tangent, the curvature in 1/units, and the osculating circle where it is not straight.
    Curve { tangent: Option<[f64; 3]>, curvature: f64, circle: Option<CircleView> },
    /// A surface: the unit normal; the principal curvatures, the greater first, with their unit directions; the Gaussian
    /// curvature in 1/units² and the mean in 1/units; the osculating circles of both principal sections.
    Surface {
        normal: [f64; 3],
        principal: [f64; 2],
        directions: [[f64; 3]; 2],
        gaussian: f64,
        mean: f64,
        circles: [Option<CircleView>; 2],
    },
}

/// A circle.
#[derive(Debug, Clone, Copy, PartialEq, Serialize, Deserialize)]
#[cfg_attr(feature = "typescript", derive(ts_rs::TS))]
#[serde(rename_all = "camelCase")]
pub struct CircleView {
    /// The centre.
    pub centre: [f64; 3],
    /// The radius, in units.
    pub radius: f64,
    /// The unit vector from the centre to the place where the circle touches.
    pub x: [f64; 3],
    /// The unit vector along the circle there.
    pub y: [f64; 3],
}
