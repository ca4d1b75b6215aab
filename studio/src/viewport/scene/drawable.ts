/** What three.js draws for a part or a batch of parts. */

import {
  BufferAttribute, BufferGeometry, DynamicDrawUsage, InstancedBufferAttribute, InstancedBufferGeometry, InstancedInterleavedBuffer,
  InterleavedBuffer, InterleavedBufferAttribute, LineSegments, Mesh, Points, Sphere, Vector3, type Object3D,
  type Camera, type RawShaderMaterial,
} from "three";

import { centre, radius } from "../../core/bounds";
import { fadeAt } from "../../core/density";
import type { Point3 } from "../../core/preview";
import { segmentSlots, segmentsOf, type Merged } from "./merge";
import { SHAPE } from "../shaders/point";
import type { Materials } from "./materials";

/** The layer that only the camera of the ground's shadow sees. */
export const SHADOW_LAYER = 1;
/** The layer of what hides what is behind it, for its depths. */
export const DEPTH_LAYER = 2;

/**
 * The order in which things are drawn. Lines and points come twice: before the surfaces that shine through, which then
 * tint what is behind them, and after them, where they are in front. Else a surface would leave out what lies below
 * the soft borders of lines.
 */
export const ORDER = { grid: -3, behind: -2, surfaces: 10, front: 1e6 } as const;

/** Bits of `uHas`. */
const HAS = { normals: 1, colours: 2, values: 4 } as const;

/** Usual sizes in pixels. */
const LINE = 1.4;
const THINNER: Partial<Record<Merged["kind"], number>> = { isocurves: 1, planes: 1 };
const POINT = 9;
const CONTROL_POINT = 7;
/** In quick pictures points are plain dots: a cross costs software ten times as much. */
const QUICK_POINT = 3;
const HEAD = 11;

export interface Drawable {
  kind: Merged["kind"];
  origin: Point3;
  objects: Object3D[];
  /** Those that are only seen through surfaces. */
  behind: Object3D[];
  /** Those of fine pictures alone, and those that stand for them in quick ones. */
  fine: Object3D[];
  few: Object3D[];
  /** The pair that draws a surface that shines through: its depth, and its colour. */
  surface: { solid: Mesh; depth: Mesh; colour: Mesh } | undefined;
  /** The middle, offset from the origin, by which surfaces are sorted. */
  middle: Vector3;
  triangles: number;
  segments: number;
  points: number;
  /** Other numbers at the positions. */
  setValues(values: Float32Array | null): void;
  dispose(): void;
}

/** How much is drawn in one go: cards that are software draw wide lines slowly, and points one by one. */
export interface Budget {
  wide: number;
  /** So many points in a quick picture. */
  points: number;
  /** So many segments of edges and isocurves in a quick picture, or none: their surfaces are seen without. */
  edges: number;
  /** Whether the card draws one thing many times in one go. */
  areInstances: boolean;
  /** Whether curves that will be finer are lines of one pixel until they are. */
  areDraftsThin: boolean;
}

export function makeDrawable(merged: Merged, materials: Materials, budget: Budget, pixels: () => number): Drawable {
  const { kind } = merged;
  const size = merged.bounds;
  const sphere = size ? new Sphere(new Vector3(...centre(size)), radius(size)) : new Sphere();
  const geometries: BufferGeometry[] = [];
  const own: Owner = (geometry) => {
    geometry.boundingSphere = sphere;
    geometries.push(geometry);
    return geometry;
  };
  const used = merged.indices?.length ?? merged.positions.length / 3;
  const base = {
    kind,
    origin: merged.origin,
    middle: sphere.center,
    triangles: kind === "mesh" ? used / 3 : 0,
    segments: 0,
    points: kind === "points" || kind === "controlPoints" ? used : 0,
    surface: undefined,
    behind: [],
    fine: [],
    few: [],
    setValues() {},
    dispose: () => geometries.forEach((geometry) => geometry.dispose()),
  };
  if (kind === "mesh") return { ...base, ...surfaceOf(merged, own(new BufferGeometry()), materials) };
  if (kind === "points" || kind === "controlPoints") {
    return { ...base, ...pointsWithin(budget.points, merged, own, materials, pixels) };
  }
  const lines = linesOf(merged, own, materials, budget, pixels);
  return { ...base, ...twice(lines), segments: used / 2 };
}

/** Takes a geometry to be disposed of with the rest. */
type Owner = <G extends BufferGeometry>(geometry: G) => G;
type Drawn = Mesh | Points | LineSegments;

/** Each in front of surfaces, and behind them. */
function twice(front: Drawn[]): { objects: Drawn[]; behind: Drawn[] } {
  const behind = front.map((object) => {
    const copy = still(object.clone());
    copy.onBeforeRender = object.onBeforeRender;
    copy.renderOrder = ORDER.behind;
    object.renderOrder += ORDER.front;
    return copy;
  });
  return { objects: [...front, ...behind], behind };
}

const attributes = new WeakMap<Float32Array, BufferAttribute>();

/** Parts of one object that share positions send them to the graphics card once; they come and go together. */
function positionsOf(positions: Float32Array): BufferAttribute {
  const known = attributes.get(positions) ?? new BufferAttribute(positions, 3);
  attributes.set(positions, known);
  return known;
}

function surfaceOf(merged: Merged, geometry: BufferGeometry, materials: Materials) {
  geometry.setAttribute("position", positionsOf(merged.positions));
  const { normals, colours, indices, slots } = merged;
  if (normals) geometry.setAttribute("normal", new BufferAttribute(normals, 3, normals instanceof Int8Array));
  if (colours) geometry.setAttribute("colour", new BufferAttribute(colours, 4, true));
  if (indices) geometry.setIndex(new BufferAttribute(indices, 1));
  if (typeof slots !== "number") geometry.setAttribute("slot", new BufferAttribute(slots, 1));
  let has = (normals ? HAS.normals : 0) | (colours ? HAS.colours : 0);
  const setValues = (values: Float32Array | null) => {
    if (values) geometry.setAttribute("value", new BufferAttribute(values, 1));
    else geometry.deleteAttribute("value");
    has = values ? has | HAS.values : has & ~HAS.values;
  };
  setValues(merged.values);
  const make = (material: RawShaderMaterial) => {
    const mesh = new Mesh(geometry, material);
    mesh.onBeforeRender = (_renderer, _scene, _camera, _geometry, drawn) => {
      materials.setLook(drawn as RawShaderMaterial, slots);
      uniform(drawn as RawShaderMaterial, "uHas", has);
    };
    return still(mesh);
  };
  const surface = { solid: make(materials.opaque), depth: make(materials.depth), colour: make(materials.translucent) };
  surface.solid.layers.enable(DEPTH_LAYER);
  const shadow = make(materials.shadow);
  shadow.layers.set(SHADOW_LAYER);
  return { objects: [...Object.values(surface), shadow], surface, setValues };
}

/** Points; where there are more than quick pictures may have, also evenly chosen ones for those. */
function pointsWithin(most: number, merged: Merged, own: Owner, materials: Materials, pixels: () => number) {
  const all = twice([pointsOf(merged, own(new BufferGeometry()), materials, pixels)]);
  const count = merged.indices?.length ?? merged.positions.length / 3;
  if (count <= most) return all;
  const step = count / most;
  const chosen = Uint32Array.from({ length: most }, (_, k) => merged.indices?.[Math.floor(k * step)] ?? Math.floor(k * step));
  const few = twice([pointsOf({ ...merged, indices: chosen }, own(new BufferGeometry()), materials, pixels)]);
  return {
    objects: [...all.objects, ...few.objects],
    behind: [...all.behind, ...few.behind],
    fine: all.objects,
    few: few.objects,
  };
}

function pointsOf(merged: Merged, geometry: BufferGeometry, materials: Materials, pixels: () => number): Points {
  geometry.setAttribute("position", positionsOf(merged.positions));
  if (merged.indices) geometry.setIndex(new BufferAttribute(merged.indices, 1));
  if (typeof merged.slots !== "number") geometry.setAttribute("slot", new BufferAttribute(merged.slots, 1));
  const points = new Points(geometry, materials.points);
  const isControl = merged.kind === "controlPoints";
  const size = merged.width || (isControl ? CONTROL_POINT : POINT);
  points.onBeforeRender = () => {
    materials.setLook(materials.points, merged.slots);
    const { isQuick } = materials;
    uniform(materials.points, "uWidth", Math.round((isQuick ? Math.min(size, QUICK_POINT) : size) * pixels()));
    uniform(materials.points, "uStroke", Math.max(1, Math.round((isControl ? 1.2 : 1.5) * pixels())));
    uniform(materials.points, "uShape", isQuick ? SHAPE.dot : isControl ? SHAPE.square : SHAPE.cross);
  };
  points.renderOrder = 1;
  return still(points);
}

function linesOf(
  merged: Merged,
  own: Owner,
  materials: Materials,
  budget: Budget,
  pixels: () => number,
): Drawn[] {
  const used = merged.indices?.length ?? merged.positions.length / 3;
  const width = merged.width || (THINNER[merged.kind] ?? LINE);
  const isWide = used / 2 <= budget.wide && !(budget.areDraftsThin && merged.isDraft);
  const fade = fadeOf(merged, materials);
  const objects: Drawn[] = [
    isWide ? wideLines(merged, own, materials, budget, width, pixels, fade) : thinLines(merged, own, materials, fade),
  ];
  if (merged.kind === "arrows") objects.push(heads(merged, own, materials, pixels));
  return objects;
}

/** How strongly lines are drawn for a camera. */
type Fade = (camera: Camera, lines: Drawn) => number;

const WHOLE: Fade = () => 1;

/** Edges and isocurves become fainter where they would cover what they bound; other lines are what is to be seen. */
function fadeOf({ kind, positions, indices, bounds }: Merged, materials: Materials): Fade {
  if ((kind !== "edges" && kind !== "isocurves") || !bounds) return WHOLE;
  const length = lengthOf(positions, indices);
  const size = radius(bounds);
  const middle = new Vector3(...centre(bounds));
  const seen = new Vector3();
  return (camera, lines) => {
    seen.copy(middle).applyMatrix4(lines.matrixWorld).applyMatrix4(camera.matrixWorldInverse);
    const { elements } = camera.projectionMatrix;
    const depth = elements[15] === 1 ? 1 : Math.max(-seen.z, size * 0.1);
    return fadeAt(length, size, ((elements[5] ?? 1) * materials.shared.uView.value.y) / 2 / depth);
  };
}

function lengthOf(positions: Float32Array, indices: Merged["indices"]): number {
  const count = indices?.length ?? positions.length / 3;
  const at = (k: number, axis: number) => positions[(indices ? (indices[k] ?? 0) : k) * 3 + axis] ?? 0;
  let sum = 0;
  for (let k = 0; k + 1 < count; k += 2) sum += Math.hypot(at(k + 1, 0) - at(k, 0), at(k + 1, 1) - at(k, 1), at(k + 1, 2) - at(k, 2));
  return sum;
}

function thinLines(merged: Merged, own: Owner, materials: Materials, fade: Fade): Drawn {
  const geometry = own(new BufferGeometry());
  geometry.setAttribute("position", positionsOf(merged.positions));
  if (merged.indices) geometry.setIndex(new BufferAttribute(merged.indices, 1));
  if (typeof merged.slots !== "number") geometry.setAttribute("slot", new BufferAttribute(merged.slots, 1));
  const lines = new LineSegments(geometry, materials.thin);
  lines.onBeforeRender = (_renderer, _scene, camera) => {
    materials.setLook(materials.thin, merged.slots);
    uniform(materials.thin, "uFade", fade(camera, lines));
  };
  return still(lines);
}

/**
 * The rectangle of a segment: its corners as `WIDE_VERTEX` reads them, and the two triangles between them. Each geometry
 * has its own buffers, because with a geometry all its buffers go.
 */
const CORNERS = [-1, 0, -1, 1, 0, -1, 1, 1, 1, -1, 1, 1];
const SIDES = [0, 1, 2, 0, 2, 3];

function wideLines(
  merged: Merged,
  own: Owner,
  materials: Materials,
  { areInstances }: Budget,
  width: number,
  pixels: () => number,
  fade: Fade,
): Drawn {
  const segments = segmentsOf(merged);
  const slots = typeof merged.slots === "number" ? undefined : segmentSlots(merged.slots, merged.indices);
  const lines = new Mesh(own(areInstances ? instances(segments, slots) : rectangles(segments, slots)), materials.wide);
  lines.onBeforeRender = (_renderer, _scene, camera) => {
    materials.setLook(materials.wide, merged.slots);
    uniform(materials.wide, "uFade", fade(camera, lines));
    uniform(materials.wide, "uWidth", width * pixels());
  };
  return still(lines);
}

/** One rectangle, and where each segment has it. */
function instances(segments: Float32Array, slots: Uint16Array | undefined): BufferGeometry {
  const geometry = new InstancedBufferGeometry();
  const buffer = new InstancedInterleavedBuffer(segments, 6, 1);
  geometry.setAttribute("position", new BufferAttribute(Float32Array.from(CORNERS), 3));
  geometry.setIndex(new BufferAttribute(Uint16Array.from(SIDES), 1));
  geometry.setAttribute("from", new InterleavedBufferAttribute(buffer, 3, 0));
  geometry.setAttribute("to", new InterleavedBufferAttribute(buffer, 3, 3));
  geometry.instanceCount = segments.length / 6;
  if (slots) geometry.setAttribute("slot", new InstancedBufferAttribute(slots, 1));
  return geometry;
}

/** Each rectangle for itself: software draws instances one by one, each as slowly as a whole model. */
function rectangles(segments: Float32Array, slots: Uint16Array | undefined): BufferGeometry {
  const count = segments.length / 6;
  const ends = new Float32Array(count * 24);
  const corners = new Int8Array(count * 12);
  const sides = new Uint32Array(count * 6);
  const colours = slots && new Uint16Array(count * 4);
  for (let at = 0; at < count; at++) {
    const segment = segments.subarray(at * 6, at * 6 + 6);
    for (let corner = 0; corner < 4; corner++) ends.set(segment, at * 24 + corner * 6);
    corners.set(CORNERS, at * 12);
    for (let k = 0; k < 6; k++) sides[at * 6 + k] = at * 4 + (SIDES[k] ?? 0);
    colours?.fill(slots?.[at] ?? 0, at * 4, at * 4 + 4);
  }
  const geometry = new BufferGeometry();
  const buffer = new InterleavedBuffer(ends, 6);
  geometry.setAttribute("position", new BufferAttribute(corners, 3));
  geometry.setIndex(new BufferAttribute(sides, 1));
  geometry.setAttribute("from", new InterleavedBufferAttribute(buffer, 3, 0));
  geometry.setAttribute("to", new InterleavedBufferAttribute(buffer, 3, 3));
  if (colours) geometry.setAttribute("slot", new BufferAttribute(colours, 1));
  return geometry;
}

function heads(
  merged: Merged,
  own: Owner,
  materials: Materials,
  pixels: () => number,
): Drawn {
  const segments = segmentsOf(merged);
  const geometry = own(new BufferGeometry());
  const buffer = new InterleavedBuffer(segments, 6);
  buffer.setUsage(DynamicDrawUsage);
  geometry.setAttribute("from", new InterleavedBufferAttribute(buffer, 3, 0));
  geometry.setAttribute("to", new InterleavedBufferAttribute(buffer, 3, 3));
  geometry.setDrawRange(0, segments.length / 6);
  if (typeof merged.slots !== "number") {
    geometry.setAttribute("slot", new BufferAttribute(segmentSlots(merged.slots, merged.indices), 1));
  }
  const points = new Points(geometry, materials.head);
  points.onBeforeRender = () => {
    materials.setLook(materials.head, merged.slots);
    uniform(materials.head, "uWidth", HEAD * pixels());
  };
  return still(points);
}

function uniform(material: RawShaderMaterial, name: string, value: number): void {
  const entry = material.uniforms[name];
  if (!entry || entry.value === value) return;
  entry.value = value;
  material.uniformsNeedUpdate = true;
}

function still<T extends Object3D>(object: T): T {
  object.matrixAutoUpdate = false;
  return object;
}
