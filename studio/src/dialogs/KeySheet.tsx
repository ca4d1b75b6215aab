import { shownKeys } from "../actions/keys";
import { allActions, type Action } from "../actions/registry";
import { t, type Key } from "../i18n";
import { Dialog } from "./Dialog";

const GROUPS: Action["group"][] = ["file", "edit", "canvas", "object", "view", "solution", "help"];

/** What hands do on the canvas that is no key. */
const GESTURES = [
  "double",
  "wire",
  "several",
  "void",
  "relay",
  "window",
  "pan",
  "zoom",
  "radial",
  "copy",
  "room",
  "free",
  "point",
  "fine",
  "drop",
] as const;

/** All keys that do something, by group. */
export function KeySheet() {
  const actions = allActions().filter((action) => action.keys?.length);
  return (
    <Dialog title={t("keys.title")} wide>
      {GROUPS.map((group) => ({ group, list: actions.filter((action) => action.group === group) }))
        .filter(({ list }) => list.length > 0)
        .map(({ group, list }) => (
          <table key={group}>
            <caption>{t(`group.${group}` as Key)}</caption>
            <tbody>
              {list.map((action) => (
                <tr key={action.id}>
                  <th scope="row">{t(action.label)}</th>
                  <td>
                    {action.keys?.map((keys) => (
                      <kbd key={keys}>{shownKeys(keys)}</kbd>
                    ))}
                  </td>
                </tr>
              ))}
            </tbody>
          </table>
        ))}
      <table>
        <caption>{t("gesture.title")}</caption>
        <tbody>
          {GESTURES.map((gesture) => (
            <tr key={gesture}>
              <th scope="row">{t(`gesture.${gesture}`)}</th>
              <td>{t(`gesture.${gesture}.what`)}</td>
            </tr>
          ))}
        </tbody>
      </table>
    </Dialog>
  );
}
