// SPDX-License-Identifier: GPL-3.0-or-later
// Figures and data as files.
import { el } from "./dom";

/** Offers a file to the browser's downloads. */
export function save(name: string, content: Blob): void {
  const link = el("a", { href: URL.createObjectURL(content), download: name });
  link.click();
  setTimeout(() => URL.revokeObjectURL(link.href), 60e3);
}

export const saveText = (name: string, text: string, type: string): void => save(name, new Blob([text], { type }));

/** What of the page's style a drawing needs to look the same alone. */
const kStyles = [
  "fill", "fill-opacity", "fill-rule", "stroke", "stroke-width", "stroke-opacity", "stroke-dasharray", "opacity",
  "font-family", "font-size", "text-anchor", "vector-effect", "paint-order", "stroke-linejoin",
];

/** Mixed colours in the older notation, which every program for drawings reads. */
const plainColour = (value: string): string =>
  value.replace(/color\(srgb ([\d.]+) ([\d.]+) ([\d.]+)\)/g, (_, ...rgb: string[]) =>
    `rgb(${rgb.slice(0, 3).map((part) => Math.round(255 * Number(part))).join(",")})`);

/** A drawing of the page as a file: its styles written out. */
export function svgText(drawing: SVGSVGElement): string {
  const copy = drawing.cloneNode(true) as SVGSVGElement;
  const copies = [...copy.querySelectorAll<SVGElement>("*")];
  [...drawing.querySelectorAll<SVGElement>("*")].forEach((original, i) => {
    const style = getComputedStyle(original);
    const written = kStyles.map((name) => `${name}:${plainColour(style.getPropertyValue(name))}`).join(";");
    copies[i].setAttribute("style", written);
    for (const name of ["tabindex", "role", "class"]) copies[i].removeAttribute(name);
  });
  const { width, height } = drawing.viewBox.baseVal;
  copy.setAttribute("xmlns", "http://www.w3.org/2000/svg");
  copy.setAttribute("width", String(kWide));
  copy.setAttribute("height", String(Math.round((kWide * height) / width)));
  copy.removeAttribute("style");
  return new XMLSerializer().serializeToString(copy);
}

/** Width of a drawing as a file [px]. */
const kWide = 1600;

/** A drawing as pixels, `fine` for each of its own. */
export async function pngOf(svg: string, fine = 1): Promise<Blob> {
  const image = new Image();
  image.src = `data:image/svg+xml;charset=utf-8,${encodeURIComponent(svg)}`;
  await image.decode();
  const canvas = el("canvas", { width: fine * image.width, height: fine * image.height });
  canvas.getContext("2d")!.drawImage(image, 0, 0, canvas.width, canvas.height);
  return pixels(canvas);
}

export const pixels = (canvas: HTMLCanvasElement): Promise<Blob> =>
  new Promise((done, fail) => canvas.toBlob((blob) => (blob ? done(blob) : fail(new Error("no picture"))), "image/png"));

/** Columns of numbers or texts as CSV; a missing one is an empty cell. */
export function csv(columns: [string, ArrayLike<number | string | null | undefined>][]): string {
  const quoted = (text: string) => (/[",\n]/.test(text) ? `"${text.replace(/"/g, '""')}"` : text);
  const lines = [columns.map(([name]) => quoted(name)).join(",")];
  const rows = Math.max(0, ...columns.map(([, values]) => values.length));
  for (let i = 0; i < rows; ++i) lines.push(columns.map(([, values]) => quoted(String(values[i] ?? ""))).join(","));
  return lines.join("\n") + "\n";
}

/** Buttons that save one figure, `what` for its name: its formats, and what each does. */
export function saveButtons(what: string, formats: Record<string, () => void | Promise<void>>): HTMLElement {
  return el("span", { class: "saves", role: "group", "aria-label": `Save ${what}` },
    ...Object.entries(formats).map(([format, act]) =>
      el("button", { type: "button", title: `Save ${what} as ${format}`, click: () => void act() }, format)));
}

/** Buttons that save a drawing of the page. */
export function drawingButtons(what: string, name: string, drawing: () => SVGSVGElement): HTMLElement {
  return saveButtons(what, {
    SVG: () => saveText(`${name}.svg`, svgText(drawing()), "image/svg+xml"),
    PNG: async () => save(`${name}.png`, await pngOf(svgText(drawing()))),
  });
}
