use katydid_geometry::{Interval, Plane};

use super::persistent::format_path;
use super::stored::{Stored, StoredGeometry};
use crate::archive::{Chunk, Item, ItemValue};

impl Stored {
    /// The item chunk as Grasshopper writes it. An unknown value goes back as it came.
    pub fn to_chunk(&self, name: &str, index: i32, type_name: bool) -> Chunk {
        let mut chunk = match self {
            Self::Unknown(chunk) => (**chunk).clone(),
            _ => Chunk { items: self.items(), ..Chunk::default() },
        };
        if let Self::Geometry(geometry) = self
            && let Some(ref_type) = &geometry.ref_type
        {
            chunk = reference(geometry, ref_type);
        }
        chunk.name = name.to_owned();
        chunk.index = Some(index);
        if type_name && let Some(type_name) = self.dot_net_type() {
            chunk.set("TypeName", type_name);
        }
        chunk
    }

    fn items(&self) -> Vec<Item> {
        match self {
            Self::Null | Self::Unknown(_) => Vec::new(),
            Self::Number(x) => vec![Item::new("number", *x)],
            Self::Integer(n) => vec![Item::new("number", *n)],
            Self::Boolean(b) => vec![Item::new("boolean", *b)],
            Self::Text(text) => vec![Item::new("null_string", false), Item::new("string", text.as_str())],
            Self::Colour(colour) => vec![Item::new("color", *colour)],
            Self::Time(ticks) => vec![Item::new("datetime", ItemValue::Date(*ticks))],
            Self::Guid(id) => vec![Item::new("guid", *id)],
            Self::Point(p) => vec![Item::new("Coordinate", ItemValue::Point3d((*p).into()))],
            Self::Vector(v) => vec![Item::new("vector", ItemValue::Point3d((*v).into()))],
            Self::Plane(p) => vec![Item::new("plane", plane(p))],
            Self::Line(l) => {
                let ([ax, ay, az], [bx, by, bz]) = (l.from.into(), l.to.into());
                vec![Item::new("Line", ItemValue::Line(Box::new([ax, ay, az, bx, by, bz])))]
            }
            Self::Circle(c) => vec![Item::new("Plane", plane(&c.plane)), Item::new("Radius", c.radius)],
            Self::Arc(a) => vec![
                Item::new("Angle", interval(a.angle)),
                Item::new("Plane", plane(&a.circle.plane)),
                Item::new("Radius", a.circle.radius),
            ],
            Self::Rectangle(r) => {
                let size = ItemValue::Interval2d([r.x.start, r.x.end, r.y.start, r.y.end]);
                vec![Item::new("Plane", plane(&r.plane)), Item::new("Size", size)]
            }
            Self::Box(b) => vec![
                Item::new("Plane", plane(&b.plane)),
                Item::new("RefID", uuid::Uuid::nil()),
                Item::new("X", interval(b.x)),
                Item::new("Y", interval(b.y)),
                Item::new("Z", interval(b.z)),
            ],
            Self::Domain(i) => vec![Item::new("Interval", interval(*i))],
            Self::Domain2([u, v]) => {
                vec![Item::new("Interval", ItemValue::Interval2d([u.start, u.end, v.start, v.end]))]
            }
            Self::Complex([re, im]) => vec![Item::new("imaginary", *im), Item::new("real", *re)],
            Self::MeshFace(corners) => {
                ["A", "B", "C", "D"].into_iter().zip(corners).map(|(n, i)| Item::new(n, *i)).collect()
            }
            Self::Path(path) => vec![Item::new("path", format_path(path))],
            Self::Material(m) => vec![
                Item::new("diffuse", m.diffuse),
                Item::new("emission", m.emission),
                Item::new("shine", m.shine),
                Item::new("specular", m.specular),
                Item::new("transparency", m.transparency),
            ],
            Self::LoftOptions(o) => vec![
                Item::new("Adjust", o.adjust),
                Item::new("Closed", o.closed),
                Item::new("LoftEnds", o.ends),
                Item::new("LoftSimp", o.simplify),
                Item::new("LoftType", o.kind),
                Item::new("Rebuild", o.rebuild),
                Item::new("Refit", o.refit),
            ],
            Self::MeshSettings(m) => vec![
                Item::new("GridMaxCount", m.grid_max),
                Item::new("GridMinCount", m.grid_min),
                Item::new("JaggedSeams", m.jagged_seams),
                Item::new("MaxEdgeLength", m.max_edge),
                Item::new("MinEdgeLength", m.min_edge),
                Item::new("MinTolerance", m.min_tolerance),
                Item::new("Refine", m.refine),
                Item::new("RefineAngle", m.refine_angle),
                Item::new("RelativeTolerance", m.relative_tolerance),
                Item::new("SimplePlanes", m.simple_planes),
                Item::new("Tolerance", m.tolerance),
            ],
            Self::QuadSettings(q) => vec![
                Item::new("aqc", q.adaptive_count),
                Item::new("as", q.adaptive_size),
                Item::new("dhe", q.hard_edges),
                Item::new("gci", q.guides),
                Item::new("null", false),
                Item::new("pme", q.seams),
                Item::new("sa", q.symmetry),
                Item::new("tqc", q.count),
            ],
            Self::Content(path) => vec![Item::new("Path", path.as_str())],
            Self::Geometry(geometry) => geometry_items(geometry),
        }
    }

    /// The .NET type that Grasshopper gives the value; `None` where the value has none or brings its own.
    fn dot_net_type(&self) -> Option<String> {
        let kind = match self {
            Self::Null
            | Self::Unknown(_)
            | Self::Content(_)
            | Self::MeshSettings(_)
            | Self::QuadSettings(_)
            | Self::LoftOptions(_) => return None,
            Self::Geometry(geometry) => return geometry.type_name.clone(),
            Self::Number(_) => "GH_Number",
            Self::Integer(_) => "GH_Integer",
            Self::Boolean(_) => "GH_Boolean",
            Self::Text(_) => "GH_String",
            Self::Colour(_) => "GH_Colour",
            Self::Time(_) => "GH_Time",
            Self::Guid(_) => "GH_Guid",
            Self::Point(_) => "GH_Point",
            Self::Vector(_) => "GH_Vector",
            Self::Plane(_) => "GH_Plane",
            Self::Line(_) => "GH_Line",
            Self::Circle(_) => "GH_Circle",
            Self::Arc(_) => "GH_Arc",
            Self::Rectangle(_) => "GH_Rectangle",
            Self::Box(_) => "GH_Box",
            Self::Domain(_) => "GH_Interval",
            Self::Domain2(_) => "GH_Interval2D",
            Self::Complex(_) => "GH_ComplexNumber",
            Self::MeshFace(_) => "GH_MeshFace",
            Self::Path(_) => "GH_StructurePath",
            Self::Material(_) => "GH_Material",
        };
        Some(format!("Grasshopper.Kernel.Types.{kind}"))
    }
}

fn plane(p: &Plane) -> ItemValue {
    let ([ox, oy, oz], [xx, xy, xz], [yx, yy, yz]) = (p.origin.into(), p.x_axis.into(), p.y_axis.into());
    ItemValue::Plane(Box::new([ox, oy, oz, xx, xy, xz, yx, yy, yz]))
}

fn interval(i: Interval) -> ItemValue {
    ItemValue::Interval1d([i.start, i.end])
}

fn geometry_items(geometry: &StoredGeometry) -> Vec<Item> {
    let mut items = Vec::new();
    if let Some(edge) = geometry.edge {
        items.push(Item::new("EdgeIndex", edge));
    }
    if let Some(data) = &geometry.on_data {
        items.push(Item::new("ON_Data", ItemValue::ByteArray(data.clone())));
    }
    if let Some(version) = geometry.on_version {
        items.push(Item::new("ON_Version", version));
    }
    items.push(Item::new("RefID", geometry.ref_id));
    if let Some(name) = &geometry.type_name {
        items.push(Item::new("TypeName", name.as_str()));
    }
    items
}

/// A point that follows a Rhino object.
fn reference(geometry: &StoredGeometry, ref_type: &str) -> Chunk {
    let mut data = Chunk::new("ReferenceData");
    data.items = vec![
        Item::new("RefID", geometry.ref_id),
        Item::new("RefIndex", -1),
        Item::indexed("RefParam", 0, 0.0),
        Item::indexed("RefParam", 1, 0.0),
        Item::new("RefType", ref_type),
    ];
    Chunk { chunks: vec![data], ..Chunk::default() }
}
