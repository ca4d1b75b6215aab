//! The text of KML.

use std::sync::Arc as Shared;

use katydid_data::Colour;
use katydid_geometry::Point3;
use quick_xml::escape::escape;

use super::kml::Style;

/// A document of KML that is being written.
pub(super) struct Kml {
    mode: Shared<str>,
    style: Option<Style>,
    count: usize,
    text: String,
}

impl Kml {
    pub(super) fn new(mode: Shared<str>) -> Self {
        let text = "<?xml version=\"1.0\" encoding=\"UTF-8\"?>\n\
            <kml xmlns=\"http://www.opengis.net/kml/2.2\">\n<Document>\n"
            .to_owned();
        Self { mode, style: None, count: 0, text }
    }

    /// The bytes so far.
    pub(super) fn len(&self) -> usize {
        self.text.len()
    }

    /// What comes from now on is drawn so.
    pub(super) fn set_style(&mut self, style: Style) {
        self.style = Some(style);
    }

    pub(super) fn point(&mut self, at: Point3) {
        let shape = format!("<Point>{}{}</Point>", self.mode(), coordinates(&[at]));
        self.placemark("Point", &shape);
    }

    /// A polyline; a closed one is a ring.
    pub(super) fn polyline(&mut self, points: &[Point3]) {
        let is_ring = points.len() > 3 && points.first() == points.last();
        let name = if is_ring { "LinearRing" } else { "LineString" };
        let shape = format!("<{name}>{}{}</{name}>", self.mode(), coordinates(points));
        self.placemark(name, &shape);
    }

    /// The faces of a mesh, each by its corners.
    pub(super) fn faces(&mut self, faces: impl Iterator<Item = Vec<Point3>>) {
        let mut shape = "<MultiGeometry>".to_owned();
        for mut corners in faces {
            corners.extend(corners.first().copied());
            let ring = coordinates(&corners);
            shape.push_str(&format!(
                "\n<Polygon>{}<outerBoundaryIs><LinearRing>{ring}</LinearRing></outerBoundaryIs></Polygon>",
                self.mode()
            ));
        }
        shape.push_str("</MultiGeometry>");
        self.placemark("MultiGeometry", &shape);
    }

    pub(super) fn finish(mut self) -> String {
        self.text.push_str("</Document>\n</kml>\n");
        self.text
    }

    fn mode(&self) -> String {
        format!("<altitudeMode>{}</altitudeMode>", self.mode)
    }

    fn placemark(&mut self, kind: &str, shape: &str) {
        let own = self.style.as_ref().and_then(|style| style.name.clone());
        let name = own.map_or_else(|| format!("{kind} {}", self.count), |name| name.to_string());
        let style = self.style.as_ref().map(styled).unwrap_or_default();
        self.count += 1;
        let name = escape(name.as_str());
        self.text.push_str(&format!("<Placemark><name>{name}</name>{style}\n{shape}\n</Placemark>\n"));
    }
}

/// Longitude, latitude and height of each point.
fn coordinates(points: &[Point3]) -> String {
    let one = |p: &Point3| format!("{},{},{}", p.x, p.y, p.z);
    format!("<coordinates>{}</coordinates>", points.iter().map(one).collect::<Vec<_>>().join(" "))
}

fn styled(style: &Style) -> String {
    format!(
        "<Style><LineStyle><color>{}</color><width>{}</width></LineStyle><PolyStyle><color>{}</color></PolyStyle></Style>",
        colour(style.line),
        style.width,
        colour(style.fill)
    )
}

/// KML has the channels as alpha, blue, green, red.
fn colour(colour: Colour) -> String {
    format!("{:02x}{:02x}{:02x}{:02x}", colour.a, colour.b, colour.g, colour.r)
}
