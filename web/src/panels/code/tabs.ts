/** `Tabs`: a tab for each file of a scene; the first is the scene's module. */
import { make } from "../../page/dom";

export class Tabs {
  readonly element = make("div", { class: "code-tabs", role: "tablist", "aria-label": "Files" });
  readonly #panel: HTMLElement;
  readonly #chosen: (path: string) => void;
  #paths: readonly string[] = [];
  #shown = "";

  /** `panel` is the element that shows the file; `chosen` is called with the path of the file. */
  constructor(panel: HTMLElement, chosen: (path: string) => void) {
    this.#panel = panel;
    this.#chosen = chosen;
    panel.id = "code-file";
    panel.setAttribute("role", "tabpanel");
    this.element.addEventListener("keydown", (event) => this.#press(event));
  }

  /** The path of the file that is shown. */
  get shown(): string {
    return this.#shown;
  }

  /** Shows tabs for these files. The file that is shown stays if it is one of them; otherwise the
   * first is chosen. */
  show(paths: readonly string[]): void {
    this.#paths = paths;
    this.element.replaceChildren(
      ...paths.map((path) => {
        const name = path.replace(/^.*\//, "");
        const tab = make("button", { role: "tab", "aria-controls": this.#panel.id }, name);
        tab.addEventListener("click", () => this.choose(path));
        return tab;
      }),
    );
    this.choose(paths.includes(this.#shown) ? this.#shown : paths[0]);
  }

  /** Selects the tab of a file and has the file shown. */
  choose(path: string): void {
    this.#shown = path;
    [...this.element.children].forEach((tab, i) => {
      const selected = this.#paths[i] === path;
      tab.setAttribute("aria-selected", String(selected));
      tab.setAttribute("tabindex", selected ? "0" : "-1");
    });
    this.#panel.setAttribute("aria-label", path);
    this.#chosen(path);
  }

  /** Arrow keys, Home and End choose a tab and focus it. */
  #press(event: KeyboardEvent): void {
    const { length } = this.#paths;
    const at = this.#paths.indexOf(this.#shown);
    const goal = { ArrowRight: at + 1, ArrowLeft: at + length - 1, Home: 0, End: length - 1 };
    if (!(event.key in goal)) return;
    event.preventDefault();
    const next = goal[event.key as keyof typeof goal] % length;
    this.choose(this.#paths[next]);
    (this.element.children[next] as HTMLElement).focus();
  }
}
