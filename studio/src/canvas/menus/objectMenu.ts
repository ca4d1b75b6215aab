/** The menu of an object's centre. */

import { shownKeys } from "../../actions/keys";
import { action } from "../../actions/registry";
import type { Control } from "../../core/protocol/Control";
import type { ObjectView } from "../../core/protocol/ObjectView";
import type { PanelChange } from "../../core/protocol/PanelChange";
import { graphChoices } from "../../core/graph";
import { leaves } from "../../core/groups";
import { showScript } from "../../dialogs/store";
import { t, type Key } from "../../i18n";
import { edit } from "../../state/session";
import { runStore } from "../../state/run";
import { uiStore } from "../../state/ui";
import { addPort, change, enter, reshape, selection, set } from "../edits";
import { documentStore } from "../../state/document";
import { isViewer, openEditor, turnViewer } from "../open";
import { canvasStore } from "../store";
import { LINE, menu, type Item } from "./items";
import { portItems, portMenu, wireDisplays } from "./portMenu";

/** What the menu is about: the whole selection when the object is in it. */
function concerned(object: ObjectView): string[] {
  return uiStore.getState().selection.has(object.id) ? selection() : [object.id];
}

export function objectMenu(object: ObjectView): Item[] {
  const ids = concerned(object);
  const own = object.inputs[0];
  const isPort = object.kind === "parameter" && own !== undefined;
  return menu(
    {
      is: "field",
      label: t("canvas.menu.name"),
      value: object.nickname,
      take: (text) => change([object.id], { is: "nickname", text }),
    },
    LINE,
    object.previews && {
      is: "do",
      label: t("canvas.menu.preview"),
      on: !object.hidden,
      keys: shownKeys("Mod+Q"),
      run: () => change(ids, { is: "hidden", on: !object.hidden }),
    },
    {
      is: "do",
      label: t("canvas.menu.enabled"),
      on: !object.disabled,
      keys: shownKeys("Mod+E"),
      run: () => change(ids, { is: "disabled", on: !object.disabled }),
    },
    messages(object),
    LINE,
    ...(object.control ? controlItems(object, object.control) : []),
    isViewer(object) && {
      is: "do",
      label: t("canvas.menu.viewerText"),
      on: !canvasStore.getState().drawing.has(object.id),
      run: () => turnViewer(object.id),
    },
    ...(isPort ? [LINE, ...portItems(object, own, "input")] : []),
    LINE,
    !isPort && ports(object, "input"),
    !isPort && ports(object, "output"),
    (!isPort || ids.length > 1) && wiresInto(ids),
    LINE,
    object.kind === "cluster" && {
      is: "do",
      label: t("canvas.menu.enter"),
      run: () => void enter([...documentStore.getState().within, object.id]),
    },
    object.kind === "cluster" && {
      is: "do",
      label: t("canvas.menu.explode"),
      run: () => void edit({ do: "explodeCluster", cluster: object.id }),
    },
    registered("canvas.cluster"),
    registered("canvas.group"),
    object.kind !== "component" && object.kind !== "cluster"
      ? undefined
      : { is: "do", label: t("canvas.menu.find"), run: () => canvasStore.setState({ pointedAt: object.component }) },
    LINE,
    registered("edit.cut"),
    registered("edit.copy"),
    registered("edit.duplicate"),
    registered("edit.delete"),
    joins(object) && {
      is: "do",
      label: t("canvas.menu.deleteJoin"),
      run: () => void edit({ do: "removeAndJoin", object: object.id }),
    },
    LINE,
    registered("object.bake"),
    registered("help.component"),
  );
}

/** How all wires into these objects are drawn; nothing where none come in. */
function wiresInto(ids: readonly string[]): Item | undefined {
  const { objects } = documentStore.getState();
  const wired = [...leaves(ids, objects)].flatMap((id) => objects.get(id)?.inputs.filter(({ sources }) => sources.length > 0) ?? []);
  const label = ids.length > 1 ? "canvas.menu.wiresOfAll" : "canvas.menu.wires";
  return wired.length === 0 ? undefined : wireDisplays(wired, label);
}

/** The menus of its ports, for hands that cannot point at them. */
function ports(object: ObjectView, side: "input" | "output"): Item | undefined {
  const all = side === "input" ? object.inputs : object.outputs;
  const varies = side === "input" ? object.variableInputs : object.variableOutputs;
  const items = all.map((port): Item => ({ is: "more", label: port.name, items: portMenu(object, port, side) }));
  const add: Item = {
    is: "do",
    label: t("canvas.port.addLast"),
    run: () => addPort(object.id, side === "input", all.length),
  };
  if (items.length === 0 && !varies) return undefined;
  const label = t(side === "input" ? "canvas.menu.inputs" : "canvas.menu.outputs");
  return { is: "more", label, items: menu(...items, LINE, varies && add) };
}

function joins(object: ObjectView): boolean {
  return object.kind === "relay" || (object.inputs.length === 1 && object.outputs.length === 1);
}

/** An action of the registry as an entry; nothing where no such action is registered. */
export function registered(id: string): Item | undefined {
  const found = action(id);
  if (!found) return undefined;
  const keys = found.keys?.[0] && shownKeys(found.keys[0]);
  const on = found.isOn?.();
  return {
    is: "do",
    label: t(found.label),
    run: () => void found.run(),
    off: found.isEnabled?.() === false,
    ...(keys === undefined ? {} : { keys }),
    ...(on === undefined ? {} : { on }),
  };
}

function messages(object: ObjectView): Item | undefined {
  const told = runStore.getState().results.get(object.id)?.messages ?? [];
  if (told.length === 0) return undefined;
  const items = told.slice(0, 20).map(({ level, text }): Item => ({ is: "told", level, text }));
  return { is: "more", label: t("canvas.menu.messages", { count: told.length }), items };
}

/** What is special about a control. */
function controlItems(object: ObjectView, control: Control): Item[] {
  const open: Item = { is: "do", label: t("canvas.menu.edit"), run: () => openEditor(object.id, "control") };
  switch (control.is) {
    case "panel":
      return panelItems(object, control);
    case "graph":
      return [open, graphTypes(object, control)];
    case "valueList":
      return [open, listModes(object, control)];
    case "toggle":
      return [
        { is: "do", label: t("canvas.true"), on: control.on, run: () => set(object.id, { is: "switch", on: true }) },
        { is: "do", label: t("canvas.false"), on: !control.on, run: () => set(object.id, { is: "switch", on: false }) },
      ];
    case "script":
      return [{ is: "do", label: t("script.menu"), run: () => showScript(object.id) }];
    case "formula":
      return [{ is: "do", label: t("canvas.menu.script"), run: () => openEditor(object.id, "formula") }];
    case "recorder": {
      const flip = () => reshape(object.id, { ...control, recording: !control.recording });
      return [{ is: "do", label: t("canvas.menu.recording"), on: control.recording, run: flip }];
    }
    case "image":
    case "sketch":
    case "contextual":
    case "group":
      return [];
    default:
      return [open];
  }
}

type PanelControl = Extract<Control, { is: "panel" }>;

const PANEL_SWITCHES: readonly (readonly [Key, (panel: PanelControl) => boolean, (on: boolean) => PanelChange])[] = [
  ["canvas.panel.multiline", (panel) => panel.multiline, (on) => ({ is: "multiline", on })],
  ["canvas.panel.paths", (panel) => panel.paths, (on) => ({ is: "paths", on })],
  ["canvas.panel.indices", (panel) => panel.indices, (on) => ({ is: "indices", on })],
  ["canvas.panel.wrap", (panel) => panel.wrap, (on) => ({ is: "wrap", on })],
  ["canvas.panel.codes", (panel) => panel.specialCodes, (on) => ({ is: "specialCodes", on })],
];

function panelItems(object: ObjectView, panel: PanelControl): Item[] {
  const changed = (how: PanelChange) => void edit({ do: "changePanel", object: object.id, change: how });
  const switches = PANEL_SWITCHES.map(
    ([label, read, make]): Item => ({ is: "do", label: t(label), on: read(panel), run: () => changed(make(!read(panel))) }),
  );
  const sides = (["left", "centre", "right"] as const).map(
    (side, alignment): Item => ({
      is: "do",
      label: t(`canvas.side.${side}`),
      on: panel.alignment === alignment,
      run: () => changed({ is: "alignment", alignment }),
    }),
  );
  return [
    { is: "do", label: t("canvas.menu.write"), run: () => canvasStore.setState({ writing: object.id }) },
    ...switches,
    { is: "more", label: t("canvas.panel.alignment"), items: sides },
    { is: "do", label: t("canvas.menu.paper"), run: () => openEditor(object.id, "control") },
    { is: "do", label: t("canvas.panel.stream"), on: panel.stream !== null, run: () => openEditor(object.id, "stream") },
    ...menu(registered("object.savePanel")),
  ];
}

function graphTypes(object: ObjectView, control: Extract<Control, { is: "graph" }>): Item {
  const { graph } = control;
  const items = graphChoices(graph.name).map(
    (name): Item => ({
      is: "do",
      label: name,
      on: graph.name === name,
      run: () => name !== graph.name && reshape(object.id, { ...control, graph: { name, handles: [] } }),
    }),
  );
  return { is: "more", label: t("canvas.menu.graph"), items };
}

function listModes(object: ObjectView, control: Extract<Control, { is: "valueList" }>): Item {
  const items = (["check", "dropDown", "sequence", "cycle"] as const).map(
    (mode): Item => ({
      is: "do",
      label: t(`canvas.list.${mode}`),
      on: control.mode === mode,
      run: () => reshape(object.id, { ...control, mode }),
    }),
  );
  return { is: "more", label: t("canvas.menu.listMode"), items };
}
