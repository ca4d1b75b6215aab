import { useEffect, useState } from "react";

import { goTo, place, readStart, type Start } from "../app";
import { t } from "../i18n";
import { Dialog } from "./Dialog";

/** The documents that the server has open: one press goes to another. */
export function Documents() {
  const [open, setOpen] = useState<Start["open"]>();
  const [wrong, setWrong] = useState<string>();
  const here = place(location.search).document;
  useEffect(() => {
    readStart().then(
      (start) => setOpen(start.open),
      (error: unknown) => setWrong(error instanceof Error ? error.message : String(error)),
    );
  }, []);
  return (
    <Dialog title={t("documents.title")}>
      <ul className="documents">
        {open?.map(({ id, name, changed }) => (
          <li key={id}>
            <button type="button" aria-current={id === here ? "page" : undefined} disabled={id === here} onClick={() => goTo(id)}>
              <span>{name || t("document.unnamed")}</span>
              <small>{[id === here ? t("documents.here") : "", changed ? t("documents.changed") : ""].filter(Boolean).join(", ")}</small>
            </button>
          </li>
        ))}
      </ul>
      {open && open.every(({ id }) => id === here) ? <p>{t("documents.none")}</p> : null}
      {wrong ? <p role="alert">{wrong}</p> : null}
      <footer>
        <button type="button" onClick={() => goTo(undefined)}>
          {t("documents.start")}
        </button>
      </footer>
    </Dialog>
  );
}
