import { useState } from "react";

import type { AccessView } from "../core/protocol/AccessView";
import type { ObjectView } from "../core/protocol/ObjectView";
import type { PortChange } from "../core/protocol/PortChange";
import type { PortView } from "../core/protocol/PortView";
import { t } from "../i18n";
import { edit } from "../state/session";

const ACCESS: readonly AccessView[] = ["item", "list", "tree"];

interface TableProps {
  object: ObjectView;
  side: "input" | "output";
  hints: readonly string[];
  gesture: number;
}

/** The ports of one side: names, and for inputs type hint and access. */
export function PortTable({ object, side, hints, gesture }: TableProps) {
  const isInput = side === "input";
  const ports = isInput ? object.inputs : object.outputs;
  const change = (port: string, how: PortChange) => void edit({ do: "changePort", port, change: how }, gesture);
  const add = () =>
    void edit(
      { do: "addPort", object: object.id, input: isInput, index: ports.length, id: crypto.randomUUID() },
      gesture,
    );
  return (
    <section aria-label={t(isInput ? "script.inputs" : "script.outputs")}>
      <h3>{t(isInput ? "script.inputs" : "script.outputs")}</h3>
      {ports.map((port) => (
        <div className="port-row" key={port.id} role="group" aria-label={port.nickname}>
          <NameField port={port} label={t(isInput ? "script.input" : "script.output")} onTake={(text) => change(port.id, { is: "nickname", text })} />
          {isInput && port.removable && (
            <>
              <select aria-label={t("script.hint")} value={port.hint ?? ""} onChange={(event) => change(port.id, { is: "hint", hint: event.target.value })}>
                {!hints.includes(port.hint ?? "") && <option value={port.hint ?? ""}>{port.hint ?? "–"}</option>}
                {hints.map((hint) => (
                  <option key={hint}>{hint}</option>
                ))}
              </select>
              <select aria-label={t("script.access")} value={port.access} onChange={(event) => change(port.id, { is: "access", access: accessOf(event.target.value) })}>
                {ACCESS.map((access) => (
                  <option key={access} value={access}>
                    {t(`script.access.${access}`)}
                  </option>
                ))}
              </select>
            </>
          )}
          {port.removable && (
            <button
              type="button"
              className="remove"
              aria-label={t("script.remove", { name: port.nickname })}
              title={t("script.remove", { name: port.nickname })}
              onClick={() => void edit({ do: "removePort", port: port.id }, gesture)}
            >
              ×
            </button>
          )}
        </div>
      ))}
      <button type="button" onClick={add}>
        {t(isInput ? "script.addInput" : "script.addOutput")}
      </button>
    </section>
  );
}

function accessOf(text: string): AccessView {
  return ACCESS.find((access) => access === text) ?? "item";
}

/** The name that the script knows a port by; it is taken when the field is left, or with Enter. */
function NameField({ port, label, onTake }: { port: PortView; label: string; onTake(text: string): void }) {
  const [text, setText] = useState<string>();
  const take = () => {
    const name = text?.trim();
    if (name && name !== port.nickname) onTake(name);
    setText(undefined);
  };
  return (
    <input
      type="text"
      aria-label={label}
      spellCheck={false}
      autoCapitalize="off"
      value={text ?? port.nickname}
      disabled={!port.removable}
      onChange={(event) => setText(event.target.value)}
      onBlur={take}
      onKeyDown={(event) => {
        if (event.key === "Enter") take();
      }}
    />
  );
}
