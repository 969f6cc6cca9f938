// SPDX-License-Identifier: GPL-3.0-or-later
// What to cite, for the features that this run used.
import type { Run } from "./data";
import { el, section } from "./dom";

const kPaper =
  "A Data-Driven Model for Ice-Breaking Resistance of Structure Based on Non-Smooth Discrete Element Method and Artificial Neural Network Method";

interface Source {
  what: string;
  cite: string;
  used: (run: Run) => boolean;
}

const model = (...names: string[]) => (run: Run) => names.includes(String(run.inputs.failure?.model?.value));
const always = () => true;
const loads = (text: string) => (run: Run) =>
  run.data.closed_forms.loads.some((load) => load.source.includes(text) && load.horizontal !== undefined);

const kSources: Source[] = [
  { what: "the model of breaking, crushing and contact", cite: kPaper, used: always },
  { what: "the failure model: a network trained on plate solutions", cite: `${kPaper} (Eq. 17); database, training and errors: this program's model card`, used: model("network", "deep-network") },
  { what: "the failure model: superposed or solved plate", cite: "Reissner–Mindlin plate on an elastic foundation: M. Hetényi, Beams on Elastic Foundation, 1946, for the limits it is verified against", used: model("plate", "plate-outline", "superposition") },
  { what: "the failure model: narrow wedges", cite: "D. E. Nevel, wedges of ice on water, 1972", used: model("wedge") },
  { what: "number of wedges of a break", cite: "D. E. Nevel, 1972, as in the paper's Sec. 2.2.2", used: always },
  { what: "drag of the water", cite: "J. R. Morison, M. P. O'Brien, J. W. Johnson, S. A. Schaaf, Petroleum Transactions AIME 189 (1950) 149, as in the paper's Eqs. 13 and 14", used: always },
  { what: "rigid bodies and collision shapes", cite: "Bullet Physics, version of the manifest", used: always },
  { what: "exact geometry of cracks", cite: "CGAL, The Computational Geometry Algorithms Library, version of the manifest", used: always },
  { what: "interval of the mean", cite: "A. Sokal, Monte Carlo methods in statistical mechanics, 1997; U. Wolff, Comput. Phys. Commun. 156 (2004) 143", used: always },
  { what: "spectrum", cite: "P. D. Welch, IEEE Trans. Audio Electroacoust. 15 (1967) 70", used: (run) => run.data.statistics?.horizontal.spectrum != null },
  { what: "closed form: elastic beam", cite: "ISO 19906, A.8.2.4.4 (Croasdale)", used: loads("Croasdale") },
  { what: "closed form: plastic cone", cite: "ISO 19906, A.8.2.4.4 (Ralston)", used: loads("Ralston") },
];

export function citeSection(run: Run): HTMLElement {
  const { program } = run.data.manifest;
  return section("cite", "What to cite",
    el("p", {}, "For the features that this run used:"),
    el("dl", { class: "cite" },
      el("div", {}, el("dt", {}, "the program"), el("dd", {}, `${program?.name ?? "brash"} ${program?.version ?? ""}: how a structure breaks level ice`)),
      ...kSources.filter((source) => source.used(run)).map(({ what, cite }) => el("div", {}, el("dt", {}, what), el("dd", {}, cite)))));
}
