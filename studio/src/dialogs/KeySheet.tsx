import { shownKeys } from "../actions/keys";
import { allActions, type Action } from "../actions/registry";
import { t, type Key } from "../i18n";
import { Dialog } from "./Dialog";

const GROUPS: Action["group"][] = ["file", "edit", "canvas", "object", "view", "solution", "help"];

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
    </Dialog>
  );
}
