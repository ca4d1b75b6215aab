//! Writes one archive that holds every kind of geometry with known numbers: `write_sample OUT.3dm [VERSION]`.
//!
//! The test `tests/rhino3dm_peer.py` reads it with rhino3dm and compares.

use std::f64::consts::{FRAC_PI_2, FRAC_PI_6};

use katydid_3dm::{Attributes, Layer, Model, ModelObject, Object, PointCloud};
use katydid_geometry::{
    Arc, ArcCurve, Circle, Curve, Interval, Line, LineCurve, Mesh, MeshFace, NurbsCurve, NurbsSurface, Plane,
    PlaneSurface, Point3, PolyCurve, PolylineCurve, RevolutionSurface, Sphere, SumSurface, Surface,
    Tolerance, Units, Vector3,
};

fn main() -> Result<(), Box<dyn std::error::Error>> {
    let mut arguments = std::env::args().skip(1);
    let path = arguments.next().ok_or("usage: write_sample OUT.3dm [VERSION]")?;
    let version = arguments.next().map_or(Ok(70), |version| version.parse())?;
    sample()?.write_to(version, &mut std::fs::File::create(path)?)?;
    Ok(())
}

fn sample() -> Result<Model, katydid_geometry::Error> {
    let curves = Layer {
        name: "curves".into(),
        colour: [200, 30, 10, 255],
        id: uuid::Uuid::from_u128(0xC0FF_EE00_0001),
        ..Layer::default()
    };
    let conics = Layer {
        name: "conics ⌀".into(),
        colour: [0, 128, 255, 255],
        id: uuid::Uuid::from_u128(0xC0FF_EE00_0002),
        parent: Some(curves.id),
        ..Layer::default()
    };
    let rest = Layer { name: "rest".into(), id: uuid::Uuid::from_u128(0xC0FF_EE00_0003), ..Layer::default() };
    let mut model = Model {
        units: Units::Centimeters,
        tolerance: Tolerance { absolute: 0.0025, angle: 0.02 },
        notes: "Written for a reader.\nZweite Zeile.".into(),
        layers: vec![curves, conics, rest],
        ..Model::default()
    };
    let mut add = |name: &str, layer: usize, geometry: Object| {
        let id = uuid::Uuid::from_u128(0xABCD_0000 + model.objects.len() as u128 + 1);
        let attributes = Attributes { id, name: name.into(), layer: Some(layer), ..Attributes::default() };
        model.objects.push(ModelObject { attributes, ..geometry.into() });
    };
    add("point", 2, Object::Point(Point3::new(0.1, -2.5, 1e6)));
    add("cloud", 2, Object::PointCloud(cloud()));
    for (name, layer, curve) in sample_curves()? {
        add(name, layer, Object::Curve(curve));
    }
    for (name, surface) in sample_surfaces()? {
        add(name, 2, Object::Surface(surface));
    }
    add("mesh", 2, mesh()?.into());
    add("plain mesh", 2, plain_mesh()?.into());
    for (i, object) in model.objects.iter_mut().enumerate() {
        if object.attributes.name == "line" {
            object.attributes.colour = Some([12, 34, 56, 255]);
            object.attributes.url = "https://example.org/".into();
            object.attributes.user_strings =
                vec![("material".into(), "larch".into()), ("Länge".into(), "√41".into())];
        }
        if object.attributes.name == "cloud" {
            object.attributes.visible = false;
        }
        if i == 3 {
            object.attributes.mode = katydid_3dm::ObjectMode::Locked;
        }
    }
    Ok(model)
}

fn cloud() -> PointCloud {
    PointCloud {
        points: (0..5).map(|i| Point3::new(f64::from(i), 0.5, -1.0 / 3.0)).collect(),
        normals: vec![Vector3::Z; 5],
        colours: (0..5).map(|i| [10 * i, 20, 30, 255]).collect(),
        ..PointCloud::default()
    }
}

/// Name, layer, curve.
fn sample_curves() -> Result<Vec<(&'static str, usize, Curve)>, katydid_geometry::Error> {
    let plane = Plane::from_axes(
        Point3::new(1.0, 2.0, 3.0),
        Vector3::new(1.0, 1.0, 0.0),
        Vector3::new(-1.0, 1.0, 0.5),
    )?;
    let circle = Circle { plane, radius: 2.75 };
    let line = LineCurve {
        line: Line::new(Point3::new(1.0, 1.0, 0.0), Point3::new(5.0, 6.0, 0.0)),
        domain: Interval::new(-1.0, 3.5),
    };
    let arc = ArcCurve {
        arc: Arc { circle, angle: Interval::new(FRAC_PI_6, FRAC_PI_6 + FRAC_PI_2) },
        domain: Interval::new(0.0, 4.0),
    };
    let zigzag = (0..7).map(|i| Point3::new(f64::from(i), f64::from(i % 2), 0.1 * f64::from(i))).collect();
    let polyline = PolylineCurve::with_parameters(zigzag, vec![0.0, 1.0, 2.5, 3.0, 4.0, 5.25, 6.0])?;
    let points = (0..6).map(|i| Point3::new(f64::from(i), f64::from(i * i) / 3.0, 0.7)).collect();
    let nurbs = NurbsCurve::new(3, points, vec![0.0, 0.0, 0.0, 1.0, 1.5, 4.0, 4.0, 4.0])?;
    let quarter = [Point3::new(1.0, 0.0, 0.0), Point3::new(1.0, 1.0, 0.0), Point3::new(0.0, 1.0, 0.0)];
    let rational =
        NurbsCurve::with_weights(2, &quarter, &[1.0, 0.5_f64.sqrt(), 1.0], vec![0.0, 0.0, 1.0, 1.0])?;
    let joined = PolyCurve::with_parameters(
        vec![
            Line::new(Point3::new(3.0, 0.0, 0.0), Point3::new(1.0, 0.0, 0.0)).into(),
            rational.clone().into(),
            PolylineCurve::new(vec![
                Point3::new(0.0, 1.0, 0.0),
                Point3::new(0.0, 2.0, 0.0),
                Point3::new(-1.0, 2.0, 1.0),
            ])?
            .into(),
        ],
        vec![0.0, 2.0, 3.0, 7.0],
    )?;
    Ok(vec![
        ("line", 0, line.into()),
        ("arc", 1, arc.into()),
        ("circle", 1, circle.into()),
        ("polyline", 0, polyline.into()),
        ("nurbs", 0, nurbs.into()),
        ("rational", 1, rational.into()),
        ("polycurve", 0, joined.into()),
    ])
}

/// One surface of every kind.
fn sample_surfaces() -> Result<Vec<(&'static str, Surface)>, katydid_geometry::Error> {
    let range = Interval::new;
    let plane = Plane::from_axes(
        Point3::new(1.0, 2.0, 3.0),
        Vector3::new(1.0, 1.0, 0.0),
        Vector3::new(-1.0, 1.0, 0.5),
    )?;
    let flat = PlaneSurface::with_domains(
        plane,
        [range(-1.0, 4.0), range(0.0, 2.0)],
        [range(0.0, 1.0), range(2.0, 8.0)],
    )?;
    let rail = Line::new(Point3::ORIGIN, Point3::new(0.0, 3.0, 4.0));
    let arc = Arc { circle: Circle { plane, radius: 2.0 }, angle: range(0.25, 2.0) };
    let sum = SumSurface::new(ArcCurve::new(arc).into(), rail.into(), Vector3::new(0.5, 0.0, -1.0))?;
    let profile = Line::new(Point3::new(3.0, 0.0, 0.0), Point3::new(1.0, 0.0, 4.0));
    let axis = Line::new(Point3::ORIGIN, Point3::new(0.0, 0.0, 2.0));
    let turned = RevolutionSurface::with_domain(profile.into(), axis, range(0.5, 4.5), range(0.0, 10.0))?;
    let bumps = (0..20).map(|i| {
        let (u, v) = (f64::from(i / 5), f64::from(i % 5));
        Point3::new(u, v, (u * v).sin())
    });
    let knots = [vec![0.0, 0.0, 1.0, 2.0, 2.0], vec![0.0, 0.0, 0.0, 1.5, 4.0, 4.0, 4.0]];
    let nurbs = NurbsSurface::new([2, 3], [4, 5], bumps.collect(), knots)?;
    let ball = Sphere::new(plane, 2.75)?.to_nurbs()?;
    Ok(vec![
        ("plane surface", flat.into()),
        ("sum surface", sum.into()),
        ("revolution", turned.clone().into()),
        ("transposed revolution", turned.transposed().into()),
        ("sphere", Sphere::new(plane, 2.75)?.into()),
        ("nurbs surface", nurbs.into()),
        ("rational surface", ball.into()),
    ])
}

/// Quads and triangles with normals and colours, whose vertices need double precision; 300 of them, so that
/// indices take two bytes.
fn mesh() -> Result<Mesh, katydid_geometry::Error> {
    let (columns, rows) = (20_u32, 15_u32);
    let vertices: Vec<Point3> = (0..columns * rows)
        .map(|i| Point3::new(f64::from(i % columns) * 0.1, f64::from(i / columns) / 3.0, f64::from(i) / 7.0))
        .collect();
    let mut faces = Vec::new();
    for row in 0..rows - 1 {
        for column in 0..columns - 1 {
            let a = row * columns + column;
            if (row + column) % 3 == 0 {
                faces.push(MeshFace::Triangle([a, a + 1, a + columns + 1]));
                faces.push(MeshFace::Triangle([a, a + columns + 1, a + columns]));
            } else {
                faces.push(MeshFace::Quad([a, a + 1, a + columns + 1, a + columns]));
            }
        }
    }
    let colours = (0..columns * rows).map(|i| [(i % 256) as u8, (i / 2) as u8, 7, 255]).collect();
    let normals = vec![Vector3::new(0.0, 0.6, 0.8); vertices.len()];
    Mesh::from_parts(vertices, faces, normals, colours)
}

/// A mesh that single precision holds exactly.
fn plain_mesh() -> Result<Mesh, katydid_geometry::Error> {
    let corners = [(0.0, 0.0), (2.0, 0.0), (2.0, 1.0), (0.0, 1.0), (3.0, 0.5)];
    Mesh::new(
        corners.iter().map(|(x, y)| Point3::new(*x, *y, 0.25)).collect(),
        vec![MeshFace::Quad([0, 1, 2, 3]), MeshFace::Triangle([1, 4, 2])],
    )
}
