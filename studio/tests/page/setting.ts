import type { Control } from "../../src/core/protocol/Control";
import type { Setting } from "../../src/core/protocol/Setting";
import { snapped } from "../../src/core/slider";

/** A control after a value was set. */
export function takeSetting(control: Control, to: Setting): Control {
  if (to.is === "number" && control.is === "slider") return { ...control, value: snapped(control, to.value) };
  if (to.is === "number" && (control.is === "knob" || control.is === "digits")) return { ...control, value: to.value };
  if (to.is === "text" && control.is === "panel") return { ...control, text: to.text };
  if (to.is === "switch" && control.is === "toggle") return { ...control, on: to.on };
  if (to.is === "colour" && control.is === "swatch") return { ...control, colour: to.colour };
  if (to.is === "place" && control.is === "mdSlider") return { ...control, value: to.value };
  if (to.is === "choose" && control.is === "valueList") {
    const items = control.items.map((item, k) => ({ ...item, selected: to.chosen.includes(k) }));
    return { ...control, items };
  }
  if (to.is === "gene" && control.is === "genes") {
    return { ...control, values: control.values.map((value, k) => (k === to.index ? to.value : value)) };
  }
  if (to.is === "date" && control.is === "calendar") return { ...control, date: to.date, shown: [to.date[0], to.date[1]] };
  if (to.is === "time" && control.is === "clock") return { ...control, seconds: to.seconds };
  return control;
}
