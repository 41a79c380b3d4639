/**
 * Mouse, touch and wheel on the scene's canvas. One pointer uses the chosen tool (pull, add,
 * explode, dig) or pans the view; two fingers or the wheel zoom it.
 */
import type { Camera, Pane } from "../../draw/camera";

/** The tools: the hand pulls bodies, the others add bodies, explode and dig. */
export const TOOLS = ["hand", "circle", "box", "blast", "dig"] as const;
export type Tool = (typeof TOOLS)[number];

/** What pointers do. Places x, y and distances are in world units. */
export interface PointerActions {
  tool(): Tool;
  /** True if the scene uses the pointer itself, so that it pulls no bodies. */
  taken(): boolean;
  /** Tells the scene where its pointer is, and whether it is pressed. */
  point(x: number, y: number, down: boolean): void;
  /** Takes hold of a body within `reach` of a place in a pane; false if there is none. */
  grab(x: number, y: number, reach: number, pane: Pane["index"]): boolean;
  drag(x: number, y: number): void;
  release(): void;
  /** Uses another tool than the hand: at the press, and again along the pointer's path. */
  apply(tool: Exclude<Tool, "hand">, x: number, y: number): void;
  /** A mouse moves over the scene, or leaves it (null). screenX, screenY: CSS pixels. */
  hover(at: { x: number; y: number; screenX: number; screenY: number } | null): void;
  /** A press was released without having moved; a body within `reach` counts as hit. */
  tap(x: number, y: number, reach: number): void;
  /** The visitor has moved the view. */
  moved(): void;
}

/** CSS pixels from a body within which a pointer hits it. Chosen: fingers are less exact. */
const REACH = { mouse: 4, touch: 18 };
/** CSS pixels that a press may move and still counts as a tap. Chosen. */
const TAP = 5;
/** CSS pixels that a pointer with a tool moves from one command to the next. Chosen. */
const APPLY_EVERY = { circle: 30, box: 30, blast: 90, dig: 10 };

/** A place on the canvas in CSS pixels. */
interface Pointer {
  x: number;
  y: number;
}

/** Listens to the canvas's pointer and wheel events; moves the camera and calls the actions. */
export function listenToPointers(
  canvas: HTMLElement,
  camera: Camera,
  actions: PointerActions,
): void {
  /** The pressed pointers by their ids, where they last were. */
  const pointers = new Map<number, Pointer>();
  /** What the pressed pointers do. */
  let mode: "none" | "pull" | "pan" | "apply" | "pinch" | "scene" = "none";
  let lastApplied: Pointer = { x: 0, y: 0 };
  let pressedAt: Pointer = { x: 0, y: 0 };
  /** While pressed: the pane in which the press began. Its coordinates hold beyond its edge too. */
  let pane: Pane["index"] | null = null;

  const place = (event: MouseEvent): Pointer => {
    const box = canvas.getBoundingClientRect();
    return { x: event.clientX - box.left, y: event.clientY - box.top };
  };
  const inWorld = (at: Pointer) =>
    camera.toWorld(at.x, at.y, pane === null ? undefined : camera.panes[pane]);
  /** Uses the tool if the pointer is at least `part` of APPLY_EVERY from where it was used last. */
  const applyAt = (at: Pointer, part: number) => {
    const tool = actions.tool();
    if (tool === "hand") return;
    const way = Math.hypot(at.x - lastApplied.x, at.y - lastApplied.y);
    if (way < part * APPLY_EVERY[tool]) return;
    actions.apply(tool, ...inWorld(at));
    lastApplied = at;
  };
  const reachOf = ({ pointerType }: PointerEvent) =>
    (pointerType === "mouse" ? REACH.mouse : REACH.touch) / camera.scale;
  /** A first pointer is pressed: starts what it does, and returns the mode. */
  const begin = (event: PointerEvent, at: Pointer): typeof mode => {
    if (event.button !== 0 || event.shiftKey) return "pan";
    const [x, y] = inWorld(at);
    if (actions.taken()) {
      actions.point(x, y, true);
      return "scene";
    }
    if (actions.tool() !== "hand") {
      applyAt(at, 0);
      return "apply";
    }
    return actions.grab(x, y, reachOf(event), pane ?? 0) ? "pull" : "pan";
  };

  canvas.addEventListener("pointerdown", (event) => {
    const at = place(event);
    pointers.set(event.pointerId, at);
    canvas.setPointerCapture(event.pointerId);
    if (pointers.size === 2) {
      if (mode === "pull") actions.release();
      if (mode === "scene") actions.point(...inWorld(at), false);
      mode = "pinch";
    } else if (pointers.size === 1) {
      pane = camera.paneAt(at.x, at.y).index;
      mode = begin(event, at);
      pressedAt = at;
    }
    canvas.dataset.mode = mode;
  });

  canvas.addEventListener("pointermove", (event) => {
    const at = place(event);
    const last = pointers.get(event.pointerId);
    const [x, y] = inWorld(at);
    if (!last) {
      if (event.pointerType !== "mouse") return;
      actions.hover({ x, y, screenX: at.x, screenY: at.y });
      if (actions.taken()) actions.point(x, y, false);
      return;
    }
    if (mode === "pinch") {
      pinch(camera, [...pointers.values()], last, at);
      actions.moved();
    }
    pointers.set(event.pointerId, at);
    if (mode === "pull") actions.drag(x, y);
    else if (mode === "scene") actions.point(x, y, true);
    else if (mode === "apply") applyAt(at, 1);
    else if (mode === "pan") {
      camera.pan(at.x - last.x, at.y - last.y);
      actions.moved();
    }
  });

  const end = (event: PointerEvent) => {
    const at = pointers.get(event.pointerId);
    if (!at) return;
    pointers.delete(event.pointerId);
    if (mode === "pull") actions.release();
    if (mode === "scene") actions.point(...inWorld(at), false);
    const last = place(event);
    const onTheSpot = Math.hypot(last.x - pressedAt.x, last.y - pressedAt.y) < TAP;
    if (onTheSpot && event.type === "pointerup" && (mode === "pull" || mode === "pan"))
      actions.tap(...inWorld(last), reachOf(event));
    // After a pinch the finger that is still down moves the view.
    mode = pointers.size === 1 ? "pan" : "none";
    if (pointers.size === 0) pane = null;
    canvas.dataset.mode = mode;
  };
  canvas.addEventListener("pointerup", end);
  canvas.addEventListener("pointercancel", end);
  canvas.addEventListener("pointerleave", () => actions.hover(null));
  canvas.addEventListener("contextmenu", (event) => event.preventDefault());
  canvas.addEventListener(
    "wheel",
    (event) => {
      event.preventDefault();
      const at = place(event);
      // In pixels: a wheel that counts lines or pages moves 30 pixels for each. Zoom rates per
      // pixel are chosen; browsers report a pinch on a touchpad as a wheel with ctrlKey.
      const lines = event.deltaMode === 0 ? event.deltaY : 30 * event.deltaY;
      camera.zoom(Math.exp(-lines * (event.ctrlKey ? 0.01 : 0.0015)), at.x, at.y);
      actions.moved();
    },
    { passive: false },
  );
}

/** One of two fingers moves from `last` to `at`: pans and zooms so that the part of the world
 * between the fingers stays between them. */
function pinch(camera: Camera, pointers: Pointer[], last: Pointer, at: Pointer): void {
  const other = pointers.find((pointer) => pointer !== last);
  if (!other) return;
  const before = Math.hypot(last.x - other.x, last.y - other.y);
  const after = Math.hypot(at.x - other.x, at.y - other.y);
  camera.pan((at.x - last.x) / 2, (at.y - last.y) / 2);
  if (before > 1 && after > 1)
    camera.zoom(after / before, (at.x + other.x) / 2, (at.y + other.y) / 2);
}
