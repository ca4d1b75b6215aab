import { useStore } from "zustand";

import { action } from "../actions/registry";
import { isStarved, lookOf, type Look } from "../core/look";
import type { ObjectView } from "../core/protocol/ObjectView";
import { t } from "../i18n";
import { documentStore } from "../state/document";
import { modelStore } from "../state/model";
import { runStore, type Run } from "../state/run";
import { lineStore } from "../state/session";
import { settingsStore } from "./settings";

/** The line at the bottom: how the solve goes, what is wrong, the unit. */
export function Status() {
  const state = useStore(lineStore, (line) => line.state);
  const complaint = useStore(lineStore, (line) => line.complaint);
  const progress = useStore(runStore, (run) => run.progress);
  const cancelled = useStore(runStore, (run) => run.cancelled);
  const took = useStore(runStore, (run) => shownTime(run.milliseconds));
  const objects = useStore(documentStore, (mirror) => mirror.objects);
  const errors = useStore(runStore, (run) => count(objects, run, ["error"]));
  // Orange on the canvas is a warning here: with Grasshopper's users an object without data has one.
  const warnings = useStore(runStore, (run) => count(objects, run, ["warning", "empty"]));
  const model = useStore(modelStore, (store) => store.model?.name);
  const view = useStore(documentStore, (mirror) => mirror.document);
  const said = () => {
    if (state === "lost") return t("line.lost");
    if (state === "joining") return t("line.joining");
    if (complaint) return complaint;
    if (progress) return t("status.solving", { ...progress });
    if (view?.locked) return t("status.locked");
    return cancelled ? t("status.cancelled") : t("status.solved", { ms: took });
  };
  return (
    <footer className="status">
      <span className="grow" role="status">
        {said()}
      </span>
      {progress && (
        <>
          <progress max={progress.total} value={progress.done} aria-label={t("status.progress")} />
          <button type="button" onClick={() => void action("solution.cancel")?.run()}>
            {t("action.cancel")}
          </button>
        </>
      )}
      <button type="button" className="quiet problems" onClick={() => settingsStore.setState({ side: "problems" })}>
        <span aria-hidden="true" className={errors > 0 ? "error" : undefined}>
          ✖ {errors}
        </span>
        <span aria-hidden="true" className={warnings > 0 ? "warning" : undefined}>
          ⚠ {warnings}
        </span>
        <span className="unseen">{t("status.problems", { errors, warnings })}</span>
      </button>
      {model && (
        <span role="status" className="model">
          {t("status.model", { name: model })}
        </span>
      )}
      {view && <span className="units">{t("status.units", { units: view.units, tolerance: view.tolerance })}</span>}
    </footer>
  );
}

/** How many objects look so. Exported for tests. */
export function count(objects: ReadonlyMap<string, ObjectView>, { results, outputs }: Run, looks: readonly Look[]): number {
  let found = 0;
  for (const object of objects.values()) {
    if (looks.includes(lookOf(object, results.get(object.id), isStarved(object, outputs)))) found += 1;
  }
  return found;
}

/** Milliseconds as people read them. Exported for tests. */
export function shownTime(milliseconds: number): string {
  if (milliseconds < 1) return "< 1 ms";
  return milliseconds < 1000 ? `${Math.round(milliseconds)} ms` : `${(milliseconds / 1000).toFixed(1)} s`;
}
