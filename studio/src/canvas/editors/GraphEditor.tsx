import { useState } from "react";

import { draggable, graphChoices, withHandle } from "../../core/graph";
import type { Control } from "../../core/protocol/Control";
import type { ObjectView } from "../../core/protocol/ObjectView";
import { t } from "../../i18n";
import { reshape } from "../edits";
import { Form, Line, NumberLine } from "./fields";

type Graph = Extract<Control, { is: "graph" }>;

/** A Graph Mapper's function, the places of its handles as numbers, and the ranges that it maps between. */
export function GraphEditor({ object, graph }: { object: ObjectView; graph: Graph }) {
  const [form, setForm] = useState(graph);
  const put = (which: "x" | "y", end: 0 | 1, value: number) => {
    const domain: [number, number] = [form[which][0], form[which][1]];
    domain[end] = value;
    setForm({ ...form, [which]: domain });
  };
  const choose = (name: string) =>
    setForm({ ...form, graph: name === graph.graph.name ? graph.graph : { name, handles: [] } });
  const move = (index: number, axis: 0 | 1, value: number) => {
    const [x, y] = form.graph.handles[index] ?? [0, 0];
    setForm({ ...form, graph: withHandle(form.graph, index, axis === 0 ? [value, y] : [x, value]) });
  };
  return (
    <Form title={t("canvas.graph.title")} onTake={() => reshape(object.id, form)}>
      <Line label={t("canvas.menu.graph")}>
        {(id) => (
          <select id={id} value={form.graph.name} onChange={(event) => choose(event.target.value)}>
            {form.graph.name === "" ? <option value="">{t("canvas.graph.none")}</option> : null}
            {graphChoices(graph.graph.name).map((name) => (
              <option key={name} value={name}>
                {name}
              </option>
            ))}
          </select>
        )}
      </Line>
      {draggable(form.graph).map((index) => (
        <div className="pair" key={index}>
          {([0, 1] as const).map((axis) => (
            <NumberLine
              key={axis}
              label={t("canvas.graph.handleAxis", { index: index + 1, axis: axis === 0 ? "x" : "y" })}
              value={form.graph.handles[index]?.[axis] ?? 0}
              take={(value) => move(index, axis, value)}
            />
          ))}
        </div>
      ))}
      {(["x", "y"] as const).map((which) => (
        <div key={which}>
          <NumberLine label={t("canvas.domain.from", { axis: which })} value={form[which][0]} take={(value) => put(which, 0, value)} />
          <NumberLine label={t("canvas.domain.to", { axis: which })} value={form[which][1]} take={(value) => put(which, 1, value)} />
        </div>
      ))}
    </Form>
  );
}
