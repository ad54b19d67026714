import type { Panel } from "../app.ts";
import { checkPanel } from "./check/panel.ts";
import { figure } from "./figure/panel.ts";
import { mechanism } from "./mechanism/panel.ts";
import { text } from "./text/panel.ts";

/** The panels in their order. */
export const PANELS: Panel[] = [mechanism, text, figure, checkPanel];
