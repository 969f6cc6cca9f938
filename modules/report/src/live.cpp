// SPDX-License-Identifier: GPL-3.0-or-later
#include "brash/report/live.hpp"

#include <array>
#include <charconv>
#include <cmath>
#include <initializer_list>
#include <utility>

#include "brash/core/contract.hpp"
#include "brash/io/result_columns.hpp"

namespace brash::report {
namespace {

using Rings = std::vector<std::vector<Vec2>>;

/// Lengths and attitudes are sent in steps of 0.1 mm and 1e-4.
constexpr double kPerUnit = 1e4;

std::int64_t rounded(double value) { return std::llround(kPerUnit * value); }

/// JSON as text, without a tree in between: records are many, and the run waits for them.
class Json {
 public:
  void number(double value) {
    if (std::isfinite(value))
      digits(value);
    else
      text_ += "null";
  }
  void number(std::int64_t value) { digits(value); }
  void key(const std::string& name) {
    text_ += '"';
    text_ += name;
    text_ += "\":";
  }

  /// What `write` writes for each of `items`, between brackets.
  template <typename Items, typename Write>
  void array(const Items& items, Write write) {
    text_ += '[';
    bool first = true;
    for (const auto& item : items) {
      if (!std::exchange(first, false)) text_ += ',';
      write(item);
    }
    text_ += ']';
  }
  void raw(char c) { text_ += c; }
  std::string text() && { return std::move(text_); }

 private:
  /// The fewest digits that give the same number back.
  template <typename Number>
  void digits(Number value) {
    std::array<char, 32> buffer{};  // a double takes 24 at most
    const auto [end, error] = std::to_chars(buffer.data(), buffer.data() + buffer.size(), value);
    BRASH_EXPECTS(error == std::errc(), value);
    text_.append(buffer.data(), end);
  }

  std::string text_;
};

/// The columns of rows under the names of a report's blocks.
template <typename Row>
void columns(Json& json, const std::string& name, const std::vector<Row>& rows) {
  json.key(name);
  json.raw('{');
  bool first = true;
  io::Columns<Row>::visit([&](const std::string& column, const char*, const std::string&, auto member) {
    if (!std::exchange(first, false)) json.raw(',');
    json.key(column);
    json.array(rows, [&](const Row& row) { json.number(static_cast<double>(member(row))); });
  });
  json.raw('}');
  json.raw(',');
}

/// Rings as x, y, x, y, ...
void rings(Json& json, const Rings& all) {
  json.array(all, [&](const std::vector<Vec2>& ring) {
    json.array(ring, [&](Vec2 node) {
      json.number(rounded(node.x));
      json.raw(',');
      json.number(rounded(node.y));
    });
  });
}

void numbers(Json& json, std::initializer_list<std::int64_t> values) {
  json.array(values, [&](std::int64_t value) { json.number(value); });
}

/// A floe, its place and attitude, its contact force [N].
void pose(Json& json, const model::FloePose& at) {
  const auto& [p, q] = at.pose;
  numbers(json, {at.floe, rounded(p.x), rounded(p.y), rounded(p.z), rounded(q.w), rounded(q.x), rounded(q.y),
                 rounded(q.z), std::llround(at.contact_force)});
}

void sheet(Json& json, double time, const Rings& outline) {
  json.raw('{');
  json.key("time");
  json.number(time);
  json.raw(',');
  json.key("rings");
  rings(json, outline);
  json.raw('}');
}

}  // namespace

std::string live_records(const model::RunResults& part, const std::vector<EndedFloe>& ended) {
  Json json;
  json.raw('{');
  columns(json, "load", part.loads);
  columns(json, "event", part.events);
  columns(json, "split", part.splits);
  columns(json, "floe", part.floes);
  columns(json, "frame", part.frames);
  json.key("outlines");
  json.array(part.floes, [&](const model::FloeRecord& floe) { rings(json, floe.rings); });
  json.raw(',');
  json.key("ended");
  json.array(ended, [&](const EndedFloe& each) {
    json.array(std::initializer_list<double>{static_cast<double>(each.floe), each.time, static_cast<double>(each.end)},
               [&](double value) { json.number(value); });
  });
  json.raw(',');
  json.key("poses");
  json.array(part.frames, [&](const model::Frame& frame) {
    json.array(frame.floes, [&](const model::FloePose& at) { pose(json, at); });
  });
  json.raw(',');
  json.key("sheets");
  std::vector<model::CrackedSheet> sheets = part.cracked_sheets;
  if (!part.initial_sheet.empty()) sheets.insert(sheets.begin(), {0.0, part.initial_sheet});
  json.array(sheets, [&](const model::CrackedSheet& each) { sheet(json, each.time, each.rings); });
  json.raw('}');
  return std::move(json).text();
}

}  // namespace brash::report
