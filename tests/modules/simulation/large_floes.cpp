// SPDX-License-Identifier: GPL-3.0-or-later
// Large floes of a field are plates that drift, meet and break; docs/theory/ice.md, fracture-of-floes.md.
#include <boost/test/unit_test.hpp>
#include <cmath>
#include <filesystem>
#include <fstream>
#include <numeric>

#include "brash/io/case.hpp"
#include "brash/simulation/initial_floes.hpp"
#include "brash/simulation/run.hpp"
#include "brash/simulation/simulation.hpp"

namespace {

using namespace brash;
namespace tt = boost::test_tools;

/// A folder with a file of ice.
struct IceFile {
  explicit IceFile(const std::string& wkt) {
    std::filesystem::create_directories(folder);
    std::ofstream(path) << wkt << '\n';
  }
  ~IceFile() { std::filesystem::remove_all(folder); }
  IceFile(const IceFile&) = delete;
  IceFile& operator=(const IceFile&) = delete;

  std::filesystem::path folder = std::filesystem::temp_directory_path() / "brash_large_floes";
  std::string path = (folder / "ice.wkt").string();
};

model::Case field_case(const IceFile& file, const std::vector<std::string>& more) {
  std::vector<std::string> overrides{"field.file=" + file.path};
  overrides.insert(overrides.end(), more.begin(), more.end());
  return io::read_case(BRASH_SOURCE_DIR "/tests/experiments/field-of-file.toml", overrides);
}

/// The case as level ice with free borders, laid by the same file.
model::Case as_level_ice(model::Case c) {
  c.field.kind = model::FieldKind::kLevelIce;
  c.field.border = model::Border::kFree;
  c.field.initial_crack = false;
  return c;
}

constexpr const char* kOneFloe = "POLYGON ((0 -25, 60 -30, 70 10, 50 30, 0 25, 0 -25))";
/// Gaps of 0.2 m before the wall at x = 90 and between the floes.
constexpr const char* kThreeFloes =
    "MULTIPOLYGON (((59.8 -20, 89.8 -20, 89.8 20, 59.8 20, 59.8 -20)),"
    "((29.6 -22, 59.6 -22, 59.6 22, 29.6 22, 29.6 -22)),((4.4 -18, 29.4 -18, 29.4 18, 4.4 18, 4.4 -18)))";
const std::vector<std::string> kBay{"field.length=90",
                                    "field.width=90",
                                    "field.border=walls",
                                    "wind.velocity=[25, 0]",
                                    "structure.start_distance=200",
                                    "structure.speed=0.01",
                                    "time.step=0.05",
                                    "time.duration=200"};

BOOST_AUTO_TEST_SUITE(large_floes)

BOOST_AUTO_TEST_CASE(a_field_of_one_large_floe_has_the_history_of_that_floe_laid_as_level_ice_with_free_borders) {
  const IceFile file(kOneFloe);
  // The cheapest judge: whoever judges, both go through the same stages.
  const model::Case field =
      field_case(file, {"field.length=70", "field.width=60", "time.duration=3", "failure.model=wedge",
                        "failure.pattern=disc", "failure.judged=centre-line", "failure.order=circumferential-first",
                        "failure.edge=static", "failure.second_order=false", "failure.joint_loads=false"});
  simulation::Simulation floe(field), sheet(as_level_ice(field));
  BOOST_TEST(floe.initial_births().empty());
  BOOST_REQUIRE(floe.sheet_motions().size() == 1u);
  int n_events = 0;
  double most = 0.0;
  for (int i = 0; i < 300; ++i) {
    const simulation::StepReport one = floe.step(), other = sheet.step();
    BOOST_TEST_REQUIRE((one.loads == other.loads));  // every bit
    BOOST_TEST_REQUIRE(one.events.size() == other.events.size());
    for (std::size_t k = 0; k < one.events.size(); ++k) BOOST_TEST((one.events[k] == other.events[k]));
    n_events += static_cast<int>(one.events.size());
    most = std::max(most, norm(one.loads.total.force));
  }
  BOOST_TEST(n_events > 0);  // it breaks as a plate
  BOOST_TEST(most > 1e4);
  BOOST_TEST(floe.ledger().closes());
}

BOOST_AUTO_TEST_CASE(large_floes_are_plates_and_small_ones_are_not) {
  const IceFile file("MULTIPOLYGON (((10 -20, 40 -20, 40 20, 10 20, 10 -20)),((42 -3, 48 -3, 48 3, 42 3, 42 -3)))");
  const model::Case c = field_case(file, {"field.length=60", "field.width=60"});
  const simulation::InitialField ice = simulation::initial_field(c);
  BOOST_TEST(ice.sheets.size() == 1u);
  BOOST_TEST(ice.floes.size() == 1u);
  BOOST_TEST(ice.sheet_area == 1200.0);
  BOOST_TEST(ice.area == 36.0);
  simulation::Simulation simulation(c);
  BOOST_TEST(simulation.sheet_motions().size() == 1u);
  BOOST_TEST(simulation.initial_births().size() == 1u);
  BOOST_TEST(simulation.ledger().sheet.square_metres() == 1200.0);
  BOOST_TEST(simulation.ledger().floes.square_metres() == 36.0);
  model::Case rigid = c;
  rigid.field.smallest_plate = 1000.0;
  BOOST_TEST(simulation::initial_field(rigid).floes.size() == 2u);
  BOOST_TEST(simulation::Simulation(rigid).sheet_motions().empty());
}

BOOST_AUTO_TEST_CASE(plates_of_a_field_begin_with_the_current) {
  const IceFile file(kThreeFloes);
  std::vector<std::string> more = kBay;
  more.insert(more.end(), {"wind.velocity=[0, 0]", "water.current=[0.1, -0.05]"});
  simulation::Simulation simulation(field_case(file, more));
  double kinetic = 0.0;
  for (const model::SheetMotion& sheet : simulation.sheet_motions()) {
    BOOST_TEST((sheet.velocity == Vec2{0.1, -0.05}));
    kinetic += 0.5 * sheet.mass * dot(sheet.velocity, sheet.velocity);
  }
  // The balance has the energy that they begin with; round-off of its sums.
  const model::LoadRow row = simulation.step().loads;
  BOOST_TEST(row.birth_energy == kinetic, tt::tolerance(1e-12));
  BOOST_TEST(std::abs(row.energy_error) < 1e-9 * kinetic);
}

BOOST_AUTO_TEST_CASE(wind_jams_a_row_of_plates_against_a_wall_and_they_come_to_rest_side_by_side) {
  const IceFile file(kThreeFloes);
  const model::Case c = field_case(file, kBay);
  simulation::Simulation whole(c);
  double lost = 0.0, error = 0.0;
  for (int i = 0; i < 4000; ++i) {
    const simulation::StepReport report = whole.step();
    lost = report.loads.losses.sheet_contact;
    error = report.loads.energy_error;
  }
  const std::vector<model::SheetMotion> row = whole.sheet_motions();
  BOOST_REQUIRE(row.size() == 3u);
  // Closed gaps: the wall at 90 m, plates of 30, 30 and 25 m. A first touch is found within a step, and the blow of
  // some centimetres a second crushes millimetres.
  const double gap_of_first = 90.0 - (row[0].centre.x + 15.0);
  const double gap_of_second = row[0].centre.x - row[1].centre.x - 30.0;
  const double gap_of_third = row[1].centre.x - row[2].centre.x - 27.5;
  for (const double gap : {gap_of_first, gap_of_second, gap_of_third}) {
    BOOST_TEST(gap < 1e-3);
    BOOST_TEST(gap > -0.02);
  }
  for (const model::SheetMotion& sheet : row) BOOST_TEST(norm(sheet.velocity) < 1e-4);
  BOOST_TEST(lost > 0.0);
  BOOST_TEST(std::abs(error) < 1e-6 * lost);
}

BOOST_AUTO_TEST_CASE(a_resumed_run_with_plates_that_meet_goes_on_to_the_bit) {
  const IceFile file(kThreeFloes);
  const model::Case c = field_case(file, kBay);
  simulation::Simulation whole(c);
  for (int i = 0; i < 700; ++i) static_cast<void>(whole.step());
  simulation::Simulation resumed(c, whole.checkpoint());
  for (int i = 0; i < 200; ++i) {
    const simulation::StepReport one = whole.step(), other = resumed.step();
    BOOST_TEST_REQUIRE((one.loads == other.loads));
  }
  BOOST_TEST((whole.checkpoint() == resumed.checkpoint()));
  BOOST_TEST(whole.step().loads.losses.sheet_contact > 0.0);
}

BOOST_AUTO_TEST_CASE(a_run_through_plates_and_floes_closes_its_ledger_and_its_energies) {
  const model::Case c =
      io::read_case(BRASH_SOURCE_DIR "/experiments/fields/cone.toml",
                    {"field.length=80", "field.width=80", "field.concentration=0.7", "field.size.least=6",
                     "field.size.largest=30", "time.duration=8", "time.step=0.01", "structure.start_distance=7",
                     "output.frames_per_second=1", "output.statistics_from=0"});
  const simulation::InitialField ice = simulation::initial_field(c);
  BOOST_TEST(ice.sheets.size() > 1u);
  BOOST_TEST(ice.floes.size() > 3u);
  const simulation::Run run = simulation::run(c);  // its watchdog looks at each step
  BOOST_TEST(run.complete);
  BOOST_TEST(run.summary.ledger.closes());
  BOOST_REQUIRE(run.summary.initial_floes.has_value());
  BOOST_TEST(run.summary.initial_floes->n == static_cast<int>(ice.sheets.size() + ice.floes.size()));
  BOOST_TEST(run.summary.initial_floes->concentration == (ice.area + ice.sheet_area) / 6400.0, tt::tolerance(1e-9));
  BOOST_TEST(run.results.loads.back().area_sheet < ice.sheet_area);  // plates have broken or been crushed
}

BOOST_AUTO_TEST_SUITE_END()

}  // namespace
