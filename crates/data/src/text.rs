//! How a panel of Grasshopper 1.0 shows each type of data.
//!
//! Numbers have up to six decimals with trailing zeros cut; lengths carry the document's unit.

use katydid_3dm::{BrepSummary, RawObject};
use katydid_geometry::{Brep, Curve, MeshFace, Point3, Tolerance, Units};

use crate::{Content, Domain2, Location, Path, Value};

/// What the text of some values depends on.
#[derive(Debug, Clone, Copy, PartialEq, Default)]
pub struct Style {
    /// The unit shown behind lengths.
    pub units: Units,
    /// How near a curve must be to a line or arc to be called one.
    pub tolerance: Tolerance,
}

/// The text of one item; `null` for none.
pub fn item(value: Option<&Value>, style: &Style) -> String {
    value.map_or_else(|| "null".to_owned(), |value| self::value(value, style))
}

/// The text of one item with all digits of numbers, points and vectors, so that reading it gives the same value again;
/// as in a panel for all else.
pub fn exact(value: Option<&Value>, style: &Style) -> String {
    match value {
        Some(Value::Number(x)) if x.is_finite() => digits(*x),
        Some(Value::Point(p)) if p.is_finite() => all_digits([p.x, p.y, p.z]),
        Some(Value::Vector(v)) if v.is_finite() => all_digits([v.x, v.y, v.z]),
        other => item(other, style),
    }
}

/// The shortest text that is this number again: `2.5`, `-3`, `0.1`, `1e-7`.
fn digits(x: f64) -> String {
    let text = format!("{x:?}");
    text.strip_suffix(".0").map(str::to_owned).unwrap_or(text)
}

fn all_digits(numbers: [f64; 3]) -> String {
    format!("{{{}}}", numbers.map(digits).join(", "))
}

/// The text of a value.
pub fn value(value: &Value, style: &Style) -> String {
    match value {
        Value::Boolean(true) => "True".to_owned(),
        Value::Boolean(false) => "False".to_owned(),
        Value::Integer(x) => x.to_string(),
        Value::Number(x) => number(*x),
        Value::Complex(z) => complex(z.re, z.im),
        Value::Text(text) => text.to_string(),
        Value::Colour(c) if c.a == 255 => format!("{},{},{}", c.r, c.g, c.b),
        Value::Colour(c) => format!("{},{},{} ({})", c.r, c.g, c.b, c.a),
        Value::Time(time) => time.to_string(),
        Value::Guid(id) => id.to_string(),
        Value::Domain(d) => domain(d.start, d.end),
        Value::Domain2(d) => domain2(d),
        Value::Path(path) => Path::to_string(path),
        Value::Point(p) => coordinates(p.x, p.y, p.z),
        Value::Vector(v) => coordinates(v.x, v.y, v.z),
        Value::Plane(p) => {
            format!("O({}) Z({})", two_decimals(p.origin), two_decimals(p.z_axis.to_point()))
        }
        Value::Line(line) => format!("Line(L:{})", length(line.length(), style.units)),
        Value::Circle(circle) => format!("Circle(R:{})", length(circle.radius, style.units)),
        Value::Arc(arc) => format!(
            "Arc(R:{} A:{}\u{b0})",
            length(arc.circle.radius, style.units),
            number(arc.angle.length().to_degrees())
        ),
        Value::Rectangle(r) => {
            format!("Rectangle (w={}, h={})", number(r.x.length().abs()), number(r.y.length().abs()))
        }
        Value::Box(b) => format!(
            "Box (x={}, y={}, z={})",
            number(b.x.length().abs()),
            number(b.y.length().abs()),
            number(b.z.length().abs())
        ),
        Value::TwistedBox(_) => "Twisted Box".to_owned(),
        Value::Curve(c) => curve(c, style).to_owned(),
        Value::Surface(_) => "Untrimmed Surface".to_owned(),
        Value::Brep(b) => brep(b).to_owned(),
        Value::Mesh(mesh) => format!("Mesh (V:{}  F:{})", mesh.vertices().len(), mesh.faces().len()),
        Value::MeshFace(MeshFace::Triangle([a, b, c])) => format!("T{{{a};{b};{c}}}"),
        Value::MeshFace(MeshFace::Quad([a, b, c, d])) => format!("Q{{{a};{b};{c};{d}}}"),
        Value::Transform(_) => "Transform".to_owned(),
        Value::Compound(c) => match c.parts.len() {
            1 => "Compound transform of 1 part".to_owned(),
            n => format!("Compound transform of {n} parts"),
        },
        Value::Field(field) => match field.forces().len() {
            1 => "Field of 1 force".to_owned(),
            n => format!("Field of {n} forces"),
        },
        Value::Location(place) => location(place),
        Value::Symbol(symbol) => format!("Symbol ({})", symbol.style),
        Value::Matrix(m) => format!("Matrix ({} rows, {} columns)", m.rows(), m.columns()),
        Value::LoftOptions(_) => "Loft Options".to_owned(),
        Value::MeshSettings(_) => "Mesh Settings".to_owned(),
        Value::QuadSettings(_) => "Quad Remesh Settings".to_owned(),
        Value::Projection(p) => p.name().to_owned(),
        Value::Material(m) => {
            format!("Material ({},{},{})", m.diffuse.r, m.diffuse.g, m.diffuse.b)
        }
        Value::Group(group) => match group.members.len() {
            1 => "Group with 1 object".to_owned(),
            n => format!("Group with {n} objects"),
        },
        Value::Kept(object) => kept(object),
        Value::Content(content) => self::content(content, style),
    }
}

/// A number with up to six decimals, trailing zeros and the point cut: `2.5`, `3`, `0.333333`, `-0`.
/// From a million on, and below a millionth, in scientific form: `1.234568e+6`.
pub fn number(x: f64) -> String {
    let size = x.abs();
    if x == 0.0 || (1e-6..1e6).contains(&size) {
        return plain_number(x);
    }
    if !x.is_finite() {
        return plain_number(x);
    }
    // Rust writes 1.234568e6 and 1e-7; the sign of the exponent is wanted too.
    let text = format!("{x:.6e}");
    match text.split_once('e') {
        Some((mantissa, exponent)) if !exponent.starts_with('-') => format!("{mantissa}e+{exponent}"),
        _ => text,
    }
}

/// A number with up to six decimals however large or small, as coordinates are shown.
pub fn plain_number(x: f64) -> String {
    if x.is_nan() {
        return "NaN".to_owned();
    }
    if x.is_infinite() {
        return if x > 0.0 { "∞" } else { "-∞" }.to_owned();
    }
    if x == 0.0 {
        // Only a negative number that rounds to zero keeps its sign in Grasshopper.
        return if x.is_sign_negative() { "-0" } else { "0" }.to_owned();
    }
    let mut text = format!("{x:.6}");
    let kept = text.trim_end_matches('0').trim_end_matches('.').len();
    text.truncate(kept);
    text
}

/// A length with two to six decimals and its unit: `16.00 mm`.
pub fn length(x: f64, units: Units) -> String {
    let text = format!("{x:.6}");
    let cut = text.trim_end_matches('0').len().max(text.find('.').map_or(0, |dot| dot + 3));
    let digits = text.get(..cut).unwrap_or(&text);
    match units.abbreviation() {
        "" => digits.to_owned(),
        unit => format!("{digits} {unit}"),
    }
}

/// `{x, y, z}`.
pub fn coordinates(x: f64, y: f64, z: f64) -> String {
    format!("{{{}, {}, {}}}", plain_number(x), plain_number(y), plain_number(z))
}

/// `0 To 10`.
pub fn domain(start: f64, end: f64) -> String {
    format!("{} To {}", plain_number(start), plain_number(end))
}

fn domain2(d: &Domain2) -> String {
    format!("u:{{{}}} v:{{{}}}", domain(d.u.start, d.u.end), domain(d.v.start, d.v.end))
}

fn complex(re: f64, im: f64) -> String {
    let sign = if im < 0.0 { '-' } else { '+' };
    format!("{} {sign} {}i", number(re), number(im.abs()))
}

/// `52.52° N, 13.41° E`.
fn location(place: &Location) -> String {
    let part = |degrees: f64, [positive, negative]: [char; 2]| {
        let side = if degrees < 0.0 { negative } else { positive };
        format!("{}\u{b0} {side}", plain_number(degrees.abs()))
    };
    format!("{}, {}", part(place.latitude, ['N', 'S']), part(place.longitude, ['E', 'W']))
}

fn two_decimals(p: Point3) -> String {
    format!("{:.2},{:.2},{:.2}", p.x, p.y, p.z)
}

/// A brep tells whether it is closed; one of a single face, whether that is trimmed.
fn brep(brep: &Brep) -> &'static str {
    match brep.faces() {
        _ if brep.is_solid() => "Closed Brep",
        [_] if brep.as_surface().is_some() => "Untrimmed Surface",
        [_] => "Trimmed Surface",
        _ => "Open Brep",
    }
}

/// Geometry that is kept whole goes by its class; a brep tells whether it is closed.
fn kept(object: &RawObject) -> String {
    match (object.class_name().as_str(), BrepSummary::read(object)) {
        ("Brep", Ok(brep)) if brep.is_closed() => "Closed Brep".to_owned(),
        ("Brep", Ok(_)) => "Open Brep".to_owned(),
        (class, _) => class.to_owned(),
    }
}

/// Content goes by its path, an object without a name by its geometry. What Grasshopper shows is not known.
fn content(content: &Content, style: &Style) -> String {
    match (content, content.path()) {
        (_, Some(path)) => path.to_owned(),
        (Content::Object(object), None) => match &object.geometry {
            Some(geometry) => value(geometry, style),
            None => content.type_name().to_owned(),
        },
        (Content::Instance(instance), None) => match instance.definition.name.as_ref() {
            "" => content.type_name().to_owned(),
            name => format!("{} ({name})", content.type_name()),
        },
        (Content::Filter(filter), None) => filter.words(style),
        (Content::Token(token), None) if let Some(text) = token.0.text() => text.to_owned(),
        (Content::Atom(atom), None) if !atom.element.is_empty() => format!("Atom ({})", atom.element),
        _ => content.type_name().to_owned(),
    }
}

/// The shape a curve is recognised as, simplest first.
fn curve(curve: &Curve, style: &Style) -> &'static str {
    let tolerance = style.tolerance.absolute;
    if curve.is_linear(tolerance) {
        "Line-like Curve"
    } else if matches!(curve, Curve::Polyline(_)) {
        "Polyline Curve"
    } else if curve.as_circle(tolerance).is_some() {
        "Circle-like Curve"
    } else if curve.as_arc(tolerance).is_some() {
        "Arc-like Curve"
    } else if curve.as_polyline().is_some() {
        "Polyline Curve"
    } else if curve.plane(tolerance).is_some() {
        "Planar Curve"
    } else {
        "Curve"
    }
}

#[cfg(test)]
mod tests {
    use katydid_geometry::{Interval, Line, Vector3};

    use super::*;

    #[test]
    fn numbers_have_up_to_six_decimals() {
        for (x, text) in [
            (2.5, "2.5"),
            (3.0, "3"),
            (1.0 / 3.0, "0.333333"),
            (16.666_666_666_7, "16.666667"),
            (12.077, "12.077"),
            (0.0, "0"),
            (-2.0, "-2"),
            (100_000.0, "100000"),
            (1_234_567.89, "1.234568e+6"),
            (1e-7, "1.000000e-7"),
        ] {
            assert_eq!(number(x), text);
        }
    }

    #[test]
    fn coordinates_keep_the_sign_of_a_rounded_zero() {
        let p = Value::Point(Point3::new(24.0, 6.0, -4.440_892_098_500_626e-16));
        assert_eq!(value(&p, &Style::default()), "{24, 6, -0}");
        let v = Value::Vector(Vector3::new(1.0, 0.25, 0.0));
        assert_eq!(value(&v, &Style::default()), "{1, 0.25, 0}");
    }

    #[test]
    fn exact_texts_are_read_back_as_they_were() {
        use crate::Kind;
        use crate::cast::{self, Rules};
        let sizes = [0.0, -3.0, 0.1, 1.0 / 3.0, 1e-7, -2.5e-300, 1e22, 6.02e23, f64::MAX, f64::MIN_POSITIVE];
        for (k, x) in sizes.into_iter().enumerate() {
            let [y, z] = [sizes[(k + 1) % sizes.len()], sizes[(k + 3) % sizes.len()]];
            for value in
                [Value::Number(x), Value::Point(Point3::new(x, y, z)), Value::Vector(Vector3::new(x, y, z))]
            {
                let text = exact(Some(&value), &Style::default());
                let kind = match value {
                    Value::Number(_) => Kind::Number,
                    Value::Point(_) => Kind::Point,
                    _ => Kind::Vector,
                };
                assert_eq!(
                    cast::value(&Value::text(text.as_str()), kind, &Rules::default()),
                    Some(value),
                    "{text}"
                );
            }
        }
        assert_eq!(exact(Some(&Value::Integer(7)), &Style::default()), "7");
        assert_eq!(exact(None, &Style::default()), "null");
    }

    #[test]
    fn lengths_have_two_to_six_decimals_and_the_unit() {
        let line = |x: f64| {
            let line = Line::new(Point3::ORIGIN, Point3::new(x, 0.0, 0.0));
            value(&Value::Line(line.into()), &Style::default())
        };
        assert_eq!(line(16.0), "Line(L:16.00 mm)");
        assert_eq!(line(16.031_22), "Line(L:16.03122 mm)");
        assert_eq!(line(2f64.sqrt()), "Line(L:1.414214 mm)");
        assert_eq!(length(2.0, Units::None), "2.00");
    }

    #[test]
    fn domains_and_faces() {
        let style = Style::default();
        assert_eq!(value(&Value::Domain(Interval::new(0.3, 1.192)), &style), "0.3 To 1.192");
        let d2 = Domain2 { u: Interval::new(0.0, 50.0), v: Interval::new(0.0, 12.5) };
        assert_eq!(value(&Value::Domain2(d2.into()), &style), "u:{0 To 50} v:{0 To 12.5}");
        assert_eq!(value(&Value::MeshFace(MeshFace::Quad([0, 1, 2, 3])), &style), "Q{0;1;2;3}");
        assert_eq!(value(&Value::MeshFace(MeshFace::Triangle([1, 4, 2])), &style), "T{1;4;2}");
        assert_eq!(item(None, &style), "null");
    }
}
