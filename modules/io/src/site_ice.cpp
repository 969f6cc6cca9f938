// SPDX-License-Identifier: GPL-3.0-or-later
#include "site_ice.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <utility>
#include <vector>

#include "brash/core/error.hpp"
#include "brash/core/text.hpp"
#include "brash/io/new_case.hpp"
#include "schema.hpp"

namespace brash::io {
namespace {

const OrderedJson& data() {
  static const OrderedJson json = OrderedJson::parse(kSiteIceText);
  return json;
}

const OrderedJson& site(const std::string& name) { return data().at("sites").at(name); }

}  // namespace

std::vector<std::string> site_ice() {
  std::vector<std::string> names;
  for (const auto& [name, unused] : data().at("sites").items()) names.push_back(name);
  return names;
}

SiteIce::SiteIce(std::string name) : name_(std::move(name)) {
  if (data().at("sites").contains(name_)) return;
  const std::string nearest = nearest_name(name_, site_ice());
  throw InputError(Complaint{"ice", fmt::format("there is no ice '{}'", printable(name_)),
                             fmt::format("one of: {}", fmt::join(site_ice(), ", ")),
                             nearest.empty() ? "name one of these" : "name one of these, such as " + nearest});
}

std::optional<SiteIce::Value> SiteIce::value_of(const std::string& key) const {
  const OrderedJson& values = site(name_).at("values");
  if (!values.contains(key)) return std::nullopt;
  std::string source = data().at("keys").at(key).get<std::string>();
  if (source.find("v_b") != std::string::npos) source += ' ' + site(name_).at("brine").get<std::string>();
  if (const auto own = values.at(key).at(1).get<std::string>(); !own.empty()) source += ' ' + own;
  return Value{toml_text(values.at(key).at(0)), source};
}

std::string SiteIce::description() const { return site(name_).at("name").get<std::string>(); }

}  // namespace brash::io
