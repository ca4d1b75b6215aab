/** What is done with the selected objects: states, groups, clusters, lining up. */

import { exportAs, place } from "../app";
import { change, enter, selectedMembers, selection } from "../canvas/edits";
import { openEditor } from "../canvas/open";
import type { Alignment } from "../core/protocol/Alignment";
import type { ObjectView } from "../core/protocol/ObjectView";
import { documentStore } from "../state/document";
import { edit, lineStore } from "../state/session";
import { select } from "../state/ui";
import { register, type Action } from "./registry";

const some = () => selection().length > 0;

function chosen(): ObjectView[] {
  const { objects } = documentStore.getState();
  return selection().flatMap((id) => objects.get(id) ?? []);
}

function groups(): string[] {
  return chosen().flatMap((object) => (object.kind === "group" ? [object.id] : []));
}

async function group(): Promise<void> {
  const id = crypto.randomUUID();
  const done = await edit({ do: "group", id, objects: selection() });
  if (done) select([id]);
}

async function cluster(): Promise<void> {
  const id = crypto.randomUUID();
  const done = await edit({ do: "makeCluster", id, objects: selection() });
  if (done) select([id]);
}

/** Has the browser keep what the selected objects have, as a model that Rhino opens. */
async function bake(): Promise<void> {
  const id = place(location.search).document;
  if (!id) return;
  try {
    await exportAs(id, "3dm", selectedMembers());
  } catch (error) {
    lineStore.setState({ complaint: error instanceof Error ? error.message : String(error) });
  }
}

/** The panel that is selected, alone. The inside of a cluster is no document of its own: nothing is saved from there. */
function lonePanel(): string | undefined {
  const [one, ...others] = chosen();
  const isLone = others.length === 0 && one?.control?.is === "panel" && documentStore.getState().within.length === 0;
  return isLone ? one.id : undefined;
}

/** Has the browser keep what a panel shows, as a file of lines. */
async function savePanel(): Promise<void> {
  const [document, panel] = [place(location.search).document, lonePanel()];
  if (!document || panel === undefined) return;
  try {
    await exportAs(document, "txt", [panel]);
  } catch (error) {
    lineStore.setState({ complaint: error instanceof Error ? error.message : String(error) });
  }
}

register(
  {
    id: "object.savePanel",
    label: "canvas.panel.save",
    group: "object",
    scope: "canvas",
    isEnabled: () => lonePanel() !== undefined,
    run: savePanel,
  },
  {
    id: "object.preview",
    label: "canvas.action.preview",
    keys: ["Mod+Q"],
    group: "object",
    scope: "canvas",
    isEnabled: some,
    run() {
      const all = chosen().filter((object) => object.previews);
      const on = all.some((object) => !object.hidden);
      change(all.map((object) => object.id), { is: "hidden", on });
    },
  },
  {
    id: "object.enabled",
    label: "canvas.action.enabled",
    keys: ["Mod+E"],
    group: "object",
    scope: "canvas",
    isEnabled: some,
    run() {
      const all = chosen().filter((object) => object.kind !== "group");
      const on = all.some((object) => !object.disabled);
      change(all.map((object) => object.id), { is: "disabled", on });
    },
  },
  {
    id: "object.bake",
    label: "canvas.action.bake",
    keys: ["Insert"],
    group: "object",
    scope: "canvas",
    isEnabled: some,
    run: bake,
  },
  {
    id: "object.rename",
    label: "canvas.action.rename",
    keys: ["F2"],
    group: "object",
    scope: "canvas",
    isEnabled: () => selection().length === 1,
    run() {
      const [object] = chosen();
      if (object) openEditor(object.id, object.kind === "group" ? "control" : "nickname");
    },
  },
  {
    id: "canvas.group",
    label: "canvas.action.group",
    keys: ["Mod+G"],
    group: "object",
    scope: "canvas",
    isEnabled: some,
    run: group,
  },
  {
    id: "canvas.ungroup",
    label: "canvas.action.ungroup",
    keys: ["Mod+Shift+G"],
    group: "object",
    scope: "canvas",
    isEnabled: () => groups().length > 0,
    run: () => void edit({ do: "ungroup", groups: groups() }),
  },
  {
    id: "canvas.cluster",
    label: "canvas.action.cluster",
    group: "object",
    scope: "canvas",
    isEnabled: some,
    run: cluster,
  },
  {
    id: "canvas.leave",
    label: "canvas.action.leave",
    keys: ["Mod+ArrowUp"],
    group: "canvas",
    scope: "canvas",
    isEnabled: () => documentStore.getState().within.length > 0,
    run: () => enter(documentStore.getState().within.slice(0, -1)),
  },
  {
    id: "canvas.front",
    label: "canvas.action.front",
    keys: ["Mod+Shift+F"],
    group: "object",
    scope: "canvas",
    isEnabled: some,
    run: () => void edit({ do: "arrange", objects: selection(), back: false }),
  },
  {
    id: "canvas.back",
    label: "canvas.action.back",
    keys: ["Mod+Shift+B"],
    group: "object",
    scope: "canvas",
    isEnabled: some,
    run: () => void edit({ do: "arrange", objects: selection(), back: true }),
  },
);

const ALIGNMENTS: readonly Alignment[] = [
  "left",
  "centre",
  "right",
  "top",
  "middle",
  "bottom",
  "spreadAcross",
  "spreadDown",
];

register(
  ...ALIGNMENTS.map(
    (how): Action => ({
      id: `canvas.align.${how}`,
      label: `canvas.align.${how}`,
      group: "object",
      scope: "canvas",
      isEnabled: () => selection().length > 1,
      run: () => void edit({ do: "align", objects: selection(), how }),
    }),
  ),
);
