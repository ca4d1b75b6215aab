/// How finely surfaces become meshes. A limit of 0 is off.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct MeshSettings {
    /// The longest edge.
    pub max_edge: f64,
    /// The shortest edge.
    pub min_edge: f64,
    /// The greatest distance between edge and surface.
    pub tolerance: f64,
    /// The least distance that is refined.
    pub min_tolerance: f64,
    /// The greatest distance by the size of the shape, from 0, off and coarse, to 1, fine.
    pub relative_tolerance: f64,
    /// The greatest turn from one edge to the next, in radians.
    pub refine_angle: f64,
    /// The longest side of a quad over its shortest.
    pub aspect: f64,
    /// The fewest quads of the first grid.
    pub grid_min: i32,
    /// The most quads of the first grid.
    pub grid_max: i32,
    /// Whether the first grid is refined.
    pub refine: bool,
    /// Whether faces meet without joining.
    pub jagged_seams: bool,
    /// Whether plane faces get as few polygons as they can.
    pub simple_planes: bool,
}

impl MeshSettings {
    /// Few polygons, soon there.
    pub const SPEED: Self = Self {
        max_edge: 0.0,
        min_edge: 0.0001,
        tolerance: 0.0,
        min_tolerance: 0.0,
        relative_tolerance: 0.65,
        refine_angle: 0.0,
        aspect: 0.0,
        grid_min: 16,
        grid_max: 0,
        refine: true,
        jagged_seams: false,
        simple_planes: true,
    };

    /// Smooth to look at.
    pub const QUALITY: Self =
        Self { relative_tolerance: 0.8, refine_angle: std::f64::consts::PI / 9.0, ..Self::SPEED };
}

impl Default for MeshSettings {
    fn default() -> Self {
        Self::SPEED
    }
}
