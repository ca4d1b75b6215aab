import { useId, useState, type KeyboardEvent, type PointerEvent } from "react";

import { css, type Colour } from "../../core/colours";
import { clamp } from "../../core/geometry";
import { colourText, ofHsv, readColour, steppedHsv, toHsv, type Hsv } from "../../core/hsv";
import { t } from "../../i18n";

type Rgba = [number, number, number, number];

interface Props {
  value: Colour;
  take(colour: Rgba): void;
}

/**
 * A square of saturation and value, strips of hue and of opacity, and a field to type in. Grey has no hue and black no
 * saturation: both are remembered while the picker is open, so that the marks do not jump.
 */
export function ColourPicker({ value, take }: Props) {
  const [kept, setKept] = useState<Hsv>(() => toHsv(value));
  const [typed, setTyped] = useState<string | undefined>(undefined);
  const id = useId();
  const now = same(ofHsv(kept), value) ? kept : toHsv(value);
  const [hue, saturation, brightness] = now;
  const put = (next: Hsv, alpha = value[3]) => {
    setKept(next);
    take(ofHsv(next, alpha));
  };
  const type = (text: string) => {
    setTyped(text);
    const read = readColour(text, value[3]);
    if (!read) return;
    setKept(toHsv(read));
    take(read);
  };
  const alpha = Math.round((value[3] / 255) * 100);
  const opaque = ofHsv(now);
  return (
    <div className="colour-picker">
      <Square hsv={now} put={put} />
      <input
        className="hue"
        type="range"
        min={0}
        max={359}
        value={Math.round(hue) % 360}
        aria-label={t("canvas.colour.hue")}
        onChange={(event) => put([Number(event.target.value), saturation, brightness])}
      />
      <input
        className="alpha"
        type="range"
        min={0}
        max={100}
        value={alpha}
        aria-label={t("canvas.colour.opacity")}
        style={{ ["--end" as string]: css(opaque) }}
        onChange={(event) => put(now, Math.round((Number(event.target.value) / 100) * 255))}
      />
      <div className="typed">
        <span className="now" style={{ background: `linear-gradient(${css(value)}, ${css(value)}), var(--canvas-checks)` }} />
        <label htmlFor={id}>{t("canvas.colour.text")}</label>
        <input
          id={id}
          type="text"
          spellCheck={false}
          value={typed ?? colourText(value)}
          aria-invalid={typed !== undefined && readColour(typed) === undefined}
          onChange={(event) => type(event.target.value)}
          onBlur={() => setTyped(undefined)}
        />
      </div>
    </div>
  );
}

function same(a: Colour, b: Colour): boolean {
  return a[0] === b[0] && a[1] === b[1] && a[2] === b[2];
}

/** The square: saturation across, value up. */
function Square({ hsv, put }: { hsv: Hsv; put(next: Hsv): void }) {
  const [hue, saturation, value] = hsv;
  const follow = (event: PointerEvent<HTMLDivElement>) => {
    const box = event.currentTarget.getBoundingClientRect();
    const x = clamp((event.clientX - box.left) / box.width, 0, 1);
    const y = clamp((event.clientY - box.top) / box.height, 0, 1);
    put([hue, x, 1 - y]);
  };
  const key = (event: KeyboardEvent) => {
    const by = { ArrowLeft: [-1, 0], ArrowRight: [1, 0], ArrowUp: [0, 1], ArrowDown: [0, -1] }[event.key];
    if (!by) return;
    event.preventDefault();
    event.stopPropagation();
    const step = event.shiftKey ? 10 : 1;
    put(steppedHsv(hsv, [(by[0] ?? 0) * step, (by[1] ?? 0) * step]));
  };
  return (
    <div
      className="square-of-colours"
      role="slider"
      tabIndex={0}
      aria-label={t("canvas.colour.square")}
      aria-valuemin={0}
      aria-valuemax={100}
      aria-valuenow={Math.round(saturation * 100)}
      aria-valuetext={t("canvas.colour.at", { saturation: Math.round(saturation * 100), value: Math.round(value * 100) })}
      style={{ backgroundColor: css(ofHsv([hue, 1, 1])) }}
      onPointerDown={(event) => {
        event.currentTarget.setPointerCapture(event.pointerId);
        follow(event);
      }}
      onPointerMove={(event) => event.currentTarget.hasPointerCapture(event.pointerId) && follow(event)}
      onKeyDown={key}
    >
      <span className="at" style={{ left: `${saturation * 100}%`, top: `${(1 - value) * 100}%`, background: css(ofHsv(hsv)) }} />
    </div>
  );
}
