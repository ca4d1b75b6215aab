/** Notes in the page what came over the socket and when a picture was drawn, without touching the page's own code. */
import type { Page } from "@playwright/test";

import type { ObjectView } from "../src/core/protocol/ObjectView";
import type {} from "../src/viewport/current";

export interface Watched {
  /** When the last input event arrived. */
  input: number;
  /** When the last solve was heard of, and how long it took on the server. */
  solved: number;
  took: number;
  /** When the last geometry was named. */
  previews: number;
  count: number;
  /** When the frame was handed over whose picture came after it. */
  drawn: number;
  /** Whether the last change is in a picture, and how long it took to solve is known: that may be heard of later. */
  isWhole(): boolean;
  /** The ids of the document's sliders. */
  sliders: string[];
}

declare global {
  interface Window {
    watched: Watched;
    /** Notes how long each frame takes, from one to the next, between start and stop. */
    frameTimes: { start(): void; stop(): number[] };
  }
}

export async function watch(page: Page): Promise<void> {
  await page.addInitScript(() => {
    const watched: Watched = {
      input: 0, solved: 0, took: 0, previews: 0, count: 0, drawn: 0, sliders: [],
      isWhole: () => watched.drawn > watched.previews && watched.solved > watched.input,
    };
    window.watched = watched;
    let frames: number[] | undefined;
    let last = 0;
    const frame = (now: number) => {
      if (!frames) return;
      if (last > 0) frames.push(now - last);
      last = now;
      requestAnimationFrame(frame);
    };
    window.frameTimes = {
      start() {
        [frames, last] = [[], 0];
        requestAnimationFrame(frame);
      },
      stop() {
        const found = frames ?? [];
        frames = undefined;
        return found;
      },
    };
    // Browsers tell of a pointer that rests when what is under it moves: only what a hand did counts.
    let place = "";
    const note = (event: Event) => {
      const now = event instanceof PointerEvent ? `${event.type} ${event.clientX} ${event.clientY}` : "";
      if (now === place && now !== "") return;
      place = now;
      watched.input = event.timeStamp;
    };
    for (const kind of ["pointermove", "pointerdown", "keydown", "change"]) addEventListener(kind, note, { capture: true });
    const Plain = window.WebSocket;
    window.WebSocket = class extends Plain {
      constructor(...of: ConstructorParameters<typeof WebSocket>) {
        super(...of);
        this.addEventListener("message", ({ data }: MessageEvent) => {
          if (typeof data !== "string") return;
          const start = data.slice(0, 40);
          if (start.includes('"preview"')) {
            watched.previews = performance.now();
            watched.count += 1;
            wait(window.__studio?.viewport?.stats()?.frames ?? 0);
          } else if (start.includes('"document"')) {
            const { objects } = JSON.parse(data) as { objects: ObjectView[] };
            watched.sliders = objects.filter(({ control }) => control?.is === "slider").map(({ id }) => id);
          } else if (start.includes('"results"') && /"finished":true/.test(data.slice(-200))) {
            watched.solved = performance.now();
            watched.took = Number(/"milliseconds":([\d.e-]+)\}?$/.exec(data)?.[1] ?? 0);
          }
        });
      }
    };
    /** Notes when a frame with a picture that came later was handed over: the first task after it runs then. */
    function wait(before: number): void {
      const { port1, port2 } = new MessageChannel();
      port1.onmessage = () => {
        if ((window.__studio?.viewport?.stats()?.frames ?? 0) > before) watched.drawn = performance.now();
        else requestAnimationFrame(() => port2.postMessage(0));
      };
      requestAnimationFrame(() => port2.postMessage(0));
    }
  });
}

/** The value below which so large a part of them lies. */
export function share(list: readonly number[], part: number): number {
  const sorted = [...list].sort((a, b) => a - b);
  return sorted[Math.round((sorted.length - 1) * part)] ?? Number.NaN;
}
