// SPDX-License-Identifier: GPL-3.0-or-later
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <nlohmann/json.hpp>
#include <optional>

#include "brash/core/byte_order_mark.hpp"
#include "brash/geometry/text.hpp"
#include "json_tree.hpp"
#include "text_ring.hpp"

namespace brash::geometry {
namespace {

using Kind = JsonNode::Kind;

/// Reads the tree of a GeoJSON text (RFC 7946, in plan metres) into features or cracks; stops at the first fault.
class Reader {
 public:
  Reader(std::string_view text, const JsonNode& root, const Ground& ground)
      : text_(text), root_(root), ground_(ground) {}

  tl::expected<std::vector<Feature>, GeometryError> features() {
    read();
    if (error_) return tl::unexpected(*error_);
    repair_round_off(features_, left_out_);
    return std::move(features_);
  }
  /// The same; ice of its own that a feature cannot have is a fault.
  tl::expected<std::vector<Feature>, GeometryError> features_with_ice() {
    checks_ice_ = true;
    return features();
  }
  tl::expected<Lines, GeometryError> lines() {
    wants_lines_ = true;
    read();
    if (error_) return tl::unexpected(*error_);
    lines_.left_out = left_out();
    return std::move(lines_);
  }

  std::string left_out() const { return left_out_.to_string(); }

  /// The member `origin`: two numbers.
  tl::expected<std::optional<Origin>, GeometryError> origin() {
    std::optional<Origin> result;
    const JsonNode* member = find(root_, "origin");
    if (member != nullptr && member->kind != Kind::kNull) {
      const std::optional<Position> position = position_of(*member);
      if (position && position->x && position->y) {
        result = Origin{*position->x, *position->y};
      } else {
        fail(root_, "\"origin\" is not an array of two numbers below 10^15 m");
      }
    }
    if (error_) return tl::unexpected(*error_);
    return result;
  }
  /// The member `crs` as it is written.
  tl::expected<std::string, GeometryError> crs() {
    type_of(root_);  // of a text that is not GeoJSON at all, that is the fault to name
    const JsonNode* member = error_ ? nullptr : find(root_, "crs");
    refuse_degrees(member);
    if (error_) return tl::unexpected(*error_);
    return std::string(member != nullptr && member->kind == Kind::kObject ? object_at(text_, member->offset) : "");
  }

 private:
  void read() {
    const std::string type = type_of(root_);
    if (error_) return;
    refuse_degrees(find(root_, "crs"));
    if (type == "FeatureCollection") {
      if (const JsonNode* features = array(root_, "features")) {
        for (const JsonNode& feature : features->items) read_feature(feature);
      }
    } else if (type == "Feature") {
      read_feature(root_);
    } else {
      read_geometry(root_, Feature{{}, "sheet", 0});
    }
  }

  void refuse_degrees(const JsonNode* crs) {
    if (error_ || crs == nullptr || crs->kind != Kind::kObject) return;
    const JsonNode* properties = find(*crs, "properties");
    if (properties == nullptr || properties->kind != Kind::kObject) return;
    const JsonNode* name = find(*properties, "name");
    if (name != nullptr && is_geographic(name->text)) fail(*crs, degrees_refused(name->text));
  }

  void fail(const JsonNode& at, std::string_view what) {
    if (!error_) error_ = error_at(text_, at.offset, what);
  }

  /// The member `name`, or null when there is none.
  const JsonNode* find(const JsonNode& object, std::string_view name) {
    if (object.kind != Kind::kObject) {
      fail(object, fmt::format("an object with \"{}\" is expected", name));
      return nullptr;
    }
    const auto first = std::find(object.names.begin(), object.names.end(), name);
    if (first == object.names.end()) return nullptr;
    if (std::find(first + 1, object.names.end(), name) != object.names.end()) {
      fail(object, fmt::format("\"{}\" is given twice", name));
    }
    return &object.items[static_cast<std::size_t>(first - object.names.begin())];
  }
  /// The member `name`, or null when there is none or it is null.
  const JsonNode* given(const JsonNode& object, std::string_view name) {
    const JsonNode* member = find(object, name);
    return member != nullptr && member->kind == Kind::kNull ? nullptr : member;
  }
  const JsonNode* array(const JsonNode& object, std::string_view name) {
    const JsonNode* member = find(object, name);
    if (member != nullptr && member->kind == Kind::kArray) return member;
    fail(object, fmt::format("\"{}\" is missing or no array", name));
    return nullptr;
  }
  std::string type_of(const JsonNode& object) {
    const JsonNode* type = find(object, "type");
    if (type != nullptr && type->kind == Kind::kString) return type->text;
    fail(object, "\"type\" is missing or no text");
    return {};
  }

  void read_feature(const JsonNode& node) {
    const std::string type = type_of(node);
    if (error_) return;
    if (type != "Feature") return fail(node, fmt::format("a Feature is expected, not {}", type));
    Feature feature{{}, "sheet", n_features_++};
    const JsonNode* properties = find(node, "properties");
    if (properties != nullptr && properties->kind != Kind::kNull) read_properties(*properties, feature);
    const JsonNode* geometry = find(node, "geometry");
    if (geometry == nullptr || geometry->kind == Kind::kNull)
      ++left_out_.n_features;
    else
      read_geometry(*geometry, feature);
  }

  void read_properties(const JsonNode& properties, Feature& feature) {
    if (const JsonNode* kind = given(properties, "kind")) {
      if (kind->text != "sheet" && kind->text != "floe") {
        return fail(properties, fmt::format("\"kind\" = \"{}\" is neither \"sheet\" nor \"floe\"", kind->text));
      }
      feature.kind = kind->text;
    }
    if (const JsonNode* id = given(properties, "id")) {
      const std::optional<std::int64_t> whole = whole_number(*id);
      left_out_.n_ids += whole ? 0 : 1;
      feature.id = whole.value_or(feature.id);
    }
    feature.thickness = positive(properties, "thickness", "metres");
    feature.flexural_strength = positive(properties, "flexural_strength", "pascals");
  }

  /// The number of a node, also of "3.0" as other programs write it.
  static std::optional<std::int64_t> whole_number(const JsonNode& node) {
    constexpr double kFar = 0x1p53;  // a double beyond may be another number than its text
    if (node.integer || node.kind != Kind::kNumber) return node.integer;
    if (std::abs(node.number) >= kFar || std::trunc(node.number) != node.number) return std::nullopt;
    return static_cast<std::int64_t>(node.number);
  }

  std::optional<double> positive(const JsonNode& properties, const char* name, const char* unit) {
    const JsonNode* node = given(properties, name);
    if (node == nullptr) return std::nullopt;
    const bool is_number = node->kind == Kind::kNumber;
    if (checks_ice_ && !(is_number && node->number > 0.0)) {
      const std::string value = is_number                     ? fmt::format("{}", node->number)
                                : node->kind == Kind::kString ? fmt::format("\"{}\"", node->text)
                                                              : "(true, false, an array or an object)";
      fail(properties,
           fmt::format("\"{}\" = {} is not a number of {} above 0: write one, without quotes, or remove the "
                       "property",
                       name, value, unit));
    }
    return is_number ? std::optional(node->number) : std::nullopt;
  }

  /// Recurs at a GeometryCollection only, and the parser has bounded the depth of those.
  void read_geometry(const JsonNode& node, const Feature& feature) {
    const std::string type = type_of(node);
    if (error_) return;
    const std::string one = wants_lines_ ? "LineString" : "Polygon";
    if (type == one) {
      if (const JsonNode* member = array(node, "coordinates")) read_member(*member, feature);
    } else if (type == "Multi" + one) {
      if (const JsonNode* members = array(node, "coordinates")) {
        for (const JsonNode& member : members->items) read_member(member, feature);
      }
    } else if (type == "GeometryCollection") {
      if (const JsonNode* geometries = array(node, "geometries")) {
        for (const JsonNode& geometry : geometries->items) read_geometry(geometry, feature);
      }
    } else {
      fail(node,
           fmt::format("{} is not read: FeatureCollection, Feature, {}, Multi{} or GeometryCollection is expected",
                       type.empty() ? "this" : type, one, one));
    }
  }

  void read_member(const JsonNode& node, const Feature& feature) {
    if (wants_lines_) return read_line(node);
    read_polygon(node, feature);
  }

  void read_line(const JsonNode& node) {
    const std::vector<Position> positions = positions_of(node, "a line");
    if (error_) return;
    const auto read = cracks_from_positions(positions, ground_.origin);
    if (!read) return fail(node, read.error());
    lines_.cracks.insert(lines_.cracks.end(), read->begin(), read->end());
    lines_.n_cracks.push_back(read->size());
  }

  void read_polygon(const JsonNode& rings, Feature feature) {
    if (error_) return;
    if (rings.kind != Kind::kArray || rings.items.empty()) return fail(rings, "an array of rings is expected");
    feature.number = n_polygons_++;
    for (const JsonNode& node : rings.items) {
      const bool is_hole = &node != &rings.items.front();
      Ring ring = read_ring(node, is_hole);
      if (error_) return;
      if (is_hole && ring.empty()) continue;
      if (is_hole) {
        feature.polygon.holes.push_back(std::move(ring));
      } else {
        feature.polygon.outline = std::move(ring);
      }
    }
    if (!feature.polygon.outline.empty()) features_.push_back(std::move(feature));
  }

  static Coordinate coordinate_of(const JsonNode& number) {
    constexpr std::int64_t kFar = 1'000'000'000'000'000;
    if (!number.integer) return Decimal::parse(number.text);
    if (*number.integer <= -kFar || *number.integer >= kFar) return std::nullopt;
    return Decimal(*number.integer);
  }
  static std::optional<Position> position_of(const JsonNode& node) {
    const auto is_number = [](const JsonNode& item) { return item.kind == Kind::kNumber; };
    if (node.kind != Kind::kArray || node.items.size() < 2 || !std::ranges::all_of(node.items, is_number))
      return std::nullopt;
    return Position{
        coordinate_of(node.items[0]), coordinate_of(node.items[1]), {node.items[0].number, node.items[1].number}};
  }
  std::vector<Position> positions_of(const JsonNode& node, std::string_view what) {
    if (node.kind != Kind::kArray) fail(node, fmt::format("{}, an array of positions, is expected", what));
    std::vector<Position> positions;
    positions.reserve(node.items.size());
    for (const JsonNode& item : node.items) {
      const std::optional<Position> position = position_of(item);
      if (!position) {
        fail(item, "a position of two numbers is expected");
        return {};
      }
      left_out_.n_heights += item.items.size() > 2 ? 1 : 0;
      positions.push_back(*position);
    }
    if (ground_.survey != nullptr) ground_.survey->add(positions);
    return positions;
  }

  Ring read_ring(const JsonNode& node, bool is_hole) {
    const std::vector<Position> positions = positions_of(node, "a ring");
    if (error_ || ground_.survey != nullptr) return {};
    if (!is_hole) ground_.go_to(positions);
    auto ring = ring_from_text(positions, is_hole, ground_.origin);
    if (ring) {
      left_out_.n_thin += ring->empty() ? 1 : 0;
      return *std::move(ring);
    }
    fail(node, ring.error());
    return {};
  }

  std::string_view text_;
  const JsonNode& root_;
  Ground ground_;
  bool wants_lines_ = false, checks_ice_ = false;
  std::int64_t n_features_ = 0;
  std::size_t n_polygons_ = 0;
  LeftOut left_out_;
  Lines lines_;
  std::vector<Feature> features_;
  std::optional<GeometryError> error_;
};

std::string ring_to_text(const Ring& ring, const Origin& origin) {
  std::string text = "[";
  for (const Point p : ring) text += '[' + position_to_text(p, ',', origin) + "],";
  return text + '[' + position_to_text(ring.front(), ',', origin) + "]]";
}

/// The members of the collection before its features.
std::string head_of(const Map& map) {
  std::string text = R"({"type":"FeatureCollection",)";
  if (!map.crs.empty()) text += fmt::format("\"crs\":{},", map.crs);
  if (map.origin != Origin{}) text += fmt::format("\"origin\":[{}],", to_string(map.origin));
  return text + "\"features\":[\n";
}

/// A map of the tree of `text`.
tl::expected<Map, GeometryError> map_of(std::string_view text, const JsonNode& root,
                                        const std::optional<Origin>& origin) {
  Map map;
  auto crs = Reader(text, root, {}).crs();
  if (!crs) return tl::unexpected(std::move(crs).error());
  const auto own = Reader(text, root, {}).origin();
  if (!own) return tl::unexpected(own.error());
  Survey survey;
  if (const auto read = Reader(text, root, {{}, &survey}).features_with_ice(); !read)
    return tl::unexpected(read.error());
  // Another program may have projected the coordinates again and kept the member as it was.
  const bool own_counts = own->has_value() && survey.lies_around(**own);
  map.origin = origin.value_or(own_counts ? **own : survey.origin());
  map.looks_like_degrees = crs->empty() && !origin && !*own && could_be_degrees(survey);
  map.crs = *std::move(crs);
  Reader reader(text, root, {map.origin});
  auto features = reader.features_with_ice();
  if (!features) return tl::unexpected(std::move(features).error());
  map.features = *std::move(features);
  map.left_out = reader.left_out();
  return map;
}

}  // namespace

std::string map_to_geojson(const Map& map) {
  std::string text = head_of(map);
  for (const Feature& feature : map.features) {
    std::string rings = ring_to_text(feature.polygon.outline, map.origin);
    for (const Ring& hole : feature.polygon.holes) rings += ',' + ring_to_text(hole, map.origin);
    const ExactArea size = area(feature.polygon);
    std::string own;
    if (feature.thickness) own += fmt::format(",\"thickness\":{}", *feature.thickness);
    if (feature.flexural_strength) own += fmt::format(",\"flexural_strength\":{}", *feature.flexural_strength);
    text += fmt::format(
        "{{\"type\":\"Feature\",\"properties\":{{\"kind\":{},\"id\":{},\"area\":{},\"area_exact\":\"{}\"{}}},"
        "\"geometry\":{{\"type\":\"Polygon\",\"coordinates\":[{}]}}}}{}\n",
        nlohmann::json(feature.kind).dump(), feature.id, size.square_metres(), size.to_string(), own, rings,
        &feature == &map.features.back() ? "" : ",");
  }
  return text + "]}\n";
}

std::string to_geojson(std::span<const Feature> features) {
  return map_to_geojson(Map{{features.begin(), features.end()}, {}, {}, false});
}

std::vector<Polygon> polygons_of(std::span<const Feature> features) {
  std::vector<Polygon> polygons;
  polygons.reserve(features.size());
  for (const Feature& feature : features) polygons.push_back(feature.polygon);
  return polygons;
}

tl::expected<Lines, GeometryError> read_lines(std::string_view text, const Origin& origin) {
  if (!is_json(text)) return lines_of_wkt(text, origin);
  const tl::expected<JsonNode, GeometryError> root = parse_json(text);
  if (!root) return tl::unexpected(root.error());
  auto crs = Reader(text, *root, {}).crs();
  if (!crs) return tl::unexpected(std::move(crs).error());
  auto lines = Reader(text, *root, {origin}).lines();
  if (lines) lines->crs = *std::move(crs);
  return lines;
}

bool is_json(std::string_view text) {
  text = without_byte_order_mark(text);
  const std::size_t first = text.find_first_not_of(" \t\r\n");
  return first != std::string_view::npos && text[first] == '{';
}

namespace {

/// @param with_ice  whether the ice of features is checked too.
tl::expected<Map, GeometryError> polygons_on(std::string_view text, const Ground& ground, bool with_ice) {
  Map map;
  if (is_json(text)) {
    const tl::expected<JsonNode, GeometryError> root = parse_json(text);
    if (!root) return tl::unexpected(root.error());
    auto crs = Reader(text, *root, {}).crs();
    if (!crs) return tl::unexpected(std::move(crs).error());
    Reader reader(text, *root, ground);
    auto features = with_ice ? reader.features_with_ice() : reader.features();
    if (!features) return tl::unexpected(std::move(features).error());
    map = {*std::move(features), {}, *std::move(crs), false, reader.left_out()};
  } else {
    auto read = map_of_wkt(text, ground);
    if (!read) return read;
    map = *std::move(read);
  }
  map.origin = ground.origin;
  return map;
}

}  // namespace

tl::expected<Map, GeometryError> read_polygons(std::string_view text, const Origin& origin) {
  return polygons_on(text, {origin}, false);
}

tl::expected<Map, GeometryError> read_shapes(std::string_view text) {
  return polygons_on(text, {.origin = {}, .survey = nullptr, .is_own = true}, true);
}

tl::expected<Map, GeometryError> read_map(std::string_view text, const std::optional<Origin>& origin) {
  if (is_json(text)) {
    const tl::expected<JsonNode, GeometryError> root = parse_json(text);
    if (!root) return tl::unexpected(root.error());
    return map_of(text, *root, origin);
  }
  Survey survey;
  if (const auto read = map_of_wkt(text, {{}, &survey}); !read) return tl::unexpected(read.error());
  const Origin place = origin.value_or(survey.origin());
  auto map = map_of_wkt(text, {place});
  if (!map) return map;
  map->origin = place;
  map->looks_like_degrees = map->crs.empty() && !origin && could_be_degrees(survey);
  return map;
}

}  // namespace brash::geometry
