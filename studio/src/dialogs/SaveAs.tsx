import { engine } from "#engine";
import { useState, type FormEvent } from "react";
import { useStore } from "zustand";

import { download, place, type DownloadFormat } from "../app";
import { t } from "../i18n";
import { documentStore } from "../state/document";
import { ask } from "../state/session";
import { Dialog } from "./Dialog";
import { showDialog } from "./store";

const FORMATS: { format: DownloadFormat; label: "saveAs.gh" | "saveAs.ghx" | "saveAs.kd" }[] = [
  { format: "gh", label: "saveAs.gh" },
  { format: "ghx", label: "saveAs.ghx" },
  { format: "kd", label: "saveAs.kd" },
];

/** Saves on this machine under a path, or has the browser keep the file. */
export function SaveAs() {
  const view = useStore(documentStore, (mirror) => mirror.document);
  const [path, setPath] = useState(view?.path ?? "");
  const [wrong, setWrong] = useState<string>();
  const id = place(location.search).document;

  const save = async (event: FormEvent) => {
    event.preventDefault();
    try {
      await ask({ ask: "save", path: path.trim() });
      showDialog(undefined);
    } catch (error) {
      setWrong(error instanceof Error ? error.message : String(error));
    }
  };
  const keep = async (format: DownloadFormat) => {
    if (!id) return;
    try {
      await download(id, format);
      showDialog(undefined);
    } catch (error) {
      setWrong(error instanceof Error ? error.message : String(error));
    }
  };
  return (
    <Dialog title={t("saveAs.title")}>
      {!engine && <form onSubmit={(event) => void save(event)}>
        <label>
          {t("saveAs.path")}
          <input type="text" autoFocus spellCheck={false} value={path} onChange={(e) => setPath(e.target.value)} />
        </label>
        <small>{t("saveAs.hint")}</small>
        <button type="submit" className="primary" disabled={path.trim() === ""}>
          {t("saveAs.save")}
        </button>
      </form>}
      <h3>{t("saveAs.download")}</h3>
      <div className="row">
        {FORMATS.map(({ format, label }) => (
          <button key={format} type="button" onClick={() => void keep(format)}>
            {t(label)}
          </button>
        ))}
      </div>
      {wrong && <p role="alert">{wrong}</p>}
    </Dialog>
  );
}
