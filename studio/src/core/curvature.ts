/**
 * The curvatures of a surface at the vertices of its mesh, from positions and normals.
 *
 * S. Rusinkiewicz, "Estimating Curvatures and Their Derivatives on Triangle Meshes" (3DPVT 2004): over each triangle
 * the second fundamental form is fitted to how the vertex normals change along the edges, then averaged at the vertices
 * with each one's share of the triangle. With the exact normals of a surface this is a second-order estimate; the sign
 * of the mean curvature is the kernel's: positive where the surface bends towards its normal, negative at the outside of a
 * sphere.
 */

type Numbers = Float32Array | Int8Array;
type Vec = [number, number, number];

export interface Curvatures {
  /** The product of the principal curvatures at each vertex, 1 over square model units. */
  gaussian: Float32Array;
  /** Half their sum at each vertex, 1 over model units. */
  mean: Float32Array;
}

export function estimateCurvatures(
  positions: Float32Array,
  normals: Numbers,
  indices: Uint16Array | Uint32Array | null,
): Curvatures {
  const count = positions.length / 3;
  // The form of each vertex in its own tangent frame: e, f, g and the sum of weights.
  const forms = new Float64Array(count * 4);
  const frames = tangentFrames(normals, count);
  const corners = indices ? indices.length : count;
  for (let at = 0; at + 2 < corners; at += 3) {
    const triangle = [0, 1, 2].map((corner) => (indices ? (indices[at + corner] ?? 0) : at + corner));
    addTriangle(positions, normals, triangle as Vec, frames, forms);
  }
  const gaussian = new Float32Array(count);
  const mean = new Float32Array(count);
  for (let vertex = 0; vertex < count; vertex++) {
    const weight = forms[vertex * 4 + 3] || 1;
    const [e, f, g] = [0, 1, 2].map((part) => (forms[vertex * 4 + part] ?? 0) / weight) as Vec;
    gaussian[vertex] = e * g - f * f;
    mean[vertex] = -(e + g) / 2;
  }
  return { gaussian, mean };
}

/** The greater or the lesser principal curvature, from their product and half their sum. */
export function principal({ gaussian, mean }: Curvatures, which: "greater" | "lesser"): Float32Array {
  const sign = which === "greater" ? 1 : -1;
  return mean.map((half, at) => half + sign * Math.sqrt(Math.max(half * half - (gaussian[at] ?? 0), 0)));
}

/** Two unit vectors across each normal, six numbers a vertex. */
function tangentFrames(normals: Numbers, count: number): Float64Array {
  const frames = new Float64Array(count * 6);
  for (let vertex = 0; vertex < count; vertex++) {
    const normal = unit(read(normals, vertex));
    const across: Vec = Math.abs(normal[0]) < 0.6 ? [1, 0, 0] : [0, 1, 0];
    const u = unit(cross(across, normal));
    frames.set(u, vertex * 6);
    frames.set(cross(normal, u), vertex * 6 + 3);
  }
  return frames;
}

function addTriangle(
  positions: Float32Array,
  normals: Numbers,
  triangle: Vec,
  frames: Float64Array,
  forms: Float64Array,
): void {
  const [p, q, r] = triangle.map((vertex) => read(positions, vertex)) as [Vec, Vec, Vec];
  const edges: [Vec, Vec, Vec] = [minus(r, q), minus(p, r), minus(q, p)];
  const area = cross(edges[0], edges[1]);
  const size = Math.hypot(...area);
  if (!(size > 0)) return;
  const n = area.map((value) => value / size) as Vec;
  const u = unit(edges[0]);
  const v = cross(n, u);
  const own = triangle.map((vertex) => unit(read(normals, vertex))) as [Vec, Vec, Vec];
  const changes: [Vec, Vec, Vec] = [minus(own[2], own[1]), minus(own[0], own[2]), minus(own[1], own[0])];
  const form = fit(edges, changes, u, v);
  if (!form) return;
  triangle.forEach((vertex, corner) => {
    const share = shareOf(edges, corner) * size;
    const turned = turn(form, u, v, n, own[corner] as Vec, frames, vertex);
    for (let part = 0; part < 3; part++) {
      forms[vertex * 4 + part] = (forms[vertex * 4 + part] ?? 0) + share * (turned[part] ?? 0);
    }
    forms[vertex * 4 + 3] = (forms[vertex * 4 + 3] ?? 0) + share;
  });
}

/** Least squares for e, f, g in (e a + f b, f a + g b) = change of the normal along an edge (a, b). */
function fit(edges: Vec[], changes: Vec[], u: Vec, v: Vec): Vec | undefined {
  let [aa, ab, bb, ax, bxay, by] = [0, 0, 0, 0, 0, 0];
  edges.forEach((edge, at) => {
    const change = changes[at] as Vec;
    const [a, b, x, y] = [dot(edge, u), dot(edge, v), dot(change, u), dot(change, v)];
    aa += a * a;
    ab += a * b;
    bb += b * b;
    ax += a * x;
    bxay += b * x + a * y;
    by += b * y;
  });
  // The normal equations | aa ab 0 ; ab aa+bb ab ; 0 ab bb | (e f g) = (ax, bxay, by), by elimination.
  const middle = aa + bb - (ab * ab) / aa - (ab * ab) / bb;
  if (!(aa > 0) || !(bb > 0) || !(middle > 1e-12 * (aa + bb))) return undefined;
  const f = (bxay - (ab * ax) / aa - (ab * by) / bb) / middle;
  return [(ax - ab * f) / aa, f, (by - ab * f) / bb];
}

/** How much of a triangle lies nearest to a corner, by its edges: near enough to Voronoi's share, never negative. */
function shareOf(edges: readonly Vec[], corner: number): number {
  const next = edges[(corner + 1) % 3] as Vec;
  const last = edges[(corner + 2) % 3] as Vec;
  const angle = Math.atan2(Math.hypot(...cross(next, last)), -dot(next, last));
  return angle / Math.PI;
}

/** The form of a triangle in the frame of a vertex, after turning the triangle's plane into the vertex's. */
function turn(form: Vec, u: Vec, v: Vec, from: Vec, to: Vec, frames: Float64Array, vertex: number): Vec {
  // A normal on the other side of the triangle (another winding) means another sign, not half a turn.
  const side = dot(from, to) < 0 ? -1 : 1;
  const target = to.map((value) => value * side) as Vec;
  const [a, b] = [rotate(u, from, target), rotate(v, from, target)];
  const s = frames.subarray(vertex * 6, vertex * 6 + 3) as unknown as Vec;
  const t = frames.subarray(vertex * 6 + 3, vertex * 6 + 6) as unknown as Vec;
  const [su, sv, tu, tv] = [dot(s, a), dot(s, b), dot(t, a), dot(t, b)];
  const [e, f, g] = form;
  return [
    su * su * e + 2 * su * sv * f + sv * sv * g,
    su * tu * e + (su * tv + sv * tu) * f + sv * tv * g,
    tu * tu * e + 2 * tu * tv * f + tv * tv * g,
  ];
}

/** A vector after the shortest turn that takes one direction to another. */
function rotate(vector: Vec, from: Vec, to: Vec): Vec {
  const axis = cross(from, to);
  const cosine = dot(from, to);
  const factor = dot(axis, vector) / (1 + cosine);
  const side = cross(axis, vector);
  return [0, 1, 2].map((at) => cosine * vector[at]! + side[at]! + factor * axis[at]!) as Vec;
}

function read(numbers: Numbers, vertex: number): Vec {
  return [numbers[vertex * 3] ?? 0, numbers[vertex * 3 + 1] ?? 0, numbers[vertex * 3 + 2] ?? 0];
}

function unit(vector: Vec): Vec {
  const length = Math.hypot(...vector) || 1;
  return [vector[0] / length, vector[1] / length, vector[2] / length];
}

function minus(a: Vec, b: Vec): Vec {
  return [a[0] - b[0], a[1] - b[1], a[2] - b[2]];
}

function dot(a: Vec, b: Vec): number {
  return a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
}

function cross(a: Vec, b: Vec): Vec {
  return [a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]];
}
