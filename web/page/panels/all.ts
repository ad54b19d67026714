import type { Panel } from "../app.ts";
import { checkPanel } from "./check/panel.ts";

/** The panels in their order. */
export const PANELS: Panel[] = [checkPanel];
