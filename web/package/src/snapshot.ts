/**
 * Snapshots: the whole state of a world as bytes, for rewinding, rollback and saved games.
 * thud_snapshot.h says what a snapshot contains, and what is the same after it was restored.
 */
import type { Engine } from "./engine.js";
import { ThudError } from "./error.js";
import { ListAt } from "./generated/slots.js";

/** A snapshot of the world at an address, as a copy outside of wasm memory. */
export function takeSnapshot(engine: Engine, world: number): Uint8Array<ArrayBuffer> {
  engine.check(engine.exports.api_world_snapshot(world));
  const address = engine.slots[ListAt.address];
  const bytes = engine.slots[ListAt.count];
  return new Uint8Array(engine.buffer.slice(address, address + bytes));
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
