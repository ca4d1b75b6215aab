/** The page's clipboard, which a browser may keep from us: then what was copied here is at least pasted here. */

let own = "";

export async function writeClipboard(text: string): Promise<void> {
  own = text;
  try {
    await navigator.clipboard.writeText(text);
  } catch {
    writeByCommand(text);
  }
}

/** The old way, which pages that are not served from this machine or over TLS still have. */
function writeByCommand(text: string): void {
  const focused = document.activeElement;
  const field = document.createElement("textarea");
  field.value = text;
  field.style.position = "fixed";
  field.style.opacity = "0";
  document.body.append(field);
  field.select();
  document.execCommand("copy");
  field.remove();
  if (focused instanceof HTMLElement) focused.focus({ preventScroll: true });
}

/** What was copied: told by the browser with a paste, asked for where nothing was told. */
export async function readClipboard(told?: string): Promise<string> {
  if (told) return told;
  try {
    const text = await navigator.clipboard.readText();
    return text === "" ? own : text;
  } catch {
    return own;
  }
}
