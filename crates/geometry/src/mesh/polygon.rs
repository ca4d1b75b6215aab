use super::MeshFace;

/// A convex polygon, by its corners in order, as a strip of quads, with a triangle at its end where it must be.
pub(crate) fn polygon_faces(ring: &[u32], out: &mut Vec<MeshFace>) {
    let mut rest = ring;
    while let [a, middle @ .., d] = rest {
        match *middle {
            [b] => out.push(MeshFace::Triangle([*a, b, *d])),
            [b, .., c] => out.push(MeshFace::Quad([*a, b, c, *d])),
            [] => {}
        }
        rest = middle;
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn strips() {
        let faces = |n: u32| {
            let mut out = Vec::new();
            polygon_faces(&(0..n).collect::<Vec<_>>(), &mut out);
            out
        };
        assert!(faces(0).is_empty() && faces(1).is_empty() && faces(2).is_empty());
        assert_eq!(faces(3), [MeshFace::Triangle([0, 1, 2])]);
        assert_eq!(faces(4), [MeshFace::Quad([0, 1, 2, 3])]);
        assert_eq!(faces(5), [MeshFace::Quad([0, 1, 3, 4]), MeshFace::Triangle([1, 2, 3])]);
        assert_eq!(faces(6), [MeshFace::Quad([0, 1, 4, 5]), MeshFace::Quad([1, 2, 3, 4])]);
    }
}
