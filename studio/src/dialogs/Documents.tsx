import { useEffect, useState } from "react";

import { goTo, place, readStart, type Start } from "../app";
import { t } from "../i18n";
import { pictures } from "../state/pictures";
import { Dialog } from "./Dialog";

/** The documents that the server has open: one press goes to another. */
export function Documents() {
  const [start, setStart] = useState<Start>();
  const [seen] = useState(pictures);
  const open = start?.open;
  const [wrong, setWrong] = useState<string>();
  const here = place(location.search).document;
  useEffect(() => {
    readStart().then(
      setStart,
      (error: unknown) => setWrong(error instanceof Error ? error.message : String(error)),
    );
  }, []);
  return (
    <Dialog title={t("documents.title")}>
      <ul className="documents">
        {open?.map(({ id, name, changed }) => (
          <li key={id}>
            <button type="button" aria-current={id === here ? "page" : undefined} disabled={id === here} onClick={() => goTo(id)}>
              <Picture of={seen.get(start?.recent.find((one) => one.name === name)?.path ?? name)} />
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

/** What it made when this browser looked at it last. */
function Picture({ of }: { of: string | undefined }) {
  return of ? <img src={of} alt="" width={80} height={50} /> : <span className="blank" aria-hidden="true" />;
}
