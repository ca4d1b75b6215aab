/** The drop-down of the zoom box: zooms, what to fit, and the named views. */

import { percent, ZOOM_STEPS } from "../../core/zoomSteps";
import { showDialog } from "../../dialogs/store";
import { t } from "../../i18n";
import { lens, zoomTo } from "../view";
import { saveView, showView, viewsStore } from "../views";
import { LINE, menu, type Item } from "./items";
import { registered } from "./objectMenu";

export function zoomMenu(): Item[] {
  const now = percent(lens().zoom);
  return menu(
    ...ZOOM_STEPS.map(
      (step): Item => ({
        is: "do",
        label: t("canvas.zoom.percent", { percent: step }),
        on: now === step,
        run: () => zoomTo(step / 100),
      }),
    ),
    LINE,
    registered("view.zoomExtents"),
    registered("view.zoomSelected"),
  );
}

export function viewsMenu(): Item[] {
  const { views, last } = viewsStore.getState();
  return menu(
    ...views.map((view): Item => ({ is: "do", label: view.name, on: view.name === last, run: () => void showView(view) })),
    LINE,
    { is: "do", label: t("canvas.views.save"), run: () => saveView() },
    { is: "do", label: t("canvas.views.manage"), run: () => showDialog("views") },
  );
}
