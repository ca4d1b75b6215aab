//! The product that all parts belong to, its representations, and the header.

use super::{Written, frame, unit};
use crate::part21::{Id, Sheet, list, quoted, real};
use crate::{Document, Shape};
use katydid_geometry::Plane;

/// Places nearer than this many metres are one, whatever a model's tolerance is: programs merge what is nearer.
const NEAR: f64 = 1e-6;
/// They are also nearer than this part of the smallest shape, or small shapes fall into a point.
const PART: f64 = 1e-3;
/// The least number of metres that programs tell apart.
const LEAST: f64 = 1e-10;

/// What representations refer to.
pub(super) struct Context {
    /// The geometric context: units and uncertainty.
    pub(super) geometry: Id,
}

impl Context {
    pub(super) fn put(sheet: &mut Sheet, document: &Document) -> Self {
        let metres = if document.metres > 0.0 && document.metres.is_finite() { document.metres } else { 1.0 };
        let length = unit::length(sheet, metres);
        let angle = sheet.put("(NAMED_UNIT(*)PLANE_ANGLE_UNIT()SI_UNIT($,.RADIAN.))");
        let solid = sheet.put("(NAMED_UNIT(*)SI_UNIT($,.STERADIAN.)SOLID_ANGLE_UNIT())");
        let mut near = NEAR / metres;
        if document.tolerance > 0.0 {
            near = near.min(document.tolerance);
        }
        let near = near.min(PART * smallest(document)).max(LEAST / metres);
        let uncertainty = sheet.put(format_args!(
            "UNCERTAINTY_MEASURE_WITH_UNIT(LENGTH_MEASURE({}),{length},'distance_accuracy_value','')",
            real(near)
        ));
        let geometry = sheet.put(format_args!(
            "(GEOMETRIC_REPRESENTATION_CONTEXT(3)GLOBAL_UNCERTAINTY_ASSIGNED_CONTEXT(({uncertainty}))\
             GLOBAL_UNIT_ASSIGNED_CONTEXT(({length},{angle},{solid}))REPRESENTATION_CONTEXT('','3D'))"
        ));
        Self { geometry }
    }
}

/// The size of the smallest brep.
fn smallest(document: &Document) -> f64 {
    let sizes = document.parts.iter().filter_map(|part| match &part.shape {
        Shape::Brep(brep) => brep.bounds_of_faces().map(|bounds| bounds.diagonal().length()),
        _ => None,
    });
    sizes.filter(|size| *size > 0.0).fold(f64::INFINITY, f64::min)
}

/// The product and the representations of its shape.
pub(super) fn put(sheet: &mut Sheet, document: &Document, context: &Context, written: &Written) {
    let shape = shape(sheet, document);
    let kinds = [
        ("ADVANCED_BREP_SHAPE_REPRESENTATION", &written.solids),
        ("MANIFOLD_SURFACE_SHAPE_REPRESENTATION", &written.sheets),
        ("GEOMETRICALLY_BOUNDED_WIREFRAME_SHAPE_REPRESENTATION", &written.curves),
    ];
    let name = quoted(&document.name);
    let geometry = context.geometry;
    let put = |keyword: &str, items: &[Id], sheet: &mut Sheet| {
        let origin = frame(sheet, &Plane::XY);
        let all = std::iter::once(&origin).chain(items);
        sheet.put(format_args!("{keyword}({name},{},{geometry})", list(all)))
    };
    let used: Vec<_> = kinds.into_iter().filter(|(_, items)| !items.is_empty()).collect();
    let main = match used.as_slice() {
        [(keyword, items)] => put(keyword, items, sheet),
        several => {
            let main = put("SHAPE_REPRESENTATION", &[], sheet);
            for (keyword, items) in several {
                let other = put(keyword, items, sheet);
                sheet.put(format_args!("SHAPE_REPRESENTATION_RELATIONSHIP('','',{main},{other})"));
            }
            main
        }
    };
    sheet.put(format_args!("SHAPE_DEFINITION_REPRESENTATION({shape},{main})"));
}

/// The definition of the shape of the one product.
fn shape(sheet: &mut Sheet, document: &Document) -> Id {
    let name = quoted(if document.name.is_empty() { "model" } else { &document.name });
    let application =
        sheet.put("APPLICATION_CONTEXT('core data for automotive mechanical design processes')");
    sheet.put(format_args!(
        "APPLICATION_PROTOCOL_DEFINITION('international standard','automotive_design',2000,{application})"
    ));
    let product_context = sheet.put(format_args!("PRODUCT_CONTEXT('',{application},'mechanical')"));
    let product = sheet.put(format_args!("PRODUCT({name},{name},'',({product_context}))"));
    sheet.put(format_args!("PRODUCT_RELATED_PRODUCT_CATEGORY('part',$,({product}))"));
    let formation = sheet.put(format_args!("PRODUCT_DEFINITION_FORMATION('','',{product})"));
    let view =
        sheet.put(format_args!("PRODUCT_DEFINITION_CONTEXT('part definition',{application},'design')"));
    let definition = sheet.put(format_args!("PRODUCT_DEFINITION('design','',{formation},{view})"));
    sheet.put(format_args!("PRODUCT_DEFINITION_SHAPE('','',{definition})"))
}

/// The file up to its entities. It has no time: the same document makes the same bytes.
pub(super) fn header(document: &Document) -> String {
    let name = quoted(&document.name);
    format!(
        "ISO-10303-21;\nHEADER;\nFILE_DESCRIPTION((''),'2;1');\n\
         FILE_NAME({name},'1970-01-01T00:00:00',(''),(''),'Katydid','Katydid','');\n\
         FILE_SCHEMA(('AUTOMOTIVE_DESIGN {{ 1 0 10303 214 1 1 1 1 }}'));\nENDSEC;\nDATA;\n"
    )
}
