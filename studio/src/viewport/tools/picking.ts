/**
 * What is under the pointer or in a window. Surfaces by a tree of boxes, built when it is first needed (in a worker
 * for great ones); curves and points by how near they are on the screen.
 */

import { BufferAttribute, BufferGeometry, DoubleSide, Matrix4, Ray, Vector3, type Camera } from "three";
import { MeshBVH } from "three-mesh-bvh";

import { centre, radius } from "../../core/bounds";
import type { Point3, PreviewPart } from "../../core/preview";
import type { Piece } from "../../core/protocol/Piece";
import { nearestOnSegment } from "../../core/screen";
import { dot } from "../../core/section";
import type { Model, ModelObject, ModelPart } from "../scene/model";
import { isOfDocument, isTool } from "./beside";
import { buildTree } from "./treeWorker";

export interface Pick {
  object: string;
  part: PreviewPart;
  piece: Piece | undefined;
  /** Where, in model coordinates. */
  point: Point3;
}

export interface PickView {
  camera: Camera;
  /** Of the pane, in pixels. */
  width: number;
  height: number;
}

interface Candidate extends Pick {
  /** How far from the eye, in the depth of the projection: −1 to 1. */
  depth: number;
}

const NEAR_LINE = 6;
const NEAR_POINT = 9;
/** Surfaces of more triangles get their tree in a worker. */
const LARGE = 150_000;
/** How much nearer a surface must be to hide a line, in the depth of the projection. */
const HIDES = 2e-3;

type Tree = MeshBVH | "on its way";

export class Picker {
  #model: Model;
  #trees = new WeakMap<PreviewPart, Tree>();
  #isWaiting = false;
  #isMeant: (object: string) => boolean = isOfDocument;

  constructor(model: Model) {
    this.#model = model;
  }

  /** Whether a great surface could not be looked at yet. */
  isWaiting(): boolean {
    return this.#isWaiting;
  }

  /** The nearest thing at a place of the pane, in pixels from its top left: of the document, or of the Rhino model too. */
  at(view: PickView, x: number, y: number, withLayers = false): Pick | undefined {
    this.#isWaiting = false;
    this.#isMeant = withLayers ? (id) => !isTool(id) : isOfDocument;
    const ray = rayThrough(view, x, y);
    const surface = this.#surface(view, ray);
    let best: Candidate | undefined;
    for (const [object, entry] of this.#visible((kind) => kind !== "mesh" && kind !== "texts")) {
      const candidate = nearestLine(view, object, entry, x, y, this.#model.origin);
      if (!candidate || this.#beyond(candidate.point) > 0 || (surface && candidate.depth > surface.depth + HIDES * (1 - surface.depth) + 1e-6)) continue;
      if (!best || rank(candidate) < rank(best) || (rank(candidate) === rank(best) && candidate.depth < best.depth)) {
        best = candidate;
      }
    }
    const found = best ?? surface;
    return found && { object: found.object, part: found.part, piece: found.piece, point: found.point };
  }

  *#visible(wanted: (kind: PreviewPart["kind"]) => boolean): Generator<[ModelObject, ModelPart]> {
    for (const object of this.#model.objects.values()) {
      if (!this.#isMeant(object.id)) continue;
      for (const entry of object.parts) {
        if (wanted(entry.part.kind) && this.#model.table.get(entry.slot)[3] > 0) yield [object, entry];
      }
    }
  }

  #surface(view: PickView, ray: Ray): Candidate | undefined {
    let best: Candidate | undefined;
    let nearest = Infinity;
    const local = new Ray();
    const [from, to] = this.#visibleAlong(ray);
    nearest = to;
    for (const [object, entry] of this.#visible((kind) => kind === "mesh")) {
      if (!entry.bounds) continue;
      const offset = minus(object.preview.origin, this.#model.origin);
      local.copy(ray);
      local.origin.sub(offset);
      const tree = this.#tree(entry.part);
      if (!tree) continue;
      const hit = tree.raycastFirst(local, DoubleSide, from, nearest);
      if (!hit || hit.distance >= nearest) continue;
      nearest = hit.distance;
      const point = hit.point.clone().add(offset);
      best = {
        object: object.id,
        part: entry.part,
        piece: pieceAt(entry.part, (hit.faceIndex ?? 0) * 3),
        depth: point.clone().project(view.camera).z,
        point: plus(point, this.#model.origin),
      };
    }
    return best;
  }

  /** From where to where a ray is on the side of the section that is drawn. */
  #visibleAlong({ origin, direction }: Ray): [number, number] {
    const { section } = this.#model;
    if (!section) return [0, Infinity];
    const normal = new Vector3(...section.normal);
    const [off, rise] = [this.#beyond(plus(origin, this.#model.origin)), direction.dot(normal)];
    if (Math.abs(rise) < 1e-12) return off > 0 ? [0, 0] : [0, Infinity];
    const at = -off / rise;
    return rise < 0 ? [Math.max(at, 0), Infinity] : [0, Math.max(at, 0)];
  }

  /** How far a point is beyond the section; less than 0 where it is drawn. */
  #beyond(point: Point3): number {
    const { section } = this.#model;
    return section ? dot(point, section.normal) - section.at : -1;
  }

  #tree(part: PreviewPart): MeshBVH | undefined {
    const known = this.#trees.get(part);
    if (known === "on its way") {
      this.#isWaiting = true;
      return undefined;
    }
    if (known) return known;
    const corners = part.indices?.length ?? part.positions.length / 3;
    if (corners === 0) return undefined;
    if (corners / 3 <= LARGE) {
      const tree = new MeshBVH(geometryOf(part), { indirect: true });
      this.#trees.set(part, tree);
      return tree;
    }
    this.#isWaiting = true;
    this.#trees.set(part, "on its way");
    buildTree(geometryOf(part)).then(
      (tree) => this.#trees.set(part, tree),
      () => this.#trees.set(part, new MeshBVH(geometryOf(part), { indirect: true })),
    );
    return undefined;
  }
}

/** The same arrays, never sent to the graphics card. */
function geometryOf({ positions, indices }: PreviewPart): BufferGeometry {
  const geometry = new BufferGeometry();
  geometry.setAttribute("position", new BufferAttribute(positions, 3));
  if (indices) geometry.setIndex(new BufferAttribute(indices, 1));
  return geometry;
}

/** A ray in the coordinates of drawing. */
export function rayThrough({ camera, width, height }: PickView, x: number, y: number): Ray {
  const [u, v] = [(x / width) * 2 - 1, 1 - (y / height) * 2];
  const near = new Vector3(u, v, -1).unproject(camera);
  const far = new Vector3(u, v, 1).unproject(camera);
  return new Ray(near, far.sub(near).normalize());
}

/** Points before lines, lines before surfaces: else the smaller could never be hit. */
function rank({ part }: Candidate): number {
  return part.kind === "points" || part.kind === "controlPoints" ? 0 : 1;
}

function nearestLine(
  { camera, width, height }: PickView, object: ModelObject, { part, bounds }: ModelPart, x: number, y: number, origin: Point3,
): Candidate | undefined {
  const isPoint = part.kind === "points" || part.kind === "controlPoints";
  let reach = (isPoint ? NEAR_POINT : NEAR_LINE) ** 2;
  const offset = minus(object.preview.origin, origin);
  const project = new Matrix4().multiplyMatrices(camera.projectionMatrix, camera.matrixWorldInverse)
    .multiply(new Matrix4().makeTranslation(offset.x, offset.y, offset.z));
  if (!bounds || !mayTouch(project, bounds, object.preview.origin, width, height, x, y)) return undefined;
  const e = project.elements;
  const { positions, indices } = part;
  const count = indices?.length ?? positions.length / 3;
  const step = isPoint ? 1 : 2;
  const place = (at: number): [number, number, number, number] => {
    const from = (indices ? (indices[at] ?? 0) : at) * 3;
    const [px, py, pz] = [positions[from] ?? 0, positions[from + 1] ?? 0, positions[from + 2] ?? 0];
    const w = e[3]! * px + e[7]! * py + e[11]! * pz + e[15]!;
    return [
      ((e[0]! * px + e[4]! * py + e[8]! * pz + e[12]!) / w + 1) * 0.5 * width,
      (1 - (e[1]! * px + e[5]! * py + e[9]! * pz + e[13]!) / w) * 0.5 * height,
      (e[2]! * px + e[6]! * py + e[10]! * pz + e[14]!) / w,
      w,
    ];
  };
  let found: { index: number; along: number; depth: number } | undefined;
  for (let index = 0; index + step <= count; index += step) {
    const a = place(index);
    const b = step === 2 ? place(index + 1) : a;
    if (a[3] <= 0 || b[3] <= 0) continue;
    const [along, far] = nearestOnSegment(x, y, a[0], a[1], b[0], b[1]);
    if (far > reach) continue;
    reach = far;
    found = { index, along, depth: a[2] + (b[2] - a[2]) * along };
  }
  if (!found) return undefined;
  const { index, along, depth } = found;
  const vertex = (at: number, axis: number) => positions[(indices ? (indices[at] ?? 0) : at) * 3 + axis] ?? 0;
  const point = [0, 1, 2].map((axis) => {
    const [from, to] = [vertex(index, axis), vertex(index + step - 1, axis)];
    return (object.preview.origin[axis] ?? 0) + from + (to - from) * along;
  }) as unknown as Point3;
  return { object: object.id, part, piece: pieceAt(part, index), point, depth };
}

/** Whether the ball round a part comes near a place on the screen; where in doubt, yes. */
function mayTouch(
  project: Matrix4, bounds: NonNullable<ModelPart["bounds"]>, origin: Point3, width: number, height: number, x: number, y: number,
): boolean {
  const middle = minus(centre(bounds), origin);
  const e = project.elements;
  const w = e[3]! * middle.x + e[7]! * middle.y + e[11]! * middle.z + e[15]!;
  // How much the screen's size of a unit can be at most, near the middle.
  const size = radius(bounds);
  const nearest = w - size * Math.hypot(e[3]!, e[7]!, e[11]!);
  if (nearest <= 1e-6) return true;
  const scale = Math.hypot(e[1]!, e[5]!, e[9]!) * height * 0.5;
  const [u, v] = [
    ((e[0]! * middle.x + e[4]! * middle.y + e[8]! * middle.z + e[12]!) / w + 1) * 0.5 * width,
    (1 - (e[1]! * middle.x + e[5]! * middle.y + e[9]! * middle.z + e[13]!) / w) * 0.5 * height,
  ];
  return Math.hypot(u - x, v - y) <= (size * scale * 1.6) / nearest + NEAR_POINT;
}

/** The item of the data that an index (or position) belongs to. Pieces are in order, as a rule. */
export function pieceAt({ pieces }: Pick["part"], at: number): Piece | undefined {
  let [low, high] = [0, pieces.length - 1];
  while (low <= high) {
    const middle = (low + high) >> 1;
    const piece = pieces[middle] as Piece;
    if (at < piece.start) high = middle - 1;
    else if (at >= piece.start + piece.count * (piece.items ?? 1)) low = middle + 1;
    else return itemAt(piece, at);
  }
  const found = pieces.find(({ start, count, items = 1 }) => at >= start && at < start + count * items);
  return found && itemAt(found, at);
}

/** The one item of a piece of several. */
function itemAt(piece: Piece, at: number): Piece {
  const away = Math.floor((at - piece.start) / piece.count);
  return { ...piece, index: piece.index + away, start: piece.start + away * piece.count, items: 1 };
}

function minus(a: Point3, b: Point3): Vector3 {
  return new Vector3(a[0] - b[0], a[1] - b[1], a[2] - b[2]);
}

function plus(a: Vector3, b: Point3): Point3 {
  return [a.x + b[0], a.y + b[1], a.z + b[2]];
}
