/** The list beside the code of what a scene can use, with an example of each. */
import { make } from "../../page/dom";
import { GROUPS } from "./names";

const FORM = `export default function ({ createWorld }) {
  const world = createWorld();
  …
  return { world };
}`;

export function createHelp(): HTMLElement {
  const groups = GROUPS.flatMap(({ title, entries }) => [
    make("h3", {}, title),
    make(
      "dl",
      {},
      ...Object.values(entries).map(([example, meaning]) =>
        make("div", {}, make("dt", {}, make("code", {}, example)), make("dd", {}, meaning)),
      ),
    ),
  ]);
  return make(
    "details",
    { class: "code-help" },
    make("summary", {}, "What a scene can use"),
    make(
      "p",
      {},
      "A scene is a JavaScript module. Its default function builds a world and returns it:",
    ),
    make(
      "pre",
      {},
      make("code", {}, FORM),
    ),
    ...groups,
  );
}
