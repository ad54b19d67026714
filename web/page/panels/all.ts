import type { Panel } from "../app.ts";
import { checkPanel } from "./check/panel.ts";
import { curves } from "./curves/panel.ts";
import { modes } from "./modes/panel.ts";
import { save } from "./save/panel.ts";
import { values } from "./values/panel.ts";

/** The panels in their order. */
export const PANELS: Panel[] = [values, curves, modes, checkPanel, save];
