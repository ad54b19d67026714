import type { Panel } from "../app.ts";
import { checkPanel } from "./check/panel.ts";
import { curves } from "./curves/panel.ts";
import { exercisePanel } from "./exercise/panel.ts";
import { figure } from "./figure/panel.ts";
import { mechanism } from "./mechanism/panel.ts";
import { modes } from "./modes/panel.ts";
import { save } from "./save/panel.ts";
import { text } from "./text/panel.ts";
import { values } from "./values/panel.ts";

/** The panels in their order. */
export const PANELS: Panel[] = [mechanism, text, figure, values, curves, modes, checkPanel, exercisePanel, save];
