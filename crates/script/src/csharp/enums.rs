//! Enumerations of RhinoCommon: those that Python's scripts have, from the same list, and some more.

use std::fmt::Write as _;
use std::sync::LazyLock;

/// The list, in Python.
const SOURCE: &str = include_str!("../../../../python/katydid/values/enums.py");

/// What that list has not.
const MORE: [(&str, &[(&str, i64)]); 7] = [
    ("BlendType", &[("Chamfer", 0), ("Fillet", 1), ("Blend", 2)]),
    ("RailType", &[("DistanceFromEdge", 0), ("RollingBall", 1), ("DistanceBetweenRails", 2)]),
    ("NurbsCurveEndConditionType", &[("Nothing", 0), ("Position", 1), ("Tangency", 2), ("Curvature", 3)]),
    ("SweepMiter", &[("None", 0), ("Trimmed", 1), ("Untrimmed", 2)]),
    ("SweepFrame", &[("Freeform", 0), ("Roadlike", 1)]),
    ("SmoothingCoordinateSystem", &[("World", 0), ("CPlane", 1), ("Object", 2)]),
    ("PointFaceRelation", &[("Exterior", 0), ("Interior", 1), ("Boundary", 2)]),
];

type Enumeration = (String, Vec<(String, i64)>);

static ALL: LazyLock<Vec<Enumeration>> = LazyLock::new(|| {
    let named = |name: &str| name.trim_matches(|c: char| !(c.is_ascii_alphanumeric() || c == '_')).to_owned();
    let mut all: Vec<Enumeration> = Vec::new();
    for call in SOURCE.split("= make(").skip(1) {
        let Some((inside, _)) = call.split_once(')') else { continue };
        let mut parts = inside.split(',');
        let name = named(parts.next().unwrap_or_default());
        let members = parts.filter_map(|part| {
            let (name, number) = part.rsplit_once(['=', ':'])?;
            Some((named(name), number.trim().trim_end_matches('}').parse().ok()?))
        });
        if MORE.iter().all(|(more, _)| *more != name) {
            all.push((name, members.collect()));
        }
    }
    for (name, members) in MORE {
        all.push((name.to_owned(), members.iter().map(|(name, x)| ((*name).to_owned(), *x)).collect()));
    }
    all
});

/// The namespace of an enumeration.
fn namespace(name: &str) -> &'static str {
    match name {
        "ObjectType" => "Rhino.DocObjects",
        "UnitSystem" => "Rhino",
        _ => "Rhino.Geometry",
    }
}

/// Whether there is an enumeration of that name in Rhino.Geometry.
pub(super) fn has(name: &str) -> bool {
    namespace(name) == "Rhino.Geometry" && ALL.iter().any(|(own, _)| own == name)
}

/// The number of a member.
pub(super) fn number(name: &str, member: &str) -> Option<i32> {
    let (_, members) = ALL.iter().find(|(own, _)| own == name)?;
    let (_, number) = members.iter().find(|(own, _)| own == member)?;
    i32::try_from(*number).ok()
}

/// Writes their declarations.
pub(super) fn write(text: &mut String) {
    for (name, members) in ALL.iter() {
        let members: Vec<String> = members.iter().map(|(name, x)| format!("{name} = {x}")).collect();
        let _ = writeln!(
            text,
            "namespace {} {{ public enum {name} {{ {} }} }}",
            namespace(name),
            members.join(", ")
        );
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_numbers_are_those_of_rhino_common() {
        let mut text = String::new();
        write(&mut text);
        for line in [
            "namespace Rhino.Geometry { public enum CurveOrientation { Undefined = 0, Clockwise = -1, CounterClockwise = 1 } }",
            "namespace Rhino.Geometry { public enum PointContainment { Unset = 0, Inside = 1, Outside = 2, Coincident = 3 } }",
            "namespace Rhino.Geometry { public enum PipeCapMode { None = 0, Flat = 1, Round = 2 } }",
        ] {
            assert!(text.contains(line), "{line}\n{text}");
        }
        assert!(text.contains("public enum ObjectType { None = 0, Point = 1, PointSet = 2, Curve = 4"));
        assert!(has("LoftType") && !has("ObjectType") && ALL.len() > 25);
    }
}
