// SPDX-License-Identifier: GPL-3.0-or-later
#include "json_tree.hpp"

#include <fmt/format.h>

#include <iterator>
#include <limits>
#include <nlohmann/json.hpp>

#include "text_ring.hpp"

namespace brash::geometry {
namespace {

/// Walks over the text and says how far the parser has come.
class CountingIterator {
 public:
  using iterator_category = std::input_iterator_tag;
  using value_type = char;
  using difference_type = std::ptrdiff_t;
  using pointer = const char*;
  using reference = const char&;

  CountingIterator(const char* at, const char** reached) : at_(at), reached_(reached) {}
  reference operator*() const { return *at_; }
  CountingIterator& operator++() {
    *reached_ = ++at_;
    return *this;
  }
  friend bool operator==(const CountingIterator& a, const CountingIterator& b) { return a.at_ == b.at_; }

 private:
  const char* at_;
  const char** reached_;
};

/// Builds the tree from the parser's events; a return of false ends the parse.
class TreeBuilder : public nlohmann::json_sax<nlohmann::json> {
 public:
  explicit TreeBuilder(std::string_view text) : text_(text), reached_(text.data()) {}

  CountingIterator begin() { return {text_.data(), &reached_}; }
  CountingIterator end() { return {text_.data() + text_.size(), &reached_}; }
  const std::optional<GeometryError>& error() const { return error_; }
  JsonNode take() { return std::move(root_); }

  bool null() override { return add({}); }
  bool boolean(bool) override { return add(node(JsonNode::Kind::kBoolean)); }
  bool number_integer(number_integer_t value) override {
    JsonNode result = node(JsonNode::Kind::kNumber);
    result.number = static_cast<double>(value);
    result.integer = value;
    return add(std::move(result));
  }
  bool number_unsigned(number_unsigned_t value) override {
    JsonNode result = node(JsonNode::Kind::kNumber);
    result.number = static_cast<double>(value);
    if (value <= static_cast<number_unsigned_t>(std::numeric_limits<std::int64_t>::max())) {
      result.integer = static_cast<std::int64_t>(value);
    } else {
      result.text = fmt::format("{}", value);
    }
    return add(std::move(result));
  }
  bool number_float(number_float_t value, const string_t& written) override {
    JsonNode result = node(JsonNode::Kind::kNumber);
    result.number = value;
    result.text = written;
    return add(std::move(result));
  }
  bool string(string_t& value) override {
    JsonNode result = node(JsonNode::Kind::kString);
    result.text = value;
    return add(std::move(result));
  }
  bool binary(binary_t&) override { return false; }
  bool key(string_t& name) override {
    open_.back()->names.push_back(name);
    return true;
  }
  bool start_object(std::size_t) override { return open(JsonNode::Kind::kObject); }
  bool start_array(std::size_t) override { return open(JsonNode::Kind::kArray); }
  bool end_object() override { return close(); }
  bool end_array() override { return close(); }
  bool parse_error(std::size_t position, const std::string&, const nlohmann::detail::exception& fault) override {
    // The library puts its own place in front: "[...] parse error at line 1, column 2: reason".
    const std::string_view message = fault.what();
    const std::size_t place = message.find("column ");
    const std::size_t colon = place == std::string_view::npos ? place : message.find(": ", place);
    error_ = error_at(text_, position == 0 ? 0 : position - 1,
                      colon == std::string_view::npos ? message : message.substr(colon + 2));
    return false;
  }

 private:
  static JsonNode node(JsonNode::Kind kind) {
    JsonNode result;
    result.kind = kind;
    return result;
  }
  JsonNode* add_node(JsonNode value) {
    if (open_.empty()) return &(root_ = std::move(value));
    return &open_.back()->items.emplace_back(std::move(value));
  }
  bool add(JsonNode value) {
    value.offset = open_.empty() ? 0 : open_.back()->offset;
    add_node(std::move(value));
    return true;
  }
  bool open(JsonNode::Kind kind) {
    JsonNode value = node(kind);
    value.offset = static_cast<std::size_t>(reached_ - text_.data()) - 1;
    if (open_.size() == kMaxJsonDepth) {
      error_ = error_at(text_, value.offset, fmt::format("nested deeper than {}", kMaxJsonDepth));
      return false;
    }
    // Only the last item of each open node grows, so the pointers below it on the stack stay good.
    open_.push_back(add_node(std::move(value)));
    return true;
  }
  bool close() {
    open_.pop_back();
    return true;
  }

  std::string_view text_;
  const char* reached_;
  JsonNode root_;
  std::vector<JsonNode*> open_;
  std::optional<GeometryError> error_;
};

}  // namespace

tl::expected<JsonNode, GeometryError> parse_json(std::string_view text) {
  TreeBuilder builder(text);
  const bool is_good = nlohmann::json::sax_parse(builder.begin(), builder.end(), &builder);
  if (!is_good) return tl::unexpected(builder.error().value_or(GeometryError{"not a JSON text"}));
  return builder.take();
}

}  // namespace brash::geometry
