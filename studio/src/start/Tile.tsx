import { useState } from "react";

import { t } from "../i18n";

interface TileProps {
  title: string;
  lines?: readonly string[];
  /** Its picture: as this browser saw it last, else as the server draws it. */
  picture: string | undefined;
  /** Whether it has edits that are not saved. */
  changed?: boolean;
  open(): void;
  close?(): void;
}

/** A definition to open: its picture, where there is one, and its name. */
export function Tile({ title, lines = [], picture, changed = false, open, close }: TileProps) {
  // What is not saved is not thrown away by one click.
  const [asked, setAsked] = useState(false);
  const [isMissing, setMissing] = useState(false);
  const label = t(asked ? "start.closeChanged" : "start.close", { name: title });
  return (
    <li>
      <button type="button" className="tile" onClick={open}>
        {picture === undefined || isMissing ? (
          <span className="blank" aria-hidden="true" />
        ) : (
          <img src={picture} alt="" width={320} height={200} loading="lazy" decoding="async" onError={() => setMissing(true)} />
        )}
        <strong>
          {changed && <span aria-label={t("document.changed")}>• </span>}
          {title}
        </strong>
        {lines.map((line) => (
          <small key={line}>{line}</small>
        ))}
      </button>
      {close && (
        <button
          type="button"
          className="quiet shut"
          title={label}
          aria-label={label}
          onClick={() => (changed && !asked ? setAsked(true) : close())}
          onBlur={() => setAsked(false)}
        >
          {asked ? t("start.discard") : "✕"}
        </button>
      )}
    </li>
  );
}
