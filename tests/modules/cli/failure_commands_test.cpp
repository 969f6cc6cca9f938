// SPDX-License-Identifier: GPL-3.0-or-later
#include <unistd.h>

#include <CLI/CLI.hpp>
#include <algorithm>
#include <boost/test/unit_test.hpp>
#include <cstdio>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <sstream>
#include <vector>

#include "brash/core/error.hpp"
#include "brash/failure/edge_responses.hpp"
#include "brash/failure/response_model.hpp"
#include "commands.hpp"

namespace brash::cli {
namespace {

namespace fs = std::filesystem;

const std::string kNetwork = BRASH_SOURCE_DIR "/experiments/failure_database/cone_network.json";
const std::string kSuperposition = BRASH_SOURCE_DIR "/experiments/failure_database/cone_superposition.json";

constexpr const char* kPlan = R"([design]
geometries = 33
rows_per_geometry = 2
edge_share = 0.06
[range]
b_lc = { from = 0.0, to = 1.0, spacing = "quadratic" }
c_lc = { from = 0.2, to = 1.0, spacing = "logarithmic" }
theta_deg = { from = 0.0, to = 90.0, spacing = "linear" }
mu1 = { from = 0.3, to = 1.0, spacing = "logarithmic" }
mu2 = { from = -0.1, to = 0.1, spacing = "linear" }
thickness_over_lc = 0.1
[plate]
poisson_ratio = 0.3
theory = "reissner-mindlin"
)";

constexpr const char* kRow = "b_lc,c_lc,theta_deg,mu1,mu2\n0.6,0.3,60,0.5,0.02\n";

/// A folder of its own for each test, removed afterwards.
struct Folder {
  fs::path path;
  explicit Folder(const std::string& name = "test")
      : path(fs::temp_directory_path() / ("brash_failure_" + name + "_" + std::to_string(::getpid()))) {
    fs::create_directories(path);
  }
  ~Folder() { fs::remove_all(path); }

  std::string write(const std::string& name, const std::string& text) const {
    std::ofstream(path / name, std::ios::binary) << text;
    return (path / name).string();
  }
  std::string read(const std::string& name) const {
    std::ifstream stream(path / name);
    return {std::istreambuf_iterator<char>(stream), std::istreambuf_iterator<char>()};
  }
};

/// Runs `brash failure ARGUMENTS` without the program around it; exceptions come through.
void run(std::vector<std::string> arguments) {
  CLI::App app;
  add_failure_command(app);
  arguments.insert(arguments.begin(), "failure");
  std::reverse(arguments.begin(), arguments.end());
  app.parse(arguments);
}

/// The output of `run`.
std::string output_of(const Folder& folder, const std::vector<std::string>& arguments) {
  const std::string file = (folder.path / "stdout").string();
  std::fflush(stdout);
  const int saved = ::dup(1);
  BOOST_REQUIRE(std::freopen(file.c_str(), "w", stdout) != nullptr);
  run(arguments);
  std::fflush(stdout);
  ::dup2(saved, 1);
  ::close(saved);
  return folder.read("stdout");
}

/// sigma/p of the only row of `text`, the sixth column.
double stress_of(const std::string& text) {
  std::string row = text.substr(text.find('\n') + 1);
  for (int i = 0; i < 5; ++i) row = row.substr(row.find(',') + 1);
  return std::stod(row);
}

BOOST_AUTO_TEST_CASE(the_models_that_come_with_the_program_predict_what_the_plate_gives) {
  const Folder folder;
  const std::string rows = folder.write("rows.csv", kRow);
  const double plate = stress_of(output_of(folder, {"predict", "--model", "fem", "--in", rows}));
  // Their 95 % errors there, from the model cards: 10 % (network), 2 % (deep network) and 1 % (superposition).
  BOOST_TEST(stress_of(output_of(folder, {"predict", "--model", kNetwork, "--in", rows})) == plate,
             boost::test_tools::tolerance(0.10));
  BOOST_TEST(stress_of(output_of(folder, {"predict", "--model", "deep-network", "--in", rows})) == plate,
             boost::test_tools::tolerance(0.02));
  BOOST_TEST(stress_of(output_of(folder, {"predict", "--model", kSuperposition, "--in", rows})) == plate,
             boost::test_tools::tolerance(0.01));
}

BOOST_AUTO_TEST_CASE(a_row_that_cannot_be_used_is_refused_with_its_line) {
  const Folder folder;
  const std::string rows = folder.write("rows.csv", "b_lc,c_lc,theta_deg,mu1,mu2\n0.6,0.3,60,0.5,0\n0.6,0,60,0.5,0\n");
  BOOST_CHECK_EXCEPTION(run({"predict", "--model", kNetwork, "--in", rows}), InputError, [](const InputError& error) {
    return std::string(error.what()).find("rows.csv:3: c_lc = 0 is not allowed\n  allowed: above 0") !=
           std::string::npos;
  });
}

/// A database of 33 geometries, solved once: as few as a superposition and its judge take.
const std::string& small_database() {
  static const Folder folder("database");
  static const std::string database = [] {
    const std::string path = (folder.path / "small.nc").string();
    output_of(folder, {"database", folder.write("plan.toml", kPlan), "-o", path});
    return path;
  }();
  return database;
}

/// kPlan with other geometries.
std::string plan_of(const std::string& geometries) {
  std::string plan = kPlan;
  return plan.replace(plan.find("geometries = 33"), 15, geometries);
}

/// Three geometries that small_database() does not have, solved once.
const std::string& unseen_database() {
  static const Folder folder("unseen");
  static const std::string database = [] {
    const std::string path = (folder.path / "unseen.nc").string();
    output_of(folder, {"database", folder.write("plan.toml", plan_of("geometries = 3\nfirst = 100")), "-o", path});
    return path;
  }();
  return database;
}

/// Runs `brash failure ARGUMENTS`, which must refuse them with all of `parts` in the message.
void refuses(const std::vector<std::string>& arguments, const std::vector<std::string>& parts) {
  BOOST_CHECK_EXCEPTION(run(arguments), InputError, [&](const InputError& error) {
    const std::string message = error.what();
    return std::ranges::all_of(parts, [&](const auto& part) { return message.find(part) != std::string::npos; });
  });
}

BOOST_AUTO_TEST_CASE(a_deep_network_is_trained_on_a_plan_and_judged_on_plates) {
  const Folder folder;
  const std::string model = (folder.path / "deep.json").string();
  const std::string plan = folder.write("deep.toml", plan_of("geometries = 60"));
  const std::vector<std::string> command{"train", plan, "--deep", "-o", model, "--hidden", "4", "--iterations", "3"};
  BOOST_CHECK_THROW(run(command), InputError);  // nothing to judge it with
  std::vector<std::string> whole = command;
  whole.insert(whole.end(), {"--test", unseen_database()});
  BOOST_TEST(output_of(folder, whole).find("far hump, ln(sigma_over_p)") != std::string::npos);
  const std::string card = folder.read("deep.md");
  BOOST_TEST(card.find("of 120 rows answered by `cone_superposition.json`") != std::string::npos);
  BOOST_TEST(card.find("    brash failure train deep.toml --output deep.json --deep --test unseen.nc --hidden 4 "
                       "--iterations 3\n") != std::string::npos);
  BOOST_TEST(folder.read("deep_errors.csv").find("\nall,6,3,") != std::string::npos);
  const std::string rows = folder.write("rows.csv", kRow);
  BOOST_TEST(stress_of(output_of(folder, {"predict", "--model", model, "--in", rows})) > 0.0);
}

BOOST_AUTO_TEST_CASE(a_deep_network_is_taught_only_plates_that_the_superposition_knows) {
  const Folder folder;
  const auto refuses_plan = [&](const std::string& line, const std::string& other, const std::string& part) {
    std::string plan = kPlan;
    plan.replace(plan.find(line), line.size(), other);
    refuses({"train", folder.write("deep.toml", plan), "--deep", "-o", (folder.path / "deep.json").string(), "--test",
             unseen_database()},
            {"deep.toml", part, "allowed:", "remedy:"});
  };
  refuses_plan("thickness_over_lc = 0.1", "thickness_over_lc = { from = 0.1, to = 0.2 }",
               "thickness_over_lc has a range");
  refuses_plan("poisson_ratio = 0.3", "poisson_ratio = 0.25", "poisson_ratio = 0.3");
  refuses_plan("reissner-mindlin", "kirchhoff", "theory = \"reissner-mindlin\"");
  refuses_plan("poisson_ratio = 0.3", "poisson_ratio = 0.3\nsplit = true", "split = true");
}

/// Columns of the rows of `text`, without its first line.
std::vector<std::vector<std::string>> rows_of(const std::string& text) {
  std::vector<std::vector<std::string>> rows;
  std::istringstream stream(text);
  std::string line;
  for (std::getline(stream, line); std::getline(stream, line);) {
    auto& row = rows.emplace_back();
    std::istringstream fields(line);
    for (std::string field; std::getline(fields, field, ',');) row.push_back(field);
  }
  return rows;
}

BOOST_AUTO_TEST_CASE(a_moving_edge_goes_from_a_plan_to_a_model_that_breaks_it) {
  const Folder folder;
  const std::string plan = folder.write("edge.toml",
                                        "[edge]\nb_lc = [0.0, 0.3]\nc_lc = [0.3, 0.6]\ntheta_deg = [40]\n"
                                        "thickness_over_lc = [0.1]\n[solver]\nscale = 1.5\nvectors = 60\n");
  const std::string data = (folder.path / "edge.nc").string(), model = (folder.path / "edge.json").string();
  const std::string printed = output_of(folder, {"database", plan, "-o", data});
  BOOST_TEST(printed.find("geometries  4") != std::string::npos);
  const std::string other =
      folder.write("test.toml",
                   "[edge]\nb_lc = [0.0, 0.2]\nc_lc = [0.4]\ntheta_deg = [40]\nthickness_over_lc = [0.1]\n"
                   "[solver]\nscale = 1.5\nvectors = 60\n");
  const std::string test = (folder.path / "test.nc").string();
  output_of(folder, {"database", other, "-o", test});
  refuses({"train", data, "-o", model, "--test", data}, {"edge.nc", "is of a plan that the model learns", "remedy:"});
  output_of(folder, {"train", data, "-o", model, "--test", test});
  const std::string card = folder.read("edge.md");
  BOOST_TEST(card.find("# Model card: edge.json") == 0u);
  BOOST_TEST(card.find("| whole, at rest | 2 |") != std::string::npos);
  BOOST_TEST(card.find("    brash failure train edge.nc --output edge.json --test test.nc\n") != std::string::npos);
  const auto errors = rows_of(folder.read("edge_errors.csv"));
  // Two responses and three numbers at each of six speeds, of all outlines and of the usual contacts.
  BOOST_TEST(errors.size() == 2u * (2u + 3u * 6u));
  for (const auto& row : errors) BOOST_TEST(row.size() == 9u);
  const std::string rows = folder.write("rows.csv", "b_lc,c_lc,theta_deg,mu1,mu2\n0.3,0.3,40,0.511,0\n");
  const auto of = [&](const std::string& of_model) {
    return rows_of(output_of(folder, {"predict", "--case", BRASH_SOURCE_DIR "/experiments/validation/cone.toml",
                                      "--speed", "0,1.2", "--in", rows, "--model", of_model}));
  };
  // The coarse model of four outlines, the one that comes with the program, and the plate on its water.
  const auto coarse = of(model), shipped = of(failure::edge_model_path()), plate = of("fem");
  BOOST_REQUIRE(plate.size() == 2u);
  for (std::size_t i = 0; i < 2; ++i) {
    BOOST_REQUIRE(plate[i].size() == 12u);
    for (const std::size_t column : {6, 8, 9}) {
      const double wanted = std::stod(plate[i][column]);
      BOOST_TEST(std::stod(shipped[i][column]) == wanted, boost::test_tools::tolerance(0.03));
      BOOST_TEST(std::stod(coarse[i][column]) == wanted, boost::test_tools::tolerance(0.10));
    }
  }
}

BOOST_AUTO_TEST_CASE(a_bay_is_solved_and_lies_outside_the_range_of_the_models) {
  const Folder folder;
  const std::string header = "b_lc,c_lc,theta_deg,mu1,mu2\n", straight = "0,0.3,60,0.5,0\n",
                    bay = "-0.4,0.3,60,0.5,0\n";
  const std::string rows = folder.write("rows.csv", header + bay), other = folder.write("other.csv", header + straight);
  const std::string solved = output_of(folder, {"predict", "--model", "fem", "--in", rows});
  BOOST_TEST(solved.find("true") != std::string::npos);
  BOOST_TEST(stress_of(solved) < 0.7 * stress_of(output_of(folder, {"predict", "--model", "fem", "--in", other})));
  const std::string looked_up = output_of(folder, {"predict", "--model", "superposition", "--in", rows});
  BOOST_TEST(looked_up.find("false") != std::string::npos);
}

BOOST_AUTO_TEST_CASE(an_inverse_thickness_is_refused_and_a_thickness_far_from_the_training_is_out_of_range) {
  const Folder folder;
  const auto rows = [&](const std::string& lc_over_h) {
    return folder.write("rows.csv", "b_lc,c_lc,theta_deg,mu1,mu2,lc_over_h\n0.5,0.3,60,0.5,0," + lc_over_h + "\n");
  };
  for (const char* const model : {"network", "fem"})
    refuses({"predict", "--model", model, "--in", rows("0.1")},
            {"rows.csv:2: lc_over_h = 0.1 is not allowed", "l_c / h of a plate, and not h / l_c", "remedy:"});
  const auto answer = [&](const std::string& lc_over_h) {
    return output_of(folder, {"predict", "--model", "network", "--in", rows(lc_over_h)});
  };
  // The network was trained with h / l_c = 0.1, and Eq. 19 scales it by a fifth.
  for (const char* const near : {"8.4", "10", "12.4"}) BOOST_TEST(answer(near).find("true") != std::string::npos);
  for (const char* const far : {"8.2", "12.6", "3"}) BOOST_TEST(answer(far).find("false") != std::string::npos);
  const auto plate = failure::make_response_model("fem");
  BOOST_TEST(plate->respond({.b_lc = 0.5, .c_lc = 0.3, .theta = 1.0, .mu1 = 0.5}, 0.3).in_range);
  BOOST_TEST(!plate->respond({.b_lc = 0.5, .c_lc = 0.3, .theta = 1.0, .mu1 = 0.5}, 10.0).in_range);
}

BOOST_AUTO_TEST_CASE(rows_may_begin_with_a_byte_order_mark) {
  const Folder folder;
  const std::string rows = folder.write("rows.csv", std::string("\xef\xbb\xbf") + kRow);
  const std::string printed = output_of(folder, {"predict", "--model", "network", "--in", rows});
  BOOST_TEST(printed.starts_with("b_lc,"));
}

BOOST_AUTO_TEST_CASE(a_moving_edge_takes_no_model_of_edges_at_rest) {
  const Folder folder;
  refuses({"predict", "--case", BRASH_SOURCE_DIR "/experiments/validation/cone.toml", "--speed", "1", "--in",
           folder.write("rows.csv", kRow), "--model", "network"},
          {"--model network: is a model of edges at rest", "allowed:", "leave --model out"});
}

BOOST_AUTO_TEST_CASE(speeds_need_a_case_and_a_case_states_the_thickness) {
  const Folder folder;
  BOOST_CHECK_THROW(run({"predict", "--speed", "1"}), CLI::ParseError);
  BOOST_CHECK_THROW(run({"predict"}), CLI::ParseError);
  const std::string rows = folder.write("rows.csv", "b_lc,c_lc,theta_deg,mu1,mu2,lc_over_h\n0.3,0.3,40,0.511,0,10\n");
  BOOST_CHECK_EXCEPTION(run({"predict", "--case", BRASH_SOURCE_DIR "/experiments/validation/cone.toml", "--speed", "1",
                             "--in", rows, "--model", "fem"}),
                        InputError, [](const InputError& error) {
                          return std::string(error.what()).find("lc_over_h") != std::string::npos;
                        });
}

BOOST_AUTO_TEST_CASE(keys_of_the_case_are_set_beside_it) {
  const Folder folder;
  const std::string rows = folder.write("rows.csv", "b_lc,c_lc,theta_deg,mu1,mu2\n0.3,0.3,40,0.511,0\n");
  const std::string name = BRASH_SOURCE_DIR "/experiments/validation/cone.toml";
  const auto load = [&](std::vector<std::string> more) {
    std::vector<std::string> arguments{"predict", "--case", name, "--speed", "0", "--in", rows};
    arguments.insert(arguments.end(), more.begin(), more.end());
    return std::stod(rows_of(output_of(folder, arguments))[0][6]);
  };
  // At rest the load grows as the strength does.
  BOOST_TEST(load({"--set", "ice.flexural_strength=1078e3"}) == 2.0 * load({}), boost::test_tools::tolerance(1e-4));
  BOOST_CHECK_THROW(run({"predict", "--model", "network", "--in", rows, "--set", "ice.thickness=0.4"}),
                    CLI::ParseError);
}

BOOST_AUTO_TEST_CASE(a_superposition_is_written_with_its_model_card) {
  const Folder folder;
  const std::string model = (folder.path / "small.json").string();
  const std::string printed = output_of(folder, {"train", small_database(), "-o", model, "--superposition"});
  BOOST_TEST(printed.find("small.md") != std::string::npos);
  BOOST_TEST(printed.find("6 rows of 3 geometries") != std::string::npos);
  const std::string card = folder.read("small.md");
  BOOST_TEST(card.find("# Model card: small.json") == 0u);
  BOOST_TEST(card.find("33 geometries") != std::string::npos);
  BOOST_TEST(card.find("[By range](small_errors.csv)") != std::string::npos);
  const auto errors = rows_of(folder.read("small_errors.csv"));
  BOOST_TEST(errors.at(0).at(0) == "all");
  BOOST_TEST(errors[0].at(1) == "6");  // geometries 10, 21 and 32, two rows each
  BOOST_TEST(errors[0].at(2) == "3");
  for (const auto& row : errors) BOOST_TEST(row.size() == 11u);
  const std::string rows = folder.write("rows.csv", kRow);
  BOOST_TEST(stress_of(output_of(folder, {"predict", "--model", model, "--in", rows})) > 0.0);
}

BOOST_AUTO_TEST_CASE(a_superposition_can_be_judged_on_another_database) {
  const Folder folder;
  const std::string model = (folder.path / "small.json").string();
  output_of(folder, {"train", small_database(), "-o", model, "--superposition", "--test", unseen_database()});
  const std::string card = folder.read("small.md");
  BOOST_TEST(card.find("(`unseen.nc`)") != std::string::npos);
  BOOST_TEST(card.find("of 6 rows") != std::string::npos);
}

BOOST_AUTO_TEST_CASE(plates_that_a_model_learns_do_not_judge_it) {
  const Folder folder;
  const std::string model = (folder.path / "small.json").string(), plan = folder.write("plan.toml", kPlan);
  refuses({"train", small_database(), "-o", model, "--superposition", "--test", small_database()},
          {"small.nc", "33 of its 33 geometries are among the plates that the model learns", "allowed:", "remedy:"});
  refuses({"train", plan, "-o", model, "--deep", "--test", small_database()},
          {"small.nc", "33 of its 33 geometries are among the plates that the model learns", "allowed:", "remedy:"});
  BOOST_TEST(!fs::exists(model));
}

BOOST_AUTO_TEST_CASE(an_option_that_would_have_no_effect_is_refused) {
  const Folder folder;
  const std::string model = (folder.path / "small.json").string(), small = small_database();
  const std::string plan = folder.write("plan.toml", plan_of("geometries = 60"));
  const auto train = [&](const std::string& data, const std::vector<std::string>& options, const std::string& what) {
    std::vector<std::string> command{"train", data, "-o", model};
    command.insert(command.end(), options.begin(), options.end());
    refuses(command, {options.back().starts_with("--") ? options.back() : options[options.size() - 2],
                      "has no effect on " + what, "allowed:", "leave the option out"});
  };
  train(small, {"--test", small}, "the network");
  train(small, {"--split", small}, "the network");
  train(small, {"--superposition", "--hidden", "3"}, "a superposition");
  train(small, {"--superposition", "--starts", "3"}, "a superposition");
  train(small, {"--superposition", "--seed", "3"}, "a superposition");
  train(plan, {"--deep", "--starts", "3"}, "a deep network");
  train(plan, {"--deep", "--one-network"}, "a deep network");
  BOOST_CHECK_THROW(run({"train", plan, "-o", model, "--deep", "--superposition"}), CLI::ExcludesError);
  BOOST_CHECK_THROW(run({"train", small, "-o", model, "--test-split", small}), CLI::RequiresError);
  BOOST_TEST(!fs::exists(model));
}

BOOST_AUTO_TEST_CASE(a_network_is_trained_written_with_its_model_card_and_the_same_each_time) {
  const Folder folder;
  const auto train = [&](const std::string& name) {
    const std::string model = (folder.path / name).string();
    return output_of(folder,
                     {"train", small_database(), "-o", model, "--hidden", "2", "--starts", "1", "--iterations", "20"});
  };
  const std::string printed = train("small.json");
  BOOST_TEST(printed.find("training") != std::string::npos);
  BOOST_TEST(printed.find("validation") != std::string::npos);
  BOOST_TEST(printed.find("test") != std::string::npos);
  BOOST_TEST(folder.read("small.md").find("# Model card: small.json") == 0u);
  for (const auto& row : rows_of(folder.read("small_errors.csv"))) BOOST_TEST(row.size() == 13u);
  train("again.json");
  BOOST_TEST(folder.read("again.json") == folder.read("small.json"));
  const std::string rows = folder.write("rows.csv", kRow);
  const std::string model = (folder.path / "small.json").string();
  BOOST_TEST(stress_of(output_of(folder, {"predict", "--model", model, "--in", rows})) > 0.0);
}

BOOST_AUTO_TEST_CASE(an_output_that_would_replace_an_input_or_its_own_card_is_refused) {
  const Folder folder;
  const auto refused = [](const std::vector<std::string>& arguments, const std::string& part) {
    refuses(arguments, {part, "would be written over"});
  };
  const std::string data = (folder.path / "data.nc").string();
  const std::string test = (folder.path / "test.md").string(), errors = (folder.path / "test_errors.csv").string();
  fs::copy_file(small_database(), errors);
  fs::copy_file(small_database(), data);
  fs::copy_file(small_database(), test);
  const std::string before = folder.read("data.nc");
  refused({"train", data, "-o", data, "--superposition"}, "data.nc");
  refused({"train", data, "-o", (folder.path / "test.json").string(), "--superposition", "--test", test}, "test.md");
  refused({"train", data, "-o", (folder.path / "test.json").string(), "--superposition", "--test", errors},
          "test_errors.csv");
  refused({"train", small_database(), "-o", data, "--split", data}, "data.nc");
  refused({"train", small_database(), "-o", data, "--split", test, "--test-split", data}, "data.nc");
  refuses({"train", data, "-o", (folder.path / "model.md").string(), "--superposition"}, {"the model's card"});
  const std::string plan = folder.write("plan.toml", kPlan);
  refused({"database", plan, "-o", plan}, "plan.toml");
  BOOST_TEST(folder.read("data.nc") == before);
  BOOST_TEST(folder.read("test.md") == before);
  BOOST_TEST(folder.read("plan.toml") == kPlan);
  BOOST_TEST(!fs::exists(folder.path / "model.md"));
}

}  // namespace
}  // namespace brash::cli
