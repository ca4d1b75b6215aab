import { useEffect, useState, type PointerEvent } from "react";

import { arms, draggable, withHandle } from "../../core/graph";
import type { Control } from "../../core/protocol/Control";
import type { GraphView } from "../../core/protocol/GraphView";
import type { ObjectView } from "../../core/protocol/ObjectView";
import { t } from "../../i18n";
import { follow } from "../drag";
import { liveShape } from "../edits";
import { lens } from "../view";

type Graph = Extract<Control, { is: "graph" }>;
const EDGE = 6;

/** A Graph Mapper: the curve that the session draws, and the handles that change it. */
export function GraphFace({ object, graph, size }: { object: ObjectView; graph: Graph; size: readonly [number, number] }) {
  const [live, setLive] = useState<GraphView | undefined>(undefined);
  useEffect(() => setLive(undefined), [graph]);
  const shown = live ?? graph.graph;
  const [width, height] = [size[0] - 2 * EDGE, size[1] - 2 * EDGE];
  const place = ([x, y]: readonly [number, number]) => [x * width, (1 - y) * height] as const;
  const drawn = graph.drawn.map((point) => place(point).join(",")).join(" ");

  const press = (index: number) => (event: PointerEvent<SVGCircleElement>) => {
    const start = shown.handles[index];
    if (!start) return;
    const shape = liveShape(object.id);
    follow(event, {
      move([dx, dy]) {
        const { zoom } = lens();
        const to: [number, number] = [start[0] + dx / (width * zoom), start[1] - dy / (height * zoom)];
        const next = withHandle(shown, index, to);
        setLive(next);
        shape.send({ ...graph, graph: next });
      },
      end: shape.end,
      abandon() {
        setLive(undefined);
        shape.abandon();
      },
    });
  };

  return (
    <svg className="graph" style={{ left: EDGE, top: EDGE }} width={width} height={height} overflow="visible">
      <title>{shown.name || t("canvas.graph.none")}</title>
      <rect className="ground" width={width} height={height} />
      <path className="lines" d={`M0,${height / 2}H${width} M${width / 2},0V${height}`} />
      <polyline className="curve" points={drawn} />
      {arms(shown).map(([a, b], k) => (
        <line key={k} className="arm" {...ends(place(a), place(b))} />
      ))}
      {draggable(shown).map((index) => {
        const [cx, cy] = place(shown.handles[index] ?? [0, 0]);
        return (
          <circle key={index} className="handle" data-own cx={cx} cy={cy} r={4} onPointerDown={press(index)}>
            <title>{t("canvas.graph.handle", { index: index + 1 })}</title>
          </circle>
        );
      })}
      {shown.name === "" ? (
        <text x={width / 2} y={height / 2} textAnchor="middle">
          {t("canvas.graph.none")}
        </text>
      ) : null}
    </svg>
  );
}

function ends(a: readonly [number, number], b: readonly [number, number]) {
  return { x1: a[0], y1: a[1], x2: b[0], y2: b[1] };
}
