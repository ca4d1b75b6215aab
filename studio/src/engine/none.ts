/** A page that a server sends has no engine of its own. */

import type { Engine } from "./types";

export const engine: Engine | undefined = undefined as Engine | undefined;
