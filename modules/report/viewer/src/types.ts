// SPDX-License-Identifier: GPL-3.0-or-later
// What stands in the page's data, as modules/report/src writes it. SI throughout.

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
  horizontal: LoadSummary;
  vertical: LoadSummary;
  mean_whole_history: { horizontal: number; vertical: number };
  /** Absent in files of earlier versions. */
  warnings?: { id: string; text: string }[];
  n_breaks: number;
  breaking_frequency: number | null;
  breaking_length_quantiles: number[];
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
  factors_95: [number, number];
  n_segments: number;
}

export interface AxisStatistics {
  spectrum: Spectrum | null;
  peaks: { value: number[]; time: number[] };
}

export interface Schema {
  properties: Record<string, { description?: string; properties?: Record<string, SchemaKey> }>;
}

export interface SchemaKey {
  description?: string;
  "x-unit"?: string;
  [key: string]: unknown;
}

export interface RunData {
  kind: "run";
  manifest: Manifest;
  summary: RunSummary;
  schema: Schema;
  closed_forms: { kind: string; loads: ClosedForm[] };
  statistics: { horizontal: AxisStatistics; vertical: AxisStatistics } | null;
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
  manifest: Manifest & Record<string, unknown>;
  summary: { n_cases: number; n_done: number; n_failed: number; settings: CampaignSetting[] };
  schema: Schema;
  table: string;
  reports: string[];
  blocks: BlockEntry[];
}

export type Numbers = Float64Array | Float32Array | Int32Array;
