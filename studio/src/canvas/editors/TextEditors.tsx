import { useState } from "react";

import type { Control } from "../../core/protocol/Control";
import type { ObjectView } from "../../core/protocol/ObjectView";
import { t } from "../../i18n";
import { reshape } from "../edits";
import { Form, Line, NumberLine, TextLine } from "./fields";

type Of<K extends Control["is"]> = Extract<Control, { is: K }>;

export function ButtonEditor({ object, button }: { object: ObjectView; button: Of<"button"> }) {
  const [form, setForm] = useState(button);
  return (
    <Form title={t("canvas.button.title")} onTake={() => reshape(object.id, form)}>
      <TextLine label={t("canvas.button.normal")} value={form.normal} take={(normal) => setForm({ ...form, normal })} />
      <TextLine label={t("canvas.button.pressed")} value={form.pressed} take={(pressed) => setForm({ ...form, pressed })} />
    </Form>
  );
}

export function CherryEditor({ object, cherry }: { object: ObjectView; cherry: Of<"cherry"> }) {
  const [form, setForm] = useState(cherry);
  return (
    <Form title={object.name} onTake={() => reshape(object.id, form)}>
      <TextLine label={t("canvas.cherry.path")} value={form.path} take={(path) => setForm({ ...form, path })} />
      <NumberLine label={t("canvas.cherry.index")} value={form.index} whole take={(index) => setForm({ ...form, index })} />
    </Form>
  );
}

/** The masks of a Path Mapper, a rule a line: `{A;B} -> {B;A}`. */
export function PathsEditor({ object, paths }: { object: ObjectView; paths: Of<"paths"> }) {
  const [text, setText] = useState(() => paths.rules.map((rule) => rule.join(" -> ")).join("\n"));
  const rules = text
    .split("\n")
    .filter((line) => line.trim() !== "")
    .map((line): [string, string] => {
      const [from, to] = line.split("->");
      return [(from ?? "").trim(), (to ?? "").trim()];
    });
  const valid = rules.every(([from, to]) => from !== "" && to !== "");
  return (
    <Form title={object.name} valid={valid} onTake={() => reshape(object.id, { is: "paths", rules })}>
      <Line label={t("canvas.paths.rules")}>
        {(id) => <textarea id={id} rows={6} spellCheck={false} value={text} onChange={(event) => setText(event.target.value)} />}
      </Line>
    </Form>
  );
}
