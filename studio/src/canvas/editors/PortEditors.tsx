import { useEffect, useState } from "react";

import type { ObjectView } from "../../core/protocol/ObjectView";
import type { PortView } from "../../core/protocol/PortView";
import { t } from "../../i18n";
import { edit } from "../../state/session";
import { changePort, reshape } from "../edits";
import { rowsOf } from "../rows";
import { Form, Line, TextLine } from "./fields";

function portOf(object: ObjectView, id: string): PortView | undefined {
  return [...object.inputs, ...object.outputs].find((port) => port.id === id);
}

/** The expression in `x` that each item of a port goes through. */
export function ExpressionEditor({ object, port: id }: { object: ObjectView; port: string }) {
  const port = portOf(object, id);
  const [text, setText] = useState(port?.expression ?? "");
  const take = () => changePort(id, { is: "expression", text: text.trim() === "" ? null : text });
  return (
    <Form title={`${port?.name ?? ""}: ${t("canvas.modifier.expression")}`} onTake={take}>
      <TextLine label="f(x) =" value={text} take={setText} />
    </Form>
  );
}

const MOST_LINES = 5000;

/** The values that an input keeps, one a line, with `{0;1}` before each branch. */
export function ValuesEditor({ object, port: id }: { object: ObjectView; port: string }) {
  const port = portOf(object, id);
  const [text, setText] = useState("");
  const [touched, setTouched] = useState(false);
  useEffect(() => {
    if (!port || port.kept === 0) return;
    void rowsOf(id, 0, MOST_LINES).then((page) => {
      if (!page) return;
      const lone = page.rows.filter((row) => row.is === "path").length < 2;
      const lines = page.rows.flatMap((row) => (row.is === "item" ? [row.text] : lone ? [] : [row.path]));
      setText((old) => (old === "" ? lines.join("\n") : old));
    });
  }, [id, port]);
  const take = () => {
    if (touched) void edit({ do: "keep", port: id, values: text === "" ? null : text });
  };
  return (
    <Form title={`${port?.name ?? ""}: ${t("canvas.menu.values")}`} onTake={take}>
      <Line label={t("canvas.values.lines")}>
        {(field) => (
          <textarea
            id={field}
            rows={9}
            spellCheck={false}
            value={text}
            onChange={(event) => {
              setText(event.target.value);
              setTouched(true);
            }}
          />
        )}
      </Line>
    </Form>
  );
}

/** The formula of an Expression. */
export function FormulaEditor({ object }: { object: ObjectView }) {
  const { control } = object;
  const [text, setText] = useState(control?.is === "formula" ? control.text : "");
  if (control?.is === "formula") {
    return (
      <Form title={object.name} onTake={() => reshape(object.id, { is: "formula", text })}>
        <Line label={t("canvas.formula")}>
          {(id) => <textarea id={id} rows={4} spellCheck={false} value={text} onChange={(event) => setText(event.target.value)} />}
        </Line>
      </Form>
    );
  }
  return null;
}
