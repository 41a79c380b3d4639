/** The controls around the canvas: buttons, dialogs, keys and messages. No simulation in here. */
import {
  type Broadphase,
  BROADPHASES,
  type Detection,
  DETECTIONS,
  QUALITIES,
  type Quality,
} from "thud";
import type { Entry } from "./catalogue";
import type { Tool } from "./input";
import { OVERLAYS, type OverlayName } from "./render/overlay";
import { SPEEDS } from "./url";

export type ThemeChoice = "system" | "dark" | "light";

export interface UiActions {
  choose(entry: Entry): void;
  openFile(file: File): void;
  togglePause(): void;
  step(): void;
  reset(): void;
  fit(): void;
  setTool(tool: Tool): void;
  setSpeed(speed: number): void;
  setQuality(quality: Quality): void;
  setDetection(detection: Detection): void;
  setBroadphase(broadphase: Broadphase): void;
  setOverlay(name: OverlayName, on: boolean): void;
  setTheme(theme: ThemeChoice): void;
  pan(dx: number, dy: number): void;
  zoom(factor: number): void;
}

const SUBSTEPS: Record<Quality, number> = { draft: 2, default: 4, high: 8, exact: 16 };

export function byId<T extends HTMLElement = HTMLElement>(id: string): T {
  return document.getElementById(id) as T;
}

/** In the order of OVERLAYS. */
const OVERLAY_KEYS = ["1", "2", "3", "4", "5", "6", "7", "8", "9", "M"];

/** Pixels that an arrow key moves the view. */
const PAN = 60;

interface Key {
  keys: string[];
  /** As event.key gives them, in lower case. */
  codes: string[];
  what: string;
  act: () => void;
}

export class Ui {
  readonly #actions: UiActions;
  readonly #keys: Key[];
  #noticeTimer = 0;

  constructor(actions: UiActions) {
    this.#actions = actions;
    const dialog = (id: string) => byId<HTMLDialogElement>(id);
    const tool = (name: Tool) => () => actions.setTool(name);
    const overlay = (name: OverlayName) => () => {
      const box = document.querySelector<HTMLInputElement>(`[name=overlay][value=${name}]`)!;
      box.click();
    };
    const near = (set: string, by: number) => () => {
      const inputs = [...document.querySelectorAll<HTMLInputElement>(`[name=${set}]`)];
      inputs[inputs.findIndex((input) => input.checked) + by]?.click();
    };
    const next = (set: string) => () => {
      const inputs = [...document.querySelectorAll<HTMLInputElement>(`[name=${set}]`)];
      inputs[(inputs.findIndex((input) => input.checked) + 1) % inputs.length].click();
    };
    const key = (keys: string, codes: string[], what: string, act: () => void): Key => ({
      keys: keys.split(" "),
      codes,
      what,
      act,
    });
    this.#keys = [
      key("Space P", [" ", "p"], "Pause or go on", actions.togglePause),
      key(".", ["."], "Single step", actions.step),
      key("R", ["r"], "Reset the scene", actions.reset),
      key("V", ["v"], "Drag bodies", tool("hand")),
      key("C", ["c"], "Add circles", tool("circle")),
      key("B", ["b"], "Add boxes", tool("box")),
      key("G", ["g"], "Dig the ground", tool("dig")),
      key("[", ["["], "Slower", near("speed", -1)),
      key("]", ["]"], "Faster", near("speed", 1)),
      key(",", [","], "Lower quality", near("quality", -1)),
      key("/", ["/"], "Higher quality", near("quality", 1)),
      key("E", ["e"], "Next detection", next("detection")),
      key("F", ["f"], "Next broadphase", next("broadphase")),
      key("←", ["arrowleft"], "Move the view left", () => actions.pan(PAN, 0)),
      key("→", ["arrowright"], "Move the view right", () => actions.pan(-PAN, 0)),
      key("↑", ["arrowup"], "Move the view up", () => actions.pan(0, PAN)),
      key("↓", ["arrowdown"], "Move the view down", () => actions.pan(0, -PAN)),
      key("+", ["+", "="], "Zoom in", () => actions.zoom(1.25)),
      key("−", ["-"], "Zoom out", () => actions.zoom(0.8)),
      key("0", ["0"], "Show the whole scene", actions.fit),
      ...OVERLAYS.map((name, i) =>
        key(OVERLAY_KEYS[i], [OVERLAY_KEYS[i].toLowerCase()], `Show ${name}`, overlay(name)),
      ),
      key("L", ["l"], "Scenes and levels", () => this.#open(dialog("scenes"))),
      key("O", ["o"], "Options", () => this.#open(dialog("options"))),
      key("H ?", ["h", "?"], "This list", () => this.#open(dialog("help"))),
    ];
    this.#listenToButtons();
    this.#fillOptions();
    this.#fillHelp();
    document.addEventListener("keydown", (event) => this.#press(event));
  }

  fillScenes(entries: readonly Entry[]): void {
    const list = byId("scene-list");
    list.replaceChildren();
    for (const group of new Set(entries.map((entry) => entry.group))) {
      const heading = document.createElement("h3");
      heading.textContent = group;
      list.append(heading);
      for (const entry of entries.filter((each) => each.group === group)) {
        const button = document.createElement("button");
        const title = document.createElement("b");
        const about = document.createElement("span");
        title.textContent = entry.title;
        about.textContent = entry.about;
        button.dataset.entry = `${entry.kind}/${entry.name}`;
        button.append(title, about);
        button.addEventListener("click", () => {
          byId<HTMLDialogElement>("scenes").close();
          this.#actions.choose(entry);
        });
        list.append(button);
      }
    }
  }

  showScene(entry: Entry): void {
    byId("scene-title").textContent = entry.title;
    byId("scenes-button").setAttribute("aria-label", `Scenes and levels; now: ${entry.title}`);
    document.title = `${entry.title} · thud`;
    for (const button of document.querySelectorAll<HTMLElement>("[data-entry]")) {
      const current = button.dataset.entry === `${entry.kind}/${entry.name}`;
      if (current) button.setAttribute("aria-current", "true");
      else button.removeAttribute("aria-current");
    }
    this.say(`${entry.title}. ${entry.about}`);
    this.notice(entry.about);
  }

  showPaused(paused: boolean): void {
    byId("pause").setAttribute("aria-pressed", String(paused));
  }

  showTool(tool: Tool): void {
    for (const button of document.querySelectorAll<HTMLElement>("[data-tool]"))
      if (button.tagName === "BUTTON")
        button.setAttribute("aria-pressed", String(button.dataset.tool === tool));
    byId("overlay").dataset.tool = tool;
  }

  /** Checks the radio button of a set without acting. */
  showChoice(
    set: "speed" | "quality" | "detection" | "broadphase" | "theme",
    value: string,
  ): void {
    for (const input of document.querySelectorAll<HTMLInputElement>(`[name=${set}]`))
      input.checked = input.value === value;
  }

  showOverlays(shown: ReadonlySet<OverlayName>): void {
    for (const box of document.querySelectorAll<HTMLInputElement>("[name=overlay]"))
      box.checked = shown.has(box.value as OverlayName);
  }

  /** For screen readers. */
  say(text: string): void {
    byId("status").textContent = text;
  }

  /** A line over the controls that goes by itself. */
  notice(text: string, seconds = 7): void {
    const line = byId("notice");
    clearTimeout(this.#noticeTimer);
    line.textContent = text;
    line.hidden = text === "";
    this.#noticeTimer = window.setTimeout(() => (line.hidden = true), seconds * 1000);
  }

  /** A message that must be read; without a way on it stays. */
  fail(title: string, text: string, details: readonly string[] = [], wayOn?: () => void): void {
    const failure = byId("failure");
    failure.querySelector("h2")!.textContent = title;
    failure.querySelector("p")!.textContent = text;
    const items = details.slice(0, 12).map((detail) => {
      const item = document.createElement("li");
      item.textContent = detail;
      return item;
    });
    failure.querySelector("ul")!.replaceChildren(...items);
    const button = failure.querySelector("button")!;
    button.hidden = !wayOn;
    button.onclick = () => {
      failure.hidden = true;
      wayOn?.();
    };
    failure.hidden = false;
    if (wayOn) button.focus();
  }

  #listenToButtons(): void {
    const actions = this.#actions;
    byId("pause").addEventListener("click", actions.togglePause);
    byId("step").addEventListener("click", actions.step);
    byId("reset").addEventListener("click", actions.reset);
    byId("fit").addEventListener("click", actions.fit);
    for (const button of document.querySelectorAll<HTMLElement>("button[data-tool]"))
      button.addEventListener("click", () => actions.setTool(button.dataset.tool as Tool));
    for (const name of ["scenes", "options", "help"]) {
      const dialog = byId<HTMLDialogElement>(name);
      const opener = byId(`${name}-button`);
      opener.addEventListener("click", () => this.#open(dialog));
      dialog.addEventListener("close", () => opener.setAttribute("aria-expanded", "false"));
      dialog.querySelector(".close")!.addEventListener("click", () => dialog.close());
      // A click beside a dialog, on its backdrop, closes it.
      dialog.addEventListener("click", (event) => {
        if (event.target === dialog) dialog.close();
      });
    }
    const file = byId<HTMLInputElement>("level-file");
    byId("open-level").addEventListener("click", () => file.click());
    file.addEventListener("change", () => {
      if (file.files?.[0]) actions.openFile(file.files[0]);
      file.value = "";
      byId<HTMLDialogElement>("scenes").close();
    });
    this.#listenToDrops();
  }

  #listenToDrops(): void {
    const sign = byId("drop");
    document.addEventListener("dragover", (event) => {
      event.preventDefault();
      sign.hidden = false;
    });
    document.addEventListener("dragleave", (event) => {
      if (!event.relatedTarget) sign.hidden = true;
    });
    document.addEventListener("drop", (event) => {
      event.preventDefault();
      sign.hidden = true;
      const file = event.dataTransfer?.files[0];
      if (file) this.#actions.openFile(file);
    });
  }

  #open(dialog: HTMLDialogElement): void {
    if (dialog.open) return;
    dialog.showModal();
    byId(`${dialog.id}-button`).setAttribute("aria-expanded", "true");
    dialog.querySelector('[aria-current="true"]')?.scrollIntoView({ block: "nearest" });
  }

  #fillOptions(): void {
    const actions = this.#actions;
    const choices = (set: string, values: [string, string][], act: (value: string) => void) => {
      for (const [value, label] of values)
        byId(set).append(input("radio", set, value, label, () => act(value)));
    };
    choices(
      "speed",
      SPEEDS.map((speed) => [String(speed), `${speed}×`]),
      (value) => actions.setSpeed(Number(value)),
    );
    choices(
      "quality",
      QUALITIES.map((name) => [name, `${name} ${SUBSTEPS[name]}`]),
      (value) => actions.setQuality(value as Quality),
    );
    choices(
      "detection",
      DETECTIONS.map((name) => [name, name]),
      (value) => actions.setDetection(value as Detection),
    );
    choices(
      "broadphase",
      BROADPHASES.map((name) => [name, name]),
      (value) => actions.setBroadphase(value as Broadphase),
    );
    choices(
      "theme",
      ["system", "dark", "light"].map((name) => [name, name]),
      (value) => actions.setTheme(value as ThemeChoice),
    );
    for (const name of OVERLAYS)
      byId("overlays").append(
        input("checkbox", "overlay", name, name, (on) => actions.setOverlay(name, on)),
      );
  }

  #fillHelp(): void {
    for (const { keys, what } of this.#keys) {
      const row = document.createElement("div");
      const term = document.createElement("dt");
      const meaning = document.createElement("dd");
      for (const name of keys) {
        const cap = document.createElement("kbd");
        cap.textContent = name;
        term.append(cap);
      }
      meaning.textContent = what;
      row.append(term, meaning);
      byId("keys").append(row);
    }
  }

  #press(event: KeyboardEvent): void {
    const target = event.target as HTMLElement;
    if (event.ctrlKey || event.metaKey || event.altKey) return;
    if (!byId("failure").hidden || document.querySelector("dialog[open]")) return;
    // Space and Enter on a button press that button.
    if (target.tagName === "BUTTON" && (event.key === " " || event.key === "Enter")) return;
    const key = this.#keys.find(({ codes }) => codes.includes(event.key.toLowerCase()));
    if (!key) return;
    event.preventDefault();
    key.act();
  }
}

function input(
  type: "radio" | "checkbox",
  name: string,
  value: string,
  text: string,
  act: (on: boolean) => void,
): HTMLLabelElement {
  const label = document.createElement("label");
  const box = document.createElement("input");
  const caption = document.createElement("span");
  Object.assign(box, { type, name, value });
  box.addEventListener("change", () => act(box.checked));
  caption.textContent = text;
  label.append(box, caption);
  return label;
}
