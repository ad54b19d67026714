import { svgElement } from "./element.ts";

/** Pictograms, drawn with lines in a square of 24. */
const ICONS: Record<string, string> = {
  undo: "M9 6 4 11l5 5M4 11h10.500a4.500 4.500 0 0 1 0 9H11",
  redo: "m15 6 5 5-5 5m5-5H9.500a4.500 4.500 0 0 0 0 9H13",
  play: "M8 5v14l11-7z",
  pause: "M8 5v14M16 5v14",
  first: "m18 6-6 6 6 6M7 6v12",
  back: "m15 6-6 6 6 6",
  forward: "m9 6 6 6-6 6",
  last: "m6 6 6 6-6 6M17 6v12",
  move: "M12 3v18M3 12h18M12 3 9.500 5.500M12 3l2.500 2.500M12 21l-2.500-2.500M12 21l2.500-2.500M3 12l2.500-2.500M3 12l2.500 2.500M21 12l-2.500-2.500M21 12l-2.500 2.500",
  shape: "M5 18 12 6l7 12zM5 18m-2 0a2 2 0 1 0 4 0 2 2 0 1 0-4 0M12 6m-2 0a2 2 0 1 0 4 0 2 2 0 1 0-4 0M19 18m-2 0a2 2 0 1 0 4 0 2 2 0 1 0-4 0",
  build: "M5 19 19 5M5 19m-2 0a2 2 0 1 0 4 0 2 2 0 1 0-4 0M19 5m-2 0a2 2 0 1 0 4 0 2 2 0 1 0-4 0M18 14v7M14.500 17.500h7",
  steps: "M4 19h5v-5h5V9h6V4",
  full: "M4 9V4h5M20 9V4h-5M4 15v5h5M20 15v5h-5",
  dark: "M20 14.500A8.500 8.500 0 1 1 9.500 4a7 7 0 0 0 10.500 10.500z",
  help: "M9.200 9a3 3 0 1 1 4.300 2.700c-1 .5-1.500 1.200-1.500 2.300M12 17.500v.1",
  more: "M5 12v.1M12 12v.1M19 12v.1",
  paper: "M6 3h8l4 4v14H6zM14 3v4h4M9 12h6M9 16h6",
  plus: "M12 5v14M5 12h14",
  minus: "M5 12h14",
  fit: "M4 8V5h4M20 8V5h-4M4 16v3h4M20 16v3h-4M9 10h6v4H9z",
  panels: "M4 5h16v14H4zM14.500 5v14",
  remove: "M6 6l12 12M18 6 6 18",
  pin: "M9 3h6l-.750 6.750L18 13.500H6l3.750-3.750zM12 13.500v7.500",
  file: "M6 3h8l4 4v14H6zM14 3v4h4",
  mechanism: "M6 18 10 8l8 4M6 18m-2 0a2 2 0 1 0 4 0 2 2 0 1 0-4 0M10 8m-2 0a2 2 0 1 0 4 0 2 2 0 1 0-4 0M18 12m-2 0a2 2 0 1 0 4 0 2 2 0 1 0-4 0",
  text: "M9 5c-3 0-1 6-4 7 3 1 1 7 4 7M15 5c3 0 1 6 4 7-3 1-1 7-4 7",
  figure: "M4 5h16v14H4zM4 15l5-5 4 4 3-3 4 4",
  values: "M4 6h16M4 12h16M4 18h16M10 6v12",
  curves: "M4 4v16h16M5 15c4 0 4-9 8-9s3 8 7 8",
  modes: "M12 4 5 18h14zM12 20l-6-12h12z",
  check: "m5 13 4 4L19 7",
  exercise: "M14 4l6 6L9 21H3v-6zM12 6l6 6",
  camera: "M4 8h3.500l1.500-2.500h6L16.500 8H20v11H4zM12 13m-3.200 0a3.200 3.200 0 1 0 6.400 0 3.200 3.200 0 1 0-6.400 0",
  picture: "M4 5h16v14H4zM4 16l5-5 4 4 2.500-2.500L20 16M15.500 9v.1",
  save: "M12 3v12m-5-5 5 5 5-5M4 20h16",
};

/** A pictogram; it says nothing to screen readers: what a button does is its own name. */
export function icon(name: string): SVGSVGElement {
  const path = svgElement("path", { d: ICONS[name] ?? "M12 12m-4 0a4 4 0 1 0 8 0 4 4 0 1 0-8 0" });
  return svgElement("svg", { class: "icon", viewBox: "0 0 24 24", "aria-hidden": "true" }, path);
}
