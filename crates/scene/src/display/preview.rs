//! Display / Preview: geometry with a material, dots, symbols.

use std::sync::Arc as Shared;

use katydid_data::{Colour, Geometry, Material, Symbol, Value};
use katydid_definition::document::Object;
use katydid_geometry::{Curve, Mesh, Point3, Xform};
use uuid::{Uuid, uuid};

use super::Draw;
use crate::Painter;
use crate::rows::Row;
use crate::values;
use crate::{Form, Look};

pub(super) const DRAWN: &[(Uuid, Draw)] = &[
    (uuid!("537b0419-bbc2-4ff4-bf08-afe526367b2c"), custom_preview),
    (uuid!("6b1bd8b2-47a4-4aa6-a471-3fd91c62a486"), dot),
    (uuid!("059b72b0-9bb3-4542-a805-2dcd27493164"), cloud),
    (uuid!("62d5ead4-53c4-4d0b-b5ce-6bd6e0850ab8"), symbol),
    (uuid!("eeb8f5d3-2c5e-46bd-a368-10f0f9576fe9"), custom_curve),
    // Human's previews with line weights and with materials.
    (uuid!("a77d0879-94c2-4101-be44-e4a616ffeb0c"), weighted_preview),
    (uuid!("ff7300b2-a4c7-4651-8fa9-79a328f41e3c"), weighted_preview),
    (uuid!("e407f858-6c25-4550-a010-76cfa112e6bd"), custom_preview),
    // Human's curves, points and meshes on the screen.
    (uuid!("6b1c7c1e-0d4e-4e3a-9d5c-3f0a5a6fd341"), placed_curve),
    (uuid!("6b1c7c1e-0d4e-4e3a-9d5c-3f0a5a6fd342"), placed_point),
    (uuid!("6b1c7c1e-0d4e-4e3a-9d5c-3f0a5a6fd343"), placed_mesh),
    (uuid!("6b1c7c1e-0d4e-4e3a-9d5c-3f0a5a6fd347"), placed_mesh),
];

/// What a thing near the origin is moved by: it is made larger about the origin first.
fn placed(row: &Row<'_>) -> Option<Xform> {
    let at = row.item::<Point3>(1).unwrap_or(Point3::ORIGIN);
    let scale = row.item::<f64>(2).unwrap_or(1.0);
    let map = Xform::translation(at - Point3::ORIGIN) * Xform::scale(Point3::ORIGIN, scale);
    (scale != 0.0 && map.is_finite()).then_some(map)
}

fn placed_curve(painter: &mut Painter<'_>, _: &Object, row: &Row<'_>) {
    let (Some(curve), Some(map)) = (row.item::<Shared<Curve>>(0), placed(row)) else { return };
    let line = row.item::<Colour>(3).unwrap_or_default();
    let width = f64::from(row.item::<i32>(4).unwrap_or(1)).clamp(0.1, 100.0);
    if let Ok(curve) = curve.transformed(&map) {
        painter.scene.add(Form::Curve(Shared::new(curve)), Look { line, width, ..painter.look });
    }
}

fn placed_point(painter: &mut Painter<'_>, _: &Object, row: &Row<'_>) {
    let (Some(point), Some(map)) = (row.item::<Point3>(0), placed(row)) else { return };
    let line = row.item::<Colour>(3).unwrap_or_default();
    painter.scene.add(Form::Point(map.point(point)), Look { line, ..painter.look });
}

fn placed_mesh(painter: &mut Painter<'_>, object: &Object, row: &Row<'_>) {
    let (Some(mesh), Some(map)) = (row.item::<Shared<Mesh>>(0), placed(row)) else { return };
    let Ok(mesh) = mesh.transformed(&map) else { return };
    let material = Material::from(row.item::<Colour>(3).unwrap_or(Colour::rgb(150, 150, 150)));
    let look = values::look(&material, painter.look);
    painter.values.add(&mut painter.scene, &Value::from(mesh), look, painter.rules, object.title());
}

fn weighted_preview(painter: &mut Painter<'_>, object: &Object, row: &Row<'_>) {
    let (Some(Geometry(value)), Some(material)) = (row.item::<Geometry>(0), row.item::<Material>(1)) else {
        return;
    };
    let width = row.item::<f64>(2).filter(|width| width.is_finite()).unwrap_or(1.0).clamp(0.1, 100.0);
    let look = Look { width, ..values::look(&material, painter.look) };
    painter.values.add(&mut painter.scene, &value, look, painter.rules, object.title());
}

fn custom_preview(painter: &mut Painter<'_>, object: &Object, row: &Row<'_>) {
    let (Some(Geometry(value)), Some(material)) = (row.item::<Geometry>(0), row.item::<Material>(1)) else {
        return;
    };
    let look = values::look(&material, painter.look);
    painter.values.add(&mut painter.scene, &value, look, painter.rules, object.title());
}

fn dot(painter: &mut Painter<'_>, _: &Object, row: &Row<'_>) {
    let Some(at) = row.item::<Point3>(0) else { return };
    let line = row.item::<Colour>(1).unwrap_or_default();
    let size = row.item::<f64>(2).unwrap_or(1.0);
    if size.is_finite() && size > 0.0 {
        painter.scene.add(Form::Dot(at, size), Look { line, ..painter.look });
    }
}

fn cloud(painter: &mut Painter<'_>, _: &Object, row: &Row<'_>) {
    let colours: Vec<Colour> = row.list(1);
    let size = row.item::<f64>(2).unwrap_or(1.0);
    if !(size.is_finite() && size > 0.0) {
        return;
    }
    for (k, at) in row.list::<Point3>(0).into_iter().enumerate() {
        let line = colours.get(k).or(colours.last()).copied().unwrap_or(Colour::rgb(255, 20, 147));
        // Soft dots let half of what is behind them through.
        painter
            .scene
            .add(Form::Dot(at, size), Look { line: Colour { a: line.a / 2, ..line }, ..painter.look });
    }
}

/// The curve in its colour; the gaps of its linetype are not drawn.
fn custom_curve(painter: &mut Painter<'_>, _: &Object, row: &Row<'_>) {
    if let (Some(curve), Some(line)) = (row.item::<Shared<Curve>>(0), row.item::<Colour>(2)) {
        painter.scene.add(Form::Curve(curve), Look { line, ..painter.look });
    }
}

fn symbol(painter: &mut Painter<'_>, _: &Object, row: &Row<'_>) {
    if let (Some(at), Some(symbol)) = (row.item::<Point3>(0), row.item::<Shared<Symbol>>(1)) {
        painter.scene.add(Form::Symbol(at, symbol), painter.look);
    }
}
