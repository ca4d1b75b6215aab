//! Writes breps of every constructor on seeded inputs, one archive a constructor: `write_solids FOLDER [COUNT
//! [CONSTRUCTOR…]]`.
//!
//! The test `tests/solids_peer.py` asks rhino3dm whether each is valid. An object's name is its constructor and seed,
//! and whether it is closed.

#[path = "../../geometry/tests/solid_cases/mod.rs"]
mod solid_cases;

use std::path::PathBuf;

use katydid_3dm::{Attributes, BrepObject, Model, ModelObject, Object};
use solid_cases::random::Random;

fn main() -> Result<(), Box<dyn std::error::Error>> {
    let mut arguments = std::env::args().skip(1);
    let folder = PathBuf::from(arguments.next().ok_or("usage: write_solids FOLDER [COUNT [CONSTRUCTOR…]]")?);
    let count: u64 = arguments.next().map_or(Ok(100), |n| n.parse())?;
    let only: Vec<String> = arguments.collect();
    for (name, make) in solid_cases::cases() {
        if !only.is_empty() && !only.iter().any(|wanted| wanted == name) {
            continue;
        }
        let mut model = Model::default();
        for seed in 0..count {
            for brep in make(&mut Random::of(seed)).into_iter().flatten() {
                let id = uuid::Uuid::from_u128(0x50_11D5_0000 + model.objects.len() as u128 + 1);
                let closed = if brep.is_solid() { "closed" } else { "open" };
                let attributes =
                    Attributes { id, name: format!("{name}/{seed}/{closed}"), ..Attributes::default() };
                let bounds = brep.bounds_of_faces();
                let object = Object::Brep(Box::new(BrepObject { bounds, ..BrepObject::from(brep) }));
                model.objects.push(ModelObject { attributes, ..object.into() });
            }
        }
        let path = folder.join(format!("{}.3dm", name.replace(' ', "-")));
        model.write_to(70, &mut std::fs::File::create(path)?)?;
    }
    Ok(())
}
