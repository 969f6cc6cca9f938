// SPDX-License-Identifier: GPL-3.0-or-later
#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <cstdlib>
#include <filesystem>
#include <memory>
#include <nlohmann/json.hpp>
#include <string_view>

#include "brash/analysis/campaign_histories.hpp"
#include "brash/campaign/campaign.hpp"
#include "brash/core/error.hpp"
#include "brash/core/input_file.hpp"
#include "brash/core/sha256.hpp"
#include "brash/core/text.hpp"
#include "brash/core/workers.hpp"
#include "brash/failure/model_files.hpp"
#include "brash/io/case.hpp"
#include "brash/io/file_names.hpp"
#include "brash/io/results.hpp"
#include "brash/recording/inputs.hpp"
#include "brash/recording/run_folder.hpp"
#include "brash/report/report.hpp"
#include "commands.hpp"
#include "messages.hpp"
#include "runs.hpp"

namespace brash::cli {
namespace {

namespace fs = std::filesystem;
using nlohmann::json;

/// A file that a manifest names.
struct Recorded {
  std::string path;
  std::string sha256;
  std::string copy;  ///< in the folder of the run; empty: none
};

/// The name of a file in a manifest: a name, and no path, because the files are written and compared in one folder.
std::string name_in(const json& value, const std::string& manifest, const char* key) {
  const std::string name = value.get<std::string>();
  if (!name.empty() && name != "." && name != ".." && name.find('/') == std::string::npos) return name;
  throw InputError(Complaint{manifest, fmt::format("{} = '{}' leads out of the folder", key, printable(name)),
                             "a name without /", "name a manifest.json that `brash run` wrote"});
}

/// The entries of a manifest that a rerun needs.
struct Manifest {
  fs::path folder;
  std::string case_name;
  std::string case_toml;
  std::string program_version;
  std::string program_file;    ///< its name; empty in manifests that do not state it
  std::string program_sha256;  ///< empty in manifests that do not state it
  std::vector<Recorded> inputs;
  std::vector<Recorded> outputs;
};

std::vector<Recorded> files_of(const json& list) {
  std::vector<Recorded> files;
  for (const json& file : list) files.push_back({file.at("path"), file.at("sha256"), file.value("copy", "")});
  return files;
}

/// The inputs, whose copies lie in the folder's `inputs`.
std::vector<Recorded> inputs_of(const json& list, const std::string& manifest) {
  std::vector<Recorded> inputs = files_of(list);
  for (const Recorded& input : inputs) {
    const fs::path copy(input.copy);
    if (input.copy.empty() || (*copy.begin() == "inputs" && copy.lexically_normal() == copy)) continue;
    throw InputError(Complaint{manifest,
                               fmt::format("inputs.copy = '{}' leads out of the folder", printable(input.copy)),
                               "a name below inputs/", "name a manifest.json that `brash run` wrote"});
  }
  return inputs;
}

Manifest read_manifest(const std::string& path) {
  constexpr const char* kAllowed = "the manifest.json that `brash run` wrote (format \"brash-manifest-1\")";
  const std::string text = read_json_text(path, kAllowed);
  try {
    const json m = json::parse(text);
    if (m.at("format") != "brash-manifest-1")
      throw InputError(Complaint{path, "format = " + printable(m["format"].dump()), kAllowed, "name such a manifest"});
    std::vector<Recorded> outputs = files_of(m.at("outputs"));
    for (const Recorded& output : outputs) name_in(output.path, path, "outputs.path");
    return {.folder = fs::path(path).parent_path(),
            .case_name = name_in(m.at("case").at("name"), path, "case.name"),
            .case_toml = m.at("case").at("toml"),
            .program_version = m.at("program").at("version"),
            .program_file = m.at("program").value("file", ""),
            .program_sha256 = m.at("program").value("sha256", ""),
            .inputs = inputs_of(m.at("inputs"), path),
            .outputs = std::move(outputs)};
  } catch (const json::exception& error) {
    throw InputError(Complaint{path, fmt::format("is not the manifest of a run: {}", error.what()), kAllowed,
                               "name the manifest.json of a run, or copy it again"});
  }
}

/// The hash of a file, or a word in its place when there is no file.
std::string hash_of(const fs::path& file) {
  std::error_code ignored;
  return fs::is_regular_file(file, ignored) ? sha256_of_file(file.string()) : "no such file";
}

/// Where the copies of the inputs are: in the folder of the run, or of the campaign that it is a case of.
fs::path base_of(const Manifest& manifest, const std::string& copy) {
  const fs::path folder = fs::absolute(manifest.folder / "manifest.json").parent_path();
  const fs::path campaign = folder.parent_path().parent_path();
  return fs::exists(folder / copy) || !fs::exists(campaign / copy) ? folder : campaign;
}

/// The changes since a run or a campaign was recorded.
class Changes {
 public:
  void expect(const std::string& what, const std::string& was, const std::string& is) {
    if (was != is) text_ += fmt::format("\n  {}\n    was {}\n    is  {}", escaped(what), printable(was), is);
  }
  bool any() const { return !text_.empty(); }
  /// Refuses to continue from `manifest`; `anyway` prints the changes instead.
  void settle(const std::string& manifest, bool anyway) const {
    if (text_.empty()) return;
    if (anyway) return print("not what it was:{}\n", text_);
    throw InputError(
        fmt::format("{}: not what it was:{}\n  allowed: the bytes that the manifest has the hashes of"
                    "\n  remedy:  put them back, or repeat the run with --anyway",
                    escaped(manifest), text_));
  }

 private:
  std::string text_;
};

/// The model of the program that `input` was, by its name; empty: it was not one.
std::string model_of_program(const Recorded& input, const model::Case& resolved) {
  if (!input.copy.empty()) return "";
  for (const std::string& model : failure::model_files(resolved.failure))
    if (fs::path(model).filename() == fs::path(input.path).filename()) return model;
  return "";
}

/// The command has another hash than the module of Python, whose runs are the same.
bool is_of_python(const Manifest& manifest) { return fs::path(manifest.program_file).extension() == ".so"; }

/// Everything on which the run depends and that is not as it was.
Changes changes_since(const Manifest& manifest, const model::Case& resolved) {
  Changes changes;
  for (const Recorded& input : manifest.inputs) {
    // The original may have changed or gone: the run has its copy. A model that comes with the program has none, nor
    // have the inputs of older manifests.
    const std::string model = model_of_program(input, resolved);
    const bool is_case = &input == &manifest.inputs.front();  // of a campaign, which has it elsewhere: a setting
    const fs::path base = is_case ? manifest.folder : base_of(manifest, input.copy);
    const fs::path file = !input.copy.empty()      ? base / input.copy
                          : !model.empty()         ? fs::path(model)
                          : fs::exists(input.path) ? fs::path(input.path)
                                                   : manifest.folder / input.path;
    if (is_case && !input.copy.empty() && !fs::exists(file)) continue;  // the case is in the manifest
    changes.expect((model.empty() ? "input " : "model ") + file.string(), input.sha256, hash_of(file));
  }
  // Results may have been cleared away; the results that are there must be the run's own.
  for (const Recorded& output : manifest.outputs) {
    const fs::path file = manifest.folder / output.path;
    if (fs::exists(file)) changes.expect("output " + file.string(), output.sha256, hash_of(file));
  }
  if (!manifest.program_sha256.empty() && !is_of_python(manifest))
    changes.expect(fmt::format("program brash {}", manifest.program_version), manifest.program_sha256,
                   io::sha256_of_program());
  return changes;
}

/// A new folder under the system's one for temporary files, removed with everything in it in the end.
class TemporaryFolder {
 public:
  TemporaryFolder() : path_((fs::temp_directory_path() / "brash-rerun-XXXXXX").string()) {
    if (::mkdtemp(path_.data()) == nullptr)
      throw RunError(path_ + ": cannot be made; set TMPDIR to a folder that may be written");
  }
  TemporaryFolder(const TemporaryFolder&) = delete;
  TemporaryFolder& operator=(const TemporaryFolder&) = delete;
  ~TemporaryFolder() {
    std::error_code ignored;
    fs::remove_all(path_, ignored);
  }
  const std::string& path() const { return path_; }

 private:
  std::string path_;
};

/// The case and its input files, from the manifest and the copies.
recording::Inputs inputs_in(const Manifest& manifest, const std::string& path) {
  try {
    const std::string copy = manifest.inputs.empty() ? "" : manifest.inputs.back().copy;
    const fs::path base = base_of(manifest, copy);
    const std::string name = manifest.case_name + ".toml";
    const model::Case resolved =
        io::parse_case(manifest.case_toml, (base / name).string(), {}, io::ModelFile::kAnywhere);
    return recording::inputs_of(name, manifest.case_toml, resolved);
  } catch (const InputError& error) {
    throw InputError(fmt::format("{}: the case in it:\n{}", escaped(path), error.what()));
  }
}

void run_into(const std::string& folder, const recording::Inputs& inputs) {
  const FolderLock lock = recording::open_run_folder(folder);
  recording::refuse_replacing(folder);
  const recording::NewResults results(folder);
  const auto begun = [&] {
    recording::expect_unchanged(inputs);
    results.begin();
  };
  const simulation::Run run = run_with_progress(inputs.resolved, {.begun = begun, .threads = Workers::available()});
  if (!run.complete) throw Interrupted("interrupted; nothing is kept");
  report::write_results(results, inputs, run);
}

struct RerunOptions {
  std::string manifest;
  std::string output;
  bool anyway = false;
  bool of_campaign = false;  ///< one of its cases
};

/// @return whether every result is as it was.
bool rerun_run(const RerunOptions& options) {
  const Manifest manifest = read_manifest(options.manifest);
  const recording::Inputs inputs = inputs_in(manifest, options.manifest);
  changes_since(manifest, inputs.resolved).settle(options.manifest, options.anyway);
  if (is_of_python(manifest))
    say("note: Python made {}: the hash of its module is not checked, only that the results are the same\n",
        options.manifest);

  const TemporaryFolder temporary;
  const std::string folder = options.output.empty() ? temporary.path() : options.output;
  run_into(folder, inputs);
  std::string different;
  for (const Recorded& output : manifest.outputs) {
    const bool same = hash_of(fs::path(folder) / output.path) == output.sha256;
    print("{:<14} {}\n", output.path, same ? "identical" : "DIFFERENT");
    if (!same) different += " " + output.path;
  }
  if (!different.empty() && !options.of_campaign) throw RunError("the repeated run differs in" + escaped(different));
  return different.empty();
}

/// The file of a setting in the folder of a campaign; empty: there is none. All have the name of the base case before
/// the setting's, so that the shortest of the names that fit is the setting's own. A campaign without a grid has one
/// file with the name of the case alone, and its setting is called base.
fs::path setting_file(const fs::path& campaign, const std::string& setting) {
  const std::string end = "_" + setting + ".toml";
  fs::path found, shortest;
  const auto take = [](fs::path& best, const fs::path& path) {
    if (best.empty() || path.filename().string().size() < best.filename().string().size()) best = path;
  };
  std::error_code missing;
  for (const auto& entry : fs::directory_iterator(campaign / "settings", missing)) {
    const std::string name = entry.path().filename().string();
    if (name.ends_with(end)) take(found, entry.path());
    if (name.ends_with(".toml")) take(shortest, entry.path());
  }
  return found.empty() && setting == "base" ? shortest : found;
}

/// The first line of each of two texts in which they differ.
std::pair<std::string, std::string> first_difference(std::string_view a, std::string_view b) {
  const auto take_line = [](std::string_view& text) {
    std::string line(text.substr(0, text.find('\n')));
    text.remove_prefix(std::min(text.size(), line.size() + 1));
    return line;
  };
  while (!a.empty() || !b.empty())
    if (std::pair lines{take_line(a), take_line(b)}; lines.first != lines.second) return lines;
  return {};
}

/// Finds the cases of a campaign that are not of the setting and the replicate in the name of their folder.
void expect_own_case(const fs::path& manifest_file, Changes& changes) {
  const fs::path folder = manifest_file.parent_path();
  const std::string id = folder.filename().string(), what = "case " + id;
  const std::size_t mark = id.rfind("-r");
  const fs::path setting = setting_file(folder.parent_path().parent_path(), id.substr(0, mark));
  if (mark == std::string::npos || setting.empty()) return changes.expect(what, "of a setting", "of no setting");
  const Manifest manifest = read_manifest(manifest_file.string());
  if (manifest.case_name != setting.stem())
    return changes.expect(what, setting.stem().string(), printable(manifest.case_name));
  const model::Case is = inputs_in(manifest, manifest_file.string()).recorded();
  model::Case was =
      recording::read_inputs(setting.string(), {"random.replicate=0"}, io::ModelFile::kAnywhere).recorded();
  const std::string replicate = id.substr(mark + 2);
  was.random.replicate = is.random.replicate;
  const auto [line_was, line_is] = first_difference(io::to_toml(was), io::to_toml(is));
  changes.expect(what, line_was, printable(line_is));
  changes.expect(what, "replicate " + replicate, fmt::format("replicate {:04}", is.random.replicate));
}

/// The manifests of the cases in the folder of a campaign, sorted.
std::vector<fs::path> manifests_of_cases(const fs::path& campaign) {
  std::vector<fs::path> manifests;
  std::error_code missing;
  for (const auto& entry : fs::directory_iterator(campaign / "cases", missing))
    if (entry.path().extension() != ".part" && fs::is_regular_file(entry.path() / "manifest.json"))
      manifests.push_back(entry.path() / "manifest.json");
  std::ranges::sort(manifests);
  return manifests;
}

/// Inputs and tables of a campaign that are not as they were, cases that have gone, and cases of another setting.
Changes changes_in_campaign(const std::string& path, const json& manifest) {
  const fs::path folder = fs::path(path).parent_path(), table = folder / "campaign.csv";
  Changes changes;
  bool has_table = false;
  try {
    for (const Recorded& input : inputs_of(manifest.value("inputs", json::array()), path))
      if (const fs::path file = folder / input.copy; !input.copy.empty())
        changes.expect("input " + file.string(), input.sha256, hash_of(file));
    for (const Recorded& output : files_of(manifest.value("outputs", json::array()))) {
      const fs::path file = folder / name_in(output.path, path, "outputs.path");
      if (file == table || fs::exists(file)) changes.expect("output " + file.string(), output.sha256, hash_of(file));
      has_table = has_table || (file == table && hash_of(file) == output.sha256);
    }
  } catch (const json::exception& error) {
    throw InputError(Complaint{path, fmt::format("is not the manifest of a campaign: {}", error.what()),
                               "the manifest.json in the folder of a campaign", "copy it again"});
  }
  if (has_table)
    for (const auto& [setting, cases] : analysis::done_cases(folder.string()))
      for (const std::string& id : cases)
        changes.expect("case " + id, "done", fs::exists(folder / "cases" / id / "manifest.json") ? "done" : "gone");
  // An input that has changed has its own line, and would change every case.
  if (!changes.any())
    for (const fs::path& case_manifest : manifests_of_cases(folder)) expect_own_case(case_manifest, changes);
  return changes;
}

/// Repeats every case of the campaign that wrote `manifest`, each with its own manifest.
void rerun_campaign(const RerunOptions& options, const json& manifest) {
  changes_in_campaign(options.manifest, manifest).settle(options.manifest, options.anyway);
  const std::vector<fs::path> manifests = manifests_of_cases(fs::path(options.manifest).parent_path());
  if (manifests.empty())
    throw InputError(Complaint{options.manifest, "is a campaign's, and its folder has no case with a manifest",
                               "the manifest.json in the whole folder of a campaign",
                               "copy the folder with its cases"});
  std::size_t n_different = 0;
  for (const fs::path& path : manifests) {
    const std::string name = path.parent_path().filename().string();
    print("{}\n", name);
    n_different += rerun_run({.manifest = path.string(),
                              .output = options.output.empty() ? "" : options.output + "/" + name,
                              .anyway = options.anyway,
                              .of_campaign = true})
                       ? 0
                       : 1;
  }
  print("{} of {} cases identical\n", manifests.size() - n_different, manifests.size());
  if (n_different > 0) throw RunError(fmt::format("{} of {} cases differ", n_different, manifests.size()));
}

void rerun(const RerunOptions& options) {
  constexpr const char* kAllowed = "the manifest.json of a run or a campaign";
  const json manifest = json::parse(read_json_text(options.manifest, kAllowed), nullptr, /*allow_exceptions=*/false);
  if (manifest.is_object() && manifest.contains("format") && manifest["format"] == campaign::kManifestFormat)
    rerun_campaign(options, manifest);
  else
    rerun_run(options);
}

}  // namespace

void add_rerun_command(CLI::App& app) {
  auto options = std::make_shared<RerunOptions>();
  CLI::App* command =
      app.add_subcommand("rerun", "Check every hash of a run or a campaign, repeat it and compare the results");
  command->add_option("manifest", options->manifest, "folder of a run or a campaign, or its manifest.json")->required();
  command->add_option("-o,--output", options->output, "folder to keep the results in [they are not kept]");
  command->add_flag("--anyway", options->anyway,
                    "repeat it although an input, the model, the program or a result has changed");
  command->footer(
      "The case comes from the manifest. Exit code 2: something has changed; 1: the results differ.\n"
      "Example: brash rerun results/cone");
  command->callback([options] {
    options->manifest = io::file_in(options->manifest, {"manifest.json"});
    rerun(*options);
  });
}

}  // namespace brash::cli
