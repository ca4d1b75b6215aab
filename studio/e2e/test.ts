/** The test that all others are made of: it watches what the page does behind its user's back. */
import { type APIRequestContext, expect, test as plain } from "@playwright/test";

interface Watch {
  /** Complaints of the browser that a test brings about on purpose. */
  excused: RegExp[];
  watched: undefined;
}

/**
 * A page that writes an error to the console (a script that failed or was forbidden, a file that is not there) or asks
 * anything of another address fails its test.
 */
export const test = plain.extend<Watch>({
  excused: [[], { option: true }],
  watched: [
    async ({ context, baseURL, excused, request }, use) => {
      await closeOthers(request);
      const faults: string[] = [];
      const fault = (text: string) => {
        if (!excused.some((excuse) => excuse.test(text))) faults.push(text);
      };
      const own = new URL(baseURL ?? "").host;
      context.on("console", (message) => {
        if (message.type() === "error") fault(`${message.text()} (${message.location().url})`);
      });
      context.on("weberror", (error) => fault(String(error.error())));
      context.on("request", (request) => {
        const { protocol, host } = new URL(request.url());
        if (!["data:", "blob:"].includes(protocol) && host !== own) fault(`asked ${request.url()}`);
      });
      context.on("dialog", (dialog) => {
        fault(`a dialog: ${dialog.message()}`);
        void dialog.dismiss();
      });
      await use(undefined);
      expect(faults.slice(0, 9), `${faults.length} faults`).toEqual([]);
    },
    { auto: true },
  ],
});

/** Closes what tests before this one left open with unsaved changes: the server holds 64 documents. */
async function closeOthers(request: APIRequestContext): Promise<void> {
  const { open } = (await (await request.get("/api/start")).json()) as { open: { id: string }[] };
  // One that a page has not yet let go stays.
  for (const { id } of open) await request.post("/api/close", { data: { document: id } });
}

export { expect };
