import { useState, type KeyboardEvent, type PointerEvent } from "react";

import { css, type Colour } from "../../core/colours";
import { colourText } from "../../core/hsv";
import type { ObjectView } from "../../core/protocol/ObjectView";
import { textWidth } from "../../core/text";
import { t } from "../../i18n";
import { set } from "../edits";
import { openEditor } from "../open";

/** The room for a name at the left, 0 where there is not enough of it. */
export function titleRoom(object: ObjectView, width: number, need: number): number {
  const named = textWidth(object.nickname.trim() || object.name, 11) + 14;
  return named + need > width ? 0 : named;
}

export function Title({ object, room }: { object: ObjectView; room: number }) {
  if (room <= 0) return <span className="above">{object.nickname.trim() || object.name}</span>;
  return (
    <span className="title" style={{ width: room }}>
      {object.nickname.trim() || object.name}
    </span>
  );
}

/** Space and Enter work on what is not a button of the page but is one for people. */
function onActivate(run: () => void) {
  return (event: KeyboardEvent) => {
    if (event.key !== " " && event.key !== "Enter") return;
    event.preventDefault();
    event.stopPropagation();
    run();
  };
}

/** A Boolean Toggle: a double-click on its value turns it, as does Space. */
export function ToggleFace({ object, on, width }: { object: ObjectView; on: boolean; width: number }) {
  const room = titleRoom(object, width, 40);
  const flip = () => set(object.id, { is: "switch", on: !on });
  return (
    <>
      <Title object={object} room={room} />
      <span
        className={`pill ${on ? "on" : ""}`}
        style={{ left: room + 3 }}
        role="switch"
        aria-checked={on}
        aria-label={object.nickname.trim() || object.name}
        tabIndex={-1}
        data-inner
        onDoubleClick={(event) => {
          event.stopPropagation();
          flip();
        }}
        onKeyDown={onActivate(flip)}
      >
        {t(on ? "canvas.true" : "canvas.false")}
      </span>
    </>
  );
}

/** A Button: true while it is held. */
export function ButtonFace({ object, width }: { object: ObjectView; width: number }) {
  const [held, setHeld] = useState(false);
  const room = titleRoom(object, width, 44);
  const press = (down: boolean) => {
    if (down === held) return;
    setHeld(down);
    set(object.id, { is: "press", down });
  };
  return (
    <>
      <Title object={object} room={room} />
      <span
        className={`pill ${held ? "on" : ""}`}
        style={{ left: room + 3 }}
        role="button"
        aria-pressed={held}
        aria-label={object.nickname.trim() || object.name}
        tabIndex={-1}
        data-inner
        data-own
        onPointerDown={(event: PointerEvent<HTMLSpanElement>) => {
          if (event.button !== 0) return;
          event.stopPropagation();
          event.currentTarget.setPointerCapture(event.pointerId);
          press(true);
        }}
        onPointerUp={() => press(false)}
        onPointerCancel={() => press(false)}
        onKeyDown={onActivate(() => press(true))}
        onKeyUp={() => press(false)}
        onBlur={() => press(false)}
      >
        {t(held ? "canvas.true" : "canvas.press")}
      </span>
    </>
  );
}

/** A Colour Swatch or Picker: a press on it opens the picker. */
export function SwatchFace({ object, colour, width }: { object: ObjectView; colour: Colour; width: number }) {
  const room = titleRoom(object, width, 24);
  return (
    <>
      <Title object={object} room={room} />
      <button
        type="button"
        className="swatch"
        style={{ left: room + 3, background: `linear-gradient(${css(colour)}, ${css(colour)}), var(--canvas-checks)` }}
        tabIndex={-1}
        data-inner
        data-own
        aria-label={t("canvas.colour.of", { name: object.nickname.trim() || object.name, colour: colourText(colour) })}
        onClick={() => openEditor(object.id, "control")}
        onDoubleClick={(event) => event.stopPropagation()}
      />
    </>
  );
}
