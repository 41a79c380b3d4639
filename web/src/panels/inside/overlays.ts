/** The part Overlays of the panel Inside: a check box for each overlay, with a description and a
 * key of its colours. */
import { DARK, LIGHT, type Theme } from "../../draw/palette";
import type { App } from "../../page/app";
import { make } from "../../page/dom";
import type { Stage } from "../../page/stage";
import { isDark, onTheme } from "../../page/theme";
import type { OverlayName } from "../../scene/overlays";

/** The texts of an overlay. */
interface Text {
  name: OverlayName;
  title: string;
  about: string;
  /** The key: each colour, and what has it in the scene. */
  key?: readonly (readonly [colour: (theme: Theme) => string, meaning: string])[];
}

/** The colour of a style of the engine's debug drawing. */
const style = (name: string) => (theme: Theme) => theme.styles[name];

/** All overlays, in the order of the stages of a step that they show. */
const GROUPS: readonly { title: string; overlays: readonly Text[] }[] = [
  {
    title: "Finding pairs",
    overlays: [
      {
        name: "bounds",
        title: "Bounds",
        about: "The upright box around each shape.",
        key: [[style("bounds"), "bounds"]],
      },
      {
        name: "cells",
        title: "Grid cells",
        about: "Cells of the grid that hold a body (with the broadphase grid).",
        key: [[style("cell"), "cell"]],
      },
      {
        name: "axes",
        title: "Sweep axis",
        about: "Bounds as intervals sorted along x, at the lower edge (with the broadphase sweep).",
        key: [
          [style("interval"), "alone"],
          [style("interval overlapping"), "overlapping"],
        ],
      },
      {
        name: "pairs",
        title: "Pairs",
        about: "A line between the centres of shapes whose bounds overlap.",
        key: [
          [style("pair"), "apart"],
          [style("pair touching"), "touching"],
        ],
      },
      {
        name: "stages",
        title: "Pairs by stage",
        about: "How far each pair came: the broadphase's wide bounds, true bounds, the exact test.",
        key: [
          [style("pair candidate"), "candidate"],
          [style("pair"), "bounds overlap"],
          [style("pair touching"), "shapes touch"],
        ],
      },
      {
        name: "sums",
        title: "Minkowski sums",
        about: "Of the body that you point at and its nearest neighbour: a shape and a point.",
        key: [
          [(theme) => theme.sum, "point outside: apart"],
          [(theme) => theme.sumOverlapping, "inside: they overlap"],
        ],
      },
    ],
  },
  {
    title: "Contacts and their solution",
    overlays: [
      {
        name: "contacts",
        title: "Contact points",
        about: "Where shapes touch, one or two points a pair.",
        key: [[style("contact"), "point"]],
      },
      {
        name: "normals",
        title: "Normals",
        about: "The direction in which a contact pushes.",
        key: [[style("normal"), "normal"]],
      },
      {
        name: "impulses",
        title: "Depths and impulses",
        about: "How deep each point is, and how hard the step pushed there.",
        key: [
          [style("depth"), "depth"],
          [style("impulse"), "impulse"],
        ],
      },
      {
        name: "joints",
        title: "Joints",
        about:
          "Axes, limits and forces, of which the largest is the longest; a ring where one is open by " +
          "more than a hundredth of a body.",
        key: [
          [style("joint axis"), "axis"],
          [style("joint limit"), "limit"],
          [(theme) => theme.joints.force, "force"],
          [(theme) => theme.joints.open, "open"],
        ],
      },
      {
        name: "islands",
        title: "Islands",
        about: "Bodies that are joined by contacts or joints have one colour.",
        key: [[style("solved directly"), "solved directly"]],
      },
      {
        name: "colours",
        title: "Solver colours",
        about: "Contacts of one colour share no moving body: eight are solved at once.",
      },
    ],
  },
  {
    title: "Motion and rest",
    overlays: [
      {
        name: "motions",
        title: "Swept volumes",
        about: "The area that a fast body passed over in the step.",
        key: [[style("motion"), "start to end of the step"]],
      },
      {
        name: "sleeping",
        title: "Sleep",
        about: "Bodies that sleep are dimmed: until touched, they cost next to nothing.",
      },
    ],
  },
];

/** Builds the part; its boxes set the stage's overlays and follow them. */
export function overlaysPart(app: App, stage: Stage): HTMLElement {
  const inputs = new Map<OverlayName, HTMLInputElement>();
  const swatches: { element: HTMLElement; colour: (theme: Theme) => string }[] = [];

  const keyOf = ([colour, meaning]: NonNullable<Text["key"]>[number]) => {
    const element = make("i", { "aria-hidden": "true" });
    swatches.push({ element, colour });
    return make("span", {}, element, meaning);
  };
  const rowOf = ({ name, title, about, key = [] }: Text) => {
    const input = make("input", {
      type: "checkbox",
      name: `overlay-${name}`,
      "aria-labelledby": `overlay-${name}-title`,
      "aria-describedby": `overlay-${name}-about`,
    });
    input.addEventListener("change", () => stage.setOverlay(name, input.checked));
    inputs.set(name, input);
    const text = make(
      "span",
      {},
      make("b", { id: `overlay-${name}-title` }, title),
      make("small", { id: `overlay-${name}-about` }, about),
    );
    if (key.length > 0) text.append(make("small", { class: "key" }, ...key.map(keyOf)));
    return make("label", {}, input, text);
  };
  const element = make(
    "div",
    { class: "overlays" },
    ...GROUPS.map(({ title, overlays }) =>
      make("fieldset", {}, make("legend", {}, title), ...overlays.map(rowOf)),
    ),
  );

  const mark = () => {
    for (const [name, input] of inputs) input.checked = stage.view.shown.has(name);
  };
  const paint = (dark: boolean) => {
    for (const { element: swatch, colour } of swatches)
      swatch.style.background = colour(dark ? DARK : LIGHT);
  };
  app.listen({ state: mark, run: mark });
  onTheme(paint);
  mark();
  paint(isDark());
  return element;
}
