import { useEffect, useState } from "react";
import { useStore } from "zustand";

import type { ScriptView } from "../core/protocol/ScriptView";
import { Dialog } from "../dialogs/Dialog";
import { showDialog } from "../dialogs/store";
import { t } from "../i18n";
import { documentStore } from "../state/document";
import { ask, lineStore } from "../state/session";
import { allowScripts } from "./allow";
import "./script.css";

/** The scripts of a definition with what they import, and the question whether they may run. */
export function ScriptsDialog() {
  const [scripts, setScripts] = useState<ScriptView[]>([]);
  const [keep, setKeep] = useState(true);
  const [wrong, setWrong] = useState<string>();
  const permission = useStore(documentStore, (mirror) => mirror.document?.scripts?.permission);
  useEffect(() => {
    ask({ ask: "scripts" }).then(
      (answer) => answer.event === "scripts" && setScripts(answer.scripts),
      () => undefined,
    );
  }, []);
  const answer = async (run: boolean) => {
    if (await allowScripts(run, keep)) showDialog(undefined);
    else setWrong(lineStore.getState().complaint);
  };
  return (
    <Dialog title={t("scripts.title")} wide className="scripts">
      <p>{t("scripts.what")}</p>
      {permission === "given" && <p>{t("script.given")}</p>}
      {permission === "refused" && <p>{t("script.refused")}</p>}
      {scripts.map((script, at) => (
        <article key={at}>
          <h3>
            {script.title} <small>{script.language}</small>
          </h3>
          <p className="imports">
            {script.imports.length === 0 ? t("script.imports.none") : `${t("script.imports")}: `}
            {script.imports.map((name) => (
              <code key={name}>{name}</code>
            ))}
          </p>
          <pre tabIndex={0} aria-label={script.title}>
            {script.text === "" ? t("script.fromWire") : script.text}
          </pre>
        </article>
      ))}
      {wrong && <p role="alert">{wrong}</p>}
      <footer>
        <label>
          <input type="checkbox" checked={keep} onChange={(event) => setKeep(event.target.checked)} />
          {t("script.ask.keep")}
        </label>
        <button type="button" onClick={() => void answer(false)}>
          {t("script.ask.refuse")}
        </button>
        <button type="button" className="primary" onClick={() => void answer(true)}>
          {t("script.ask.allow")}
        </button>
      </footer>
    </Dialog>
  );
}
