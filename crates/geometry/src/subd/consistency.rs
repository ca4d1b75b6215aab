//! What the parts of a net say of each other must agree. Each check gives the first fault in words.

use std::collections::HashSet;

use super::{SubDEdge, SubDFace, SubDNet, SubDSide, SubDVertex};

type Fault = std::result::Result<(), String>;

pub(super) fn check(net: &SubDNet) -> Fault {
    ids("vertex", net.vertices().iter().map(|v| v.id))?;
    ids("edge", net.edges().iter().map(|e| e.id))?;
    ids("face", net.faces().iter().map(|f| f.id))?;
    for (i, edge) in net.edges().iter().enumerate() {
        check_edge(net, i, edge)?;
    }
    for (i, vertex) in net.vertices().iter().enumerate() {
        check_vertex(net, i, vertex)?;
    }
    for (i, face) in net.faces().iter().enumerate() {
        check_face(net, i, face)?;
    }
    Ok(())
}

fn ids(what: &str, ids: impl Iterator<Item = u32>) -> Fault {
    let mut taken = HashSet::new();
    for (i, id) in ids.enumerate() {
        if id == 0 || !taken.insert(id) {
            return Err(format!("{what} {i} has the identifier {id}, which is 0 or taken"));
        }
    }
    Ok(())
}

fn check_edge(net: &SubDNet, i: usize, edge: &SubDEdge) -> Fault {
    let [a, b] = edge.vertices;
    if a == b || a.max(b) >= net.vertices().len() {
        return Err(format!("edge {i} joins vertex {a} to vertex {b}"));
    }
    if !edge.sharpness.iter().chain(&edge.sector_coefficients).all(|x| x.is_finite()) {
        return Err(format!("edge {i} has a sharpness or a sector coefficient that is not finite"));
    }
    for (end, vertex) in edge.vertices.into_iter().enumerate() {
        let here = SubDSide { index: i, reversed: end == 1 };
        if !net.vertices()[vertex].edges.contains(&here) {
            return Err(format!("edge {i} ends at vertex {vertex}, which does not name it"));
        }
    }
    for side in &edge.faces {
        let here = SubDSide { index: i, reversed: side.reversed };
        if !net.faces().get(side.index).is_some_and(|face| face.edges.contains(&here)) {
            return Err(format!("edge {i} bounds face {}, which does not name it", side.index));
        }
    }
    Ok(())
}

fn check_vertex(net: &SubDNet, i: usize, vertex: &SubDVertex) -> Fault {
    if !vertex.point.is_finite() {
        return Err(format!("vertex {i} is not finite"));
    }
    for side in &vertex.edges {
        let ends = net.edges().get(side.index).map(|edge| edge.vertices[usize::from(side.reversed)]);
        if ends != Some(i) {
            return Err(format!("vertex {i} names edge {}, which does not end there", side.index));
        }
    }
    for &face in &vertex.faces {
        if !net.faces().get(face).is_some_and(|f| passes(net, f, i)) {
            return Err(format!("vertex {i} names face {face}, which does not pass through it"));
        }
    }
    Ok(())
}

/// Whether a face passes through a vertex. Its edges may not have been checked.
fn passes(net: &SubDNet, face: &SubDFace, vertex: usize) -> bool {
    face.edges.iter().any(|side| net.edges().get(side.index).is_some_and(|e| e.vertices.contains(&vertex)))
}

fn check_face(net: &SubDNet, i: usize, face: &SubDFace) -> Fault {
    if face.edges.len() < 3 {
        return Err(format!("face {i} has {} edges", face.edges.len()));
    }
    let ends = |side: &SubDSide| {
        let [a, b] = net.edges().get(side.index)?.vertices;
        Some(if side.reversed { [b, a] } else { [a, b] })
    };
    for (k, side) in face.edges.iter().enumerate() {
        let next = &face.edges[(k + 1) % face.edges.len()];
        let (Some([from, to]), Some([then, _])) = (ends(side), ends(next)) else {
            return Err(format!("face {i} names edge {} or {}, which is not there", side.index, next.index));
        };
        if to != then {
            return Err(format!("face {i} goes to vertex {to} and on from vertex {then}"));
        }
        let here = SubDSide { index: i, reversed: side.reversed };
        if !net.edges()[side.index].faces.contains(&here) {
            return Err(format!("face {i} runs through edge {}, which does not name it", side.index));
        }
        if !net.vertices()[from].faces.contains(&i) {
            return Err(format!("face {i} passes through vertex {from}, which does not name it"));
        }
    }
    Ok(())
}
