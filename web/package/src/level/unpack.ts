/** Decodes cells in base64, compressed by zlib, gzip or Zstandard. As demo/level/unpack.c does. */

/** The largest window of a Zstandard frame that is accepted, log2 of bytes: zstd's own default. */
const LARGEST_WINDOW = 27;

/**
 * Decodes base64 and decompresses it by `compression` ("" for none) to exactly `size` bytes.
 * Returns a text that says why not where that fails. It never allocates more, whatever the data
 * claims.
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
    // Damaged data gives the same message as data of another size.
  }
  return whole ?? "do not unpack to as many as it has columns and rows";
}

/** Decompresses by the platform's DecompressionStream; null where the size differs. */
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

/** Collects the chunks of output whose total size is known. */
class Out {
  readonly bytes: Uint8Array;
  #used = 0;

  constructor(size: number) {
    this.bytes = new Uint8Array(size);
  }

  /** Appends bytes; false where there are more than `size` in all. */
  add(more: Uint8Array): boolean {
    if (this.#used + more.length > this.bytes.length) return false;
    this.bytes.set(more, this.#used);
    this.#used += more.length;
    return true;
  }

  /** All bytes, or null where fewer than `size` have come. */
  get whole(): Uint8Array | null {
    return this.#used === this.bytes.length ? this.bytes : null;
  }
}

/** Decompresses Zstandard; null where the size differs or the frame would need too much memory. */
function unpackZstd(
  Decompress: typeof import("fzstd").Decompress,
  bytes: Uint8Array,
  size: number,
): Uint8Array | null {
  // fzstd allocates the window that the frame's header claims before it reads the data. So the
  // header is checked first: a single-segment frame has its content size, others the window's
  // exponent minus ten (RFC 8878, section 3.1.1.1).
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

/** Whether the header of a single-segment frame gives `size` as its content size. */
function claims(bytes: Uint8Array, size: number): boolean {
  const form = bytes[4] >> 6;
  const at = 5 + [0, 1, 2, 4][bytes[4] & 3];
  let value = form === 1 ? 256 : 0;
  for (let i = 0; i < 1 << form; i++) value += bytes[at + i] * 2 ** (8 * i);
  return value === size;
}
