import { memo, useEffect, useRef, useState, type CSSProperties, type PointerEvent } from "react";

import { css, inkOn } from "../../core/colours";
import type { Control } from "../../core/protocol/Control";
import type { ObjectView } from "../../core/protocol/ObjectView";
import type { Page } from "../../core/protocol/Page";
import type { Row } from "../../core/protocol/Row";
import { t } from "../../i18n";
import { follow } from "../drag";
import { liveBounds, set } from "../edits";
import { useCanvas, useResult } from "../hooks";
import { closeBoxes } from "../open";
import { rowsOf } from "../rows";
import { canvasStore } from "../store";
import { lens } from "../view";
import { Frame } from "./Frame";

type Panel = Extract<Control, { is: "panel" }>;

const ROW = 14;
/** Rows that are asked for at a time. */
const PAGE = 100;
const SIDES = ["left", "center", "right"] as const;

/** A panel: a note that can be written on, or the data that comes in with its paths and indices. */
export function PanelNode({ object, panel, size }: { object: ObjectView; panel: Panel; size: readonly [number, number] }) {
  const result = useResult(object.id);
  const writing = useCanvas((canvas) => canvas.writing === object.id);
  const wired = (object.inputs[0]?.sources.length ?? 0) > 0;
  const named = object.nickname.trim() !== "" && object.nickname !== object.name;
  const style: CSSProperties = {
    width: size[0],
    height: size[1],
    background: css(panel.colour),
    textAlign: SIDES[panel.alignment] ?? "left",
  };
  const page = result?.panel ?? undefined;
  const lone = wired && page?.rows[0]?.is === "path" && page.rows.filter((row) => row.is === "path").length === 1;
  return (
    <Frame object={object} kind={`panel ink-${inkOn(panel.colour)}`} style={style} filled={false}>
      {named || (lone && panel.paths) ? (
        <div className="panel-head">
          <b>{named ? object.nickname : ""}</b>
          <span>{lone && panel.paths ? pathOf(page?.rows[0]) : ""}</span>
        </div>
      ) : null}
      {writing ? (
        <Writing object={object} text={panel.text} />
      ) : wired ? (
        <Data object={object} panel={panel} first={page} skipPath={lone} />
      ) : (
        <div className={`panel-text nowheel ${panel.wrap ? "wrap" : ""}`} data-scrolls>
          {panel.text}
        </div>
      )}
      {panel.stream ? <Stream file={panel.stream} /> : null}
      <Corner object={object} />
    </Frame>
  );
}

/** Where what the panel shows is written to: the name of the file, without its folders. */
function Stream({ file }: { file: string }) {
  const name = file.split(/[\\/]/).at(-1) || file;
  return (
    <span className="panel-stream" title={t("canvas.panel.streams", { file })}>
      ⤓ {name}
    </span>
  );
}

function pathOf(row: Row | undefined): string {
  return row?.is === "path" ? row.path : "";
}

/** Text being written: Escape or a click elsewhere takes it, as in Grasshopper; Undo takes it back. */
function Writing({ object, text }: { object: ObjectView; text: string }) {
  const field = useRef<HTMLTextAreaElement>(null);
  const done = useRef(false);
  useEffect(() => {
    field.current?.focus();
    field.current?.select();
  }, []);
  const finish = (take: boolean) => {
    if (done.current) return;
    done.current = true;
    const next = field.current?.value ?? text;
    canvasStore.setState({ writing: undefined });
    if (take && next !== text) set(object.id, { is: "text", text: next });
  };
  return (
    <textarea
      ref={field}
      className="writing nowheel"
      data-own
      data-scrolls
      aria-label={t("canvas.panel.text")}
      defaultValue={text}
      onPointerDown={(event) => event.stopPropagation()}
      onBlur={() => finish(true)}
      onKeyDown={(event) => {
        event.stopPropagation();
        if (event.key !== "Escape" && !(event.key === "Enter" && (event.ctrlKey || event.metaKey))) return;
        finish(true);
        closeBoxes();
      }}
    />
  );
}

interface DataProps {
  object: ObjectView;
  panel: Panel;
  first: Page | undefined;
  skipPath: boolean;
}

/** The data that comes in: rows are asked for as they are scrolled to. */
const Data = memo(function Data({ object, panel, first, skipPath }: DataProps) {
  const total = first?.total ?? 0;
  const port = object.inputs[0]?.id ?? object.id;
  const [pages, setPages] = useState<ReadonlyMap<number, readonly Row[]>>(new Map());
  const [at, setAt] = useState(0);
  const box = useRef<HTMLDivElement>(null);
  // New results: what was read before is of another solve.
  useEffect(() => setPages(new Map()), [first]);

  const height = object.bounds[3];
  const shown = Math.ceil(height / ROW) + 4;
  const start = Math.max(Math.min(at, total - 1), 0);
  const rows: (readonly [number, Row])[] = [];
  const missing = new Set<number>();
  for (let k = start; k < Math.min(start + shown, total); k++) {
    const row = first?.rows[k - (first.from ?? 0)] ?? pages.get(Math.floor(k / PAGE))?.[k % PAGE];
    if (row) rows.push([k, row]);
    else missing.add(Math.floor(k / PAGE));
  }
  const wanted = [...missing].join();
  useEffect(() => {
    let here = true;
    for (const number of wanted === "" ? [] : wanted.split(",").map(Number)) {
      void rowsOf(port, number * PAGE, PAGE).then((page) => {
        if (here && page) setPages((old) => new Map(old).set(number, page.rows));
      });
    }
    return () => {
      here = false;
    };
  }, [wanted, port, first]);

  if (!first) return <div className="panel-text faint">{t("canvas.empty")}</div>;
  return (
    <div
      className="panel-data nowheel"
      data-scrolls
      ref={box}
      onScroll={(event) => setAt(Math.floor(event.currentTarget.scrollTop / ROW))}
    >
      <div style={{ height: total * ROW, position: "relative" }}>
        <div className={panel.wrap && total * ROW < height ? "wrap" : ""} style={{ paddingTop: start * ROW }}>
          {rows.map(([k, row]) => (row.is === "path" ? <PathRow key={k} row={row} hidden={skipPath || !panel.paths} /> : <ItemRow key={k} row={row} indexed={panel.indices} />))}
        </div>
      </div>
    </div>
  );
});

function PathRow({ row, hidden }: { row: Extract<Row, { is: "path" }>; hidden: boolean }) {
  return hidden ? null : <div className="path-row">{row.path}</div>;
}

function ItemRow({ row, indexed }: { row: Extract<Row, { is: "item" }>; indexed: boolean }) {
  return (
    <div className="item-row">
      {indexed ? <span className="index">{row.index}</span> : null}
      <span className="item">{row.text}</span>
    </div>
  );
}

const LEAST: readonly [number, number] = [50, 20];

/** The corner that gives a panel another size. */
function Corner({ object }: { object: ObjectView }) {
  const [x, y, w, h] = object.bounds;
  const press = (event: PointerEvent<HTMLSpanElement>) => {
    const bounds = liveBounds(object.id);
    follow(event, {
      move([dx, dy]) {
        const { zoom } = lens();
        bounds.send([x, y, Math.max(w + dx / zoom, LEAST[0]), Math.max(h + dy / zoom, LEAST[1])]);
      },
      end: bounds.end,
      abandon: bounds.abandon,
    });
  };
  return <span className="corner-grip" data-own title={t("canvas.resize")} onPointerDown={press} />;
}
