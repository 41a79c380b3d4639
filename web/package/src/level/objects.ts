/**
 * Reads the objects of a Tiled map: each becomes a body, a joint, or the spawn point. The same
 * arithmetic as demo/level/objects.c.
 */
import type { JointKind } from "../joint-types.js";
import type { Layer, Reader } from "../level.js";
import { DEGREES, FAR, type Form, turn } from "./form.js";
import { addBody, placeFits, readForms, settleForms, TOO_FAR, TOO_MANY, turnForm } from "./forms.js";
import { jointKind } from "./joint-names.js";
import { readJoint } from "./joints.js";
import { findTile, listTilesets, readTileForms, type Tileset } from "./tilesets.js";
import {
  isRecord,
  type Json,
  type JsonRecord,
  type Physics,
  readPhysics,
  Values,
} from "./values.js";
import type { Vec2 } from "../types.js";

/** An object together with its template. */
interface Thing {
  /** The fields of the object, and those of its template that it does not have. */
  json: JsonRecord;
  /** The objects with its properties: the template, then the object itself. */
  links: JsonRecord[];
  /** The tilesets in which its tile number is looked up. */
  tilesets: Tileset[];
}

/** Reads all objects of a layer. */
export function readObjects(reader: Reader, layer: Layer): void {
  const { objects } = layer.json;
  const { report } = reader;
  if (!Array.isArray(objects)) {
    report.add("skip", 0, `layer '${layer.name}': has no list of objects`);
    return;
  }
  let unmarked = 0;
  for (const object of objects)
    if (readObject(reader, layer, isRecord(object) ? object : {})) unmarked++;
  reader.unmarked += unmarked;
  const what = `of ${unmarked} tile objects nothing says that they are solid`;
  if (unmarked > 0) report.add("note", 0, `layer '${layer.name}': ${what}`);
}

/** Reads one object. True where it is a tile of which nothing says whether it collides. */
function readObject(reader: Reader, layer: Layer, object: JsonRecord): boolean {
  const { id } = object;
  const { report } = reader;
  if (typeof id !== "number" || !(id >= 1 && id <= 0xffffffff)) {
    report.add("skip", 0, `layer '${layer.name}': an object has no valid id`);
    return false;
  }
  const plain = new Values(report, [...layer.chain, object], Math.floor(id), "");
  const thing = resolve(reader, plain, object);
  if (!thing) {
    report.noteUnknown(object, plain.object, "", "any");
    return false;
  }
  const { json, links } = thing;
  const v = plain.within([...layer.chain, ...links]);
  const joint = jointOf(v, json);
  countClass(reader, json);
  report.noteUnknown(object, plain.object, "", joint);
  const what = json.text !== undefined ? "a text" : json.capsule !== undefined ? "a capsule" : null;
  if (what) {
    v.complain("skip", `${what} cannot be modelled`);
    return false;
  }
  const x = layer.ox + v.required(json, "x", -FAR, FAR);
  const y = layer.oy + v.required(json, "y", -FAR, FAR);
  const degrees = v.optional(json, "rotation", 0, -DEGREES, DEGREES);
  if (v.bad) return false;
  if (joint) {
    readJoint(reader, v, json, joint, x, y, degrees);
    return false;
  }
  if (jointKind(classOf(json)))
    v.complain("note", "without a or b it is no joint, but what it is drawn as");
  if (json.gid !== undefined) return addTile(reader, layer, v, thing, x, y, degrees);
  if (json.point === true) readPoint(reader, v, json, x, y);
  else addShape(reader, v, json, x, y, degrees);
  return false;
}

/** The object together with its template, if it has one; null, with a problem in the report. */
function resolve(reader: Reader, v: Values, object: JsonRecord): Thing | null {
  if (object.template === undefined)
    return { json: object, links: [object], tilesets: reader.tilesets };
  const file = reader.library.open(reader.report, "", object.template, "template");
  const own = file?.json.object;
  if (!file || !isRecord(own) || own.template !== undefined) {
    const what = file ? "has no object of its own" : "cannot be used";
    v.complain("skip", `its template ${what}`);
    return null;
  }
  // A tile number in the template belongs to the template's tileset.
  const tilesets =
    object.gid === undefined ? listTilesets([file.json.tileset], file.path) : reader.tilesets;
  return { json: { ...own, ...object }, links: [own, object], tilesets };
}

/** The class of an object: the field `type`, or `class` in files of Tiled 1.9. */
function classOf(object: JsonRecord): Json {
  return typeof object.type === "string" ? object.type : object.class;
}

/**
 * Counts the class of an object that has no meaning here. Points are left out: they are reported.
 */
function countClass({ level }: Reader, object: JsonRecord): void {
  const name = classOf(object);
  if (typeof name !== "string" || name === "" || object.point === true || jointKind(name)) return;
  level.classes[name] = (Object.hasOwn(level.classes, name) ? level.classes[name] : 0) + 1;
}

/**
 * The kind of joint of an object, or null. An object with the class of a joint is one only if it is
 * a point or has a property `a` or `b`, since shapes may have a class such as "wheel", too.
 */
function jointOf(v: Values, object: JsonRecord): JointKind | null {
  const refers = v.find("a") !== undefined || v.find("b") !== undefined;
  return refers || object.point === true ? jointKind(classOf(object)) : null;
}

/** Reads a point: the spawn point, or a note that it has no meaning. */
function readPoint(reader: Reader, v: Values, object: JsonRecord, x: number, y: number): void {
  const { pixelsPerUnit: ppu, mapHeight, level } = reader;
  const place: Vec2 = [x / ppu, (mapHeight - y) / ppu];
  if (classOf(object) !== "spawn")
    v.complain("note", "a point has no meaning here, unless its class is 'spawn'");
  else if (!placeFits(reader, place)) v.complain("skip", `its place is ${TOO_FAR}`);
  else level.spawn = place;
}

/**
 * How far below `y`, pixels, the lower side of a ground polygon must be: in the map's last row of
 * tiles or lower, so that the solid part below its line hides no free space of the map.
 */
function lowestBelow({ mapHeight, tileHeight }: Reader, y: number): number {
  return mapHeight - tileHeight - y;
}

/** Adds the bodies of an object's forms, or reports why not. */
function addForms(
  reader: Reader,
  v: Values,
  physics: Physics,
  forms: readonly Form[],
  x: number,
  y: number,
  degrees: number,
): void {
  const left = addBody(reader, physics, v.object, forms, true, x, y, degrees);
  if (left) v.complain("skip", left === "far" ? `its place is ${TOO_FAR}` : TOO_MANY);
}

/** Adds the body of an object with an outline of its own. */
function addShape(
  reader: Reader,
  v: Values,
  object: JsonRecord,
  x: number,
  y: number,
  degrees: number,
): void {
  const forms = readForms(v, object);
  if (!forms) return;
  const physics = readPhysics(v);
  if (v.bad) return;
  const { material, approximate } = physics;
  for (const f of forms) Object.assign(f, { material, approximate });
  const [first] = forms;
  if (forms.length === 1 && !first.points) {
    turnForm(first, x, y, degrees);
    ({ x, y, rotation: degrees } = first);
    first.x = first.y = first.rotation = 0;
  }
  const settled = settleForms(reader, v, physics, forms, degrees, lowestBelow(reader, y));
  addForms(reader, v, physics, settled, x, y, degrees);
}

/** Adds the body of a tile object. True where nothing says whether the tile collides. */
function addTile(
  reader: Reader,
  layer: Layer,
  v: Values,
  { json, links, tilesets }: Thing,
  x: number,
  y: number,
  degrees: number,
): boolean {
  const gid = Math.floor(v.required(json, "gid", 1, 0xffffffff));
  const tile = findTile(reader, tilesets, gid);
  if (v.bad) return false;
  if (!tile) {
    v.complain("skip", "its tile is of no tileset that can be used");
    return false;
  }
  const inner = tile.json ? [tile.tileset, tile.json] : [tile.tileset];
  const outer = layer.chain.length + inner.length;
  const width = v.optional(json, "width", 0, 0, FAR) || tile.width;
  const height = v.optional(json, "height", 0, 0, FAR) || tile.height;
  if (v.bad) return false;
  const ofTile = v.within([...layer.chain, ...inner, ...links]);
  const { solid, physics, forms } = readTileForms(reader, ofTile, tile, gid, width, height, outer);
  if (physics && forms.length > 0) {
    const { c, s } = turn(degrees);
    const dx = (0.5 - tile.anchorX) * width + tile.offsetX * (width / tile.width);
    const dy = (0.5 - tile.anchorY) * height + tile.offsetY * (height / tile.height);
    const [cx, cy] = [x + (c * dx - s * dy), y + (s * dx + c * dy)];
    const settled = settleForms(reader, ofTile, physics, forms, degrees, lowestBelow(reader, cy));
    addForms(reader, v, physics, settled, cx, cy, degrees);
  }
  return solid === "unmarked";
}
