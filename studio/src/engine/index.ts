import { Client } from "./client";
import type { Engine } from "./types";

export const engine: Engine | undefined = new Client();

// Without it the page works too, as long as there is a network.
if (import.meta.env.PROD) void navigator.serviceWorker?.register("./sw.js").catch(() => undefined);
