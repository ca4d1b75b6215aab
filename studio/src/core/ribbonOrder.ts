/** The components of each panel of the tabs that definitions use most, the most used first. Others follow by name. */
export const ORDER: Readonly<Record<string, readonly string[]>> = {
  "Curve/Analysis": [
    "End Points", "Evaluate Length", "Length", "Control Points", "Evaluate Curve", "Curve Closest Point",
    "Polygon Center", "Point In Curve",
  ],
  "Curve/Division": [
    "Divide Curve", "Divide Distance", "Shatter", "Perp Frames", "Divide Length", "Horizontal Frames", "Dash Pattern",
  ],
  "Curve/Primitive": ["Line", "Rectangle", "Circle", "Line SDL", "Polygon", "Rectangle 2Pt", "Arc 3Pt", "Arc"],
  "Curve/Spline": [
    "Interpolate", "PolyLine", "Nurbs Curve", "Tween Curve", "Iso Curve", "Connect Curves", "Curve On Surface",
    "Blend Curve",
  ],
  "Curve/Util": [
    "Explode", "Join Curves", "Offset Curve", "Flip Curve", "Extend Curve", "Rebuild Curve", "Fillet",
    "Offset Curve Loose",
  ],
  "Display/Colour": ["Split AHSV", "Colour RGB (f)", "Colour HSL", "Split ARGB", "Colour RGB", "Colour CMYK"],
  "Display/Dimensions": ["Text Tag", "Text Tag 3D", "Aligned Dimension", "Angular Dimension"],
  "Display/Graphs": ["Legend", "Quick Graph"],
  "Display/Preview": [
    "Custom Preview", "Create Material", "Dot Display", "Cloud Display", "Symbol (Simple)", "Symbol Display",
    "Custom Curve Preview",
  ],
  "Display/Vector": ["Vector Display", "Point List", "Vector Display Ex", "Point Order"],
  "Intersect/Mathematical": [
    "Contour", "Brep | Plane", "Curve | Plane", "Curve | Line", "Brep | Line", "Line | Line", "Mesh | Plane",
    "Line | Plane",
  ],
  "Intersect/Physical": [
    "Surface Split", "Curve | Curve", "Mesh | Mesh", "Collision One|Many", "Multiple Curves", "Collision Many|Many",
    "Brep | Curve", "Curve | Self",
  ],
  "Intersect/Shape": ["Region Union", "Region Difference", "Region Intersection", "Mesh Union"],
  "Maths/Domain": [
    "Remap Numbers", "Bounds", "Construct Domain", "Deconstruct Domain", "Consecutive Domains", "Divide Domain²",
    "Deconstruct Domain²", "Construct Domain²",
  ],
  "Maths/Matrix": ["Construct Matrix", "Display Matrix"],
  "Maths/Operators": [
    "Division", "Negative", "Addition", "Multiplication", "Larger Than", "Mass Addition", "Subtraction", "Equality",
  ],
  "Maths/Polynomials": ["Square Root", "Square", "Power of E", "Power of 10", "One Over X"],
  "Maths/Script": ["Expression", "Evaluate"],
  "Maths/Time": ["Deconstruct Date"],
  "Maths/Trig": ["Radians", "Sine", "Cosine", "Degrees", "ArcCosine"],
  "Maths/Util": ["Pi", "Average", "Interpolate data", "Minimum", "Round", "Maximum"],
  "Mesh/Analysis": [
    "Deconstruct Mesh", "Mesh Edges", "Mesh Closest Point", "Mesh Eval", "Deconstruct Face", "Face Normals",
    "Face Boundaries", "Face Circles",
  ],
  "Mesh/Primitive": [
    "Construct Mesh", "Mesh Colours", "Mesh Plane", "Mesh Sphere", "Mesh Triangle", "Mesh Quad", "Mesh Box",
    "Mesh Sphere Ex",
  ],
  "Mesh/Triangulation": [
    "Delaunay Mesh", "Voronoi", "Facet Dome", "Voronoi 3D", "MetaBall(t) Custom", "Delaunay Edges", "MetaBall(t)",
    "Convex Hull",
  ],
  "Mesh/Util": [
    "Mesh Join", "Mesh Brep", "Simple Mesh", "Weld Mesh", "Settings (Custom)", "Disjoint Mesh", "Mesh Surface",
    "Smooth Mesh",
  ],
  "Params/Geometry": ["Point", "Curve", "Geometry", "Surface", "Brep", "Mesh", "Plane", "Vector"],
  "Params/Input": [
    "Number Slider", "Panel", "Boolean Toggle", "Value List", "Button", "Colour Swatch", "MD Slider", "Graph Mapper",
  ],
  "Params/Primitive": ["Number", "Data", "Integer", "Text", "Boolean", "File Path", "Colour", "Domain"],
  "Params/Util": [
    "Relay", "Cluster Input", "Cluster Output", "Trigger", "Param Viewer", "Get Number", "Data Recorder",
    "Context Bake",
  ],
  "Rhino/Block": ["Explode Block Instance", "Import Model Block Definition", "Model Block Instance"],
  "Rhino/Content": [
    "Filter Content", "Equality Filter", "User Text", "Group Content", "Contains Text Filter", "Content Details",
    "Intersection Filter",
  ],
  "Sets/List": ["List Item", "List Length", "Dispatch", "Sort List", "Weave", "Split List", "Shift List", "Sub List"],
  "Sets/Sequence": [
    "Range", "Series", "Random", "Cull Pattern", "Cull Index", "Duplicate Data", "Jitter", "Repeat Data",
  ],
  "Sets/Sets": [
    "Delete Consecutive", "Key/Value Search", "Create Set", "Find similar member", "Member Index", "Replace Members",
    "Set Difference (S)",
  ],
  "Sets/Text": [
    "Concatenate", "Text Join", "Match Text", "Text Split", "Characters", "Format", "Replace Text", "Sort Text",
  ],
  "Sets/Tree": [
    "Merge", "Graft Tree", "Flatten Tree", "Flip Matrix", "Shift Paths", "Explode Tree", "Tree Statistics",
    "Stream Filter",
  ],
  "Surface/Analysis": [
    "Area", "Deconstruct Brep", "Box Corners", "Surface Closest Point", "Brep Edges", "Volume", "Evaluate Surface",
    "Brep Wireframe",
  ],
  "Surface/Freeform": [
    "Boundary Surfaces", "Loft", "Extrude", "Pipe", "Surface From Points", "Ruled Surface", "4Point Surface",
    "Extrude Point",
  ],
  "Surface/Primitive": [
    "Bounding Box", "Sphere", "Plane Surface", "Cone", "Center Box", "Domain Box", "Box 2Pt", "Cylinder",
  ],
  "Surface/SubD": ["SubD from Mesh", "Mesh from SubD", "MultiPipe", "SubD Control Polygon"],
  "Surface/Util": [
    "Cap Holes", "Brep Join", "Divide Surface", "Flip", "Isotrim", "Surface Frames", "Offset Surface", "Fillet Edge",
  ],
  "Transform/Affine": ["Scale", "Scale NU", "Project", "Orient Direction", "Project Along", "Rectangle Mapping"],
  "Transform/Array": ["Linear Array", "Rectangular Array", "Box Array", "Polar Array", "Curve Array", "Kaleidoscope"],
  "Transform/Euclidean": ["Move", "Rotate", "Mirror", "Orient", "Rotate 3D", "Rotate Axis", "Move Away From"],
  "Transform/Morph": [
    "Stretch", "Box Morph", "Map to Surface", "Surface Box", "Surface Morph", "Mirror Curve", "Twisted Box",
  ],
  "Transform/Util": ["Group", "Ungroup", "Transform", "Compound", "Inverse Transform"],
  "Vector/Field": [
    "Merge Fields", "Field Line", "Point Charge", "Spin Force", "Line Charge", "Direction Display", "Tensor Display",
  ],
  "Vector/Grid": [
    "Populate Geometry", "Square", "Populate 2D", "Hexagonal", "Populate 3D", "Rectangular", "Triangular",
  ],
  "Vector/Plane": [
    "XY Plane", "Construct Plane", "XZ Plane", "YZ Plane", "Deconstruct Plane", "Plane Normal", "Flip Plane",
    "Plane Offset",
  ],
  "Vector/Point": [
    "Construct Point", "Deconstruct", "Distance", "Closest Point", "Pull Point", "Project Point", "Cull Duplicates",
    "Point Polar",
  ],
  "Vector/Vector": ["Unit Z", "Unit X", "Vector 2Pt", "Unit Y", "Amplitude", "Vector XYZ", "Rotate", "Dot Product"],
};
