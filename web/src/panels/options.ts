/** The panel Options: speed, theme, random seed, and a link to the present view. */
import type { App } from "../page/app";
import { choiceBar, make } from "../page/dom";
import type { Panel } from "../page/dock";
import { notice } from "../page/messages";
import { applyTheme, chosenTheme, chooseTheme, THEMES } from "../page/theme";
import { LONGEST_LEVEL, SPEEDS } from "../page/url";

/** What the copied link contains. A level whose packed text is too long is missing in it. */
function carried({ state: { level } }: App): string {
  if (!level) return "scene, choices, view and code.";
  return location.hash.includes("level=")
    ? "level, choices, view and code."
    : `choices and view, but not the level, which is over ${LONGEST_LEVEL / 1000} kB even packed. ` +
        "Send its file too.";
}

export function createPanel(app: App): Panel {
  const speed = choiceBar(
    "speed",
    "Speed",
    "times real time",
    SPEEDS.map((value) => ({ value: String(value), label: `${value}×` })),
    (value) => app.setSpeed(Number(value)),
  );
  const theme = choiceBar(
    "theme",
    "Theme",
    "",
    THEMES.map((value) => ({ value, label: value })),
    (value) => {
      chooseTheme(value);
      applyTheme();
    },
  );
  theme.show(chosenTheme());
  const seed = make("input", {
    type: "number",
    id: "seed",
    min: 0,
    max: 999999999,
    step: 1,
    inputmode: "numeric",
  });
  seed.addEventListener("change", () => {
    if (!seed.checkValidity() || seed.value === "") return;
    app.state.seed = Number(seed.value);
    void app.restart();
  });
  const share = make("button", { class: "wide", id: "share" }, "Copy a link to what you see");
  share.addEventListener("click", () => {
    void navigator.clipboard.writeText(location.href).then(
      () => notice(`The link is in the clipboard: ${carried(app)}`),
      () => notice("The clipboard is not allowed here: copy the address from the address bar."),
    );
  });
  const element = make(
    "div",
    {},
    speed.element,
    theme.element,
    make(
      "fieldset",
      {},
      make("legend", {}, make("label", { for: "seed" }, "Random seed")),
      seed,
    ),
    make("div", { class: "section" }, share),
  );
  const show = () => {
    speed.show(String(app.state.speed));
    seed.value = String(app.state.seed);
  };
  app.listen({ state: show });
  show();
  return { element };
}
