import { speaker, type Words } from "../../words.ts";

type Key = "ghosts" | "single" | "drawn" | "count" | "mode" | "chosen" | "list";

const WORDS: Words<Key> = {
  en: {
    ghosts: "Show the others pale in the picture",
    single: "The mechanism can be assembled in one way only.",
    drawn: "This scene gives its points as they are drawn. They can be assembled in this one way.",
    count: "With these lengths and this position of the drive there are {count} ways to assemble it. The scene keeps the one that you choose.",
    mode: "Mode {number}",
    chosen: "Mode {number} is chosen.",
    list: "Assembly modes",
  },
  es: {
    ghosts: "Mostrar los demás, pálidos, en la figura",
    single: "El mecanismo solo puede montarse de una manera.",
    drawn: "Esta escena da sus puntos tal como están dibujados. Solo pueden montarse de esta manera.",
    count: "Con estas longitudes y esta posición motriz hay {count} maneras de montarlo. La escena guarda la que usted elija.",
    mode: "Modo {number}",
    chosen: "Se ha elegido el modo {number}.",
    list: "Modos de montaje",
  },
};

/** The panel's sentences. */
export const say = speaker(WORDS);
