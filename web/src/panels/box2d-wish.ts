/** Starts and ends Box2D in the worker beside the scene, for the panels Versus and Trade. */
import type { App } from "../page/app";
import { EndedError } from "../page/client";
import { notice } from "../page/messages";
import { messageOf } from "../shared/error";

/** Box2D begins with the next step, with the chosen substeps; one that runs already takes over the
 * substeps. Rejects if Box2D cannot be loaded. */
export function askForBox2D({ client, state }: App): Promise<void> {
  return client.ask("box2d", { substeps: state.versus.substeps });
}

/** Ends Box2D, for the scene that runs and those that follow. */
export function endBox2D({ client }: App): void {
  client.ask("box2d", null).catch((error) => {
    // Where the worker has been terminated, Box2D has ended with it.
    if (!(error instanceof EndedError)) notice(`Box2D did not end well: ${messageOf(error)}`);
  });
}
