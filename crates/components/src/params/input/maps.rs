//! Maps from shapefiles.

use std::sync::Arc;

use katydid_component::{Context, Message, component};
use katydid_data::Value;
use katydid_exchange::shp;
use katydid_geometry::{Brep, Curve, Point3, PolylineCurve};

/// Reads the points, lines and regions of a shapefile (.shp), a format of maps.
///
/// Coordinates are taken as they stand, whatever projection of the earth they follow. Regions are flat surfaces with
/// their holes. What is not read, patches in space say, is left out with a warning. A path that is not absolute starts
/// where the definition lies.
#[component("aa538b89-3df8-436f-9ae4-bc44525984de", name = "Import SHP", nick = "SHP", at = "Params/Input")]
#[output("Points", "P", "The points.")]
#[output("Curves", "C", "The parts of lines, as polylines.")]
#[output("Regions", "R", "The regions, as surfaces with holes.", kind = Brep)]
fn import_shp(
    context: &Context<'_>,
    /// The path of the file.
    #[port("File", "F")]
    file: Arc<str>,
) -> Result<(Vec<Point3>, Vec<Option<Arc<Curve>>>, Vec<Option<Value>>), Message> {
    let bytes = context.read_file(&file)?;
    let read = shp::read(&bytes).map_err(|error| Message::error(format!("{file}: {error}")))?;
    for left_out in &read.left_out {
        context.warn(format!("Left out: {left_out}"));
    }
    context.items(read.points.len())?;
    context.items(read.lines.len())?;
    context.items(read.polygons.len())?;
    let curve = |points: Vec<Point3>| match PolylineCurve::new(points) {
        Ok(curve) => Some(Arc::new(Curve::from(curve))),
        Err(error) => {
            context.warn(format!("A line is left out: {error}"));
            None
        }
    };
    let curves = read.lines.into_iter().map(curve).collect();
    let mut regions = Vec::with_capacity(read.polygons.len());
    for rings in read.polygons {
        context.check()?;
        regions.extend(region(context, rings)?);
    }
    Ok((read.points, curves, regions))
}

/// The surfaces of one polygon: a record may hold several outlines with their holes.
fn region(context: &Context<'_>, rings: Vec<Vec<Point3>>) -> Result<Vec<Option<Value>>, Message> {
    let outlines: Vec<Curve> =
        rings.into_iter().filter_map(|ring| PolylineCurve::new(ring).ok().map(Curve::from)).collect();
    let found = match Brep::planar_faces(&outlines, &context.tolerance()) {
        Ok(found) if !found.breps.is_empty() => found,
        _ => {
            context.warn("A region is left out: it is not flat, not closed, or encloses nothing");
            return Ok(vec![None]);
        }
    };
    context.items(found.breps.len())?;
    Ok(found.breps.into_iter().map(|brep| Some(Value::from(brep))).collect())
}

#[cfg(test)]
mod tests {
    use katydid_component::Files;
    use katydid_component::testing::{Trial, texts};

    /// A file of records, each a type, counts and numbers, by the format's white paper.
    fn file(records: &[(i32, &[i32], &[f64])]) -> Vec<u8> {
        let mut bytes = vec![0; 100];
        bytes[..4].copy_from_slice(&9994_i32.to_be_bytes());
        for (kind, counts, numbers) in records {
            let mut content = kind.to_le_bytes().to_vec();
            content.extend(vec![0; if counts.is_empty() { 0 } else { 32 }]);
            content.extend(counts.iter().flat_map(|n| n.to_le_bytes()));
            content.extend(numbers.iter().flat_map(|x| x.to_le_bytes()));
            bytes.extend(1_i32.to_be_bytes());
            bytes.extend((content.len() as i32 / 2).to_be_bytes());
            bytes.extend(content);
        }
        bytes
    }

    #[test]
    fn points_curves_and_regions_of_a_map() {
        let folder = std::env::temp_dir().join(format!("katydid-map-{}", std::process::id()));
        std::fs::create_dir_all(&folder).unwrap();
        // A square of 4 clockwise, a hole of 1 in it counter-clockwise.
        let square = [0.0, 0.0, 0.0, 4.0, 4.0, 4.0, 4.0, 0.0, 0.0, 0.0];
        let hole = [1.0, 1.0, 2.0, 1.0, 2.0, 2.0, 1.0, 2.0, 1.0, 1.0];
        let rings = [square, hole].concat();
        let map = file(&[
            (1, &[], &[3.0, 4.0]),
            (3, &[1, 2, 0], &[0.0, 0.0, 3.0, 4.0]),
            (5, &[2, 10, 0, 5], &rings),
            (31, &[0, 0], &[]),
        ]);
        std::fs::write(folder.join("map.shp"), map).unwrap();
        std::fs::write(folder.join("no.shp"), "text").unwrap();
        let trial = |name: &str| Trial::of("Import SHP").files(Files::Inside(folder.clone())).item(name);
        let out = trial("map.shp").run();
        assert_eq!(texts(&out.outputs[0]), ["{0;0}: {3, 4, 0}"]);
        assert_eq!(texts(&out.outputs[1]), ["{0;0}: Line-like Curve"]);
        assert_eq!(texts(&out.outputs[2]), ["{0;0}: Trimmed Surface"]);
        assert_eq!(Trial::of("Area").tree(out.outputs[2].clone()).texts(0), ["{0;0}: 15"]);
        assert!(out.messages[0].text.contains("1 × multipatch"));
        assert!(trial("no.shp").message().contains("does not begin as every shapefile does"));
        std::fs::remove_dir_all(&folder).unwrap();
    }
}
