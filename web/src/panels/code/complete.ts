/** Completion of what a scene can use; the language's own names come from its package. */
import { GROUPS } from "virtual:code-names";

/** What of CodeMirror's completion context is used. */
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

function completionsOf(completes: "plain" | "member"): Completion[] {
  const entries = GROUPS.filter((group) => group.completes === completes).flatMap((group) =>
    group.entries.map(({ name, meaning }) => [name, firstSentence(meaning)] as const),
  );
  // Some names stand in two groups; the first tells.
  const named = new Map([...entries].reverse());
  return [...named].map(([label, detail]) => ({ label, detail, type: "property" }));
}

const PLAIN = completionsOf("plain");
const MEMBERS = completionsOf("member");

/** What of the language is prose: Enter after a word there ends a line and takes no name. */
const PROSE = ["LineComment", "BlockComment", "String"];

export function completeNames(context: Asked) {
  if (context.tokenBefore(PROSE)) return null;
  const member = context.matchBefore(/\bworld\.\w*/);
  if (member) return { from: member.from + "world.".length, options: MEMBERS, validFor: /^\w*$/ };
  const word = context.matchBefore(/[\w.]+/);
  if (word ? word.text.includes(".") : !context.explicit) return null;
  return { from: word?.from ?? context.pos, options: PLAIN, validFor: /^\w*$/ };
}
