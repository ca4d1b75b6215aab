//! Layers under layers.

/// Layers nest no deeper than this; what lies deeper lies at the top.
const DEEPEST: usize = 256;

/// The parents of layers, such that every layer comes to the top in a few steps: one that lies under itself, or under a
/// layer that is not there, lies at the top.
pub(crate) fn rooted(parents: &[Option<usize>]) -> Vec<Option<usize>> {
    let is_rooted = |layer: usize| {
        let mut next = Some(layer);
        for _ in 0..DEEPEST {
            match next.map(|at| parents.get(at)) {
                Some(Some(parent)) => next = *parent,
                Some(None) => return false,
                None => return true,
            }
        }
        false
    };
    let parent = |(layer, parent): (usize, &Option<usize>)| parent.filter(|_| is_rooted(layer));
    parents.iter().enumerate().map(parent).collect()
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn circles_are_cut() {
        assert_eq!(rooted(&[None, Some(0), Some(1)]), [None, Some(0), Some(1)]);
        assert_eq!(rooted(&[Some(1), Some(0), Some(0), Some(3), Some(9)]), [None; 5]);
        let chain: Vec<Option<usize>> = (0..400_usize).map(|i| i.checked_sub(1)).collect();
        assert_eq!(rooted(&chain).iter().filter(|parent| parent.is_none()).count(), 400 - 254);
    }
}
