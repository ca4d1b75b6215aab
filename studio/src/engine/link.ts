/** A definition in the fragment of an address: Katydid's text, deflated, in the letters that addresses have. */

const KEY = "d";
const NAME = "name";
/** Longer addresses are cut by programs that pass them on. */
const LONGEST = 30_000;
/** What a link holds is not larger than this when it is unpacked. */
const MOST_BYTES = 4 << 20;

async function through(bytes: Uint8Array<ArrayBuffer>, change: CompressionStream | DecompressionStream, most: number): Promise<Uint8Array<ArrayBuffer>> {
  const reader = new Blob([bytes]).stream().pipeThrough(change).getReader();
  const parts: Uint8Array[] = [];
  let length = 0;
  for (;;) {
    const { done, value } = (await reader.read()) as { done: boolean; value?: Uint8Array };
    if (done || !value) break;
    length += value.length;
    if (length > most) {
      await reader.cancel();
      throw new RangeError("the link holds too much");
    }
    parts.push(value);
  }
  const whole = new Uint8Array(length);
  let at = 0;
  for (const part of parts) {
    whole.set(part, at);
    at += part.length;
  }
  return whole;
}

function letters(bytes: Uint8Array): string {
  let text = "";
  for (const byte of bytes) text += String.fromCharCode(byte);
  return btoa(text).replaceAll("+", "-").replaceAll("/", "_").replace(/=+$/, "");
}

function unlettered(text: string): Uint8Array<ArrayBuffer> {
  const plain = atob(text.replaceAll("-", "+").replaceAll("_", "/"));
  return Uint8Array.from(plain, (letter) => letter.charCodeAt(0));
}

/** The address of this page with a definition in it. */
export async function addressOf(page: string, name: string, text: Uint8Array<ArrayBuffer>): Promise<string> {
  const packed = letters(await through(text, new CompressionStream("deflate-raw"), MOST_BYTES));
  if (packed.length > LONGEST) throw new RangeError("the definition is too large for a link: save it as a file");
  const url = new URL(page);
  url.searchParams.delete("document");
  url.hash = new URLSearchParams({ [NAME]: name.replace(/\.kd$/, ""), [KEY]: packed }).toString();
  return url.toString();
}

/** What the fragment of an address holds; nothing where it holds no definition. */
export async function textOf(hash: string): Promise<{ name: string; bytes: Uint8Array<ArrayBuffer> } | undefined> {
  const held = new URLSearchParams(hash.replace(/^#/, ""));
  const packed = held.get(KEY);
  if (packed === null) return undefined;
  const bytes = await through(unlettered(packed), new DecompressionStream("deflate-raw"), MOST_BYTES);
  return { name: `${held.get(NAME) ?? "definition"}.kd`, bytes };
}
