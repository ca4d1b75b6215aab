import { useState } from "react";

import { dayOf, dayText, secondsOf, timeText } from "../../core/dates";
import type { Control } from "../../core/protocol/Control";
import type { ObjectView } from "../../core/protocol/ObjectView";
import { t } from "../../i18n";
import { set } from "../edits";
import { Form, Line } from "./fields";

type Of<K extends Control["is"]> = Extract<Control, { is: K }>;

/** The day of a calendar, typed. */
export function CalendarEditor({ object, calendar }: { object: ObjectView; calendar: Of<"calendar"> }) {
  const [text, setText] = useState(dayText(calendar.date));
  const date = dayOf(text);
  return (
    <Form title={object.name} valid={date !== undefined} onTake={() => void (date && set(object.id, { is: "date", date }))}>
      <Line label={t("canvas.calendar.date")}>
        {(id) => <input id={id} type="date" required value={text} onChange={(event) => setText(event.target.value)} />}
      </Line>
    </Form>
  );
}

/** The time of a clock, typed. */
export function ClockEditor({ object, clock }: { object: ObjectView; clock: Of<"clock"> }) {
  const [text, setText] = useState(timeText(clock.seconds));
  const seconds = secondsOf(text);
  const take = () => void (seconds !== undefined && set(object.id, { is: "time", seconds }));
  return (
    <Form title={object.name} valid={seconds !== undefined} onTake={take}>
      <Line label={t("canvas.clock.time")}>
        {(id) => <input id={id} type="time" step={1} required value={text} onChange={(event) => setText(event.target.value)} />}
      </Line>
    </Form>
  );
}
