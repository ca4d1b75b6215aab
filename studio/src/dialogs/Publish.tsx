/** Which inputs the player shows, in which order, what they are called there and what is said of them. */

import { useState } from "react";

import { goTo } from "../app/files";
import { place } from "../app/place";
import { movedRow, publishedOf, rowsOf, type Row } from "../core/published";
import { t } from "../i18n";
import { playable } from "../player/groups";
import { documentStore } from "../state/document";
import { edit } from "../state/session";
import { Dialog } from "./Dialog";
import { showDialog } from "./store";

export function Publish() {
  const { objects, document } = documentStore.getState();
  const [rows, setRows] = useState(() => rowsOf(playable([...objects.values()]), document?.player ?? null));
  const change = (at: number, now: Partial<Row>) => setRows(rows.map((row, k) => (k === at ? { ...row, ...now } : row)));
  const publish = async (inputs: ReturnType<typeof publishedOf> | null) => {
    const answer = await edit({ do: "publish", inputs });
    if (answer) showDialog(undefined);
    return answer !== undefined;
  };
  const nameOf = (id: string) => objects.get(id)?.nickname || objects.get(id)?.name || "";
  const id = place(location.search).document;
  return (
    <Dialog title={t("publish.title")} wide>
      <p>{t(rows.length > 0 ? "publish.what" : "player.none")}</p>
      <table className="publish">
        {rows.length > 0 && (
          <thead>
            <tr>
              <th scope="col">{t("publish.input")}</th>
              <th scope="col">{t("publish.label")}</th>
              <th scope="col">{t("publish.help")}</th>
              <th scope="col">{t("publish.order")}</th>
            </tr>
          </thead>
        )}
        <tbody>
          {rows.map((row, at) => {
            const name = nameOf(row.object);
            return (
              <tr key={row.object} className={row.isShown ? undefined : "soft"}>
                <th scope="row">
                  <label>
                    <input type="checkbox" checked={row.isShown} onChange={({ target }) => change(at, { isShown: target.checked })} /> {name}
                  </label>
                </th>
                <td>
                  <input type="text" aria-label={t("publish.labelOf", { name })} placeholder={name} value={row.label} disabled={!row.isShown} onChange={({ target }) => change(at, { label: target.value })} />
                </td>
                <td>
                  <input type="text" aria-label={t("publish.helpOf", { name })} value={row.help} disabled={!row.isShown} onChange={({ target }) => change(at, { help: target.value })} />
                </td>
                <td>
                  <button type="button" aria-label={t("publish.up", { name })} disabled={at === 0} onClick={() => setRows(movedRow(rows, at, -1))}>
                    ↑
                  </button>{" "}
                  <button type="button" aria-label={t("publish.down", { name })} disabled={at === rows.length - 1} onClick={() => setRows(movedRow(rows, at, 1))}>
                    ↓
                  </button>
                </td>
              </tr>
            );
          })}
        </tbody>
      </table>
      <footer className="row">
        <button type="button" className="primary" onClick={() => void publish(publishedOf(rows))}>
          {t("publish.keep")}
        </button>
        <button type="button" disabled={!document?.player} onClick={() => void publish(null)}>
          {t("publish.all")}
        </button>
        <button type="button" onClick={() => void publish(publishedOf(rows)).then((done) => done && goTo(id, true))}>
          {t("publish.show")}
        </button>
      </footer>
    </Dialog>
  );
}
