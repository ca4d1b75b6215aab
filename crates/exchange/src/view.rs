//! Where a drawing is seen from.

use katydid_geometry::{Plane, Point3, Vector3, Xform};

/// A named parallel view. What is seen first is nearest to the eye.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default)]
pub enum View {
    /// From above: x to the right, y up the page.
    #[default]
    Top,
    /// From below: x to the right, y down the page.
    Bottom,
    /// From the front, against y: x to the right, z up the page.
    Front,
    /// From the back: x to the left, z up the page.
    Back,
    /// From the right: y to the right, z up the page.
    Right,
    /// From the left: y to the left, z up the page.
    Left,
    /// From the front right above, all three axes at the same length.
    Isometric,
}

impl View {
    /// All views with their names in lower case.
    pub const NAMES: [(&'static str, Self); 7] = [
        ("top", Self::Top),
        ("bottom", Self::Bottom),
        ("front", Self::Front),
        ("back", Self::Back),
        ("right", Self::Right),
        ("left", Self::Left),
        ("isometric", Self::Isometric),
    ];

    /// The axes of the page: to the right and up.
    fn axes(self) -> [Vector3; 2] {
        let (x, y, z) = (Vector3::X, Vector3::Y, Vector3::Z);
        match self {
            Self::Top => [x, y],
            Self::Bottom => [x, -y],
            Self::Front => [x, z],
            Self::Back => [-x, z],
            Self::Right => [y, z],
            Self::Left => [-y, z],
            Self::Isometric => {
                let (half, sixth) = (0.5_f64.sqrt(), (1.0 / 6.0_f64).sqrt());
                [Vector3::new(half, half, 0.0), Vector3::new(-sixth, sixth, 2.0 * sixth)]
            }
        }
    }

    /// The motion that brings the right of the page to x, its upward direction to y, and the eye to +z.
    pub(crate) fn to_page(self) -> Xform {
        let [x_axis, y_axis] = self.axes();
        let plane = Plane { origin: Point3::ORIGIN, x_axis, y_axis, z_axis: x_axis.cross(y_axis) };
        Xform::world_to_plane(&plane)
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn views_look_where_their_names_say() {
        // (view, a direction that points at the eye)
        let eyes = [
            (View::Top, Vector3::Z),
            (View::Bottom, -Vector3::Z),
            (View::Front, -Vector3::Y),
            (View::Back, Vector3::Y),
            (View::Right, Vector3::X),
            (View::Left, -Vector3::X),
            (View::Isometric, Vector3::new(1.0, -1.0, 1.0) / 3.0_f64.sqrt()),
        ];
        for (view, eye) in eyes {
            let page = view.to_page();
            assert!((page.vector(eye) - Vector3::Z).length() < 1e-12, "{view:?}");
            assert!(page.is_rigid(1e-12), "{view:?}");
        }
    }
}
