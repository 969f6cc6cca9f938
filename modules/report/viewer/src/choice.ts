// SPDX-License-Identifier: GPL-3.0-or-later
// The load that charts and tables show, chosen in one place.
import { loadUnit } from "./format";
import type { LoadName } from "./types";

/** Name, what it is called, and its unit. */
export const kLoads: Record<LoadName, { title: string; short: string; unit: "N" | "N m" }> = {
  Fx: { title: "Fx, against the heading", short: "Fx, horizontal", unit: "N" },
  Fy: { title: "Fy, to starboard", short: "Fy, lateral", unit: "N" },
  Fz: { title: "Fz, upwards", short: "Fz, vertical", unit: "N" },
  Mx: { title: "Mx, about the heading", short: "Mx", unit: "N m" },
  My: { title: "My, about the beam", short: "My", unit: "N m" },
  Mz: { title: "Mz, about the vertical", short: "Mz", unit: "N m" },
};
/** The unit that a load is shown in. */
export const shownUnit = (name: LoadName): string => kLoads[name].unit.replace("N", loadUnit());
export const kLoadNames = Object.keys(kLoads) as LoadName[];

export class LoadChoice {
  name: LoadName = "Fx";
  private readonly listeners: (() => void)[] = [];

  onChange(listener: () => void): void {
    this.listeners.push(listener);
  }

  set(name: LoadName): void {
    this.name = name;
    for (const listener of this.listeners) listener();
  }

  get unit(): string {
    return shownUnit(this.name);
  }
}
