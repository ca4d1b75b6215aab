import { useStore } from "zustand";

import { t } from "../i18n";
import { documentStore } from "../state/document";
import { ask, lineStore } from "../state/session";
import { ScriptsBanner } from "../script/ScriptsBanner";
import { settingsStore } from "./settings";

/** What must be seen at once: the connection is lost; edits were restored; add-ons are missing. */
export function Banners() {
  const state = useStore(lineStore, (line) => line.state);
  const restored = useStore(documentStore, (mirror) => mirror.restored);
  const problems = useStore(documentStore, (mirror) => mirror.problems);
  const missing = useStore(documentStore, ({ objects }) => [...objects.values()].filter(({ support }) => support.is === "no").length);
  const seen = useStore(settingsStore, (settings) => settings.side === "problems");
  const settle = async (keep: boolean) => {
    await ask({ ask: "settle", keep });
    documentStore.setState({ restored: null });
  };
  return (
    <div>
      {state === "lost" && (
        <div className="banner error" role="alert">
          <p>{t("line.lost")}</p>
        </div>
      )}
      {restored && (
        <div className="banner warning" role="alert">
          <p>{t("restored.text", { steps: restored.steps, at: new Date(restored.at * 1000).toLocaleString() })}</p>
          <button type="button" className="primary" onClick={() => void settle(true)}>
            {t("restored.keep")}
          </button>
          <button type="button" onClick={() => void settle(false)}>
            {t("restored.discard")}
          </button>
        </div>
      )}
      <ScriptsBanner />
      {missing + problems.length > 0 && !seen && (
        <div className="banner warning" role="status">
          <p>{missing > 0 ? t("missing.text", { n: missing }) : t("missing.problems", { n: problems.length })}</p>
          <button type="button" onClick={() => settingsStore.setState({ side: "problems" })}>
            {t("missing.show")}
          </button>
        </div>
      )}
    </div>
  );
}
