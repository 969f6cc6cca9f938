// SPDX-License-Identifier: GPL-3.0-or-later
#include <filesystem>

#include "brash/core/contract.hpp"
#include "brash/io/case.hpp"
#include "case_keys.hpp"
#include "cross_checks.hpp"
#include "resolve.hpp"
#include "schema.hpp"
#include "validate.hpp"

namespace brash::io {
namespace {

using Json = nlohmann::json;

template <typename Value>
void assign(Value& value, const Json& section, const char* key) {
  section.at(key).get_to(value);
}
template <model::Choice Choice>
void assign(Choice& value, const Json& section, const char* key) {
  const auto text = section.at(key).get<std::string>();
  const auto known = model::named<Choice>(text);
  BRASH_EXPECTS(known.has_value(), key, text);  // the schema has the same names
  value = *known;
}
void assign(Vec2& value, const Json& section, const char* key) {
  value = {section.at(key).at(0).get<double>(), section.at(key).at(1).get<double>()};
}
void assign(std::optional<double>& value, const Json& section, const char* key) {
  if (section.contains(key)) value = section.at(key).get<double>();
}

model::Case case_from(const Json& document) {
  model::Case result;
  std::size_t n_read = 0;
  visit_keys(result, [&](const char* section, const char* key, auto& value) {
    assign(value, document.at(section), key);
    ++n_read;
  });
  std::size_t n_known = 0;
  for (const OrderedJson& section : schema_of_cases().sections()) n_known += section.at("properties").size();
  BRASH_EXPECTS(n_read == n_known, n_read, n_known);
  return result;
}

/// A model file is named relative to the file that names it, or to the working folder where the command line does.
std::string resolve_file(const std::string& file, const CaseSource& source) {
  if (file.empty()) return file;
  const Place named = place_of(source, "failure", "file");
  const std::filesystem::path base =
      named.override_text.empty() ? std::filesystem::path(named.file).parent_path() : std::filesystem::path();
  return std::filesystem::absolute(base / file).lexically_normal().string();
}

/// What is wrong with a model file outside the folder of the file that names it.
std::vector<Problem> leads_out(const std::string& file, const CaseSource& source) {
  const Place named = place_of(source, "failure", "file");
  if (file.empty() || !named.override_text.empty()) return {};
  const auto folder = std::filesystem::absolute(named.file).lexically_normal().parent_path();
  const std::filesystem::path inside = std::filesystem::path(file).lexically_relative(folder);
  if (!inside.empty() && *inside.begin() != "..") return {};
  return {{named, "failure.file", value_text(source, "failure", "file"),
           "leads out of the folder of the file that names it", "a file in that folder or below", "",
           "put the model beside the case, or name it on the command line: --set failure.file=PATH may lead anywhere"}};
}

}  // namespace

model::Case resolve(const CaseSource& source, const std::string& name, ModelFile model_file) {
  model::Case result = case_from(validated(source, schema_of_cases()));
  result.name = name;
  result.failure.file = resolve_file(result.failure.file, source);
  std::vector<Problem> problems;
  if (model_file == ModelFile::kInItsFolder) problems = leads_out(result.failure.file, source);
  if (problems.empty()) problems = cross_check(result, source);
  if (!problems.empty()) refuse(std::move(problems));
  return result;
}

model::Case read_case(const std::string& path, const std::vector<std::string>& overrides, ModelFile model_file) {
  return parse_case(read_case_text(path), path, overrides, model_file);
}

std::string read_case_text(const std::string& path) { return read_text(path, "case file"); }

model::Case parse_case(const std::string& text, const std::string& path, const std::vector<std::string>& overrides,
                       ModelFile model_file) {
  return resolve(parse_source(text, path, overrides), std::filesystem::path(path).stem().string(), model_file);
}

}  // namespace brash::io
