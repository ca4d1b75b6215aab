import { useStore as useFlowStore } from "@xyflow/react";
import { useStore } from "zustand";

import { alignHandles, within } from "../core/alignHandles";
import { around, grown, toWindow, type Point, type Rect } from "../core/geometry";
import { isGroup, leaves } from "../core/groups";
import { frameOf } from "../core/places";
import { t } from "../i18n";
import { documentStore } from "../state/document";
import { edit } from "../state/session";
import { uiStore } from "../state/ui";
import { selection } from "./edits";
import { useCanvas } from "./hooks";
import { Icon } from "./icons";

/** From the selected objects to the dashed frame, in pixels; and from the edge of the window. */
const ROOM = 8;
const EDGE = 38;
/** Smaller than this the frame is a dot, and its handles would be all there is to see. */
const SMALLEST = 24;

/** A dashed frame around what is selected, with handles that line it up. The same commands are in the menus. */
export function AlignWidget() {
  const shown = useCanvas((canvas) => canvas.aligning);
  const busy = useCanvas((canvas) => canvas.shifts.size > 0 || canvas.window !== undefined || canvas.wire !== undefined);
  const box = useCanvas((canvas) => Boolean(canvas.radial ?? canvas.menu ?? canvas.editor ?? canvas.search ?? canvas.writing));
  const several = useStore(uiStore, (ui) => ui.selection.size > 1);
  return shown && several && !busy && !box ? <Handles /> : null;
}

function Handles() {
  const [x, y, zoom] = useFlowStore((flow) => flow.transform);
  const width = useFlowStore((flow) => flow.width);
  const height = useFlowStore((flow) => flow.height);
  const frame = useFrame();
  if (!frame) return null;
  const [left, top] = toWindow({ x, y, zoom }, [frame[0], frame[1]]);
  const pixels = grown([left, top, frame[2] * zoom, frame[3] * zoom], ROOM);
  const seen = within(pixels, [width, height], EDGE);
  if (!seen || Math.max(pixels[2], pixels[3]) < SMALLEST) return null;
  return (
    <div className="align-widget">
      <div className="frame" style={box(pixels)} />
      {alignHandles(seen).map(({ how, at }) => (
        <button
          key={how}
          type="button"
          className="handle"
          style={place(at)}
          tabIndex={-1}
          title={t(`canvas.align.${how}`)}
          aria-label={t(`canvas.align.${how}`)}
          data-own
          onClick={() => void edit({ do: "align", objects: selection(), how })}
          onDoubleClick={(event) => event.stopPropagation()}
        >
          <Icon name={how} size={16} />
        </button>
      ))}
    </div>
  );
}

/** The rectangle around two or more selected objects. A group counts as one, and its members not for themselves. */
function useFrame(): Rect | undefined {
  const objects = useStore(documentStore, (mirror) => mirror.objects);
  const chosen = useStore(uiStore, (ui) => ui.selection);
  const full = useStore(uiStore, (ui) => ui.fullNames);
  if (leaves(chosen, objects).size < 2) return undefined;
  const rects: Rect[] = [];
  for (const id of chosen) {
    const object = objects.get(id);
    if (object && !(isGroup(object) && chosen.size === 1)) rects.push(frameOf(object, objects, new Map(), full));
  }
  return rects.length > 1 ? around(rects) : undefined;
}

function place([left, top]: Point) {
  return { left, top };
}

function box([left, top, width, height]: Rect) {
  return { left, top, width, height };
}
