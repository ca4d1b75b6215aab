//! Values in the text and in ports.

use katydid_data::QuadSettings;
use katydid_geometry::{Arc, Box3, Circle, Interval, Line, Plane, Point3, Rectangle, Vector3};

use super::ast::{Lit, LitKind, Values};
use super::catalogue::Expect;
use super::problem::Fault;
use super::raw_value::{colour_form, double, missing_data};
use super::text;
use crate::archive::Colour;
use crate::document::{
    Branch, LoftOptions, Material, MeshSettings, Persistent, Stored, StoredGeometry, format_path,
};

/// The bytes by their number.
pub(super) type Data<'a> = dyn Fn(u32) -> Option<&'a [u8]> + 'a;

/// The values of a port; nothing where it shall have none.
pub(super) fn persistent(
    values: &Values,
    expect: Expect,
    data: &Data<'_>,
    faults: &mut Vec<Fault>,
) -> Option<Persistent> {
    let mut read = |lit: &Lit| match stored(lit, expect, data) {
        Ok(value) => value,
        Err(fault) => {
            faults.push(fault);
            Stored::Null
        }
    };
    Some(match values {
        Values::Default | Values::None => return None,
        Values::One(lit) => Persistent::item(read(lit)),
        Values::Tree(branches) => Persistent {
            branches: branches
                .iter()
                .map(|(path, items)| Branch {
                    path: path.clone(),
                    items: items.iter().map(&mut read).collect(),
                })
                .collect(),
        },
    })
}

fn wrong(lit: &Lit, what: &str) -> Fault {
    Fault::new(lit.span.at, lit.span.len, format!("{what} should stand here"))
}

/// One value.
fn stored(lit: &Lit, expect: Expect, data: &Data<'_>) -> Result<Stored, Fault> {
    Ok(match &lit.kind {
        LitKind::Number(x, digits) => {
            let whole = digits.is_none() && x.fract() == 0.0 && x.abs() <= f64::from(i32::MAX);
            if whole && expect != Expect::Number { Stored::Integer(*x as i32) } else { Stored::Number(*x) }
        }
        LitKind::Boolean(b) => Stored::Boolean(*b),
        LitKind::Null => Stored::Null,
        LitKind::Text(text) => Stored::Text(text.clone()),
        LitKind::Range(a, b, _) => Stored::Domain(Interval::new(*a, *b)),
        LitKind::Point(p) if expect == Expect::Vector => Stored::Vector((*p).into()),
        LitKind::Point(p) => Stored::Point((*p).into()),
        LitKind::Path(path) => Stored::Path(path.clone()),
        LitKind::Guid(id) => Stored::Guid(*id),
        LitKind::Data(_) => return Err(wrong(lit, "geometry($…)")),
        LitKind::Made(what, parts) => made(lit, what, parts, data)?,
    })
}

/// The parts of a made value, taken one by one.
struct Parts<'a> {
    whole: &'a Lit,
    parts: &'a [(Option<String>, Lit)],
    at: usize,
}

impl<'a> Parts<'a> {
    fn next(&mut self, what: &str) -> Result<&'a Lit, Fault> {
        let part = self.parts.get(self.at).filter(|(name, _)| name.is_none());
        self.at += 1;
        part.map(|(_, lit)| lit).ok_or_else(|| wrong(self.whole, what))
    }

    fn more(&self) -> bool {
        self.at < self.parts.len()
    }

    fn number(&mut self) -> Result<f64, Fault> {
        let lit = self.next("a number more")?;
        if let LitKind::Number(x, _) = lit.kind { Ok(x) } else { Err(wrong(lit, "a number")) }
    }

    fn integer(&mut self) -> Result<i32, Fault> {
        let lit = self.next("a whole number more")?;
        match lit.kind {
            LitKind::Number(x, _) if x.fract() == 0.0 && x.abs() <= f64::from(i32::MAX) + 1.0 => Ok(x as i32),
            _ => Err(wrong(lit, "a whole number")),
        }
    }

    fn boolean(&mut self) -> Result<bool, Fault> {
        let lit = self.next("true or false")?;
        if let LitKind::Boolean(b) = lit.kind { Ok(b) } else { Err(wrong(lit, "true or false")) }
    }

    fn text(&mut self) -> Result<&'a str, Fault> {
        let lit = self.next("a text")?;
        if let LitKind::Text(text) = &lit.kind { Ok(text) } else { Err(wrong(lit, "a text")) }
    }

    fn xyz(&mut self) -> Result<[f64; 3], Fault> {
        let lit = self.next("three coordinates more")?;
        if let LitKind::Point(p) = lit.kind { Ok(p) } else { Err(wrong(lit, "(x, y, z)")) }
    }

    fn point(&mut self) -> Result<Point3, Fault> {
        Ok(self.xyz()?.into())
    }

    fn vector(&mut self) -> Result<Vector3, Fault> {
        Ok(self.xyz()?.into())
    }

    fn interval(&mut self) -> Result<Interval, Fault> {
        let lit = self.next("a range more")?;
        if let LitKind::Range(a, b, _) = lit.kind {
            Ok(Interval::new(a, b))
        } else {
            Err(wrong(lit, "a range such as 0..1"))
        }
    }

    fn colour(&mut self) -> Result<Colour, Fault> {
        let lit = self.next("a colour more")?;
        colour(lit)
    }

    fn plane(&mut self) -> Result<Plane, Fault> {
        let lit = self.next("a plane more")?;
        match &lit.kind {
            LitKind::Made(what, parts) if what == "plane" => plane(lit, parts),
            _ => Err(wrong(lit, "plane(origin, x, y)")),
        }
    }

    fn end(&self) -> Result<(), Fault> {
        match self.parts.get(self.at) {
            Some((_, extra)) => Err(Fault::new(extra.span.at, extra.span.len, "this is one part too many")),
            None => Ok(()),
        }
    }
}

/// An origin, with the axes x and y where they are not the world's.
fn plane(whole: &Lit, parts: &[(Option<String>, Lit)]) -> Result<Plane, Fault> {
    let mut parts = Parts { whole, parts, at: 0 };
    let origin = parts.point()?;
    let (x, y) = if parts.more() {
        (parts.vector()?, parts.vector()?)
    } else {
        (Vector3::new(1.0, 0.0, 0.0), Vector3::new(0.0, 1.0, 0.0))
    };
    parts.end()?;
    Ok(Plane { origin, x_axis: x, y_axis: y, z_axis: x.cross(y) })
}

/// `rgb(r, g, b)` or `rgb(r, g, b, a)`.
pub(super) fn colour(lit: &Lit) -> Result<Colour, Fault> {
    let LitKind::Made(what, parts) = &lit.kind else { return Err(wrong(lit, "rgb(red, green, blue)")) };
    if what != "rgb" {
        return Err(wrong(lit, "rgb(red, green, blue)"));
    }
    let mut parts = Parts { whole: lit, parts, at: 0 };
    let mut byte = || {
        let n = parts.integer()?;
        u8::try_from(n).map_err(|_| wrong(lit, "a colour of numbers from 0 to 255"))
    };
    let (r, g, b) = (byte()?, byte()?, byte()?);
    let a = if parts.more() {
        let n = parts.integer()?;
        u8::try_from(n).map_err(|_| wrong(lit, "an opacity from 0 to 255"))?
    } else {
        255
    };
    parts.end()?;
    Ok(Colour { a, r, g, b })
}

fn made(lit: &Lit, what: &str, list: &[(Option<String>, Lit)], data: &Data<'_>) -> Result<Stored, Fault> {
    if what == "geometry" {
        return geometry(lit, list, data);
    }
    let mut p = Parts { whole: lit, parts: list, at: 0 };
    let coordinates =
        |p: &mut Parts<'_>| -> Result<[f64; 3], Fault> { Ok([p.number()?, p.number()?, p.number()?]) };
    let value = match what {
        "point" => Stored::Point(coordinates(&mut p)?.into()),
        "vector" => Stored::Vector(coordinates(&mut p)?.into()),
        "plane" => return Ok(Stored::Plane(Box::new(plane(lit, list)?))),
        "rgb" => return Ok(Stored::Colour(colour(lit)?)),
        "int" => Stored::Integer(p.integer()?),
        "content" => Stored::Content(p.text()?.to_owned()),
        "guid" => {
            let id = p.next("@ and a GUID")?;
            let LitKind::Guid(id) = id.kind else { return Err(wrong(id, "@ and a GUID")) };
            Stored::Guid(id)
        }
        "time" => {
            let ticks = p.text()?.parse();
            Stored::Time(ticks.map_err(|_| wrong(lit, "the steps of 100 ns since the year 1, in quotes,"))?)
        }
        "line" => Stored::Line(Box::new(Line::new(p.point()?, p.point()?))),
        "circle" => Stored::Circle(Box::new(Circle { plane: p.plane()?, radius: p.number()? })),
        "arc" => {
            let circle = Circle { plane: p.plane()?, radius: p.number()? };
            Stored::Arc(Box::new(Arc { circle, angle: p.interval()? }))
        }
        "rectangle" => {
            Stored::Rectangle(Box::new(Rectangle { plane: p.plane()?, x: p.interval()?, y: p.interval()? }))
        }
        "box" => Stored::Box(Box::new(Box3 {
            plane: p.plane()?,
            x: p.interval()?,
            y: p.interval()?,
            z: p.interval()?,
        })),
        "domain2" => Stored::Domain2([p.interval()?, p.interval()?]),
        "complex" => Stored::Complex([p.number()?, p.number()?]),
        "face" => {
            let (a, b, c) = (p.integer()?, p.integer()?, p.integer()?);
            Stored::MeshFace([a, b, c, if p.more() { p.integer()? } else { -1 }])
        }
        "material" => Stored::Material(Box::new(Material {
            diffuse: p.colour()?,
            specular: p.colour()?,
            emission: p.colour()?,
            transparency: p.number()?,
            shine: p.number()?,
        })),
        "loft" => Stored::LoftOptions(Box::new(LoftOptions {
            closed: p.boolean()?,
            adjust: p.boolean()?,
            kind: p.integer()?,
            simplify: p.integer()?,
            ends: p.integer()?,
            rebuild: p.integer()?,
            refit: p.number()?,
        })),
        "mesher" => Stored::MeshSettings(Box::new(MeshSettings {
            max_edge: p.number()?,
            min_edge: p.number()?,
            tolerance: p.number()?,
            min_tolerance: p.number()?,
            relative_tolerance: p.number()?,
            refine_angle: p.number()?,
            grid_min: p.integer()?,
            grid_max: p.integer()?,
            refine: p.boolean()?,
            jagged_seams: p.boolean()?,
            simple_planes: p.boolean()?,
        })),
        "quads" => Stored::QuadSettings(Box::new(QuadSettings {
            count: p.integer()?,
            adaptive_size: p.number()?,
            adaptive_count: p.boolean()?,
            hard_edges: p.boolean()?,
            seams: p.integer()?,
            symmetry: p.integer()?,
            guides: p.integer()?,
        })),
        _ => return Err(wrong(lit, "a value")),
    };
    p.end()?;
    Ok(value)
}

/// `geometry($1, ref = @…, edge = 3, kind = "point_object", version = 5, type = "…")`.
fn geometry(whole: &Lit, parts: &[(Option<String>, Lit)], data: &Data<'_>) -> Result<Stored, Fault> {
    let mut geometry = StoredGeometry::default();
    for (name, lit) in parts {
        let integer = || match lit.kind {
            LitKind::Number(x, None) if x.abs() <= f64::from(i32::MAX) => Ok(x as i32),
            _ => Err(wrong(lit, "a whole number")),
        };
        match (name.as_deref(), &lit.kind) {
            (None, LitKind::Data(n)) => {
                let bytes = data(*n).ok_or_else(|| missing_data(*n, lit.span.at, lit.span.len))?;
                geometry.on_data = Some(bytes.to_vec());
            }
            (Some("ref"), LitKind::Guid(id)) => geometry.ref_id = *id,
            (Some("edge"), _) => geometry.edge = Some(integer()?),
            (Some("version"), _) => geometry.on_version = Some(integer()?),
            (Some("kind"), LitKind::Text(text)) => geometry.ref_type = Some(text.clone()),
            (Some("type"), LitKind::Text(text)) => geometry.type_name = Some(text.clone()),
            _ => return Err(wrong(lit, "$ and a number, ref, edge, kind, version or type")),
        }
    }
    if parts.is_empty() {
        return Err(wrong(whole, "geometry($1) or geometry(ref = @…)"));
    }
    Ok(Stored::Geometry(Box::new(geometry)))
}

/// Writes the values of a port. Bytes go into the data that the closure keeps.
pub(super) fn print(values: &Persistent, expect: Expect, keep: &mut dyn FnMut(&[u8]) -> u32) -> String {
    let mut list = |items: &[Stored]| {
        items.iter().map(|item| print_one(item, expect, keep)).collect::<Vec<_>>().join(", ")
    };
    match values.branches.as_slice() {
        [] => "[]".to_owned(),
        [branch] if branch.path == [0] && branch.items.len() == 1 => list(&branch.items),
        [branch] if branch.path == [0] && !branch.items.is_empty() => format!("[{}]", list(&branch.items)),
        branches => {
            let branches: Vec<String> = branches
                .iter()
                .map(|branch| format!("{}: {}", format_path(&branch.path), list(&branch.items)))
                .collect();
            format!("[{}]", branches.join("; "))
        }
    }
}

/// A number, without a point where it needs none.
pub(super) fn plain(x: f64) -> String {
    let text = double(x);
    if x == 0.0 && x.is_sign_negative() {
        return text;
    }
    text.strip_suffix(".0").map(str::to_owned).unwrap_or(text)
}

fn xyz(v: impl Into<[f64; 3]>) -> String {
    let [x, y, z] = v.into();
    format!("({}, {}, {})", plain(x), plain(y), plain(z))
}

fn range(i: Interval) -> String {
    format!("{}..{}", plain(i.start), plain(i.end))
}

fn plane_form(p: &Plane) -> String {
    let (x, y): ([f64; 3], [f64; 3]) = (p.x_axis.into(), p.y_axis.into());
    let same = |a: [f64; 3], b: [f64; 3]| a.map(f64::to_bits) == b.map(f64::to_bits);
    if same(x, [1.0, 0.0, 0.0]) && same(y, [0.0, 1.0, 0.0]) {
        return format!("plane({})", xyz(p.origin));
    }
    format!("plane({}, {}, {})", xyz(p.origin), xyz(x), xyz(y))
}

fn print_one(value: &Stored, expect: Expect, keep: &mut dyn FnMut(&[u8]) -> u32) -> String {
    match value {
        // What is not known here is put back by the details.
        Stored::Null | Stored::Unknown(_) => "null".to_owned(),
        Stored::Number(x) if expect == Expect::Number => plain(*x),
        Stored::Number(x) => double(*x),
        Stored::Integer(n) if expect == Expect::Number || *n == i32::MIN => format!("int({n})"),
        Stored::Integer(n) => n.to_string(),
        Stored::Boolean(b) => b.to_string(),
        Stored::Text(text) => text::quote(text, '"'),
        Stored::Colour(c) => colour_form(*c),
        Stored::Time(ticks) => format!("time(\"{ticks}\")"),
        Stored::Guid(id) => format!("guid(@{id})"),
        Stored::Content(path) => format!("content({})", text::quote(path, '"')),
        Stored::Point(p) if expect == Expect::Vector => format!("point{}", xyz(*p)),
        Stored::Point(p) => xyz(*p),
        Stored::Vector(v) if expect == Expect::Vector => xyz(*v),
        Stored::Vector(v) => format!("vector{}", xyz(*v)),
        Stored::Plane(p) => plane_form(p),
        Stored::Line(l) => format!("line({}, {})", xyz(l.from), xyz(l.to)),
        Stored::Circle(c) => format!("circle({}, {})", plane_form(&c.plane), plain(c.radius)),
        Stored::Arc(a) => {
            format!("arc({}, {}, {})", plane_form(&a.circle.plane), plain(a.circle.radius), range(a.angle))
        }
        Stored::Rectangle(r) => {
            format!("rectangle({}, {}, {})", plane_form(&r.plane), range(r.x), range(r.y))
        }
        Stored::Box(b) => {
            format!("box({}, {}, {}, {})", plane_form(&b.plane), range(b.x), range(b.y), range(b.z))
        }
        Stored::Domain(i) => range(*i),
        Stored::Domain2([u, v]) => format!("domain2({}, {})", range(*u), range(*v)),
        Stored::Complex([re, im]) => format!("complex({}, {})", plain(*re), plain(*im)),
        Stored::MeshFace([a, b, c, -1]) => format!("face({a}, {b}, {c})"),
        Stored::MeshFace([a, b, c, d]) => format!("face({a}, {b}, {c}, {d})"),
        Stored::Path(path) => format_path(path),
        Stored::Material(m) => format!(
            "material({}, {}, {}, {}, {})",
            colour_form(m.diffuse),
            colour_form(m.specular),
            colour_form(m.emission),
            plain(m.transparency),
            plain(m.shine)
        ),
        Stored::LoftOptions(o) => format!(
            "loft({}, {}, {}, {}, {}, {}, {})",
            o.closed,
            o.adjust,
            o.kind,
            o.simplify,
            o.ends,
            o.rebuild,
            plain(o.refit)
        ),
        Stored::MeshSettings(m) => {
            let numbers =
                [m.max_edge, m.min_edge, m.tolerance, m.min_tolerance, m.relative_tolerance, m.refine_angle];
            format!(
                "mesher({}, {}, {}, {}, {}, {})",
                numbers.map(plain).join(", "),
                m.grid_min,
                m.grid_max,
                m.refine,
                m.jagged_seams,
                m.simple_planes
            )
        }
        Stored::QuadSettings(q) => format!(
            "quads({}, {}, {}, {}, {}, {}, {})",
            q.count,
            plain(q.adaptive_size),
            q.adaptive_count,
            q.hard_edges,
            q.seams,
            q.symmetry,
            q.guides
        ),
        Stored::Geometry(geometry) => geometry_form(geometry, keep),
    }
}

fn geometry_form(geometry: &StoredGeometry, keep: &mut dyn FnMut(&[u8]) -> u32) -> String {
    let mut parts = Vec::new();
    if let Some(bytes) = &geometry.on_data {
        parts.push(format!("${}", keep(bytes)));
    }
    if !geometry.ref_id.is_nil() || geometry.on_data.is_none() {
        parts.push(format!("ref = @{}", geometry.ref_id));
    }
    parts.extend(geometry.edge.map(|edge| format!("edge = {edge}")));
    parts.extend(geometry.ref_type.as_ref().map(|kind| format!("kind = {}", text::quote(kind, '"'))));
    parts.extend(geometry.on_version.map(|version| format!("version = {version}")));
    parts.extend(geometry.type_name.as_ref().map(|name| format!("type = {}", text::quote(name, '"'))));
    format!("geometry({})", parts.join(", "))
}
