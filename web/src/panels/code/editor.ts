/** The editor: CodeMirror in a shadow tree, where its styles need no style element of the page. */
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
  /** Escape was pressed: Tab leaves the editor now, and Escape its panel. */
  escaped(): void;
}

export class Editor {
  /** Takes the place that it is given. */
  readonly host = make("div", { class: "code-editor", "data-typed": true });
  readonly #actions: EditorActions;
  readonly #view: EditorView;
  /** Of the files that are not shown, with their pasts for undoing. */
  readonly #states = new Map<string, EditorState>();
  #shown = "";
  #escaped = false;

  constructor(actions: EditorActions) {
    this.#actions = actions;
    const root = this.host.attachShadow({ mode: "open" });
    this.#view = new EditorView({ root, parent: root });
    // Whoever comes back finds Tab indenting again.
    this.host.addEventListener("focusout", () => this.#setEscaped(false));
  }

  /** Forgets all files. */
  clear(): void {
    this.#states.clear();
    this.#shown = "";
    this.#view.setState(EditorState.create());
  }

  /** Adds a file, or another text of one; a file that is not there yet is not shown by this. */
  add(path: string, text: string, readOnly: boolean): void {
    const name = path.replace(/^.*\//, "");
    const label = readOnly
      ? `${name}, read only. Escape, then Tab, leaves it.`
      : `${name}. Tab indents; Escape, then Tab, leaves the editor. Control and Enter runs it.`;
    const extensions = [
      this.#setup,
      EditorState.readOnly.of(readOnly),
      EditorView.contentAttributes.of({ "aria-label": label }),
    ];
    this.#states.set(path, EditorState.create({ doc: text, extensions }));
    if (path === this.#shown) this.#view.setState(this.#states.get(path)!);
  }

  has(path: string): boolean {
    return this.#states.has(path);
  }

  show(path: string): void {
    if (path === this.#shown) return;
    if (this.#states.has(this.#shown)) this.#states.set(this.#shown, this.#view.state);
    this.#shown = path;
    this.#view.setState(this.#states.get(path)!);
  }

  textOf(path: string): string {
    return this.#stateOf(path)?.doc.toString() ?? "";
  }

  /** Puts another text into the file that is shown; can be undone by itself. */
  replace(text: string): void {
    const { length } = this.#view.state.doc;
    this.#view.dispatch({
      changes: { from: 0, to: length, insert: text },
      annotations: isolateHistory.of("full"),
    });
  }

  /** Marks a place of the file that is shown. */
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

  unmark(): void {
    this.#view.dispatch(setDiagnostics(this.#view.state, []));
  }

  /** Puts the cursor to a place, and the keyboard with it. */
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

  get #setup(): Extension {
    const run = () => {
      this.#actions.run();
      return true;
    };
    return [
      Prec.highest(keymap.of([{ key: "Mod-Enter", run }, { key: "Ctrl-Enter", run }])),
      basicSetup,
      keymap.of([indentWithTab]),
      // After all that Escape closes inside the editor.
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

  /** The second time the panel gets it, which closes. */
  #escape(): boolean {
    if (this.#escaped) return false;
    this.#setEscaped(true);
    this.#actions.escaped();
    return true;
  }

  #setEscaped(escaped: boolean): void {
    this.#escaped = escaped;
    this.#view.setTabFocusMode(escaped);
  }
}

/**
 * Types over a selection. Left to itself a browser would give what is typed the selection's look
 * by a style attribute, which the page's policy forbids.
 */
function replaceSelection(event: InputEvent, view: EditorView): boolean {
  const { data, inputType, isComposing } = event;
  const { state } = view;
  const { from, to, empty } = state.selection.main;
  if (empty || isComposing || inputType !== "insertText" || data === null) return false;
  event.preventDefault();
  const insert = () =>
    state.update(state.replaceSelection(data), { userEvent: "input.type", scrollIntoView: true });
  // Brackets are put around it, for one.
  const handled = state
    .facet(EditorView.inputHandler)
    .some((handler) => handler(view, from, to, data, insert));
  if (!handled) view.dispatch(insert());
  return true;
}
