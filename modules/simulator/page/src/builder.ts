// SPDX-License-Identifier: GPL-3.0-or-later
// A form for every key of a case, made from its JSON Schema, beside the file that it writes.
import { el, section } from "../../../report/viewer/src/dom";
import { number } from "../../../report/viewer/src/format";
import { isOnPaper, onRefit } from "../../../report/viewer/src/paper";
import { saveText } from "../../../report/viewer/src/save";
import { tomlOf, typedOf, valueIn } from "./case_text";
import { chooser } from "./chooser";
import { plausibleText, sizeOfUnit } from "./plausible";
import { type KeySchema, ofKind, readSchema, type Section, sectionsOf } from "./schema";
import type { CaseStore } from "./store";

/** Sections that a new case needs are open at first. */
const kOpen = ["ice", "structure", "field", "time"];

/** What a key holds if it is not written, or how one could write it. */
function hint(schema: KeySchema): string {
  if (schema.default !== undefined && schema.default !== "") return `${JSON.stringify(schema.default).replace(/^"|"$/g, "")}`;
  const [example] = schema.examples ?? [];
  return example === undefined ? "" : `such as ${String(example)}`;
}

/** A bound for the eye. */
const bound = (value: number | undefined): string => (value === undefined ? "…" : number(value, 6).replace(/(\.\d*?)0+$/, "$1").replace(/\.$/, ""));

/** Of the examples of a key: the unit in which a reader writes it, and its size in SI. Angles are written in degrees. */
function writtenUnit(schema: KeySchema): { name: string; one: number } {
  const si = schema["x-unit"] ?? "1";
  const usual = [schema.default, ...(schema.examples ?? [])].find((value) => typeof value === "string" && /^[-+.\d]/.test(value));
  const name = typeof usual === "string" ? (/^[-+.\d][-+.\deE]*\s*(.*)$/.exec(usual)?.[1] ?? "") : "";
  return { name, one: name === "" ? NaN : sizeOfUnit(name, si) };
}

function meaning(schema: KeySchema): string {
  const si = schema["x-unit"] ?? "1";
  const own = writtenUnit(schema);
  const isOther = Number.isFinite(own.one) && own.one !== 1;
  const unit = si === "1" ? "" : isOther ? `Unit: ${own.name}, or another behind the number, which is in ${si} without one. ` : `Unit: ${si}, or another that is written behind the number. `;
  const [least, most] = [schema.minimum ?? schema.exclusiveMinimum, schema.maximum ?? schema.exclusiveMaximum];
  const shown = (value: number | undefined) => bound(value === undefined || !isOther ? value : Number((value / own.one).toPrecision(6)));
  const range = least === undefined && most === undefined ? "" : `Range: ${shown(least)} to ${shown(most)}${isOther ? ` ${own.name}` : ""}. `;
  const usual = schema.default === undefined || schema.default === "" || schema["x-of-kinds"] ? "" : `Default: ${hint(schema)}. `;
  const presets = Object.entries(schema["x-presets"] ?? {}).map(([name, value]) => `With the preset ${name}: ${JSON.stringify(value)}. `).join("");
  return `${unit}${range}${plausibleText(schema)}${usual}${presets}`.trim();
}

/** One key of the form. */
class Field {
  readonly element: HTMLElement;
  private readonly input: HTMLInputElement | HTMLSelectElement;
  /** The warning about the value, beside it: on a narrow page the others are far below. */
  private readonly doubt = el("p", { class: "doubt", hidden: true });

  /** @param usual  the kind of a section that names none. */
  constructor(private readonly store: CaseStore, private readonly section: string, private readonly key: string, private readonly schema: KeySchema,
              private readonly required: boolean, private readonly usual: string) {
    const id = `key-${section}-${key}`.replace(/\./g, "-");
    this.input = this.makeInput(id);
    this.element = el("div", { class: "field" },
      el("label", { for: id }, el("code", {}, key), required && el("b", { class: "required" }, " required")),
      this.input,
      this.doubt,
      el("p", { class: "meaning", id: `${id}-meaning` }, schema.description ?? "", " ", el("small", {}, meaning(schema))));
    this.input.setAttribute("aria-describedby", `${id}-meaning`);
    store.onChange(() => this.follow());
  }

  private makeInput(id: string): HTMLInputElement | HTMLSelectElement {
    const choices = this.schema.enum ?? (this.schema.type === "boolean" ? ["true", "false"] : null);
    const write = () => this.store.setKey(this.section, this.key, this.input.value.trim() === "" ? null : this.toml(this.input.value));
    if (choices) return el("select", { id, change: write }, el("option", { value: "" }), ...choices.map((name) => el("option", { value: name }, name)));
    return el("input", { id, type: "text", spellcheck: "false", autocomplete: "off", placeholder: hint(this.schema), input: write });
  }

  /** A text that looks like a number is a text where the schema has no numbers. */
  private toml(typed: string): string {
    return this.schema.type === "string" ? JSON.stringify(typed.trim()) : tomlOf(typed);
  }

  private follow(): void {
    const written = valueIn(this.store.text, this.section, this.key);
    const shown = written === null ? "" : typedOf(written);
    if (document.activeElement !== this.input && this.input.value !== shown) this.input.value = shown;
    const kinds = this.schema["x-kinds"];
    const of = valueIn(this.store.text, this.section, "kind");
    const kind = of === null ? this.usual : typedOf(of);
    if (this.input instanceof HTMLSelectElement) {
      const schema = ofKind(this.schema, kind);
      for (const option of this.input.options)
        if (option.value === "") option.textContent = this.required ? "choose" : `default: ${hint(schema)}`;
        else option.hidden = schema.enum?.includes(option.value) === false && option.value !== shown;
    }
    const doubt = this.store.warnings.find(({ text }) => text.startsWith(`${this.section}.${this.key} = `));
    this.doubt.textContent = doubt?.text ?? "";
    this.doubt.hidden = doubt === undefined;
    this.element.classList.toggle("unset", written === null);
    this.element.hidden = written === null && kinds !== undefined && this.section === "structure" && !kinds.includes(kind);
    // The program names the keys that it refuses.
    const bad = this.store.error.includes(`${this.section}.${this.key}`);
    this.input.setAttribute("aria-invalid", String(bad));
  }
}

function fieldset(store: CaseStore, { name, description, keys }: Section): HTMLDetailsElement {
  const kinds = keys.find((each) => each.name === "kind")?.schema;
  const usual = String(kinds?.default ?? kinds?.enum?.[0] ?? "");
  return el("details", { open: kOpen.includes(name) },
    el("summary", {}, el("code", {}, `[${name}]`), ` ${description}`),
    ...keys.map(({ name: key, schema, required }) => new Field(store, name, key, schema, required, usual).element));
}

/** The text of the case; whoever likes writes in it. */
export function caseFile(store: CaseStore): { element: HTMLElement; copy: HTMLElement } {
  const text = el("textarea", { spellcheck: "false", rows: 24, "aria-label": "Case file (TOML)", input: () => store.set(text.value) });
  // A field shows on paper as much of a text as it does on screen.
  const printed = el("pre", { class: "on-paper" });
  const told = el("span", { role: "status", class: "hint" });
  const copied = async () => {
    try {
      await navigator.clipboard.writeText(store.text);
    } catch {  // a page from a folder may have no clipboard
      text.select();
      document.execCommand("copy");
    }
    told.textContent = "copied";
  };
  const buttons = () => [
    el("button", { type: "button", click: () => void copied() }, "Copy the case"),
    el("button", { type: "button", click: () => saveText(store.name, store.text, "application/toml") }, "Save the case"),
  ];
  store.onChange(() => {
    printed.textContent = store.text;
    if (document.activeElement !== text && text.value !== store.text) text.value = store.text;
    told.textContent = "";
  });
  return {
    element: el("div", { class: "case-file", id: "case-file" }, el("div", { class: "bar" }, el("strong", {}, "Case file"), ...buttons()), text, printed),
    copy: el("span", { class: "pair" }, ...buttons(), told),
  };
}

/** Paper shows the keys that are written, also those of sections that are closed. */
function openForPaper(form: HTMLElement, sections: HTMLDetailsElement[]): void {
  let open: boolean[] | null = null;
  onRefit(form, () => {
    if (isOnPaper()) open ??= sections.map((each) => each.open);
    sections.forEach((each, i) => (each.open = isOnPaper() || (open?.[i] ?? each.open)));
    if (!isOnPaper()) open = null;
  });
}

export function builderSection(store: CaseStore, file: HTMLElement, messages: HTMLElement, beside: HTMLElement | null): HTMLElement {
  const sections = sectionsOf(readSchema()).map((each) => fieldset(store, each));
  const form = el("div", { class: "form" }, ...sections);
  openForPaper(form, sections);
  const note = store.core ? ["Every message is the program's own."]
    : ["This page checks names, choices and ranges, and warns of values that no ice has. ", el("code", {}, "brash check"), " also reads all units and knows which keys go together."];
  return section("builder", "Case builder",
    el("p", { class: "do" }, "Every key of a case, its unit, range, default and source. An empty field takes its default, which is shown in grey. ", ...note),
    chooser(store),
    el("p", { class: "on-paper" }, "The case file, and the meaning of its keys. Every other key takes its default."),
    el("div", { class: "builder" }, form, el("div", { class: "file" }, file, messages, beside)));
}
