/** The menus of the empty canvas, of groups, and of wires. */

import type { Point } from "../../core/geometry";
import type { Control } from "../../core/protocol/Control";
import type { GroupChange } from "../../core/protocol/GroupChange";
import type { ObjectView } from "../../core/protocol/ObjectView";
import { t } from "../../i18n";
import { documentStore } from "../../state/document";
import { edit } from "../../state/session";
import { remove, selection, unwire } from "../edits";
import { openEditor, openSearch } from "../open";
import { canvasStore, keep } from "../store";
import { LINE, menu, type Item } from "./items";
import { registered } from "./objectMenu";
import { wireDisplays } from "./portMenu";

export function canvasMenu(pixel: Point): Item[] {
  const { scheme } = canvasStore.getState();
  const some = selection().length > 0;
  return menu(
    { is: "do", label: t("canvas.menu.search"), keys: "Space", run: () => openSearch(pixel) },
    registered("edit.paste"),
    LINE,
    ...(some ? selectionItems() : []),
    LINE,
    registered("edit.selectAll"),
    registered("edit.find"),
    registered("view.zoomExtents"),
    registered("view.zoomSelected"),
    registered("solution.recompute"),
    LINE,
    registered("canvas.icons"),
    registered("canvas.fullNames"),
    registered("canvas.profiler"),
    registered("canvas.snapping"),
    registered("canvas.aligning"),
    registered("canvas.ribbon"),
    {
      is: "more",
      label: t("canvas.menu.mouse"),
      items: (["grasshopper", "figma"] as const).map(
        (one): Item => ({
          is: "do",
          label: t(`canvas.mouse.${one}`),
          on: scheme === one,
          run: () => keep({ scheme: one }),
        }),
      ),
    },
  );
}

export function selectionItems(): Item[] {
  const aligns = ["left", "centre", "right", "top", "middle", "bottom", "spreadAcross", "spreadDown"] as const;
  return menu(
    registered("object.preview"),
    registered("object.enabled"),
    registered("canvas.group"),
    registered("canvas.cluster"),
    { is: "more", label: t("canvas.menu.align"), items: menu(...aligns.map((how) => registered(`canvas.align.${how}`))) },
    registered("edit.cut"),
    registered("edit.copy"),
    registered("edit.duplicate"),
    registered("edit.delete"),
  );
}

export function groupMenu(object: ObjectView, group: Extract<Control, { is: "group" }>): Item[] {
  const change = (how: GroupChange) => void edit({ do: "changeGroup", group: object.id, change: how });
  const borders = (["box", "blob", "rectangle"] as const).map(
    (border): Item => ({
      is: "do",
      label: t(`canvas.border.${border}`),
      on: group.border === border,
      run: () => change({ is: "border", border }),
    }),
  );
  const chosen = selection().filter((id) => id !== object.id);
  const members = new Set(group.members);
  return menu(
    { is: "field", label: t("canvas.menu.label"), value: group.label, take: (text) => change({ is: "label", text }) },
    { is: "do", label: t("canvas.menu.paper"), run: () => openEditor(object.id, "control") },
    { is: "more", label: t("canvas.menu.border"), items: borders },
    LINE,
    {
      is: "do",
      label: t("canvas.menu.addToGroup"),
      off: !chosen.some((id) => !members.has(id)),
      run: () => change({ is: "members", members: [...new Set([...group.members, ...chosen])] }),
    },
    {
      is: "do",
      label: t("canvas.menu.removeFromGroup"),
      off: !chosen.some((id) => members.has(id)),
      run: () => change({ is: "members", members: group.members.filter((id) => !chosen.includes(id)) }),
    },
    { is: "do", label: t("canvas.menu.ungroup"), run: () => void edit({ do: "ungroup", groups: [object.id] }) },
    {
      is: "do",
      label: t("canvas.menu.deleteGroup"),
      run: () => void remove([object.id, ...group.members]),
    },
    LINE,
    registered("edit.copy"),
    registered("edit.duplicate"),
  );
}

export function wireMenu(from: string, to: string, at: Point): Item[] {
  const place: [number, number] = [at[0], at[1]];
  const { objects, inputs } = documentStore.getState();
  const held = inputs.get(to);
  const input = held && objects.get(held.object)?.inputs[held.index];
  return [
    ...(input ? [wireDisplays([input])] : []),
    { is: "do", label: t("canvas.menu.unwire"), run: () => unwire(from, to) },
    {
      is: "do",
      label: t("canvas.menu.relay"),
      run: () => void edit({ do: "insertRelay", id: crypto.randomUUID(), from, to, at: place }),
    },
  ];
}
