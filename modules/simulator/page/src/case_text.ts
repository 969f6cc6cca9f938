// SPDX-License-Identifier: GPL-3.0-or-later
// A case file as text: single keys are read and written, and the rest stays as its writer left it.

const header = (line: string): string | null => /^\s*\[\s*([A-Za-z0-9_.]+)\s*\]\s*(#.*)?$/.exec(line)?.[1] ?? null;
const entry = (line: string): { key: string; value: string; comment: string } | null => {
  const found = /^\s*([A-Za-z0-9_]+)\s*=\s*((?:"(?:[^"\\]|\\.)*"|'[^']*'|[^#"'])*?)\s*(#.*)?$/.exec(line);
  return found && { key: found[1], value: found[2], comment: found[3] ?? "" };
};

interface Place {
  /** Line of the section's header, -1: none. */
  head: number;
  /** Line of the key, -1: none. */
  line: number;
  /** Line behind the section's last key. */
  end: number;
}

function find(lines: string[], section: string, key: string): Place {
  const place: Place = { head: -1, line: -1, end: lines.length };
  let current = "";
  lines.forEach((line, i) => {
    const head = header(line);
    if (head !== null) {
      current = head;
      if (head === section) Object.assign(place, { head: i, end: i + 1 });
    } else if (current === section && entry(line)) {
      place.end = i + 1;
      if (entry(line)!.key === key) place.line = i;
    }
  });
  return place;
}

/** The value of a key as it is written; null where it is not. */
export function valueIn(toml: string, section: string, key: string): string | null {
  const lines = toml.split("\n");
  const { line } = find(lines, section, key);
  return line < 0 ? null : entry(lines[line])!.value;
}

/** The text with a key of this value; without the key, if the value is null. */
export function withValue(toml: string, section: string, key: string, value: string | null): string {
  const lines = toml.split("\n");
  const { head, line, end } = find(lines, section, key);
  if (value === null) {
    if (line >= 0) lines.splice(line, 1);
  } else if (line >= 0) {
    const { comment } = entry(lines[line])!;
    lines[line] = `${key} = ${value}${comment && `  ${comment}`}`;
  } else if (head >= 0) {
    lines.splice(end, 0, `${key} = ${value}`);
  } else {
    while (lines.length > 0 && lines.at(-1)!.trim() === "") lines.pop();
    lines.push("", `[${section}]`, `${key} = ${value}`, "");
  }
  return lines.join("\n").replace(/^\n+/, "");
}

/** What a reader typed as a value of TOML: a number, a truth, an array, or else a text. */
export function tomlOf(typed: string): string {
  const text = typed.trim();
  if (/^[+-]?(\d+(\.\d+)?|\.\d+)([eE][+-]?\d+)?$/.test(text)) return text.replace(/^\+/, "").replace(/^(-?)\./, "$10.");
  if (/^(true|false)$/.test(text) || /^\[.*\]$/s.test(text)) return text;
  return JSON.stringify(text);
}

/** The same the other way round. */
export function typedOf(value: string): string {
  if (/^'.*'$/.test(value)) return value.slice(1, -1);
  if (!/^".*"$/.test(value)) return value;
  try {
    return JSON.parse(value) as string;
  } catch {
    return value.slice(1, -1);
  }
}
