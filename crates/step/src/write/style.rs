//! Colours and layers.

use std::collections::BTreeMap;

use super::product::Context;
use crate::part21::{Id, Sheet, list, quoted, real};
use crate::{Document, Shape};

/// Gives parts their colours and layers.
pub(super) fn put(sheet: &mut Sheet, document: &Document, context: &Context, styled: &[(Id, usize)]) {
    let mut known = BTreeMap::new();
    let mut items = Vec::new();
    let mut layers: BTreeMap<&str, Vec<Id>> = BTreeMap::new();
    for (id, place) in styled {
        let Some(part) = document.parts.get(*place) else { continue };
        if let Some(layer) = part.layer.as_deref().filter(|layer| !layer.is_empty()) {
            layers.entry(layer).or_default().push(*id);
        }
        if let Some(colour) = part.colour {
            let kind = Kind::of(&part.shape);
            let style = *known.entry((colour, kind)).or_insert_with(|| style(sheet, colour, kind));
            items.push(sheet.put(format_args!("STYLED_ITEM('',({style}),{id})")));
        }
    }
    if !items.is_empty() {
        sheet.put(format_args!(
            "MECHANICAL_DESIGN_GEOMETRIC_PRESENTATION_REPRESENTATION('',{},{})",
            list(items),
            context.geometry
        ));
    }
    for (layer, ids) in layers {
        sheet.put(format_args!("PRESENTATION_LAYER_ASSIGNMENT({},'',{})", quoted(layer), list(ids)));
    }
}

/// What is coloured.
#[derive(Debug, Clone, Copy, PartialEq, Eq, PartialOrd, Ord)]
enum Kind {
    Points,
    Curve,
    Faces,
}

impl Kind {
    fn of(shape: &Shape) -> Self {
        match shape {
            Shape::Points(_) => Self::Points,
            Shape::Curve(_) => Self::Curve,
            Shape::Brep(_) => Self::Faces,
        }
    }
}

fn style(sheet: &mut Sheet, [r, g, b, alpha]: [u8; 4], kind: Kind) -> Id {
    let part = |x: u8| real(f64::from(x) / 255.0);
    let colour = sheet.put(format_args!("COLOUR_RGB('',{},{},{})", part(r), part(g), part(b)));
    let style = match kind {
        Kind::Points => sheet
            .put(format_args!("POINT_STYLE('',MARKER_TYPE(.DOT.),POSITIVE_LENGTH_MEASURE(0.1),{colour})")),
        Kind::Curve => {
            let font = sheet.put("DRAUGHTING_PRE_DEFINED_CURVE_FONT('continuous')");
            sheet.put(format_args!("CURVE_STYLE('',{font},POSITIVE_LENGTH_MEASURE(0.1),{colour})"))
        }
        Kind::Faces => faces(sheet, colour, alpha),
    };
    sheet.put(format_args!("PRESENTATION_STYLE_ASSIGNMENT(({style}))"))
}

fn faces(sheet: &mut Sheet, colour: Id, alpha: u8) -> Id {
    let fill = sheet.put(format_args!("FILL_AREA_STYLE_COLOUR('',{colour})"));
    let fill = sheet.put(format_args!("FILL_AREA_STYLE('',({fill}))"));
    let mut styles = vec![sheet.put(format_args!("SURFACE_STYLE_FILL_AREA({fill})"))];
    if alpha < u8::MAX {
        let share = real(1.0 - f64::from(alpha) / 255.0);
        let through = sheet.put(format_args!("SURFACE_STYLE_TRANSPARENT({share})"));
        styles.push(sheet.put(format_args!(
            "SURFACE_STYLE_RENDERING_WITH_PROPERTIES(.NORMAL_SHADING.,{colour},({through}))"
        )));
    }
    let side = sheet.put(format_args!("SURFACE_SIDE_STYLE('',{})", list(styles)));
    sheet.put(format_args!("SURFACE_STYLE_USAGE(.BOTH.,{side})"))
}
