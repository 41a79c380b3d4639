/**
 * The scene that runs when the page is first opened. Code that it does not need is loaded later.
 */
export const FIRST_SCENE = "brick_wall";
