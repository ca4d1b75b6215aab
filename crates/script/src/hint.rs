//! Type hints: what a script's input makes of its data before the script sees it.

use katydid_data::Kind;
use uuid::Uuid;

/// What an input casts its data to.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(crate) struct Hint {
    /// The name that scripts and users know.
    pub(crate) name: &'static str,
    /// The type of values; none for data as it comes.
    pub(crate) kind: Option<Kind>,
}

impl Hint {
    /// The hint of an identifier as files keep it: by its first eight digits, which tell all known ones apart. A hint that
    /// is not known casts nothing.
    pub(crate) fn of(id: Option<Uuid>) -> Self {
        let Some(id) = id else { return NONE };
        let digits = id.as_fields().0;
        HINTS.iter().find(|(own, _)| *own == digits).map_or(NONE, |(_, hint)| *hint)
    }

    /// Whether it is the hint of that name.
    pub(crate) fn is(self, name: &str) -> bool {
        self.name == name
    }
}

const fn hint(name: &'static str, kind: Kind) -> Hint {
    Hint { name, kind: Some(kind) }
}

const fn open(name: &'static str) -> Hint {
    Hint { name, kind: None }
}

const NONE: Hint = open("none");

/// The identifiers as real files hold them, by their first eight digits.
const HINTS: [(u32, Hint); 34] = [
    (0x3591_5213, open("none")),
    (0x87f8_7f55, open("ghdoc")),
    (0x6a18_4b65, open("object")),
    (0x1c28_2eeb, open("object")),
    (0xc379_56f4, hint("GeometryBase", Kind::Geometry)),
    (0x3726_1734, hint("str", Kind::Text)),
    (0x3ace_b454, hint("str", Kind::Text)),
    (0xd969_c421, hint("str", Kind::Text)),
    (0x9e93_878a, hint("str", Kind::Text)),
    (0x39fb_c626, hint("float", Kind::Number)),
    (0x19ff_81a2, hint("float", Kind::Number)),
    (0x9d51_e32e, hint("float", Kind::Number)),
    (0x48d0_1794, hint("int", Kind::Integer)),
    (0xd605_27f5, hint("bool", Kind::Boolean)),
    (0xe193_7b56, hint("Point3d", Kind::Point)),
    (0x15a5_0725, hint("Vector3d", Kind::Vector)),
    (0x3897_522d, hint("Plane", Kind::Plane)),
    (0x5897_48aa, hint("Interval", Kind::Domain)),
    (0x74c9_06f3, hint("UVInterval", Kind::Domain2)),
    (0xf802_a8cd, hint("Line", Kind::Line)),
    (0x3c54_09a1, hint("Circle", Kind::Circle)),
    (0x9c80_ec18, hint("Arc", Kind::Arc)),
    (0x66fa_617b, hint("Polyline", Kind::Curve)),
    (0x83da_014b, hint("Rectangle3d", Kind::Rectangle)),
    (0xf29c_b021, hint("Box", Kind::Box)),
    (0x9ba8_9ec2, hint("Curve", Kind::Curve)),
    (0xf407_0a37, hint("Surface", Kind::Surface)),
    (0x2ceb_0405, hint("Brep", Kind::Brep)),
    (0x794a_1f9d, hint("Mesh", Kind::Mesh)),
    (0xc4b3_8e4c, hint("Transform", Kind::Transform)),
    (0x24b1_d1a3, hint("Color", Kind::Colour)),
    (0x5325_b8e1, hint("Guid", Kind::Guid)),
    (0x3096_90df, hint("Complex", Kind::Complex)),
    (0x09bc_f900, hint("DateTime", Kind::Time)),
];

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn identifiers_of_files_are_known() {
        let id = |text: &str| Some(Uuid::parse_str(text).unwrap_or_default());
        assert_eq!(Hint::of(id("87f87f55-5b71-41f4-8aea-21d494016f81")), open("ghdoc"));
        assert_eq!(Hint::of(id("00000000-0000-0000-0000-000000000001")), NONE);
        assert_eq!(Hint::of(None), NONE);
    }
}
