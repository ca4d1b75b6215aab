import { useEffect, useRef, useState } from "react";

import type { Control } from "../../core/protocol/Control";
import type { ObjectView } from "../../core/protocol/ObjectView";
import { t } from "../../i18n";
import { liveSetting, type LiveSetting } from "../edits";
import type { Setting } from "../../core/protocol/Setting";
import { closeBoxes } from "../open";
import { ColourPicker } from "./ColourPicker";

type Swatch = Extract<Control, { is: "swatch" }>;

/**
 * The colour of a swatch, picked while the model follows. All of it is one step for Undo; Escape and Cancel take it
 * back, and a press elsewhere keeps it.
 */
export function SwatchEditor({ object, swatch }: { object: ObjectView; swatch: Swatch }) {
  const [colour, setColour] = useState(swatch.colour);
  const live = useRef<LiveSetting<Setting> | undefined>(undefined);
  const finish = (how: "end" | "abandon") => {
    live.current?.[how]();
    live.current = undefined;
  };
  useEffect(() => () => finish("end"), []);
  return (
    <form
      onSubmit={(event) => {
        event.preventDefault();
        closeBoxes();
      }}
      onKeyDown={(event) => {
        if (event.key === "Escape") finish("abandon");
      }}
    >
      <h3>{object.nickname.trim() || object.name}</h3>
      <ColourPicker
        value={colour}
        take={(next) => {
          setColour(next);
          live.current ??= liveSetting(object.id);
          live.current.send({ is: "colour", colour: next });
        }}
      />
      <div className="form-end">
        <button
          type="button"
          onClick={() => {
            finish("abandon");
            closeBoxes();
          }}
        >
          {t("canvas.form.cancel")}
        </button>
        <button type="submit" className="first">
          {t("canvas.form.take")}
        </button>
      </div>
    </form>
  );
}
