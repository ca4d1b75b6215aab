//! What openNURBS calls invalid is mended or told.

use std::collections::BTreeMap;

use katydid_3dm::{Limits, Object, ObjectMode, Validity};

use super::Baked;

/// Makes meshes valid and takes out those of which nothing is left; of everything else that is invalid a remark tells.
pub(super) fn make_valid(baked: &mut Baked) {
    let mut dropped: BTreeMap<String, usize> = BTreeMap::new();
    let mut invalid: BTreeMap<(String, String), usize> = BTreeMap::new();
    baked.model.objects.retain_mut(|object| {
        let Validity::Invalid(reason) = object.geometry.validity() else { return true };
        let mesh = match &object.geometry {
            Object::Kept(raw) => match raw.parse(&Limits::default()) {
                Ok(Object::Mesh(mesh)) => Some(mesh),
                _ => None,
            },
            Object::Mesh(mesh) => Some(mesh.clone()),
            _ => None,
        };
        let Some(mesh) = mesh else {
            *invalid.entry((object.attributes.name.clone(), reason)).or_default() += 1;
            return true;
        };
        match mesh.made_valid() {
            Some(made) => object.geometry = Object::Mesh(Box::new(made)),
            // A block keeps what it is made of.
            None if object.attributes.mode == ObjectMode::InDefinition => {
                *invalid.entry((object.attributes.name.clone(), reason)).or_default() += 1;
            }
            None => {
                *dropped.entry(object.attributes.name.clone()).or_default() += 1;
                return false;
            }
        }
        true
    });
    let objects = |count: usize, what: &str| match count {
        1 => format!("a {what}"),
        n => format!("{n} {what}es"),
    };
    let dropped = dropped.into_iter();
    baked.left_out.extend(dropped.map(|(name, n)| format!("{name}: {} without faces", objects(n, "mesh"))));
    let invalid = invalid.into_iter();
    baked.remarks.extend(invalid.map(|((name, reason), n)| match n {
        1 => format!("{name}: an object is invalid by the rules of openNURBS: {reason}"),
        n => format!("{name}: {n} objects are invalid by the rules of openNURBS: {reason}"),
    }));
}

#[cfg(test)]
mod tests {
    #![allow(clippy::unwrap_used, clippy::panic, reason = "a failing assertion is how a test reports")]

    use katydid_3dm::{Model, ModelObject};
    use katydid_geometry::{Mesh, MeshFace, Plane, Point3};

    use super::*;

    #[test]
    fn meshes_are_made_valid_or_left_out() {
        let at = |x: f64, y: f64| Point3::new(x, y, 0.0);
        let corners = vec![at(0.0, 0.0), at(1.0, 0.0), at(1.0, 1.0), at(0.0, 0.0), at(5.0, 5.0)];
        let odd = Mesh::new(corners.clone(), vec![MeshFace::Quad([0, 1, 2, 3])]).unwrap().with_normals();
        let flat = Mesh::new(corners, vec![MeshFace::Triangle([0, 1, 3])]).unwrap().with_normals();
        let sound = Mesh::sphere(&Plane::XY, 1.0, 8, 4).unwrap().with_normals();
        let mut model = Model::default();
        for mesh in [&odd, &flat, &sound, &Mesh::default()] {
            let mut object = ModelObject::from(Object::from(mesh.clone()));
            object.attributes.name = "Mesh".to_owned();
            model.objects.push(object);
        }
        let nowhere = ModelObject::from(Object::Point(at(f64::NAN, 0.0)));
        model.objects.push(nowhere);
        let mut baked = Baked { model, left_out: Vec::new(), remarks: Vec::new() };
        make_valid(&mut baked);
        let objects = &baked.model.objects;
        assert_eq!(objects.len(), 3);
        assert!(objects[..2].iter().all(|object| object.geometry.validity() == Validity::Valid));
        assert_eq!(objects[1].geometry, Object::from(sound));
        assert_eq!(baked.left_out, ["Mesh: 2 meshes without faces"]);
        assert!(baked.remarks[0].contains("invalid by the rules of openNURBS"), "{:?}", baked.remarks);
    }
}
