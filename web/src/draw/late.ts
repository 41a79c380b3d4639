/**
 * What the overlay draws besides joints and the visitor's pull. The first picture of the page needs
 * none of it, so it is imported when it is first needed.
 */
export { drawLists } from "./debug";
export { drawLabels } from "./labels";
export { drawMarks } from "./marks";
export { drawSums } from "./sums";
