//! SubDs.

use katydid_geometry::Mesh;
use katydid_geometry::subd::{FromMesh, SubD, SubDNet};
use serde_json::Value as Json;

use super::answer::Outcome;
use super::table::Endpoints;
use crate::Fault;
use crate::wire::{Members, Read, Subdivision};

pub(super) fn enter(table: &mut Endpoints) {
    table.add("subd/createfrommesh-mesh", |m: Mesh| of_mesh(&m, Options::default()));
    table.add("subd/createfrommesh-mesh_subdcreationoptions", |m: Mesh, options: Option<Options>| {
        of_mesh(&m, options.unwrap_or_default())
    });
}

/// `SubDCreationOptions`, as far as they are heeded.
#[derive(Default)]
struct Options {
    creases: bool,
    corners: bool,
    interpolate: bool,
}

impl Read for Options {
    fn read(json: &Json) -> Result<Self, Fault> {
        let members = Members::of(json)?;
        // 0 is unset, 1 none, 2 at double edges, or at corners of one face.
        let creases: i32 = members.read_or("InteriorCreaseTest", 0)?;
        let corners: i32 = members.read_or("ConvexCornerTest", 0)?;
        let interpolate = members.read_or("InterpolateMeshVertices", false)?;
        Ok(Self { creases: creases >= 2, corners: corners >= 2, interpolate })
    }
}

fn of_mesh(mesh: &Mesh, options: Options) -> Outcome<Subdivision> {
    let net = SubDNet::from_mesh(mesh, &FromMesh { creases: options.creases, corners: options.corners })?;
    let net = if options.interpolate { net.interpolating()?.0 } else { net };
    Ok(Subdivision(SubD::new(net)))
}
