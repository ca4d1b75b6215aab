/** A viewport on the page, joined to what the stores know and to the hands on it. */

import { radius } from "../../core/bounds";
import type { Preview, Rgba } from "../../core/preview";
import type { DocumentView } from "../../core/protocol/DocumentView";
import { t } from "../../i18n";
import { documentStore } from "../../state/document";
import { modelStore } from "../../state/model";
import { lineStore } from "../../state/session";
import { select, uiStore } from "../../state/ui";
import { setCurrentViewport } from "../current";
import { analysisGeometry, geometry } from "../geometry";
import { layerColours, layerGeometry } from "../layers";
import { settingsStore, viewportStore } from "../settings";
import { aim } from "../tools/aim";
import { Drawer } from "../tools/drawer";
import { Grabber } from "../tools/grabber";
import { Gumball } from "../tools/gumball";
import { PointHandles } from "../tools/pointHandles";
import { PointerControls } from "../tools/pointer";
import { besides, layers } from "../tools/beside";
import { Looker } from "../tools/looker";
import { MotionArrows } from "../tools/motionArrows";
import { Probes } from "../tools/probes";
import type { Pick } from "../tools/picking";
import { SectionHandle } from "../tools/sectionHandle";
import { Viewport, type Options } from "../Viewport";
import type { Surroundings } from "../surroundings";
import { viewOf } from "../views";
import { PaneFrames } from "./frames";
import { portray } from "./portrait";

/** The colours of previews where no document says others: Grasshopper's. */
const NORMAL: Rgba = [150, 0, 0, 100];
const SELECTED: Rgba = [0, 150, 0, 100];

/** What is drawn of the places that are looked at. */
const PLACES = "tool:places";
/** And of how places move. */
const MOTION = "tool:motion";

export function isStill(): boolean {
  return matchMedia("(prefers-reduced-motion: reduce)").matches;
}

/** Puts a viewport into an element; gives what takes it away again. */
export function openViewport(host: HTMLElement, options: Options = {}): () => void {
  const viewport = new Viewport(host, surroundings(), options);
  const { canvas } = viewport;
  canvas.tabIndex = 0;
  canvas.setAttribute("role", "application");
  canvas.setAttribute("aria-label", t("viewport.label"));
  canvas.setAttribute("aria-description", t("viewport.help"));
  const drawer = new Drawer(host, viewport);
  setCurrentViewport(viewport, drawer);
  const stops = [
    geometry.listen({
      put: (object, preview) => viewport.put(object, preview),
      drop: (object) => viewport.drop(object),
      clear: () => viewport.clear(),
      failed: (object, reason) => complain(object, reason),
    }),
    analysisGeometry.listen({ ...besides(viewport), failed: (object, reason) => complain(object, reason) }),
    layerGeometry.listen({ ...layers(viewport), failed: (layer, reason) => complain(layer, reason) }),
    modelStore.subscribe(() => viewport.surround(surroundings())),
    uiStore.subscribe(() => viewport.surround(surroundings())),
    documentStore.subscribe(() => viewport.surround(surroundings())),
    settingsStore.subscribe((now, before) => now.previews !== before.previews && viewport.surround(surroundings())),
    followTheme(() => viewport.retheme()),
  ];
  const frames = new PaneFrames(host, {
    activate: (pane) => viewport.panes.activate(pane),
    maximise(pane) {
      viewport.panes.activate(pane);
      settingsStore.setState(({ layout }) => ({ layout: layout === "one" ? "four" : "one" }));
    },
    look(pane, view) {
      viewport.panes.activate(pane);
      viewport.panes.look(view, true, isStill());
    },
  });
  const gumball = new Gumball(host, viewport);
  const handles = new PointHandles(host, viewport);
  const section = new SectionHandle(host, viewport);
  const grabber = new Grabber(host, viewport);
  const looker = new Looker();
  const size = () => radius(viewport.documentBounds() ?? [[0, 0, 0], [1, 1, 1]]);
  const shown = (name: string) => (preview: Preview | undefined) => (preview ? viewport.put(name, preview) : viewport.drop(name));
  const probes = new Probes({ show: shown(PLACES), size });
  const arrows = new MotionArrows({ show: shown(MOTION), size });
  viewport.afterDraw = (placed) => {
    frames.place(placed, viewport.panes.active);
    gumball.place(placed);
    handles.place(placed);
    section.place(placed);
    grabber.place();
    drawer.place();
  };
  const controls = hands(viewport, host, { probes, drawer, grabber });
  const stopPortraits = portray(viewport, host);
  return () => {
    stopPortraits();
    controls.dispose();
    looker.dispose();
    probes.dispose();
    arrows.dispose();
    gumball.dispose();
    handles.dispose();
    section.dispose();
    grabber.dispose();
    drawer.dispose();
    frames.dispose();
    for (const stop of stops) stop();
    setCurrentViewport(undefined);
    viewport.dispose();
  };
}

const NONE: ReadonlySet<string> = new Set();

function surroundings(): Surroundings {
  const { document, objects } = documentStore.getState();
  const { selection, hovered } = uiStore.getState();
  const { previews } = settingsStore.getState();
  const colour = (of: keyof Pick4<DocumentView>, usual: Rgba): Rgba => document?.[of] ?? usual;
  const hidden = new Set<string>();
  for (const [id, object] of objects) if (object.hidden || object.disabled) hidden.add(id);
  return {
    normal: colour("previewNormal", NORMAL),
    selected: colour("previewSelected", SELECTED),
    selection,
    hovered,
    hidden,
    only: previews === "all" ? undefined : previews === "selected" ? selection : NONE,
    layers: layerColours(modelStore.getState()),
  };
}

type Pick4<T> = { [K in keyof T as T[K] extends [number, number, number, number] ? K : never]: T[K] };

function complain(object: string, reason: string): void {
  const layer = modelStore.getState().model?.layers.find(({ id }) => id === object);
  const name = layer?.path ?? documentStore.getState().objects.get(object)?.nickname ?? "";
  lineStore.setState({ complaint: t("viewport.failed", { object: name, reason }) });
}

/** Calls when the page's colours change: by the attribute of the theme, or by the system's. */
function followTheme(changed: () => void): () => void {
  const observer = new MutationObserver(changed);
  observer.observe(document.documentElement, { attributes: true, attributeFilter: ["data-theme", "class", "style"] });
  const queries = ["(prefers-color-scheme: dark)", "(forced-colors: active)"].map((query) => matchMedia(query));
  for (const query of queries) query.addEventListener("change", changed);
  return () => {
    observer.disconnect();
    for (const query of queries) query.removeEventListener("change", changed);
  };
}

interface Tools {
  probes: Probes;
  drawer: Drawer;
  grabber: Grabber;
}

function hands(viewport: Viewport, host: HTMLElement, { probes, drawer, grabber }: Tools): PointerControls {
  const { panes } = viewport;
  const band = document.createElement("div");
  band.className = "viewport-window";
  band.hidden = true;
  host.append(band);
  let waiting: [number, number] | undefined;
  let request = 0;
  const hover = () => {
    request = 0;
    if (drawer.isOn()) return drawer.hover(waiting);
    const pick = waiting && !controls.isBusy() ? viewport.pickAt(...waiting) : undefined;
    pointAt(probes, pick, waiting);
  };
  const controls: PointerControls = new PointerControls({
    element: viewport.canvas,
    paneAt(x, y) {
      const { pane } = panes.at(x, y);
      return pane;
    },
    begin(pane) {
      panes.activate(pane);
      // Who takes the model into the hand stops the table.
      if (settingsStore.getState().turntable) settingsStore.setState({ turntable: false });
    },
    orbit: (pane, dx, dy) => panes.orbit(pane, dx, dy),
    pan: (pane, dx, dy) => panes.pan(pane, dx, dy),
    zoom: (pane, x, y, factor) => panes.zoom(pane, aim(viewport, x, y), factor),
    hover(x, y) {
      waiting = x === undefined || y === undefined ? undefined : [x, y];
      request ||= requestAnimationFrame(hover);
    },
    click(x, y, how) {
      if (drawer.isOn()) return drawer.click(x, y);
      const pick = viewport.pickAt(x, y);
      choose(pick ? [pick.object] : [], how);
    },
    mark: (x, y) => probes.pin(viewport.pickAt(x, y)),
    hold: (x, y) => !drawer.isOn() && grabber.begin(x, y),
    drag: (x, y) => grabber.move(x, y),
    letGo: () => grabber.end(),
    window(corners, done, how) {
      if (drawer.isOn()) return;
      band.hidden = done || !corners;
      if (!corners) return;
      const [x, y, u, v] = corners;
      const [left, top] = [Math.min(x, u), Math.min(y, v)];
      Object.assign(band.style, {
        left: `${left}px`, top: `${top}px`, width: `${Math.abs(u - x)}px`, height: `${Math.abs(v - y)}px`,
      });
      band.classList.toggle("is-crossing", u < x);
      if (done) choose(viewport.inWindow(corners), how);
    },
    isPlan: ({ rig }) => rig.pose.projection === "parallel" && viewOf(rig.pose) !== undefined,
    trackpad: () => settingsStore.getState().trackpad,
  });
  return controls;
}

function choose(ids: readonly string[], how: "replace" | "add" | "remove"): void {
  const { selection } = uiStore.getState();
  if (how === "replace") select(ids);
  else if (how === "add") select([...selection, ...ids]);
  else select([...selection].filter((id) => !ids.includes(id)));
}

function pointAt(probes: Probes, pick: Pick | undefined, at: [number, number] | undefined): void {
  const object = pick?.object;
  probes.point(settingsStore.getState().circle ? pick : undefined);
  if (uiStore.getState().hovered !== object) uiStore.setState({ hovered: object });
  const { pointed } = viewportStore.getState();
  if (!pick || !object || !at) {
    if (pointed) viewportStore.setState({ pointed: undefined });
    return;
  }
  const [x, y] = at;
  const { path = "", index = 0 } = pick.piece ?? {};
  viewportStore.setState({ pointed: { object, path, index: pick.piece ? index : -1, x, y } });
}
