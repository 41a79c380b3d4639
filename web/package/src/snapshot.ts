/**
 * A world's whole state as bytes: for rewinding, for networked play that predicts and corrects, for
 * saved games. What a snapshot holds, and what restoring promises, stands in thud_snapshot.h.
 */
import type { Engine } from "./engine.js";
import { ThudError } from "./error.js";
import { ListAt } from "./generated/slots.js";

/** A copy of its own, outside wasm memory. */
export function takeSnapshot(engine: Engine, world: number): Uint8Array<ArrayBuffer> {
  engine.check(engine.exports.api_world_snapshot(world));
  const address = engine.slots[ListAt.address];
  const bytes = engine.slots[ListAt.count];
  return new Uint8Array(engine.buffer.slice(address, address + bytes));
}

export function restoreSnapshot(engine: Engine, world: number, bytes: Uint8Array): void {
  if (!(bytes instanceof Uint8Array))
    throw new ThudError("invalid", "restore: a snapshot is a Uint8Array");
  const address = engine.exports.api_snapshot_room(bytes.length + 1);
  if (address === 0) throw new ThudError("memory", "out of memory");
  new Uint8Array(engine.buffer, address, bytes.length).set(bytes);
  engine.check(engine.exports.api_world_restore(world, bytes.length));
}
