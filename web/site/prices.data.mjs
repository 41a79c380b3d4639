/** What docs/tradeoff/tradeoff.json measured, for the tables of the pages. */
import { readFileSync } from "node:fs";
import { fileURLToPath } from "node:url";

const FILE = fileURLToPath(new URL("../../docs/tradeoff/tradeoff.json", import.meta.url));

/** The settings that are shown: thud's qualities, and Box2D at so many substeps, also at its stiffest. */
const SHOWN = ["draft", "default", "high", "exact", "default swept", "Box2D 4", "Box2D 8 stiff", "Box2D 16 stiff"];

export default {
  watch: [FILE],
  load() {
    const { about, cases } = JSON.parse(readFileSync(FILE, "utf8"));
    const few = (value) => (value >= 100 ? Math.round(value).toLocaleString("en") : String(Number(value.toPrecision(2))));
    return {
      about: { commit: about.commit, date: about.date.slice(0, 10), processor: about.processor },
      cases: cases.map(({ case: name, title, about: words, error, unit, floor, points }) => ({
        name,
        title,
        words,
        error,
        unit,
        points: points
          .map((point) => ({ ...point, setting: point.engine === "box2d" ? `Box2D ${point.setting}` : point.setting }))
          .filter(({ setting }) => SHOWN.includes(setting))
          .map((point) => ({
            setting: point.setting,
            error: point.error <= floor ? "none" : few(point.error),
            microseconds: few(1000 * point.ms_mean),
          })),
      })),
    };
  },
};
