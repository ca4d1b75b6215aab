import { useEffect, useMemo, useRef, useSyncExternalStore, type RefObject } from "react";
import { useStore as useFlowStore } from "@xyflow/react";
import { useStore } from "zustand";

import { farList, type FarList } from "../core/far";
import { placeLabels, type PlacedLabel } from "../core/farLabels";
import type { Lens } from "../core/geometry";
import { documentStore } from "../state/document";
import { runStore } from "../state/run";
import { uiStore } from "../state/ui";
import { farColours, type FarColours } from "./farColours";
import { paintFar } from "./farPaint";
import { useCanvas } from "./hooks";

/** The canvas from afar: one sheet with boxes and wires. Panning paints it anew; what is painted is gathered once. */
export function FarLayer() {
  const sheet = useRef<HTMLCanvasElement>(null);
  const list = useFarList();
  const [x, y, zoom] = useFlowStore((flow) => flow.transform);
  const width = useFlowStore((flow) => flow.width);
  const height = useFlowStore((flow) => flow.height);
  // Where words stand hangs on the zoom alone: panning moves them with the rest.
  const labels = useMemo(() => placeLabels(list, zoom), [list, zoom]);
  const found = useCanvas((canvas) => canvas.found);
  const icons = useCanvas((canvas) => canvas.icons);
  const theme = useTheme();
  const colours = useRef<FarColours | undefined>(undefined);

  useEffect(() => {
    colours.current = undefined;
  }, [theme]);
  useEffect(
    () => paint(sheet, list, labels, { x, y, zoom }, [width, height], colours, found, icons),
    [list, labels, x, y, zoom, width, height, theme, found, icons],
  );

  return <canvas ref={sheet} className="far" aria-hidden="true" />;
}

/** A word that changes when the page's colours do: the theme that was chosen, and what the system wants. */
function useTheme(): string {
  return useSyncExternalStore(watchTheme, () => `${document.documentElement.dataset.theme ?? ""} ${DARK.matches}`);
}

const DARK = matchMedia("(prefers-color-scheme: dark)");

function watchTheme(changed: () => void): () => void {
  const watcher = new MutationObserver(changed);
  watcher.observe(document.documentElement, { attributeFilter: ["data-theme"] });
  DARK.addEventListener("change", changed);
  return () => {
    watcher.disconnect();
    DARK.removeEventListener("change", changed);
  };
}

function useFarList(): FarList {
  const mirror = useStore(documentStore);
  const results = useStore(runStore, (run) => run.results);
  const data = useStore(runStore, (run) => run.outputs);
  const selection = useStore(uiStore, (ui) => ui.selection);
  const full = useStore(uiStore, (ui) => ui.fullNames);
  const shifts = useCanvas((canvas) => canvas.shifts);
  const known = useRef<{ key: readonly unknown[]; list: FarList } | undefined>(undefined);
  const key = [mirror, results, data, selection, full, shifts] as const;
  if (!known.current || known.current.key.some((part, k) => part !== key[k])) {
    const { objects, order, outputs } = mirror;
    known.current = { key, list: farList({ objects, order, outputs, results, data, selection, shifts, full }) };
  }
  return known.current.list;
}

function paint(
  sheet: RefObject<HTMLCanvasElement | null>,
  list: FarList,
  labels: readonly PlacedLabel[],
  lens: Lens,
  [width, height]: readonly [number, number],
  colours: RefObject<FarColours | undefined>,
  found: ReadonlySet<string> | undefined,
  icons: boolean,
): void {
  const canvas = sheet.current;
  const context = canvas?.getContext("2d");
  if (!canvas || !context || width === 0 || height === 0) return;
  const dense = Math.min(window.devicePixelRatio || 1, 2);
  const [w, h] = [Math.round(width * dense), Math.round(height * dense)];
  if (canvas.width !== w || canvas.height !== h) {
    canvas.width = w;
    canvas.height = h;
    canvas.style.width = `${width}px`;
    canvas.style.height = `${height}px`;
  }
  colours.current ??= farColours(canvas);
  paintFar(context, list, labels, lens, [width, height], dense, colours.current, found, icons);
}
