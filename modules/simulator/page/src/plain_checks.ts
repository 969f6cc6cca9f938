// SPDX-License-Identifier: GPL-3.0-or-later
// Checks of a page without the core: names, choices and the range of bare numbers. `brash check` knows the rest.
import { typedOf, valueIn } from "./case_text";
import { type KeySchema, readSchema, sectionsOf } from "./schema";

function complaint(where: string, value: string, key: KeySchema): string | null {
  const typed = typedOf(value);
  if (key.enum && !key.enum.includes(typed)) return `${where} = ${value} is not one of ${key.enum.join(", ")}.`;
  const number = Number(value);
  if (!/^[-+.\d]/.test(value) || !Number.isFinite(number)) return null;
  const [least, most] = [key.minimum ?? key.exclusiveMinimum ?? -Infinity, key.maximum ?? key.exclusiveMaximum ?? Infinity];
  const outside = number < least || number > most || number === key.exclusiveMinimum || number === key.exclusiveMaximum;
  return outside ? `${where} = ${value} is outside its range, ${least} to ${most}${key["x-unit"] && key["x-unit"] !== "1" ? ` ${key["x-unit"]}` : ""}.` : null;
}

export function complaintsOf(toml: string): string[] {
  return sectionsOf(readSchema()).flatMap(({ name, keys }) =>
    keys.flatMap(({ name: key, schema, required }) => {
      const value = valueIn(toml, name, key);
      if (value === null) return required && !schema["x-kinds"] ? [`${name}.${key} is missing.`] : [];
      return complaint(`${name}.${key}`, value, schema) ?? [];
    }));
}
