//! The Breps of archives, for examples that judge them.

use katydid_3dm::{Limits, Model, Object};
use katydid_geometry::brep::Brep;

/// Every Brep of archives, extrusions as such, with a name that says where it stands: `FILE PLACE`. An archive that
/// cannot be read is named.
#[allow(clippy::print_stdout, reason = "an example speaks")]
pub(crate) fn breps_of(paths: &[String]) -> impl Iterator<Item = (String, Brep)> + '_ {
    paths.iter().flat_map(|path| {
        let read = std::fs::read(path).map_err(|e| e.to_string());
        let model = read.and_then(|bytes| Model::read(&bytes, &Limits::default()).map_err(|e| e.to_string()));
        let objects = model.map(|model| model.objects).unwrap_or_else(|why| {
            println!("{path}: not read: {why}");
            Vec::new()
        });
        let name = path.rsplit('/').next().unwrap_or(path);
        objects.into_iter().enumerate().filter_map(move |(place, object)| match object.geometry {
            Object::Brep(b) => Some((format!("{name} {place}"), b.brep)),
            Object::Extrusion(e) => Some((format!("{name} {place} extrusion"), e.to_brep()?.brep)),
            _ => None,
        })
    })
}
