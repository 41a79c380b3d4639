/** The message from the page to a waiting service worker: replace that of the former build now. */
export const TAKE_OVER = "take over";
