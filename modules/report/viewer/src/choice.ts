// SPDX-License-Identifier: GPL-3.0-or-later
// The load that charts and tables show, chosen in one place.
import type { LoadName } from "./types";

/** Name, what it is called, and the unit that it is shown in. */
export const kLoads: Record<LoadName, { title: string; short: string; unit: "kN" | "kN m" }> = {
  Fx: { title: "Fx, against the heading", short: "Fx, horizontal", unit: "kN" },
  Fy: { title: "Fy, to starboard", short: "Fy, lateral", unit: "kN" },
  Fz: { title: "Fz, upwards", short: "Fz, vertical", unit: "kN" },
  Mx: { title: "Mx, about the heading", short: "Mx", unit: "kN m" },
  My: { title: "My, about the beam", short: "My", unit: "kN m" },
  Mz: { title: "Mz, about the vertical", short: "Mz", unit: "kN m" },
};
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
    return kLoads[this.name].unit;
  }
}
