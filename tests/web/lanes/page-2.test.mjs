/** One of the processes that share the files that test the page out among themselves. */
import { runLane } from "../support/lane.mjs";

runLane("page", ["page", "panels"], ["clock.test.mjs"]);
