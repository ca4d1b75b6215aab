/** Named views of the canvas. */

import { saveView, showBeside, viewsStore } from "../canvas/views";
import { showDialog } from "../dialogs/store";
import { register } from "./registry";

const some = () => viewsStore.getState().views.length > 0;

register(
  { id: "canvas.views", label: "canvas.views", group: "canvas", keys: ["Mod+Shift+V"], scope: "canvas", run: () => showDialog("views") },
  { id: "canvas.views.save", label: "canvas.views.save", group: "canvas", run: () => saveView() },
  {
    id: "canvas.views.next",
    label: "canvas.views.next",
    group: "canvas",
    keys: ["PageDown"],
    scope: "canvas",
    isEnabled: some,
    run: () => showBeside(1),
  },
  {
    id: "canvas.views.previous",
    label: "canvas.views.previous",
    group: "canvas",
    keys: ["PageUp"],
    scope: "canvas",
    isEnabled: some,
    run: () => showBeside(-1),
  },
);
