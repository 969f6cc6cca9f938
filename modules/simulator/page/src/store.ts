// SPDX-License-Identifier: GPL-3.0-or-later
// The case of the page: its text, and what the core says of it. Controls and builder change the text; all follow it.
import { type InputValue, parseToml } from "../../../report/viewer/src/data";
import { withValue } from "./case_text";
import { type Core, type Description, Refused } from "./core";
import { complaintsOf } from "./plain_checks";

/** Time without a change after which a text is checked [ms]. */
const kPause = 250;

export class CaseStore {
  description: Description | null = null;
  /** The resolved case; that of the last text without an error. */
  resolved: Record<string, Record<string, InputValue>> = {};
  /** The program's own message; empty where there is none. */
  error = "";
  checked: Promise<void> = Promise.resolve();
  private listeners: (() => void)[] = [];
  private timer = 0;
  private nChanges = 0;

  constructor(readonly core: Core | null, public text: string, public name: string) {}

  onChange(listener: () => void): void {
    this.listeners.push(listener);
  }

  set(text: string, name = this.name): void {
    this.text = text;
    this.name = name;
    clearTimeout(this.timer);
    this.checked = new Promise((done) => {
      this.timer = window.setTimeout(() => void this.check().then(done), kPause);
    });
    this.notify();
  }

  setKey(section: string, key: string, value: string | null): void {
    this.set(withValue(this.text, section, key, value));
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
    for (const listener of this.listeners) listener();
  }
}
