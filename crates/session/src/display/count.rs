//! How many triangles there are, and how many each object may have.

use katydid_geometry::Mesh;
use katydid_scene::{Form, Scene};

/// No object has more triangles on a screen: what has is drawn with fewer.
pub(super) const MOST: usize = 4_000_000;

/// The triangles of a mesh.
pub(super) fn of_mesh(mesh: &Mesh) -> usize {
    mesh.faces().iter().map(|face| face.indices().len().saturating_sub(2)).sum()
}

/// The triangles of a thing as it comes.
pub(super) fn of_form(form: &Form) -> usize {
    match form {
        Form::Mesh(mesh) => of_mesh(mesh),
        Form::Surface(facets) => of_mesh(&facets.mesh),
        Form::Dot(..) => super::faces::DOT_TRIANGLES,
        Form::Tile(..) => 2,
        _ => 0,
    }
}

/// The triangles of a scene as it comes.
pub(super) fn triangles(scene: &Scene) -> usize {
    scene.things.iter().map(|thing| of_form(&thing.form)).sum()
}

/// The curves of a scene.
pub(super) fn curves(scene: &Scene) -> usize {
    scene.things.iter().filter(|thing| matches!(thing.form, Form::Curve(_))).count()
}

/// Shares out a number of triangles: who needs less than an even share keeps all, the others share what is left.
pub(super) fn shares(counts: &[usize], all: usize) -> Vec<usize> {
    let mut order: Vec<usize> = (0..counts.len()).collect();
    order.sort_by_key(|&k| counts.get(k).copied());
    let mut shares = vec![0; counts.len()];
    let mut left = all;
    for (served, &k) in order.iter().enumerate() {
        let even = left / (counts.len() - served);
        let share = counts.get(k).copied().unwrap_or(0).min(even);
        left -= share;
        if let Some(slot) = shares.get_mut(k) {
            *slot = share;
        }
    }
    shares
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_small_keep_all_and_the_large_share_the_rest() {
        assert_eq!(shares(&[10, 1000, 20, 2000], 530), [10, 250, 20, 250]);
        assert_eq!(shares(&[5, 5], 100), [5, 5]);
        assert_eq!(shares(&[], 100), [0_usize; 0]);
        let many = shares(&[12; 10_000], 50_000);
        assert!(many.iter().sum::<usize>() <= 50_000 && many.iter().all(|&share| share == 5));
    }
}
