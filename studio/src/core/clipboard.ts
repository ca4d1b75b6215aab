/** The page's clipboard, which a browser may keep from us: then what was copied here is at least pasted here. */

let own = "";

export async function writeClipboard(text: string): Promise<void> {
  own = text;
  try {
    await navigator.clipboard.writeText(text);
  } catch {
    // No permission: `own` has it.
  }
}

export async function readClipboard(): Promise<string> {
  try {
    const text = await navigator.clipboard.readText();
    return text === "" ? own : text;
  } catch {
    return own;
  }
}
