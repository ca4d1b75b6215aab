/** False colours: the numbers at the positions of every surface, and the range they are coloured over. */

import { estimateCurvatures, principal, type Curvatures } from "../core/curvature";
import { usefulRange } from "../core/falseColour";
import type { PreviewPart } from "../core/preview";
import type { Model } from "./scene/model";
import type { Analysis } from "./settings";
import { isOfDocument } from "./tools/beside";
import type { CurvatureAnswer, CurvatureQuestion } from "./tools/curvature.worker";

export interface Coloured {
  range: readonly [number, number];
  /** Whether all numbers are the kernel's own. */
  exact: boolean;
}

/** Meshes of more triangles are looked at beside the page. */
const LARGE = 10_000;

export class FalseColours {
  #known = new WeakMap<PreviewPart, Curvatures | "on its way">();
  #principals = new WeakMap<PreviewPart, { greater?: Float32Array; lesser?: Float32Array }>();
  #waiting = new Map<number, PreviewPart>();
  #worker: Worker | undefined;
  #next = 0;
  #arrived: () => void;

  /** `arrived` is called when numbers have come that were on their way. */
  constructor(arrived: () => void) {
    this.#arrived = arrived;
  }

  /** Gives each surface its numbers; undefined where nothing has any yet. */
  colour(model: Model, analysis: Analysis): Coloured | undefined {
    const all: Float32Array[] = [];
    let exact = true;
    for (const { id, parts } of model.objects.values()) {
      for (const entry of parts) {
        if (entry.part.kind !== "mesh" || !isOfDocument(id)) continue;
        const found = this.#numbers(entry.part, analysis);
        model.setValues(entry, found?.values ?? null);
        if (!found || model.table.get(entry.slot)[3] === 0) continue;
        all.push(found.values);
        exact &&= found.exact;
      }
    }
    const range = usefulRange(all);
    return range && { range, exact };
  }

  dispose(): void {
    this.#worker?.terminate();
    this.#waiting.clear();
  }

  #numbers(part: PreviewPart, analysis: Analysis): { values: Float32Array; exact: boolean } | undefined {
    if (analysis === "none" || analysis === "zebra") return undefined;
    const { values: gaussian, mean } = part;
    const exact = gaussian !== null && mean !== null;
    const known = exact ? { gaussian, mean } : (this.#known.get(part) ?? this.#estimate(part));
    if (!known || known === "on its way") return undefined;
    return { values: analysis === "gaussian" || analysis === "mean" ? known[analysis] : this.#principal(part, known, analysis), exact };
  }

  #principal(part: PreviewPart, curvatures: Curvatures, which: "greater" | "lesser"): Float32Array {
    const own = this.#principals.get(part) ?? {};
    const found = own[which] ?? principal(curvatures, which);
    this.#principals.set(part, { ...own, [which]: found });
    return found;
  }

  #estimate(part: PreviewPart): Curvatures | undefined {
    const { positions, normals, indices } = part;
    if (!normals) return undefined;
    if ((indices?.length ?? positions.length / 3) / 3 <= LARGE) {
      const found = estimateCurvatures(positions, normals, indices);
      this.#known.set(part, found);
      return found;
    }
    this.#known.set(part, "on its way");
    this.#worker ??= this.#start();
    const id = this.#next++;
    this.#waiting.set(id, part);
    // Copies, of the arrays alone and not of all the bytes that they are views of.
    const question: CurvatureQuestion = { id, positions: positions.slice(), normals: normals.slice(), indices: indices?.slice() ?? null };
    const transfer = [question.positions.buffer, question.normals.buffer, question.indices?.buffer];
    this.#worker.postMessage(question, { transfer: transfer.filter((buffer) => buffer !== undefined) });
    return undefined;
  }

  #start(): Worker {
    const worker = new Worker(new URL("./tools/curvature.worker.ts", import.meta.url), { type: "module" });
    worker.onmessage = ({ data: { id, gaussian, mean } }: MessageEvent<CurvatureAnswer>) => {
      const part = this.#waiting.get(id);
      if (!part) return;
      this.#waiting.delete(id);
      this.#known.set(part, { gaussian, mean });
      this.#arrived();
    };
    return worker;
  }
}
