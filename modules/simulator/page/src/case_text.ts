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

/** Columns of comment lines. */
const kColumns = 100;

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

/** All entries of a case with their sections, in their order. */
export function entriesOf(toml: string): (Omit<Entry, "n"> & { section: string })[] {
  const lines = toml.split("\n");
  const all = [];
  let section = "";
  for (let i = 0; i < lines.length; ) {
    const head = header(lines[i]);
    const entry = head === null ? entryAt(lines, i) : null;
    if (head !== null) section = head;
    if (entry) all.push({ section, key: entry.key, value: entry.value, comment: entry.comment });
    i += entry?.n ?? 1;
  }
  return all;
}

/** The text without a section. */
export function withoutSection(toml: string, section: string): string {
  const lines = toml.split("\n");
  const { head } = find(lines, section, "");
  if (head < 0) return toml;
  const next = lines.findIndex((line, i) => i > head && header(line) !== null);
  lines.splice(head, (next < 0 ? lines.length : next) - head);
  return lines.join("\n");
}

/** The value of a key as it is written, on one line; null where it is not. */
export function valueIn(toml: string, section: string, key: string): string | null {
  return find(toml.split("\n"), section, key).entry?.value ?? null;
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

/** Text of comment lines without their marks, on one line. */
const commentText = (lines: string[]): string => lines.map((line) => line.replace(/^\s*#\s*/, "").trim()).join(" ");

/** Whether a comment begins as the meaning of its key does. */
function isMeaning(comment: string, meaning: string): boolean {
  const [first] = comment.split(/(?<=\.) /);
  return first !== "" && meaning.startsWith(first);
}

/** The text without comments on the value of a key, behind it and above it; the meaning of the key stays. */
export function withoutSource(toml: string, section: string, key: string, meaning: string): string {
  const lines = toml.split("\n");
  const { line, entry } = find(lines, section, key);
  if (!entry) return toml;
  let above = line;
  while (above > 0 && /^\s*#/.test(lines[above - 1])) --above;
  const block = lines.slice(above, line);
  const ice = block.findIndex((each) => /^\s*# Ice \(/.test(each));  // as the template marks the source of a site's value
  const kept = !isMeaning(commentText(block), meaning) ? 0 : ice < 0 ? block.length : ice;
  lines.splice(above + kept, block.length - kept);
  const behind = isMeaning(commentText([entry.comment]), meaning) ? entry.comment : "";
  return withValue(lines.join("\n"), section, key, entry.value, behind);
}

/** The text with another value of a key, and without comments on the former one. */
export function withChange(toml: string, section: string, key: string, value: string | null, meaning: string): string {
  const isSame = valueIn(toml, section, key) === value;
  return isSame ? toml : withValue(withoutSource(toml, section, key, meaning), section, key, value);
}

/** The text with the source of a value in comment lines above it, as `brash new` writes them. */
export function withSource(toml: string, section: string, key: string, source: string): string {
  const lines = toml.split("\n");
  const comment = ["#"];
  for (const word of source.split(" ")) {
    if (comment.at(-1)!.length + 1 + word.length > kColumns) comment.push("#");
    comment.push(`${comment.pop()} ${word}`);
  }
  lines.splice(find(lines, section, key).line, 0, ...comment);
  return lines.join("\n");
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
