//! Type hints of a script's inputs: what an input makes of its data before the script sees it, and the identifiers by which
//! files keep that.

use katydid_data::Kind;
use uuid::{Uuid, uuid};

use super::ids;

/// What an input casts its data to.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub struct TypeHint {
    /// The name that scripts and users know.
    pub name: &'static str,
    /// The type of values; none for data as it comes.
    pub kind: Option<Kind>,
    id: Id,
    /// The components that offer it.
    offered: &'static [Family],
}

/// How far an identifier is known.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
enum Id {
    Whole(Uuid),
    /// The first eight digits, from lists of hints; they tell all known ones apart.
    Digits(u32),
}

/// Script components with the same hints.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
enum Family {
    /// GhPython.
    GhPython,
    /// C# and VB of Grasshopper 1.
    DotNet,
    /// C# of Rhino 8.
    CSharp8,
    /// The other script components of Rhino 8.
    Rhino8,
}

use Family::{CSharp8, DotNet, GhPython, Rhino8};

impl Family {
    fn of(component: Uuid) -> Self {
        match component {
            ids::GH_PYTHON => GhPython,
            ids::C_SHARP | ids::VB | ids::OLD_C_SHARP | ids::OLD_VB => DotNet,
            ids::RHINO_8_C_SHARP => CSharp8,
            _ => Rhino8,
        }
    }
}

impl TypeHint {
    /// Data as it comes.
    pub const NONE: Self = HINTS[0];

    /// The hint of an identifier as files keep it; data as it comes for one that is not known.
    pub fn of(id: Option<Uuid>) -> Self {
        let found = id.and_then(|id| HINTS.iter().find(|hint| hint.digits() == id.as_fields().0));
        found.copied().unwrap_or(Self::NONE)
    }

    /// Those that inputs of a script component can have, in the order of its menu.
    pub fn offered_by(component: Uuid) -> impl Iterator<Item = (&'static Self, Uuid)> {
        let family = Family::of(component);
        let offered = HINTS.iter().filter(move |hint| hint.offered.contains(&family));
        offered.filter_map(|hint| Some((hint, hint.whole()?)))
    }

    /// The one that is set on an input, if any component offers it.
    pub fn chosen(id: Option<Uuid>) -> Option<Self> {
        let digits = id?.as_fields().0;
        let known = HINTS.iter().find(|hint| hint.digits() == digits && hint.whole().is_some());
        known.copied()
    }

    /// Whether it is the hint of that name.
    pub fn is(self, name: &str) -> bool {
        self.name == name
    }

    fn whole(&self) -> Option<Uuid> {
        match self.id {
            Id::Whole(id) => Some(id),
            Id::Digits(_) => None,
        }
    }

    fn digits(&self) -> u32 {
        match self.id {
            Id::Whole(id) => id.as_fields().0,
            Id::Digits(digits) => digits,
        }
    }
}

const fn own(name: &'static str, id: Uuid, kind: Option<Kind>, offered: &'static [Family]) -> TypeHint {
    TypeHint { name, kind, id: Id::Whole(id), offered }
}

/// One that all script components offer.
const fn all(name: &'static str, id: Uuid, kind: Option<Kind>) -> TypeHint {
    own(name, id, kind, &[GhPython, DotNet, CSharp8, Rhino8])
}

/// One that files hold and that is not offered here.
const fn read(name: &'static str, digits: u32, kind: Kind) -> TypeHint {
    TypeHint { name, kind: Some(kind), id: Id::Digits(digits), offered: &[] }
}

const TEXT: Option<Kind> = Some(Kind::Text);
const NUMBER: Option<Kind> = Some(Kind::Number);

/// The hints as real files hold them.
const HINTS: [TypeHint; 35] = [
    own("none", uuid!("35915213-5534-4277-81b8-1bdc9e7383d2"), None, &[GhPython]),
    own("ghdoc", uuid!("87f87f55-5b71-41f4-8aea-21d494016f81"), None, &[GhPython]),
    own("object", uuid!("6a184b65-baa3-42d1-a548-3915b401de53"), None, &[DotNet, CSharp8]),
    own("object", uuid!("1c282eeb-dd16-439f-94e4-7d92b542fe8b"), None, &[Rhino8]),
    own("str", uuid!("37261734-eec7-4f50-b6a8-b8d1f3c4396b"), TEXT, &[GhPython]),
    own("str", uuid!("9e93878a-f9c5-4f0a-8a70-584bf09f24bb"), TEXT, &[DotNet]),
    own("str", uuid!("3aceb454-6dbd-4c5b-9b6b-e71f8c1cdf88"), TEXT, &[CSharp8, Rhino8]),
    own("float", uuid!("39fbc626-7a01-46ab-a18e-ec1c0c41685b"), NUMBER, &[GhPython]),
    own("float", uuid!("19ff81a2-dc4f-4035-8de9-26224c561321"), NUMBER, &[DotNet, CSharp8]),
    own("float", uuid!("9d51e32e-c038-4352-9554-f4137ca91b9a"), NUMBER, &[Rhino8]),
    all("int", uuid!("48d01794-d3d8-4aef-990e-127168822244"), Some(Kind::Integer)),
    all("bool", uuid!("d60527f5-b5af-4ef6-8970-5f96fe412559"), Some(Kind::Boolean)),
    all("Point3d", uuid!("e1937b56-b1da-4c12-8bd8-e34ee81746ef"), Some(Kind::Point)),
    all("Vector3d", uuid!("15a50725-e3d3-4075-9f7c-142ba5f40747"), Some(Kind::Vector)),
    all("Plane", uuid!("3897522d-58e9-4d60-b38c-978ddacfedd8"), Some(Kind::Plane)),
    all("Line", uuid!("f802a8cd-e699-4a94-97ea-83b5406271de"), Some(Kind::Line)),
    all("Circle", uuid!("3c5409a1-3293-4181-a6fa-c24c37fc0c32"), Some(Kind::Circle)),
    all("Curve", uuid!("9ba89ec2-5315-435f-a621-b66c5fa2f301"), Some(Kind::Curve)),
    all("Surface", uuid!("f4070a37-c822-410f-9057-100d2e22a22d"), Some(Kind::Surface)),
    all("Brep", uuid!("2ceb0405-fdfe-403d-a4d6-8786da45fb9d"), Some(Kind::Brep)),
    all("Mesh", uuid!("794a1f9d-21d5-4379-b987-9e8bbf433912"), Some(Kind::Mesh)),
    all("PointCloud", uuid!("d73c9fb0-365d-458f-9fb5-f4141399311f"), None),
    all("GeometryBase", uuid!("c37956f4-d39c-49c7-af71-1e87f8031b26"), Some(Kind::Geometry)),
    all("Color", uuid!("24b1d1a3-ab79-498c-9e44-c5b14607c4d3"), Some(Kind::Colour)),
    all("Guid", uuid!("5325b8e1-51d7-4d36-837a-d98394626c35"), Some(Kind::Guid)),
    read("str", 0xd969_c421, Kind::Text),
    read("Interval", 0x5897_48aa, Kind::Domain),
    read("UVInterval", 0x74c9_06f3, Kind::Domain2),
    read("Arc", 0x9c80_ec18, Kind::Arc),
    read("Polyline", 0x66fa_617b, Kind::Curve),
    read("Rectangle3d", 0x83da_014b, Kind::Rectangle),
    read("Box", 0xf29c_b021, Kind::Box),
    read("Transform", 0xc4b3_8e4c, Kind::Transform),
    read("Complex", 0x3096_90df, Kind::Complex),
    read("DateTime", 0x09bc_f900, Kind::Time),
];

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn identifiers_of_files_are_known() {
        let id = |text: &str| Some(Uuid::parse_str(text).unwrap_or_default());
        let named = |text: &str| TypeHint::of(id(text)).name;
        assert_eq!(named("87f87f55-5b71-41f4-8aea-21d494016f81"), "ghdoc");
        assert_eq!(named("589748aa-0000-0000-0000-000000000000"), "Interval");
        assert_eq!(named("00000000-0000-0000-0000-000000000001"), "none");
        assert_eq!(TypeHint::of(None), TypeHint::NONE);
    }

    #[test]
    fn no_two_share_their_first_digits() {
        let mut digits: Vec<u32> = HINTS.iter().map(TypeHint::digits).collect();
        digits.sort_unstable();
        digits.dedup();
        assert_eq!(digits.len(), HINTS.len());
    }

    #[test]
    fn a_component_offers_each_name_once() {
        for component in [ids::GH_PYTHON, ids::C_SHARP, ids::RHINO_8_C_SHARP, ids::RHINO_8_PYTHON] {
            let mut names: Vec<&str> = TypeHint::offered_by(component).map(|(hint, _)| hint.name).collect();
            let count = names.len();
            names.sort_unstable();
            names.dedup();
            assert_eq!(names.len(), count);
            assert!(names.contains(&"str") && names.contains(&"float") && names.contains(&"Guid"));
        }
    }
}
