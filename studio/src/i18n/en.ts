/** All that people read, in English: one table a part. Another language is another table with the same keys. */
import { app } from "./en/app";
import { canvas } from "./en/canvas";
import { canvasMore } from "./en/canvasMore";
import { effects } from "./en/effects";
import { pick } from "./en/pick";
import { script } from "./en/script";
import { study } from "./en/study";
import { viewport } from "./en/viewport";

export const en = { ...app, ...canvas, ...canvasMore, ...effects, ...pick, ...script, ...study, ...viewport } as const;

export type Key = keyof typeof en;
