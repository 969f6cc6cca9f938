// SPDX-License-Identifier: GPL-3.0-or-later
// The case of the page: its text, and what the core says of it. Controls and builder change the text; all follow it.
import { type InputValue, parseToml } from "../../../report/viewer/src/data";
import { typedOf, valueIn, withChange } from "./case_text";
import { type Core, type Description, Refused } from "./core";
import { readKinds, withKind } from "./kinds";
import { complaintsOf } from "./plain_checks";
import { namesABasin, type Warning, warningsOf } from "./plausible";
import { meaningOf } from "./schema";
import { withoutIceName } from "./site_ice";

/** Sections whose values change no load. */
const kWithoutLoad = ["time", "random", "output", "reference"];

/** Time without a change after which a text is checked [ms]. */
const kPause = 250;

export class CaseStore {
  description: Description | null = null;
  /** The resolved case; that of the last text without an error. */
  resolved: Record<string, Record<string, InputValue>> = {};
  /** The program's own message; empty where there is none. */
  error = "";
  checked: Promise<void> = Promise.resolve();
  /** The program's warnings; without it, the warnings of the page. */
  warnings: Warning[] = [];
  /** Of a change that the page made on its own. */
  private note = "";
  private listeners: (() => void)[] = [];
  private timer = 0;
  private nChanges = 0;

  constructor(readonly core: Core | null, public text: string, public name: string) {}

  onChange(listener: () => void): void {
    this.listeners.push(listener);
  }

  /** @param note  of a change that the page made on its own. */
  set(text: string, name = this.name, note = this.name === name ? this.note : ""): void {
    this.text = text;
    this.name = name;
    this.note = note;
    clearTimeout(this.timer);
    this.checked = new Promise((done) => {
      this.timer = window.setTimeout(() => void this.check().then(done), kPause);
    });
    this.notify();
  }

  /** Writes a key. Comments on its former value go with that. */
  setKey(section: string, key: string, value: string | null): void {
    if (section === "structure" && key === "kind" && value !== null) return this.alter(withKind(this.text, typedOf(value), readKinds()));
    const changed = withChange(this.text, section, key, value, meaningOf(section, key));
    if (changed === this.text || kWithoutLoad.includes(section)) this.set(changed);
    else this.alter(withoutIceName(changed, section, key));
  }

  /** Takes a text of another load: one that was measured with the former text goes, but not the name of its basin. */
  alter(text: string): void {
    const measured = valueIn(text, "reference", "mean_horizontal");
    if (measured === null) return this.set(text);
    const source = typedOf(valueIn(text, "reference", "source") ?? "");
    const rest = withChange(text, "reference", "mean_horizontal", null, "");
    const note = `reference.mean_horizontal = ${measured} was measured in the case before this change, and is removed: write it again if it holds for this case`;
    this.set(withChange(rest, "reference", "source", namesABasin(source) ? JSON.stringify("ice of a model basin") : null, ""), this.name, note);
  }

  /** Asks the core; without one, looks at the schema alone. */
  async check(): Promise<void> {
    const change = ++this.nChanges;
    try {
      if (this.core) {
        const description = await this.core.check(this.text, this.name);
        if (change !== this.nChanges) return;
        this.description = description;
        this.resolved = parseToml(description.toml);
        this.error = "";
      } else {
        this.error = complaintsOf(this.text).join("\n");
      }
    } catch (error) {
      if (change !== this.nChanges) return;
      this.error = error instanceof Refused ? error.message : String(error);
    }
    this.notify();
  }

  /** Tells of a failure that another part met. */
  fail(error: unknown): void {
    this.error = error instanceof Refused ? error.message : String(error);
    this.notify();
  }

  private notify(): void {
    const own = this.note === "" ? [] : [{ id: "reference", text: this.note }];
    this.warnings = [...own, ...(this.core ? (this.description?.warnings ?? []) : warningsOf(this.text))];
    for (const listener of this.listeners) listener();
  }
}
