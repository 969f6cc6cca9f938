// SPDX-License-Identifier: GPL-3.0-or-later
// The stages of a step, each a function of the state that the one before it left. step.cpp has their order.
#pragma once

#include <vector>

#include "state.hpp"

namespace brash::simulation {

/// One time step; docs/theory/simulation.md.
void take(Step& step, State& s, const Laws& laws);

// edge_stage.cpp: where structure and floes load the edge of level ice, and whether it fails.

edge::EdgeModel edge_model(const State& s, const Laws& laws, const ice::Plate& plate);
/// Moves the structure by the largest part of `share` of the step that keeps within two limits; `share` becomes that
/// part. Contacts stay below the failure model's upper range (Sec. 2.2.2: "a shorter time step can avoid it"). It
/// cannot where a contact is above already: the step is then left whole. And no ice is loaded far beyond its strength,
/// as far as the verdicts before can show: docs/theory/simulation.md, (S7). The trailing outlines then crush the ice
/// that they cover. So the contacts belong to the state that is reached, however short or long the step.
/// @param done  share of the step before.
/// @return the structure's contacts with level ice, without a verdict.
std::vector<edge::EdgeContact> move_within_limits(State& s, const Laws& laws, double done, double& share, Step& step);
/// A part of the step loads the structure by crushing (Eq. 15), and edges that move follow its loads.
void crush_edges(State& s, const Laws& laws, std::vector<edge::EdgeContact>& contacts, double done, double share,
                 Step& step);
/// Adds the edges of level ice under the floes that press on them, by their forces up to the step before. In the order
/// of the floes; without a verdict.
void add_contacts_of_floes(const State& s, const Laws& laws, std::vector<edge::EdgeContact>& contacts);
/// Finds the verdicts on the contacts of each level ice together (Eqs. 17 to 19, or the plate). The most stressed one
/// is first then where loads act together: it breaks the ice first.
void judge(State& s, const Laws& laws, std::vector<edge::EdgeContact>& contacts, double now, Step& step);
/// The plane of the ice has an end, and so has the motion of a body that another program or its loads throw about.
/// @throws RunError beyond it.
void expect_on_the_plane(const State& s, const Laws& laws);

// break_stage.cpp: level ice breaks, is crushed, and becomes floes.

/// Fig. 5: the ice has broken once before the structure comes; ahead of each leg that has a way of its own, along the
/// course at the start.
void initial_crack(State& s, const Laws& laws, Step& step);
/// The structure has penetrated the whole thickness of the ice that the trailing outlines cover. This ice is crushed
/// and leaves its plate, and the parts that it has held continue on their own. @return whether there was any.
bool crush_passed_ice(State& s, const Laws& laws, double time, Step& step);
/// Breaks the ice at every contact whose stress exceeds the flexural strength, in the contacts' order. A contact as
/// near to a break of this step as its crack reaches is left to the next step.
void break_ice(State& s, const Laws& laws, const std::vector<edge::EdgeContact>& contacts, Step& step);
/// A piece of level ice becomes a body of its own: a floe, or a large piece of a drifting sheet another sheet.
void let_float(State& s, const Laws& laws, ice::Plate&& piece, int level_ice, std::vector<model::FloeRecord>& births,
               Step& step);
/// The outline of level ice has changed: collision shapes and mass follow.
void follow_outline(State& s, const ice::Plate& plate, const geometry::Extent& changed);

// sheet_stage.cpp: sheets with free borders move, take their loads, split, and become floes when they are small.

/// Where the level ice is. A sheet that drifts is rounded to the grid again.
std::vector<geometry::Polygon> outlines_in_world(const State& s);
/// An event of level ice that drifts, where it was.
model::CrackEvent in_world(const State& s, int level_ice, model::CrackEvent event);
/// Whether the hull comes near the box of level ice. Fast ice is large, and always counts as near.
bool is_near(const State& s, const Laws& laws, const ice::Plate& plate, const structure::State& seen);
/// The collision shapes of level ice wherever the floe could meet them, or be in their lee, in this step.
void lay_sheet_near(State& s, const Laws& laws, BodyId body);
/// Sheets and their collision shapes go into the step of the bodies.
void hand_over_sheets(State& s, const Laws& laws);
/// The step of the bodies has found the velocities of the sheets.
void take_back_sheets(State& s, const Laws& laws);
/// Sheets split whose toughness the structure's splitting force exceeds; docs/theory/fracture-of-floes.md, (G6), (G7),
/// (G8).
void split_sheets(State& s, const Laws& laws, const std::vector<edge::EdgeContact>& contacts, Step& step);
/// A sheet that has become small becomes a floe.
void release_small_sheets(State& s, const Laws& laws, Step& step);

// floe_stage.cpp: floes float, sleep, are crushed and split.

/// The floes that are there at the start. @return their records.
std::vector<model::FloeRecord> lay_floes(State& s, const Laws& laws);
/// A field that nothing drives rests until the structure comes.
void begin_asleep(State& s, const Laws& laws);
void fall_asleep_or_wake(State& s, const Laws& laws, Step& step);
/// Contact forces as each floe's stress takes them, and averaged over its collision time: its bending, and its load on
/// level ice.
void average_contacts(State& s, const Laws& laws, Step& step);
/// Floes whose compressive stress exceeds sigma_c are crushed and leave (Sec. 2.2.1).
void remove_crushed_floes(State& s, const Laws& laws, Step& step);
/// Floes split whose bending tension exceeds the flexural strength.
void split_floes(State& s, const Laws& laws, Step& step);

}  // namespace brash::simulation
