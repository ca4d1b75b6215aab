import { useState } from "react";

import { clamp } from "../../core/geometry";
import type { Control } from "../../core/protocol/Control";
import type { ObjectView } from "../../core/protocol/ObjectView";
import { rounded } from "../../core/slider";
import { t } from "../../i18n";
import { reshape } from "../edits";
import { Form, NumberLine, SwitchLine, TextLine } from "./fields";

type Of<K extends Control["is"]> = Extract<Control, { is: K }>;

const MOST_GENES = 1000;

export function GenesEditor({ object, genes }: { object: ObjectView; genes: Of<"genes"> }) {
  const [form, setForm] = useState(genes);
  const put = (part: Partial<Of<"genes">>) => setForm((old) => ({ ...old, ...part }));
  const count = (wanted: number) => {
    const size = clamp(wanted, 0, MOST_GENES);
    put({ values: Array.from({ length: size }, (_, k) => form.values[k] ?? (form.min + form.max) / 2) });
  };
  const take = () => {
    const values = form.values.map((value) => rounded(clamp(value, form.min, form.max), form.decimals));
    reshape(object.id, { ...form, values });
  };
  return (
    <Form title={t("canvas.genes.title")} valid={form.min < form.max} onTake={take}>
      <NumberLine label={t("canvas.genes.count")} value={form.values.length} whole take={count} />
      <NumberLine
        label={t("canvas.slider.digits")}
        value={form.decimals}
        whole
        take={(decimals) => put({ decimals: clamp(decimals, 0, 12) })}
      />
      <NumberLine label={t("canvas.slider.min")} value={form.min} take={(min) => put({ min })} />
      <NumberLine label={t("canvas.slider.max")} value={form.max} take={(max) => put({ max })} />
    </Form>
  );
}

export function KnobEditor({ object, knob }: { object: ObjectView; knob: Of<"knob"> }) {
  const [form, setForm] = useState(knob);
  const put = (part: Partial<Of<"knob">>) => setForm((old) => ({ ...old, ...part }));
  return (
    <Form
      title={t("canvas.knob.title")}
      valid={form.range > 0 && (!form.limited || form.min < form.max)}
      onTake={() => reshape(object.id, form)}
    >
      <NumberLine label={t("canvas.slider.value")} value={form.value} take={(value) => put({ value })} />
      <NumberLine label={t("canvas.knob.range")} value={form.range} take={(range) => put({ range })} />
      <NumberLine
        label={t("canvas.slider.digits")}
        value={form.decimals}
        whole
        take={(decimals) => put({ decimals: clamp(decimals, 0, 12) })}
      />
      <SwitchLine label={t("canvas.knob.limited")} on={form.limited} take={(limited) => put({ limited })} />
      {form.limited ? (
        <>
          <NumberLine label={t("canvas.slider.min")} value={form.min} take={(min) => put({ min })} />
          <NumberLine label={t("canvas.slider.max")} value={form.max} take={(max) => put({ max })} />
        </>
      ) : null}
    </Form>
  );
}

export function DigitsEditor({ object, digits }: { object: ObjectView; digits: Of<"digits"> }) {
  const [form, setForm] = useState(digits);
  const put = (part: Partial<Of<"digits">>) => setForm((old) => ({ ...old, ...part }));
  return (
    <Form title={t("canvas.digits.title")} onTake={() => reshape(object.id, form)}>
      <NumberLine label={t("canvas.slider.value")} value={form.value} take={(value) => put({ value })} />
      <NumberLine label={t("canvas.slider.digits")} value={form.digits} whole take={(n) => put({ digits: clamp(n, 1, 15) })} />
      <NumberLine label={t("canvas.digits.before")} value={form.radix} whole take={(n) => put({ radix: clamp(n, 1, 15) })} />
      <TextLine label={t("canvas.digits.prefix")} value={form.prefix} take={(prefix) => put({ prefix })} />
      <TextLine label={t("canvas.digits.suffix")} value={form.suffix} take={(suffix) => put({ suffix })} />
    </Form>
  );
}

const AXES = ["x", "y", "z"] as const;

export function DomainsEditor({ object, control }: { object: ObjectView; control: Of<"mdSlider"> }) {
  const [form, setForm] = useState(control);
  const put = (axis: 0 | 1 | 2, end: 0 | 1, value: number) => {
    const domains = structuredClone(form.domains);
    domains[axis][end] = value;
    setForm({ ...form, domains });
  };
  return (
    <Form title={t("canvas.mdSlider.title")} onTake={() => reshape(object.id, form)}>
      {([0, 1, 2] as const).map((axis) => (
        <div key={axis}>
          <NumberLine
            label={t("canvas.domain.from", { axis: AXES[axis] })}
            value={form.domains[axis][0]}
            take={(value) => put(axis, 0, value)}
          />
          <NumberLine
            label={t("canvas.domain.to", { axis: AXES[axis] })}
            value={form.domains[axis][1]}
            take={(value) => put(axis, 1, value)}
          />
        </div>
      ))}
    </Form>
  );
}
