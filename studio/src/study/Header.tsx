import { t } from "../i18n";
import { isGood, type Study } from "./core/rows";

/** The name of the study, how it stands, and what is left out. */
export function Header({ study }: { study: Study | undefined }) {
  if (!study) return <header className="study-header"><h1>Katydid</h1></header>;
  const { name, state, total, planned, rows, definition } = study;
  const isUnderWay = state === "running" || state === "stopped";
  const count = isUnderWay && planned !== null ? t("study.planned", { count: total, planned }) : t("study.count", { count: total });
  const failed = rows.filter((row) => !isGood(row)).length;
  return (
    <header className="study-header">
      <h1>{name}</h1>
      {definition && <span className="soft">{definition}</span>}
      <span className={`state ${state}`} role="status">{t(`study.state.${state}`)}</span>
      {isUnderWay && planned !== null && planned > 0 && <progress aria-label={t("study.progress")} max={planned} value={total} />}
      <span data-testid="count">{count}</span>
      {failed > 0 && <span className="failures">✕ {t("study.failed", { count: failed })}</span>}
      {rows.length < total && <p className="left-out">{t("study.leftOut", { shown: rows.length, total })}</p>}
    </header>
  );
}
