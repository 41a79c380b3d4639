/**
 * The page's messages: a notice that disappears by itself, announcements to screen readers, and
 * failures that cover the page.
 */
import { byId, make } from "./dom";

/** Announcements that stay in the log, since a screen reader may be some behind. Chosen. */
const SAID = 3;
/**
 * Maximum number of details of a failure that are listed; browsers are slow with longer lists.
 * Chosen.
 */
const MOST_DETAILS = 2000;

let noticeTimer = 0;

/** Shows a line over the controls for some seconds and announces it; "" hides it. */
export function notice(text: string, seconds = 7): void {
  const line = byId("notice");
  clearTimeout(noticeTimer);
  line.textContent = text;
  line.hidden = text === "";
  noticeTimer = window.setTimeout(() => (line.hidden = true), seconds * 1000);
  // Not announced twice: the last announcement may already end with this text.
  const said = byId("status").lastElementChild?.textContent ?? "";
  if (!said.endsWith(text)) say(text);
}

/** Announces a text to screen readers. It is appended to an element of role "log", of which they
 * read each new line even if the next one follows at once. */
export function say(text: string): void {
  const log = byId("status");
  log.append(make("p", {}, text));
  if (log.children.length > SAID) log.firstElementChild!.remove();
}

/** The button of a failure: its label, and what it does after the failure is hidden. */
export interface WayOn {
  label: string;
  go(): void;
}

/** Number of the latest failure. */
let failures = 0;
/** The element that had the focus before a failure took it. */
let focusBefore: Element | null = null;

/**
 * Shows a failure over the page. `wayOn` is its button; without one the failure stays. The returned
 * function hides it, unless another failure has replaced it.
 */
export function fail(
  title: string,
  text: string,
  details: readonly string[] = [],
  wayOn?: WayOn,
): () => void {
  const number = ++failures;
  const failure = byId("failure");
  failure.querySelector("h2")!.textContent = title;
  failure.querySelector("p")!.textContent = text;
  const items = details.slice(0, MOST_DETAILS).map((detail) => make("li", {}, detail));
  failure.querySelector("ul")!.replaceChildren(...items);
  const button = failure.querySelector("button")!;
  button.hidden = !wayOn;
  button.textContent = wayOn?.label ?? "";
  const hide = () => {
    failure.hidden = true;
    setInert(false);
    if (focusBefore instanceof HTMLElement) focusBefore.focus();
  };
  button.onclick = () => {
    hide();
    wayOn?.go();
  };
  // An open dialog would cover the failure and keep the keyboard.
  for (const dialog of document.querySelectorAll("dialog")) dialog.close();
  if (failure.hidden) focusBefore = document.activeElement;
  failure.hidden = false;
  setInert(true);
  (wayOn ? button : failure.querySelector<HTMLElement>(".panel")!).focus();
  return () => {
    if (number === failures) hide();
  };
}

/** Makes everything behind a failure unreachable for pointer and keyboard, or reachable again. */
function setInert(inert: boolean): void {
  document.querySelector("main")!.inert = inert;
}
