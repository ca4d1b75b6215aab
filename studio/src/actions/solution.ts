import { documentStore } from "../state/document";
import { runStore } from "../state/run";
import { ask } from "../state/session";
import { register } from "./registry";

const quietly = (asked: Promise<unknown>) => asked.then(() => undefined, () => undefined);

register(
  {
    id: "solution.recompute",
    label: "action.recompute",
    group: "solution",
    keys: ["F5"],
    run: () => quietly(ask({ ask: "recompute" })),
  },
  {
    id: "solution.cancel",
    label: "action.cancel",
    group: "solution",
    keys: ["Escape"],
    isEnabled: () => runStore.getState().progress !== undefined,
    run: () => quietly(ask({ ask: "cancel" })),
  },
  {
    id: "solution.lock",
    label: "action.lock",
    group: "solution",
    isOn: () => documentStore.getState().document?.locked ?? false,
    run: () => quietly(ask({ ask: "lock", on: !(documentStore.getState().document?.locked ?? false) })),
  },
);
