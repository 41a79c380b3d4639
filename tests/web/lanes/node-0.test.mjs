/** One of the processes that share the files that test without a page out among themselves. */
import { runLane } from "../support/lane.mjs";

runLane("node", ["package", "rules", "games", "worker"]);
