/** Runs a third of the files that test the page. */
import { runLane } from "../support/lane.mjs";

runLane(1);
