/** The panels of the dock, each loaded when it is first opened. */
import type { PanelKind } from "../page/dock";
import type { Stage } from "../page/stage";

export function panels(_stage: Stage): Record<string, PanelKind> {
  return {
    options: {
      title: "Options",
      load: async () => (await import("./options")).createPanel,
    },
  };
}
