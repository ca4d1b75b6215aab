//! Geometry for globes on the screen: KML 2.2, a standard of the Open Geospatial Consortium.

use std::sync::Arc as Shared;

use katydid_component::{Context, Message, component};
use katydid_data::{Colour, Kind, Tree, Value, cast};
use katydid_geometry::Point3;

use super::geo::on_earth;
use super::kml_write::Kml;
use crate::kept::{keep, kept};
use crate::model_objects::first;

/// How something is drawn.
#[derive(Debug, Clone, PartialEq)]
pub(super) struct Style {
    pub(super) fill: Colour,
    pub(super) line: Colour,
    pub(super) width: f64,
    pub(super) name: Option<Shared<str>>,
}

impl Style {
    fn item(self) -> Value {
        keep("KML Style".to_owned(), self)
    }
}

/// How objects are drawn: the colour of faces, the colour and width of lines, and what the object is called. Stands for gHowl's KML
/// Style.
#[component("26114b99-80c2-4e9e-91d3-a17ac8ed800d", name = "KML Style", nick = "S", at = "gHowl/KML")]
#[output("KML Style", "S", "The style.")]
fn style(
    /// The colour of faces.
    #[port("Fill Color", "F", default = Colour::rgb(255, 255, 255))]
    fill: Colour,
    /// The colour of lines.
    #[port("Curve Color", "L", default = Colour::rgb(0, 0, 0))]
    line: Colour,
    /// The width of lines, in pixels.
    #[port("Curve Width", "W", default = 1.0)]
    width: f64,
    /// What the object is called.
    #[port("Name", "N", default = "gHowl")]
    name: Shared<str>,
) -> Value {
    Style { fill, line, width, name: Some(name) }.item()
}

/// How objects are drawn. Stands for an earlier KML Style of gHowl.
#[component("8354046b-989b-4d61-a92d-e109bb53dad3", name = "KML Style", nick = "S", at = "gHowl/KML", old)]
#[output("KML Style", "S", "The style.")]
fn style_before(
    /// The colour of faces.
    #[port("Fill Color", "F", default = Colour::rgb(255, 255, 255))]
    fill: Colour,
    /// The colour of lines.
    #[port("Curve Color", "L", default = Colour::rgb(0, 0, 0))]
    line: Colour,
    /// The width of lines, in pixels.
    #[port("Curve Width", "W", default = 1.0)]
    width: f64,
) -> Value {
    Style { fill, line, width, name: None }.item()
}

/// Writes geometry as KML, which globes on the screen show: points, curves as polylines of 25 parts where they are none, meshes and
/// Breps by their faces. A point of the model whose place is known says where all is. Stands for gHowl's KML Exporter. Files are
/// written by `katydid run --write FOLDER`, into that folder. The unit of the document counts, and a KML Style may come with the
/// geometry, which is our reading.
#[component(
    "7fde1e88-728f-43b2-a217-e312462dfa10",
    name = "KML Exporter",
    nick = "KML Out",
    at = "gHowl/KML"
)]
fn export(
    context: &Context<'_>,
    /// The path of the file, of which the name counts.
    #[port("File Path", "F", kind = Text)]
    path: &Tree,
    /// The geometry.
    #[port("Geometry", "G", kind = Generic)]
    geometry: &Tree,
    /// The point of the model whose place is known.
    #[port("EAP_XYZ", "XYZ", kind = Point)]
    anchor: &Tree,
    /// Its longitude and latitude in degrees, and its height in metres.
    #[port("EAP_GPS", "GPS", kind = Point)]
    place: &Tree,
    /// What heights are above: `absolute` the sea, `relativeToGround` the ground; `clampToGround` lays all on the ground.
    #[port("Altitude Mode", "A", kind = Text, optional)]
    mode: &Tree,
) -> Result<(), Message> {
    let Some(Value::Text(path)) = first(path) else { return Ok(()) };
    let (Some(Value::Point(anchor)), Some(Value::Point(place))) = (first(anchor), first(place)) else {
        return Ok(());
    };
    let mode = match first(mode) {
        Some(Value::Text(mode)) => mode,
        _ => "absolute".into(),
    };
    if !["absolute", "clampToGround", "relativeToGround"].contains(&&*mode) {
        return Err(Message::error(format!(
            "{mode} is no altitude mode: absolute, clampToGround and relativeToGround are"
        )));
    }
    let units = context.rules().units;
    let locate = |point: Point3| on_earth(point, anchor, place, units);
    locate(anchor)?;
    let mut kml = Kml::new(mode);
    let mut left_out = 0_usize;
    for branch in geometry.branches() {
        for item in branch.iter().flatten() {
            context.check()?;
            if let Some(style) = kept::<Style>(&item) {
                kml.set_style(style.clone());
                continue;
            }
            let before = kml.len();
            let added = add(context, &mut kml, &item, &locate)?;
            left_out += usize::from(!added);
            context.bytes(kml.len().saturating_sub(before))?;
        }
    }
    if left_out > 0 {
        context.warn(format!("{left_out} items are of types that KML has no form for"));
    }
    context.write_file(&path, kml.finish().into_bytes())?;
    Ok(())
}

/// So many parts a curve that is no polyline is divided into, as by the plug-in.
const PARTS: usize = 25;

/// Adds an item; tells whether it has a form.
fn add(
    context: &Context<'_>,
    kml: &mut Kml,
    item: &Value,
    locate: &dyn Fn(Point3) -> Result<Point3, Message>,
) -> Result<bool, Message> {
    let located = |points: Vec<Point3>| points.into_iter().map(locate).collect::<Result<Vec<_>, _>>();
    if let Value::Point(point) = item {
        kml.point(locate(*point)?);
        return Ok(true);
    }
    let cast = |kind| cast::value(item, kind, context.rules());
    if let Some(Value::Curve(curve)) = cast(Kind::Curve) {
        let points = match curve.as_polyline() {
            Some(points) => points,
            None => {
                let parameters =
                    curve.divide_by_count(PARTS).map_err(|error| Message::error(error.to_string()))?;
                let mut points: Vec<Point3> = parameters.into_iter().map(|t| curve.point_at(t)).collect();
                if curve.is_closed() {
                    points.extend(points.first().copied());
                }
                points
            }
        };
        kml.polyline(&located(points)?);
        return Ok(true);
    }
    if let Some(Value::Mesh(mesh)) = cast(Kind::Mesh) {
        context.bytes(mesh.faces().len().saturating_mul(200))?;
        let vertices = located(mesh.vertices().to_vec())?;
        let corner = |index: &u32| usize::try_from(*index).ok().and_then(|at| vertices.get(at)).copied();
        let faces =
            mesh.faces().iter().map(|face| face.indices().iter().filter_map(corner).collect::<Vec<_>>());
        kml.faces(faces);
        return Ok(true);
    }
    Ok(false)
}
