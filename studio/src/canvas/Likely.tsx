/** The components that most often follow the selected one, in a corner of the canvas: a press places and wires one. */

import { useStore } from "zustand";

import { portFor } from "../core/search";
import type { CatalogueEntry } from "../core/catalogue";
import { meets, type Point, type Rect } from "../core/geometry";
import { isGroup } from "../core/groups";
import { likelyAfter } from "../core/likely";
import type { ObjectView } from "../core/protocol/ObjectView";
import { t } from "../i18n";
import { Icon } from "../icons/Icon";
import { catalogueStore } from "../state/catalogue";
import { documentStore } from "../state/document";
import { likelyStore } from "../state/likely";
import { uiStore } from "../state/ui";
import { placeWired } from "./edits";
import { useCanvas } from "./hooks";

const MOST = 5;
/** How far to the right of an object the next one stands, and how far below another that is there already. */
const AWAY = 90;
const BELOW = 60;
const TRIES = 20;

export function Likely() {
  const isOn = useCanvas((canvas) => canvas.likely);
  const object = useStore(uiStore, ({ selection }) => (selection.size === 1 ? [...selection][0] : undefined));
  const view = useStore(documentStore, (mirror) => (object === undefined ? undefined : mirror.objects.get(object)));
  const counts = useStore(likelyStore, (likely) => likely.counts);
  const byId = useStore(catalogueStore, (catalogue) => catalogue.byId);
  if (!isOn || !view || view.outputs.length === 0) return null;
  const next = likelyAfter(counts, view.component).flatMap((id) => {
    const entry = byId.get(id);
    const from = entry && !entry.old ? sourceFor(view, entry) : undefined;
    return entry && from ? [{ entry, from }] : [];
  });
  if (next.length === 0) return null;
  return (
    <div className="likely" role="group" aria-label={t("likely.label")} data-own onPointerDown={(event) => event.stopPropagation()}>
      {next.slice(0, MOST).map(({ entry, from }) => {
        const label = t("likely.place", { name: entry.name });
        return (
          <button key={entry.guid} type="button" className="quiet" title={label} aria-label={label} onClick={() => void placeAfter(view, entry, from)}>
            <Icon component={entry.guid} name={entry.name} size={20} />
            <span>{entry.nick || entry.name}</span>
          </button>
        );
      })}
    </div>
  );
}

/** The output of an object that a component takes best. */
function sourceFor({ outputs }: ObjectView, entry: CatalogueEntry): string | undefined {
  let best: { id: string; fit: number } | undefined;
  for (const { id, kind } of outputs) {
    const fit = portFor(entry, { side: "input", kind })?.fit ?? 0;
    if (fit > (best?.fit ?? 0)) best = { id, fit };
  }
  return best?.id;
}

async function placeAfter({ id, bounds: [x, y, width, height] }: ObjectView, { guid }: CatalogueEntry, port: string): Promise<void> {
  const at = freePlace([x + width + AWAY, y + height / 2]);
  await placeWired(guid, at, { port, object: id, side: "output", at });
}

/** The first place below a point, or that itself, where nothing stands. */
function freePlace([x, y]: Point): Point {
  const { objects } = documentStore.getState();
  const rects = [...objects.values()].filter((object) => !isGroup(object)).map(({ bounds }) => bounds);
  for (let step = 0; step < TRIES; step++) {
    const room: Rect = [x - 40, y + step * BELOW - 20, 80, 40];
    if (!rects.some((rect) => meets(rect, room))) return [x, y + step * BELOW];
  }
  return [x, y];
}
