/** What the page tells: a line that goes by itself, words for screen readers, and failures. */
import { byId, make } from "./dom";

/** Lines of what is said that are kept: a screen reader may be behind by some. */
const SAID = 3;
/** Details of a failure that are listed: a browser is slow with more. */
const MOST_DETAILS = 2000;

let noticeTimer = 0;

/** A line over the controls that goes by itself, and is said. */
export function notice(text: string, seconds = 7): void {
  const line = byId("notice");
  clearTimeout(noticeTimer);
  line.textContent = text;
  line.hidden = text === "";
  noticeTimer = window.setTimeout(() => (line.hidden = true), seconds * 1000);
  // What is told of a scene is said with its name already.
  const said = byId("status").lastElementChild?.textContent ?? "";
  if (!said.endsWith(text)) say(text);
}

/** For screen readers, by a log: they read each line that it gets, however soon the next comes. */
export function say(text: string): void {
  const log = byId("status");
  log.append(make("p", {}, text));
  if (log.children.length > SAID) log.firstElementChild!.remove();
}

export interface WayOn {
  label: string;
  go(): void;
}

let failures = 0;
/** What had the focus before a failure took it. */
let focusBefore: Element | null = null;

/** A message that must be read; without a way on it stays. What is returned takes it back. */
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
  // An open dialog would lie over it, and keep the keys.
  for (const dialog of document.querySelectorAll("dialog")) dialog.close();
  if (failure.hidden) focusBefore = document.activeElement;
  failure.hidden = false;
  setInert(true);
  (wayOn ? button : failure.querySelector<HTMLElement>(".panel")!).focus();
  return () => {
    if (number === failures) hide();
  };
}

/** Nothing behind a failure can be reached until it is read. */
function setInert(inert: boolean): void {
  document.querySelector("main")!.inert = inert;
}
