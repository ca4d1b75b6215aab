import { createRoot } from "react-dom/client";

import "../../src/app/tokens.css";
import "../../src/app/app.css";
import "../../src/actions";
import { Workbench } from "../../src/app/Workbench";
import { followKeys } from "../../src/actions/keys";
import { Canvas } from "../../src/canvas/Canvas";
import type { DocumentState } from "../../src/core/protocol/DocumentState";
import type { CatalogueEntry } from "../../src/core/catalogue";
import { join } from "../../src/state/session";
import { takeCatalogue } from "../../src/state/catalogue";
import { documentStore } from "../../src/state/document";
import { runStore } from "../../src/state/run";
import { uiStore } from "../../src/state/ui";
import { canvasStore } from "../../src/canvas/store";
import { lens, look } from "../../src/canvas/view";
import { CATALOGUE, emptyState, sampleState } from "./sample";
import { PageSession } from "./session";
import { socketTo } from "./socket";

async function stateOf(name: string | null): Promise<DocumentState> {
  if (name === null || name === "sample") return sampleState();
  if (name === "empty") return emptyState();
  return (await (await fetch(name)).json()) as DocumentState;
}

async function catalogueOf(name: string | null): Promise<CatalogueEntry[]> {
  return name === null ? CATALOGUE : ((await (await fetch(name)).json()) as CatalogueEntry[]);
}

const query = new URLSearchParams(location.search);
const theme = query.get("theme");
if (theme) document.documentElement.dataset.theme = theme;
const session = new PageSession(await stateOf(query.get("state")));
takeCatalogue(await catalogueOf(query.get("catalogue")));
window.WebSocket = socketTo(session);
if (!query.has("workbench")) join("page", "");

/** What tests look at. */
Object.assign(window, { page: { session, documentStore, runStore, uiStore, canvasStore, lens, look } });

const root = document.getElementById("root");
if (root && query.has("workbench")) createRoot(root).render(<Workbench id="page" />);
else if (root) {
  followKeys();
  createRoot(root).render(
    <div data-scope="canvas" style={{ height: "100%" }}>
      <Canvas />
    </div>,
  );
}
