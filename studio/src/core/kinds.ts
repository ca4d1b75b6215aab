/** Which data an input takes: as far as the names of types tell. The solver has the last word, by casting. */

const ANY = new Set(["Generic Data", "Data", "Any", ""]);
const NUMBERS = new Set(["Number", "Integer", "Boolean", "Text", "Angle", "Complex", "Time", "Percentage"]);
const GEOMETRY = new Set([
  "Geometry",
  "Point",
  "Vector",
  "Plane",
  "Line",
  "Circle",
  "Arc",
  "Rectangle",
  "Box",
  "Curve",
  "Surface",
  "Brep",
  "Mesh",
  "SubD",
  "Twisted Box",
  "Group",
]);

/** What becomes what without a component between them. */
const CASTS: Record<string, readonly string[]> = {
  Point: ["Vector", "Plane", "Text"],
  Vector: ["Point", "Plane", "Text"],
  Plane: ["Point", "Vector", "Text", "Transform"],
  Line: ["Curve", "Vector", "Number"],
  Circle: ["Curve", "Point", "Plane", "Surface", "Number"],
  Arc: ["Curve", "Number"],
  Rectangle: ["Curve", "Plane", "Surface"],
  Curve: ["Line", "Circle", "Arc", "Rectangle", "Number"],
  Box: ["Brep", "Mesh", "Point", "Plane"],
  Surface: ["Brep", "Domain²", "Mesh"],
  Brep: ["Surface", "Mesh", "Box"],
  Mesh: ["Point"],
  Number: ["Domain", "Complex", "Point", "Colour", "Matrix"],
  Integer: ["Domain", "Colour"],
  Text: ["Point", "Vector", "Plane", "Domain", "Colour", "Path", "Matrix", "Culture"],
  Domain: ["Number", "Text"],
  "Domain²": ["Point"],
  Colour: ["Text", "Number", "Vector", "Shader", "Material"],
  Matrix: ["Transform"],
  Transform: ["Matrix"],
};

/** 2 for the same type, 1 where it is cast, 0 where it will hardly do. */
export function fit(from: string, to: string): 0 | 1 | 2 {
  if (from === to) return 2;
  if (ANY.has(from) || ANY.has(to)) return 1;
  if (to === "Geometry") return GEOMETRY.has(from) ? 2 : 0;
  if (from === "Geometry") return GEOMETRY.has(to) ? 1 : 0;
  if (NUMBERS.has(from) && NUMBERS.has(to)) return 1;
  if (to === "Text") return NUMBERS.has(from) ? 1 : 0;
  return CASTS[from]?.includes(to) ? 1 : 0;
}
