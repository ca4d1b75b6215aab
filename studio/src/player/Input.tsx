import { useRef } from "react";

import { fromHex, toHex } from "../core/colour";
import { dayOf, dayText, secondsOf, timeText } from "../core/dates";
import type { Control } from "../core/protocol/Control";
import type { Setting } from "../core/protocol/Setting";
import { t } from "../i18n";
import { edit, newGesture } from "../state/session";
import type { ShownInput } from "./groups";

/** One control of the player. */
export function Input({ input: { object, label, help } }: { input: ShownInput }) {
  const gesture = useRef<number>(undefined);
  const set = (to: Setting) => void edit({ do: "set", object: object.id, to }, gesture.current ?? null);
  const hold = {
    onPointerDown: () => {
      gesture.current = newGesture();
    },
    onPointerUp: () => {
      gesture.current = undefined;
    },
  };
  const field = object.control && face(object.control, label, set, hold);
  if (!field) return null;
  return (
    <div className="input">
      {field}
      {help && <p className="soft">{help}</p>}
    </div>
  );
}

interface Hold {
  onPointerDown(): void;
  onPointerUp(): void;
}

function face(control: Control, name: string, set: (to: Setting) => void, hold: Hold) {
  switch (control.is) {
    case "slider":
    case "knob": {
      const digits = control.is === "slider" ? (control.rounding === "float" ? control.digits : 0) : control.decimals;
      const number = (value: number) => Number.isFinite(value) && set({ is: "number", value });
      const range = control.is === "slider" || control.limited ? [control.min, control.max] : undefined;
      return (
        <label>
          <span>{name}</span>
          <span className="row">
            {range && (
              <input
                type="range"
                min={range[0]}
                max={range[1]}
                step={10 ** -digits}
                value={control.value}
                onChange={(event) => number(event.target.valueAsNumber)}
                {...hold}
              />
            )}
            <input
              type="number"
              aria-label={t("player.value", { name })}
              step={10 ** -digits}
              value={control.value}
              onChange={(event) => number(event.target.valueAsNumber)}
            />
          </span>
        </label>
      );
    }
    case "toggle":
      return (
        <label className="row">
          <input type="checkbox" checked={control.on} onChange={(event) => set({ is: "switch", on: event.target.checked })} />
          <span>{name}</span>
        </label>
      );
    case "button": {
      const press = (down: boolean) => () => set({ is: "press", down });
      return (
        <button
          type="button"
          onPointerDown={press(true)}
          onPointerUp={press(false)}
          onKeyDown={(event) => !event.repeat && event.key === " " && set({ is: "press", down: true })}
          onKeyUp={(event) => event.key === " " && set({ is: "press", down: false })}
        >
          {name}
        </button>
      );
    }
    case "valueList": {
      const several = control.mode === "check";
      const chosen = control.items.flatMap((item, index) => (item.selected ? [String(index)] : []));
      return (
        <label>
          <span>{name}</span>
          <select
            multiple={several}
            value={several ? chosen : (chosen[0] ?? "")}
            onChange={(event) => set({ is: "choose", chosen: [...event.target.selectedOptions].map((option) => Number(option.value)) })}
          >
            {control.items.map((item, index) => (
              <option key={index} value={index}>
                {item.name}
              </option>
            ))}
          </select>
        </label>
      );
    }
    case "swatch":
      return (
        <label>
          <span>{name}</span>
          <input
            type="color"
            value={toHex(control.colour)}
            onChange={(event) => set({ is: "colour", colour: fromHex(event.target.value, control.colour[3]) })}
          />
        </label>
      );
    case "calendar":
      return (
        <label>
          <span>{name}</span>
          <input
            type="date"
            required
            value={dayText(control.date)}
            onChange={(event) => {
              const date = dayOf(event.target.value);
              if (date) set({ is: "date", date });
            }}
          />
        </label>
      );
    case "clock":
      return (
        <label>
          <span>{name}</span>
          <input
            type="time"
            required
            value={timeText(control.seconds)}
            onChange={(event) => {
              const seconds = secondsOf(event.target.value);
              if (seconds !== undefined) set({ is: "time", seconds });
            }}
          />
        </label>
      );
    case "panel":
      return (
        <label>
          <span>{name}</span>
          <textarea
            key={control.text}
            rows={2}
            defaultValue={control.text}
            onBlur={(event) => event.target.value !== control.text && set({ is: "text", text: event.target.value })}
          />
        </label>
      );
    default:
      return undefined;
  }
}
