import { capsuleLayout } from "../../core/capsule";
import { css } from "../../core/colours";
import { lookOf } from "../../core/look";
import { useFullNames, useResult, useSelected, useStarved } from "../hooks";
import type { Shown } from "./ofObject";

/** An object as it is drawn while the canvas moves under it: its ground in the colour of its state, and its name. */
export function Plainly({ object, size: [width, height] }: Pick<Shown, "object" | "size">) {
  const look = lookOf(object, useResult(object.id), useStarved(object));
  const selected = useSelected(object.id);
  const full = useFullNames();
  const name = (full ? object.name : object.nickname.trim()) || object.name;
  const isCapsule = object.kind === "component" || object.kind === "cluster";
  const layout = isCapsule ? capsuleLayout(object, width, full) : undefined;
  const own = object.control?.is === "panel" && !selected ? { background: css(object.control.colour) } : {};
  return (
    <div
      className={`object capsule filled look-${look} ${isCapsule ? "" : "parameter"} ${selected ? "selected" : ""}`}
      style={{ width, height, ...own }}
      data-object={object.id}
      aria-hidden="true"
    >
      {layout ? (
        <div
          className={layout.upright ? "band upright" : "band"}
          style={{ left: layout.band[0], width: layout.band[1] - layout.band[0], fontSize: layout.nameSize }}
        >
          <span>{name}</span>
        </div>
      ) : object.kind === "parameter" ? (
        <span className="title">{name}</span>
      ) : null}
    </div>
  );
}
