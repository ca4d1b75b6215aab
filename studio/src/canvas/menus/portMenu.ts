/** The menu of an input or output. */

import type { MappingView } from "../../core/protocol/MappingView";
import type { ObjectView } from "../../core/protocol/ObjectView";
import type { PortChange } from "../../core/protocol/PortChange";
import type { PortView } from "../../core/protocol/PortView";
import type { WireView } from "../../core/protocol/WireView";
import { t, type Key } from "../../i18n";
import { SETTABLE } from "../../core/drawing";
import { documentStore } from "../../state/document";
import { beginPick, isSettable } from "../../state/pickJob";
import { edit, newGesture } from "../../state/session";
import { changePort, removePort, unwire } from "../edits";
import { gripOf } from "../gestures/world";
import { openEditor } from "../open";
import { canvasStore } from "../store";
import { LINE, menu, type Item } from "./items";

export function portMenu(object: ObjectView, port: PortView, side: "input" | "output"): Item[] {
  const nickname: Item = {
    is: "field",
    label: t("canvas.menu.name"),
    value: port.nickname,
    take: (text) => changePort(port.id, { is: "nickname", text }),
  };
  const remove = port.removable && {
    is: "do" as const,
    label: t("canvas.port.remove", { name: port.nickname }),
    run: () => removePort(port.id),
  };
  return menu(nickname, LINE, ...portItems(object, port, side), LINE, remove);
}

/** What a port's menu and a floating parameter's menu have in common. */
export function portItems(object: ObjectView, port: PortView, side: "input" | "output"): Item[] {
  const input = side === "input";
  const floating = object.kind === "parameter";
  return menu(
    { is: "do", label: t("canvas.menu.connect"), keys: "C", run: () => connect(port, side) },
    input && wireDisplay(port),
    input ? disconnect(port) : readers(port),
    LINE,
    flag(port, "canvas.modifier.reverse", port.reverse, (on) => ({ is: "reverse", on })),
    mapping(port, "flatten"),
    mapping(port, "graft"),
    flag(port, "canvas.modifier.simplify", port.simplify, (on) => ({ is: "simplify", on })),
    flag(port, "canvas.modifier.reparameterize", port.reparameterize, (on) => ({ is: "reparameterize", on }), GEOMETRIC),
    flag(port, "canvas.modifier.invert", port.invert, (on) => ({ is: "invert", on }), ["Boolean"]),
    flag(port, "canvas.modifier.degrees", port.degrees, (on) => ({ is: "degrees", on }), ["Number", "Angle"]),
    flag(port, "canvas.modifier.unitize", port.unitize, (on) => ({ is: "unitize", on }), ["Vector"]),
    input &&
      !floating &&
      flag(port, "canvas.modifier.principal", port.principal, (on) => ({ is: "principal", on })),
    LINE,
    { is: "do", label: t("canvas.menu.expression"), run: () => openEditor(object.id, "expression", { port: port.id }) },
    ...(input ? setItems(port) : []),
    input && { is: "do", label: t("canvas.menu.values"), run: () => openEditor(object.id, "values", { port: port.id }) },
    input && {
      is: "do",
      label: t("canvas.menu.clear", { count: port.kept }),
      off: port.kept === 0,
      run: () => void edit({ do: "keep", port: port.id, values: null }),
    },
    {
      is: "do",
      label: t("canvas.menu.internalise"),
      off: input && port.sources.length === 0,
      run: () => void edit({ do: "internalise", port: port.id }),
    },
    input && !floating && {
      is: "do",
      label: t("canvas.menu.extract"),
      run: () => void edit({ do: "extract", port: port.id, id: crypto.randomUUID() }),
    },
  );
}

/** *Set one* and *Set multiple*, for what can be picked or drawn. */
function setItems(port: PortView): Item[] {
  if (!SETTABLE.has(port.kind)) return [];
  const kind = t(`pick.kind.${port.kind}` as Key);
  const item = (label: Key, isMany: boolean): Item => ({
    is: "do",
    label: t(label, { kind }),
    off: !isSettable(port),
    run: () => beginPick(port, isMany),
  });
  return [item("pick.menu.one", false), item("pick.menu.many", true)];
}

const GEOMETRIC = ["Curve", "Surface", "Brep", "Geometry", "Line", "Arc", "Circle"];

function flag(
  port: PortView,
  label: Key,
  on: boolean,
  make: (on: boolean) => PortChange,
  kinds?: readonly string[],
): Item | undefined {
  if (kinds && !on && !kinds.includes(port.kind)) return undefined;
  return { is: "do", label: t(label), on, run: () => changePort(port.id, make(!on)) };
}

function mapping(port: PortView, which: Exclude<MappingView, "none">): Item {
  const on = port.mapping === which;
  const next: PortChange = { is: "mapping", mapping: on ? "none" : which };
  return { is: "do", label: t(`canvas.modifier.${which}`), on, run: () => changePort(port.id, next) };
}

function connect(port: PortView, side: "input" | "output"): void {
  canvasStore.setState({ connecting: gripOf(port.id, side) });
}

function wireDisplay(port: PortView): Item {
  return wireDisplays([port]);
}

/** How the wires into inputs are drawn, of all of them at once: one step for Undo. */
export function wireDisplays(ports: readonly PortView[], label: Key = "canvas.menu.wires"): Item {
  const items = (["normal", "faint", "hidden"] as const).map(
    (wire: WireView): Item => ({
      is: "do",
      label: t(`canvas.wire.${wire}`),
      on: ports.every((port) => port.wire === wire),
      run: () => {
        const gesture = newGesture();
        for (const { id } of ports) void edit({ do: "changePort", port: id, change: { is: "wire", wire } }, gesture);
      },
    }),
  );
  return { is: "more", label: t(label), items };
}

/** Each wire by the name of its other end; pointing at an entry shows the wire. */
function wireEntry(from: string, to: string, name: string): Item {
  return {
    is: "do",
    label: name,
    run: () => unwire(from, to),
    hover: (on) => canvasStore.setState({ hotWire: on ? { from, to } : undefined }),
  };
}

function disconnect(port: PortView): Item | undefined {
  const { objects, outputs } = documentStore.getState();
  if (port.sources.length === 0) return undefined;
  const entries = port.sources.map((from) => {
    const place = outputs.get(from);
    const object = place ? objects.get(place.object) : undefined;
    return wireEntry(from, port.id, nameOf(object, object?.outputs[place?.index ?? -1]));
  });
  const all: Item = {
    is: "do",
    label: t("canvas.menu.disconnectAll"),
    run: () => void edit({ do: "disconnect", port: port.id }),
  };
  return { is: "more", label: t("canvas.menu.disconnect"), items: menu(...entries, LINE, entries.length > 1 && all) };
}

function readers(port: PortView): Item | undefined {
  const entries: Item[] = [];
  for (const object of documentStore.getState().objects.values()) {
    for (const input of object.inputs) {
      if (input.sources.includes(port.id)) entries.push(wireEntry(port.id, input.id, nameOf(object, input)));
    }
  }
  return entries.length === 0 ? undefined : { is: "more", label: t("canvas.menu.disconnect"), items: entries };
}

function nameOf(object: ObjectView | undefined, port: PortView | undefined): string {
  if (!object) return t("canvas.menu.lost");
  const name = object.nickname.trim() || object.name;
  return port && port.id !== object.id ? `${name} · ${port.nickname || port.name}` : name;
}
