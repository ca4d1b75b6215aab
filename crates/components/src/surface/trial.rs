//! What tests of components that make breps look at.

use katydid_component::testing::Trial;
use katydid_geometry::{Brep, MeshSettings};

/// The breps of the first output.
pub(super) fn breps(trial: Trial) -> Vec<Brep> {
    let column = trial.run().outputs.swap_remove(0);
    let column = column.column();
    let breps = column.iter().map(|item| (*item.unwrap().brep().unwrap().unwrap()).clone());
    let breps: Vec<Brep> = breps.collect();
    for brep in &breps {
        assert_eq!(brep.faults(), [], "a brep with faults");
    }
    breps
}

/// The area of a fine mesh.
pub(super) fn mesh_area(brep: &Brep) -> f64 {
    brep.mesh(&MeshSettings::within(1e-4)).unwrap().to_mesh().unwrap().area()
}

/// The volume of a fine mesh.
pub(super) fn mesh_volume(brep: &Brep) -> f64 {
    let mesh = brep.mesh(&MeshSettings::within(1e-4)).unwrap().welded().unwrap();
    assert!(mesh.is_closed(), "the mesh of a solid has gaps");
    mesh.volume()
}
