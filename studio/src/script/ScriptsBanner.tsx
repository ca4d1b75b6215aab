import { useStore } from "zustand";

import { showDialog } from "../dialogs/store";
import { t } from "../i18n";
import { documentStore } from "../state/document";
import { allowScripts } from "./allow";

/** Asks whether the scripts of a definition may run: once, until somebody has said. */
export function ScriptsBanner() {
  const scripts = useStore(documentStore, (mirror) => mirror.document?.scripts);
  if (scripts?.permission !== "asked") return null;
  return (
    <div className="banner warning" role="alert">
      <p>{t("script.ask", { n: scripts.count })}</p>
      <button type="button" className="primary" onClick={() => showDialog("scripts")}>
        {t("script.ask.show")}
      </button>
      <button type="button" onClick={() => void allowScripts(true, true)}>
        {t("script.ask.allow")}
      </button>
      <button type="button" onClick={() => void allowScripts(false, false)}>
        {t("script.ask.refuse")}
      </button>
    </div>
  );
}
