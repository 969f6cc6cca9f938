// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "brash/io/results.hpp"

/// A small run with every kind of thing in it: a floe with a hole, a deleted and an outside floe, frames without floes.
inline brash::model::RunResults sample_results() {
  using namespace brash;
  using namespace brash::io;
  using namespace brash::model;
  RunResults results;
  for (int i = 1; i <= 5; ++i) {
    LoadRow row;
    row.time = 0.01 * i;
    row.total = {{1.0 / 3.0 * i, -2.5, 1e5 * i}, {0.1, 0.2, -0.0}};
    row.crushing = {{0.1 * i, 0.2, 0.3}, {1.0, 2.0, 3.0}};
    row.floe_normal = {{1.1, 1.2, 1.3 * i}, {4.0, 5.0, 6.0}};
    row.floe_friction = {{2.1, 2.2, 2.3}, {7.0, 8.0, 9.0 * i}};
    row.kinetic_energy = 12.5;
    row.potential_energy = 0.25;
    row.work = 1e3 * i;
    row.birth_energy = 0.125;
    row.removed_energy = 0.5 * i;
    row.losses = {1.5, 2.5 * i, 3.5, 4.5, 5.5, 6.5, 7.5, -8.5, 9.5, 10.5};
    row.energy_error = -1e-3 * i;
    row.area_sheet = 2500.0 - i;
    row.area_floes = i;
    row.area_crushed = 1e-9;
    row.area_deleted = 0.5;
    row.area_brash = 0.03;
    row.area_snap = -1e-18;
    row.n_floes = i;
    row.n_contacts = 2 * i;
    row.structure = {-6.5 * i, 0.25};
    row.velocity = {1.5, -0.125};
    results.loads.push_back(row);
  }
  CrackEvent event;
  event.time = 0.02;
  event.at = {0.1, -0.2};
  event.depth = 0.5;
  event.contact_length = 0.3;
  event.angle = 1.0471975511965976;
  event.fit_error = 0.011;
  event.mu1 = 0.511;
  event.mu2 = 0.027;
  event.pressure = 5e5;
  event.sigma_max = 5.4e5;
  event.breaking_length = 1.7;
  event.wedges = 4;
  event.edge_age = 0.25;
  event.edge_deflection = 0.0625;
  event.thickness = 0.375;
  event.flexural_strength = 4.9e5;
  event.overload = 1.0625;
  event.pieces = 5;
  event.substeps = 2;
  event.area_before = 2499.0;
  event.area_after = 2495.5;
  event.tip = {0.2, -0.2};
  event.towards = {0.6, -0.8};
  results.events.push_back(event);
  event.time = 0.04;
  event.in_range = false;
  results.events.push_back(event);

  const std::vector<Vec2> square{{-1, -1}, {1, -1}, {1, 1}, {-1, 1}};
  const std::vector<Vec2> hole{{-0.1, -0.1}, {-0.1, 0.1}, {0.1, 0.1}};
  results.floes.push_back({0, {square, hole}, 3.98, 0.0, 0.05, FloeEnd::kAlive, 1e5, {{1, 2, -0.1}, {0.8, 0, 0, 0.6}}});
  results.floes.push_back({1, {{{0, 0}, {1, 0}, {0, 1}}}, 0.5, 0.02, 0.03, FloeEnd::kCrushed, 1.25e6});
  results.floes.push_back({7, {square}, 4.0, 0.02, 0.04, FloeEnd::kBroken, 0.0, {}, 0, 0.375});
  results.frames.push_back({0.0, {{-7, 0, 0}, {}}, {}});
  results.frames.push_back({0.02, {{-6.9, 0, 0}, {}}, {{0, {{1, 2, 3}, {0.5, 0.5, 0.5, 0.5}}}, {7, {{4, 5, 6}, {}}}}});
  results.frames.push_back({0.04, {{-6.8, 0, 0}, {}}, {{0, {{1.5, 2, 3}, {0, 1, 0, 0}}, 1.5e4}}});
  results.cracked_sheets.push_back({0.02, {{{0, -25}, {50, -25}, {50, 25}, {0.1, 25}}}});
  results.cracked_sheets.push_back({0.04, {{{0, -25}, {50, -25}, {50, 25}, {0.1, 24}}, hole}});
  results.initial_sheet = {{{0, -25}, {50, -25}, {50, 25}, {0, 25}}};
  results.final_sheet = {{{0, -25}, {50, -25}, {50, 25}, {0, 25}}, hole};
  return results;
}
