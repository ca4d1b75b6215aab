import { useState } from "react";

import type { Control } from "../../core/protocol/Control";
import type { ObjectView } from "../../core/protocol/ObjectView";
import { t } from "../../i18n";
import { edit, newGesture } from "../../state/session";
import { change } from "../edits";
import { ColourPicker } from "./ColourPicker";
import { Form, TextLine } from "./fields";

export function NicknameEditor({ object }: { object: ObjectView }) {
  const [name, setName] = useState(object.nickname);
  return (
    <Form title={object.name} onTake={() => change([object.id], { is: "nickname", text: name })}>
      <TextLine label={t("canvas.menu.name")} value={name} take={setName} />
    </Form>
  );
}

/** A group's label and colour, with how far it lets the canvas through. */
export function GroupEditor({ object, group }: { object: ObjectView; group: Extract<Control, { is: "group" }> }) {
  const [label, setLabel] = useState(group.label);
  const [colour, setColour] = useState(group.colour);
  const take = () => {
    const gesture = newGesture();
    const changed = (how: Parameters<typeof edit>[0]) => void edit(how, gesture);
    if (label !== group.label) changed({ do: "changeGroup", group: object.id, change: { is: "label", text: label } });
    if (colour !== group.colour) changed({ do: "changeGroup", group: object.id, change: { is: "colour", colour } });
  };
  return (
    <Form title={t("canvas.group")} onTake={take}>
      <TextLine label={t("canvas.menu.label")} value={label} take={setLabel} />
      <ColourPicker value={colour} take={setColour} />
    </Form>
  );
}

/** The colour of a panel's paper. */
export function PaperEditor({ object, panel }: { object: ObjectView; panel: Extract<Control, { is: "panel" }> }) {
  const [colour, setColour] = useState(panel.colour);
  const take = () => void edit({ do: "changePanel", object: object.id, change: { is: "colour", colour } });
  return (
    <Form title={t("canvas.menu.colour")} onTake={take}>
      <ColourPicker value={colour} take={setColour} />
    </Form>
  );
}

/** The file that a panel is written to when the definition is run; an empty name ends that. */
export function StreamEditor({ object, panel }: { object: ObjectView; panel: Extract<Control, { is: "panel" }> }) {
  const [file, setFile] = useState(panel.stream ?? "");
  const take = () => void edit({ do: "changePanel", object: object.id, change: { is: "stream", file: file.trim() || null } });
  return (
    <Form title={t("canvas.panel.stream")} onTake={take}>
      <TextLine label={t("canvas.panel.file")} value={file} take={setFile} />
      <p className="form-note">{t("canvas.panel.streamed")}</p>
    </Form>
  );
}
