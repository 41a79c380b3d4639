/**
 * `Editor`: the code editor, CodeMirror with a state for each file. It is in a shadow tree, into
 * which CodeMirror puts its styles without a style element in the page, which the page's content
 * security policy forbids.
 */
import { indentWithTab, isolateHistory } from "@codemirror/commands";
import { javascript, javascriptLanguage } from "@codemirror/lang-javascript";
import { lintGutter, setDiagnostics } from "@codemirror/lint";
import { EditorState, type Extension, Prec } from "@codemirror/state";
import { EditorView, keymap, tooltips } from "@codemirror/view";
import { basicSetup } from "codemirror";
import { make } from "../../page/dom";
import { completeNames } from "./complete";
import { codeTheme } from "./theme";

export interface EditorActions {
  changed(): void;
  run(): void;
  /** Escape was pressed: Tab now leaves the editor, and a second Escape closes the panel. */
  escaped(): void;
}

export class Editor {
  /** The element that contains the editor. */
  readonly host = make("div", { class: "code-editor", "data-typed": true });
  readonly #actions: EditorActions;
  readonly #view: EditorView;
  /** States (text, undo history) of the files by their paths. That of the shown file is out of
   * date: the view has the current one. */
  readonly #states = new Map<string, EditorState>();
  /** The path of the file that is shown; "" for none. */
  #shown = "";
  /** Escape was pressed in the editor, and no other key but Tab and Shift since. */
  #escaped = false;

  constructor(actions: EditorActions) {
    this.#actions = actions;
    const root = this.host.attachShadow({ mode: "open" });
    this.#view = new EditorView({ root, parent: root });
    // When the editor gets the focus again, Tab indents again.
    this.host.addEventListener("focusout", () => this.#setEscaped(false));
  }

  /** Removes all files. */
  clear(): void {
    this.#states.clear();
    this.#shown = "";
    this.#view.setState(EditorState.create());
  }

  /** Adds a file, or replaces the state of one that exists; does not show it. */
  add(path: string, text: string, readOnly: boolean): void {
    const name = path.replace(/^.*\//, "");
    const label = readOnly
      ? `${name}, read only. Escape, then Tab, leaves it.`
      : `${name}. Tab indents; Escape, then Tab, leaves the editor. Control and Enter runs it.`;
    const extensions = [
      this.#setup,
      EditorState.readOnly.of(readOnly),
      // tabindex says outright that Tab reaches the text, and with it the region that scrolls.
      EditorView.contentAttributes.of({ "aria-label": label, tabindex: "0" }),
    ];
    this.#states.set(path, EditorState.create({ doc: text, extensions }));
    if (path === this.#shown) this.#view.setState(this.#states.get(path)!);
  }

  has(path: string): boolean {
    return this.#states.has(path);
  }

  /** Shows a file that has been added. */
  show(path: string): void {
    if (path === this.#shown) return;
    if (this.#states.has(this.#shown)) this.#states.set(this.#shown, this.#view.state);
    this.#shown = path;
    this.#view.setState(this.#states.get(path)!);
  }

  /** The text of a file; "" if there is no such file. */
  textOf(path: string): string {
    return this.#stateOf(path)?.doc.toString() ?? "";
  }

  /** Replaces the text of the file that is shown, as a single edit that can be undone. */
  replace(text: string): void {
    const { length } = this.#view.state.doc;
    this.#view.dispatch({
      changes: { from: 0, to: length, insert: text },
      annotations: isolateHistory.of("full"),
    });
  }

  /** Marks an error in the file that is shown, and scrolls to it. Lines and columns count from 1;
   * without a column the whole line is marked. */
  mark(message: string, line: number, column: number | undefined): void {
    const { state } = this.#view;
    const { doc } = state;
    const { from: start, to } = doc.line(Math.min(Math.max(1, line), doc.lines));
    const from = Math.min(start + (column ?? 1) - 1, to);
    const word = column === undefined ? null : state.wordAt(from);
    const end = word?.to ?? (column === undefined ? to : Math.min(to, from + 1));
    this.#view.dispatch(setDiagnostics(state, [{ from, to: end, severity: "error", message }]));
    this.#view.dispatch({ effects: EditorView.scrollIntoView(from, { y: "center" }) });
  }

  /** Removes the mark. */
  unmark(): void {
    this.#view.dispatch(setDiagnostics(this.#view.state, []));
  }

  /** Moves the cursor to a line and column, and focuses the editor. */
  goTo(line: number, column = 1): void {
    const { doc } = this.#view.state;
    const { from, to } = doc.line(Math.min(Math.max(1, line), doc.lines));
    const anchor = Math.min(from + column - 1, to);
    this.#view.dispatch({ selection: { anchor }, scrollIntoView: true });
    this.#view.focus();
  }

  #stateOf(path: string): EditorState | undefined {
    return path === this.#shown ? this.#view.state : this.#states.get(path);
  }

  /** The extensions of every file's state. */
  get #setup(): Extension {
    const run = () => {
      this.#actions.run();
      return true;
    };
    return [
      Prec.highest(keymap.of([{ key: "Mod-Enter", run }, { key: "Ctrl-Enter", run }])),
      basicSetup,
      keymap.of([indentWithTab]),
      // Lowest precedence: Escape first closes search, completion and the like in the editor.
      Prec.lowest(keymap.of([{ key: "Escape", run: () => this.#escape() }])),
      EditorView.domEventHandlers({
        keydown: ({ key }) => {
          if (!["Escape", "Tab", "Shift"].includes(key)) this.#setEscaped(false);
        },
        beforeinput: replaceSelection,
      }),
      EditorView.updateListener.of((update) => {
        if (update.docChanged) this.#actions.changed();
      }),
      javascript(),
      javascriptLanguage.data.of({ autocomplete: completeNames }),
      lintGutter(),
      tooltips({
        position: "absolute",
        tooltipSpace: ({ dom }) => dom.getBoundingClientRect(),
      }),
      codeTheme,
    ];
  }

  /** Escape: true if the editor handles it. A second one is left to the dock, which closes. */
  #escape(): boolean {
    if (this.#escaped) return false;
    this.#setEscaped(true);
    this.#actions.escaped();
    return true;
  }

  /** Sets whether the Tab key leaves the editor (true) or indents. */
  #setEscaped(escaped: boolean): void {
    this.#escaped = escaped;
    this.#view.setTabFocusMode(escaped);
  }
}

/**
 * Replaces the selection by typed text; true if it did. Browsers by themselves would insert the
 * text with a style attribute that copies the selection's look, which the page's content security
 * policy forbids.
 */
function replaceSelection(event: InputEvent, view: EditorView): boolean {
  const { data, inputType, isComposing } = event;
  const { state } = view;
  const { from, to, empty } = state.selection.main;
  if (empty || isComposing || inputType !== "insertText" || data === null) return false;
  event.preventDefault();
  const insert = () =>
    state.update(state.replaceSelection(data), { userEvent: "input.type", scrollIntoView: true });
  // Extensions handle some input: a typed bracket, for one, is put around the selection.
  const handled = state
    .facet(EditorView.inputHandler)
    .some((handler) => handler(view, from, to, data, insert));
  if (!handled) view.dispatch(insert());
  return true;
}
