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
        text: "JavaScript",
        collapsed: true,
        items: [
          page("World", "js-world"),
          page("Engine, movers, functions", "js-engine"),
          page("Options and results", "js-types"),
          page("thud/geometry", "js-geometry"),
          page("thud/level", "js-level"),
        ],
      },
      page("Python", "python-thud"),
    ],
  },
];
