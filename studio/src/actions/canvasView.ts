/** How the canvas is looked at. */

import { openRadial, openSearch } from "../canvas/open";
import { selection } from "../canvas/edits";
import { canvasStore, keep } from "../canvas/store";
import { zoomBy, zoomExtents, zoomTo } from "../canvas/view";
import { uiStore } from "../state/ui";
import { register } from "./registry";

register(
  {
    id: "canvas.search",
    label: "canvas.action.search",
    keys: ["Space"],
    group: "canvas",
    scope: "canvas",
    run: () => openSearch(),
  },
  {
    id: "canvas.radial",
    label: "canvas.radial",
    keys: ["Shift+Space"],
    group: "canvas",
    scope: "canvas",
    run: () => openRadial(),
  },
  {
    id: "edit.find",
    label: "canvas.action.find",
    keys: ["F3", "Mod+F"],
    group: "edit",
    run: () => canvasStore.setState({ finding: true, search: undefined, menu: undefined }),
  },
  {
    id: "view.zoomExtents",
    label: "canvas.action.zoomExtents",
    keys: ["Mod+0"],
    group: "view",
    under: "menu.zoom",
    scope: "canvas",
    run: () => zoomExtents(),
  },
  {
    id: "view.zoomSelected",
    label: "canvas.action.zoomSelected",
    keys: ["Mod+2"],
    group: "view",
    under: "menu.zoom",
    scope: "canvas",
    isEnabled: () => selection().length > 0,
    run: () => zoomExtents(selection()),
  },
  {
    id: "view.zoom100",
    label: "canvas.action.zoom100",
    keys: ["Mod+1"],
    group: "view",
    under: "menu.zoom",
    scope: "canvas",
    run: () => zoomTo(1),
  },
  {
    id: "view.zoomIn",
    label: "canvas.action.zoomIn",
    keys: ["Mod++", "Mod+="],
    group: "view",
    under: "menu.zoom",
    scope: "canvas",
    run: () => zoomBy(1.25),
  },
  {
    id: "view.zoomOut",
    label: "canvas.action.zoomOut",
    keys: ["Mod+-"],
    group: "view",
    under: "menu.zoom",
    scope: "canvas",
    run: () => zoomBy(0.8),
  },
  {
    id: "canvas.fullNames",
    label: "canvas.action.fullNames",
    group: "canvas",
    isOn: () => uiStore.getState().fullNames,
    run: () => uiStore.setState({ fullNames: !uiStore.getState().fullNames }),
  },
  {
    id: "canvas.icons",
    label: "canvas.action.icons",
    group: "canvas",
    isOn: () => canvasStore.getState().icons,
    run: () => keep({ icons: !canvasStore.getState().icons }),
  },
  {
    id: "canvas.profiler",
    label: "canvas.action.profiler",
    group: "canvas",
    isOn: () => uiStore.getState().profiler,
    run: () => uiStore.setState({ profiler: !uiStore.getState().profiler }),
  },
  {
    id: "canvas.aligning",
    label: "canvas.aligning",
    group: "canvas",
    isOn: () => canvasStore.getState().aligning,
    run: () => keep({ aligning: !canvasStore.getState().aligning }),
  },
  {
    id: "canvas.snapping",
    label: "canvas.menu.snapping",
    group: "canvas",
    isOn: () => canvasStore.getState().snapping,
    run: () => keep({ snapping: !canvasStore.getState().snapping }),
  },
  {
    id: "canvas.likely",
    label: "likely.action",
    group: "canvas",
    isOn: () => canvasStore.getState().likely,
    run: () => keep({ likely: !canvasStore.getState().likely }),
  },
  {
    id: "canvas.ribbon",
    label: "canvas.action.ribbon",
    group: "canvas",
    isOn: () => canvasStore.getState().ribbon,
    run: () => keep({ ribbon: !canvasStore.getState().ribbon }),
  },
);
