/** Cells in base64, packed by zlib, gzip or Zstandard. Follows demo/level/unpack.c. */

/** Zstandard's own bound on how far back a frame may refer: 2 to the power of it. */
const LARGEST_WINDOW = 27;

/**
 * Unpacks base64, then by `compression`, to exactly `size` bytes, or tells why not. Unpacks no
 * more, whatever the data claims.
 */
export async function unpack(
  text: string,
  compression: string,
  size: number,
): Promise<Uint8Array | string> {
  let bytes: Uint8Array<ArrayBuffer>;
  try {
    bytes = Uint8Array.from(atob(text), (letter) => letter.charCodeAt(0));
  } catch {
    return "are not in base64";
  }
  let whole: Uint8Array | null = null;
  try {
    if (compression === "") whole = bytes.length === size ? bytes : null;
    else if (compression === "zlib") whole = await inflate(bytes, "deflate", size);
    else if (compression === "gzip") whole = await inflate(bytes, "gzip", size);
    else if (compression === "zstd") {
      const { Decompress } = await import("fzstd").catch(() => ({ Decompress: null }));
      if (!Decompress) return "need the package fzstd";
      whole = unpackZstd(Decompress, bytes, size);
    } else return "are packed in a way that is not known";
  } catch {
    // Damaged: the same as not enough.
  }
  return whole ?? "do not unpack to as many as it has columns and rows";
}

async function inflate(
  bytes: Uint8Array<ArrayBuffer>,
  format: "deflate" | "gzip",
  size: number,
): Promise<Uint8Array | null> {
  const stream = new Blob([bytes]).stream().pipeThrough(new DecompressionStream(format));
  const reader = stream.getReader();
  const out = new Out(size);
  for (;;) {
    const { done, value } = await reader.read();
    if (done) return out.whole;
    if (out.add(value)) continue;
    await reader.cancel();
    return null;
  }
}

/** Bytes of a known number. */
class Out {
  readonly bytes: Uint8Array;
  #used = 0;

  constructor(size: number) {
    this.bytes = new Uint8Array(size);
  }

  /** False if there are too many. */
  add(more: Uint8Array): boolean {
    if (this.#used + more.length > this.bytes.length) return false;
    this.bytes.set(more, this.#used);
    this.#used += more.length;
    return true;
  }

  get whole(): Uint8Array | null {
    return this.#used === this.bytes.length ? this.bytes : null;
  }
}

function unpackZstd(
  Decompress: typeof import("fzstd").Decompress,
  bytes: Uint8Array,
  size: number,
): Uint8Array | null {
  // The window is allocated before anything else is looked at: a frame of one segment says its
  // size, others the window's exponent less ten.
  const oneSegment = (bytes[4] & 0x20) !== 0;
  if (!oneSegment && 10 + (bytes[5] >> 3) > LARGEST_WINDOW) return null;
  if (oneSegment && !claims(bytes, size)) return null;
  const out = new Out(size);
  let fits = true;
  const stream = new Decompress((more) => {
    fits &&= out.add(more);
    if (!fits) throw new RangeError("too many");
  });
  stream.push(bytes, true);
  return fits ? out.whole : null;
}

/** Whether a frame of one segment says that it holds so much, as frames of cells do. */
function claims(bytes: Uint8Array, size: number): boolean {
  const form = bytes[4] >> 6;
  const at = 5 + [0, 1, 2, 4][bytes[4] & 3];
  let value = form === 1 ? 256 : 0;
  for (let i = 0; i < 1 << form; i++) value += bytes[at + i] * 2 ** (8 * i);
  return value === size;
}
