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
void assign(Vec2& value, const Json& section, const char* key) {
  value = {section.at(key).at(0).get<double>(), section.at(key).at(1).get<double>()};
}
void assign(std::optional<double>& value, const Json& section, const char* key) {
  if (section.contains(key)) value = section.at(key).get<double>();
}

Case case_from(const Json& document) {
  Case result;
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

}  // namespace

Case resolve(const CaseSource& source, const std::string& name) {
  Case result = case_from(validated(source, schema_of_cases()));
  result.name = name;
  result.failure.file = resolve_file(result.failure.file, source);
  std::vector<Problem> problems = cross_check(result, source);
  if (!problems.empty()) refuse(std::move(problems));
  return result;
}

Case read_case(const std::string& path, const std::vector<std::string>& overrides) {
  return parse_case(read_case_text(path), path, overrides);
}

std::string read_case_text(const std::string& path) { return read_text(path, "case file"); }

Case parse_case(const std::string& text, const std::string& path, const std::vector<std::string>& overrides) {
  return resolve(parse_source(text, path, overrides), std::filesystem::path(path).stem().string());
}

}  // namespace brash::io
