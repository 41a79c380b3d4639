/** Draws a text as a QR code. Imported when the first invitation is made. */
import qrcode from "qrcode-generator";

const SVG = "http://www.w3.org/2000/svg";
/** Light modules around the code that readers need (ISO/IEC 18004). */
const MARGIN = 4;

/** The code as a picture, dark on light in either theme, since not all readers know the reverse. */
export function drawCode(text: string, label: string): SVGSVGElement {
  const code = qrcode(0, "L");
  code.addData(text);
  code.make();
  const count = code.getModuleCount();
  let path = "";
  for (let row = 0; row < count; row++)
    for (let column = 0; column < count; column++)
      if (code.isDark(row, column)) path += `M${column + MARGIN} ${row + MARGIN}h1v1h-1z`;
  const svg = document.createElementNS(SVG, "svg");
  const side = count + 2 * MARGIN;
  svg.setAttribute("viewBox", `0 0 ${side} ${side}`);
  svg.setAttribute("role", "img");
  svg.setAttribute("aria-label", label);
  svg.setAttribute("shape-rendering", "crispEdges");
  svg.setAttribute("class", "qr");
  const shape = document.createElementNS(SVG, "path");
  shape.setAttribute("d", path);
  svg.append(shape);
  return svg;
}
