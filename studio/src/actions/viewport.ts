/** What can be done with the view of the model. */

import { t } from "../i18n";
import { uiStore } from "../state/ui";
import { saveCamera } from "../viewport/cameras";
import { currentViewport } from "../viewport/current";
import { filmOf, isFilmed } from "../viewport/film";
import { aim } from "../viewport/tools/aim";
import { DISPLAY_MODES } from "../viewport/scene/looks";
import { ANALYSES, PREVIEWS, settingsStore, type Analysis } from "../viewport/settings";
import { VIEW_NAMES, type ViewName } from "../viewport/views";
import { register, type Action } from "./registry";

const isStill = () => matchMedia("(prefers-reduced-motion: reduce)").matches;

const VIEW_KEYS: Partial<Record<ViewName, string>> = { top: "Mod+F1", front: "Mod+F2", right: "Mod+F3", perspective: "Mod+F4" };
const MODE_KEYS = { wireframe: "Mod+Alt+W", shaded: "Mod+Alt+S", ghosted: "Mod+Alt+G", rendered: "Mod+Alt+R", technical: "Mod+Alt+T" };

const base = { group: "view", isEnabled: () => currentViewport() !== undefined } as const;

const views = VIEW_NAMES.map((name): Action => {
  const keys = VIEW_KEYS[name];
  return {
    ...base,
    under: "menu.camera",
    id: `viewport.view.${name}`,
    label: `viewport.look.${name}`,
    ...(keys && { keys: [keys] }),
    run: () => currentViewport()?.panes.look(name, false, isStill()),
  };
});

const modes = DISPLAY_MODES.map((mode): Action => ({
  ...base,
  under: "menu.display",
  id: `viewport.mode.${mode}`,
  label: `viewport.display.${mode}`,
  keys: [MODE_KEYS[mode]],
  isOn: () => settingsStore.getState().mode === mode,
  run: () => settingsStore.setState({ mode }),
}));

const previews = PREVIEWS.map((name): Action => ({
  ...base,
  under: "menu.display",
  id: `viewport.previews.${name}`,
  label: `viewport.previews.${name}`,
  isOn: () => settingsStore.getState().previews === name,
  run: () => settingsStore.setState({ previews: name }),
}));

const analyses = ANALYSES.filter((name) => name !== "none").map((analysis): Action => ({
  ...base,
  under: "viewport.analysis",
  id: `viewport.analysis.${analysis}`,
  label: `viewport.analysis.${analysis}`,
  isOn: () => settingsStore.getState().analysis === analysis,
  run: () => settingsStore.setState((now) => ({ analysis: now.analysis === analysis ? ("none" as Analysis) : analysis, range: undefined })),
}));

const toggle = (name: "comb" | "circle" | "controls"): Action => ({
  ...base,
  under: "viewport.analysis",
  id: `viewport.analysis.${name}`,
  label: `viewport.analysis.${name}`,
  isOn: () => settingsStore.getState()[name],
  run: () => settingsStore.setState((now) => ({ [name]: !now[name] })),
});

/** A sixteenth of half a turn, and as many pixels. */
const TURN = 24;
const MOVE = 40;

const step = (id: string, label: Action["label"], key: string, run: () => void): Action => ({
  ...base,
  under: "menu.camera",
  id: `viewport.${id}`,
  label,
  keys: [key],
  scope: "viewport",
  run,
});

const orbit = (dx: number, dy: number) => () => {
  const panes = currentViewport()?.panes;
  panes?.orbit(panes.active, dx * TURN, dy * TURN);
};

const pan = (dx: number, dy: number) => () => {
  const panes = currentViewport()?.panes;
  panes?.pan(panes.active, dx * MOVE, dy * MOVE);
};

const zoom = (factor: number) => () => {
  const viewport = currentViewport();
  if (!viewport) return;
  const { left, top, width, height, pane } = viewport.panes.placedOf(viewport.panes.active);
  viewport.panes.zoom(pane, aim(viewport, left + width / 2, top + height / 2), factor);
};

async function savePicture(): Promise<void> {
  const picture = await currentViewport()?.picture();
  if (picture) keepFile(picture, t("viewport.pictureName"));
}

async function saveFilm(): Promise<void> {
  const viewport = currentViewport();
  const film = viewport && (await filmOf(viewport));
  if (film) keepFile(film.bytes, t("viewport.filmName", { ending: film.ending }));
}

/** Has the browser keep a file. */
function keepFile(bytes: Blob, name: string): void {
  const link = document.createElement("a");
  link.href = URL.createObjectURL(bytes);
  link.download = name;
  link.click();
  setTimeout(() => URL.revokeObjectURL(link.href), 10_000);
}

register(
  {
    ...base,
    under: "menu.camera",
    id: "viewport.zoomExtents",
    label: "viewport.zoomExtents",
    keys: ["Mod+Alt+E", "Home"],
    run: () => currentViewport()?.zoomExtents(isStill()),
  },
  {
    ...base,
    under: "menu.camera",
    id: "viewport.zoomSelected",
    label: "viewport.zoomSelected",
    keys: ["Mod+Alt+Z"],
    isEnabled: () => currentViewport() !== undefined && uiStore.getState().selection.size > 0,
    run: () => currentViewport()?.zoomSelected(isStill()),
  },
  ...views,
  {
    ...base,
    under: "menu.camera",
    id: "viewport.parallel",
    label: "viewport.parallel",
    keys: ["Mod+Alt+P"],
    isOn: () => currentViewport()?.panes.projection() === "parallel",
    run() {
      const panes = currentViewport()?.panes;
      panes?.setProjection(panes.projection() === "parallel" ? "perspective" : "parallel");
    },
  },
  {
    ...base,
    under: "menu.camera",
    id: "viewport.four",
    label: "viewport.four",
    keys: ["Mod+Alt+4"],
    isOn: () => settingsStore.getState().layout === "four",
    run: () => settingsStore.setState(({ layout }) => ({ layout: layout === "four" ? "one" : "four" })),
  },
  ...modes,
  ...previews,
  {
    ...base,
    under: "menu.display",
    id: "viewport.grid",
    label: "viewport.show.grid",
    keys: ["F7"],
    isOn: () => settingsStore.getState().shown.grid,
    run: () => settingsStore.setState(({ shown }) => ({ shown: { ...shown, grid: !shown.grid } })),
  },
  {
    ...base,
    under: "menu.display",
    id: "viewport.gumball",
    label: "viewport.gumball",
    isOn: () => settingsStore.getState().gumball,
    run: () => settingsStore.setState(({ gumball }) => ({ gumball: !gumball })),
  },
  ...analyses,
  toggle("comb"),
  toggle("circle"),
  toggle("controls"),
  {
    ...base,
    under: "menu.display",
    id: "viewport.section",
    label: "viewport.section.on",
    isOn: () => settingsStore.getState().section.isOn,
    run: () => settingsStore.setState(({ section }) => ({ section: { ...section, isOn: !section.isOn } })),
  },
  {
    ...base,
    under: "menu.camera",
    id: "viewport.turntable",
    label: "viewport.turntable",
    // What moves by itself is not for those who asked for less of it.
    isEnabled: () => currentViewport() !== undefined && !isStill(),
    isOn: () => settingsStore.getState().turntable,
    run: () => settingsStore.setState(({ turntable }) => ({ turntable: !turntable })),
  },
  { ...base, under: "menu.camera", id: "viewport.camera.save", label: "viewport.cameras.saveNow", run: () => saveCamera() },
  { ...base, id: "viewport.save", label: "viewport.save", run: savePicture },
  {
    ...base,
    under: "menu.camera",
    id: "viewport.film",
    label: "viewport.film",
    isEnabled: () => currentViewport() !== undefined && !isFilmed(),
    run: saveFilm,
  },
  step("turnLeft", "viewport.turnLeft", "ArrowLeft", orbit(1, 0)),
  step("turnRight", "viewport.turnRight", "ArrowRight", orbit(-1, 0)),
  step("turnUp", "viewport.turnUp", "ArrowUp", orbit(0, 1)),
  step("turnDown", "viewport.turnDown", "ArrowDown", orbit(0, -1)),
  step("moveLeft", "viewport.moveLeft", "Shift+ArrowLeft", pan(1, 0)),
  step("moveRight", "viewport.moveRight", "Shift+ArrowRight", pan(-1, 0)),
  step("moveUp", "viewport.moveUp", "Shift+ArrowUp", pan(0, 1)),
  step("moveDown", "viewport.moveDown", "Shift+ArrowDown", pan(0, -1)),
  step("zoomIn", "viewport.zoomIn", "+", zoom(0.8)),
  step("zoomOut", "viewport.zoomOut", "-", zoom(1.25)),
);
