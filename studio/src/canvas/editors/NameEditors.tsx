import { useState } from "react";

import type { ObjectView } from "../../core/protocol/ObjectView";
import { t } from "../../i18n";
import { edit } from "../../state/session";
import { change } from "../edits";
import { Form, TextLine } from "./fields";

export function NicknameEditor({ object }: { object: ObjectView }) {
  const [name, setName] = useState(object.nickname);
  return (
    <Form title={object.name} onTake={() => change([object.id], { is: "nickname", text: name })}>
      <TextLine label={t("canvas.menu.name")} value={name} take={setName} />
    </Form>
  );
}

export function GroupEditor({ object }: { object: ObjectView }) {
  const [label, setLabel] = useState(object.control?.is === "group" ? object.control.label : "");
  const take = () => void edit({ do: "changeGroup", group: object.id, change: { is: "label", text: label } });
  return (
    <Form title={t("canvas.group")} onTake={take}>
      <TextLine label={t("canvas.menu.label")} value={label} take={setLabel} />
    </Form>
  );
}
