import { useStore } from "zustand";

import { action } from "../actions/registry";
import { t } from "../i18n";
import { documentStore } from "../state/document";
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
  const errors = useStore(runStore, (run) => count(run, "error"));
  const warnings = useStore(runStore, (run) => count(run, "warning"));
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
      <button type="button" onClick={() => settingsStore.setState({ side: "problems" })}>
        <span aria-hidden="true">✖ {errors} ⚠ {warnings}</span>
        <span className="unseen">{t("status.problems", { errors, warnings })}</span>
      </button>
      {view && <span>{t("status.units", { units: view.units, tolerance: view.tolerance })}</span>}
    </footer>
  );
}

function count({ results }: Run, status: string): number {
  let found = 0;
  for (const result of results.values()) if (result.status === status) found += 1;
  return found;
}

/** Milliseconds as people read them. Exported for tests. */
export function shownTime(milliseconds: number): string {
  if (milliseconds < 1) return "< 1 ms";
  return milliseconds < 1000 ? `${Math.round(milliseconds)} ms` : `${(milliseconds / 1000).toFixed(1)} s`;
}
