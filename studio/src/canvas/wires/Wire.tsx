import { memo } from "react";
import type { EdgeProps } from "@xyflow/react";
import { useStore } from "zustand";

import { DASHES, wirelessPath, wireLook, wirePath, type WireLook } from "../../core/wires";
import { uiStore } from "../../state/ui";
import type { WireEdge } from "../flow";
import { useCanvas, useStructure } from "../hooks";

/** A wire: its lines tell the structure of the data on it. */
export const Wire = memo(function Wire(props: EdgeProps<WireEdge>) {
  const { source, target, sourceX, sourceY, targetX, targetY, data } = props;
  const structure = useStructure(data?.from ?? "");
  const atSource = useStore(uiStore, (ui) => ui.selection.has(source));
  const atTarget = useStore(uiStore, (ui) => ui.selection.has(target));
  const hot = useCanvas((canvas) => canvas.hotWire?.from === data?.from && canvas.hotWire?.to === data?.to);
  const look = wireLook(structure, data?.view ?? "normal", atSource || atTarget || hot);
  const [a, b] = [[sourceX, sourceY] as const, [targetX, targetY] as const];
  if (look.wireless) return <path className="wire wireless" d={`${wirelessPath(a, 1)} ${wirelessPath(b, -1)}`} />;
  const fades = !hot && look.colour === "selected" && atSource !== atTarget;
  const plain = structure === "empty" || structure === undefined ? "empty" : "plain";
  const id = `fade-${props.id}`;
  return (
    <g className={`wire ${hot ? "hot" : ""}`} data-wire={props.id} data-structure={structure ?? "empty"}>
      {fades ? (
        <linearGradient id={id} gradientUnits="userSpaceOnUse" x1={a[0]} y1={a[1]} x2={b[0] + 0.01} y2={b[1]}>
          <stop offset="0.1" className={atSource ? "stop-selected" : `stop-${plain}`} />
          <stop offset="0.9" className={atSource ? `stop-${plain}` : "stop-selected"} />
        </linearGradient>
      ) : null}
      <Lines d={wirePath(a, b)} look={look} stroke={fades ? `url(#${CSS.escape(id)})` : undefined} />
    </g>
  );
});

function Lines({ d, look, stroke }: { d: string; look: WireLook; stroke: string | undefined }) {
  const dashes = look.dashed ? { strokeDasharray: DASHES } : {};
  const own = stroke === undefined ? {} : { style: { stroke } };
  return (
    <>
      <path className={`line ${look.colour}`} d={d} strokeWidth={look.width} opacity={look.opacity} {...dashes} {...own} />
      {look.gap > 0 ? <path className="gap" d={d} strokeWidth={look.gap} {...dashes} /> : null}
    </>
  );
}
