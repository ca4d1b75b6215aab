import { useEffect, useRef, useState, type KeyboardEvent, type PointerEvent } from "react";

import {
  afterKey,
  fineness,
  position,
  sliderText,
  snapped,
  typed,
  valueAt,
  widest,
  type Slider,
} from "../../core/slider";
import type { ObjectView } from "../../core/protocol/ObjectView";
import { DIGIT, textWidth } from "../../core/text";
import { t } from "../../i18n";
import { follow } from "../drag";
import { liveSetting, reshape, set } from "../edits";
import { lens } from "../view";
import { openEditor } from "../open";
import { NumberField } from "./NumberField";

const TEXT = 11;

/** The name, the track with its knob, and the number; as Grasshopper's number slider. */
export function SliderFace({ object, slider, width }: { object: ObjectView; slider: Slider; width: number }) {
  const [live, setLive] = useState<number | undefined>(undefined);
  const [typing, setTyping] = useState(false);
  const value = live ?? slider.value;
  const unanswered = useRef(0);
  // What was dragged or gone to holds until the session has answered, to the last of keys that follow each other fast.
  useEffect(() => {
    if (unanswered.current === 0) setLive(undefined);
  }, [slider]);
  const step = (next: number) => {
    setLive(next);
    unanswered.current += 1;
    void set(object.id, { is: "number", value: snapped(slider, next) }).finally(() => {
      unanswered.current -= 1;
      if (unanswered.current === 0) setLive(undefined);
    });
  };

  const name = object.nickname.trim() || object.name;
  const named = textWidth(name, TEXT) + 14;
  const room = width - named < 60 ? Math.max(width - 70, 0) : named;
  return (
    <>
      <span className="title" style={{ width: room }} data-editor="control" title={name}>
        {room > 12 ? name : ""}
      </span>
      <div className="field" style={{ left: room }} data-own>
        <Track
          object={object}
          slider={slider}
          value={value}
          onLive={setLive}
          onStep={step}
          trackWidth={width - room - 22 - widest(slider) * DIGIT * TEXT}
        />
        {typing ? (
          <NumberField
            start={sliderText(slider, value)}
            label={t("canvas.slider.value")}
            onDone={(text) => {
              setTyping(false);
              if (text !== undefined) takeTyped(object, slider, text);
            }}
          />
        ) : (
          <span
            className="number"
            style={{ minWidth: widest(slider) * DIGIT * TEXT }}
            onDoubleClick={(event) => {
              event.stopPropagation();
              setTyping(true);
            }}
          >
            {sliderText(slider, value)}
          </span>
        )}
      </div>
    </>
  );
}

/** A number that was typed: within the limits it is set, beyond them the limit moves out to it. */
function takeTyped(object: ObjectView, slider: Slider, text: string): void {
  const next = typed(slider, text);
  if (!next) return;
  if (next.min === slider.min && next.max === slider.max) set(object.id, { is: "number", value: next.value });
  else reshape(object.id, next);
}

interface TrackProps {
  object: ObjectView;
  slider: Slider;
  value: number;
  trackWidth: number;
  onLive(value: number | undefined): void;
  /** A key went to a value. */
  onStep(value: number): void;
}

function Track({ object, slider, value, trackWidth, onLive, onStep }: TrackProps) {
  const shown = useRef(value);
  shown.current = value;
  const at = position(slider, value);
  const track = Math.max(trackWidth, 10);

  const press = (event: PointerEvent<HTMLDivElement>) => {
    const setting = liveSetting(object.id);
    // The drag goes on from where the last move left it, so that keys for fine steps can be held and let go.
    let [before, place] = [0, position(slider, shown.current)];
    follow(event, {
      move([dx], pointer) {
        place += ((dx - before) * fineness(pointer)) / (track * lens().zoom);
        before = dx;
        const next = valueAt(slider, place);
        if (next === shown.current) return;
        shown.current = next;
        onLive(next);
        setting.send({ is: "number", value: next });
      },
      end: () => setting.end(),
      abandon() {
        onLive(undefined);
        setting.abandon();
      },
    });
  };

  const key = (event: KeyboardEvent) => {
    if (event.key === "Enter") openEditor(object.id, "control");
    if (event.altKey || event.ctrlKey || event.metaKey) return;
    const next = afterKey(slider, shown.current, event.key, event.shiftKey);
    if (next === undefined) return;
    event.preventDefault();
    event.stopPropagation();
    shown.current = next;
    onStep(next);
  };

  return (
    <div
      className="track"
      style={{ width: track }}
      role="slider"
      tabIndex={-1}
      data-inner
      aria-label={object.nickname.trim() || object.name}
      aria-valuemin={slider.min}
      aria-valuemax={slider.max}
      aria-valuenow={value}
      aria-valuetext={sliderText(slider, value)}
      onPointerDown={press}
      onKeyDown={key}
    >
      <span className="rail" />
      <span className="done" style={{ width: at * track }} />
      <span className="knob" style={{ left: at * track }} />
    </div>
  );
}
