// SPDX-License-Identifier: GPL-3.0-or-later
#include <filesystem>

#include "brash/core/contract.hpp"
#include "brash/io/case.hpp"
#include "case_keys.hpp"
#include "cross_checks.hpp"
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
  for (const OrderedJson& section : section_schemas()) n_known += section.at("properties").size();
  BRASH_EXPECTS(n_read == n_known, n_read, n_known);
  return result;
}

/// A model file is named relative to the case file, or to the working folder where an override names it.
std::string resolve_file(const std::string& file, const CaseSource& source) {
  if (file.empty()) return file;
  const std::filesystem::path base = source.overridden.contains("failure.file")
                                         ? std::filesystem::path()
                                         : std::filesystem::path(source.file).parent_path();
  return std::filesystem::absolute(base / file).lexically_normal().string();
}

}  // namespace

Case read_case(const std::string& path, const std::vector<std::string>& overrides) {
  return parse_case(read_case_text(path), path, overrides);
}

Case parse_case(const std::string& text, const std::string& path, const std::vector<std::string>& overrides) {
  const CaseSource source = parse_source(text, path, overrides);
  Case result = case_from(validated(source));
  result.name = std::filesystem::path(path).stem().string();
  result.failure.file = resolve_file(result.failure.file, source);
  std::vector<Problem> problems = cross_check(result, source);
  if (!problems.empty()) refuse(std::move(problems));
  return result;
}

}  // namespace brash::io
