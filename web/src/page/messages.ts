/** What the page tells: a line that goes by itself, words for screen readers, and failures. */
import { byId, make } from "./dom";

let noticeTimer = 0;

/** A line over the controls that goes by itself. */
export function notice(text: string, seconds = 7): void {
  const line = byId("notice");
  clearTimeout(noticeTimer);
  line.textContent = text;
  line.hidden = text === "";
  noticeTimer = window.setTimeout(() => (line.hidden = true), seconds * 1000);
}

/** For screen readers. */
export function say(text: string): void {
  byId("status").textContent = text;
}

export interface WayOn {
  label: string;
  go(): void;
}

let failures = 0;

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
  const items = details.slice(0, 12).map((detail) => make("li", {}, detail));
  failure.querySelector("ul")!.replaceChildren(...items);
  const button = failure.querySelector("button")!;
  button.hidden = !wayOn;
  button.textContent = wayOn?.label ?? "";
  const hide = () => {
    failure.hidden = true;
    setInert(false);
  };
  button.onclick = () => {
    hide();
    wayOn?.go();
  };
  failure.hidden = false;
  setInert(true);
  if (wayOn) button.focus();
  return () => {
    if (number === failures) hide();
  };
}

/** Nothing behind a failure can be reached until it is read. */
function setInert(inert: boolean): void {
  document.querySelector("main")!.inert = inert;
}
