/** The viewport by itself, fed with previews that are made here: `?scene=NAME&bare&dark`. */

import { StrictMode } from "react";
import { createRoot } from "react-dom/client";

import "../../src/app/tokens.css";
import "../../src/app/app.css";
import { followKeys } from "../../src/actions/keys";
import { documentStore } from "../../src/state/document";
import { takeAnalysis } from "../../src/state/analysis";
import { takeGeometry, takePreview } from "../../src/state/preview";
import { join } from "../../src/state/session";
import { select, uiStore } from "../../src/state/ui";
import { ViewportPane } from "../../src/viewport";
import { settingsStore } from "../../src/viewport/settings";
import { writeFrame, writePreview, type TestPreview } from "../unit/previewBytes";
import { floor, million, timePick } from "./million";
import { scenes } from "./scenes";

const query = new URLSearchParams(location.search);
if (query.has("dark")) document.documentElement.dataset.theme = "dark";

let solution = 0;

function feed(...previews: TestPreview[]): void {
  solution++;
  const objects = previews.map((preview, at): [string, string] => {
    const { hash, frame } = writeFrame(`${solution} ${at}`, writePreview(preview));
    takeGeometry(frame);
    return [preview.object, hash];
  });
  takePreview({ event: "preview", solution, draft: false, objects });
}

const test = { feed, scenes, select, uiStore, settingsStore, documentStore, takeGeometry, takePreview, takeAnalysis, writeFrame, writePreview, million, floor, timePick, join, show: (_on: boolean) => {} };
declare global {
  interface Window {
    test: typeof test;
  }
}
window.test = test;

const root = document.getElementById("root");
if (root) {
  root.classList.toggle("bare", query.has("bare"));
  const options = { antialias: query.has("smooth"), pixelRatio: Number(query.get("ratio") ?? 1) };
  const shown = createRoot(root);
  const pane = <StrictMode><ViewportPane options={options} /></StrictMode>;
  shown.render(pane);
  test.show = (on) => shown.render(on ? pane : null);
  followKeys();
  const scene = scenes[query.get("scene") ?? ""];
  if (scene) feed(...scene());
}
