//! The classes of Rhino.Geometry as C# declarations, made from the signatures of the member table: there is no second list.

use std::collections::{BTreeMap, BTreeSet};
use std::fmt::Write as _;

/// What each text below begins with.
const USING: &str = "using System;\nusing System.Collections;\nusing System.Collections.Generic;\n";
/// Structs, written out with their formulas.
const VALUES: &str = include_str!("values.cs");
/// Types of Grasshopper.
const GRASSHOPPER: &str = include_str!("grasshopper.cs");

/// Types that stand in the texts, as the table names them, with how C# writes them.
const KNOWN: [(&str, &str); 15] = [
    ("Double", "double"),
    ("Boolean", "bool"),
    ("Int32", "int"),
    ("String", "string"),
    ("Void", "void"),
    ("Object", "object"),
    ("Point3d", "Point3d"),
    ("Point2d", "Point2d"),
    ("Vector3d", "Vector3d"),
    ("Plane", "Plane"),
    ("Interval", "Interval"),
    ("Line", "Line"),
    ("BoundingBox", "BoundingBox"),
    ("Circle", "Circle"),
    ("Polyline", "Polyline"),
];

/// Enumerations of RhinoCommon with their members, in the order of their numbers from 0.
const ENUMS: [(&str, &str); 7] = [
    ("BlendContinuity", "Position, Tangency, Curvature"),
    ("CurveEnd", "None, Start, End, Both"),
    ("CurveExtensionStyle", "Line, Arc, Smooth"),
    (
        "CurveKnotStyle",
        "Uniform, Chord, ChordSquareRoot, UniformPeriodic, ChordPeriodic, ChordSquareRootPeriodic",
    ),
    ("CurveOffsetCornerStyle", "None, Sharp, Round, Smooth, Chamfer"),
    ("LoftType", "Normal, Loose, Tight, Straight, Developable, Uniform"),
    ("PipeCapMode", "None, Flat, Round"),
];

/// The class that a class inherits from, as the table has it too.
fn base(class: &str) -> Option<&'static str> {
    Some(match class {
        "LineCurve" | "ArcCurve" | "PolylineCurve" | "NurbsCurve" | "PolyCurve" | "BrepEdge" => "Curve",
        "PlaneSurface" | "NurbsSurface" | "RevSurface" | "SumSurface" | "Extrusion" | "BrepFace" => "Surface",
        "Curve" | "Surface" | "Brep" | "Mesh" | "SubD" | "Point" | "Hatch" => "GeometryBase",
        _ => return None,
    })
}

/// A member of the table, taken apart.
struct Member<'a> {
    class: &'a str,
    name: &'a str,
    is_static: bool,
    parameters: Vec<(&'a str, &'a str)>,
    gives: Vec<&'a str>,
}

impl<'a> Member<'a> {
    /// `Class.Member(this Type, Type name) -> Type, Type`.
    fn of(signature: &'a str) -> Option<Self> {
        let (head, gives) = signature.split_once(" -> ")?;
        let (name, parameters) = head.strip_suffix(')')?.split_once('(')?;
        let (class, name) = name.split_once('.')?;
        let (is_static, parameters) = match parameters.strip_prefix("this ") {
            Some(rest) => (false, rest.split_once(", ").map_or("", |(_, rest)| rest)),
            None => (true, parameters),
        };
        let parameters = parameters.split(", ").filter(|text| !text.is_empty());
        let parameters = parameters.map(|text| text.split_once(' ')).collect::<Option<_>>()?;
        Some(Self { class, name, is_static, parameters, gives: gives.split(", ").collect() })
    }
}

/// The declarations of all that a script may use beside the library.
pub(super) fn declarations(signatures: &[String]) -> String {
    let members: Vec<Member<'_>> = signatures.iter().filter_map(|text| Member::of(text)).collect();
    let mut classes: BTreeMap<&str, Vec<&Member<'_>>> = BTreeMap::from([("GeometryBase", Vec::new())]);
    for member in &members {
        classes.entry(member.class).or_default().push(member);
    }
    let names: BTreeSet<&str> = classes.keys().copied().collect();
    let mut text = format!("{USING}{VALUES}{GRASSHOPPER}namespace Rhino.Geometry.Intersect {{ }}\n");
    text.push_str("namespace Rhino.Geometry {\n");
    for (name, list) in ENUMS {
        let _ = writeln!(text, "public enum {name} {{ {list} }}");
    }
    for (class, members) in &classes {
        // What belongs to intersections has a namespace of its own, behind this one.
        if !is_of_intersections(class) {
            write_class(&mut text, class, members, &names);
        }
    }
    text.push_str("}\nnamespace Rhino.Geometry.Intersect {\n");
    for (class, members) in classes.iter().filter(|(class, _)| is_of_intersections(class)) {
        write_class(&mut text, class, members, &names);
    }
    text.push_str("}\n");
    text
}

/// Whether a class stands in `Rhino.Geometry.Intersect`.
pub(super) fn is_of_intersections(class: &str) -> bool {
    matches!(class, "Intersection" | "IntersectionEvent" | "MeshClash")
}

fn write_class(text: &mut String, class: &str, members: &[&Member<'_>], names: &BTreeSet<&str>) {
    let before = base(class).map_or(String::new(), |base| format!(" : {base}"));
    let _ = writeln!(text, "[Native] public class {class}{before} {{");
    let mut written = BTreeSet::new();
    for member in members {
        let line = if member.name.starts_with("get_") || member.name.starts_with("set_") {
            property(member, members, names)
        } else {
            method(member, names)
        };
        // Overloads whose types C# cannot tell apart are one.
        if let Some((key, line)) = line
            && written.insert(key)
        {
            let _ = writeln!(text, "  {line}");
        }
    }
    text.push_str("}\n");
}

/// A type as C# writes it; none for one that is not declared.
fn written(name: &str, is_parameter: bool, names: &BTreeSet<&str>) -> Option<String> {
    if let Some(element) = name.strip_suffix("[]") {
        let element = written(element, is_parameter, names)?;
        // Arrays and lists both are given where a sequence is asked for.
        return Some(if is_parameter { format!("IEnumerable<{element}>") } else { format!("{element}[]") });
    }
    if let Some((_, known)) = KNOWN.iter().find(|(own, _)| *own == name) {
        return Some((*known).to_owned());
    }
    let is_enum = ENUMS.iter().any(|(own, _)| *own == name);
    (is_enum || names.contains(name)).then(|| match name {
        name if is_of_intersections(name) => format!("Rhino.Geometry.Intersect.{name}"),
        name => name.to_owned(),
    })
}

fn property(member: &Member<'_>, all: &[&Member<'_>], names: &BTreeSet<&str>) -> Option<(String, String)> {
    let name = member.name.get(4..)?;
    let has = |start: &str, count: usize| {
        all.iter().any(|m| m.name == format!("{start}{name}") && m.parameters.len() == count)
    };
    if name == "Item" || member.is_static {
        return None;
    }
    let kind = match (member.name.starts_with("get_"), member.parameters.as_slice(), member.gives.as_slice())
    {
        (true, [], [kind]) | (false, [(kind, _)], _) => written(kind, false, names)?,
        _ => return None,
    };
    let (get, set) = (if has("get_", 0) { "get; " } else { "" }, if has("set_", 1) { "set; " } else { "" });
    Some((name.to_owned(), format!("public extern {kind} {name} {{ {get}{set}}}")))
}

fn method(member: &Member<'_>, names: &BTreeSet<&str>) -> Option<(String, String)> {
    let (result, outs) = member.gives.split_first()?;
    let mut parameters = Vec::new();
    let mut key = member.name.to_owned();
    for (kind, name) in &member.parameters {
        let kind = written(kind, true, names)?;
        let _ = write!(key, ",{kind}");
        parameters.push(format!("{kind} @{name}"));
    }
    for (place, kind) in outs.iter().enumerate() {
        let kind = written(kind, false, names)?;
        let _ = write!(key, ",out {kind}");
        parameters.push(format!("out {kind} out{place}"));
    }
    let list = parameters.join(", ");
    if member.name == "new" {
        return Some((key, format!("public extern {}({list});", member.class)));
    }
    let result = written(result, false, names)?;
    let is_static = if member.is_static { "static " } else { "" };
    Some((key, format!("public {is_static}extern {result} {}({list});", member.name)))
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn members_become_declarations() {
        let signatures = [
            "Curve.ClosestPoint(this Curve, Point3d testPoint) -> Boolean, Double",
            "Curve.JoinCurves(Curve[] inputCurves) -> Curve[]",
            "Curve.get_Domain(this Curve) -> Interval",
            "Curve.set_Domain(this Curve, Interval domain) -> Void",
            "Curve.Odd(this Curve, Unknown what) -> Void",
            "LineCurve.new(Line line) -> Curve",
        ];
        let text = declarations(&signatures.map(str::to_owned));
        for line in [
            "public extern bool ClosestPoint(Point3d @testPoint, out double out0);",
            "public static extern Curve[] JoinCurves(IEnumerable<Curve> @inputCurves);",
            "public extern Interval Domain { get; set; }",
            "[Native] public class LineCurve : Curve {",
            "public extern LineCurve(Line @line);",
        ] {
            assert!(text.contains(line), "{line}");
        }
        assert!(!text.contains("Odd"), "a type that is not declared leaves its member out");
    }
}
