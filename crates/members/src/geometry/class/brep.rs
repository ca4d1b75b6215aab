//! `Brep`: how it is made, what it is, and changes in place.

use katydid_geometry::brep::Solidity;
use katydid_geometry::{
    Box3, Brep, Cone, Curve, Cylinder, Mesh, Point3, Sphere, Surface, Tolerance, Torus, construct,
};

use super::Named;
use crate::geometry::answer::Outcome;
use crate::geometry::argument::Count;
use crate::geometry::table::Endpoints;

pub(super) fn enter(table: &mut Endpoints) {
    makers(table);
    table.member("Brep.new", || Ok(Brep::merged(&[])));
    table.member("Brep.DuplicateBrep this", |b: Brep| Ok(b));
    table.member("Brep.get_IsSolid this", |b: Brep| Ok(b.is_solid()));
    table.member("Brep.get_IsManifold this", |b: Brep| Ok(b.is_manifold()));
    table.member("Brep.get_IsSurface this", |b: Brep| Ok(b.as_surface().is_some()));
    table.member("Brep.get_SolidOrientation this", |b: Brep| Ok(orientation(&b)));
    table.member("Brep.get_Curves3D this", |b: Brep| edges(&b, 0..b.edges().len()));
    table.member("Brep.get_Surfaces this", |b: Brep| {
        Ok(b.parts().surfaces.iter().flatten().cloned().collect::<Vec<Surface>>())
    });
    table.member("Brep.DuplicateEdgeCurves this", |b: Brep| edges(&b, 0..b.edges().len()));
    table.member("Brep.DuplicateEdgeCurves this nakedOnly", |b: Brep, naked_only: bool| {
        if naked_only { edges(&b, b.naked_edges()) } else { edges(&b, 0..b.edges().len()) }
    });
    table.member("Brep.DuplicateNakedEdgeCurves this nakedOuter nakedInner", naked);
    table.member("Brep.DuplicateVertices this", |b: Brep| {
        Ok(b.vertices().iter().map(|vertex| vertex.point).collect::<Vec<Point3>>())
    });
    table.member("Brep.DuplicateSubBrep this faceIndices", |b: Brep, faces: Vec<Count<0, 10_000_000>>| {
        Ok(b.sub_brep(&faces.iter().map(|face| face.0).collect::<Vec<usize>>())?)
    });
    table.member("Brep.GetConnectedComponents this", |b: Brep| Ok(b.connected_components()?));
    table.member("Brep.Flip &this", |b: Brep| Ok(((), b.flipped())));
    table.member("Brep.Append &this other", |b: Brep, other: Brep| Ok(((), Brep::merged(&[b, other]))));
    table.member("Brep.Compact &this", |b: Brep| Ok(((), b)));
}

fn makers(table: &mut Endpoints) {
    table.member("Brep.CreateFromBox box", |shape: Box3| Ok(construct::box_brep(&shape)?));
    table.member("Brep.CreateFromBox corners", |corners: Vec<Point3>| box_of_corners(&corners));
    table.member("Brep.CreateFromSphere sphere", |sphere: Sphere| Ok(construct::sphere(&sphere)?));
    table.member("Brep.CreateQuadSphere sphere", |sphere: Sphere| Ok(construct::quad_sphere(&sphere)?));
    table.member("Brep.CreateFromTorus torus", |torus: Torus| Ok(construct::torus(&torus)?));
    table.member(
        "Brep.CreateFromCylinder cylinder capBottom capTop",
        |cylinder: Cylinder, bottom: bool, top: bool| Ok(construct::cylinder(&cylinder, [bottom, top])?),
    );
    table.member("Brep.CreateFromCone cone capBottom", |cone: Cone, cap: bool| {
        Ok(construct::cone(&cone, cap)?)
    });
    table.member("Brep.CreateFromSurface surface", |surface: Surface| Ok(Brep::from_surface(surface)?));
    table.member(
        "Brep.CreateFromRevSurface surface capStart capEnd",
        |s: Surface, start: bool, end: bool| {
            let brep = Brep::from_surface(s)?;
            if start || end { Ok(brep.capped(&Tolerance::default())?.0) } else { Ok(brep) }
        },
    );
    table.member("Brep.CreateFromMesh mesh trimmedTriangles", |mesh: Mesh, _: bool| {
        Ok(Brep::from_mesh(&mesh, &Tolerance::default())?)
    });
    table.member("Brep.TryConvertBrep geometry", |brep: Brep| Ok(brep));
}

/// The Brep of eight corners, as `Box` numbers them: four around the bottom, four above them.
fn box_of_corners(corners: &[Point3]) -> Outcome<Brep> {
    let [a, b, c, d, e, f, g, h] = *corners else {
        return Err(crate::Fault::bad_request(format!("corners has {} points, not 8", corners.len())));
    };
    let sides = [[a, d, c, b], [e, f, g, h], [a, b, f, e], [b, c, g, f], [c, d, h, g], [d, a, e, h]];
    let tolerance = Tolerance::default();
    let faces = sides.map(|[p, q, r, s]| construct::four_point_surface(p, q, r, Some(s)));
    let faces = faces.into_iter().collect::<Result<Vec<Brep>, _>>()?;
    let joined = Brep::join(&faces, &tolerance)?.breps.into_iter().next();
    let joined = joined.ok_or_else(|| crate::Fault::failed("the corners bound no box"))?;
    Ok(joined.turned_outward())
}

/// `BrepSolidOrientation`.
fn orientation(brep: &Brep) -> Named {
    let number = match brep.solid_orientation() {
        _ if !brep.is_solid() => 0,
        Solidity::Inward => -1,
        Solidity::Outward | Solidity::Unknown => 1,
    };
    Named("BrepSolidOrientation", number)
}

fn edges(brep: &Brep, places: impl IntoIterator<Item = usize>) -> Outcome<Vec<Curve>> {
    let mut curves = Vec::new();
    for place in places {
        curves.extend(brep.edge_as_curve(place)?);
    }
    Ok(curves)
}

/// The naked edges, of outer loops, of inner ones, or of both.
fn naked(brep: Brep, outer: bool, inner: bool) -> Outcome<Vec<Curve>> {
    use katydid_geometry::brep::LoopKind;
    let wanted = |edge: usize| {
        let trim = brep.edges().get(edge).and_then(|edge| brep.trims().get(*edge.trims.first()?));
        let own = trim.and_then(|trim| brep.loops().get(trim.in_loop?));
        match own.map(|own| own.kind) {
            Some(LoopKind::Inner) => inner,
            _ => outer,
        }
    };
    edges(&brep, brep.naked_edges().into_iter().filter(|edge| wanted(*edge)))
}
