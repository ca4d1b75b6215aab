import { useMemo, useState } from "react";

import { t } from "../i18n";
import { fileAddress } from "./api";
import { cellText } from "./core/axes";
import type { Derived } from "./derived";
import { look, useChosen } from "./store";

/** So many pictures are shown, and so many more each time. */
const SOME = 48;

/** Small pictures of the selected points. */
export function Pictures({ study, places, front, onFront }: Derived) {
  const [most, setMost] = useState(SOME);
  const current = useChosen((chosen) => chosen.point);
  // Those on the front come first: they are what one looks for.
  const shown = useMemo(() => [...front, ...places.filter((place) => !onFront.has(place))].filter((place) => study.rows[place]?.picture), [study.rows, places, front, onFront]);
  const outputs = study.columns.flatMap(({ kind, name }, at) => (kind === "out" ? [{ name, at }] : [])).slice(0, 2);
  return (
    <section className="panel pictures" aria-labelledby="pictures-title">
      <div className="panel-head"><h2 id="pictures-title">{t("study.pictures")}</h2></div>
      {shown.length === 0 && <p className="soft">{t("study.pictures.none")}</p>}
      <ul className="multiples">
        {shown.slice(0, most).map((place) => {
          const row = study.rows[place];
          if (!row) return null;
          const said = outputs.map(({ name, at }) => `${name} ${cellText(row.cells[at])}`).join(", ");
          return (
            <li key={row.point}>
              <button type="button" aria-pressed={current === row.point} onClick={() => look(row.point)}>
                <img src={fileAddress(row.picture)} loading="lazy" width={160} height={120} alt="" />
                <span className="picture-name">{onFront.has(place) && <span className="mark">◆ <span className="unseen">{t("study.onFront")}</span></span>}{t("study.picture.of", { point: row.point })}</span>
                <span className="soft">{said}</span>
              </button>
            </li>
          );
        })}
      </ul>
      {shown.length > most && (
        <button type="button" onClick={() => setMost(most + SOME)}>{t("study.pictures.more", { count: Math.min(SOME, shown.length - most) })}</button>
      )}
    </section>
  );
}
