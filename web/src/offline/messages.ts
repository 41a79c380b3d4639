/** What the page tells the service worker: to replace the one of the former build now. */
export const TAKE_OVER = "take over";
