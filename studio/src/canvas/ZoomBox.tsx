import { useStore as useFlowStore } from "@xyflow/react";
import type { MouseEvent, ReactNode } from "react";

import { action } from "../actions/registry";
import { percent } from "../core/zoomSteps";
import { t } from "../i18n";
import { Icon, type IconName } from "./icons";
import { canvasStore } from "./store";
import { canvasPoint, pixelOf } from "./view";

/** The zoom of the canvas at its lower left: a drop-down of percents, fitting, and named views. */
export function ZoomBox() {
  const zoom = useFlowStore((flow) => percent(flow.transform[2]));
  return (
    <div className="zoom-box" role="toolbar" aria-label={t("canvas.zoom")} data-own>
      <Does id="view.zoomOut">−</Does>
      <button
        type="button"
        className="percent"
        aria-haspopup="menu"
        aria-label={t("canvas.zoom.now", { percent: zoom })}
        title={t("canvas.zoom")}
        onClick={(event) => open(event, "zoom")}
      >
        {t("canvas.zoom.percent", { percent: zoom })} <span aria-hidden="true">▾</span>
      </button>
      <Does id="view.zoomIn">+</Does>
      <Does id="view.zoomExtents" icon="extents" />
      <Does id="view.zoomSelected" icon="selected" />
      <button
        type="button"
        aria-haspopup="menu"
        aria-label={t("canvas.views")}
        title={t("canvas.views")}
        onClick={(event) => open(event, "views")}
      >
        <Icon name="views" size={16} />
      </button>
    </div>
  );
}

/** A button of an action of the registry. */
function Does({ id, icon, children }: { id: string; icon?: IconName; children?: ReactNode }) {
  const found = action(id);
  if (!found) return null;
  const run = () => {
    if (found.isEnabled?.() ?? true) void found.run();
  };
  return (
    <button type="button" aria-label={t(found.label)} title={t(found.label)} onClick={run}>
      {icon ? <Icon name={icon} size={16} /> : children}
    </button>
  );
}

/** Opens a drop-down above the button. */
function open(event: MouseEvent<HTMLButtonElement>, is: "zoom" | "views"): void {
  const box = event.currentTarget.getBoundingClientRect();
  const pixel = pixelOf({ clientX: box.left, clientY: box.top });
  canvasStore.setState({ menu: { pixel, above: true, at: canvasPoint(pixel), target: { is } }, tip: undefined });
}
