/** Numbers as the page shows them. */

/** A time in milliseconds: "14 µs", "0.23 ms", "16.7 ms", "1.2 s". */
export function duration(milliseconds: number): string {
  if (milliseconds < 0.0995) return `${Math.round(1000 * milliseconds)} µs`;
  if (milliseconds < 9.95) return `${milliseconds.toFixed(2)} ms`;
  if (milliseconds < 999.5) return `${milliseconds.toFixed(milliseconds < 99.5 ? 1 : 0)} ms`;
  return `${(milliseconds / 1000).toFixed(1)} s`;
}

/** A length with two significant digits, at most four decimals: "0.0069", "0.12", "3.4". */
export function length(metres: number): string {
  if (metres < 0.00005) return metres > 0 ? "< 0.0001" : "0";
  const digits = Math.max(0, 1 - Math.floor(Math.log10(metres)));
  return metres.toFixed(Math.min(4, digits));
}

/** A whole number with separators between thousands: "5,050". */
export function count(number: number): string {
  return number.toLocaleString("en");
}
