use katydid_geometry::{Plane, Point3};

/// A view for drawings: a picture plane, and from where it is seen.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Projection {
    /// The picture plane. Its axes become those of the drawing.
    pub plane: Plane,
    /// The camera of a perspective; none for a parallel view, which looks against the plane's normal.
    pub camera: Option<Point3>,
}

impl Default for Projection {
    /// The parallel view from above.
    fn default() -> Self {
        Self { plane: Plane::XY, camera: None }
    }
}

impl Projection {
    /// What it is called where it is shown as text.
    pub fn name(&self) -> &'static str {
        if self.camera.is_some() { "Perspective Projection" } else { "Parallel Projection" }
    }
}
