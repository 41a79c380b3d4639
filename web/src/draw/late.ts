/** What the overlay draws only where there is some: none of it is in the page's first picture. */
export { drawLists } from "./debug";
export { drawLabels } from "./labels";
export { drawMarks } from "./marks";
export { drawSums } from "./sums";
