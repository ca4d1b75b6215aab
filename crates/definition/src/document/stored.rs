use katydid_data::QuadSettings;
use katydid_geometry::{Arc, Box3, Circle, Interval, Line, Plane, Point3, Rectangle, Vector3};
use uuid::Uuid;

use super::on_data::OnData;
use crate::Result;
use crate::archive::{Chunk, Colour, ItemValue, Limits};

/// A value kept in a parameter.
///
/// Numbers are as the file has them, NaN included: whoever hands them to the kernel checks first.
#[derive(Debug, Clone, PartialEq)]
#[non_exhaustive]
pub enum Stored {
    /// Nothing, holding its place.
    Null,
    /// A number.
    Number(f64),
    /// A whole number.
    Integer(i32),
    /// True or false.
    Boolean(bool),
    /// A text.
    Text(String),
    /// A colour.
    Colour(Colour),
    /// A moment, in steps of 100 ns since the start of year 1.
    Time(i64),
    /// An id.
    Guid(Uuid),
    /// A point.
    Point(Point3),
    /// A vector.
    Vector(Vector3),
    /// A plane.
    Plane(Box<Plane>),
    /// A line.
    Line(Box<Line>),
    /// A circle.
    Circle(Box<Circle>),
    /// An arc.
    Arc(Box<Arc>),
    /// A rectangle.
    Rectangle(Box<Rectangle>),
    /// A box.
    Box(Box<Box3>),
    /// A range.
    Domain(Interval),
    /// A range in u and one in v.
    Domain2([Interval; 2]),
    /// A complex number: real and imaginary part.
    Complex([f64; 2]),
    /// The vertex indices of a mesh face; a triangle repeats its third or has −1 as fourth.
    MeshFace([i32; 4]),
    /// A path.
    Path(Vec<i32>),
    /// A display material.
    Material(Box<Material>),
    /// The settings of a loft.
    LoftOptions(Box<LoftOptions>),
    /// The settings of a mesher.
    MeshSettings(Box<MeshSettings>),
    /// The settings of a remesher with quads.
    QuadSettings(Box<QuadSettings>),
    /// Content of a Rhino model by its path, a linetype or layer say; the parameter tells which.
    Content(String),
    /// A curve, surface, brep, mesh or the like.
    Geometry(Box<StoredGeometry>),
    /// An item of a shape that is not known here, as it is.
    Unknown(Box<Chunk>),
}

/// Geometry in the file, or a reference to a Rhino object.
#[derive(Debug, Clone, PartialEq, Default)]
pub struct StoredGeometry {
    /// The Rhino object that it follows; zero when it stands for itself.
    pub ref_id: Uuid,
    /// Which edge of the referenced brep, where a curve is kept; −1 when it is no edge.
    pub edge: Option<i32>,
    /// The kind of reference to a point: `point_object` and the like.
    pub ref_type: Option<String>,
    /// The geometry, as [`OnData`] reads it; absent when only the Rhino model has it.
    pub on_data: Option<Vec<u8>>,
    /// The openNURBS version that newer files put beside the data.
    pub on_version: Option<i32>,
    /// The .NET type, `Grasshopper.Kernel.Types.GH_Brep` say, where the parameter takes several.
    pub type_name: Option<String>,
}

impl StoredGeometry {
    /// Unpacks the geometry; `None` when only the Rhino model has it.
    ///
    /// # Errors
    /// As for [`OnData::read`].
    pub fn decode(&self, limits: &Limits) -> Option<Result<OnData>> {
        self.on_data.as_deref().map(|bytes| OnData::read(bytes, limits))
    }

    /// Whether the geometry is in a Rhino model and not here.
    pub fn is_missing(&self) -> bool {
        self.on_data.is_none() && !self.ref_id.is_nil()
    }
}

/// A display material.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Material {
    /// The colour in plain light.
    pub diffuse: Colour,
    /// The colour of highlights.
    pub specular: Colour,
    /// The colour it sends out by itself.
    pub emission: Colour,
    /// 0 is solid, 1 clear.
    pub transparency: f64,
    /// 0 is dull, 1 polished.
    pub shine: f64,
}

/// The settings of a loft, as numbers of RhinoCommon's enumerations.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct LoftOptions {
    /// Whether the last section is joined to the first.
    pub closed: bool,
    /// Whether seams are adjusted.
    pub adjust: bool,
    /// The kind: 0 normal, 1 loose, 2 tight, 3 straight, 4 developable, 5 uniform.
    pub kind: i32,
    /// How sections are simplified: 0 not, 1 rebuilt, 2 refitted.
    pub simplify: i32,
    /// How the ends are treated.
    pub ends: i32,
    /// Control points when rebuilt.
    pub rebuild: i32,
    /// Tolerance when refitted.
    pub refit: f64,
}

/// The settings of a mesher.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct MeshSettings {
    /// Longest edge; 0 for any.
    pub max_edge: f64,
    /// Shortest edge.
    pub min_edge: f64,
    /// Distance from edge to surface; 0 for any.
    pub tolerance: f64,
    /// Least distance that is refined.
    pub min_tolerance: f64,
    /// Distance relative to size, 0 to 1.
    pub relative_tolerance: f64,
    /// Angle in radians; 0 for any.
    pub refine_angle: f64,
    /// Fewest quads of the first grid.
    pub grid_min: i32,
    /// Most quads of the first grid.
    pub grid_max: i32,
    /// Whether the grid is refined.
    pub refine: bool,
    /// Whether faces meet without joining.
    pub jagged_seams: bool,
    /// Whether planar faces get few triangles.
    pub simple_planes: bool,
}

impl Stored {
    /// Reads an item by its shape: which items it has tells what it is.
    pub fn read(item: &Chunk) -> Self {
        Self::known(item).unwrap_or_else(|| Self::Unknown(Box::new(item.clone())))
    }

    fn known(item: &Chunk) -> Option<Self> {
        if let Some(reference) = item.child("ReferenceData") {
            return Some(Self::Geometry(Box::new(StoredGeometry {
                ref_id: reference.guid("RefID")?,
                ref_type: reference.str("RefType").map(str::to_owned),
                type_name: item.str("TypeName").map(str::to_owned),
                ..StoredGeometry::default()
            })));
        }
        if !item.chunks.is_empty() {
            return None;
        }
        let mut items = item.items.iter().filter(|item| item.name != "TypeName");
        let Some(first) = items.next() else { return Some(Self::Null) };
        // The name of a type beside a path cannot be made anew from it.
        if first.name == "Path" && item.item("TypeName").is_some() {
            return None;
        }
        if items.next().is_none() && first.name != "RefID" {
            return simple(&first.name, &first.value);
        }
        composite(item)
    }

    /// What the value is, in a word.
    pub fn type_name(&self) -> &'static str {
        match self {
            Self::Null => "null",
            Self::Number(_) => "number",
            Self::Integer(_) => "integer",
            Self::Boolean(_) => "boolean",
            Self::Text(_) => "text",
            Self::Colour(_) => "colour",
            Self::Time(_) => "time",
            Self::Guid(_) => "id",
            Self::Point(_) => "point",
            Self::Vector(_) => "vector",
            Self::Plane(_) => "plane",
            Self::Line(_) => "line",
            Self::Circle(_) => "circle",
            Self::Arc(_) => "arc",
            Self::Rectangle(_) => "rectangle",
            Self::Box(_) => "box",
            Self::Domain(_) => "domain",
            Self::Domain2(_) => "domain²",
            Self::Complex(_) => "complex number",
            Self::MeshFace(_) => "mesh face",
            Self::Path(_) => "path",
            Self::Material(_) => "material",
            Self::LoftOptions(_) => "loft options",
            Self::MeshSettings(_) => "mesh settings",
            Self::QuadSettings(_) => "quad settings",
            Self::Content(_) => "model content",
            Self::Geometry(_) => "geometry",
            Self::Unknown(_) => "unknown value",
        }
    }
}

/// A value that is one item.
fn simple(name: &str, value: &ItemValue) -> Option<Stored> {
    Some(match (name, value) {
        ("number", ItemValue::Double(x)) => Stored::Number(*x),
        ("number", ItemValue::Single(x)) => Stored::Number(f64::from(*x)),
        ("number", ItemValue::Int32(n)) => Stored::Integer(*n),
        ("boolean", ItemValue::Bool(b)) => Stored::Boolean(*b),
        ("string", ItemValue::String(text)) => Stored::Text(text.clone()),
        ("null_string", ItemValue::Bool(true)) => Stored::Null,
        ("Path", ItemValue::String(path)) => Stored::Content(path.clone()),
        ("path", ItemValue::String(text)) => Stored::Path(super::parse_path(text)?),
        (_, ItemValue::Colour(colour)) => Stored::Colour(*colour),
        (_, ItemValue::Date(ticks)) => Stored::Time(*ticks),
        (_, ItemValue::Guid(id)) => Stored::Guid(*id),
        ("vector", ItemValue::Point3d(v)) => Stored::Vector((*v).into()),
        (_, ItemValue::Point3d(p)) => Stored::Point((*p).into()),
        (_, ItemValue::Plane(p)) => Stored::Plane(Box::new(plane(**p)?)),
        (_, ItemValue::Line(l)) => {
            let [ax, ay, az, bx, by, bz] = **l;
            Stored::Line(Box::new(Line::new(Point3::new(ax, ay, az), Point3::new(bx, by, bz))))
        }
        (_, ItemValue::Interval1d(i)) => Stored::Domain(interval(*i)),
        (_, ItemValue::Interval2d([au, bu, av, bv])) => {
            Stored::Domain2([Interval::new(*au, *bu), Interval::new(*av, *bv)])
        }
        _ => return None,
    })
}

/// A value of several items.
fn composite(item: &Chunk) -> Option<Stored> {
    if item.bool("null_string") == Some(true) {
        return Some(Stored::Null);
    }
    if let Some(text) = item.str("string") {
        return Some(Stored::Text(text.to_owned()));
    }
    if let Some(frame) = item.plane("Plane") {
        return flat(item, plane(frame)?);
    }
    if let Some(ref_id) = item.guid("RefID") {
        return Some(Stored::Geometry(Box::new(StoredGeometry {
            ref_id,
            edge: item.i32("EdgeIndex"),
            ref_type: None,
            on_data: item.bytes("ON_Data").map(<[u8]>::to_vec),
            on_version: item.i32("ON_Version"),
            type_name: item.str("TypeName").map(str::to_owned),
        })));
    }
    if let [Some(a), Some(b), Some(c), Some(d)] = ["A", "B", "C", "D"].map(|name| item.i32(name)) {
        return Some(Stored::MeshFace([a, b, c, d]));
    }
    if let (Some(re), Some(im)) = (item.f64("real"), item.f64("imaginary")) {
        return Some(Stored::Complex([re, im]));
    }
    if let Some(diffuse) = item.colour("diffuse") {
        return Some(Stored::Material(Box::new(Material {
            diffuse,
            specular: item.colour("specular")?,
            emission: item.colour("emission")?,
            transparency: item.f64("transparency")?,
            shine: item.f64("shine")?,
        })));
    }
    if let Some(kind) = item.i32("LoftType") {
        return Some(Stored::LoftOptions(Box::new(LoftOptions {
            closed: item.bool("Closed")?,
            adjust: item.bool("Adjust")?,
            kind,
            simplify: item.i32("LoftSimp")?,
            ends: item.i32("LoftEnds")?,
            rebuild: item.i32("Rebuild")?,
            refit: item.f64("Refit")?,
        })));
    }
    // Settings that are none are kept as they are.
    if let (Some(count), Some(false)) = (item.i32("tqc"), item.bool("null")) {
        return Some(Stored::QuadSettings(Box::new(QuadSettings {
            count,
            adaptive_size: item.f64("as")?,
            adaptive_count: item.bool("aqc")?,
            hard_edges: item.bool("dhe")?,
            seams: item.i32("pme")?,
            symmetry: item.i32("sa")?,
            guides: item.i32("gci")?,
        })));
    }
    Some(Stored::MeshSettings(Box::new(MeshSettings {
        max_edge: item.f64("MaxEdgeLength")?,
        min_edge: item.f64("MinEdgeLength")?,
        tolerance: item.f64("Tolerance")?,
        min_tolerance: item.f64("MinTolerance")?,
        relative_tolerance: item.f64("RelativeTolerance")?,
        refine_angle: item.f64("RefineAngle")?,
        grid_min: item.i32("GridMinCount")?,
        grid_max: item.i32("GridMaxCount")?,
        refine: item.bool("Refine")?,
        jagged_seams: item.bool("JaggedSeams")?,
        simple_planes: item.bool("SimplePlanes")?,
    })))
}

/// A figure in a plane.
fn flat(item: &Chunk, plane: Plane) -> Option<Stored> {
    let range = |name| item.interval(name).map(interval);
    if let Some(radius) = item.f64("Radius") {
        let circle = Circle { plane, radius };
        // Inferred from the circle: no file with an arc is known.
        let angle = range("Angle").or_else(|| item.f64("Angle").map(|end| Interval::new(0.0, end)));
        return Some(match angle {
            Some(angle) => Stored::Arc(Box::new(Arc { circle, angle })),
            None => Stored::Circle(Box::new(circle)),
        });
    }
    if let Some([ax, bx, ay, by]) = item.interval2d("Size") {
        let (x, y) = (Interval::new(ax, bx), Interval::new(ay, by));
        return Some(Stored::Rectangle(Box::new(Rectangle { plane, x, y })));
    }
    let (x, y) = (range("X")?, range("Y")?);
    Some(match range("Z") {
        Some(z) => Stored::Box(Box::new(Box3 { plane, x, y, z })),
        None => Stored::Rectangle(Box::new(Rectangle { plane, x, y })),
    })
}

fn interval([start, end]: [f64; 2]) -> Interval {
    Interval::new(start, end)
}

/// The plane of an origin and two axes. Axes that are already unit and square stay as they are, so that they
/// are written back to the last bit.
fn plane([ox, oy, oz, xx, xy, xz, yx, yy, yz]: [f64; 9]) -> Option<Plane> {
    const SQUARE: f64 = 1e-9;
    let (origin, x, y) = (Point3::new(ox, oy, oz), Vector3::new(xx, xy, xz), Vector3::new(yx, yy, yz));
    let unit = |v: Vector3| (v.length() - 1.0).abs() < SQUARE;
    if unit(x) && unit(y) && x.dot(y).abs() < SQUARE {
        return Some(Plane { origin, x_axis: x, y_axis: y, z_axis: x.cross(y) });
    }
    Plane::from_axes(origin, x, y).ok()
}
