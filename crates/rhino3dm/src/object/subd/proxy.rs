//! SubDs in archives before version 60 (and 70, as Rhino 6 wrote them): a mesh of the same shape, and the SubD in its
//! user data.

use katydid_geometry::subd::SubDNet;
use katydid_geometry::{Mesh, MeshFace};
use sha1::{Digest, Sha1};
use uuid::{Uuid, uuid};

use super::{SubDObject, WHAT, read, write};
use crate::chunk::{Reader, Writer};
use crate::class_object::UserData;
use crate::version::Version;
use crate::{Error, MeshObject, Ngon, Result, class_ids};

/// The application that owns the user data.
const OPENNURBS_6: Uuid = uuid!("7B0B585D-7A31-45D0-925E-BDD7DDF3E4E3");
/// The first version whose archives have SubDs.
const FIRST: i32 = 60;

/// Whether an archive of the given version can carry a SubD, as a mesh if need be.
pub(in crate::object) fn check_writable(subd: &SubDObject, version: i32) -> Result<()> {
    if version >= FIRST || net_of(subd).is_some() {
        return Ok(());
    }
    Err(Error::CannotWrite {
        what: "a SubD".into(),
        version,
        why: "archives have the class from version 60 on, and this one has no faces to make a mesh of".into(),
    })
}

/// The mesh that stands for a SubD in an archive of the given version, with the user data that makes it one again;
/// nothing when the archive has SubDs, or the SubD no faces.
pub(in crate::object) fn mesh_of(
    subd: &SubDObject,
    version: Version,
) -> Result<Option<(MeshObject, UserData)>> {
    if version.archive >= FIRST {
        return Ok(None);
    }
    let Some((mesh, ngons)) = net_of(subd) else { return Ok(None) };
    let mesh = MeshObject { ngons, ..MeshObject::from(mesh) };
    let mut data = UserData::core(class_ids::SUBD_PROXY, 1, version, |w| {
        w.versioned(1, 1, |w| {
            w.bool(true);
            write::write(subd, w)?;
            w.count(mesh.faces.len(), "faces")?;
            w.count(mesh.vertices.len(), "vertices")?;
            hashes_of(&mesh).iter().try_for_each(|hash| write_hash(hash, w))
        })
    })?;
    data.application = OPENNURBS_6;
    Ok(Some((mesh, data)))
}

/// By what readers tell that the mesh is the one of then: hashes of its faces and of its vertices.
fn hashes_of(mesh: &MeshObject) -> [[u8; 20]; 2] {
    let faces: Vec<u8> = mesh.faces.iter().flatten().flat_map(|i| i.to_le_bytes()).collect();
    let vertices: Vec<u8> = mesh.vertices.iter().flatten().flat_map(|x| x.to_le_bytes()).collect();
    [Sha1::digest(&faces).into(), Sha1::digest(&vertices).into()]
}

fn read_hash(body: &mut Reader<'_>) -> Result<[u8; 20]> {
    let (mut chunk, _) = body.versioned_1("hash of a mesh")?;
    let hash = chunk.array("hash of a mesh")?;
    chunk.finish();
    Ok(hash)
}

fn write_hash(hash: &[u8; 20], w: &mut Writer) -> Result<()> {
    w.versioned(1, 0, |w| {
        w.bytes(hash);
        Ok(())
    })
}

/// The control net as a mesh, its polygons of more than four corners as groups of triangles.
fn net_of(subd: &SubDObject) -> Option<(Mesh, Vec<Ngon>)> {
    let subd = subd.to_subd().ok()?;
    let net: &SubDNet = subd.net();
    let points = net.vertices().iter().map(|vertex| vertex.point).collect();
    let (mut faces, mut ngons) = (Vec::new(), Vec::new());
    for face in 0..net.faces().len() {
        let corners =
            net.corners(face).map(|corner| u32::try_from(corner).ok()).collect::<Option<Vec<u32>>>()?;
        match *corners.as_slice() {
            [a, b, c] => faces.push(MeshFace::Triangle([a, b, c])),
            [a, b, c, d] => faces.push(MeshFace::Quad([a, b, c, d])),
            [a, ref others @ ..] => {
                let first = u32::try_from(faces.len()).ok()?;
                faces.extend(others.windows(2).filter_map(|pair| match *pair {
                    [b, c] => Some(MeshFace::Triangle([a, b, c])),
                    _ => None,
                }));
                let end = u32::try_from(faces.len()).ok()?;
                ngons.push(Ngon { vertices: corners.clone(), faces: (first..end).collect() });
            }
            [] => {}
        }
    }
    if faces.is_empty() {
        return None;
    }
    Some((Mesh::new(points, faces).ok()?, ngons))
}

/// The SubD that user data says a mesh stands for; none when the mesh is not that of then any more.
pub(in crate::object) fn stood_for(mesh: &MeshObject, data: &UserData) -> Option<SubDObject> {
    if data.class != class_ids::SUBD_PROXY {
        return None;
    }
    let found = data.with_body(|body| {
        let (mut chunk, _) = body.versioned_1(WHAT)?;
        if !chunk.bool(WHAT)? {
            return Ok(None);
        }
        let subd = read::read(&mut chunk)?;
        let counts = [chunk.i32(WHAT)?, chunk.i32(WHAT)?].map(usize::try_from);
        let hashes = [read_hash(&mut chunk)?, read_hash(&mut chunk)?];
        let is_that = counts == [Ok(mesh.faces.len()), Ok(mesh.vertices.len())] && hashes == hashes_of(mesh);
        Ok(is_that.then_some(subd))
    });
    found.ok().flatten()
}
