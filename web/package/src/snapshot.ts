/**
 * Snapshots: the whole state of a world as bytes, for rewinding, rollback and saved games; and
 * packed ones, which are small. thud_snapshot.h says what a snapshot contains, and what is the same
 * after it was restored; thud_packed.h, how it is packed.
 */
import type { Engine } from "./engine.js";
import { ThudError } from "./error.js";
import { ListAt } from "./generated/slots.js";

/** A copy, outside of wasm memory, of the bytes that a call listed. */
function listedBytes(engine: Engine): Uint8Array<ArrayBuffer> {
  const address = engine.slots[ListAt.address];
  const bytes = engine.slots[ListAt.count];
  return new Uint8Array(engine.buffer, address, bytes).slice();
}

/** A snapshot of the world at an address. */
export function takeSnapshot(engine: Engine, world: number): Uint8Array<ArrayBuffer> {
  engine.check(engine.exports.api_world_snapshot(world));
  return listedBytes(engine);
}

/** Restores the world at an address. Throws as World.restore. */
export function restoreSnapshot(engine: Engine, world: number, bytes: Uint8Array): void {
  if (!(bytes instanceof Uint8Array))
    throw new ThudError("invalid", "restore: a snapshot is a Uint8Array");
  const address = engine.exports.api_snapshot_room(bytes.length + 1);
  if (address === 0) throw new ThudError("memory", "out of memory");
  new Uint8Array(engine.buffer, address, bytes.length).set(bytes);
  engine.check(engine.exports.api_world_restore(world, bytes.length));
}

/** The buffers of api_packed.c that are written here. */
const BASE = 0;
const GIVEN = 1;

/** Copies bytes to a buffer of api_packed.c. */
function lend(engine: Engine, which: number, bytes: Uint8Array): void {
  const address = engine.exports.api_packed_room(which, bytes.length + 1);
  if (address === 0) throw new ThudError("memory", "out of memory");
  new Uint8Array(engine.buffer, address, bytes.length).set(bytes);
}

/** Packs or unpacks, as the export of this name does. Throws as World.pack and World.unpack. */
export function repack(
  engine: Engine,
  world: number,
  call: "api_world_pack" | "api_world_unpack",
  bytes: Uint8Array,
  base: Uint8Array | undefined,
): Uint8Array<ArrayBuffer> {
  if (!(bytes instanceof Uint8Array))
    throw new ThudError("invalid", "pack or unpack: a snapshot is a Uint8Array");
  if (base !== undefined && !(base instanceof Uint8Array && base.length > 0))
    throw new ThudError("invalid", "pack or unpack: a base is a Uint8Array that is not empty");
  if (base) lend(engine, BASE, base);
  lend(engine, GIVEN, bytes);
  engine.check(engine.exports[call](world, base ? base.length : 0, bytes.length));
  return listedBytes(engine);
}
