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

/** A name or a path that may continue in the next line behind its underscores, slashes and dots, but for decimal
 * points. */
function breakable(text: string): Child[] {
  return text.split(/(?<=\/)|(?<=_)(?=[a-z\d])|(?<=\.)(?=[a-z])/).flatMap((part, i) => (i === 0 ? [part] : [el("wbr"), part]));
}

const kNumeric = /^([−\d.,: ]|to|%|×|[⁰¹²³⁴⁵⁶⁷⁸⁹⁻]|–|[kM]?B)*$/;

interface Group {
  /** Of the row above the group; none, if it is empty. */
  title: string;
  id?: string;
  rows: Child[][];
}

/** Said in a column of numbers in place of a number. */
const kNoNumber = /^(none|none: see the warnings|too few samples)$/;

/** The head of a column; its unit stays in one line. */
function headText(text: string): Child[] {
  const unit = /^(.*?)( ?\[[^\]]*\])$/.exec(text);
  return unit ? [...breakable(unit[1]), " ", el("span", { class: "value" }, unit[2].trim())] : breakable(text);
}

/** A cell; an interval in brackets stays in one line. */
function cellText(text: string): Child[] {
  const interval = /^([^ ]+) (\([^()]* to [^()]*\))$/.exec(text);
  return interval ? [interval[1], " ", el("span", { class: "value" }, interval[2])] : breakable(text);
}

/** A table in groups of rows; columns that hold nothing but numbers align right. */
export function groupedTable(head: Child[], groups: Group[], attributes: Attributes = {}): HTMLElement {
  const all = groups.flatMap(({ rows }) => rows);
  const isNumeric = (cells: Child[]) => cells.every((cell) => typeof cell === "string" && (kNumeric.test(cell) || kNoNumber.test(cell))) &&
    cells.some((cell) => kNumeric.test(cell as string));
  const numeric = (all[0] ?? []).map((_, i) => isNumeric(all.map((row) => row[i])));
  const cell = (tag: "td" | "th", child: Child, i: number) =>
    el(tag, { class: numeric[i] ? "number" : undefined, scope: tag === "th" ? "col" : undefined },
      ...(typeof child !== "string" ? [child] : tag === "th" ? headText(child) : cellText(child)));
  const headOf = (text: Child, i: number) => (text === "" ? el("td") : cell("th", text, i));
  // A wide table scrolls, also by keys.
  return el("div", { class: "table", tabindex: 0, role: "group", "aria-label": "Table" },
    el("table", attributes,
      head.length > 0 && el("thead", {}, el("tr", {}, ...head.map(headOf))),
      ...groups.map(({ title, id, rows }) => el("tbody", { id },
        title !== "" && el("tr", { class: "group" }, el("th", { colspan: Math.max(1, head.length), scope: "rowgroup" }, ...breakable(title))),
        ...rows.map((row) => el("tr", {}, ...row.map((child, i) => cell("td", child, i))))))));
}

export function table(head: Child[], rows: Child[][], attributes: Attributes = {}): HTMLElement {
  return groupedTable(head, [{ title: "", rows }], attributes);
}

export function css(variable: string): string {
  return getComputedStyle(document.documentElement).getPropertyValue(variable).trim();
}
