/** Arrows along which places of the model move with the input that is looked at. */

import { arrowLines } from "../../core/motion";
import type { Point3, Preview } from "../../core/preview";
import { studyStore } from "../../state/study";

/** Where arrows are drawn. */
export interface ArrowScene {
  show(preview: Preview | undefined): void;
  /** The size of the model. */
  size(): number;
}

export class MotionArrows {
  #scene: ArrowScene;
  #stop: () => void;

  constructor(scene: ArrowScene) {
    this.#scene = scene;
    this.#stop = studyStore.subscribe((now, before) => now.motion !== before.motion && this.#draw());
    this.#draw();
  }

  dispose(): void {
    this.#stop();
  }

  #draw(): void {
    const arrows = studyStore.getState().motion?.view.arrows ?? [];
    const origin: Point3 = arrows[0]?.at ?? [0, 0, 0];
    // A model of one point has no size.
    const lines = arrowLines(arrows, this.#scene.size() || 10, origin);
    if (lines.length === 0) return this.#scene.show(undefined);
    const part = {
      kind: "circles" as const, width: 1.6, positions: Float32Array.from(lines), colour: null, normals: null, colours: null,
      values: null, mean: null, indices: null, texts: [], textHeight: 0, pieces: [],
    };
    this.#scene.show({ object: "", origin, bounds: null, draft: false, parts: [part], size: 0 });
  }
}
