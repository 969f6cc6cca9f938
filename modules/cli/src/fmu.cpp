// SPDX-License-Identifier: GPL-3.0-or-later
#include "fmu.hpp"

#include <algorithm>
#include <array>
#include <filesystem>
#include <utility>

#include "brash/advice/advice.hpp"
#include "brash/core/error.hpp"
#include "brash/core/input_file.hpp"
#include "brash/core/own_path.hpp"
#include "brash/core/sha256.hpp"
#include "brash/core/text.hpp"
#include "brash/core/version.hpp"
#include "brash/failure/model_files.hpp"
#include "brash/fmu/unit.hpp"
#include "brash/fmu/variables.hpp"
#include "brash/formats/zip_file.hpp"
#include "brash/io/file_names.hpp"
#include "brash/model/case_keys.hpp"
#include "brash/recording/inputs.hpp"
#include "messages.hpp"

namespace brash::cli {
namespace {

namespace fs = std::filesystem;
using formats::ZipEntry;

/// The library of all units, where the program was built or installed.
std::string unit_library() {
  for (fs::path folder = own_path().parent_path(); folder.has_relative_path(); folder = folder.parent_path())
    if (std::error_code ignored; fs::is_regular_file(folder / "lib/brash/fmu.so", ignored))
      return folder / "lib/brash/fmu.so";
  throw InputError(Complaint{"lib/brash/fmu.so", "is not beside the program", "the library of the same installation",
                             "install the program again"});
}

/// Keys that depend on no other key: a host may set any such key within its range.
bool stands_alone(const io::NumberKey& key) {
  const std::string name = key.section + "." + key.key;
  constexpr std::array kNames{"ice.youngs_modulus",       "ice.poisson_ratio",     "ice.flexural_strength",
                              "ice.compressive_strength", "ice.crushing_factor",   "ice.friction_ice",
                              "structure.speed",          "structure.motion.mass", "structure.motion.stiffness",
                              "structure.motion.damping", "random.seed",           "random.replicate"};
  return std::ranges::find(kNames, name) != kNames.end();
}

std::vector<fmu::Parameter> parameters_of(const model::Case& resolved) {
  std::vector<fmu::Parameter> parameters;
  for (const io::NumberKey& key : io::number_keys(resolved))
    if (stands_alone(key) && !(key.key == "speed" && fmu::is_driven(resolved)))
      parameters.push_back({key.section, key.key, key.unit, key.meaning, key.least, key.most});
  return parameters;
}

/// The models, the mesh and the ice that the case reads, in the resources.
std::vector<ZipEntry> input_entries(const recording::Inputs& inputs) {
  constexpr std::size_t kMostMebibytes = 64;
  const std::string& own = inputs.resolved.failure.file;
  std::vector<ZipEntry> entries;
  if (const auto* const mesh = std::get_if<model::Mesh>(&inputs.resolved.structure.shape))
    for (const recording::InputFile& file : inputs.files)
      if (file.path == mesh->file) entries.push_back({"resources/" + file.copy, file.bytes});
  const model::Case recorded = inputs.recorded();
  model::visit_files_of_field(recorded.field, [&](const char*, const std::string& copy) {
    for (const recording::InputFile& file : inputs.files)
      if (!copy.empty() && file.copy == copy) entries.push_back({"resources/" + file.copy, file.bytes});
  });
  for (const std::string& file : failure::model_files(inputs.resolved.failure)) {
    const std::string name = file == own ? inputs.recorded().failure.file
                                         : std::string(fmu::kModelFolder) + "/" + fs::path(file).filename().string();
    entries.push_back({"resources/" + name, read_text_file(file, "the file of a failure model", kMostMebibytes)});
  }
  return entries;
}

/// FMI 3.0.2, Sec. 2.5: a unit that needs other libraries says which.
std::string needs() {
  return fmt::format(
      "The library of this unit is for Linux on x86-64 with glibc {}.{} or newer and the C++ library of GCC.\n"
      "It brings every other library along. They are in the packages\n\n    {}\n\n"
      "of {}, whose licences lie in /usr/share/doc there.\n",
      __GLIBC__, __GLIBC_MINOR__, BRASH_FMU_PACKAGES, BRASH_FMU_SYSTEM);
}

/// The library of the unit, and beside it the shared libraries that it needs.
std::vector<ZipEntry> library_entries(fmu::Standard standard) {
  const fs::path library = unit_library(), folder = fs::path(fmu::library_path(standard)).parent_path();
  std::vector<ZipEntry> entries{{fmu::library_path(standard), read_text_file(library, "the library of units")}};
  std::vector<fs::path> others;
  for (const auto& entry : fs::directory_iterator(library.parent_path() / "fmu")) others.push_back(entry.path());
  std::ranges::sort(others);
  for (const fs::path& path : others)
    entries.push_back({folder / path.filename(), read_text_file(path, "a library that units need")});
  return entries;
}

/// Says which case, models and version a unit is made of.
std::string token_of(const fmu::Unit& unit, const std::vector<ZipEntry>& inputs) {
  Sha256 hash;
  hash.add(kVersion);
  hash.add(fmu::to_json(unit));
  for (const ZipEntry& input : inputs) hash.add(sha256(input.bytes));
  return hexadecimal(hash.digest());
}

/// Descriptions of units are XML, which holds no control characters and no bytes that are not UTF-8.
void check_name(const std::string& name, const std::string& case_file) {
  if (escaped(name) == name) return;
  throw InputError(Complaint{case_file, "has a name that the description of a unit cannot hold, " + escaped(name),
                             "letters of UTF-8 without control characters", "rename the file"});
}

}  // namespace

void export_fmu(const std::string& case_file, const std::vector<std::string>& overrides, const std::string& file,
                fmu::Standard standard, bool velocity_from_poses) {
  refuse_overwriting(file, {case_file});
  io::check_ending(file, "a co-simulation unit", {".fmu"});
  const recording::Inputs inputs = recording::read_inputs(case_file, overrides);
  check_name(inputs.resolved.name, case_file);
  say_warnings(advice::warnings_of(inputs.resolved));
  if (velocity_from_poses && !fmu::is_driven(inputs.resolved))
    throw InputError(Complaint{"--velocity-from-poses", "is of no use: no host drives the structure of " + case_file,
                               "a structure that the host drives", "add --set structure.motion.kind=driven"});
  fmu::Unit unit{inputs.recorded(), parameters_of(inputs.resolved), "", velocity_from_poses};
  std::vector<ZipEntry> entries = input_entries(inputs);
  unit.token = token_of(unit, entries);
  entries.insert(entries.begin(), {"modelDescription.xml", fmu::model_description(unit, standard)});
  entries.push_back({std::string("resources/") + fmu::kUnitFile, fmu::to_json(unit)});
  entries.push_back({"documentation/externalDependencies.txt", needs()});
  for (ZipEntry& entry : library_entries(standard)) entries.push_back(std::move(entry));
  formats::write_zip(file, entries);
  print("co-simulation unit of {} in {}\n", inputs.resolved.name, file);
}

}  // namespace brash::cli
