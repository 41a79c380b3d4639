/** Mouse, touch and wheel on the canvas: pull, spawn or dig with one pointer, pan, zoom and pinch. */
import type { Camera } from "./camera";

export type Tool = "hand" | "circle" | "box" | "dig";

export interface InputActions {
  tool(): Tool;
  /** True if there is a body to pull. */
  grab(x: number, y: number, reach: number): boolean;
  moveGrab(x: number, y: number): void;
  release(): void;
  /** What another tool than the hand does, at the pointer and then along its way. */
  apply(tool: Exclude<Tool, "hand">, x: number, y: number): void;
}

/** How near to a body a pointer must come, in CSS pixels. */
const REACH = { mouse: 4, touch: 18 };
/** While a pointer with a tool moves: pixels from one new body to the next, from crater to crater. */
const APPLY_EVERY = { circle: 30, box: 30, dig: 10 };

interface Pointer {
  x: number;
  y: number;
}

export function listen(canvas: HTMLElement, camera: Camera, actions: InputActions): void {
  const pointers = new Map<number, Pointer>();
  let mode: "none" | "pull" | "pan" | "apply" | "pinch" = "none";
  let lastApplied: Pointer = { x: 0, y: 0 };

  const place = (event: MouseEvent): Pointer => {
    const box = canvas.getBoundingClientRect();
    return { x: event.clientX - box.left, y: event.clientY - box.top };
  };
  const applyAt = (at: Pointer, least: number) => {
    const tool = actions.tool();
    if (tool === "hand") return;
    if (Math.hypot(at.x - lastApplied.x, at.y - lastApplied.y) < least * APPLY_EVERY[tool]) return;
    actions.apply(tool, ...camera.toWorld(at.x, at.y));
    lastApplied = at;
  };

  canvas.addEventListener("pointerdown", (event) => {
    const at = place(event);
    pointers.set(event.pointerId, at);
    canvas.setPointerCapture(event.pointerId);
    if (pointers.size === 2) {
      actions.release();
      mode = "pinch";
      return;
    }
    if (pointers.size > 2) return;
    const reach = (event.pointerType === "mouse" ? REACH.mouse : REACH.touch) / camera.scale;
    if (event.button !== 0 || event.shiftKey) mode = "pan";
    else if (actions.tool() !== "hand") {
      mode = "apply";
      applyAt(at, 0);
    } else mode = actions.grab(...camera.toWorld(at.x, at.y), reach) ? "pull" : "pan";
    canvas.dataset.mode = mode;
  });

  canvas.addEventListener("pointermove", (event) => {
    const last = pointers.get(event.pointerId);
    if (!last) return;
    const at = place(event);
    if (mode === "pinch") pinch(camera, [...pointers.values()], last, at);
    pointers.set(event.pointerId, at);
    if (mode === "pull") actions.moveGrab(...camera.toWorld(at.x, at.y));
    else if (mode === "pan") camera.pan(at.x - last.x, at.y - last.y);
    else if (mode === "apply") applyAt(at, 1);
  });

  const end = (event: PointerEvent) => {
    if (!pointers.delete(event.pointerId)) return;
    if (mode === "pull") actions.release();
    // After a pinch the finger that stays moves the view.
    mode = pointers.size === 1 ? "pan" : "none";
    canvas.dataset.mode = mode;
  };
  canvas.addEventListener("pointerup", end);
  canvas.addEventListener("pointercancel", end);
  canvas.addEventListener("contextmenu", (event) => event.preventDefault());
  canvas.addEventListener(
    "wheel",
    (event) => {
      event.preventDefault();
      const at = place(event);
      const lines = event.deltaMode === 0 ? event.deltaY : 30 * event.deltaY;
      camera.zoom(Math.exp(-lines * (event.ctrlKey ? 0.01 : 0.0015)), at.x, at.y);
    },
    { passive: false },
  );
}

/** Two fingers: what was between them stays between them. */
function pinch(camera: Camera, pointers: Pointer[], last: Pointer, at: Pointer): void {
  const other = pointers.find((pointer) => pointer !== last);
  if (!other) return;
  const before = Math.hypot(last.x - other.x, last.y - other.y);
  const after = Math.hypot(at.x - other.x, at.y - other.y);
  camera.pan((at.x - last.x) / 2, (at.y - last.y) / 2);
  if (before > 1 && after > 1)
    camera.zoom(after / before, (at.x + other.x) / 2, (at.y + other.y) / 2);
}
