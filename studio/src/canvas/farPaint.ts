/** Painting the far view. */

import type { FarBox, FarList, FarWire } from "../core/far";
import type { PlacedLabel } from "../core/farLabels";
import { meets, type Lens, type Rect } from "../core/geometry";
import { curveBounds, wireCurve } from "../core/wires";
import { sprite } from "../icons/sprite";
import { catalogueStore } from "../state/catalogue";
import type { FarColours } from "./farColours";

/** Icons smaller than this many pixels are left out; larger than this in canvas units they are not drawn. */
const LEAST_ICON = 8;
const LARGEST_ICON = 120;
/** How much of what was not found is seen while something is searched for. */
const FAINT = 0.22;
const FONT = '"Inter Variable", system-ui, sans-serif';

export function paintFar(
  context: CanvasRenderingContext2D,
  list: FarList,
  labels: readonly PlacedLabel[],
  lens: Lens,
  [width, height]: readonly [number, number],
  dense: number,
  colours: FarColours,
  found?: ReadonlySet<string>,
  icons = false,
): void {
  const shown = (box: FarBox) => (found && !found.has(box.id) ? FAINT : 1);
  context.setTransform(1, 0, 0, 1, 0, 0);
  context.clearRect(0, 0, width * dense, height * dense);
  context.setTransform(lens.zoom * dense, 0, 0, lens.zoom * dense, lens.x * dense, lens.y * dense);
  const field: Rect = [-lens.x / lens.zoom, -lens.y / lens.zoom, width / lens.zoom, height / lens.zoom];
  const pixel = 1 / lens.zoom;
  const paint = (boxes: readonly FarBox[], one: typeof paintGroup) => {
    for (const box of boxes) {
      if (!meets(box.rect, field)) continue;
      context.globalAlpha = shown(box);
      one(context, box, pixel, colours);
    }
  };
  paint(list.groups, paintGroup);
  paintWires(context, list.wires, field, pixel, colours, found ? FAINT : 1);
  const isIcon = (box: FarBox) => icons && box.icon?.forName === true;
  const words = labels.filter(({ box, on }) => typeof on !== "string" || !isIcon(box));
  const named = new Set(words.filter(({ on }) => typeof on === "string").map(({ box }) => box.id));
  paint(list.boxes, (context, box) => {
    paintBox(context, box, pixel, colours);
    // Where there is no room for the name.
    if (box.icon && !named.has(box.id)) paintIcon(context, box, pixel, dense, colours);
  });
  paintLabels(context, words, field, pixel, colours, shown);
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

/** Boxes that are higher and wider than so many pixels have an edge; above the second, round corners too. */
const EDGE_ABOVE = 6;
const ROUND_ABOVE = 9;
/** The corners of a capsule, in units of the canvas: as the near view has them. */
const CORNER = 4;
/** How much of the edge's colour lies on a box that is too small for an edge. */
const SMALL_SHADE = 0.35;

function paintBox(context: CanvasRenderingContext2D, box: FarBox, pixel: number, colours: FarColours): void {
  const [x, y, w, h] = box.rect;
  // Nothing but its words is seen of a scribble.
  if (box.kind === "text") return;
  if (box.kind === "lines") {
    context.strokeStyle = box.colour ?? colours.edge;
    context.lineWidth = Math.max(2, pixel);
    context.beginPath();
    for (const line of box.lines) line.forEach((point, k) => (k === 0 ? context.moveTo(...point) : context.lineTo(...point)));
    context.stroke();
    return;
  }
  context.fillStyle = box.selected ? colours.selected[box.look] : (box.colour ?? colours.look[box.look]);
  const least = Math.min(w, h) / pixel;
  if (least > ROUND_ABOVE) {
    context.beginPath();
    context.roundRect(x, y, w, h, Math.min(CORNER, h / 3, w / 3));
    context.fill();
    context.strokeStyle = colours.edge;
    context.lineWidth = pixel;
    context.stroke();
    return;
  }
  context.fillRect(x, y, w, h);
  if (least > EDGE_ABOVE) {
    context.strokeStyle = colours.edge;
    context.lineWidth = pixel;
    context.strokeRect(x, y, w, h);
  } else if (!box.colour && !box.selected) {
    // An edge would fill it: a darker ground keeps it apart from the canvas.
    const before = context.globalAlpha;
    context.globalAlpha = before * SMALL_SHADE;
    context.fillStyle = colours.edge;
    context.fillRect(x, y, w, h);
    context.globalAlpha = before;
  }
}

/** The picture of a component as large as its box allows, but for a margin: names of ports are not seen from afar. */
function paintIcon(context: CanvasRenderingContext2D, { icon, rect, look }: FarBox, pixel: number, dense: number, colours: FarColours): void {
  const [x, y, w, h] = rect;
  const size = Math.min(w - 4, h - 4, LARGEST_ICON);
  if (!icon || size < LEAST_ICON * pixel) return;
  const place = catalogueStore.getState().byId.get(icon.component);
  const inks = look === "error" ? colours.iconOnError : colours.icon;
  const image = sprite(icon.component, place?.name ?? icon.name, place, (size / pixel) * dense, inks);
  context.drawImage(image, x + (w - size) / 2, y + (h - size) / 2, size, size);
}

/** What is left free beside a number that stands over a box, in pixels. */
const GAP = 4;

function paintLabels(
  context: CanvasRenderingContext2D,
  labels: readonly PlacedLabel[],
  field: Rect,
  pixel: number,
  colours: FarColours,
  shown: (box: FarBox) => number,
): void {
  context.textBaseline = "middle";
  context.lineJoin = "round";
  let font = "";
  for (const { box, lines, size, at: [x, y], across, bold, on } of labels) {
    // Words reach beyond their boxes: those of boxes a little out of sight can still be seen.
    const reach = 120 * pixel;
    if (!meets(box.rect, [field[0] - reach, field[1] - reach, field[2] + 2 * reach, field[3] + 2 * reach])) continue;
    const wanted = `${bold ? "600 " : ""}${size}px ${FONT}`;
    if (wanted !== font) context.font = font = wanted;
    context.textAlign = across === "centre" ? "center" : across;
    context.globalAlpha = shown(box);
    if (typeof on !== "string") {
      context.fillStyle = colours.band;
      context.fillRect(...on);
    }
    const isFree = on === "ground" || on === "over";
    const ink = on === "box" ? inkOn(box, colours) : isFree ? colours.ink : colours.bandInk;
    if (on === "over") {
      // A gap in the box: an end of it right beside a number would be read as a minus.
      const gap = context.measureText(lines[0] ?? "").width + 2 * GAP * pixel;
      context.fillStyle = colours.ground;
      context.fillRect(x - gap / 2, y - size / 2, gap, size);
    }
    lines.forEach((line, k) => {
      const down = y + k * size * 1.25;
      if (isFree) {
        // A halo keeps words apart from the wires below them.
        context.strokeStyle = colours.ground;
        context.lineWidth = 3 * pixel;
        context.strokeText(line, x, down);
      }
      context.fillStyle = ink;
      context.fillText(line, x, down);
    });
  }
}

function inkOn(box: FarBox, colours: FarColours): string {
  if (box.colour) return colours.panelInk;
  return box.look === "error" && !box.selected ? colours.errorInk : box.look === "disabled" ? colours.disabledInk : colours.ink;
}
