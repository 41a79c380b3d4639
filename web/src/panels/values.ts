/** The panel Values: the controls of the running scene (scene/controls.ts), and its readings, which
 * are rows of figures under a ticked box. */
import type { App } from "../page/app";
import type { Panel } from "../page/dock";
import { choiceBar, make } from "../page/dom";
import { say } from "../page/messages";
import type {
  CheckControl,
  ChoiceControl,
  Control,
  Readings,
  Setting,
  SliderControl,
} from "../scene/controls";
import { fillList } from "./inside/values";
import { makeMatrix } from "./matrix";
import "../style/values.css";

/** Milliseconds from the visitor's last change until the readings are announced. Chosen. */
const SETTLED = 900;

/** Milliseconds for which a control keeps a value that the visitor has set, although frames made
 * before the change still carry the old one. Chosen. */
const ON_ITS_WAY = 1000;

/** A control's element; `show` displays a value, `read` the readings that belong to it. */
interface Made {
  element: HTMLElement;
  show(value: Setting): void;
  read?(rows: Readings[string]): void;
}

export function createPanel(app: App): Panel {
  const element = make("div", { class: "values-panel" });
  let made = new Map<string, Made>();
  let controls: readonly Control[] = [];
  let timer = 0;
  /** Values that were set and that no frame has carried yet; they are shown until `until`. */
  const sent = new Map<string, { value: Setting; until: number }>();

  /** Announces the first reading under each ticked box. */
  const tellRest = () => {
    const { settings = {}, paint } = app.player.shown?.frame ?? {};
    const told = controls
      .filter(({ kind, name }) => kind === "check" && settings[name])
      .flatMap(({ name }) => paint?.readings?.[name]?.slice(0, 1) ?? [])
      .map(([name, value]) => `${name}: ${value}`);
    say(told.join(". "));
  };
  const set = (name: string, value: Setting) => {
    sent.set(name, { value, until: performance.now() + ON_ITS_WAY });
    app.do({ kind: "set", name, value });
    clearTimeout(timer);
    timer = window.setTimeout(tellRest, SETTLED);
  };

  const show = () => {
    const { settings, paint } = app.player.shown?.frame ?? {};
    if (!settings) return;
    for (const [name, control] of made) {
      const wanted = sent.get(name);
      if (wanted && wanted.value !== settings[name] && performance.now() < wanted.until) continue;
      sent.delete(name);
      control.show(settings[name]);
      control.read?.((settings[name] && paint?.readings?.[name]) || []);
    }
  };
  const begin = () => {
    const next = app.scene?.controls ?? [];
    // A scene that starts again has the same controls; their elements stay, and keep the focus.
    if (next.length > 0 && JSON.stringify(next) === JSON.stringify(controls)) return;
    controls = next;
    made = new Map(controls.map((control) => [control.name, makeControl(control, set)]));
    element.replaceChildren(...groupsOf(controls, made));
    if (controls.length === 0)
      element.append(make("p", { class: "quiet" }, "This scene has nothing to set."));
    show();
  };
  app.listen({ run: begin, frame: show });
  begin();
  return { element, opened: show };
}

/** The elements of the panel: one for each group of controls. */
function groupsOf(controls: readonly Control[], made: ReadonlyMap<string, Made>): HTMLElement[] {
  const names = [...new Set(controls.map(({ group }) => group))];
  return names.map((group) => {
    const ofGroup = controls.filter((control) => control.group === group);
    const elements = ofGroup.map(({ name }) => made.get(name)!.element);
    // A group of sliders alone is folded: sliders take much room, and are needed less often.
    if (ofGroup.every(({ kind }) => kind === "slider"))
      return make(
        "details",
        { class: "section" },
        make("summary", {}, group),
        make("div", { role: "group", "aria-label": group }, ...elements),
      );
    return make("fieldset", {}, make("legend", {}, group), ...elements);
  });
}

type Set = (name: string, value: Setting) => void;

/** Creates a control; `set` is called with its name and value when the visitor changes it. */
function makeControl(control: Control, set: Set): Made {
  if (control.kind === "choice") return makeChoice(control, set);
  if (control.kind === "matrix") return makeMatrix(control, set);
  return control.kind === "check" ? makeCheck(control, set) : makeSlider(control, set);
}

function makeChoice({ name, label, options }: ChoiceControl, set: Set): Made {
  const bar = choiceBar(`set-${name}`, label, "", options, (value) => set(name, value));
  // A letter stands before the choices, a word above them.
  bar.element.classList.toggle("worded", label.length > 1);
  return { element: bar.element, show: (value) => bar.show(String(value)) };
}

function makeCheck({ name, label, about }: CheckControl, set: Set): Made {
  const input = make("input", {
    type: "checkbox",
    name: `set-${name}`,
    "aria-labelledby": `set-${name}-title`,
    "aria-describedby": `set-${name}-about`,
  });
  input.addEventListener("change", () => set(name, input.checked));
  const list = make("dl", { class: "values", "data-readings": name });
  const text = make(
    "span",
    {},
    make("b", { id: `set-${name}-title` }, label),
    make("small", { id: `set-${name}-about` }, about),
  );
  return {
    element: make("div", { class: "check" }, make("label", {}, input, text), list),
    show: (value) => (input.checked = Boolean(value)),
    read: (rows) => fillList(list, rows),
  };
}

function makeSlider({ name, label, least, most, step }: SliderControl, set: Set): Made {
  const input = make("input", { type: "range", name: `set-${name}`, min: least, max: most, step });
  const digits = step < 1 ? 2 : 0;
  const output = make("output", { "aria-hidden": "true" });
  const write = (value: number) => {
    const text = value.toFixed(digits);
    if (output.textContent === text) return;
    output.textContent = text;
    input.setAttribute("aria-valuetext", text);
  };
  input.addEventListener("input", () => {
    set(name, input.valueAsNumber);
    write(input.valueAsNumber);
  });
  return {
    element: make("label", { class: "slider" }, make("span", {}, label), input, output),
    show(value) {
      input.valueAsNumber = Number(value);
      write(Number(value));
    },
  };
}
