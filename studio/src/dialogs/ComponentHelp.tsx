import { engine } from "#engine";
import { useEffect, useState } from "react";
import { useStore } from "zustand";

import { token } from "../app/files";
import { paragraphs, readHelp, type Help, type HelpPort } from "../core/help";
import { t } from "../i18n";
import { Dialog } from "./Dialog";
import { dialogStore } from "./store";

type Answer = { is: "asked" } | { is: "failed" } | { is: "here"; help: Help };

async function helpOn(component: string): Promise<Answer> {
  try {
    if (engine) {
      const help = readHelp(await engine.help(component));
      return help ? { is: "here", help } : { is: "failed" };
    }
    const query = new URLSearchParams({ component, ...(token() ? { token: token() } : {}) });
    const response = await fetch(`api/help?${query.toString()}`);
    const help = response.ok ? readHelp(await response.json()) : undefined;
    return help ? { is: "here", help } : { is: "failed" };
  } catch {
    return { is: "failed" };
  }
}

/** What a component does, and what each of its inputs and outputs is. */
export function ComponentHelp() {
  const component = useStore(dialogStore, (state) => state.component);
  const [answer, setAnswer] = useState<Answer>({ is: "asked" });
  useEffect(() => {
    let here = true;
    setAnswer({ is: "asked" });
    if (component !== undefined) void helpOn(component).then((found) => here && setAnswer(found));
    return () => {
      here = false;
    };
  }, [component]);
  const title = answer.is === "here" ? answer.help.name : t("help.component");
  return (
    <Dialog title={title} wide>
      {answer.is === "here" ? <Told help={answer.help} /> : null}
      {answer.is === "asked" ? <p role="status">{t("help.asked")}</p> : null}
      {answer.is === "failed" ? <p role="alert">{t("help.failed")}</p> : null}
    </Dialog>
  );
}

function Told({ help }: { help: Help }) {
  if (help.is === "unsupported") {
    return (
      <>
        <p>{t("help.unsupported")}</p>
        <p>{help.reason}</p>
      </>
    );
  }
  const [first, ...rest] = paragraphs(help.help);
  return (
    <div className="component-help">
      <p className="place">
        <span>{help.nick}</span>
        {help.tab ? <span>{[help.tab, help.panel].filter(Boolean).join(" › ")}</span> : null}
        {help.old ? <span>{t("help.old")}</span> : null}
      </p>
      {first ? <p className="lead">{first}</p> : null}
      {rest.map((line, k) => (
        <p key={k}>{line}</p>
      ))}
      <Ports title={t("help.inputs")} ports={help.inputs} inputs />
      <Ports title={t("help.outputs")} ports={help.outputs} inputs={false} />
    </div>
  );
}

function Ports({ title, ports, inputs }: { title: string; ports: readonly HelpPort[]; inputs: boolean }) {
  if (ports.length === 0) return null;
  return (
    <table>
      <caption>{title}</caption>
      <thead>
        <tr>
          <th scope="col">{t("help.name")}</th>
          <th scope="col">{t("help.type")}</th>
          <th scope="col">{t("help.what")}</th>
        </tr>
      </thead>
      <tbody>
        {ports.map((port, k) => (
          <tr key={k}>
            <th scope="row">
              {port.name} <small>{port.nick === port.name ? "" : port.nick}</small>
            </th>
            <td>
              {port.kind}
              <small>{notes(port, inputs).join(", ")}</small>
            </td>
            <td>{port.help}</td>
          </tr>
        ))}
      </tbody>
    </table>
  );
}

function notes(port: HelpPort, input: boolean): string[] {
  const access = port.access === "list" ? t("canvas.access.list") : port.access === "tree" ? t("canvas.access.tree") : "";
  return [access, input && port.optional ? t("help.optional") : "", port.many ? t("help.many") : ""].filter(Boolean);
}
