import { useStore } from "zustand";

import { numberText, timeText } from "../../core/numbers";
import { modifiers } from "../../core/ports";
import type { MessageView } from "../../core/protocol/MessageView";
import type { ObjectView } from "../../core/protocol/ObjectView";
import type { PortView } from "../../core/protocol/PortView";
import { t } from "../../i18n";
import { documentStore } from "../../state/document";
import { useCanvas, useEntry, useObject, useOutput, useResult } from "../hooks";
import { useRows } from "../rows";
import { paneSize } from "../view";

const WIDTH = 340;
const ROWS = 12;

/** The tip: what an object is and tells, or what a port is and holds. */
export function Tip() {
  const tip = useCanvas((canvas) => canvas.tip);
  const object = useObject(tip?.object);
  if (!tip || !object) return null;
  const [width, height] = paneSize();
  const left = Math.max(Math.min(tip.pixel[0] + 14, width - WIDTH - 8), 8);
  const above = tip.pixel[1] > height * 0.6;
  const place = above ? { bottom: height - tip.pixel[1] + 12 } : { top: tip.pixel[1] + 18 };
  const ports = tip.port?.side === "input" ? object.inputs : object.outputs;
  const port = ports.find((one) => one.id === tip.port?.id);
  return (
    <div className="box tip" role="tooltip" style={{ left, width: WIDTH, ...place }}>
      {tip.port && port ? <PortTip object={object} port={port} side={tip.port.side} /> : <ObjectTip object={object} />}
    </div>
  );
}

function ObjectTip({ object }: { object: ObjectView }) {
  const entry = useEntry(object.component);
  const result = useResult(object.id);
  const own = object.nickname.trim();
  return (
    <>
      <h3>
        {object.name}
        {own !== "" && own !== object.name ? <small> {own}</small> : null}
      </h3>
      {entry?.help ? <p>{entry.help}</p> : null}
      {object.support.is === "no" ? (
        <p className="message warning">
          {object.support.reason}
          {object.support.plugin ? ` (${object.support.plugin})` : ""}
        </p>
      ) : null}
      <Messages messages={result?.messages ?? []} />
      {result ? <p className="faint">{timeText(result.milliseconds)}</p> : null}
    </>
  );
}

export function Messages({ messages }: { messages: readonly MessageView[] }) {
  return messages.slice(0, 8).map((message, k) => (
    <p key={k} className={`message ${message.level}`}>
      {message.text}
    </p>
  ));
}

function PortTip({ object, port, side }: { object: ObjectView; port: PortView; side: "input" | "output" }) {
  const entry = useEntry(object.component);
  const index = (side === "input" ? object.inputs : object.outputs).indexOf(port);
  const help = (side === "input" ? entry?.inputs : entry?.outputs)?.[index]?.help;
  const marks = modifiers(port).map((mark) => t(`canvas.modifier.${mark}`));
  return (
    <>
      <h3>
        {port.name} <small>{[port.kind, t(access(port.access))].join(", ")}</small>
      </h3>
      {help ? <p>{help}</p> : null}
      {marks.length > 0 ? <p className="faint">{marks.join(", ")}</p> : null}
      <PortData port={port} side={side} />
    </>
  );
}

function access(word: string) {
  return word === "list" ? "canvas.access.list" : word === "tree" ? "canvas.access.tree" : "canvas.access.item";
}

/** The first values of a port, with the paths of their branches. */
function PortData({ port, side }: { port: PortView; side: "input" | "output" }) {
  const output = useOutput(side === "output" ? port.id : (port.sources[0] ?? port.id));
  const sources = useStore(documentStore, (mirror) => mirror.outputs);
  const page = useRows(port.id, 0, ROWS, output);
  const lost = side === "input" && port.sources.length > 0 && !port.sources.some((id) => sources.has(id));
  if (lost) return <p className="faint">{t("canvas.data.lost")}</p>;
  if (!page) return null;
  if (page.total === 0) return <p className="faint">{t("canvas.data.empty")}</p>;
  const rest = page.total - page.rows.length;
  return (
    <div className="data">
      {output && side === "output" ? (
        <p className="faint">{t("canvas.data.count", { items: output.items, branches: output.branches })}</p>
      ) : null}
      <ul>
        {page.rows.map((row, k) =>
          row.is === "path" ? (
            <li key={k} className="path">
              {row.path} <small>N = {row.items}</small>
            </li>
          ) : (
            <li key={k}>
              <small>{row.index}</small> {row.text}
            </li>
          ),
        )}
      </ul>
      {rest > 0 ? <p className="faint">{t("canvas.data.more", { count: numberText(rest) })}</p> : null}
    </div>
  );
}
