import type { Request } from "../../src/core/protocol/Request";
import type { PageSession } from "./session";

/** A WebSocket whose other end is a session in this page. */
export function socketTo(session: PageSession): typeof WebSocket {
  class PageSocket extends EventTarget {
    static readonly OPEN = 1;
    readonly OPEN = 1;
    readyState = 0;
    binaryType = "arraybuffer";
    onopen: (() => void) | null = null;
    onmessage: ((event: { data: string }) => void) | null = null;
    onclose: (() => void) | null = null;

    constructor() {
      super();
      setTimeout(() => {
        this.readyState = 1;
        this.onopen?.();
        session.join((event) => this.onmessage?.({ data: JSON.stringify(event) }));
      });
    }

    send(text: string): void {
      const request = JSON.parse(text) as Request;
      setTimeout(() => session.take(request));
    }

    close(): void {
      this.onclose?.();
    }
  }
  return PageSocket as unknown as typeof WebSocket;
}
