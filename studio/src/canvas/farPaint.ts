/** Painting the far view. */

import type { FarBox, FarList, FarWire } from "../core/far";
import { meets, type Lens, type Rect } from "../core/geometry";
import { curveBounds, wireCurve } from "../core/wires";
import type { FarColours } from "./farColours";

/** Texts smaller than this many pixels are left out. */
const READABLE = 4.5;
/** How much of what was not found is seen while something is searched for. */
const FAINT = 0.22;
const FONT = '"Inter Variable", system-ui, sans-serif';

export function paintFar(
  context: CanvasRenderingContext2D,
  list: FarList,
  lens: Lens,
  [width, height]: readonly [number, number],
  dense: number,
  colours: FarColours,
  found?: ReadonlySet<string>,
): void {
  const shown = (box: FarBox) => (found && !found.has(box.id) ? FAINT : 1);
  context.setTransform(1, 0, 0, 1, 0, 0);
  context.clearRect(0, 0, width * dense, height * dense);
  context.setTransform(lens.zoom * dense, 0, 0, lens.zoom * dense, lens.x * dense, lens.y * dense);
  const field: Rect = [-lens.x / lens.zoom, -lens.y / lens.zoom, width / lens.zoom, height / lens.zoom];
  const pixel = 1 / lens.zoom;
  const paint = (boxes: readonly FarBox[], one: typeof paintBox) => {
    for (const box of boxes) {
      if (!meets(box.rect, field)) continue;
      context.globalAlpha = shown(box);
      one(context, box, pixel, colours);
    }
  };
  paint(list.groups, paintGroup);
  paintWires(context, list.wires, field, pixel, colours, found ? FAINT : 1);
  paint(list.boxes, paintBox);
  context.globalAlpha = 1;
}

function paintGroup(context: CanvasRenderingContext2D, box: FarBox, pixel: number, colours: FarColours): void {
  const [x, y, w, h] = box.rect;
  context.fillStyle = box.colour ?? colours.edge;
  context.fillRect(x, y, w, h);
  if (box.selected) {
    context.strokeStyle = colours.wire.selected;
    context.lineWidth = 2 * pixel;
    context.strokeRect(x, y, w, h);
  }
  paintLabel(context, box, [x + 6, y + 4, w - 12, h], pixel, colours.ink);
}

/** Wires of one look are one path: a stroke for all of them costs little more than a stroke for one. */
function paintWires(
  context: CanvasRenderingContext2D,
  wires: readonly FarWire[],
  field: Rect,
  pixel: number,
  colours: FarColours,
  seen: number,
): void {
  const paths = new Map<string, { path: Path2D; wire: FarWire }>();
  for (const wire of wires) {
    const curve = wireCurve(wire.a, wire.b);
    if (!meets(curveBounds(curve), field)) continue;
    const key = `${wire.look.colour} ${wire.look.width} ${wire.look.opacity}`;
    const one = paths.get(key) ?? { path: new Path2D(), wire };
    paths.set(key, one);
    const [a, b, c, d] = curve;
    one.path.moveTo(a[0], a[1]);
    one.path.bezierCurveTo(b[0], b[1], c[0], c[1], d[0], d[1]);
  }
  for (const { path, wire } of paths.values()) {
    context.strokeStyle = colours.wire[wire.look.colour];
    context.globalAlpha = wire.look.opacity * seen;
    context.lineWidth = Math.max(wire.look.width * 0.7, pixel);
    context.stroke(path);
  }
}

function paintBox(context: CanvasRenderingContext2D, box: FarBox, pixel: number, colours: FarColours): void {
  const [x, y, w, h] = box.rect;
  if (box.kind === "text") {
    paintLabel(context, box, [x, y, w, h], pixel, colours.ink);
    return;
  }
  if (box.kind === "lines") {
    context.strokeStyle = box.colour ?? colours.edge;
    context.lineWidth = Math.max(2, pixel);
    context.beginPath();
    for (const line of box.lines) line.forEach((point, k) => (k === 0 ? context.moveTo(...point) : context.lineTo(...point)));
    context.stroke();
    return;
  }
  context.fillStyle = box.selected ? colours.selected[box.look] : (box.colour ?? colours.look[box.look]);
  context.fillRect(x, y, w, h);
  if (w > 6 * pixel && h > 6 * pixel) {
    context.strokeStyle = colours.edge;
    context.lineWidth = pixel;
    context.strokeRect(x, y, w, h);
  }
  paintLabel(context, box, [x + 4, y + 2, w - 8, h - 4], pixel, box.colour ? colours.panelInk : colours.ink);
}

function paintLabel(context: CanvasRenderingContext2D, box: FarBox, room: Rect, pixel: number, ink: string): void {
  const { label } = box;
  if (!label || label.size < READABLE * pixel) return;
  const [x, y, w, h] = room;
  context.save();
  context.beginPath();
  context.rect(x, y, Math.max(w, 0), Math.max(h, 0));
  if (box.kind !== "text") context.clip();
  context.fillStyle = ink;
  context.font = `${label.bold ? "bold " : ""}${label.size}px ${FONT}`;
  context.textBaseline = "middle";
  context.textAlign = label.across === "centre" ? "center" : label.across;
  const at = label.across === "left" ? x : label.across === "right" ? x + w : x + w / 2;
  const lines = label.text.split("\n");
  const step = label.size * 1.3;
  const top = lines.length === 1 && box.kind === "box" ? y + h / 2 : y + step / 2;
  lines.slice(0, Math.max(Math.ceil(h / step), 1)).forEach((line, k) => context.fillText(line, at, top + k * step));
  context.restore();
}
