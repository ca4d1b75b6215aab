/** Narrow reads of the stores: an element is drawn again for what it shows, and for nothing else. */

import { createContext, useContext, useEffect, useLayoutEffect } from "react";
import { useStore } from "zustand";

import type { CatalogueEntry } from "../core/catalogue";
import { isStarved } from "../core/look";
import type { ObjectView } from "../core/protocol/ObjectView";
import type { OutputView } from "../core/protocol/OutputView";
import type { ResultView } from "../core/protocol/ResultView";
import { catalogueStore } from "../state/catalogue";
import { documentStore } from "../state/document";
import { runStore } from "../state/run";
import { uiStore } from "../state/ui";
import { canvasStore, type CanvasState } from "./store";
import { objectElement, paneElement } from "./view";

export function useResult(id: string): ResultView | undefined {
  return useStore(runStore, (run) => run.results.get(id));
}

/** Whether nothing comes over the wires of one of its inputs. */
export function useStarved(object: ObjectView): boolean {
  return useStore(runStore, (run) => isStarved(object, run.outputs));
}

export function useOutput(port: string): OutputView | undefined {
  return useStore(runStore, (run) => run.outputs.get(port));
}

/** How the data of an output is built: solves change it seldom. */
export function useStructure(port: string): OutputView["structure"] | undefined {
  return useStore(runStore, (run) => run.outputs.get(port)?.structure);
}

export function useObject(id: string | undefined): ObjectView | undefined {
  return useStore(documentStore, (mirror) => (id === undefined ? undefined : mirror.objects.get(id)));
}

export function useSelected(id: string): boolean {
  return useStore(uiStore, (ui) => ui.selection.has(id));
}

/** Whether the pointer is on an object, here or in the viewport. */
export function useHovered(id: string): boolean {
  return useStore(uiStore, (ui) => ui.hovered === id);
}

/** Whether an object is among what was searched for on the canvas. */
export function useFound(id: string): boolean {
  return useStore(canvasStore, (canvas) => canvas.found?.has(id) === true);
}

export function useFullNames(): boolean {
  return useStore(uiStore, (ui) => ui.fullNames);
}

export function useProfiler(): boolean {
  return useStore(uiStore, (ui) => ui.profiler);
}

export function useCanvas<T>(read: (state: CanvasState) => T): T {
  return useStore(canvasStore, read);
}

export function useEntry(component: string): CatalogueEntry | undefined {
  return useStore(catalogueStore, (catalogue) => catalogue.byId.get(component));
}

/** Whether the canvas is near enough for (+) and (−). */
export const Near = createContext(false);

export function useNear(): boolean {
  return useContext(Near);
}

/**
 * The object that the keyboard is at has the focus, as soon as it is in sight, while the focus is on the canvas at all.
 * One that goes, by Undo or out of sight, leaves it to the canvas: keys go on working.
 */
export function useFocus(id: string, active: boolean): void {
  useEffect(() => {
    const holder = document.activeElement;
    const isOnCanvas = holder === paneElement() || (holder instanceof HTMLElement && holder.dataset.object !== undefined);
    if (active && isOnCanvas) objectElement(id)?.focus({ preventScroll: true });
  }, [id, active]);
  useLayoutEffect(
    () => () => {
      const holder = document.activeElement?.closest<HTMLElement>("[data-object]");
      if (holder?.dataset.object === id) paneElement()?.focus({ preventScroll: true });
    },
    [id],
  );
}
