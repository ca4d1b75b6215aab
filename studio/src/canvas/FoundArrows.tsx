import { useStore as useFlowStore } from "@xyflow/react";
import { useStore } from "zustand";

import { edgeArrows } from "../core/edgeArrows";
import { NO_SHIFTS, frameOf } from "../core/places";
import { t } from "../i18n";
import { documentStore } from "../state/document";
import { uiStore } from "../state/ui";
import { useCanvas } from "./hooks";
import { reveal } from "./view";

/** Arrows at the edge of the window to what was found beyond it; a press goes there. */
export function FoundArrows() {
  const found = useCanvas((canvas) => canvas.found);
  return found && found.size > 0 ? <Arrows found={found} /> : null;
}

function Arrows({ found }: { found: ReadonlySet<string> }) {
  const [x, y, zoom] = useFlowStore((flow) => flow.transform);
  const width = useFlowStore((flow) => flow.width);
  const height = useFlowStore((flow) => flow.height);
  const objects = useStore(documentStore, (mirror) => mirror.objects);
  const full = useStore(uiStore, (ui) => ui.fullNames);
  const rects = [...found].flatMap((id) => {
    const object = objects.get(id);
    return object ? [[id, frameOf(object, objects, NO_SHIFTS, full)] as const] : [];
  });
  return (
    <div className="found-arrows">
      {edgeArrows(rects, { x, y, zoom }, [width, height]).map(({ id, at, turn, count }) => (
        <button
          key={id}
          type="button"
          tabIndex={-1}
          style={{ left: at[0], top: at[1] }}
          title={t("canvas.find.beyond", { count })}
          aria-label={t("canvas.find.beyond", { count })}
          data-own
          // The box that finds keeps the focus, and so stays open.
          onPointerDown={(event) => {
            event.preventDefault();
            event.stopPropagation();
            reveal(id);
          }}
        >
          <svg viewBox="-10 -10 20 20" width={20} height={20} aria-hidden="true" style={{ rotate: `${turn}deg` }}>
            <path d="M8,0L-5,6L-2,0L-5,-6Z" />
          </svg>
          {count > 1 ? <span>{count}</span> : null}
        </button>
      ))}
    </div>
  );
}
