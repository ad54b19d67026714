import type { Panel } from "../app.ts";

/** The panels in their order. */
export const PANELS: Panel[] = [];
