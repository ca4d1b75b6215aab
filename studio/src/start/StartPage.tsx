import { useEffect, useState } from "react";

import { DropZone, take } from "../app/DropZone";
import { DEFINITIONS, goTo, open, readStart, type Opening, type Start } from "../app/files";
import { t } from "../i18n";
import { lineStore } from "../state/session";
import { useStore } from "zustand";
import "./start.css";

/** Where one begins: a new definition, a file, what was open lately, or one from the book. */
export function StartPage() {
  const [start, setStart] = useState<Start>();
  const [path, setPath] = useState("");
  const complaint = useStore(lineStore, (line) => line.complaint);
  const complain = (error: unknown) =>
    lineStore.setState({ complaint: error instanceof Error ? error.message : String(error) });
  useEffect(() => {
    document.title = t("app.title");
    readStart().then(setStart, complain);
  }, []);
  const go = (what: Opening) => open(what).then((id) => goTo(id), complain);
  const groups = [...new Set(start?.gallery.map((entry) => entry.group))];
  return (
    <main className="start" tabIndex={-1}>
      <header>
        <h1>{t("app.title")}</h1>
        <p>{t("start.what")}</p>
      </header>
      <p role="alert" className="complaint">
        {complaint}
      </p>
      <section aria-label={t("start.begin")} className="begin">
        <button type="button" className="primary" onClick={() => void go({ new: true })}>
          {t("start.new")}
        </button>
        <label className="button">
          {t("start.openFile")}
          <input
            type="file"
            accept={DEFINITIONS.join(",")}
            className="unseen"
            onChange={(event) => {
              const file = event.target.files?.[0];
              if (file) void take(file);
            }}
          />
        </label>
        {start?.local && (
          <form
            onSubmit={(event) => {
              event.preventDefault();
              void go({ path: path.trim() });
            }}
          >
            <label>
              <span className="unseen">{t("start.path")}</span>
              <input
                type="text"
                spellCheck={false}
                placeholder={t("start.path")}
                value={path}
                onChange={(event) => setPath(event.target.value)}
              />
            </label>
            <button type="submit" disabled={path.trim() === ""}>
              {t("start.openPath")}
            </button>
          </form>
        )}
      </section>
      {start && start.open.length > 0 && (
        <section>
          <h2>{t("start.open")}</h2>
          <ul className="tiles">
            {start.open.map(({ id, name, changed }) => (
              <li key={id}>
                <button type="button" onClick={() => goTo(id)}>
                  {changed && "• "}
                  {name || t("document.unnamed")}
                </button>
              </li>
            ))}
          </ul>
        </section>
      )}
      {start && start.recent.length > 0 && (
        <section>
          <h2>{t("start.recent")}</h2>
          <ul className="tiles">
            {start.recent.map(({ path: at, name, modified }) => (
              <li key={at}>
                <button type="button" onClick={() => void go({ path: at })}>
                  <strong>{name}</strong>
                  <small>{at}</small>
                  <small>{new Date(modified * 1000).toLocaleString()}</small>
                </button>
              </li>
            ))}
          </ul>
        </section>
      )}
      {groups.map((group) => (
        <section key={group}>
          <h2>{group}</h2>
          <ul className="tiles">
            {start?.gallery
              .filter((entry) => entry.group === group)
              .map(({ id, title, description }) => (
                <li key={id}>
                  <button type="button" onClick={() => void go({ gallery: id })}>
                    <strong>{title}</strong>
                    <small>{description}</small>
                  </button>
                </li>
              ))}
          </ul>
        </section>
      ))}
      <footer>
        <p>
          {t("about.privacy")} {start && t("start.version", { version: start.version })}
        </p>
      </footer>
      <DropZone />
    </main>
  );
}
