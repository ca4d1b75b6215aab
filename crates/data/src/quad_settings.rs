/// How a mesh is made anew of quads.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct QuadSettings {
    /// How many quads are wanted.
    pub count: i32,
    /// How much smaller quads are where the shape curves: 0 not at all, 100 the most.
    pub adaptive_size: f64,
    /// Whether there may be more quads where the shape curves.
    pub adaptive_count: bool,
    /// Whether sharp edges are kept.
    pub hard_edges: bool,
    /// Which edges between faces of the input are kept: 0 none, 1 those that matter, 2 all.
    pub seams: i32,
    /// The planes of symmetry: 1 for x, 2 for y, 4 for z, added together.
    pub symmetry: i32,
    /// What guide curves do: 0 they lead the quads about, 1 a ring of edges crosses them, 2 a loop of edges runs along.
    pub guides: i32,
}

impl Default for QuadSettings {
    /// Those of a remesher nobody has told anything.
    fn default() -> Self {
        Self {
            count: 2000,
            adaptive_size: 50.0,
            adaptive_count: true,
            hard_edges: true,
            seams: 0,
            symmetry: 0,
            guides: 0,
        }
    }
}
