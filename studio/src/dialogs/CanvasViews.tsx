import { useState, type FormEvent } from "react";
import { useStore } from "zustand";

import { removeView, renameView, saveView, showView, viewsStore } from "../canvas/views";
import { freshName } from "../core/named";
import { percent } from "../core/zoomSteps";
import { t } from "../i18n";
import { Dialog } from "./Dialog";
import { showDialog } from "./store";

/** The named views of the canvas: to go to, to name, to throw away; and what is seen now as another. */
export function CanvasViews() {
  const { views, last } = useStore(viewsStore);
  const [name, setName] = useState(() => freshName(views, (number) => t("canvas.views.numbered", { number })));
  const save = (event: FormEvent) => {
    event.preventDefault();
    saveView(name);
    setName(freshName(viewsStore.getState().views, (number) => t("canvas.views.numbered", { number })));
  };
  return (
    <Dialog title={t("canvas.views")}>
      {views.length === 0 ? <p>{t("canvas.views.none")}</p> : null}
      {views.length > 0 ? (
        <table className="canvas-views">
          <tbody>
            {views.map((view) => (
              <tr key={view.name} aria-current={view.name === last ? "true" : undefined}>
                <th scope="row">
                  <input
                    type="text"
                    aria-label={t("canvas.views.name")}
                    defaultValue={view.name}
                    onBlur={(event) => renameView(view.name, event.target.value)}
                  />
                </th>
                <td>{t("canvas.zoom.percent", { percent: percent(view.zoom) })}</td>
                <td>
                  <button
                    type="button"
                    aria-label={t("canvas.views.goTo", { name: view.name })}
                    onClick={() => {
                      showDialog(undefined);
                      void showView(view);
                    }}
                  >
                    {t("canvas.views.go")}
                  </button>{" "}
                  <button type="button" aria-label={t("canvas.views.removeOf", { name: view.name })} onClick={() => removeView(view.name)}>
                    {t("canvas.views.remove")}
                  </button>
                </td>
              </tr>
            ))}
          </tbody>
        </table>
      ) : null}
      <form onSubmit={save}>
        <label>
          {t("canvas.views.new")}
          <span className="row">
            <input type="text" value={name} onChange={(event) => setName(event.target.value)} />
            <button type="submit" className="primary">
              {t("canvas.views.add")}
            </button>
          </span>
        </label>
      </form>
      <p>
        <small>{t("canvas.views.kept")}</small>
      </p>
    </Dialog>
  );
}
