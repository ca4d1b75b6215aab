/** Files that are saved where the user says, by the browser's pickers where it has them. */

interface Handle {
  name: string;
  createWritable(): Promise<{ write(bytes: Uint8Array<ArrayBuffer>): Promise<void>; close(): Promise<void> }>;
  requestPermission?(wish: { mode: "readwrite" }): Promise<string>;
}

type Picker = (wish: { suggestedName: string }) => Promise<Handle>;

/** The files that documents of this page were saved in. They are forgotten with the page. */
const handles = new Map<string, Handle>();

async function write(handle: Handle, bytes: Uint8Array<ArrayBuffer>): Promise<void> {
  const file = await handle.createWritable();
  await file.write(bytes);
  await file.close();
}

/** Has the user name a file, and saves in it; gives its name. Without such a picker the browser keeps the file: nothing. */
export async function keep(document: string, name: string, bytes: Uint8Array<ArrayBuffer>): Promise<string | undefined> {
  const picker = (globalThis as { showSaveFilePicker?: Picker }).showSaveFilePicker;
  if (!picker) {
    handOver(name, bytes);
    return undefined;
  }
  let handle: Handle;
  try {
    handle = await picker({ suggestedName: name });
  } catch (error) {
    // Who thinks better of it saves nothing.
    if (error instanceof DOMException && error.name === "AbortError") return undefined;
    throw error;
  }
  await write(handle, bytes);
  handles.set(document, handle);
  return handle.name;
}

/** Saves in the file that was named before. */
export async function keepAgain(document: string, bytes: Uint8Array<ArrayBuffer>): Promise<void> {
  const handle = handles.get(document);
  if (!handle) throw new Error("name the file once more: the page was loaded anew");
  await handle.requestPermission?.({ mode: "readwrite" });
  await write(handle, bytes);
}

/** Has the browser keep a file. */
export function handOver(name: string, bytes: Uint8Array<ArrayBuffer>): void {
  const link = document.createElement("a");
  link.href = URL.createObjectURL(new Blob([bytes]));
  link.download = name;
  link.click();
  setTimeout(() => URL.revokeObjectURL(link.href), 10_000);
}
