// SPDX-License-Identifier: GPL-3.0-or-later
#include <fmt/format.h>

#include <algorithm>
#include <nlohmann/json.hpp>
#include <optional>

#include "brash/geometry/text.hpp"
#include "json_tree.hpp"
#include "text_ring.hpp"

namespace brash::geometry {
namespace {

using Kind = JsonNode::Kind;

/// Reads the tree of a GeoJSON text (RFC 7946, in plan metres) into features; stops at the first fault.
class Reader {
 public:
  explicit Reader(std::string_view text) : text_(text) {}

  tl::expected<std::vector<Feature>, GeometryError> read() {
    const tl::expected<JsonNode, GeometryError> root = parse_json(text_);
    if (!root) return tl::unexpected(root.error());
    const std::string type = type_of(*root);
    if (type == "FeatureCollection") {
      if (const JsonNode* features = array(*root, "features")) {
        for (const JsonNode& feature : features->items) read_feature(feature);
      }
    } else if (type == "Feature") {
      read_feature(*root);
    } else {
      read_geometry(*root, Feature{{}, "sheet", 0});
    }
    if (error_) return tl::unexpected(*error_);
    return std::move(features_);
  }

 private:
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
    if (geometry == nullptr || geometry->kind == Kind::kNull) return fail(node, "the feature has no geometry");
    read_geometry(*geometry, feature);
  }

  void read_properties(const JsonNode& properties, Feature& feature) {
    if (const JsonNode* kind = find(properties, "kind")) {
      if (kind->text != "sheet" && kind->text != "floe") {
        return fail(properties, fmt::format("\"kind\" = \"{}\" is neither \"sheet\" nor \"floe\"", kind->text));
      }
      feature.kind = kind->text;
    }
    if (const JsonNode* id = find(properties, "id")) {
      if (!id->integer) return fail(properties, "\"id\" is no whole number of 64 bits");
      feature.id = *id->integer;
    }
  }

  /// Recurs at a GeometryCollection only, and the parser has bounded the depth of those.
  void read_geometry(const JsonNode& node, const Feature& feature) {
    const std::string type = type_of(node);
    if (error_) return;
    if (type == "Polygon") {
      if (const JsonNode* rings = array(node, "coordinates")) read_polygon(*rings, feature);
    } else if (type == "MultiPolygon") {
      if (const JsonNode* polygons = array(node, "coordinates")) {
        for (const JsonNode& rings : polygons->items) read_polygon(rings, feature);
      }
    } else if (type == "GeometryCollection") {
      if (const JsonNode* geometries = array(node, "geometries")) {
        for (const JsonNode& geometry : geometries->items) read_geometry(geometry, feature);
      }
    } else {
      fail(node, fmt::format("{} is not read: FeatureCollection, Feature, Polygon, MultiPolygon or GeometryCollection "
                             "is expected",
                             type.empty() ? "this" : type));
    }
  }

  void read_polygon(const JsonNode& rings, Feature feature) {
    if (error_) return;
    if (rings.kind != Kind::kArray || rings.items.empty()) return fail(rings, "an array of rings is expected");
    for (const JsonNode& node : rings.items) {
      const bool is_hole = &node != &rings.items.front();
      Ring ring = read_ring(node, is_hole);
      if (error_) return;
      if (is_hole) {
        feature.polygon.holes.push_back(std::move(ring));
      } else {
        feature.polygon.outline = std::move(ring);
      }
    }
    features_.push_back(std::move(feature));
  }

  Ring read_ring(const JsonNode& node, bool is_hole) {
    if (node.kind != Kind::kArray) fail(node, "a ring, an array of positions, is expected");
    std::vector<Vec2> positions;
    positions.reserve(node.items.size());
    for (const JsonNode& position : node.items) {
      if (position.kind != Kind::kArray || position.items.size() != 2 || position.items[0].kind != Kind::kNumber ||
          position.items[1].kind != Kind::kNumber) {
        fail(position, "a position of two numbers is expected");
        return {};
      }
      positions.push_back({position.items[0].number, position.items[1].number});
    }
    if (error_) return {};
    auto ring = ring_from_text(positions, is_hole);
    if (ring) return *std::move(ring);
    fail(node, ring.error());
    return {};
  }

  std::string_view text_;
  std::int64_t n_features_ = 0;
  std::vector<Feature> features_;
  std::optional<GeometryError> error_;
};

std::string ring_to_text(const Ring& ring) {
  std::string text = "[";
  for (const Point p : ring) text += '[' + position_to_text(p, ',') + "],";
  return text + '[' + position_to_text(ring.front(), ',') + "]]";
}

}  // namespace

std::string to_geojson(std::span<const Feature> features) {
  std::string text = "{\"type\":\"FeatureCollection\",\"features\":[\n";
  for (const Feature& feature : features) {
    std::string rings = ring_to_text(feature.polygon.outline);
    for (const Ring& hole : feature.polygon.holes) rings += ',' + ring_to_text(hole);
    text += fmt::format(
        "{{\"type\":\"Feature\",\"properties\":{{\"kind\":{},\"id\":{},\"area\":\"{}\"}},"
        "\"geometry\":{{\"type\":\"Polygon\",\"coordinates\":[{}]}}}}{}\n",
        nlohmann::json(feature.kind).dump(), feature.id, area(feature.polygon).to_string(), rings,
        &feature == &features.back() ? "" : ",");
  }
  return text + "]}\n";
}

tl::expected<std::vector<Feature>, GeometryError> from_geojson(std::string_view text) { return Reader(text).read(); }

}  // namespace brash::geometry
