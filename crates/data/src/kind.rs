use std::fmt;

/// The type of a value, and of a port that takes values.
///
/// [`Kind::Generic`] and [`Kind::Geometry`] are types of ports only: they take values of any type, and of any
/// geometric type, unchanged.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash, PartialOrd, Ord)]
#[expect(missing_docs, reason = "the names are Grasshopper's own parameter types")]
pub enum Kind {
    Generic,
    Geometry,
    Boolean,
    Integer,
    Number,
    Complex,
    Text,
    Colour,
    Time,
    Guid,
    Domain,
    Domain2,
    Path,
    Point,
    Vector,
    Plane,
    Line,
    Circle,
    Arc,
    Rectangle,
    Box,
    /// A box with eight free corners.
    TwistedBox,
    Curve,
    Surface,
    Brep,
    Mesh,
    MeshFace,
    SubD,
    PointCloud,
    Transform,
    /// Several transforms, one after the other: a transform that can be taken apart again.
    Compound,
    Matrix,
    Field,
    Location,
    Symbol,
    Material,
    LoftOptions,
    MeshSettings,
    QuadSettings,
    Projection,
    Group,
    /// Geometry of a class that Katydid keeps whole but does not compute with.
    Kept,
    /// What a Rhino model holds: objects with attributes, layers, linetypes, blocks, and filters for them.
    Content,
}

impl Kind {
    /// The name that messages and port lists use.
    pub const fn name(self) -> &'static str {
        match self {
            Self::Generic => "Generic Data",
            Self::Geometry => "Geometry",
            Self::Boolean => "Boolean",
            Self::Integer => "Integer",
            Self::Number => "Number",
            Self::Complex => "Complex",
            Self::Text => "Text",
            Self::Colour => "Colour",
            Self::Time => "Time",
            Self::Guid => "Guid",
            Self::Domain => "Domain",
            Self::Domain2 => "Domain²",
            Self::Path => "Path",
            Self::Point => "Point",
            Self::Vector => "Vector",
            Self::Plane => "Plane",
            Self::Line => "Line",
            Self::Circle => "Circle",
            Self::Arc => "Arc",
            Self::Rectangle => "Rectangle",
            Self::Box => "Box",
            Self::TwistedBox => "Twisted Box",
            Self::Curve => "Curve",
            Self::Surface => "Surface",
            Self::Brep => "Brep",
            Self::Mesh => "Mesh",
            Self::MeshFace => "Mesh face",
            Self::SubD => "SubD",
            Self::PointCloud => "Point Cloud",
            Self::Transform => "Transform",
            Self::Compound => "Transform",
            Self::Matrix => "Matrix",
            Self::Field => "Field",
            Self::Location => "Location",
            Self::Symbol => "Symbol Display",
            Self::Material => "Shader",
            Self::LoftOptions => "Loft Options",
            Self::MeshSettings => "Mesh Settings",
            Self::QuadSettings => "Quad meshing settings",
            Self::Projection => "Projection",
            Self::Group => "Group",
            Self::Kept => "Geometry",
            Self::Content => "Model Content",
        }
    }

    /// Whether values of this type have a place in space.
    pub const fn is_geometry(self) -> bool {
        matches!(
            self,
            Self::Geometry
                | Self::Point
                | Self::Vector
                | Self::Plane
                | Self::Line
                | Self::Circle
                | Self::Arc
                | Self::Rectangle
                | Self::Box
                | Self::TwistedBox
                | Self::Curve
                | Self::Surface
                | Self::Brep
                | Self::Mesh
                | Self::SubD
                | Self::PointCloud
                | Self::Group
                | Self::Kept
        )
    }
}

impl fmt::Display for Kind {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str(self.name())
    }
}
