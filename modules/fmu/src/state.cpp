// SPDX-License-Identifier: GPL-3.0-or-later
#include "state.hpp"

#include <nlohmann/json.hpp>
#include <utility>

#include "brash/core/error.hpp"
#include "brash/core/sha256.hpp"
#include "brash/model/case_keys.hpp"

namespace brash::fmu {
namespace {

using Json = nlohmann::json;

constexpr std::size_t kDigestSize = 64;

Json tree_of(const geometry::Ring& ring) {
  Json points = Json::array();
  for (const geometry::Point& point : ring) points.push_back({point.x, point.y});
  return points;
}

geometry::Ring ring_from(const Json& tree) {
  geometry::Ring ring;
  for (const Json& point : tree)
    ring.push_back(geometry::Point::of_units(point.at(0).get<std::int64_t>(), point.at(1).get<std::int64_t>()));
  return ring;
}

Json tree_of(const geometry::Polygon& polygon) {
  Json rings = Json::array({tree_of(polygon.outline)});
  for (const geometry::Ring& hole : polygon.holes) rings.push_back(tree_of(hole));
  return rings;
}

geometry::Polygon polygon_from(const Json& tree) {
  geometry::Polygon polygon{ring_from(tree.at(0)), {}};
  for (std::size_t i = 1; i < tree.size(); ++i) polygon.holes.push_back(ring_from(tree.at(i)));
  return polygon;
}

Json tree_of(const std::vector<geometry::Polygon>& polygons) {
  Json tree = Json::array();
  for (const geometry::Polygon& polygon : polygons) tree.push_back(tree_of(polygon));
  return tree;
}
template <typename Value>
Json tree_of(const std::vector<Value>& values) {
  return values;
}

void take(std::vector<geometry::Polygon>& polygons, const Json& tree) {
  for (const Json& polygon : tree) polygons.push_back(polygon_from(polygon));
}
template <typename Value>
void take(std::vector<Value>& values, const Json& tree) {
  tree.get_to(values);
}

/// A variant of vectors that holds the one of this index.
model::ColumnValues values_of_kind(std::size_t kind) {
  switch (kind) {
    case 0:
      return std::vector<double>{};
    case 1:
      return std::vector<std::int64_t>{};
    case 2:
      return std::vector<std::string>{};
    default:
      return std::vector<geometry::Polygon>{};
  }
}

/// Units and meanings are for files that people read.
Json tree_of(const model::Table& table) {
  Json columns = Json::array();
  for (const model::Column& column : table.columns)
    columns.push_back({column.name, column.values.index(),
                       std::visit([](const auto& values) { return tree_of(values); }, column.values)});
  return {{"name", table.name}, {"columns", std::move(columns)}};
}

model::Table table_from(const Json& tree) {
  model::Table table{tree.at("name"), {}};
  for (const Json& column : tree.at("columns")) {
    table.columns.push_back({column.at(0), "", "", values_of_kind(column.at(1))});
    std::visit([&](auto& values) { take(values, column.at(2)); }, table.columns.back().values);
  }
  return table;
}

/// The numbers that a `visit` names, in its order.
template <typename Owner>
Json numbers_of(const Owner& owner) {
  Json numbers = Json::array();
  Owner::visit(owner, [&](const auto&, const auto&, const auto&, double number) { numbers.push_back(number); });
  return numbers;
}
template <typename Owner>
void take_numbers(Owner& owner, const Json& tree) {
  std::size_t next = 0;
  Owner::visit(owner, [&](const auto&, const auto&, const auto&, double& number) { tree.at(next++).get_to(number); });
}

Json tree_of(const State& state) {
  Json tree{{"phase", static_cast<int>(state.phase)},
            {"start_time", state.start_time},
            {"n_steps", state.n_steps},
            {"remainder", state.remainder},
            {"name", state.resolved.name},
            {"case", model::to_tree<Json>(state.resolved)},
            {"inputs", numbers_of(state.inputs)},
            {"track", numbers_of(state.track)},
            {"outputs", numbers_of(state.outputs)}};
  tree["case"]["failure"]["file"] = "";
  if (state.stop_time) tree["stop_time"] = *state.stop_time;
  if (state.checkpoint)
    for (const model::Table& table : state.checkpoint->tables) tree["tables"].push_back(tree_of(table));
  return tree;
}

State state_from(const Json& tree) {
  State state{.phase = static_cast<Phase>(tree.at("phase").get<int>()),
              .start_time = tree.at("start_time"),
              .stop_time = {},
              .n_steps = tree.at("n_steps"),
              .remainder = tree.at("remainder"),
              .resolved = model::from_tree(tree.at("case")),
              .inputs = {},
              .track = {},
              .outputs = {},
              .checkpoint = {}};
  state.resolved.name = tree.at("name");
  if (tree.contains("stop_time")) state.stop_time = tree.at("stop_time").get<double>();
  take_numbers(state.inputs, tree.at("inputs"));
  take_numbers(state.track, tree.at("track"));
  take_numbers(state.outputs, tree.at("outputs"));
  if (!tree.contains("tables")) return state;
  state.checkpoint.emplace().resolved = state.resolved;
  for (const Json& table : tree.at("tables")) state.checkpoint->tables.push_back(table_from(table));
  return state;
}

[[noreturn]] void refuse(const std::string& what) {
  throw InputError(Complaint{"the serialised state", what, "the bytes of a state of this unit", "pass them unchanged"});
}

}  // namespace

std::string to_bytes(const State& state, const std::string& token) {
  Json tree = tree_of(state);
  tree["token"] = token;
  std::string bytes;
  Json::to_cbor(tree, nlohmann::detail::output_adapter<char, std::string>(bytes));
  return sha256(bytes) + bytes;
}

State state_from(std::string_view bytes, const std::string& token) {
  const std::string_view digest = bytes.substr(0, kDigestSize);
  const std::string_view content = bytes.substr(digest.size());
  if (digest != sha256(content)) refuse("is damaged: its bytes do not have their digest");
  try {
    const Json tree = Json::from_cbor(content.begin(), content.end());
    if (tree.at("token") != token) refuse("is of another unit");
    return state_from(tree);
  } catch (const Json::exception& error) {
    refuse(error.what());
  }
}

}  // namespace brash::fmu
