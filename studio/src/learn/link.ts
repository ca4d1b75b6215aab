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

export function writeLink(figure: string, name: string, value: number | boolean): void {
  const all = held();
  all.set(`${figure}:${name}`, String(value));
  history.replaceState(history.state, "", `#${all.toString()}`);
}
