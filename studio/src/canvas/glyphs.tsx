/** The pictures of components: one for each panel of the tabs, drawn with lines in the colour of their text. */

import { abbreviation } from "../core/abbreviation";
import { useEntry } from "./hooks";

const PATHS: Record<string, string> = {
  "Params/Geometry": "M10 3l6 3.500v7L10 17l-6-3.500v-7z",
  "Params/Primitive": "M4 10h12M10 4v12M6 6l8 8",
  "Params/Input": "M3 7h14M3 13h14M7 5v4M13 11v4",
  "Params/Util": "M4 4h5v5H4zM11 11h5v5h-5zM9 6.500h4V11",
  "Maths/Domain": "M4 5v10M16 5v10M4 10h12",
  "Maths/Matrix": "M6 4H4v12h2M14 4h2v12h-2M8 8h.1M12 8h.1M8 12h.1M12 12h.1",
  "Maths/Operators": "M5 7h6M8 4v6M10 14h6",
  "Maths/Polynomials": "M4 16C7 16 13 12 15 4M12 4h4",
  "Maths/Script": "M7 6l-4 4 4 4M13 6l4 4-4 4",
  "Maths/Time": "M10 3a7 7 0 1 0 0 14a7 7 0 0 0 0-14zM10 6v4l3 2",
  "Maths/Trig": "M3 10c3-9 5-9 7 0s4 9 7 0",
  "Maths/Util": "M10 3v14M3 10h14M5 5l10 10M15 5L5 15",
  "Sets/List": "M7 5h10M7 10h10M7 15h10M3.5 5h.1M3.5 10h.1M3.5 15h.1",
  "Sets/Sequence": "M4 16v-3M8 16v-6M12 16V7M16 16V4",
  "Sets/Sets": "M8 5a5 5 0 1 0 0 10a5 5 0 0 0 0-10zM12 5a5 5 0 1 1 0 10a5 5 0 0 1 0-10z",
  "Sets/Text": "M4 5h12M10 5v11M7.5 16h5",
  "Sets/Tree": "M10 17V9M10 9L5 4M10 9l5-5M10 13l4-3",
  "Vector/Field": "M4 15l3-3M4 8l5-2M10 14l4-5M13 6l3-2M6 10l.1 0M12 11l.1 0",
  "Vector/Grid": "M3 7h14M3 13h14M7 3v14M13 3v14",
  "Vector/Plane": "M3 13l5-7h9l-5 7zM10 9.500V3M8 5l2-2 2 2",
  "Vector/Point": "M6 6l8 8M14 6l-8 8",
  "Vector/Vector": "M4 16L16 4M10 4h6v6",
  "Curve/Analysis": "M3 14c4-10 10-10 14 0M10 6.500V17M8 17h4",
  "Curve/Division": "M3 14c4-10 10-10 14 0M5 8l2 2M10 5v3M15 8l-2 2",
  "Curve/Primitive": "M10 4a6 6 0 1 0 0 12a6 6 0 0 0 0-12z",
  "Curve/Spline": "M3 15C6 3 12 17 17 5",
  "Curve/Util": "M3 12c4-8 8-8 10-2M3 16c5-6 11-6 14-2M15 4v4M13 6h4",
  "Surface/Analysis": "M3 13l5-7h9l-5 7zM8 9.500h4M10 17v-6",
  "Surface/Freeform": "M3 12c4-6 6-6 9-5s3 1 5-1v7c-2 2-3 2-5 1s-5-1-9 5z",
  "Surface/Primitive": "M4 7l6-3 6 3v7l-6 3-6-3zM4 7l6 3 6-3M10 10v7",
  "Surface/SubD": "M10 3c5 0 7 3 7 7s-2 7-7 7-7-3-7-7 2-7 7-7zM3 10c4 2 10 2 14 0M10 3c-2 4-2 10 0 14",
  "Surface/Util": "M3 13l5-7h9l-5 7zM6 17l8-4M14 13v4h-4",
  "Mesh/Analysis": "M3 15l7-11 7 11zM10 4v11M6.5 9.500h7",
  "Mesh/Primitive": "M3 6l7-3 7 3v8l-7 3-7-3zM3 6l7 3 7-3M10 9v8M3 14l7-5 7 5",
  "Mesh/Triangulation": "M3 15l4-9 9-2 1 9-6 4zM7 6l4 11M7 6l10 7M16 4l-5 13",
  "Mesh/Util": "M3 15l7-11 7 11zM6.5 9.500h7M6.5 9.500L10 15l3.5-5.5",
  "Intersect/Mathematical": "M3 15L17 5M4 4c3 8 8 12 13 12M9 10.500h.1",
  "Intersect/Physical": "M4 4h8v8H4zM8 8h8v8H8z",
  "Intersect/Region": "M8 4a5 5 0 1 0 0 10a5 5 0 0 0 0-10zM12 6a5 5 0 1 1 0 10a5 5 0 0 1 0-10zM9 8h3M9 12h3",
  "Intersect/Shape": "M3 8h8v8H3zM8 3a6 6 0 0 1 9 9H11V8H8z",
  "Transform/Affine": "M3 15h8V7H3zM8 15l4-10h6l-3 10z",
  "Transform/Array": "M3 3h4v4H3zM13 3h4v4h-4zM3 13h4v4H3zM13 13h4v4h-4z",
  "Transform/Euclidean": "M3 9h6v6H3zM10 7c2-4 6-3 6 2M13.5 7.500L16 10l2-3",
  "Transform/Morph": "M3 5h6v10H3zM12 5c3 2 3 8 0 10h5c3-2 3-8 0-10z",
  "Transform/Util": "M4 6h8M9 3l3 3-3 3M16 14H8M11 11l-3 3 3 3",
  "Display/Colour": "M10 3a7 7 0 1 0 0 14c2 0 1-2 1-3s1-2 3-2h3a7 7 0 0 0-7-9zM6.5 8h.1M10 6h.1M13.5 8h.1M6 12h.1",
  "Display/Dimensions": "M4 4v12M16 4v12M4 10h12M6 8l-2 2 2 2M14 8l2 2-2 2",
  "Display/Graphs": "M4 3v13h13M7 13l3-4 3 2 4-6",
  "Display/Preview": "M2 10s3-5 8-5 8 5 8 5-3 5-8 5-8-5-8-5zM10 8a2 2 0 1 0 0 4a2 2 0 0 0 0-4z",
  "Display/Vector": "M4 16L12 8M8 8h4v4M14 4h.1M16 8h.1",
  Rhino: "M4 4h9l3 3v9H4zM13 4v3h3",
};

/** What has no panel of these: a plain box. */
const PLAIN = "M4 4h12v12H4z";

/** The picture of a panel's components. Exported for tests. */
export function glyphOf(tab: string, panel: string): string {
  return PATHS[`${tab}/${panel}`] ?? PATHS[tab] ?? PLAIN;
}

/** A component's picture, with letters below it that tell it from its neighbours. */
export function Glyph({ component, name, size }: { component: string; name: string; size: number }) {
  const entry = useEntry(component);
  return (
    <svg className="glyph" viewBox="0 0 20 27" height={size} aria-hidden="true">
      <path d={glyphOf(entry?.tab ?? "", entry?.panel ?? "")} />
      <text x="10" y="25.5" textAnchor="middle">
        {abbreviation(name)}
      </text>
    </svg>
  );
}
