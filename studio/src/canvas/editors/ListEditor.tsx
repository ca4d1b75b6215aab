import { useState } from "react";

import type { Control } from "../../core/protocol/Control";
import type { ListItemView } from "../../core/protocol/ListItemView";
import type { ObjectView } from "../../core/protocol/ObjectView";
import { t } from "../../i18n";
import { reshape } from "../edits";
import { Form, Line } from "./fields";

type List = Extract<Control, { is: "valueList" }>;

/** The items as lines: `name = expression`. */
function textOf(list: List): string {
  return list.items.map(({ name, expression }) => `${name} = ${expression}`).join("\n");
}

/** The items of lines; what was chosen stays chosen, by name. */
export function itemsOf(text: string, before: readonly ListItemView[]): ListItemView[] {
  const chosen = new Set(before.filter((item) => item.selected).map((item) => item.name));
  return text
    .split("\n")
    .filter((line) => line.trim() !== "")
    .map((line) => {
      const at = line.indexOf("=");
      const name = (at < 0 ? line : line.slice(0, at)).trim();
      const expression = (at < 0 ? line : line.slice(at + 1)).trim();
      return { name, expression, selected: chosen.has(name) };
    });
}

/** A Value List's mode and items. */
export function ListEditor({ object, list }: { object: ObjectView; list: List }) {
  const [mode, setMode] = useState(list.mode);
  const [text, setText] = useState(() => textOf(list));
  const take = () => {
    const items = itemsOf(text, list.items);
    const first = items[0];
    // All modes but boxes have one item chosen.
    if (mode !== "check" && first && !items.some((item) => item.selected)) first.selected = true;
    reshape(object.id, { is: "valueList", mode, items });
  };
  return (
    <Form title={t("canvas.list.title")} onTake={take}>
      <Line label={t("canvas.menu.listMode")}>
        {(id) => (
          <select id={id} value={mode} onChange={(event) => setMode(event.target.value as List["mode"])}>
            {(["dropDown", "check", "sequence", "cycle"] as const).map((one) => (
              <option key={one} value={one}>
                {t(`canvas.list.${one}`)}
              </option>
            ))}
          </select>
        )}
      </Line>
      <Line label={t("canvas.list.items")}>
        {(id) => <textarea id={id} rows={9} spellCheck={false} value={text} onChange={(event) => setText(event.target.value)} />}
      </Line>
    </Form>
  );
}
