// SPDX-License-Identifier: GPL-3.0-or-later
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <exception>
#include <stdexcept>
#include <string>

#include "corpus.hpp"
#include "peers.hpp"
#include "soak_sequences.hpp"

// How often each library fails on the named corpus and on random adversarial sequences (argument: how many, 100).
// Every library gets the same sheet, the kernel's, at every cut: one failure does not become many.
namespace {

using namespace brash;
using namespace brash::benchmarks;
using geometry::IceSheet;

struct Failures {
  int refused = 0;
  int thrown = 0;
  int invalid = 0;
  int wrong_area = 0;       ///< By more than 1e-9 of the sheet's.
  int absurd_area = 0;      ///< By more than 1e-3.
  double worst_area = 0.0;  ///< Error over the area of the sheet.
};

class Tally {
 public:
  explicit Tally(const char* title) : title_(title), failures_(peers().size()) {}

  void cut(const std::vector<geometry::Polygon>& ice, const geometry::Ring& region) {
    double before = 0.0;
    for (const geometry::Polygon& polygon : ice) before += geometry::area(polygon).square_metres();
    const double exact = exact_area(ice, region);
    ++n_cuts_;
    for (std::size_t i = 0; i < peers().size(); ++i) {
      Failures& failures = failures_[i];
      try {
        const Loops rest = peers()[i].difference(ice, region);
        if (!are_simple(rest)) ++failures.invalid;
        const double error = std::abs(exact_area(rest) - exact) / before;
        if (error > 1e-9) ++failures.wrong_area;
        if (error > 1e-3) ++failures.absurd_area;
        failures.worst_area = std::max(failures.worst_area, error);
      } catch (const Refused&) {
        ++failures.refused;
      } catch (const std::exception&) {
        ++failures.thrown;
      }
    }
  }

  void print() const {
    std::printf(
        "\n%s, %d cuts\n\n| kernel | input refused | exceptions | invalid loops | area off by > 1e-9 | by > 1e-3 | "
        "largest |\n",
        title_, n_cuts_);
    std::printf("|---|---|---|---|---|---|---|\n");
    for (std::size_t i = 0; i < peers().size(); ++i) {
      const Failures& f = failures_[i];
      std::printf("| %s | %d | %d | %d | %d | %d | %.1e |\n", peers()[i].name.c_str(), f.refused, f.thrown, f.invalid,
                  f.wrong_area, f.absurd_area, f.worst_area);
    }
  }

 private:
  const char* title_;
  int n_cuts_ = 0;
  std::vector<Failures> failures_;
};

Loops kernel_difference(const std::vector<geometry::Polygon>& ice, const geometry::Ring& region) {
  IceSheet sheet = IceSheet::from_polygons(ice).value();
  sheet.cut(region);
  Loops loops;
  const auto append = [&](const geometry::Ring& ring) {
    std::vector<Vec2>& loop = loops.emplace_back();
    for (const geometry::Point p : ring) loop.push_back(metres(p));
  };
  for (const geometry::Polygon& polygon : sheet.polygons()) {
    append(polygon.outline);
    for (const geometry::Ring& hole : polygon.holes) append(hole);
  }
  return loops;
}

const Registration kKernel("this one", kernel_difference);

void run_corpus() {
  // Sheets of a few grid units lose percents to any rounding. They show the behaviour of a kernel, not its accuracy.
  constexpr double kSmall = 1e-6;  // [m2]
  Tally tally("Named corpus, sheets of metres");
  Tally small("Named corpus, sheets of grid units");
  for (const corpus::Case& c : corpus::read_all()) {
    for (const corpus::Case& variant : corpus::variants(c)) {
      IceSheet sheet = IceSheet::from_polygons(variant.ice).value();
      for (const corpus::Event& event : variant.events) {
        if (event.region.empty()) {
          (void)sheet.release_detached();
          continue;
        }
        const std::vector<geometry::Polygon> ice = sheet.polygons();
        const bool is_small = sheet.area().square_metres() < kSmall;
        if (!ice.empty()) (is_small ? small : tally).cut(ice, event.region);
        sheet.cut(event.region, event.cracks);
      }
    }
  }
  tally.print();
  small.print();
}

void run_random(int n_sequences) {
  constexpr int kEvents = 30;
  Tally tally("Random adversarial sequences");
  for (int seed = 1; seed <= n_sequences; ++seed) {
    geometry::soak::Random random(static_cast<std::uint64_t>(seed));
    IceSheet sheet = IceSheet::from_polygons(geometry::soak::make_sheet(random)).value();
    geometry::soak::Events events;
    for (int i = 0; i < kEvents; ++i) {
      const std::vector<geometry::Polygon> ice = sheet.polygons();
      if (ice.empty()) break;
      const geometry::soak::Event event = events.next(random, ice);
      tally.cut(ice, event.region);
      sheet.cut(event.region, event.cracks);
    }
  }
  tally.print();
}

}  // namespace

std::vector<Peer>& brash::benchmarks::peers() {
  static std::vector<Peer> all;
  return all;
}

int main(int argc, char** argv) {
  run_corpus();
  run_random(argc > 1 ? std::atoi(argv[1]) : 100);
}
