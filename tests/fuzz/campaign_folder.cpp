// SPDX-License-Identifier: GPL-3.0-or-later
// libFuzzer: a campaign continues in a folder with any content under its file names, or ends with an error in words.
// Nothing outside the folder changes. Lines `@ file NAME`, `@ folder NAME` and `@ link NAME` begin its entries.
#include <unistd.h>

#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <sstream>

#include "brash/campaign/campaign.hpp"
#include "brash/core/error.hpp"
#include "brash/report/report.hpp"
#include "collect.hpp"
#include "folder.hpp"
#include "schedule.hpp"
#include "scratch_file.hpp"

namespace {

namespace fs = std::filesystem;
using namespace brash;

constexpr const char* kPlan = R"([campaign]
replicates = 2
[output]
columns = ["horizontal.mean"]
[case.ice]
thickness = 0.33
youngs_modulus = 3.5e8
flexural_strength = 5.39e5
[case.structure]
angle = 1.07
waterline_width = 13.6
height = 9.08
height_under_water = 5.68
speed = 1.202
start_distance = 7
[case.field]
length = 20
width = 30
[case.failure]
model = "wedge"
[case.time]
duration = 2
)";

/// The campaign's folder, a folder outside of it, and the plan.
struct Place {
  Place() : root(fs::temp_directory_path() / ("brash-fuzz-campaign-" + std::to_string(::getpid()))) {
    fs::remove_all(root);
    fs::create_directories(root / "outside");
    std::ofstream(root / "outside/summary.json") << "{}";
    std::ofstream(root / "outside/lock") << "process 1 on nobody\n";
    std::ofstream(root / "plan.toml") << kPlan;
    plan = io::read_campaign_plan((root / "plan.toml").string(), {.quick = false,
                                                                  .replicates = {},
                                                                  .overrides = {},
                                                                  .known_columns = campaign::known_columns(),
                                                                  .default_columns = campaign::default_columns()});
  }
  ~Place() { fs::remove_all(root); }
  bool is_whole() const {
    return fs::exists(root / "outside/summary.json") && fs::exists(root / "outside/lock") &&
           std::distance(fs::directory_iterator(root / "outside"), fs::directory_iterator()) == 2;
  }

  fs::path root;
  io::CampaignPlan plan;
};

/// A name below `folder`, or nothing when it leads out of it.
fs::path inside(const fs::path& folder, const std::string& name) {
  const fs::path path = fs::path(name).lexically_normal();
  if (name.empty() || name.size() > 100 || path.is_absolute() || *path.begin() == ".." || *path.begin() == ".")
    return {};
  return folder / path;
}

void fill(const fs::path& folder, const std::string& text, const fs::path& outside) {
  std::istringstream lines(text);
  std::ofstream file;
  for (std::string line; std::getline(lines, line);) {
    if (!line.starts_with("@ ")) {
      if (file.is_open()) file << line << '\n';
      continue;
    }
    file.close();
    std::istringstream words(line.substr(2));
    std::string kind, name;
    words >> kind >> name;
    const fs::path path = inside(folder, name);
    std::error_code ignored;
    // Not through a link that was put there before: that would be this test's own write.
    if (path.empty() || fs::weakly_canonical(path.parent_path(), ignored) != path.parent_path()) continue;
    fs::create_directories(path.parent_path(), ignored);
    if (kind == "folder") fs::create_directories(path, ignored);
    if (kind == "link" && !fs::exists(fs::symlink_status(path, ignored))) fs::create_symlink(outside, path, ignored);
    if (kind == "file" && !fs::is_symlink(path, ignored)) file.open(path, std::ios::binary);
  }
}

template <typename Call>
void expect_words(Call call) {
  try {
    call();
  } catch (const InputError&) {
  } catch (const RunError&) {
  } catch (const fs::filesystem_error&) {  // the system's own words
  }
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  static const Place place;
  const fs::path folder = fs::canonical(place.root) / "campaign";
  fs::remove_all(folder);
  fs::create_directories(folder);
  fill(folder, std::string(text_of(data, size)), place.root / "outside");
  campaign::Folder files(place.plan, folder.string());
  const campaign::Campaign campaign{.plan = place.plan,
                                    .plan_file = (place.root / "plan.toml").string(),
                                    .directory = folder.string(),
                                    .resume = true,
                                    .program = {}};
  expect_words([&] {
    files.prepare(true);
    const campaign::Schedule schedule(place.plan, files);
    if (schedule.counts().n_missing() == 0) campaign::collect(campaign, files, schedule);
  });
  expect_words([&] { (void)campaign::count(place.plan, folder.string()); });
  expect_words([&] { (void)report::write_campaign_report(folder.string()); });
  if (!place.is_whole()) std::abort();
  return 0;
}
