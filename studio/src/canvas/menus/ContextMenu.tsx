import { useEffect } from "react";

import { t } from "../../i18n";
import { documentStore } from "../../state/document";
import { useCanvas } from "../hooks";
import { closeBoxes } from "../open";
import { canvasStore, type MenuAt } from "../store";
import { canvasMenu, groupMenu, wireMenu } from "./groundMenu";
import type { Item } from "./items";
import { Menu } from "./Menu";
import { objectMenu } from "./objectMenu";
import { portMenu } from "./portMenu";
import { viewsMenu, zoomMenu } from "./zoomMenu";

/** The menu of what lay below the pointer, or of what the keyboard is at. */
export function ContextMenu() {
  const at = useCanvas((canvas) => canvas.menu);
  useEffect(() => {
    if (!at) return undefined;
    const { target } = at;
    if (target.is === "wire") canvasStore.setState({ hotWire: { from: target.from, to: target.to } });
    const close = (event: PointerEvent) => {
      if (event.target instanceof Element && event.target.closest(".pop-menu")) return;
      canvasStore.setState({ menu: undefined, hotWire: undefined });
    };
    window.addEventListener("pointerdown", close);
    return () => window.removeEventListener("pointerdown", close);
  }, [at]);
  if (!at) return null;
  const items = itemsOf(at);
  if (items.length === 0) return null;
  return <Menu key={at.pixel.join()} items={items} pixel={at.pixel} above={at.above ?? false} label={t("canvas.menu")} onClose={closeBoxes} />;
}

function itemsOf({ target, pixel, at }: MenuAt): Item[] {
  const { objects } = documentStore.getState();
  switch (target.is) {
    case "void":
      return canvasMenu(pixel);
    case "zoom":
      return zoomMenu();
    case "views":
      return viewsMenu();
    case "wire":
      return wireMenu(target.from, target.to, at);
    case "grip": {
      const { port: id, side, object: owner } = target.grip;
      const object = objects.get(owner);
      const port = (side === "input" ? object?.inputs : object?.outputs)?.find((one) => one.id === id);
      if (!object || !port) return [];
      return object.kind === "parameter" || port.id === object.id ? objectMenu(object) : portMenu(object, port, side);
    }
    case "centre":
    case "object": {
      const object = objects.get(target.id);
      if (!object) return [];
      return object.control?.is === "group" ? groupMenu(object, object.control) : objectMenu(object);
    }
  }
}
