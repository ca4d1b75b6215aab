/**
 * The named views of a document's canvas. Files of Grasshopper have a place for them whose form is not known, so this
 * browser keeps them, by document.
 */

import { createStore } from "zustand/vanilla";

import { place } from "../app/place";
import { beside, lensOf, readViews, viewOf, type CanvasView } from "../core/canvasViews";
import { freshName, renamed, without, withNamed } from "../core/named";
import { t } from "../i18n";
import { documentStore } from "../state/document";
import { enter } from "./edits";
import { say } from "./store";
import { lens, look, paneSize } from "./view";

interface Views {
  document: string;
  views: readonly CanvasView[];
  /** The one that was shown last. */
  last: string | undefined;
}

const KEPT = "katydid.canvas.views.";

export const viewsStore = createStore<Views>(() => ({ document: "", views: [], last: undefined }));

/** Takes up what the browser keeps of this document. */
export function loadViews(): void {
  const document = place(location.search).document ?? "";
  if (viewsStore.getState().document === document && document !== "") return;
  let text: string | null = null;
  try {
    text = localStorage.getItem(KEPT + document);
  } catch {
    // Storage may be forbidden: then there are none.
  }
  viewsStore.setState({ document, views: readViews(text), last: undefined });
}

function put(views: readonly CanvasView[], last = viewsStore.getState().last): void {
  viewsStore.setState({ views, last });
  try {
    localStorage.setItem(KEPT + viewsStore.getState().document, JSON.stringify(views));
  } catch {
    // They hold for this page then.
  }
}

/** Gives what is seen now a name: the one told, or the next free number. */
export function saveView(told?: string): void {
  const { views } = viewsStore.getState();
  const name = told?.trim() || freshName(views, (number) => t("canvas.views.numbered", { number }));
  put(withNamed(views, viewOf(name, lens(), paneSize(), documentStore.getState().within)), name);
  say(t("canvas.views.saved", { name }));
}

export function renameView(from: string, to: string): void {
  put(renamed(viewsStore.getState().views, from, to));
}

export function removeView(name: string): void {
  put(without(viewsStore.getState().views, name));
}

/** Shows a view; where it is inside a cluster, that is entered first. */
export async function showView(view: CanvasView): Promise<void> {
  viewsStore.setState({ last: view.name });
  const { within } = documentStore.getState();
  if (within.join() !== view.within.join()) {
    await enter([...view.within]);
    // What is entered is shown whole at first: the view goes after that.
    await new Promise((resolve) => setTimeout(resolve, 120));
    if (documentStore.getState().within.join() !== view.within.join()) return;
  }
  look(lensOf(view, paneSize()), true);
  say(view.name);
}

export function showBeside(by: 1 | -1): void {
  const { views, last } = viewsStore.getState();
  const next = beside(views, last, by);
  if (next) void showView(next);
}
