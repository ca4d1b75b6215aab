//! Texts in space, and legends.

use std::sync::Arc as Shared;

use katydid_data::Colour;
use katydid_definition::document::Object;
use katydid_geometry::{Plane, Point3};
use uuid::{Uuid, uuid};

use super::Draw;
use crate::result::Painter;
use crate::result::rows::Row;
use crate::scene::{Form, Legend, Look, Place};

pub(super) const DRAWN: &[(Uuid, Draw)] = &[
    (uuid!("3b220754-4114-4170-b6c3-b286b86ed524"), text_tag),
    (uuid!("5a41528b-12b9-40dc-a3f2-842034d267c4"), text_tag_3d),
    (uuid!("f6867cdd-2216-4451-9134-7da94bdcd5af"), legend),
];

fn text_tag(painter: &mut Painter<'_>, object: &Object, row: &Row<'_>) {
    let (Some(at), Some(text)) = (row.item::<Point3>(0), row.item::<Shared<str>>(1)) else { return };
    let line = row.item::<Colour>(2).unwrap_or(painter.look.line);
    let height = object.container().i32("TagHeight").map_or(13.0, f64::from);
    let tag = Form::Tag { at, text: text.to_string(), size: height.clamp(4.0, 200.0), place: Place::Beside };
    painter.scene.add(tag, Look { line, ..painter.look });
}

fn text_tag_3d(painter: &mut Painter<'_>, _: &Object, row: &Row<'_>) {
    let (Some(plane), Some(text)) = (row.item::<Plane>(0), row.item::<Shared<str>>(1)) else { return };
    let line = row.item::<Colour>(3).unwrap_or(painter.look.line);
    let size = row.item::<f64>(2).unwrap_or(1.0);
    let justification = row.item::<i32>(4).unwrap_or(7);
    let writing = Form::Writing { plane, text: text.to_string(), size, justification };
    if size.is_finite() && size > 0.0 {
        painter.scene.add(writing, Look { line, ..painter.look });
    }
}

fn legend(painter: &mut Painter<'_>, _: &Object, row: &Row<'_>) {
    let tags: Vec<Shared<str>> = row.list(1);
    let text = |k: usize| tags.get(k).map(|tag| tag.to_string()).unwrap_or_default();
    let entries = row.list::<Colour>(0).into_iter().enumerate().map(|(k, colour)| (colour, text(k)));
    painter.scene.legends.push(Legend::List(entries.collect()));
}
