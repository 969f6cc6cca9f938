// SPDX-License-Identifier: GPL-3.0-or-later
// Not a test: the breaking load and the breaking length of three models on edges of real runs, to first order and
// without radial cracks. The reference is the true edge on the fine mesh. The numbers of
// docs/theory/fracture-of-the-edge.md.
//
//   edge_study [first seed] [last seed] [least steps between contacts]

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <optional>
#include <utility>
#include <vector>

#include "brash/core/constants.hpp"
#include "brash/plate/sheet.hpp"
#include "edge_of_run.hpp"
#include "outline_sheet.hpp"
#include "weak_places.hpp"

namespace {

using namespace brash;

/// The stress over the strength, and the breaking length over l_c.
struct Answer {
  double stress = 0.0;
  double length = 0.0;
};

/// The answers of a solved sheet, on the centre line and all around B.
struct OnSheet {
  Answer line, anywhere;
};

/// The judgements of one contact.
struct Judged {
  Answer trapezoid;
  OnSheet fast, fine;
  double joint = 0.0;  ///< stress under all loads of the structure, fast mesh, over the strength
  bool clamped = false;
};

std::optional<OnSheet> on_sheet(const failure::LoadCase& load, const failure::IceProperties& ice,
                                plate::Accuracy accuracy) {
  plate::LoadedSheet sheet = failure::loaded_sheet(load, ice, false);
  sheet.accuracy = accuracy;
  const auto solution = plate::solve(sheet);
  if (!solution) return std::nullopt;
  const failure::OwnPlaces own(failure::loads_of(load, ice.thickness), ice);
  const auto stresses = failure::stresses_ahead(sheet, *solution, ice, own);
  if (!stresses) return std::nullopt;
  OnSheet result{{stresses->largest, stresses->place}, {stresses->largest, stresses->place}};
  const auto weakest = failure::weak_places(sheet, *solution, ice, own).weakest();
  if (weakest && weakest->stress > stresses->largest) result.anywhere = {weakest->stress, norm(weakest->at)};
  return result;
}

/// Nothing where the sheet cannot be solved.
std::optional<Judged> judge(const edge::EdgeModel& model, const geometry::IceSheet& sheet,
                            const std::vector<edge::EdgeContact>& contacts, std::size_t i) {
  failure::LoadCase alone = contacts[i].load, joint = contacts[i].load;
  if (!edge::place_loads(model, sheet, contacts, i, false, alone) ||
      !edge::place_loads(model, sheet, contacts, i, true, joint))
    return std::nullopt;
  const failure::Assessment quick = model.criterion.assess(contacts[i].load);
  const auto fast = on_sheet(alone, model.ice, plate::Accuracy::kFast);
  const auto fine = on_sheet(alone, model.ice, plate::Accuracy::kFine);
  const auto all = on_sheet(joint, model.ice, plate::Accuracy::kFast);
  if (!fast || !fine || !all) return std::nullopt;
  const double l_c = failure::characteristic_length(model.ice);
  return Judged{.trapezoid = {quick.sigma_max / model.ice.flexural_strength, quick.breaking_length / l_c},
                .fast = *fast,
                .fine = *fine,
                .joint = all->line.stress,
                .clamped = quick.below_range || quick.above_range};
}

void print(const char* name, std::vector<double> values, double unit) {
  std::ranges::sort(values);
  const auto quantile = [&](double share) {
    return unit * values[static_cast<std::size_t>(std::lround(share * static_cast<double>(values.size() - 1)))];
  };
  std::printf("%-34s median %8.3f  95 %% %8.3f  99 %% %8.3f  worst %8.3f\n", name, quantile(0.5), quantile(0.95),
              quantile(0.99), quantile(1.0));
}

/// Errors of the contacts whose stress is at least `least` of the strength, with all loads on the sheet.
void table(const std::vector<Judged>& judged, double least) {
  std::vector<double> load[2], length[2], signed_load, lowered, load_anywhere, length_anywhere, line_too_high;
  int n_clamped = 0;
  for (const Judged& one : judged) {
    if (one.joint < least) continue;
    const Answer* model[2] = {&one.trapezoid, &one.fast.line};
    for (int i = 0; i < 2; ++i) {
      load[i].push_back(std::abs(one.fine.line.stress / model[i]->stress - 1.0));
      length[i].push_back(std::abs(model[i]->length - one.fine.line.length));
    }
    load_anywhere.push_back(std::abs(one.fine.anywhere.stress / one.fast.anywhere.stress - 1.0));
    length_anywhere.push_back(std::abs(one.fast.anywhere.length - one.fine.anywhere.length));
    line_too_high.push_back(one.fine.anywhere.stress / one.fine.line.stress - 1.0);
    signed_load.push_back(one.fine.line.stress / one.trapezoid.stress - 1.0);
    lowered.push_back(1.0 - one.fast.line.stress / one.joint);
    n_clamped += one.clamped ? 1 : 0;
  }
  std::printf("\n%zu contacts with at least %.2f of the strength; %d outside the superposition's range\n",
              load[0].size(), least, n_clamped);
  if (load[0].empty()) return;
  print("load, trapezoid [%]", load[0], 100.0);
  print("load, trapezoid, signed [%]", signed_load, 100.0);
  print("load, fast sheet [%]", load[1], 100.0);
  print("length, trapezoid [l_c]", length[0], 1.0);
  print("length, fast sheet [l_c]", length[1], 1.0);
  print("load, fast sheet, anywhere [%]", load_anywhere, 100.0);
  print("length, fast sheet, anywhere [l_c]", length_anywhere, 1.0);
  print("load, centre line too high by [%]", line_too_high, 100.0);
  print("lowered by the other loads [%]", lowered, 100.0);
}

/// The contacts whose trapezoid has at least 5 % of the strength. Most of the others have just touched the edge.
std::vector<std::size_t> bearing(const edge::EdgeModel& model, const std::vector<edge::EdgeContact>& contacts) {
  std::vector<std::size_t> result;
  for (std::size_t i = 0; i < contacts.size(); ++i) {
    const failure::LoadCase& load = contacts[i].load;
    if (load.pressure > 0.0 && model.criterion.assess(load).sigma_max > 0.05 * model.ice.flexural_strength)
      result.push_back(i);
  }
  return result;
}

void print(const failure::LoadCase& load, const Judged& one) {
  std::printf("b %.3f c %.3f m theta %.0f: trapezoid %.4f %.3f", load.depth, load.contact_length,
              load.angle / radians(1.0), one.trapezoid.stress, one.trapezoid.length);
  for (const auto& [name, sheet] : {std::pair{"fast", one.fast}, std::pair{"fine", one.fine}})
    std::printf(" %s %.4f %.3f anywhere %.4f %.3f", name, sheet.line.stress, sheet.line.length, sheet.anywhere.stress,
                sheet.anywhere.length);
  std::printf(" joint %.4f%s\n", one.joint, one.clamped ? " clamped" : "");
}

/// Judges one contact at a time, at least `pause` steps apart.
void judge_run(int seed, int pause, std::vector<Judged>& judged, int& n_refused) {
  testing::EdgeOfRun run(seed);
  const auto trapezoid = failure::make_criterion(model::FailureModel::kSuperposition, "", run.ice);
  const edge::EdgeModel model{*run.hull, run.resolved, run.ice, *trapezoid};
  std::size_t turn = 0;
  for (int step = 0, next = pause; !run.is_over(); ++step, (void)run.step()) {
    if (step < next) continue;
    const geometry::IceSheet sheet = run.next_sheet(model);
    const auto contacts = run.next_contacts(model, sheet);
    const std::vector<std::size_t> loaded = bearing(model, contacts);
    next = step + (loaded.empty() ? 2 : pause);
    if (loaded.empty()) continue;
    const std::size_t i = loaded[turn++ % loaded.size()];
    std::printf("%d %.2f s ", seed, run.simulation.time());
    if (const auto one = judge(model, sheet, contacts, i)) {
      judged.push_back(*one);
      print(contacts[i].load, *one);
    } else {
      ++n_refused;
      std::printf("no sheet\n");
    }
    std::fflush(stdout);
  }
}

}  // namespace

int main(int argc, char** argv) {
  const int first = argc > 1 ? std::atoi(argv[1]) : 101, last = argc > 2 ? std::atoi(argv[2]) : 105;
  const int pause = argc > 3 ? std::atoi(argv[3]) : 10;
  std::vector<Judged> judged;
  int n_refused = 0;
  for (int seed = first; seed <= last; ++seed) {
    judge_run(seed, pause, judged, n_refused);
    std::printf("\nUp to seed %d: %zu contacts, %d sheets refused\n", seed, judged.size(), n_refused);
    for (const double least : {0.0, 0.5}) table(judged, least);
  }
}
