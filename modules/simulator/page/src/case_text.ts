// SPDX-License-Identifier: GPL-3.0-or-later
// A case file as text: single keys are read and written, and the rest stays as its writer left it.

const header = (line: string): string | null => /^\s*\[\s*([A-Za-z0-9_.]+)\s*\]\s*(#.*)?$/.exec(line)?.[1] ?? null;

/** Strings, then comments, then all else of a line. */
const kTokens = /"(?:[^"\\]|\\.)*"|'[^']*'|#.*|[^"'#]+|["']/g;

/** A line without its comment, the comment, and how many brackets it opens more than it closes. */
function parts(line: string): { code: string; comment: string; open: number } {
  const tokens = line.match(kTokens) ?? [];
  const isComment = (token: string) => token.startsWith("#");
  const bare = tokens.filter((token) => !/^["'#]/.test(token)).join("");
  return {
    code: tokens.filter((token) => !isComment(token)).join("").trim(),
    comment: tokens.find(isComment) ?? "",
    open: (bare.match(/\[/g) ?? []).length - (bare.match(/\]/g) ?? []).length,
  };
}

interface Entry {
  key: string;
  /** On one line. */
  value: string;
  /** Behind the value. */
  comment: string;
  /** Number of lines: an array may go on over several. */
  n: number;
}

/** The entry that begins on a line. */
function entryAt(lines: string[], first: number): Entry | null {
  const found = /^([A-Za-z0-9_]+)\s*=\s*(.*)$/.exec(parts(lines[first]).code);
  if (!found) return null;
  let { comment, open } = parts(lines[first]);
  let [value, n] = [found[2], 1];
  while (open > 0 && first + n < lines.length) {
    const next = parts(lines[first + n++]);
    value += ` ${next.code}`;
    comment = next.comment;
    open += next.open;
  }
  return { key: found[1], value: value.trim(), comment, n };
}

interface Place {
  /** Line of the section's header, -1: none. */
  head: number;
  /** First line of the key, -1: none. */
  line: number;
  entry: Entry | null;
  /** Line behind the section's last key. */
  end: number;
}

function find(lines: string[], section: string, key: string): Place {
  const place: Place = { head: -1, line: -1, entry: null, end: lines.length };
  let current = "";
  for (let i = 0; i < lines.length; ) {
    const head = header(lines[i]);
    const entry = head === null ? entryAt(lines, i) : null;
    const n = entry?.n ?? 1;
    if (head !== null) current = head;
    if (head === section) Object.assign(place, { head: i, end: i + 1 });
    if (current === section && entry) {
      place.end = i + n;
      if (entry.key === key) Object.assign(place, { line: i, entry });
    }
    i += n;
  }
  return place;
}

/** The value of a key as it is written, on one line; null where it is not. */
export function valueIn(toml: string, section: string, key: string): string | null {
  return find(toml.split("\n"), section, key).entry?.value ?? null;
}

/** The comment behind the value of a key; "" where there is none. */
export function commentIn(toml: string, section: string, key: string): string {
  return find(toml.split("\n"), section, key).entry?.comment ?? "";
}

/**
 * The text with a key of this value; without the key, if the value is null.
 * @param comment in place of the one behind the value, which stays by default.
 */
export function withValue(toml: string, section: string, key: string, value: string | null, comment?: string): string {
  const lines = toml.split("\n");
  const { head, line, entry, end } = find(lines, section, key);
  const written = (behind: string) => `${key} = ${value}${behind && `  ${behind}`}`;
  if (value === null) {
    if (entry) lines.splice(line, entry.n);
  } else if (entry) {
    lines.splice(line, entry.n, written(comment ?? entry.comment));
  } else if (head >= 0) {
    lines.splice(end, 0, written(comment ?? ""));
  } else {
    while (lines.length > 0 && lines.at(-1)!.trim() === "") lines.pop();
    lines.push("", `[${section}]`, written(comment ?? ""), "");
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
