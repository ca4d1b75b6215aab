import type { Control } from "../../core/protocol/Control";
import type { ObjectView } from "../../core/protocol/ObjectView";
import { t } from "../../i18n";
import { set } from "../edits";
import { titleRoom, Title } from "./SmallFaces";

type List = Extract<Control, { is: "valueList" }>;

/** A Value List in its four modes: boxes to tick, a menu, steps, steps around. */
export function ValueListFace({ object, list, size }: { object: ObjectView; list: List; size: readonly [number, number] }) {
  const [width, height] = size;
  const room = list.mode === "check" && height > 24 ? 0 : titleRoom(object, width, 50);
  const choose = (chosen: number[]) => set(object.id, { is: "choose", chosen });
  return (
    <>
      <Title object={object} room={room} />
      <div className="field" style={{ left: room }} data-own>
        {list.mode === "check" ? <Checks list={list} onChoose={choose} /> : null}
        {list.mode === "dropDown" ? <Menu object={object} list={list} onChoose={choose} /> : null}
        {list.mode === "sequence" || list.mode === "cycle" ? <Steps list={list} onChoose={choose} /> : null}
      </div>
    </>
  );
}

interface ListProps {
  list: List;
  onChoose(chosen: number[]): void;
}

function Checks({ list, onChoose }: ListProps) {
  const toggle = (index: number) =>
    onChoose(list.items.flatMap((item, k) => (item.selected !== (k === index) ? [k] : [])));
  return (
    <div className="checks nowheel" data-scrolls>
      {list.items.map((item, index) => (
        <label key={index}>
          <input
            type="checkbox"
            tabIndex={-1}
            data-inner
            checked={item.selected}
            onChange={() => toggle(index)}
          />
          <span>{item.name}</span>
        </label>
      ))}
    </div>
  );
}

function chosenIndex(list: List): number {
  return list.items.findIndex((item) => item.selected);
}

function Menu({ object, list, onChoose }: ListProps & { object: ObjectView }) {
  return (
    <select
      className="menu-list"
      tabIndex={-1}
      data-inner
      aria-label={object.nickname.trim() || object.name}
      value={chosenIndex(list)}
      onChange={(event) => onChoose([Number(event.target.value)])}
      onKeyDown={(event) => event.stopPropagation()}
    >
      {chosenIndex(list) < 0 ? <option value={-1}>–</option> : null}
      {list.items.map((item, index) => (
        <option key={index} value={index}>
          {item.name}
        </option>
      ))}
    </select>
  );
}

/** Steps through the items; a cycle goes around at its ends. */
function Steps({ list, onChoose }: ListProps) {
  const count = list.items.length;
  const at = chosenIndex(list);
  const around = list.mode === "cycle";
  const go = (by: number) => {
    if (count === 0) return;
    const next = around ? (at + by + count) % count : Math.min(Math.max(at + by, 0), count - 1);
    if (next !== at) onChoose([next]);
  };
  const arrow = (by: -1 | 1) => (
    <button
      type="button"
      className="step"
      tabIndex={-1}
      data-inner
      disabled={!around && (by < 0 ? at <= 0 : at >= count - 1)}
      aria-label={t(by < 0 ? "canvas.list.previous" : "canvas.list.next")}
      onClick={() => go(by)}
    >
      {by < 0 ? "◂" : "▸"}
    </button>
  );
  return (
    <div className="steps">
      {arrow(-1)}
      <span>{list.items[at]?.name ?? "–"}</span>
      {arrow(1)}
    </div>
  );
}
