// SPDX-License-Identifier: GPL-3.0-or-later
// The JSON Schema of a case as the form needs it.

/** Values that have been measured [SI]. */
export interface Range {
  least: number;
  most: number;
  source: string;
}

export interface KeySchema {
  type?: string | string[];
  enum?: string[];
  default?: unknown;
  minimum?: number;
  maximum?: number;
  exclusiveMinimum?: number;
  exclusiveMaximum?: number;
  examples?: unknown[];
  description?: string;
  properties?: Record<string, KeySchema>;
  required?: string[];
  "x-unit"?: string;
  "x-kinds"?: string[];
  "x-of-kinds"?: Record<string, string[]>;
  "x-presets"?: Record<string, unknown>;
  "x-required"?: boolean;
  "x-short-for"?: string;
  /** Values beyond these are warned of. */
  "x-plausible"?: { warning: string; sea: Range; model?: Range };
}

export interface Section {
  /** As in a case file: ice, ice.variation. */
  name: string;
  description: string;
  keys: { name: string; schema: KeySchema; required: boolean }[];
}

/** Sections in the order of the schema; a section inside another comes behind it. */
export function sectionsOf(schema: KeySchema, prefix = ""): Section[] {
  return Object.entries(schema.properties ?? {}).flatMap(([name, part]) => {
    const path = prefix + name;
    const keys = Object.entries(part.properties ?? {}).filter(([, key]) => !key.properties)
      .map(([key, of]) => ({ name: key, schema: of, required: (part.required ?? []).includes(key) || of["x-required"] === true }));
    const own = part.properties && keys.length > 0 ? [{ name: path, description: part.description ?? "", keys }] : [];
    const inner = Object.fromEntries(Object.entries(part.properties ?? {}).filter(([, key]) => key.properties));
    return [...own, ...sectionsOf({ properties: inner }, `${path}.`)];
  });
}

/** A key with the names that its section's kind takes alone, as the program reads it. */
export function ofKind(key: KeySchema, kind: string): KeySchema {
  const names = key["x-of-kinds"]?.[kind];
  return names ? { ...key, enum: names, default: names.includes(key.default as string) ? key.default : names[0] } : key;
}

/** What a key means, as the schema has it. */
export function meaningOf(section: string, key: string): string {
  const of = sectionsOf(readSchema()).find(({ name }) => name === section);
  return of?.keys.find(({ name }) => name === key)?.schema.description ?? "";
}

export function readSchema(): KeySchema {
  return JSON.parse(document.getElementById("brash-schema")!.textContent!) as KeySchema;
}
