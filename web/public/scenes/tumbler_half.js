// The drum again, half full of circles: they make the load flow like gravel.
import { drumOf } from "./tumbler.js";

export const title = "Tumbler, half of it circles";
export const about = "The same drum with circles and boxes, which flow like gravel.";
export const menu = { group: "In motion", place: 460 };
export const size = { means: "circles and boxes", usual: 2000, least: 1, most: 100000 };

export default function (setting) {
  return drumOf(setting, (world, body, i) => {
    if (i % 2 === 0) world.createCircle(body, { radius: 0.125 });
    else world.createObb(body, { halfWidth: 0.125, halfHeight: 0.125 });
  });
}
