/**
 * Completion in the editor of the names that the page gives to a scene. Names of JavaScript itself
 * are completed by CodeMirror's package of the language.
 */
import { GROUPS } from "virtual:code-names";

/** The part of CodeMirror's CompletionContext that is used here. */
interface Asked {
  pos: number;
  explicit: boolean;
  matchBefore(pattern: RegExp): { from: number; text: string } | null;
  tokenBefore(types: readonly string[]): object | null;
}

interface Completion {
  label: string;
  detail: string;
  type: string;
}

function firstSentence(text: string): string {
  return /^.*?[.;](?=\s|$)/.exec(text)?.[0].replace(/;$/, ".") ?? text;
}

/** The names that stand alone ("plain") or follow "world." ("member"). */
function completionsOf(completes: "plain" | "member"): Completion[] {
  const entries = GROUPS.filter((group) => group.completes === completes).flatMap((group) =>
    group.entries.map(({ name, meaning }) => [name, firstSentence(meaning)] as const),
  );
  // A name may be in two groups: the description of the first one is taken.
  const named = new Map([...entries].reverse());
  return [...named].map(([label, detail]) => ({ label, detail, type: "property" }));
}

const PLAIN = completionsOf("plain");
const MEMBERS = completionsOf("member");

/** Syntax nodes that contain prose: in them no names are offered, so that Enter after a word begins
 * a line and accepts no completion. */
const PROSE = ["LineComment", "BlockComment", "String"];

/** A completion source of CodeMirror: the names that fit before the cursor, or null for none. */
export function completeNames(context: Asked) {
  if (context.tokenBefore(PROSE)) return null;
  const member = context.matchBefore(/\bworld\.\w*/);
  if (member) return { from: member.from + "world.".length, options: MEMBERS, validFor: /^\w*$/ };
  const word = context.matchBefore(/[\w.]+/);
  if (word ? word.text.includes(".") : !context.explicit) return null;
  return { from: word?.from ?? context.pos, options: PLAIN, validFor: /^\w*$/ };
}
