import { t } from "../i18n";

/** What the marks of the scatter mean: each has a shape of its own. */
export function Key({ hasFront, hasFailed }: { hasFront: boolean; hasFailed: boolean }) {
  return (
    <ul className="key">
      <li><svg viewBox="0 0 16 16"><circle cx="8" cy="8" r="4" className="dot" /></svg>{t("study.key.selected")}</li>
      <li><svg viewBox="0 0 16 16"><circle cx="8" cy="8" r="2.5" className="pale" /></svg>{t("study.key.other")}</li>
      {hasFailed && <li><svg viewBox="0 0 16 16"><path d="M4 4l8 8M12 4l-8 8" className="cross" /></svg>{t("study.key.failed")}</li>}
      {hasFront && <li><svg viewBox="0 0 16 16"><path d="M8 2l6 6-6 6-6-6z" className="diamond" /></svg>{t("study.key.front")}</li>}
      <li><svg viewBox="0 0 16 16"><circle cx="8" cy="8" r="6" className="ring" /></svg>{t("study.key.current")}</li>
    </ul>
  );
}
