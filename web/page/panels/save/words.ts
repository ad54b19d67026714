import { speaker, type Words } from "../../words.ts";

type Key =
  | "old_text"
  | "pictures"
  | "figure"
  | "worksheet"
  | "this_step"
  | "png_width"
  | "as"
  | "steps"
  | "coarse"
  | "sheets"
  | "steps_text"
  | "packing"
  | "film"
  | "film_turn"
  | "film_about"
  | "filming"
  | "film_taken"
  | "film_hidden"
  | "film_stuck"
  | "cannot_film"
  | "numbers"
  | "motion"
  | "results"
  | "scene"
  | "scene_about"
  | "scene_file"
  | "page_file"
  | "page_about"
  | "copy_link"
  | "link_of"
  | "link_copied"
  | "link_not_copied"
  | "link_long"
  | "link_local"
  | "print"
  | "print_now"
  | "size"
  | "on"
  | "preview"
  | "to_scale"
  | "ruler"
  | "saved";

const WORDS: Words<Key> = {
  en: {
    old_text: "The scene’s text has a mistake. Pictures, numbers and prints are those of the last good text; scene file, page and link have the text as it is.",
    pictures: "Pictures",
    figure: "Figure",
    worksheet: "Work sheet",
    this_step: "Step {number}",
    png_width: "Width of PNG, in pixels",
    as: "{what} as {format}",
    steps: "Construction",
    coarse: "Steps that belong together on one sheet",
    sheets: "{count} sheets, {format} (ZIP)",
    steps_text: "Text of the steps",
    packing: "Sheet {number} of {count} …",
    film: "Film",
    film_turn: "One turn of the drive",
    film_about: "The browser records the picture while the drives run as the scene says: for six seconds, or for each turn until the mechanism is where it began. Keep the page in sight; pulling, Play or a change of the scene breaks it off. GIF, for slides and messages, is made by the program: kinegon draw scene.json -o film.gif",
    filming: "Recording …",
    film_taken: "The film was broken off: something was moved or changed.",
    film_hidden: "The film was broken off: the page was not in sight.",
    film_stuck: "There is no film: the drive cannot move from where it stands.",
    cannot_film: "This browser records no films. The program makes them: kinegon draw scene.json -o film.gif",
    numbers: "Numbers",
    motion: "Motion over the cycle (CSV)",
    results: "Results (JSON)",
    scene: "Scene",
    scene_about: "The file goes back into this page and into the program. The page as one file has everything inside and needs no network: put it on a stick, a course page, a mail.",
    scene_file: "Scene file",
    page_file: "This page with the scene",
    page_about: "The page was not loaded whole, so it cannot be saved. Reload it.",
    copy_link: "Copy the link",
    link_of: "Link with the scene in it, {size} characters",
    link_copied: "The link is on the clipboard: {size} characters.",
    link_not_copied: "This browser does not let the page use the clipboard. The link is selected: copy it with Ctrl+C.",
    link_long: "At {size} characters this link is too long for some mail programs and chats. The scene file or the page as one file is safer.",
    link_local: "This page was opened from a file of this computer: its links work only here. Open it from a web page to share links, or share the page as one file.",
    print: "Print at 100 %",
    print_now: "Print …",
    size: "{name} {width} mm × {height} mm",
    on: "Sheet {number} of {count}",
    preview: "The sheet as it is printed",
    to_scale: "In the print dialogue choose 100 % (actual size), this paper, and no margins.",
    ruler: "The work sheet has a ruler. If it measures 50 mm on the print, everything is true to scale.",
    saved: "Saved: {name}",
  },
  es: {
    old_text: "El texto de la escena tiene un error. Las figuras, los números y lo impreso son los del último texto correcto; el archivo de escena, la página y el enlace llevan el texto tal como está.",
    pictures: "Figuras",
    figure: "Figura",
    worksheet: "Hoja de trabajo",
    this_step: "Paso {number}",
    png_width: "Ancho del PNG, en píxeles",
    as: "{what} como {format}",
    steps: "Construcción",
    coarse: "En una hoja los pasos que van juntos",
    sheets: "{count} hojas, {format} (ZIP)",
    steps_text: "Texto de los pasos",
    packing: "Hoja {number} de {count} …",
    film: "Película",
    film_turn: "Una vuelta del accionamiento",
    film_about: "El navegador graba la figura mientras los accionamientos se mueven como dice la escena: seis segundos, o seis por vuelta hasta que el mecanismo está donde empezó. Deje la página a la vista; tirar de un punto, reproducir o cambiar la escena interrumpe la grabación. El programa hace GIF, para presentaciones y mensajes: kinegon draw escena.json -o película.gif",
    filming: "Grabando …",
    film_taken: "La grabación se interrumpió: algo se movió o cambió.",
    film_hidden: "La grabación se interrumpió: la página no estaba a la vista.",
    film_stuck: "No hay película: el accionamiento no puede moverse desde donde está.",
    cannot_film: "Este navegador no graba películas. El programa las hace: kinegon draw escena.json -o película.gif",
    numbers: "Números",
    motion: "Movimiento a lo largo del ciclo (CSV)",
    results: "Resultados (JSON)",
    scene: "Escena",
    scene_about: "El archivo vuelve a entrar en esta página y en el programa. La página en un solo archivo lo lleva todo dentro y no necesita red: póngala en una memoria, en la página del curso, en un correo.",
    scene_file: "Archivo de escena",
    page_file: "Esta página con la escena",
    page_about: "La página no se cargó entera y no puede guardarse. Vuelva a cargarla.",
    copy_link: "Copiar el enlace",
    link_of: "Enlace con la escena dentro, {size} caracteres",
    link_copied: "El enlace está en el portapapeles: {size} caracteres.",
    link_not_copied: "Este navegador no deja que la página use el portapapeles. El enlace está seleccionado: cópielo con Ctrl+C.",
    link_long: "Con {size} caracteres este enlace es demasiado largo para algunos programas de correo y chats. El archivo de escena o la página en un solo archivo son más seguros.",
    link_local: "Esta página se abrió desde un archivo de este ordenador: sus enlaces solo valen aquí. Ábrala desde la web para compartir enlaces, o comparta la página en un solo archivo.",
    print: "Imprimir al 100 %",
    print_now: "Imprimir …",
    size: "{name} {width} mm × {height} mm",
    on: "Hoja {number} de {count}",
    preview: "La hoja tal como se imprime",
    to_scale: "En el diálogo de impresión elija 100 % (tamaño real), este papel y ningún margen.",
    ruler: "La hoja de trabajo tiene una regla. Si mide 50 mm en el papel, todo está a escala.",
    saved: "Guardado: {name}",
  },
};

/** The panel's sentences. */
export const say = speaker(WORDS);
