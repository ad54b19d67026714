/** Wires the page: store → engine → view → panels. */
import type { App, Solved } from "./app.ts";
import { startEngine } from "./engine/client.ts";
import type { Picture, Refused, View } from "./engine/types.ts";
import { PANELS } from "./panels/all.ts";
import { hashOf } from "./state/address.ts";
import { history } from "./state/history.ts";
import { signal } from "./state/signal.ts";
import { unpacked } from "./unpack.ts";
import { language } from "./words.ts";

async function start(): Promise<void> {
  const [script, wasm] = await Promise.all([unpacked("worker"), unpacked("engine")]);
  const engine = startEngine(new TextDecoder().decode(script), wasm);
  const kinds = await engine.kinds();
  const first = kinds.find((kind) => kind.name === "paper-figure-2") ?? kinds[0];
  const app: App = {
    history: history({ text: first?.text ?? "", form: "" }),
    engine,
    solved: signal<Solved>({ text: "", opened: null, good: "", refused: null }),
    view: signal<View>({ step: null, coarse: false, modes: false }),
    picture: signal<Picture | null>(null),
    student: signal(false),
    shown: signal(""),
    place: signal<{ from: number; to: number } | null>(null),
    open: (text) => app.history.change({ text }),
    link: async (shared) => location.href.replace(/#.*/s, "") + (await hashOf(shared)),
    print: () => undefined,
    shaping: signal(false),
    pins: signal({ points: [], lengths: [] }),
    tell: (message) => void (document.getElementById("said")!.textContent = message),
    show: () => undefined,
    pick: () => () => undefined,
    markers: signal([]),
  };
  (window as unknown as { kinegon: App }).kinegon = app;
  app.history.now.on(({ text }) => {
    void engine.open(text).then(
      (opened) => app.solved.set({ text, opened, good: text, refused: null }),
      (refused: Refused) => app.solved.set({ ...app.solved.value, text, refused }),
    );
  });
  const sheet = document.getElementById("sheet")!;
  app.solved.on(({ good, refused }) => {
    document.getElementById("message")!.textContent = refused?.message ?? "";
    if (good !== "") void engine.picture(good, app.view.value).then((picture) => (sheet.innerHTML = picture.svg));
  });
  const panels = document.getElementById("panels")!;
  for (const panel of PANELS) {
    const root = document.createElement("section");
    root.id = `panel-${panel.id}`;
    const title = document.createElement("h2");
    language.on((now) => (title.textContent = panel.title[now]));
    root.append(title);
    panels.append(root);
    panel.mount(root, app);
  }
  document.documentElement.dataset["ready"] = "yes";
}

void start();
