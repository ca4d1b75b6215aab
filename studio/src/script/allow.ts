import { ask } from "../state/session";

/** Says whether the scripts of the definition may run; gives whether the answer was taken. */
export async function allowScripts(run: boolean, keep: boolean): Promise<boolean> {
  try {
    await ask({ ask: "allowScripts", run, keep });
    return true;
  } catch {
    // What was refused stands in the line below.
    return false;
  }
}
