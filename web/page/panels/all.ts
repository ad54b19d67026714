import type { Panel } from "../app.ts";
import { mechanism } from "./mechanism/panel.ts";

/** The panels in their order. */
export const PANELS: Panel[] = [mechanism];
