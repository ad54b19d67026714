// Makes the scenes of the guide live: a picture of a scene becomes the scene itself, with its steps and its motion, and so does a scene that is printed whole.
// `web/build --guide DIR` puts the component and the scenes beside the book; without them, or without scripts, the pictures stay.
(() => {
  const root = typeof path_to_root === "string" ? path_to_root : "";
  const load = (name) =>
    new Promise((done, failed) => {
      const script = document.createElement("script");
      script.src = root + name;
      script.onload = done;
      script.onerror = failed;
      document.head.append(script);
    });
  const plan = (text) => {
    const made = document.createElement("kinegon-plan");
    const scene = document.createElement("script");
    scene.type = "application/json";
    scene.textContent = text;
    made.setAttribute("controls", "");
    made.append(scene);
    return made;
  };
  const isScene = (text) => {
    try {
      const { kinegon, ground, links } = JSON.parse(text);
      return kinegon === 1 && ground !== undefined && links !== undefined;
    } catch {
      return false;
    }
  };
  const makeLive = () => {
    const scenes = window.kinegonScenes;
    for (const picture of document.querySelectorAll('main img[src$=".svg"]')) {
      const text = scenes[/([^/]+)\.svg$/.exec(picture.getAttribute("src"))[1]];
      if (text === undefined) continue;
      const live = plan(text);
      live.setAttribute("aria-label", picture.alt);
      picture.replaceWith(live);
      live.append(picture);
    }
    for (const code of document.querySelectorAll("main code.language-json")) {
      if (isScene(code.textContent)) code.closest("pre").after(plan(code.textContent));
    }
    if (document.querySelector("kinegon-plan") !== null) return load("kinegon-plan.js");
  };
  load("kinegon-scenes.js").then(makeLive).catch(() => undefined);
})();
