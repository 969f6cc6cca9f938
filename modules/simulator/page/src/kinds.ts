// SPDX-License-Identifier: GPL-3.0-or-later
// Another kind of structure in a case: with the keys that it needs, and without those of the former one.
import { entriesOf, typedOf, valueIn, withoutSection, withValue } from "./case_text";

/** Sections that a kind decides on: what `brash new --kind` writes in them for each. */
export type NewKinds = Record<string, string>;

/** Of these sections only the keys that a new case has are taken; the others stay as they are. */
const kShared = ["field", "time"];

/** The case with this kind of structure. Its speed stays; shape, start, ice and duration are a new case's, since they have to fit. */
export function withKind(toml: string, kind: string, kinds: NewKinds): string {
  const former = typedOf(valueIn(toml, "structure", "kind") ?? "");
  if (former === kind || kinds[kind] === undefined) return toml;
  const speed = valueIn(toml, "structure", "speed");
  let text = withoutSection(toml, "hull");
  for (const { section, key } of [...entriesOf(toml).filter((each) => each.section === "structure"), ...entriesOf(kinds[former] ?? "").filter((each) => kShared.includes(each.section))])
    text = withValue(text, section, key, null);
  for (const { section, key, value, comment } of entriesOf(kinds[kind]))
    text = withValue(text, section, key, key === "speed" && speed !== null ? speed : value, comment);
  return text;
}

export const readKinds = (): NewKinds => JSON.parse(document.getElementById("brash-kinds")!.textContent!) as NewKinds;
