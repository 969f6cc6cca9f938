// SPDX-License-Identifier: GPL-3.0-or-later
// Elements. Every text goes through text nodes or attributes: nothing from a case is ever read as HTML.

type Child = Node | string | number | null | undefined | false;
type Attributes = Record<string, string | number | boolean | ((event: never) => void) | undefined>;

function fill(element: Element, attributes: Attributes, children: Child[]): void {
  for (const [name, value] of Object.entries(attributes)) {
    if (value === undefined || value === false) continue;
    if (typeof value === "function") element.addEventListener(name, value as EventListener);
    else element.setAttribute(name, value === true ? "" : String(value));
  }
  for (const child of children) {
    if (child === null || child === undefined || child === false) continue;
    element.append(child instanceof Node ? child : String(child));
  }
}

/** An HTML element; attributes that are functions are listeners of the event of that name. */
export function el<K extends keyof HTMLElementTagNameMap>(tag: K, attributes: Attributes = {}, ...children: Child[]) {
  const element = document.createElement(tag);
  fill(element, attributes, children);
  return element;
}

/** The same in SVG. */
export function svg<K extends keyof SVGElementTagNameMap>(tag: K, attributes: Attributes = {}, ...children: Child[]) {
  const element = document.createElementNS("http://www.w3.org/2000/svg", tag);
  fill(element, attributes, children);
  return element;
}

/** A titled part of the page that the contents link to. */
export function section(id: string, title: string, ...children: Child[]): HTMLElement {
  return el("section", { id, "aria-labelledby": `${id}-title` }, el("h2", { id: `${id}-title` }, title), ...children);
}

/** A name or a path that may go on in the next line behind its underscores, slashes and dots, but for decimal points. */
function breakable(text: string): Child[] {
  return text.split(/(?<=\/)|(?<=_)(?=[a-z\d])|(?<=\.)(?=[a-z])/).flatMap((part, i) => (i === 0 ? [part] : [el("wbr"), part]));
}

const kNumeric = /^([−\d.,: ]|to|%|×|[⁰¹²³⁴⁵⁶⁷⁸⁹⁻]|–|[kM]?B)*$/;

/** A table; columns that hold nothing but numbers align right. */
export function table(head: string[], rows: Child[][], attributes: Attributes = {}): HTMLElement {
  const numeric = (rows[0] ?? []).map((_, i) => rows.every((row) => typeof row[i] === "string" && kNumeric.test(row[i] as string)));
  const cell = (tag: "td" | "th", child: Child, i: number) =>
    el(tag, { class: numeric[i] ? "number" : undefined }, ...(typeof child === "string" ? breakable(child) : [child]));
  return el(
    "div",
    { class: "table" },
    el(
      "table",
      attributes,
      head.length > 0 && el("thead", {}, el("tr", {}, ...head.map((text, i) => cell("th", text, i)))),
      el("tbody", {}, ...rows.map((row) => el("tr", {}, ...row.map((child, i) => cell("td", child, i))))),
    ),
  );
}

export function css(variable: string): string {
  return getComputedStyle(document.documentElement).getPropertyValue(variable).trim();
}
