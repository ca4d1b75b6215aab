//! The types of RhinoCommon and Grasshopper as C# declarations. Classes come from the signatures of the member table, and
//! enumerations from the list that Python's have: there is no second list. Structs are written out with their formulas.

use std::collections::{BTreeMap, BTreeSet};
use std::fmt::Write as _;

use super::enums;
use super::member::{Member, Types};

/// What the text begins with.
const USING: &str = "using System;\nusing System.Collections;\nusing System.Collections.Generic;\n";
/// Structs, written out with their formulas.
const VALUES: [&str; 6] = [
    include_str!("rhino/math.cs"),
    include_str!("rhino/point.cs"),
    include_str!("rhino/plane.cs"),
    include_str!("rhino/line.cs"),
    include_str!("rhino/polyline.cs"),
    include_str!("rhino/solid.cs"),
];
/// The document, and types of Grasshopper.
const GRASSHOPPER: &str = concat!(include_str!("rhino/document.cs"), include_str!("rhino/grasshopper.cs"));
/// Members of classes that the table has in another form.
const CLASSES: &str = include_str!("rhino/classes.cs");
/// Lists that belong to objects.
const LISTS: &str = include_str!("rhino/lists.cs");
/// What begins the members of a class in the two texts above.
const MARK: &str = "//: ";

/// The class that a class inherits from, as the table has it too.
fn base(class: &str) -> Option<&'static str> {
    Some(match class {
        "LineCurve" | "ArcCurve" | "PolylineCurve" | "NurbsCurve" | "PolyCurve" | "BrepEdge" => "Curve",
        "PlaneSurface" | "NurbsSurface" | "RevSurface" | "SumSurface" | "Extrusion" | "BrepFace" => "Surface",
        "Curve" | "Surface" | "Brep" | "Mesh" | "SubD" | "Point" | "Hatch" | "PointCloud" | "TextDot" => {
            "GeometryBase"
        }
        _ => return None,
    })
}

/// Classes that members speak of, though the table has no member of them.
const BARE: [&str; 6] = ["GeometryBase", "Hatch", "PointCloud", "PointCloudItem", "TextDot", "ControlPoint"];

/// The namespace of a class.
pub(super) fn namespace(class: &str) -> &'static str {
    match class {
        "Intersection" | "IntersectionEvent" | "MeshClash" => "Rhino.Geometry.Intersect",
        class if class.ends_with("List") => "Rhino.Geometry.Collections",
        _ => "Rhino.Geometry",
    }
}

/// What is written by hand for one class: what it implements, and its members.
struct Own<'a> {
    bases: &'a str,
    members: &'a str,
}

/// The classes of a text, and what stands before the first of them.
fn parts(text: &'static str) -> (&'static str, BTreeMap<&'static str, Own<'static>>) {
    let mut pieces = text.split(MARK);
    let before = pieces.next().unwrap_or_default();
    let classes = pieces.filter_map(|piece| {
        let (head, members) = piece.split_once('\n')?;
        let (class, bases) = head.split_once(" : ").unwrap_or((head, ""));
        Some((class.trim(), Own { bases: bases.trim(), members }))
    });
    // The last line of what stands before may begin a comment on the marks.
    (before, classes.collect())
}

/// The declarations of all that a script may use beside the library.
pub(super) fn declarations(signatures: &[String]) -> String {
    let members: Vec<Member<'_>> = signatures.iter().filter_map(|text| Member::of(text)).collect();
    let mut classes: BTreeMap<&str, Vec<&Member<'_>>> = BARE.map(|class| (class, Vec::new())).into();
    for member in &members {
        classes.entry(member.class).or_default().push(member);
    }
    let (_, mut by_hand) = parts(CLASSES);
    let (lists, more) = parts(LISTS);
    by_hand.extend(more);
    let types = Types { classes: classes.keys().copied().collect() };
    let mut text = String::from(USING);
    VALUES.iter().for_each(|part| text.push_str(part));
    text.push_str(GRASSHOPPER);
    text.push_str(lists);
    enums::write(&mut text);
    for space in ["Rhino.Geometry", "Rhino.Geometry.Intersect", "Rhino.Geometry.Collections"] {
        let _ = writeln!(text, "namespace {space} {{");
        for (class, members) in classes.iter().filter(|(class, _)| namespace(class) == space) {
            write_class(&mut text, class, members, &types, by_hand.get(class));
        }
        text.push_str("}\n");
    }
    text
}

fn write_class(
    text: &mut String,
    class: &str,
    members: &[&Member<'_>],
    types: &Types<'_>,
    own: Option<&Own<'_>>,
) {
    let is_list = namespace(class) == "Rhino.Geometry.Collections";
    let bases = match (base(class), own.map(|own| own.bases).filter(|bases| !bases.is_empty())) {
        (Some(base), _) => format!(" : {base}"),
        (None, Some(bases)) => format!(" : {bases}"),
        (None, None) => String::new(),
    };
    // A list has its object in its one field.
    let kind = if is_list { "" } else { "[Native] " };
    let _ = writeln!(text, "{kind}public class {class}{bases} {{");
    let by_hand = own.map_or("", |own| own.members);
    text.push_str(by_hand);
    let mut written = BTreeSet::new();
    for member in members {
        if by_hand.contains(&format!("raw_{}(", member.name)) {
            continue;
        }
        // Overloads whose types C# cannot tell apart are one.
        let bare = format!(" {}()", member.name);
        if let Some((key, line)) = member.written(members, types)
            // What is written by hand is not declared a second time.
            && !(line.contains(&bare) && by_hand.contains(&bare))
            && written.insert(key)
        {
            let _ = writeln!(text, "  {line}");
        }
    }
    text.push_str("}\n");
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn members_become_declarations() {
        let signatures = [
            "Curve.ClosestPoint(this Curve, Point3d testPoint) -> Boolean, Double",
            "Curve.ClosestPoint(this Curve, Point3d testPoint, Double maximumDistance) -> Boolean, Double",
            "Curve.TryGetArc(this Curve, Double tolerance) -> Boolean, Arc",
            "Curve.JoinCurves(Curve[] inputCurves) -> Curve[]",
            "Curve.get_Degree(this Curve) -> Int32",
            "Curve.Odd(this Curve, Unknown what) -> Void",
            "LineCurve.new(Line line) -> Curve",
            "NurbsCurve.CreateFromLine(Line line) -> Curve",
            "Curve.Contains(this Curve, Point3d testPoint) -> Int32",
        ];
        let text = declarations(&signatures.map(str::to_owned));
        for line in [
            "public extern bool ClosestPoint(Point3d @testPoint, out double out0);",
            "public extern bool ClosestPoint(Point3d @testPoint, out double out0, double @maximumDistance);",
            "public extern bool TryGetArc(out Arc out0, double @tolerance);",
            "public static extern Curve[] JoinCurves(IEnumerable<Curve> @inputCurves);",
            "public extern int Degree { get; }",
            "[Native] public class LineCurve : Curve {",
            "public extern LineCurve(Line @line);",
            "public static extern NurbsCurve CreateFromLine(Line @line);",
            "public PointContainment Contains(Point3d @testPoint) { return (PointContainment)raw_Contains(@testPoint); }",
        ] {
            assert!(text.contains(line), "{line}");
        }
        assert!(!text.contains("Odd"), "a type that is not declared leaves its member out");
    }
}
