/** The dock's panels: title of each, and the module that is imported when it is first opened. */
import type { PanelKind } from "../page/dock";
import type { Stage } from "../page/stage";

export function panels(stage: Stage): Record<string, PanelKind> {
  return {
    versus: {
      title: "thud and Box2D",
      load: async () => {
        const { createPanel } = await import("./versus/versus");
        return (app) => createPanel(app, stage);
      },
    },
    inside: {
      title: "Inside",
      load: async () => {
        const { createPanel } = await import("./inside/inside");
        return (app) => createPanel(app, stage);
      },
    },
    trade: {
      title: "Trade: speed against accuracy",
      load: async () => (await import("./trade/trade")).createPanel,
    },
    match: {
      title: "Play together",
      load: async () => (await import("./match/match")).createPanel,
    },
    values: {
      title: "Values",
      load: async () => (await import("./values")).createPanel,
    },
    code: {
      title: "Code",
      load: async () => (await import("./code/code")).createPanel,
    },
    options: {
      title: "Options",
      load: async () => (await import("./options")).createPanel,
    },
  };
}
