// SPDX-License-Identifier: GPL-3.0-or-later
// What is in the page's data, as modules/report/src writes it. SI throughout.

export interface BlockEntry {
  name: string;
  kind: "f64" | "f32" | "i32";
  count: number;
  unit: number;
}

export interface HashedFile {
  path: string;
  bytes?: number;
  sha256: string;
}

export interface Manifest {
  program?: { name: string; version: string };
  built_with?: Record<string, string>;
  glibc?: string;
  case?: { name: string; toml: string };
  plan?: { path: string; sha256: string };
  seeds?: { seed: number; replicate: number };
  inputs?: HashedFile[];
  outputs?: HashedFile[];
  volatile?: { started_at?: string; wall_seconds?: number; host_cpu?: string; stage_seconds?: Record<string, number> };
}

/** Null where the run is over before its statistics begin. */
export interface LoadSummary {
  mean: number | null;
  mean_95: [number, number] | [null, null];
  standard_deviation: number | null;
  minimum: number | null;
  maximum: number | null;
  skewness: number | null;
  quantile_50: number | null;
  quantile_95: number | null;
  quantile_99: number | null;
  autocorrelation_time: number | null;
  effective_sample_size: number | null;
  long_enough: boolean;
  mean_by_cause: Record<string, number | null>;
}

export interface RunSummary {
  statistics_from: number;
  /** These two are absent in files of earlier versions. */
  statistics_until?: number;
  statistics_window?: { begins: string; ends: string };
  horizontal: LoadSummary;
  vertical: LoadSummary;
  mean_whole_history: { horizontal: number; vertical: number };
  /** Absent in files of earlier versions. */
  warnings?: { id: string; text: string }[];
  n_breaks: number;
  breaking_frequency: number | null;
  breaking_length_quantiles: number[];
  /** These three are absent in files of earlier versions. */
  overload_quantiles?: number[];
  sheets?: Record<string, number>;
  verdicts?: { kept: number; controls: number; late: number; latest: number };
  piece_area_quantiles: number[];
  quantile_levels: number[];
  n_floes_born: number;
  n_floes_present: number;
  n_floes_crushed: number;
  n_floes_broken: number;
  failure_model_range: { n_substepped: number; n_below: number; n_above: number };
  n_outlines_refused: number;
  n_steps_too_long: number;
  fastest_floe: number | null;
  ledger: Record<string, string | number | boolean>;
  energy: { work: number; losses: Record<string, number>; [key: string]: number | Record<string, number> };
}

export interface ClosedForm {
  method: string;
  source: string;
  horizontal?: number;
  vertical?: number;
  components?: Record<string, number>;
  not_applicable?: string;
  in_range?: boolean;
}

export interface Spectrum {
  frequency: number[];
  density: number[];
  /** How many lines the estimate has; of many, the lowest and the highest of narrow bands are here. */
  n_lines?: number;
  factors_95: [number, number];
  n_segments: number;
}

export interface Schema {
  properties: Record<string, SchemaKey>;
}

export interface SchemaKey {
  description?: string;
  properties?: Record<string, SchemaKey>;
  "x-unit"?: string;
  [key: string]: unknown;
}

export type LoadName = "Fx" | "Fy" | "Fz" | "Mx" | "My" | "Mz";

/** One rise of a load from its mean to a peak and back. */
export interface LoadEvent {
  start: number;
  end: number;
  peak_time: number;
  peak: number;
  impulse: number;
}

/** A law of extremes with the level that it gives, or why it gives none. */
export interface ExtremeLaw {
  law: string | null;
  reason?: string;
  not_fitted?: string;
  level?: number;
  level_95?: [number | null, number | null];
}

/** Statistics of one load, with the keys of `brash stats --json`. */
export interface LoadStatistics {
  mean: number;
  mean_95: [number, number] | [null, null];
  standard_deviation: number;
  minimum: number;
  maximum: number;
  skewness: number;
  quantile_50: number;
  quantile_95: number;
  quantile_99: number;
  autocorrelation_time: number;
  effective_sample_size: number;
  extremes: { return_period: number };
  laws: ExtremeLaw[];
  recommended: ExtremeLaw;
  warnings: string[];
  events: LoadEvent[];
  /** Null: the history is too short for it. */
  spectrum: Spectrum | null;
  /** The load acts towards its lower end: high quantiles, events and levels are of that end. */
  lower_end: boolean;
}

/** A run as its files say. Null: it is over before its statistics begin. */
export interface RunFiles {
  kind: "run";
  /** Preset and program, as every table of the command names them. */
  origin: string;
  manifest: Manifest;
  summary: RunSummary;
  closed_forms: { kind: string; loads: ClosedForm[] };
  loads: Record<LoadName, LoadStatistics> | null;
  /** The `load` blocks have `n` rows: all, or of each `span` of rows those with an extreme of a drawn load. */
  drawn_rows: { n: number; span: number };
}

export interface RunData extends RunFiles {
  schema: Schema;
  blocks: BlockEntry[];
  /** A history that is drawn over Fx: `measured.time`, `measured.value`. */
  measured?: { name: string; statistics: LoadStatistics } | null;
  /** A run beside this one, its arrays under names that begin with `other.`. */
  other?: RunFiles;
}

/** A run in progress: its arrays are streamed. */
export interface LiveData {
  kind: "live";
  origin: string;
  manifest: Manifest;
  schema: Schema;
  blocks: BlockEntry[];
}

export interface CampaignColumn {
  n: number;
  mean: number | null;
  standard_deviation: number | null;
  mean_95: [number, number] | null;
}

export interface CampaignSetting {
  setting: string;
  case: string;
  values: Record<string, number | string | boolean | number[]>;
  n_done: number;
  n_failed: number;
  stopped_by?: string;
  /** How many of its runs have a warning, by its id. */
  warnings?: Record<string, number>;
  statistics: Record<string, CampaignColumn>;
}

export interface CampaignData {
  kind: "campaign";
  /** Of all cases; empty in campaigns of earlier versions. */
  origin: string;
  manifest: Manifest & Record<string, unknown>;
  summary: { n_cases: number; n_done: number; n_failed: number; settings: CampaignSetting[] };
  schema: Schema;
  table: string;
  reports: string[];
  blocks: BlockEntry[];
}

export type PageData = RunData | CampaignData | LiveData;

export type Numbers = Float64Array | Float32Array | Int32Array;
