// SPDX-License-Identifier: GPL-3.0-or-later
// What to cite, for the features that this run used.
import { bibtex, kHetenyi, kIso19906, kIso19906Of2010, kLindqvist, kMorison, kNevel, kPaper, kSokal, kWelch, kWolff, program, type Work } from "./bibliography";
import type { Run } from "./data";
import { el, section } from "./dom";

interface Source {
  what: string;
  cite: string;
  works: Work[];
  used: (run: Run) => boolean;
}

const model = (...names: string[]) => (run: Run) => names.includes(String(run.inputs.failure?.model?.value));
const always = () => true;
const loads = (text: string) => (run: Run) =>
  run.data.closed_forms.loads.some((load) => load.source.includes(text) && load.horizontal !== undefined);

const kPaperText = `${kPaper.fields.title}, J. Mar. Sci. Eng. 11 (2023) 469, doi:${kPaper.fields.doi}`;

const kSources: Source[] = [
  { what: "the model of breaking, crushing and contact", cite: kPaperText, works: [kPaper], used: always },
  { what: "the failure model: a network trained on plate solutions", cite: "the same (Eq. 17); database, training and errors: this program's model card", works: [kPaper], used: model("network", "deep-network") },
  { what: "the failure model: superposed or solved plate", cite: "Reissner–Mindlin plate on an elastic foundation: M. Hetényi, Beams on Elastic Foundation, 1946, for the limits it is verified against", works: [kHetenyi], used: model("plate", "plate-outline", "superposition") },
  { what: "the failure model: narrow wedges", cite: "D. E. Nevel, wedges of ice on water, 1972", works: [kNevel], used: model("wedge") },
  { what: "number of wedges of a break", cite: "D. E. Nevel, 1972, as in the paper's Sec. 2.2.2", works: [kNevel], used: always },
  { what: "drag of the water", cite: "J. R. Morison, M. P. O'Brien, J. W. Johnson, S. A. Schaaf, Petroleum Transactions AIME 189 (1950) 149, as in the paper's Eqs. 13 and 14", works: [kMorison], used: always },
  { what: "rigid bodies and collision shapes", cite: "Bullet Physics, version of the manifest", works: [], used: always },
  { what: "exact geometry of cracks", cite: "CGAL, The Computational Geometry Algorithms Library, version of the manifest", works: [], used: always },
  { what: "interval of the mean", cite: "A. Sokal, Monte Carlo methods in statistical mechanics, 1997; U. Wolff, Comput. Phys. Commun. 156 (2004) 143", works: [kSokal, kWolff], used: always },
  { what: "spectrum", cite: "P. D. Welch, IEEE Trans. Audio Electroacoust. 15 (1967) 70", works: [kWelch], used: (run) => run.data.loads?.Fx.spectrum != null },
  { what: "closed form: elastic beam", cite: "ISO 19906, A.8.2.4.4 (Croasdale)", works: [kIso19906], used: loads("Croasdale") },
  { what: "closed form: plastic cone", cite: "ISO 19906, A.8.2.4.4 (Ralston)", works: [kIso19906], used: loads("Ralston") },
  { what: "closed form: crushing of a vertical face", cite: "ISO 19906:2010, A.8.2.4.3.3", works: [kIso19906Of2010], used: loads("A.8.2.4.3.3") },
  { what: "closed form: resistance of a ship", cite: "G. Lindqvist, A straightforward method for calculation of ice resistance of ships, POAC, 1989", works: [kLindqvist], used: loads("Lindqvist") },
];

/** The programs: their versions are in the manifest. */
function programs(run: Run): Work[] {
  const { program: own, built_with: libraries } = run.data.manifest;
  return [
    program("brash", "The brash authors", "brash: how a structure breaks level ice", String(own?.version ?? "")),
    program("bullet", "Bullet Physics contributors", "Bullet Physics SDK", String(libraries?.["Bullet (float64)"] ?? "")),
    program("cgal", "The CGAL Project", "CGAL, the Computational Geometry Algorithms Library", String(libraries?.CGAL ?? "")),
  ];
}

export function citeSection(run: Run): HTMLElement {
  const { program: own } = run.data.manifest;
  const used = kSources.filter((source) => source.used(run));
  const text = bibtex([...programs(run), ...used.flatMap((source) => source.works)]);
  return section("cite", "What to cite",
    el("p", {}, "For the features that this run used:"),
    el("dl", { class: "cite" },
      el("div", {}, el("dt", {}, "the program"), el("dd", {}, `${own?.name ?? "brash"} ${own?.version ?? ""}: how a structure breaks level ice`)),
      ...used.map(({ what, cite }) => el("div", {}, el("dt", {}, what), el("dd", {}, cite)))),
    el("details", { class: "bibtex" },
      el("summary", {}, "BibTeX"),
      el("p", {}, el("a", { href: `data:application/x-bibtex;charset=utf-8,${encodeURIComponent(text)}`, download: "brash.bib" }, "Download brash.bib")),
      el("pre", { tabindex: 0, role: "group", "aria-label": "BibTeX" }, text)));
}
