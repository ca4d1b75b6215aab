import { memo, type CSSProperties, type ReactNode } from "react";

import { balloon, lookOf, SIGNS, type Look } from "../../core/look";
import { timeText } from "../../core/numbers";
import type { ObjectView } from "../../core/protocol/ObjectView";
import type { PortView } from "../../core/protocol/PortView";
import type { ResultView } from "../../core/protocol/ResultView";
import { t } from "../../i18n";
import { useCanvas, useFocus, useFound, useFullNames, useHovered, useProfiler, useResult, useSelected, useStarved } from "../hooks";
import { portName } from "../../core/ports";

interface FrameProps {
  object: ObjectView;
  /** More classes of the outermost element. */
  kind: string;
  style?: CSSProperties;
  /** Whether the colour of the state fills it; panels and notes keep their own. */
  filled?: boolean;
  children: ReactNode;
}

/** What every object on the canvas has: its state by colour and sign, grips, balloon, time, name for who listens. */
export function Frame({ object, kind, style, filled = true, children }: FrameProps) {
  const result = useResult(object.id);
  const selected = useSelected(object.id);
  const active = useCanvas((canvas) => canvas.active === object.id);
  const hovered = useHovered(object.id);
  const found = useFound(object.id);
  const look = lookOf(object, result, useStarved(object));
  useFocus(object.id, active);
  const states = [selected ? "selected" : "", filled ? "filled" : "", hovered ? "hovered" : "", found ? "found" : ""];
  const classes = ["object", kind, `look-${look}`, ...states];
  return (
    <div
      className={classes.filter(Boolean).join(" ")}
      style={style}
      role="group"
      aria-roledescription={t("canvas.object")}
      aria-label={spoken(object, look, selected)}
      tabIndex={active ? 0 : -1}
      data-object={object.id}
      data-look={look}
    >
      {children}
      <Grips object={object} />
      <Sign look={look} result={result} />
      {object.strip ? <div className="strip">{object.strip}</div> : null}
      <Profile result={result} below={(object.strip ? 14 : 0) + (object.support.is === "no" ? 14 : 0)} />
    </div>
  );
}

/** What a screen reader says of an object. */
export function spoken(object: ObjectView, look: Look, selected: boolean): string {
  const own = object.nickname.trim();
  const name = own === "" || own === object.name ? object.name : `${own}, ${object.name}`;
  const state = look === "plain" ? "" : `, ${t(`canvas.look.${look}`)}`;
  return name + state + (selected ? `, ${t("canvas.selected")}` : "");
}

const Grips = memo(function Grips({ object }: { object: ObjectView }) {
  const full = useFullNames();
  const grip = (side: "input" | "output") => (port: PortView) => (
    <span
      key={side + port.id}
      className={`grip ${side}`}
      style={{ top: port.at }}
      title=""
      data-port={port.id}
      data-side={side}
      data-name={portName(port, full)}
    />
  );
  return (
    <>
      {object.inputs.map(grip("input"))}
      {object.outputs.map(grip("output"))}
    </>
  );
});

function Sign({ look, result }: { look: Look; result: ResultView | undefined }) {
  const level = balloon(result);
  const shown = look === "plain" || look === "hidden" ? "" : SIGNS[look];
  if (shown !== "") return <span className={`sign sign-${look}`}>{shown}</span>;
  return level === "remark" ? <span className="sign sign-remark">i</span> : null;
}

function Profile({ result, below }: { result: ResultView | undefined; below: number }) {
  const on = useProfiler();
  if (!on || !result || result.milliseconds <= 0) return null;
  return (
    <div className="profile" style={{ marginTop: below }}>
      {timeText(result.milliseconds)}
    </div>
  );
}
