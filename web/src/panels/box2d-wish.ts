/** What the panels ask of the worker about Box2D beside the scene. */
import type { App } from "../page/app";
import { EndedError } from "../page/client";
import { notice } from "../page/messages";
import { messageOf } from "../shared/error";

/** It begins with the next step; what is chosen since goes to one that runs. */
export function askForBox2D({ client, state }: App): Promise<void> {
  return client.ask("box2d", { substeps: state.versus.substeps });
}

export function endBox2D({ client }: App): void {
  client.ask("box2d", null).catch((error) => {
    // With its worker Box2D has ended too.
    if (!(error instanceof EndedError)) notice(`Box2D did not end well: ${messageOf(error)}`);
  });
}
