import { useEffect, useState, type KeyboardEvent, type PointerEvent } from "react";

import { addDays, addMonths, DAY_SECONDS, timeText, weekday, weeksOf, type Day } from "../../core/dates";
import type { Control } from "../../core/protocol/Control";
import type { ObjectView } from "../../core/protocol/ObjectView";
import { language, t } from "../../i18n";
import { follow } from "../drag";
import { liveSetting, set } from "../edits";
import { useLive } from "./live";

type Of<K extends Control["is"]> = Extract<Control, { is: K }>;

interface FaceProps {
  object: ObjectView;
  size: readonly [number, number];
}

/** The moment at noon of a day where there are no zones: what is written of it is that day everywhere. */
function noon([year, month, day]: Day): Date {
  const date = new Date(0);
  date.setUTCFullYear(year, month - 1, day);
  date.setUTCHours(12);
  return date;
}

const format = (options: Intl.DateTimeFormatOptions) => new Intl.DateTimeFormat(language, { ...options, timeZone: "UTC" });
const MONTH = format({ month: "long", year: "numeric" });
const WHOLE = format({ weekday: "long", day: "numeric", month: "long", year: "numeric" });
const WEEKDAY = format({ weekday: "narrow" });
/** The days of a week from a Monday on. */
const WEEK = Array.from({ length: 7 }, (_, k) => WEEKDAY.format(noon([2024, 1, 1 + k])));

const name = ({ nickname, name }: ObjectView) => nickname.trim() || name;

/** A Calendar: a month, whose days are pressed. The arrow keys go by days and weeks, Page up and down by months. */
export function CalendarFace({ object, calendar, size }: FaceProps & { calendar: Of<"calendar"> }) {
  const [date, setLive] = useLive<Day>(calendar.date);
  const [year, month] = calendar.shown;
  // Leafing through months picks nothing, so it is no edit.
  const [shown, leaf] = useState<readonly [number, number]>([year, month]);
  useEffect(() => leaf([year, month]), [year, month]);
  const pick = (next: Day) => {
    setLive(next);
    leaf([next[0], next[1]]);
    void set(object.id, { is: "date", date: [...next] });
  };
  const turn = (by: -1 | 1) => () => {
    const [y, m] = addMonths([...shown, 1], by);
    leaf([y, m]);
  };
  const key = (event: KeyboardEvent) => {
    const next = later(date, event.key);
    if (!next || event.altKey || event.ctrlKey || event.metaKey) return;
    event.preventDefault();
    event.stopPropagation();
    pick(next);
  };
  const arrow = (by: -1 | 1) => (
    <button
      type="button"
      className="leaf"
      tabIndex={-1}
      data-own
      aria-label={t(by < 0 ? "canvas.calendar.before" : "canvas.calendar.after")}
      onClick={turn(by)}
      onDoubleClick={(event) => event.stopPropagation()}
    >
      {by < 0 ? "◂" : "▸"}
    </button>
  );
  const isShown = shown[0] === date[0] && shown[1] === date[1];
  return (
    <div className="calendar" style={{ width: size[0] - 12, height: size[1] - 12 }}>
      <div className="calendar-head">
        {arrow(-1)}
        <b>{MONTH.format(noon([...shown, 1]))}</b>
        {arrow(1)}
      </div>
      <div
        className="calendar-days"
        role="spinbutton"
        tabIndex={-1}
        data-inner
        data-own
        aria-label={name(object)}
        aria-valuenow={date[0] * 10_000 + date[1] * 100 + date[2]}
        aria-valuetext={WHOLE.format(noon(date))}
        onKeyDown={key}
        onDoubleClick={(event) => event.stopPropagation()}
      >
        {WEEK.map((letter, k) => (
          <span key={`name${k}`} className="weekday">
            {letter}
          </span>
        ))}
        {weeksOf(...shown).flatMap((week, row) =>
          week.map((day, k) =>
            day === undefined ? (
              <span key={`${row} ${k}`} />
            ) : (
              <span
                key={`${row} ${k}`}
                className={isShown && day === date[2] ? "day chosen" : "day"}
                data-day={day}
                onPointerDown={(event) => {
                  if (event.button !== 0) return;
                  event.stopPropagation();
                  pick([...shown, day]);
                }}
              >
                {day}
              </span>
            ),
          ),
        )}
      </div>
    </div>
  );
}

/** The day that a key leads to. */
function later(date: Day, key: string): Day | undefined {
  switch (key) {
    case "ArrowLeft":
      return addDays(date, -1);
    case "ArrowRight":
      return addDays(date, 1);
    case "ArrowUp":
      return addDays(date, -7);
    case "ArrowDown":
      return addDays(date, 7);
    case "PageUp":
      return addMonths(date, -1);
    case "PageDown":
      return addMonths(date, 1);
    case "Home":
      return addDays(date, -weekday(date));
    case "End":
      return addDays(date, 6 - weekday(date));
    default:
      return undefined;
  }
}

/** Within this part of the dial the hand of the hours is dragged, beyond it that of the minutes. */
const HOURS_WITHIN = 0.55;
const MINUTE = 60;
const HOUR = 3600;

/** Seconds that go around with the day. */
const around = (seconds: number) => ((seconds % DAY_SECONDS) + DAY_SECONDS) % DAY_SECONDS;

/** A Clock: a dial whose hands are dragged. The arrow keys go by minutes, with Shift and by pages by hours. */
export function ClockFace({ object, clock, size }: FaceProps & { clock: Of<"clock"> }) {
  const [seconds, setLive] = useLive(clock.seconds);
  const side = Math.max(Math.min(size[0] - 12, size[1] - 30), 20);
  const press = (event: PointerEvent<HTMLDivElement>) => {
    const box = event.currentTarget.getBoundingClientRect();
    const [cx, cy] = [box.left + box.width / 2, box.top + box.height / 2];
    const turnOf = (x: number, y: number) => Math.atan2(x - cx, cy - y) / (2 * Math.PI);
    const share = Math.hypot(event.clientX - cx, event.clientY - cy) / (box.width / 2);
    // A turn of a hand, and how finely it is set.
    const [whole, step] = share < HOURS_WITHIN ? [12 * HOUR, 15 * MINUTE] : [HOUR, MINUTE];
    const setting = liveSetting(object.id);
    let turn = turnOf(event.clientX, event.clientY);
    let at = seconds;
    follow(event, {
      move(_, pointer) {
        const now = turnOf(pointer.clientX, pointer.clientY);
        // The short way round, so that a hand passes the top.
        const by = now - turn - Math.round(now - turn);
        turn = now;
        at += by * whole;
        const next = around(Math.round(at / step) * step);
        setLive(next);
        setting.send({ is: "time", seconds: next });
      },
      end: setting.end,
      abandon() {
        setLive(undefined);
        setting.abandon();
      },
    });
  };
  const key = (event: KeyboardEvent) => {
    const step = event.shiftKey ? HOUR : MINUTE;
    const by = { ArrowUp: step, ArrowRight: step, ArrowDown: -step, ArrowLeft: -step, PageUp: HOUR, PageDown: -HOUR }[event.key];
    if (by === undefined || event.altKey || event.ctrlKey || event.metaKey) return;
    event.preventDefault();
    event.stopPropagation();
    const next = around(seconds + by);
    setLive(next);
    void set(object.id, { is: "time", seconds: next });
  };
  const hand = (turn: number) => ({ transform: `rotate(${turn * 360}deg)` });
  return (
    <>
      <div
        className="clock"
        style={{ width: side, height: side }}
        role="slider"
        tabIndex={-1}
        data-inner
        data-own
        aria-label={name(object)}
        aria-valuenow={Math.floor(seconds / MINUTE)}
        aria-valuemin={0}
        aria-valuemax={DAY_SECONDS / MINUTE - 1}
        aria-valuetext={timeText(seconds)}
        onPointerDown={press}
        onKeyDown={key}
      >
        {Array.from({ length: 12 }, (_, k) => (
          <span key={k} className={k % 3 === 0 ? "tick quarter" : "tick"} style={hand(k / 12)} />
        ))}
        <span className="hour hand" style={hand(seconds / (12 * HOUR))} />
        <span className="minute hand" style={hand(seconds / HOUR)} />
      </div>
      <span className="clock-time">{timeText(seconds)}</span>
    </>
  );
}
