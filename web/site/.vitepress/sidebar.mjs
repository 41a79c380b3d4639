/** The pages of the site in reading order. A test asks that every page stands here. */
import { cHeaders } from "../../tools/site/c-reference.mjs";

const page = (text, name) => ({ text, link: `/${name}` });

export const sidebar = [
  {
    text: "Begin",
    items: [
      page("In JavaScript", "begin-javascript"),
      page("In C", "begin-c"),
      page("In Python", "begin-python"),
      page("In C++", "binding-cpp"),
      page("In Rust", "binding-rust"),
      page("In LuaJIT", "binding-lua"),
    ],
  },
  {
    text: "Guides",
    items: [
      page("Units and scale", "guide-units"),
      page("Bodies, shapes, ground", "guide-bodies"),
      page("Quality and its price", "guide-quality"),
      page("Error report and max_error", "guide-errors"),
      page("Detection of fast bodies", "guide-detection"),
      page("Events, callbacks, rules", "guide-events"),
      page("Joints", "guide-joints"),
      page("Queries", "guide-queries"),
      page("Characters", "guide-characters"),
      page("Wind, water, explosions", "guide-fields"),
      page("Snapshots and rollback", "guide-snapshots"),
      page("Recordings", "guide-recordings"),
      page("Determinism", "guide-determinism"),
      page("Threads", "guide-threads"),
      page("Drawing", "guide-drawing"),
      page("Levels from Tiled", "guide-levels"),
      page("Speed, memory, requirements", "guide-speed"),
    ],
  },
  {
    text: "Good to know",
    items: [page("Common mistakes", "mistakes"), page("What thud does not do", "limits"), page("Glossary", "glossary")],
  },
  {
    text: "How it works",
    items: [page("Finding collisions", "how-collisions"), page("Resolving them", "how-solver")],
  },
  {
    text: "Coming from",
    items: [
      page("Box2D", "from-box2d"),
      page("Chipmunk", "from-chipmunk"),
      page("Rapier", "from-rapier"),
      page("matter.js", "from-matter"),
      page("planck", "from-planck"),
    ],
  },
  {
    text: "Reference",
    items: [
      page("Errors and what to do", "errors"),
      {
        ...page("C", "reference-c"),
        collapsed: true,
        items: cHeaders().map((header) => page(header.name, header.page)),
      },
      {
        ...page("JavaScript", "reference-js"),
        collapsed: true,
        items: [
          page("World", "js-world"),
          page("Engine, movers, functions", "js-engine"),
          page("Options and results", "js-types"),
          page("thud/geometry", "js-geometry"),
          page("thud/level", "js-level"),
          page("thud/canvas", "js-canvas"),
          page("thud/pixi", "js-pixi"),
          page("thud/three", "js-three"),
          page("thud/phaser", "js-phaser"),
          page("thud/recording", "js-recording"),
        ],
      },
      page("Python", "python-thud"),
    ],
  },
];
