//! Bytes that nobody vouches for: never a panic, never an allocation that they do not pay for.

mod common;

use katydid_3dm::{BrepSummary, Limits, Model, Object};
use proptest::prelude::*;

/// The smallest real archives, or one of our own making when there are none.
#[allow(clippy::unwrap_used, reason = "a helper of tests only")]
fn seeds() -> Vec<Vec<u8>> {
    let mut seeds: Vec<Vec<u8>> =
        common::archives().into_iter().map(|(_, b)| b).filter(|b| b.len() < 60_000).take(12).collect();
    let mut model = Model::default();
    model.objects.push(Object::Point(katydid_geometry::Point3::ORIGIN).into());
    seeds.push(model.write(70).unwrap());
    seeds
}

fn exercise(bytes: &[u8]) {
    let limits = Limits { inflated: 1 << 26, ..Limits::default() };
    let Ok(model) = Model::read(bytes, &limits) else { return };
    for object in &model.objects {
        if let Object::Kept(raw) = &object.geometry {
            let _ = BrepSummary::read(raw);
        }
    }
    let _ = (model.views(), model.named_views(), model.named_construction_planes(), model.page_settings());
    let _ = (model.dimension_styles(), model.text_styles());
    for version in [4, 50, 70] {
        let _ = model.write_what_fits(version);
    }
}

proptest! {
    #[test]
    fn flipped_bytes_never_panic(
        seed in any::<prop::sample::Index>(),
        flips in prop::collection::vec((any::<prop::sample::Index>(), any::<u8>()), 1..20),
        cut in proptest::option::weighted(0.2, any::<prop::sample::Index>()),
    ) {
        thread_local!(static SEEDS: Vec<Vec<u8>> = seeds());
        SEEDS.with(|seeds| {
            let mut bytes = seed.get(seeds).clone();
            for (place, value) in flips {
                let at = place.index(bytes.len());
                bytes[at] = value;
            }
            if let Some(cut) = cut {
                bytes.truncate(cut.index(bytes.len()));
            }
            exercise(&bytes);
        });
    }

    #[test]
    fn objects_out_of_any_bytes_never_panic(
        version in prop::sample::select(vec![2, 4, 5, 50, 60, 70, 80, 1, -3]),
        opennurbs in any::<i32>(),
        bytes in prop::collection::vec(any::<u8>(), 0..300),
    ) {
        let _ = Object::from_on_data(version, opennurbs, &bytes);
    }

    #[test]
    fn flipped_objects_never_panic(flips in prop::collection::vec((any::<prop::sample::Index>(), any::<u8>()), 1..6)) {
        let mesh = katydid_geometry::Mesh::new(
            (0..300).map(|i| katydid_geometry::Point3::new(f64::from(i) / 3.0, 0.1, 0.0)).collect(),
            vec![katydid_geometry::MeshFace::Triangle([0, 1, 299])],
        ).unwrap();
        for version in [50, 70] {
            let written = Object::from(mesh.clone()).to_on_data(version).unwrap();
            let mut bytes = written.data;
            for (place, value) in &flips {
                let at = place.index(bytes.len());
                bytes[at] = *value;
            }
            let _ = Object::from_on_data(version, written.opennurbs, &bytes);
        }
    }
}
