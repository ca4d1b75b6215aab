/** When a tip opens: the pointer rests on an object or port for a moment. */

import { uiStore } from "../../state/ui";
import { isBusy } from "../gestures/bind";
import { canvasStore, type TipAt } from "../store";
import { pixelOf } from "../view";

const REST = 450;

let timer: ReturnType<typeof setTimeout> | undefined;
let resting = "";

/** What an element belongs to, and a word for it that changes when the tip must. */
function under(event: PointerEvent): (Omit<TipAt, "pixel"> & { word: string }) | undefined {
  const element = event.target instanceof Element ? event.target : null;
  const object = element?.closest<HTMLElement>("[data-object]")?.dataset.object;
  if (!object || element?.closest(".box, textarea, input, [data-group]")) return undefined;
  const port = element?.closest<HTMLElement>("[data-port], [data-name-of]");
  const id = port?.dataset.port ?? port?.dataset.nameOf;
  const side = port?.dataset.side === "input" ? "input" : "output";
  return { object, port: id === undefined ? undefined : { id, side }, word: `${object} ${id ?? ""} ${side}` };
}

export function hoverOver(event: PointerEvent): void {
  const here = event.pointerType === "touch" || event.buttons !== 0 || isBusy() ? undefined : under(event);
  if (uiStore.getState().hovered !== here?.object) uiStore.setState({ hovered: here?.object });
  if (here?.word === resting) return;
  resting = here?.word ?? "";
  clearTimeout(timer);
  if (canvasStore.getState().tip) canvasStore.setState({ tip: undefined });
  if (!here) return;
  const { object, port } = here;
  const pixel = pixelOf(event);
  timer = setTimeout(() => {
    const { menu, radial, search, editor } = canvasStore.getState();
    if (!isBusy() && !menu && !radial && !search && !editor) canvasStore.setState({ tip: { pixel, object, port } });
  }, REST);
}

export function hoverOut(): void {
  clearTimeout(timer);
  resting = "";
  if (canvasStore.getState().tip) canvasStore.setState({ tip: undefined });
  if (uiStore.getState().hovered !== undefined) uiStore.setState({ hovered: undefined });
}
