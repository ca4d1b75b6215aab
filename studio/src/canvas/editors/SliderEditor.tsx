import { useState } from "react";

import type { ObjectView } from "../../core/protocol/ObjectView";
import type { RoundingView } from "../../core/protocol/RoundingView";
import { limitsAbout, MOST_DIGITS, places, snapped, type Slider } from "../../core/slider";
import { t } from "../../i18n";
import { change, reshape } from "../edits";
import { Form, NumberLine, TextLine } from "./fields";

const ROUNDINGS: readonly [RoundingView, string][] = [
  ["float", "R"],
  ["integer", "N"],
  ["even", "E"],
  ["odd", "O"],
];

/** Everything about a number slider: name, rounding, digits, limits, value, expression. */
export function SliderEditor({ object, slider }: { object: ObjectView; slider: Slider }) {
  const [name, setName] = useState(object.nickname);
  const [form, setForm] = useState(slider);
  const put = (part: Partial<Slider>) => setForm((old) => ({ ...old, ...part }));
  const valid = form.min < form.max && [form.min, form.max, form.value].every(Number.isFinite);
  const take = () => {
    if (name !== object.nickname) change([object.id], { is: "nickname", text: name });
    const next = { ...form, value: snapped(form, form.value) };
    if (JSON.stringify(next) !== JSON.stringify(slider)) reshape(object.id, next);
  };
  const about = () => {
    const [min, max] = limitsAbout(form.value, form.rounding !== "float");
    put({ min, max });
  };
  return (
    <Form title={t("canvas.slider.title")} valid={valid} onTake={take}>
      <TextLine label={t("canvas.menu.name")} value={name} take={setName} />
      <fieldset className="choices">
        <legend>{t("canvas.slider.rounding")}</legend>
        {ROUNDINGS.map(([rounding, letter]) => (
          <label key={rounding} title={t(`canvas.slider.${rounding}`)}>
            <input
              type="radio"
              name="rounding"
              aria-label={t(`canvas.slider.${rounding}`)}
              checked={form.rounding === rounding}
              onChange={() => put({ rounding })}
            />
            <span>{letter}</span>
          </label>
        ))}
      </fieldset>
      {form.rounding === "float" ? (
        <NumberLine
          label={t("canvas.slider.digits")}
          value={places(form)}
          whole
          take={(digits) => put({ digits: Math.min(Math.max(digits, 0), MOST_DIGITS) })}
        />
      ) : null}
      <NumberLine label={t("canvas.slider.min")} value={form.min} take={(min) => put({ min })} />
      <NumberLine label={t("canvas.slider.max")} value={form.max} take={(max) => put({ max })} />
      <NumberLine label={t("canvas.slider.value")} value={form.value} take={(value) => put({ value })} />
      <TextLine
        label={t("canvas.slider.expression")}
        value={form.expression ?? ""}
        take={(text) => put({ expression: text.trim() === "" ? null : text })}
      />
      <button type="button" className="aside" onClick={about}>
        {t("canvas.slider.about")}
      </button>
    </Form>
  );
}
