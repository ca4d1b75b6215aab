import { useState } from "react";

import { css, gradientCss } from "../../core/colours";
import { clamp } from "../../core/geometry";
import { mirrored, preset, PRESETS, withGrip, withoutGrip } from "../../core/gradient";
import type { Control } from "../../core/protocol/Control";
import type { GripView } from "../../core/protocol/GripView";
import type { ObjectView } from "../../core/protocol/ObjectView";
import { t } from "../../i18n";
import { reshape } from "../edits";
import { ColourPicker } from "./ColourPicker";
import { Form, NumberLine, SwitchLine } from "./fields";

type Gradient = Extract<Control, { is: "gradient" }>;

/** A gradient's grips, one at a time: where it stands, and the colours to its left and right. */
export function GradientEditor({ object, gradient, index }: { object: ObjectView; gradient: Gradient; index: number }) {
  const [form, setForm] = useState(gradient);
  const [at, setAt] = useState(index);
  const [side, setSide] = useState<"left" | "right">("left");
  const chosen = Math.min(at, form.grips.length - 1);
  const grip = form.grips[chosen];
  const sharp = grip !== undefined && css(grip.left) !== css(grip.right);
  const [parted, setParted] = useState(sharp);
  const take = (grips: GripView[]) => setForm((old) => ({ ...old, grips }));
  const put = (part: Partial<GripView>) => take(form.grips.map((one, k) => (k === chosen ? { ...one, ...part } : one)));
  const paint = (colour: GripView["left"]) => put(parted ? { [side]: colour } : { left: colour, right: colour });
  const part = (on: boolean) => {
    setParted(on);
    if (!on && grip) put({ right: grip.left });
    setSide("left");
  };
  const choose = (next: number) => {
    setAt(next);
    const other = form.grips[next];
    setParted(other !== undefined && css(other.left) !== css(other.right));
    setSide("left");
  };
  const restart = (grips: GripView[]) => {
    take(grips);
    setAt(0);
    setParted(false);
  };
  return (
    <Form title={t("canvas.gradient.title")} onTake={() => reshape(object.id, form)}>
      <div className="gradient-shown" style={{ background: gradientCss(form.grips) }}>
        {form.grips.map((one, k) => (
          <button
            key={k}
            type="button"
            className="stop"
            aria-label={t("canvas.gradient.number", { number: k + 1 })}
            aria-pressed={k === chosen}
            style={{ left: `${one.at * 100}%`, background: css(one.right) }}
            onClick={() => choose(k)}
          />
        ))}
      </div>
      <div className="presets" role="group" aria-label={t("canvas.gradient.presets")}>
        {PRESETS.map((name) => (
          <button
            key={name}
            type="button"
            title={t(`canvas.gradient.preset.${name}`)}
            aria-label={t(`canvas.gradient.preset.${name}`)}
            style={{ background: gradientCss(preset(name)) }}
            onClick={() => restart(preset(name))}
          />
        ))}
      </div>
      {grip ? (
        <fieldset>
          <legend>{t("canvas.gradient.number", { number: chosen + 1 })}</legend>
          <NumberLine label={t("canvas.gradient.at")} value={grip.at} take={(place) => put({ at: clamp(place, 0, 1) })} />
          <SwitchLine label={t("canvas.gradient.parted")} on={parted} take={part} />
          {parted ? (
            <div className="sides">
              {(["left", "right"] as const).map((one) => (
                <button key={one} type="button" aria-pressed={side === one} onClick={() => setSide(one)}>
                  <span style={{ background: css(grip[one]) }} /> {t(`canvas.gradient.${one}`)}
                </button>
              ))}
            </div>
          ) : null}
          <ColourPicker key={`${chosen} ${side}`} value={grip[side]} take={paint} />
        </fieldset>
      ) : null}
      <div className="row-of-buttons">
        <button
          type="button"
          onClick={() => {
            take(withGrip(form.grips, grip ? middleAfter(form.grips, chosen) : 0.5));
            setAt(form.grips.length);
          }}
        >
          {t("canvas.gradient.add")}
        </button>
        <button type="button" disabled={form.grips.length < 2} onClick={() => restart(withoutGrip(form.grips, chosen))}>
          {t("canvas.gradient.remove")}
        </button>
        <button type="button" onClick={() => restart(mirrored(form.grips))}>
          {t("canvas.gradient.mirror")}
        </button>
      </div>
      <SwitchLine label={t("canvas.gradient.linear")} on={form.linear} take={(linear) => setForm((old) => ({ ...old, linear }))} />
    </Form>
  );
}

/** Half-way from a grip to the next, or to the one before where it is the last. */
function middleAfter(grips: readonly GripView[], index: number): number {
  const here = grips[index]?.at ?? 0.5;
  const places = grips.map((grip) => grip.at).filter((at) => at !== here);
  const after = Math.min(...places.filter((at) => at > here));
  if (Number.isFinite(after)) return (here + after) / 2;
  const before = Math.max(...places.filter((at) => at < here));
  return Number.isFinite(before) ? (here + before) / 2 : here > 0.5 ? here / 2 : (here + 1) / 2;
}
