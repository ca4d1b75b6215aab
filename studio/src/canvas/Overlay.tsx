import { ViewportPortal } from "@xyflow/react";

import type { Grip } from "../core/hit";
import { wirePath } from "../core/wires";
import { useCanvas } from "./hooks";

/** What is drawn over the canvas while a gesture goes on: the window, the elastic wire, guides, places of copies. */
export function Overlay() {
  return (
    <ViewportPortal>
      <svg className="overlay" aria-hidden="true">
        <Ghosts />
        <Guides />
        <Elastic />
        <Window />
      </svg>
    </ViewportPortal>
  );
}

function Window() {
  const window = useCanvas((canvas) => canvas.window);
  if (!window) return null;
  const [x, y, width, height] = window.rect;
  return <rect className={window.crossing ? "window across" : "window within"} {...{ x, y, width, height }} />;
}

function Elastic() {
  const wire = useCanvas((canvas) => canvas.wire);
  if (!wire) return null;
  const [x, y] = wire.to;
  const path = ({ side, at }: Grip) => (side === "output" ? wirePath(at, wire.to) : wirePath(wire.to, at));
  return (
    <g className={`elastic ${wire.how} ${wire.end ? "held" : ""}`}>
      {[wire.grip, ...wire.more].map((grip) => (
        <path key={grip.port} d={path(grip)} />
      ))}
      <circle cx={x} cy={y} r={wire.end ? 6 : 3} />
      {wire.how === "replace" ? null : (
        <text x={x + 10} y={y - 8}>
          {{ add: "+", remove: "−", move: "⇄" }[wire.how]}
        </text>
      )}
    </g>
  );
}

function Guides() {
  const guides = useCanvas((canvas) => canvas.guides);
  return guides.map(({ axis, at, from, to }, k) => (
    <path key={k} className="guide" d={axis === "x" ? `M${at},${from - 8}V${to + 8}` : `M${from - 8},${at}H${to + 8}`} />
  ));
}

function Ghosts() {
  const ghosts = useCanvas((canvas) => canvas.ghosts);
  return ghosts.map(([x, y, width, height], k) => <rect key={k} className="ghost" rx={4} {...{ x, y, width, height }} />);
}
