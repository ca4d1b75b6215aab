//! What an archive of some version cannot carry.

use crate::model::{Model, ModelObject};
use crate::object::Object;
use crate::styles::Styles;
use crate::version::Version;
use crate::{Result, tables::HatchFill};

/// Something of a model that an archive of some version cannot carry.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct Loss {
    /// What is left out, in words.
    pub what: String,
    /// Why.
    pub why: String,
}

impl std::fmt::Display for Loss {
    fn fmt(&self, f: &mut std::fmt::Formatter<'_>) -> std::fmt::Result {
        write!(f, "{}: {}", self.what, self.why)
    }
}

impl Model {
    /// What an archive of the given version cannot carry, in the order of the archive: records of tables and
    /// objects that [`Model::write_what_fits`] leaves out. [`Model::write`] leaves out the records, but fails for
    /// an object.
    ///
    /// # Errors
    /// A version that is not written.
    pub fn losses(&self, version: i32) -> Result<Vec<Loss>> {
        let target = Version::for_writing(version)?;
        let mut losses: Vec<Loss> = Vec::new();
        let styles = Styles::of(&self.kept, self.unit(), target);
        let kept = self.kept.iter().filter(|record| !styles.replaces(record.table));
        let objects = self.lights.iter().chain(&self.objects);
        for record in kept.chain(objects.filter_map(|object| object.history.as_deref())) {
            if let Err(why) = record.body_for(target) {
                let name = record.name();
                let what = format!("{name} of a version {} archive", record.archive_version);
                losses.push(Loss { what, why: why.into() });
            }
        }
        for table in self.user_tables.iter().filter(|table| table.body_for(target).is_none()) {
            let what = format!("the document strings of a version {} archive", table.archive_version);
            losses.push(Loss { what, why: "their chunks cannot be told".into() });
        }
        losses.extend(self.simplified(version));
        losses.extend(self.lights.iter().filter_map(|light| object_loss(light, "light", version)));
        losses.extend(self.objects.iter().filter_map(|object| object_loss(object, "object", version)));
        Ok(losses)
    }

    /// Entries that are written, but with less than they have.
    fn simplified(&self, version: i32) -> Vec<Loss> {
        let mut losses = Vec::new();
        if version >= 60 {
            return losses;
        }
        for pattern in self.hatch_patterns.iter().filter(|pattern| pattern.fill == HatchFill::Gradient) {
            losses.push(Loss {
                what: format!("the gradient of the hatch pattern {}", pattern.name),
                why: "archives of this version fill with colours and lines only".into(),
            });
        }
        for linetype in &self.linetypes {
            if linetype.width_units != 0 || !linetype.taper.is_empty() || linetype.model_distances {
                losses.push(Loss {
                    what: format!("the width of the linetype {}", linetype.name),
                    why: "linetypes of this version have none".into(),
                });
            }
        }
        losses
    }

    /// The model as far as an archive of the given version carries it, and what it does not.
    ///
    /// # Errors
    /// As [`Model::write`], except for objects that the version cannot carry.
    pub fn write_what_fits(&self, version: i32) -> Result<(Vec<u8>, Vec<Loss>)> {
        let losses = self.losses(version)?;
        let fits = |object: &ModelObject| object.geometry.check_writable(version).is_ok();
        if self.objects.iter().chain(&self.lights).all(fits) {
            return Ok((self.write(version)?, losses));
        }
        let mut carried = self.clone();
        carried.objects.retain(fits);
        carried.lights.retain(fits);
        Ok((carried.write(version)?, losses))
    }
}

fn object_loss(object: &ModelObject, kind: &str, version: i32) -> Option<Loss> {
    let error = object.geometry.check_writable(version).err()?;
    let name = if object.attributes.name.is_empty() {
        String::new()
    } else {
        format!(" {}", object.attributes.name)
    };
    let class = Object::class_name(&object.geometry);
    Some(Loss { what: format!("{kind}{name} ({class})"), why: error.to_string() })
}
