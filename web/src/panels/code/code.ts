/**
 * The panel Code: an editor with the running scene's module, which the visitor can change and run.
 * Changed code is kept as a draft and in the page's address; code that came with a link is shown
 * first and runs when the visitor says so.
 */
import { isConfined } from "../../offline/confine";
import type { App } from "../../page/app";
import type { Panel } from "../../page/dock";
import { make } from "../../page/dom";
import { keepDraft, readDraft } from "../../page/drafts";
import { notice, say } from "../../page/messages";
import { sceneFile } from "../../scene/registry";
import { messageOf } from "../../shared/error";
import type { Trouble } from "../../worker/protocol";
import workerScript from "../../worker/worker?worker&url";
import { Editor } from "./editor";
import { importsOf, readSource } from "./files";
import { createHelp } from "./help";
import { Offer } from "./offer";
import { Tabs } from "./tabs";
import { TroubleLine } from "./trouble";
import "../../style/code.css";

/** The scene that the button New opens, for visitors who write their own. */
const TEMPLATE = "sketch";

export function createPanel(app: App): Panel {
  return new CodePanel(app);
}

class CodePanel implements Panel {
  readonly element: HTMLElement;
  readonly #app: App;
  readonly #editor: Editor;
  readonly #tabs: Tabs;
  readonly #trouble = new TroubleLine((line, column) => this.#goToTrouble(line, column));
  readonly #offer: Offer;
  readonly #status = make("p", { class: "code-status" });
  /** The path of the scene's module, which can be edited; files that it imports are read only. */
  #path = "";
  /** The text of that file on the host. */
  #original = "";
  /** The link's code that the editor shows, or that it showed last; null: none. */
  #offered: string | null = null;
  /** The text that failed to start or stopped with an error, and the error. */
  #failed: { text: string; trouble: Trouble } | null = null;
  /** The visitor's code does not answer. The next scene to start is not the visitor's code, so its
   * start must not hide the error. */
  #ending = false;
  /** Number of the latest load of files; results of earlier ones are dropped. */
  #loads = 0;

  constructor(app: App) {
    this.#app = app;
    this.#editor = new Editor({
      changed: () => this.#changed(),
      run: () => void this.#run(),
      escaped: () => say("Tab leaves the editor now. Escape again closes the panel."),
    });
    this.#tabs = new Tabs(this.#editor.host, () => this.#showFile());
    this.#offer = new Offer({ run: () => void this.#run(), leave: () => app.offerCode(null) });
    this.element = make(
      "div",
      { class: "code" },
      this.#offer.element,
      this.#makeBar(),
      this.#tabs.element,
      this.#editor.host,
      this.#trouble.element,
      make("p", { class: "code-hint" }, "Tab indents. Escape, then Tab, leaves the editor."),
      createHelp(),
    );
    app.listen({
      run: () => this.#ran(),
      offer: () => void this.#load(),
      trouble: (trouble) => this.#fail(trouble),
      stuck: () => this.#stuck(),
      answers: () => this.#answers(),
    });
    void this.#load();
  }

  #makeBar(): HTMLElement {
    const button = (label: string, title: string, act: () => void) => {
      const element = make("button", { title }, label);
      element.addEventListener("click", act);
      return element;
    };
    const run = button("Run", "Run this code (Ctrl+Enter in the editor)", () => void this.#run());
    run.classList.add("code-run");
    return make(
      "div",
      { class: "code-bar" },
      run,
      button("Original", "Back to the original", () => this.#goBack()),
      button("Copy", "Copy the code", () => this.#copy()),
      button("New", "A new scene, from a small one", () => void this.#app.open(TEMPLATE)),
      this.#status,
    );
  }

  /** The text of the scene's module as edited. */
  get #text(): string {
    return this.#editor.textOf(this.#path);
  }

  // ---- files ----

  /** Shows the running scene's module: the link's code, the draft, or what runs, in this order. */
  async #load(): Promise<void> {
    const load = ++this.#loads;
    const { scene, recording } = this.#app.state;
    if (recording) {
      this.#status.textContent = "A recording has no code.";
      return;
    }
    const path = sceneFile(scene);
    let original: string;
    try {
      original = await readSource(path);
    } catch (error) {
      this.#status.textContent = messageOf(error);
      return;
    }
    if (load !== this.#loads) return;
    const own = readDraft(scene) ?? this.#app.state.code ?? original;
    if (path !== this.#path) {
      this.#path = path;
      this.#original = original;
      this.#forgetTrouble();
      this.#editor.clear();
      this.#editor.add(path, own, false);
      this.#tabs.show([path]);
    }
    // The link's code replaces the text as an edit, so that undo leads back to the visitor's text.
    // `left`: the link's code is no longer offered and the editor still shows it.
    const { offeredCode } = this.#app;
    const left = offeredCode === null && this.#offered !== null && this.#text === this.#offered;
    this.#offered = offeredCode;
    if (offeredCode !== null || left) {
      this.#tabs.choose(path);
      this.#editor.replace(offeredCode ?? own);
    }
    this.#refresh();
    await this.#findImports(load);
  }

  /** Adds tabs for the files that the module imports. */
  async #findImports(load: number): Promise<void> {
    const files = await importsOf(this.#path, this.#text);
    if (load !== this.#loads) return;
    for (const { path, text } of files)
      if (!this.#editor.has(path)) this.#editor.add(path, text, true);
    this.#tabs.show([this.#path, ...files.map(({ path }) => path)]);
  }

  /** Shows the file of the chosen tab. */
  #showFile(): void {
    this.#editor.show(this.#tabs.shown);
    this.#mark();
    this.#refresh();
  }

  // ---- actions of the visitor ----

  /** The text in the editor has changed. */
  #changed(): void {
    const text = this.#text;
    // The link's code becomes the visitor's draft only when it is changed or run.
    if (text !== this.#offered) this.#keep(text);
    this.#refresh();
  }

  /** Keeps the text as a draft; the original text needs none. */
  #keep(text: string): void {
    keepDraft(this.#app.state.scene, text === this.#original ? null : text);
  }

  /** Runs the edited text. The link's code runs only if the policy confines it or the visitor has
   * been warned. */
  async #run(): Promise<void> {
    const app = this.#app;
    if (app.state.recording) return;
    if (app.offeredCode !== null && !this.#offer.warned && !(await isConfined(workerScript))) {
      this.#offer.warn();
      return;
    }
    const text = this.#text;
    const { scene, size, seed, camera } = app.state;
    this.#keep(text);
    this.#forgetTrouble();
    const code = text === this.#original ? null : text;
    const runs = await app.open(scene, { code, size, seed, camera, level: app.state.level });
    if (runs) await this.#findImports(++this.#loads);
  }

  /** Restores the original text as an edit, and runs it. */
  #goBack(): void {
    this.#tabs.choose(this.#path);
    if (this.#text !== this.#original) {
      this.#editor.replace(this.#original);
      notice("The original is back. Undoing in the editor (Ctrl+Z) brings your text again.");
    }
    void this.#run();
  }

  #copy(): void {
    void navigator.clipboard.writeText(this.#editor.textOf(this.#tabs.shown)).then(
      () => notice("The code is in the clipboard."),
      () => notice("The clipboard is not allowed here: select the text and copy it."),
    );
  }

  // ---- events of the app ----

  /** A scene has started. */
  #ran(): void {
    if (sceneFile(this.#app.state.scene) !== this.#path) void this.#load();
    else if (!this.#ending) this.#forgetTrouble();
    this.#ending = false;
    this.#offered = this.#app.offeredCode;
    this.#refresh();
  }

  /** The scene failed to start or stopped: shows the error and marks its line. */
  #fail(trouble: Trouble): void {
    const { scene, code } = this.#app.state;
    if (this.#ending || sceneFile(scene) !== this.#path) return;
    this.#failed = { text: code ?? this.#original, trouble };
    const { file = this.#path } = trouble;
    this.#trouble.show(trouble, file === this.#path ? "" : file.replace(/^.*\//, ""));
    this.#mark();
    this.#refresh();
  }

  /** The worker does not answer. */
  #stuck(): void {
    if (this.#app.state.code === null) return;
    this.#fail({ message: "This code did not answer for eight seconds: a loop without an end?" });
    this.#ending = true;
  }

  /** The worker answers after all. */
  #answers(): void {
    if (!this.#ending) return;
    this.#ending = false;
    this.#forgetTrouble();
    this.#refresh();
  }

  /** Hides the error and its mark. */
  #forgetTrouble(): void {
    this.#failed = null;
    this.#trouble.hide();
    this.#editor.unmark();
  }

  /** Marks the error's line in the file that is shown, if the error is in it. */
  #mark(): void {
    const { text, trouble } = this.#failed ?? {};
    if (trouble?.line === undefined) return;
    const { file = this.#path, line, column, message } = trouble;
    // After a change of the text the line may be elsewhere.
    const fits = file !== this.#path || text === this.#text;
    if (fits && file === this.#tabs.shown) this.#editor.mark(message, line, column);
  }

  /** Shows the file in which the error is, and moves the cursor to it. */
  #goToTrouble(line: number, column?: number): void {
    this.#tabs.choose(this.#failed?.trouble.file ?? this.#path);
    this.#editor.goTo(line, column);
  }

  /** Shows the offer, and whether the text runs. */
  #refresh(): void {
    const { state, offeredCode } = this.#app;
    this.#offer.show(offeredCode !== null);
    if (state.recording) return;
    const text = this.#text;
    const changed = text !== (state.code ?? this.#original);
    let status = "Runs unchanged";
    if (this.#tabs.shown !== this.#path) status = "Read only";
    else if (this.#failed?.text === text) status = "Does not run";
    else if (text === offeredCode) status = "Not run yet";
    else if (changed) status = "Changed, not run yet";
    else if (state.code !== null) status = "Your code runs";
    this.#status.textContent = status;
    this.#status.dataset.changed = String(changed);
  }
}
