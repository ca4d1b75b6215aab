/**
 * Asks the session for what is looked at closely, as settings and selection have it: combs, circles, control points,
 * isocurves. The session keeps it up to date; here only the question changes. While one is on its way the newest waits.
 */

import type { AnalysisView } from "../../core/protocol/AnalysisView";
import { documentStore } from "../../state/document";
import { ask, lineStore } from "../../state/session";
import { uiStore } from "../../state/ui";
import { settingsStore, type ViewportSettings } from "../settings";

/** What is to be asked for; null for nothing. Exported for tests. */
export function questionOf(settings: ViewportSettings, selection: readonly string[]): AnalysisView | null {
  const { comb, combScale, combTeeth, combSurfaces, circles, controls, isocurves, directions, analysis, ofAll } = settings;
  const colours = analysis !== "none";
  const lines = isocurves > 0 || directions;
  if (!comb && circles === 0 && !controls && !lines && !colours) return null;
  return {
    objects: ofAll ? null : [...selection],
    comb: comb ? { teeth: combTeeth, length: combScale / 100, surfaces: combSurfaces } : null,
    circles,
    controls,
    isocurves: lines ? { between: isocurves, directions } : null,
    colours,
  };
}

export class Looker {
  #asked = "null";
  #isSending = false;
  #stops: (() => void)[];

  constructor() {
    const look = () => this.#look();
    this.#stops = [
      settingsStore.subscribe(look),
      uiStore.subscribe((now, before) => now.selection !== before.selection && look()),
      lineStore.subscribe((now, before) => {
        if (now.state === before.state) return;
        // Another end of the line knows nothing of what was asked.
        if (now.state !== "open") this.#asked = "null";
        look();
      }),
    ];
    look();
  }

  /** Nobody looks any more. */
  dispose(): void {
    for (const stop of this.#stops) stop();
    if (this.#asked !== "null" && lineStore.getState().state === "open") void ask({ ask: "analyse", analysis: null }).catch(() => {});
  }

  #look(): void {
    if (this.#isSending || lineStore.getState().state !== "open") return;
    const { objects } = documentStore.getState();
    const selection = [...uiStore.getState().selection].filter((id) => objects.has(id));
    const analysis = questionOf(settingsStore.getState(), selection);
    const text = JSON.stringify(analysis);
    if (text === this.#asked) return;
    this.#asked = text;
    this.#isSending = true;
    void ask({ ask: "analyse", analysis }).catch(() => {}).finally(() => {
      this.#isSending = false;
      this.#look();
    });
  }
}
