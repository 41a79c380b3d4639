/** The scene that is there when the page is first opened: what it does without comes later. */
export const FIRST_SCENE = "brick_wall";
