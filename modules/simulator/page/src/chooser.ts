// SPDX-License-Identifier: GPL-3.0-or-later
// Three questions that end in a case and the commands for it: which structure, which ice, what do you want to know.
import { el } from "../../../report/viewer/src/dom";
import { typedOf, valueIn, withoutSection, withValue } from "./case_text";
import { readKinds, withKind } from "./kinds";
import { iceChoice } from "./site_ice";
import type { CaseStore } from "./store";

/** Keys by section and name, as they are written; null for one that is left out. */
type Keys = Record<string, string | null>;

interface Choice {
  name: string;
  /** Keys that make the choice, and by which it is recognised. */
  keys: Keys;
}

interface Question {
  name: string;
  /** The structures it is asked of; all, if there are none. */
  of?: string[];
  /** Commands, and the files besides the case that they read. */
  commands: string;
  files?: Record<string, string>;
  says: string;
}

/** `entersWhole`: its level ice begins without a crack. */
const kStructures: Record<string, Choice & { kind: string; entersWhole?: boolean }> = {
  cone: { kind: "cone", name: "a tower or pier with an ice cone", keys: {} },
  pier: { kind: "cone", entersWhole: true, name: "a vertical pier or tower", keys: { "structure.angle": '"90 deg"' } },
  wall: { kind: "plane", name: "a sloping wall or a barge", keys: {} },
  ship: { kind: "ship", entersWhole: true, name: "a ship", keys: {} },
  floater: {
    kind: "cone", name: "a moored floater",
    keys: {
      "structure.breaking": '"downward"', "structure.motion.kind": '"moored"', "structure.motion.frame": '"ice-drifts-through-still-water"',
      "structure.motion.stiffness_matrix": "[[2e5, 0, 0, 0, 0, 0], [0, 2e5, 0, 0, 0, 0], [0, 0, 0, 0, 0, 0], [0, 0, 0, 0, 0, 0], [0, 0, 0, 0, 0, 0], [0, 0, 0, 0, 0, 1e7]]",
      "structure.motion.linear_damping": "[1e5, 1e5, 1e5]", "structure.motion.angular_damping": "[1e6, 1e6, 1e6]",
    },
  },
  mesh: { kind: "mesh", name: "a mesh of your own", keys: {} },
};

const kCovers: Record<string, Choice> = {
  level: { name: "level ice", keys: {} },
  floes: {
    name: "broken ice", keys: {
      "field.kind": '"floes"', "field.concentration": '"70 percent"',
      "field.size.kind": '"log-normal"', "field.size.median": '"6 m"', "field.size.deviation": "0.3",
    },
  },
};

/** A plan of replicates in three thicknesses. */
const kPlan = `[campaign]
case = "CASE"
replicates = 10

[[grid]]
ice.thickness = ["0.2 m", "0.4 m", "0.6 m"]

[output]
keep = "history"
columns = ["horizontal.mean", "horizontal.maximum"]
`;

const kQuestions: Record<string, Question> = {
  load: { name: "the load over time, and its causes", commands: "brash run CASE -o results/one",
          says: "The table has the mean, its interval, quantiles and causes; results/one/report.html draws them and replays the run." },
  codes: { name: "what the codes say, without a run", commands: "brash loads CASE", says: "The closed forms that fit the structure, each with its source." },
  mean: { name: "the load over the thickness, with intervals", commands: "brash campaign plan.toml -o results/thickness\nbrash trend results/thickness --along ice.thickness",
          files: { "plan.toml": kPlan }, says: "Replicates differ in their random numbers, and give the interval. The table says how many would halve it." },
  years: { name: "the load of 50 years", commands: "brash campaign plan.toml -o results/thickness\nbrash design results/thickness --scatter states.csv --years 1,50",
           files: { "plan.toml": kPlan, "states.csv": "ice.thickness,hours\n0.2,300\n0.4,200\n0.6,20\n" },
           says: "The hours of each thickness in a year are yours to write. Levels far beyond the histories are marked." },
  resistance: { name: "the resistance, and the speed that a thrust attains", of: ["ship"],
                commands: "brash resistance CASE --thickness 0.3,0.6,0.9 --speed 1,2,4 -o results/ship\nbrash resistance results/ship --bollard-pull 9e5 --open-water-speed 8",
                says: "Hours of a core: each run goes 3.5 lengths of the hull. Lindqvist, Riska and Jeong stand beside." },
  offset: { name: "offset and mooring", of: ["floater"], commands: "brash run CASE -o results/one\nbrash stats results/one --column structure_x",
            says: "history.csv has the motion; the offset is structure_x less the path of the anchors, which move with structure.speed. Lines take the place of the springs." },
  measured: { name: "how a run compares with a measurement", commands: "brash run CASE -o results/one\nbrash compare results/one measured.csv",
              says: "measured.csv has a column of times and a column of loads, such as Fx [kN]." },
  openfast: { name: "a load file for OpenFAST", of: ["cone", "pier", "floater"], commands: "brash run CASE -o results/one\nbrash export openfast results/one --ramp 2 -o openfast",
              says: "A campaign in place of the run gives a file for each case." },
};

/** The section and the name of a key. */
const partsOf = (path: string): [string, string] => [path.slice(0, path.lastIndexOf(".")), path.slice(path.lastIndexOf(".") + 1)];

/** Whether a case has these keys. */
const has = (toml: string, keys: Keys): boolean => Object.entries(keys).every(([path, value]) => valueIn(toml, ...partsOf(path)) === value);

const withKeys = (toml: string, keys: Keys): string => Object.entries(keys).reduce((text, [path, value]) => withValue(text, ...partsOf(path), value), toml);

/** The choice whose keys a case has: the one with the most of them. "" if there is none. */
function chosen<T extends Choice>(toml: string, choices: Record<string, T>, fits: (choice: T) => boolean = () => true): string {
  const all = Object.entries(choices).filter(([, choice]) => fits(choice) && has(toml, choice.keys));
  return all.sort(([, a], [, b]) => Object.keys(b.keys).length - Object.keys(a.keys).length)[0]?.[0] ?? "";
}

const structureOf = (toml: string): string => chosen(toml, kStructures, ({ kind }) => valueIn(toml, "structure", "kind") === `"${kind}"`);

/** The case with another structure: as a new case of its kind, so that no key of the former one is left. */
function withStructure(toml: string, name: string): string {
  const { kind, keys } = kStructures[name];
  const kinds = readKinds();
  const bare = withValue(withoutSection(toml, "structure.motion"), "structure", "breaking", null);
  const other = typedOf(valueIn(bare, "structure", "kind") ?? "") === kind ? withKind(bare, kind === "plane" ? "cone" : "plane", kinds) : bare;
  return withFirstCrack(withKeys(withKind(other, kind, kinds), keys));
}

const isBroken = (toml: string): boolean => valueIn(toml, "field", "kind") === '"floes"';

/** The case with a first crack where its structure and its ice have one. */
function withFirstCrack(toml: string): string {
  const isWhole = !isBroken(toml) && kStructures[structureOf(toml)]?.entersWhole;
  return withValue(toml, "field", "initial_crack", isWhole ? "false" : null);
}

function withCover(toml: string, name: string): string {
  const bare = withoutSection(withKeys(toml, { "field.kind": null, "field.concentration": null }), "field.size");
  return withFirstCrack(withKeys(bare, kCovers[name].keys));
}

/** Which structure, which ice, what do you want to know: the case below changes, and commands follow. */
export function chooser(store: CaseStore): HTMLElement {
  const choice = (id: string, label: string, choices: Record<string, { name: string }>, take: (name: string) => void) => {
    const select = el("select", { id, change: () => select.value && take(select.value) },
      el("option", { value: "" }, "as written"), ...Object.entries(choices).map(([value, { name }]) => el("option", { value }, name)));
    return { select, row: el("p", { class: "do" }, el("label", { for: id }, `${label} `), select) };
  };
  const structure = choice("choose-structure", "Which structure?", kStructures, (name) => store.alter(withStructure(store.text, name)));
  const cover = choice("choose-cover", "Whole or broken?", kCovers, (name) => store.alter(withCover(store.text, name)));
  const question = choice("choose-question", "What do you want to know?", kQuestions, () => show());
  question.select.options[0].remove();
  const answer = el("div", { id: "answer" });
  const show = () => {
    const { commands, files = {}, says } = kQuestions[question.select.value];
    const named = (text: string) => text.replace(/CASE/g, store.name);
    answer.replaceChildren(
      el("p", { class: "hint" }, says),
      ...Object.entries(files).flatMap(([name, text]) => [el("p", {}, "Write ", el("code", {}, name), ":"), el("pre", {}, named(text))]),
      el("p", {}, "Save the case below as ", el("code", {}, store.name), ", and run:"),
      el("pre", { class: "commands" }, named(`brash check CASE\n${commands}`)));
  };
  store.onChange(() => {
    structure.select.value = structureOf(store.text);
    cover.select.value = isBroken(store.text) ? "floes" : "level";
    for (const option of question.select.options) option.hidden = kQuestions[option.value].of?.includes(structure.select.value) === false;
    if (question.select.selectedOptions[0]?.hidden !== false) question.select.value = "load";
    show();
  });
  return el("div", { class: "chooser" }, structure.row, iceChoice(store), cover.row, question.row, answer);
}
