// SPDX-License-Identifier: GPL-3.0-or-later
// The works that a report asks to cite, as BibTeX.

export interface Work {
  kind: "article" | "book" | "inproceedings" | "misc" | "software" | "techreport";
  key: string;
  fields: Record<string, string>;
}

const article = (key: string, fields: Record<string, string>): Work => ({ kind: "article", key, fields });

export const kPaper = article("ndem_ann_2023", {
  title: "A Data-Driven Model for Ice-Breaking Resistance of Structure Based on Non-Smooth Discrete Element Method and Artificial Neural Network Method",
  journal: "Journal of Marine Science and Engineering", year: "2023", volume: "11", number: "3", pages: "469", doi: "10.3390/jmse11030469",
});
export const kHetenyi: Work = { kind: "book", key: "hetenyi_1946", fields: {
  author: "Hetényi, M.", title: "Beams on Elastic Foundation", publisher: "University of Michigan Press", year: "1946",
} };
export const kNevel: Work = { kind: "inproceedings", key: "nevel_1972", fields: {
  author: "Nevel, D. E.", title: "The ultimate failure of a floating ice sheet", booktitle: "IAHR Ice Symposium, Leningrad", year: "1972",
} };
export const kMorison = article("morison_1950", {
  author: "Morison, J. R. and O'Brien, M. P. and Johnson, J. W. and Schaaf, S. A.", title: "The force exerted by surface waves on piles",
  journal: "Petroleum Transactions, AIME", year: "1950", volume: "189", pages: "149--154", doi: "10.2118/950149-G",
});
export const kSokal: Work = { kind: "inproceedings", key: "sokal_1997", fields: {
  author: "Sokal, A.", title: "Monte Carlo methods in statistical mechanics: foundations and new algorithms", booktitle: "Functional Integration", year: "1997",
} };
export const kWolff = article("wolff_2004", {
  author: "Wolff, U.", title: "Monte Carlo errors with less errors", journal: "Computer Physics Communications",
  year: "2004", volume: "156", pages: "143--153", doi: "10.1016/S0010-4655(03)00467-3",
});
export const kWelch = article("welch_1967", {
  author: "Welch, P. D.",
  title: "The use of fast Fourier transform for the estimation of power spectra: a method based on time averaging over short, modified periodograms",
  journal: "IEEE Transactions on Audio and Electroacoustics", year: "1967", volume: "15", number: "2", pages: "70--73", doi: "10.1109/TAU.1967.1161901",
});
export const kIso19906: Work = { kind: "techreport", key: "iso_19906", fields: {
  author: "{International Organization for Standardization}", title: "ISO 19906: Petroleum and natural gas industries -- Arctic offshore structures",
  institution: "ISO", year: "2019", note: "A.8.2.4.4",
} };

export const kIso19906Of2010: Work = { ...kIso19906, key: "iso_19906_2010", fields: { ...kIso19906.fields, year: "2010", note: "A.8.2.4.3.3" } };
export const kLindqvist: Work = { kind: "inproceedings", key: "lindqvist_1989", fields: {
  author: "Lindqvist, G.", title: "A straightforward method for calculation of ice resistance of ships", booktitle: "POAC, Luleå", year: "1989",
} };

/** A program, with the version that the run used; "" where its manifest names none. */
export function program(key: string, author: string, title: string, version: string): Work {
  return { kind: "software", key, fields: { author: `{${author}}`, title, ...(version && { version }) } };
}

/** Letters that would end a field or begin a command are left out: a version comes from the manifest, whatever it holds. */
const plain = (text: string) => text.replace(/[^\p{L}\p{N} .,:;'()/{}_+-]/gu, "");

/** Each work once, in the order given. */
export function bibtex(works: Work[]): string {
  const once = [...new Map(works.map((work) => [work.key, work])).values()];
  return once
    .map(({ kind, key, fields }) =>
      `@${kind}{${key},\n${Object.entries(fields).map(([name, value]) => `  ${name} = {${plain(value)}},\n`).join("")}}\n`)
    .join("\n");
}
