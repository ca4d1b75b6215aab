/** Gives everything in the model the colour that it has now. */

import type { Rgba } from "../../core/preview";
import type { ViewportSettings } from "../settings";
import { isHidden, type Surroundings } from "../surroundings";
import type { Theme } from "../theme";
import { isTool, layerOf } from "../tools/beside";
import { layerLook, lookOf, toolLook, type ObjectState } from "./looks";
import type { Model } from "./model";

export function dress(model: Model, around: Surroundings, settings: ViewportSettings, { ink, plaster, ground }: Theme): void {
  const { normal, selected, selection, hovered } = around;
  const palette = { normal, selected, ink, plaster, background: ground };
  const looks = new Map<string, Rgba>();
  for (const { id, parts } of model.objects.values()) {
    if (isTool(id)) {
      for (const entry of parts) model.setColour(entry, toolLook(entry.part.kind, entry.part.colour, palette));
      continue;
    }
    const layer = layerOf(id);
    if (layer !== undefined) {
      const colour = around.layers.get(layer) ?? ink;
      for (const entry of parts) model.setColour(entry, layerLook(entry.part.kind, colour, settings.mode, palette, settings.shown));
      continue;
    }
    const own = around.colours?.get(id);
    const state: ObjectState = { selected: selection.has(id), hovered: hovered === id, hidden: isHidden(around, id) };
    for (const entry of parts) {
      const { kind, colour } = entry.part;
      // Most parts look like many others, and to find a colour that is seen on the background takes a while.
      const name = [kind, colour, own, state.selected, state.hovered, state.hidden].join();
      const look = looks.get(name) ?? lookOf(kind, colour, state, settings.mode, own ? { ...palette, normal: own } : palette, settings.shown);
      looks.set(name, look);
      model.setColour(entry, look);
    }
  }
}
