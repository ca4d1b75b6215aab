//! A member of the table as a line of C#.

use std::collections::BTreeSet;
use std::fmt::Write as _;

use super::declare::namespace;
use super::enums;

/// Types that are written out, as the table names them, with how C# writes them.
const KNOWN: [(&str, &str); 31] = [
    ("Arc", "Arc"),
    ("Boolean", "bool"),
    ("BoundingBox", "BoundingBox"),
    ("Box", "Box"),
    ("Circle", "Circle"),
    ("Color", "System.Drawing.Color"),
    ("Cone", "Cone"),
    ("Cylinder", "Cylinder"),
    ("Double", "double"),
    ("Ellipse", "Ellipse"),
    ("Int32", "int"),
    ("Interval", "Interval"),
    ("Line", "Line"),
    ("MeshFace", "MeshFace"),
    ("MeshingParameters", "MeshingParameters"),
    ("Object", "object"),
    ("Plane", "Plane"),
    ("Point2d", "Point2d"),
    ("Point3d", "Point3d"),
    ("Polyline", "Polyline"),
    ("Ray3d", "Ray3d"),
    ("Rectangle3d", "Rectangle3d"),
    ("Sphere", "Sphere"),
    ("String", "string"),
    ("SurfaceCurvature", "SurfaceCurvature"),
    ("BrepVertex", "BrepVertex"),
    ("BrepLoop", "BrepLoop"),
    ("Torus", "Torus"),
    ("Transform", "Transform"),
    ("Vector3d", "Vector3d"),
    ("Void", "void"),
];

/// Results that RhinoCommon has a narrower type for.
const RESULTS: [(&str, &str); 18] = [
    ("NurbsCurvePointList.GetControlPoint", "ControlPoint"),
    ("NurbsSurfacePointList.GetControlPoint", "ControlPoint"),
    ("NurbsSurface.Create", "NurbsSurface"),
    ("SubDEdge.get_Tag", "SubDEdgeTag"),
    ("SubDVertex.get_Tag", "SubDVertexTag"),
    ("Brep.get_SolidOrientation", "BrepSolidOrientation"),
    ("BrepEdge.get_EndVertex", "BrepVertex"),
    ("BrepEdge.get_StartVertex", "BrepVertex"),
    ("BrepFace.get_Loops", "BrepLoop[]"),
    ("BrepFace.get_OuterLoop", "BrepLoop"),
    ("Curve.Contains", "PointContainment"),
    ("Curve.PlanarClosedCurveRelationship", "RegionContainment"),
    ("Curve.ToNurbsCurve", "NurbsCurve"),
    ("Surface.ClosestSide", "IsoStatus"),
    ("Surface.CurvatureAt", "SurfaceCurvature"),
    ("Surface.ToNurbsSurface", "NurbsSurface"),
    ("BrepFace.UnderlyingSurface", "Surface"),
    ("BrepFace.IsPointOnFace", "PointFaceRelation"),
];

/// The types that declarations may name.
pub(super) struct Types<'a> {
    pub(super) classes: BTreeSet<&'a str>,
}

impl Types<'_> {
    /// A type as C# writes it; none for one that is not declared.
    fn written(&self, name: &str, is_parameter: bool) -> Option<String> {
        if let Some(element) = name.strip_suffix("[]") {
            let element = self.written(element, is_parameter)?;
            // Arrays and lists both are given where a sequence is asked for.
            return Some(if is_parameter {
                format!("IEnumerable<{element}>")
            } else {
                format!("{element}[]")
            });
        }
        if let Some((_, known)) = KNOWN.iter().find(|(own, _)| *own == name) {
            return Some((*known).to_owned());
        }
        if enums::has(name) {
            return Some(name.to_owned());
        }
        self.classes.contains(name).then(|| match namespace(name) {
            "Rhino.Geometry" => name.to_owned(),
            space => format!("{space}.{name}"),
        })
    }
}

/// A member of the table, taken apart.
pub(super) struct Member<'a> {
    pub(super) class: &'a str,
    pub(super) name: &'a str,
    is_static: bool,
    parameters: Vec<(&'a str, &'a str)>,
    gives: Vec<&'a str>,
}

impl<'a> Member<'a> {
    /// `Class.Member(this Type, Type name) -> Type, Type`.
    pub(super) fn of(signature: &'a str) -> Option<Self> {
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

    /// How many parameters stand before the `out` ones, as RhinoCommon has them: the table gives results behind one
    /// another and does not say. A tolerance, a largest distance and a part of the domain follow what is found.
    pub(super) fn before_outs(&self) -> usize {
        let first = match self.name {
            name if name.starts_with("TryGet") => 0,
            "LengthParameter" | "NormalizedLengthParameter" | "ClosestPoint" => 1,
            _ => return self.parameters.len(),
        };
        first.min(self.parameters.len())
    }

    /// The types of the parameters in RhinoCommon's order, `out` ones too.
    #[cfg(test)]
    pub(super) fn types(&self) -> Vec<&'a str> {
        let mut types: Vec<&str> = self.parameters.iter().map(|(kind, _)| *kind).collect();
        let at = self.before_outs();
        types.splice(at..at, self.outs());
        types
    }

    /// The types of the `out` parameters.
    fn outs(&self) -> impl Iterator<Item = &'a str> {
        let is_nurbs = self.class == "NurbsSurface";
        self.gives
            .iter()
            .skip(1)
            .map(move |kind| if is_nurbs && *kind == "Surface" { "NurbsSurface" } else { kind })
    }

    /// The type of the result.
    fn result(&self) -> Option<&'a str> {
        let own = *self.gives.first()?;
        let name = format!("{}.{}", self.class, self.name);
        if let Some((_, narrow)) = RESULTS.iter().find(|(own, _)| *own == name) {
            return Some(narrow);
        }
        let makes_its_own = self.is_static || self.name.starts_with("Duplicate");
        Some(match (self.class, own) {
            ("NurbsCurve" | "PolyCurve" | "PolylineCurve", "Curve") if makes_its_own => self.class,
            ("NurbsSurface" | "RevSurface" | "SumSurface" | "PlaneSurface", "Surface") if makes_its_own => {
                self.class
            }
            _ => own,
        })
    }

    /// The declaration, with a key that tells overloads apart; none where a type is not declared.
    pub(super) fn written(&self, all: &[&Member<'_>], types: &Types<'_>) -> Option<(String, String)> {
        if self.name.starts_with("get_") || self.name.starts_with("set_") {
            self.property(all, types)
        } else {
            self.method(types)
        }
    }

    fn property(&self, all: &[&Member<'_>], types: &Types<'_>) -> Option<(String, String)> {
        let name = self.name.get(4..)?;
        let has = |start: &str, count: usize| {
            all.iter().any(|m| m.name == format!("{start}{name}") && m.parameters.len() == count)
        };
        if name == "Item" || self.is_static {
            return None;
        }
        let kind = match (self.name.starts_with("get_"), self.parameters.as_slice()) {
            (true, []) => types.written(self.result()?, false)?,
            (false, [(kind, _)]) => types.written(kind, false)?,
            _ => return None,
        };
        let line = if enums::has(&kind) {
            // The table gives the number of the member.
            format!(
                "internal extern int raw_get_{name}(); public {kind} {name} {{ get {{ return ({kind})raw_get_{name}(); }} }}"
            )
        } else {
            let get = if has("get_", 0) { "get; " } else { "" };
            let set = if has("set_", 1) { "set; " } else { "" };
            format!("public extern {kind} {name} {{ {get}{set}}}")
        };
        Some((name.to_owned(), line))
    }

    fn method(&self, types: &Types<'_>) -> Option<(String, String)> {
        let mut parameters = Vec::new();
        let mut key = self.name.to_owned();
        for (kind, name) in &self.parameters {
            let kind = types.written(kind, true)?;
            let _ = write!(key, ",{kind}");
            parameters.push(format!("{kind} @{name}"));
        }
        let at = self.before_outs();
        for (place, kind) in self.outs().enumerate() {
            let kind = types.written(kind, false)?;
            let _ = write!(key, ",out {kind}");
            parameters.insert(at + place, format!("out {kind} out{place}"));
        }
        let list = parameters.join(", ");
        if self.name == "new" {
            return Some((key, format!("public extern {}({list});", self.class)));
        }
        let (name, result) = (self.name, types.written(self.result()?, false)?);
        let is_static = if self.is_static { "static " } else { "" };
        if enums::has(&result) {
            let names: Vec<String> = self.parameters.iter().map(|(_, name)| format!("@{name}")).collect();
            let names = names.join(", ");
            return Some((
                key,
                format!(
                    "internal {is_static}extern int raw_{name}({list}); public {is_static}{result} {name}({list}) {{ \
                     return ({result})raw_{name}({names}); }}"
                ),
            ));
        }
        Some((key, format!("public {is_static}extern {result} {name}({list});")))
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use katydid_members::geometry::endpoints;

    /// Paths of a compute server name the types of all parameters, `out` ones too, in RhinoCommon's order.
    #[test]
    fn out_parameters_stand_where_rhino_common_has_them() {
        let signatures = endpoints().members();
        let mut checked = 0;
        for signature in &signatures {
            let Some(member) = Member::of(signature) else { continue };
            if member.gives.len() < 2 {
                continue;
            }
            let plain = |kind: &str| match kind {
                "Double" => "double".to_owned(),
                "Boolean" => "bool".to_owned(),
                "Int32" => "int".to_owned(),
                kind => kind.to_ascii_lowercase().replace("int32[]", "intarray").replace("[]", "array"),
            };
            let mut types: Vec<String> = member.types().into_iter().map(plain).collect();
            if !member.is_static {
                types.insert(0, member.class.to_ascii_lowercase());
            }
            let start = format!("{}/{}-", member.class, member.name).to_ascii_lowercase();
            let start = start.replace("intersection/", "intersect/intersection/");
            let paths: Vec<&str> = endpoints().answered().filter(|path| path.starts_with(&start)).collect();
            if paths.is_empty() {
                continue;
            }
            checked += 1;
            let types = types.join("_");
            let fits = |path: &&str| path.get(start.len()..) == Some(types.as_str());
            let is_known_otherwise =
                ["MeshPolyline", "Validate", "ShrinkSurface", "Sum", "TryGet", "Offset", "Project"]
                    .iter()
                    .any(|part| member.name.contains(part));
            assert!(paths.iter().any(fits) || is_known_otherwise, "{signature}: {types}, not {paths:?}");
        }
        assert!(checked > 30, "{checked}");
    }
}
