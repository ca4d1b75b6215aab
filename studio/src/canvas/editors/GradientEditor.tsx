import { useState } from "react";

import { fromHex, gradientCss, hex } from "../../core/colours";
import { clamp } from "../../core/geometry";
import type { Control } from "../../core/protocol/Control";
import type { GripView } from "../../core/protocol/GripView";
import type { ObjectView } from "../../core/protocol/ObjectView";
import { t } from "../../i18n";
import { reshape } from "../edits";
import { Form, NumberLine, SwitchLine } from "./fields";

type Gradient = Extract<Control, { is: "gradient" }>;

/** A gradient's grips: where each stands, and the colours to its left and right. */
export function GradientEditor({ object, gradient, index }: { object: ObjectView; gradient: Gradient; index: number }) {
  const [form, setForm] = useState(gradient);
  const put = (at: number, part: Partial<GripView>) =>
    setForm((old) => ({ ...old, grips: old.grips.map((grip, k) => (k === at ? { ...grip, ...part } : grip)) }));
  const add = () => {
    const colour: GripView["left"] = [128, 128, 128, 255];
    setForm((old) => ({ ...old, grips: [...old.grips, { at: 0.5, left: colour, right: colour }] }));
  };
  const remove = (at: number) => setForm((old) => ({ ...old, grips: old.grips.filter((_, k) => k !== at) }));
  return (
    <Form title={t("canvas.gradient.title")} onTake={() => reshape(object.id, form)}>
      <div className="gradient-shown" style={{ background: gradientCss(form.grips) }} />
      <SwitchLine label={t("canvas.gradient.linear")} on={form.linear} take={(linear) => setForm((old) => ({ ...old, linear }))} />
      <div className="grips-list">
        {form.grips.map((grip, k) => (
          <fieldset key={k} className={k === index ? "hot" : ""}>
            <legend>{t("canvas.gradient.number", { number: k + 1 })}</legend>
            <NumberLine label={t("canvas.gradient.at")} value={grip.at} take={(at) => put(k, { at: clamp(at, 0, 1) })} />
            <label>
              {t("canvas.gradient.left")}
              <input type="color" value={hex(grip.left)} onChange={(event) => put(k, { left: fromHex(event.target.value, grip.left[3]) })} />
            </label>
            <label>
              {t("canvas.gradient.right")}
              <input type="color" value={hex(grip.right)} onChange={(event) => put(k, { right: fromHex(event.target.value, grip.right[3]) })} />
            </label>
            <button type="button" disabled={form.grips.length < 2} onClick={() => remove(k)}>
              {t("canvas.gradient.remove")}
            </button>
          </fieldset>
        ))}
      </div>
      <button type="button" className="aside" onClick={add}>
        {t("canvas.gradient.add")}
      </button>
    </Form>
  );
}
