import { useEffect, useState } from "react";

import { DropZone, take } from "../app/DropZone";
import { close, DEFINITIONS, goTo, MODELS, open, portrait, readStart, type Opening, type Start } from "../app/files";
import { openNew } from "../app/template";
import { t } from "../i18n";
import { pictures } from "../state/pictures";
import { lineStore } from "../state/session";
import { useStore } from "zustand";
import { Hero, isHero } from "./Hero";
import { Tile } from "./Tile";
import "./start.css";

/** Where one begins: a new definition, a file, what was open lately, or one from the book. */
export function StartPage() {
  const [start, setStart] = useState<Start>();
  const [path, setPath] = useState("");
  const [seen] = useState(pictures);
  const complaint = useStore(lineStore, (line) => line.complaint);
  const complain = (error: unknown) =>
    lineStore.setState({ complaint: error instanceof Error ? error.message : String(error) });
  useEffect(() => {
    document.title = t("app.title");
    readStart().then(setStart, complain);
  }, []);
  const go = (what: Opening) => open(what).then((id) => goTo(id), complain);
  const shut = (id: string) => void close(id).then(readStart).then(setStart, complain);
  const opened = start?.open.filter((document) => !isHero(document)) ?? [];
  const groups = [...new Set(start?.gallery.map((entry) => entry.group))];
  return (
    <main className="start" tabIndex={-1}>
      <header>
        <img src="./icon.svg" alt="" width={40} height={40} />
        <h1>{t("app.title")}</h1>
        <p>{t("start.what")}</p>
      </header>
      <p role="alert" className="complaint">
        {complaint}
      </p>
      <section aria-label={t("start.begin")} className="begin">
        <button type="button" className="primary" onClick={() => void openNew().then(goTo, complain)}>
          {t("start.new")}
        </button>
        <label className="button">
          {t("start.openFile")}
          <input
            type="file"
            accept={[...DEFINITIONS, ...MODELS].join(",")}
            multiple
            className="unseen"
            onChange={(event) => {
              void take([...(event.target.files ?? [])]);
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
      {start && <Hero start={start} />}
      {opened.length > 0 && (
        <section>
          <h2>{t("start.open")}</h2>
          <ul className="tiles">
            {opened.map(({ id, name, changed }) => (
              <Tile
                key={id}
                title={name || t("document.unnamed")}
                picture={seen.get(start?.recent.find((one) => one.name === name)?.path ?? name)}
                changed={changed}
                open={() => goTo(id)}
                close={() => shut(id)}
              />
            ))}
          </ul>
        </section>
      )}
      {start && start.recent.length > 0 && (
        <section>
          <h2>{t("start.recent")}</h2>
          <ul className="tiles">
            {start.recent.map(({ path: at, name, modified }) => (
              <Tile
                key={at}
                title={name}
                lines={[at, new Date(modified * 1000).toLocaleString()]}
                picture={seen.get(at) ?? portrait({ recent: at })}
                open={() => void go({ path: at })}
              />
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
              .map(({ id, name, title, description }) => (
                <Tile
                  key={id}
                  title={title}
                  lines={[description]}
                  picture={seen.get(name) ?? portrait({ gallery: id })}
                  open={() => void go({ gallery: id })}
                />
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
