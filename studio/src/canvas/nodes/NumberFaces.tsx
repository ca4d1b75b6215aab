import type { KeyboardEvent, PointerEvent } from "react";

import { clamp } from "../../core/geometry";
import { digitsText, numberText } from "../../core/numbers";
import type { Control } from "../../core/protocol/Control";
import type { ObjectView } from "../../core/protocol/ObjectView";
import { fineness, rounded } from "../../core/slider";
import { t } from "../../i18n";
import { follow } from "../drag";
import { liveSetting, set } from "../edits";
import { lens } from "../view";
import { useLive } from "./live";
import { titleRoom, Title } from "./SmallFaces";

type Of<K extends Control["is"]> = Extract<Control, { is: K }>;

/** An MD Slider: a grip in a square. */
export function MdSliderFace(props: { object: ObjectView; control: Of<"mdSlider">; size: readonly [number, number] }) {
  const { object, control } = props;
  const [width, height] = [props.size[0] - 12, props.size[1] - 12];
  const [value, setLive] = useLive(control.value);
  const at = (k: 0 | 1) => control.domains[k][0] + value[k] * (control.domains[k][1] - control.domains[k][0]);
  const press = (event: PointerEvent<HTMLDivElement>) => {
    const setting = liveSetting(object.id);
    const start = value;
    follow(event, {
      move([dx, dy], pointer) {
        const scale = fineness(pointer) / lens().zoom;
        const next: [number, number, number] = [
          clamp(start[0] + (dx * scale) / width, 0, 1),
          clamp(start[1] - (dy * scale) / height, 0, 1),
          start[2],
        ];
        setLive(next);
        setting.send({ is: "place", value: next });
      },
      end: setting.end,
      abandon() {
        setLive(undefined);
        setting.abandon();
      },
    });
  };
  const key = (event: KeyboardEvent) => {
    const by = { ArrowLeft: [-1, 0], ArrowRight: [1, 0], ArrowUp: [0, 1], ArrowDown: [0, -1] }[event.key];
    if (!by || event.altKey || event.ctrlKey) return;
    event.preventDefault();
    event.stopPropagation();
    const step = event.shiftKey ? 0.1 : 0.01;
    const move = (k: 0 | 1) => clamp(value[k] + (by[k] ?? 0) * step, 0, 1);
    set(object.id, { is: "place", value: [move(0), move(1), value[2]] });
  };
  const text = `${numberText(at(0))}, ${numberText(at(1))}`;
  return (
    <div
      className="square"
      style={{ width, height }}
      role="slider"
      tabIndex={-1}
      data-inner
      data-own
      aria-label={object.nickname.trim() || object.name}
      aria-valuenow={at(0)}
      aria-valuemin={control.domains[0][0]}
      aria-valuemax={control.domains[0][1]}
      aria-valuetext={text}
      onPointerDown={press}
      onKeyDown={key}
    >
      <span className="hair across" style={{ top: (1 - value[1]) * height }} />
      <span className="hair down" style={{ left: value[0] * width }} />
      <span className="grip-dot" style={{ left: value[0] * width, top: (1 - value[1]) * height }} />
      <span className="corner">{text}</span>
    </div>
  );
}

/** A Control Knob: a turn is its range; drag around it or up and down. */
export function KnobFace({ object, knob, size }: { object: ObjectView; knob: Of<"knob">; size: readonly [number, number] }) {
  const [value, setLive] = useLive(knob.value);
  const range = knob.range === 0 ? 1 : Math.abs(knob.range);
  const side = Math.min(size[0], size[1]) - 10;
  const fitted = (x: number) => {
    const kept = knob.limited ? clamp(x, Math.min(knob.min, knob.max), Math.max(knob.min, knob.max)) : x;
    return rounded(kept, clamp(knob.decimals, 0, 12));
  };
  const press = (event: PointerEvent<HTMLDivElement>) => {
    const setting = liveSetting(object.id);
    const box = event.currentTarget.getBoundingClientRect();
    const [cx, cy] = [box.left + box.width / 2, box.top + box.height / 2];
    let angle = Math.atan2(event.clientX - cx, cy - event.clientY);
    let turned = value;
    follow(event, {
      move(_, pointer) {
        const next = Math.atan2(pointer.clientX - cx, cy - pointer.clientY);
        const by = Math.atan2(Math.sin(next - angle), Math.cos(next - angle));
        angle = next;
        turned += (by / (2 * Math.PI)) * range * fineness(pointer);
        setLive(fitted(turned));
        setting.send({ is: "number", value: fitted(turned) });
      },
      end: setting.end,
      abandon() {
        setLive(undefined);
        setting.abandon();
      },
    });
  };
  const key = (event: KeyboardEvent) => {
    const up = event.key === "ArrowUp" || event.key === "ArrowRight";
    if ((!up && event.key !== "ArrowDown" && event.key !== "ArrowLeft") || event.altKey || event.ctrlKey) return;
    event.preventDefault();
    event.stopPropagation();
    const step = 10 ** -clamp(knob.decimals, 0, 12) * (event.shiftKey ? 10 : 1);
    set(object.id, { is: "number", value: fitted(value + (up ? step : -step)) });
  };
  return (
    <div
      className="knob-face"
      style={{ width: side, height: side }}
      role="slider"
      tabIndex={-1}
      data-inner
      data-own
      aria-label={object.nickname.trim() || object.name}
      aria-valuenow={value}
      {...(knob.limited ? { "aria-valuemin": knob.min, "aria-valuemax": knob.max } : {})}
      onPointerDown={press}
      onKeyDown={key}
    >
      <span className="hand" style={{ transform: `rotate(${(value / range) * 360}deg)` }} />
      <span className="value">{value.toFixed(clamp(knob.decimals, 0, 12))}</span>
    </div>
  );
}

/** A Digit Scroller: each digit is dragged up and down for itself. */
export function DigitsFace({ object, digits, width }: { object: ObjectView; digits: Of<"digits">; width: number }) {
  const [value, setLive] = useLive(digits.value);
  const after = Math.max(0, digits.digits - digits.radix);
  const text = digitsText(value, digits.digits, digits.radix);
  const point = text.indexOf(".");
  const room = titleRoom(object, width, text.length * 9 + 10);
  const press = (place: number) => (event: PointerEvent<HTMLSpanElement>) => {
    const setting = liveSetting(object.id);
    follow(event, {
      move([, dy]) {
        const next = rounded(value - Math.round(dy / (8 * lens().zoom)) * 10 ** place, after);
        setLive(next);
        setting.send({ is: "number", value: next });
      },
      end: setting.end,
      abandon() {
        setLive(undefined);
        setting.abandon();
      },
    });
  };
  const letters = [...text];
  return (
    <>
      <Title object={object} room={room} />
      <div
        className="field digits"
        style={{ left: room }}
        role="spinbutton"
        tabIndex={-1}
        data-inner
        data-own
        aria-label={object.nickname.trim() || object.name}
        aria-valuenow={value}
        onKeyDown={(event) => {
          const by = event.key === "ArrowUp" ? 1 : event.key === "ArrowDown" ? -1 : 0;
          if (by === 0) return;
          event.preventDefault();
          event.stopPropagation();
          set(object.id, { is: "number", value: rounded(value + by * 10 ** -after, after) });
        }}
      >
        {digits.prefix}
        {letters.map((letter, k) => {
          if (!/\d/.test(letter)) return <span key={k}>{letter}</span>;
          const whole = point < 0 ? letters.length : point;
          const place = k < whole ? whole - 1 - k : whole - k;
          return (
            <span key={k} className="digit" title={t("canvas.digits.drag")} onPointerDown={press(place)}>
              {letter}
            </span>
          );
        })}
        {digits.suffix}
      </div>
    </>
  );
}

/** A Gene Pool: sliders one below the other. */
export function GenesFace({ object, genes, size }: { object: ObjectView; genes: Of<"genes">; size: readonly [number, number] }) {
  const width = size[0] - 12;
  const rows = Math.max(genes.values.length, 1);
  const height = Math.max((size[1] - 10) / rows, 1);
  return (
    <div className="genes" data-own>
      {genes.values.map((value, index) => (
        <Gene key={index} {...{ object, genes, value, index, width, height }} />
      ))}
    </div>
  );
}

interface GeneProps {
  object: ObjectView;
  genes: Of<"genes">;
  value: number;
  index: number;
  width: number;
  height: number;
}

function Gene({ object, genes, value, index, width, height }: GeneProps) {
  const [shown, setLive] = useLive(value);
  const range = genes.max - genes.min || 1;
  const digits = clamp(genes.decimals, 0, 12);
  const fitted = (x: number) => rounded(clamp(x, Math.min(genes.min, genes.max), Math.max(genes.min, genes.max)), digits);
  const press = (event: PointerEvent<HTMLDivElement>) => {
    const setting = liveSetting(object.id);
    const start = shown;
    follow(event, {
      move([dx], pointer) {
        const next = fitted(start + ((dx * fineness(pointer)) / (width * lens().zoom)) * range);
        setLive(next);
        setting.send({ is: "gene", index, value: next });
      },
      end: setting.end,
      abandon() {
        setLive(undefined);
        setting.abandon();
      },
    });
  };
  return (
    <div
      className="gene"
      style={{ width, height }}
      role="slider"
      tabIndex={-1}
      data-inner
      aria-label={t("canvas.gene", { index, name: object.nickname.trim() || object.name })}
      aria-valuenow={shown}
      aria-valuemin={genes.min}
      aria-valuemax={genes.max}
      onPointerDown={press}
      onKeyDown={(event) => {
        const by = event.key === "ArrowRight" || event.key === "ArrowUp" ? 1 : event.key === "ArrowLeft" || event.key === "ArrowDown" ? -1 : 0;
        if (by === 0 || event.altKey || event.ctrlKey) return;
        event.preventDefault();
        event.stopPropagation();
        set(object.id, { is: "gene", index, value: fitted(shown + by * 10 ** -digits * (event.shiftKey ? 10 : 1)) });
      }}
    >
      <span className="bar" style={{ width: `${clamp((shown - genes.min) / range, 0, 1) * 100}%` }} />
      {height >= 9 ? <span className="value">{shown.toFixed(digits)}</span> : null}
    </div>
  );
}
