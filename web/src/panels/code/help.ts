/** The folded help below the editor: a list of what a scene can use, with an example of each. */
import { GROUPS } from "virtual:code-names";
import { make } from "../../page/dom";

/** The form of every scene's module. */
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
      ...entries.map(({ form, meaning }) =>
        make("div", {}, make("dt", {}, make("code", {}, form)), make("dd", {}, meaning)),
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
