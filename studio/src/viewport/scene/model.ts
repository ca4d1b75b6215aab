/** Everything that is drawn of the document: objects, their parts, and what three.js draws for them. */

import { Scene, Vector3, type Matrix4, type Object3D } from "three";

import { boundsOfPositions, centre, radius, union } from "../../core/bounds";
import type { Bounds, Point3, Preview, PreviewPart, Rgba } from "../../core/preview";
import { ALONE, Batch, batchKey } from "./batch";
import { ColourTable } from "./colourTable";
import { makeDrawable, ORDER, type Drawable, type Budget } from "./drawable";
import { Materials } from "./materials";
import { alone, type Member } from "./merge";

export interface ModelPart {
  part: PreviewPart;
  slot: number;
  bounds: Bounds | null;
  member: Member;
  /** Drawn alone, or with others. */
  drawable: Drawable | undefined;
  batch: Batch | undefined;
}

export interface ModelObject {
  id: string;
  preview: Preview;
  bounds: Bounds | null;
  parts: ModelPart[];
}

export type Passes = "own" | "solid" | "through";

/** From so many segments on lines take longer than surfaces. */
const MANY_LINES = 150_000;

/** How far off the origin of drawing may be, in sizes of the model, before everything is moved. */
const OFF = 50;

export class Model {
  readonly scene = new Scene();
  readonly table = new ColourTable();
  readonly materials: Materials;
  readonly objects = new Map<string, ModelObject>();
  /** What is drawn is moved by −origin, so that single precision is enough. */
  origin: Point3 = [0, 0, 0];
  bounds: Bounds | null = null;
  /** The plane that cuts the view, where there is one. */
  section: { normal: Point3; at: number } | undefined;
  /** Another number after each change of geometry. */
  version = 0;
  /** Whether surfaces are drawn that hide what is behind them. */
  hides = false;
  #batches = new Map<string, Batch[]>();
  #drawables = new Set<Drawable>();
  #budget: Budget;
  #pixels: () => number;
  #isChanged = false;

  constructor(budget: Budget, pixels: () => number) {
    this.#budget = budget;
    this.#pixels = pixels;
    this.scene.matrixAutoUpdate = false;
    this.materials = new Materials(this.table);
  }

  put(id: string, preview: Preview): ModelObject {
    this.drop(id);
    const object: ModelObject = { id, preview, bounds: preview.bounds, parts: [] };
    for (const part of preview.parts) {
      if (part.positions.length === 0) continue;
      const bounds = boundsOfPositions(part.positions, preview.origin);
      object.bounds = union(object.bounds, bounds);
      object.parts.push(this.#addPart(part, preview, bounds));
    }
    this.objects.set(id, object);
    this.#isChanged = true;
    return object;
  }

  drop(id: string): void {
    const object = this.objects.get(id);
    if (!object) return;
    for (const { drawable, batch, member, slot } of object.parts) {
      if (drawable) this.#removeDrawable(drawable);
      batch?.remove(member);
      this.table.give(slot);
    }
    this.objects.delete(id);
    this.#isChanged = true;
  }

  clear(): void {
    for (const id of [...this.objects.keys()]) this.drop(id);
  }

  setColour({ slot }: ModelPart, colour: Rgba): void {
    this.table.set(slot, colour);
  }

  /** Other numbers at the positions of a part, for false colours. */
  setValues(part: ModelPart, values: Float32Array | null): void {
    if (part.member.values === values) return;
    part.member.values = values;
    if (part.drawable) {
      part.drawable.setValues(values);
    } else if (part.batch) {
      part.batch.remove(part.member);
      part.batch = this.#join(part.member);
    }
  }

  /** Makes batches and bounds anew where something changed; to be called before drawing. */
  settle(): void {
    if (!this.#isChanged && ![...this.#batches.values()].flat().some((batch) => batch.isStale())) return;
    this.#isChanged = false;
    this.version++;
    this.bounds = null;
    for (const { bounds } of this.objects.values()) this.bounds = union(this.bounds, bounds);
    this.#rebase();
    for (const [key, batches] of this.#batches) {
      for (const batch of batches.filter((each) => each.isStale())) this.#remake(batch);
      const kept = batches.filter((batch) => batch.members.size > 0);
      if (kept.length > 0) this.#batches.set(key, kept);
      else this.#batches.delete(key);
    }
  }

  /** Prepares what shines through: the farthest first, each with its depth just before its colour. */
  sortSurfaces(view: Matrix4): void {
    const place = new Vector3();
    const surfaces = [...this.#drawables].filter(({ surface }) => surface);
    const depths = new Map(
      surfaces.map((drawable) => {
        place.copy(drawable.middle).applyMatrix4(drawable.objects[0]?.matrix ?? view).applyMatrix4(view);
        return [drawable, place.z] as const;
      }),
    );
    surfaces.sort((a, b) => (depths.get(a) ?? 0) - (depths.get(b) ?? 0));
    surfaces.forEach(({ surface }, rank) => {
      if (!surface) return;
      surface.depth.renderOrder = ORDER.surfaces + rank * 2;
      surface.colour.renderOrder = ORDER.surfaces + rank * 2 + 1;
    });
  }

  /**
   * Shows the passes that are needed: most documents have nothing opaque, or nothing that shines through. Surfaces are
   * drawn as their colours say (`own`), or all of them as if solid or translucent. A picture that is not fine does
   * without sorting out what is behind what in one surface.
   */
  choosePasses(how: Passes, isFine: boolean): void {
    // The quick lights are those of surfaces that are shaded or rendered: what analyses is drawn with all care.
    const { opaque, translucent } = !isFine && how !== "solid" ? this.materials.quick : this.materials;
    opaque.uniforms["uPass"]!.value = how === "solid" ? 2 : 0;
    translucent.uniforms["uPass"]!.value = how === "through" ? 2 : 1;
    const solid = new Set<Drawable>();
    const through = new Set<Drawable>();
    for (const { parts } of this.objects.values()) {
      for (const { drawable, batch, slot } of parts) {
        const target = drawable ?? batch?.drawable;
        const alpha = this.table.get(slot)[3];
        if (!target?.surface || alpha === 0) continue;
        const isSolid = how === "solid" || (how === "own" && alpha === 255);
        (isSolid ? solid : through).add(target);
      }
    }
    this.hides = solid.size > 0;
    const isOnSurface = ({ kind }: Drawable) => kind === "edges" || kind === "isocurves";
    const edges = [...this.#drawables].reduce((sum, each) => sum + (isOnSurface(each) ? each.segments : 0), 0);
    for (const drawable of this.#drawables) {
      // A quick picture does without very many lines, and without those behind surfaces; very many are never drawn there.
      const isMany = drawable.segments > MANY_LINES;
      if (!drawable.surface) {
        const isLeftOut = isMany || (isOnSurface(drawable) && edges > this.#budget.edges);
        for (const object of drawable.objects) object.visible = isFine || !isLeftOut;
        for (const object of drawable.behind) object.visible = through.size > 0 && isFine && !isMany;
        for (const object of isFine ? drawable.few : drawable.fine) object.visible = false;
        continue;
      }
      drawable.surface.solid.material = opaque;
      drawable.surface.colour.material = translucent;
      drawable.surface.solid.visible = solid.has(drawable);
      drawable.surface.colour.visible = through.has(drawable);
      drawable.surface.depth.visible = through.has(drawable) && how === "own" && isFine;
    }
  }

  counts(): { parts: number; triangles: number; segments: number; points: number; drawables: number } {
    const counts = { parts: 0, triangles: 0, segments: 0, points: 0, drawables: this.#drawables.size };
    for (const { parts } of this.objects.values()) counts.parts += parts.length;
    for (const { triangles, segments, points } of this.#drawables) {
      counts.triangles += triangles;
      counts.segments += segments;
      counts.points += points;
    }
    return counts;
  }

  dispose(): void {
    this.clear();
    this.settle();
    this.materials.dispose();
    this.table.dispose();
  }

  #addPart(part: PreviewPart, { origin, draft }: Preview, bounds: Bounds | null): ModelPart {
    const slot = this.table.take();
    const member: Member = { part, origin, bounds, slot, values: null, isDraft: draft };
    const entry: ModelPart = { part, slot, bounds, member, drawable: undefined, batch: undefined };
    if (part.kind === "texts") return entry;
    if (part.positions.length / 3 > ALONE) entry.drawable = this.#addDrawable(this.#make(alone(member)));
    else entry.batch = this.#join(member);
    return entry;
  }

  #make(merged: ReturnType<typeof alone>): Drawable {
    return makeDrawable(merged, this.materials, this.#budget, this.#pixels);
  }

  #join(member: Member): Batch {
    const key = batchKey(member.part, member.values !== null);
    const batches = this.#batches.get(key) ?? [];
    this.#batches.set(key, batches);
    let batch = batches.find((each) => !each.isFull());
    if (!batch) batches.push((batch = new Batch(key)));
    batch.add(member);
    return batch;
  }

  #remake(batch: Batch): void {
    const old = batch.remake((merged) => this.#make(merged));
    if (old) this.#removeDrawable(old);
    if (batch.drawable) this.#addDrawable(batch.drawable);
  }

  #addDrawable(drawable: Drawable): Drawable {
    this.#drawables.add(drawable);
    for (const object of drawable.objects) {
      this.#place(object, drawable.origin);
      this.scene.add(object);
    }
    return drawable;
  }

  #removeDrawable(drawable: Drawable): void {
    this.#drawables.delete(drawable);
    this.scene.remove(...drawable.objects);
    drawable.dispose();
  }

  #place(object: Object3D, origin: Point3): void {
    const [x, y, z] = this.origin;
    object.matrix.makeTranslation(origin[0] - x, origin[1] - y, origin[2] - z);
    object.matrixWorldNeedsUpdate = true;
  }

  /** Moves the origin of drawing to the model, when the model is small beside how far away it is. */
  #rebase(): void {
    if (!this.bounds) return;
    const middle = centre(this.bounds);
    const off = Math.hypot(...middle.map((value, axis) => value - (this.origin[axis] ?? 0)));
    if (off < OFF * Math.max(radius(this.bounds), 1e-9)) return;
    this.origin = middle;
    for (const drawable of this.#drawables) for (const object of drawable.objects) this.#place(object, drawable.origin);
  }
}
