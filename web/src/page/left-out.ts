/**
 * Shows the notes of a level, which say which parts of its map the page leaves out: a notice with
 * the first note, and a dialog with all of them, which a button in the gallery opens as well.
 */
import { byId, make } from "./dom";
import { notice } from "./messages";

/** Maximum number of notes in the list; browsers are slow with longer lists. Chosen. */
const MOST_LINES = 2000;

let dialog: HTMLDialogElement | null = null;
let opener: HTMLButtonElement | null = null;

/** Shows the notes of a scene that begins, in place of those of the scene before; may be empty. */
export function showNotes(notes: readonly string[]): void {
  const [first, ...more] = notes;
  dialog?.close();
  const button = (opener ??= addOpener());
  button.hidden = !first;
  button.textContent = `What this level does without (${notes.length})`;
  if (!first) return;
  const open = () => openList(notes);
  button.onclick = () => {
    byId<HTMLDialogElement>("scenes").close();
    open();
  };
  notice(`${first}${more.length > 0 ? ` (and ${more.length} more) ` : ""}`, 20);
  if (more.length === 0) return;
  const all = make("button", {}, "List all");
  all.addEventListener("click", open);
  byId("notice").append(all);
}

/** Adds the button to the dialog of scenes. */
function addOpener(): HTMLButtonElement {
  const button = make("button", { id: "notes-button", class: "wide" });
  byId("open-level").before(button);
  return button;
}

function openList(notes: readonly string[]): void {
  dialog ??= addDialog();
  const shown = notes.slice(0, MOST_LINES).map((note) => make("li", {}, note));
  const rest = notes.length - shown.length;
  if (rest > 0) shown.push(make("li", {}, `… and ${rest} more`));
  dialog.querySelector("ul")!.replaceChildren(...shown);
  dialog.showModal();
  dialog.scrollTop = 0;
}

function addDialog(): HTMLDialogElement {
  const close = make("button", { class: "close", "aria-label": "Close" });
  close.append(document.querySelector("dialog .close svg")!.cloneNode(true));
  const heading = make("h2", { id: "notes-heading" }, "What this level does without");
  const head = make("div", { class: "head" }, heading, close);
  const made = make("dialog", { id: "notes", "aria-labelledby": "notes-heading" }, head, make("ul"));
  close.addEventListener("click", () => made.close());
  made.addEventListener("click", (event) => {
    if (event.target === made) made.close();
  });
  document.body.append(made);
  return made;
}
