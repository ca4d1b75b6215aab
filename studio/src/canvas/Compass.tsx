import { useStore as useFlowStore } from "@xyflow/react";
import { useStore } from "zustand";

import { edgeArrows } from "../core/edgeArrows";
import { middle, toWindow, type Rect } from "../core/geometry";
import { isGroup } from "../core/groups";
import { t } from "../i18n";
import { documentStore } from "../state/document";
import { useCanvas } from "./hooks";
import { zoomExtents } from "./view";

/**
 * Where nothing of the definition is in sight: an arrow towards the nearest of it; a press goes back. While something is
 * searched for, the arrows to what was found lead there.
 */
export function Compass() {
  const isFinding = useCanvas(({ found }) => found !== undefined && found.size > 0);
  return isFinding ? null : <Needle />;
}

function Needle() {
  const [x, y, zoom] = useFlowStore((flow) => flow.transform);
  const width = useFlowStore((flow) => flow.width);
  const height = useFlowStore((flow) => flow.height);
  const objects = useStore(documentStore, (mirror) => mirror.objects);
  const lens = { x, y, zoom };
  let nearest: { far: number; rect: Rect } | undefined;
  for (const object of objects.values()) {
    // Groups are where their members are. This is asked for with each step of a pan: the session's own frames will do.
    if (isGroup(object)) continue;
    const rect = object.bounds;
    const [left, top] = toWindow(lens, [rect[0], rect[1]]);
    const [right, bottom] = [left + rect[2] * zoom, top + rect[3] * zoom];
    if (right > 0 && bottom > 0 && left < width && top < height) return null;
    const [u, v] = toWindow(lens, middle(rect));
    const far = Math.hypot(u - width / 2, v - height / 2);
    if (!nearest || far < nearest.far) nearest = { far, rect };
  }
  const [arrow] = nearest ? edgeArrows([["", nearest.rect]], lens, [width, height]) : [];
  if (!arrow) return null;
  const label = t("compass.back");
  return (
    <div className="found-arrows">
      <button type="button" style={{ left: arrow.at[0], top: arrow.at[1] }} title={label} aria-label={label} data-own onPointerDown={(event) => event.stopPropagation()} onClick={() => zoomExtents()}>
        <svg viewBox="-10 -10 20 20" width={20} height={20} aria-hidden="true" style={{ rotate: `${arrow.turn}deg` }}>
          <path d="M8,0L-5,6L-2,0L-5,-6Z" />
        </svg>
      </button>
    </div>
  );
}
