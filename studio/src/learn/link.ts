/** The values of controls in the address of the page: `#sum:a1=2.5&sum:b1=3`. */

function held(): URLSearchParams {
  const hash = location.hash.replace(/^#/, "");
  return new URLSearchParams(hash.includes("=") ? hash : "");
}

export function readLink(figure: string): Map<string, number | boolean> {
  const values = new Map<string, number | boolean>();
  for (const [key, text] of held()) {
    const [id, ...name] = key.split(":");
    if (id !== figure) continue;
    const value = text === "true" ? true : text === "false" ? false : Number(text);
    if (typeof value === "boolean" || Number.isFinite(value)) values.set(name.join(":"), value);
  }
  return values;
}

/** Browsers take some hundred addresses a minute: what is dragged is written when it rests for so many milliseconds. */
const REST = 200;
const waiting = new Map<string, string | undefined>();
let timer: ReturnType<typeof setTimeout> | undefined;

/** Writes what waits, at once. */
export function settleLink(): void {
  clearTimeout(timer);
  if (waiting.size === 0) return;
  const all = held();
  for (const [key, value] of waiting) {
    if (value === undefined) all.delete(key);
    else all.set(key, value);
  }
  waiting.clear();
  const text = all.toString();
  history.replaceState(history.state, "", text === "" ? location.pathname + location.search : `#${text}`);
}

function plan(key: string, value: string | undefined): void {
  waiting.set(key, value);
  clearTimeout(timer);
  timer = setTimeout(settleLink, REST);
}

export function writeLink(figure: string, name: string, value: number | boolean): void {
  plan(`${figure}:${name}`, String(value));
}

/** Takes all values of a figure out of the address. */
export function clearLink(figure: string): void {
  for (const key of [...held().keys(), ...waiting.keys()]) if (key.startsWith(`${figure}:`)) plan(key, undefined);
}
