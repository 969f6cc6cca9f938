// SPDX-License-Identifier: GPL-3.0-or-later
#include "chart.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <optional>
#include <utility>

namespace brash::report {
namespace {

std::string escaped(const std::string& text) {
  std::string out;
  for (const char c : text) {
    if (c == '<') {
      out += "&lt;";
    } else if (c == '&') {
      out += "&amp;";
    } else {
      out += c;
    }
  }
  return out;
}

/// Share of the axis at which a value lies.
double share(const ChartAxis& axis, double value) {
  if (!axis.logarithmic) return (value - axis.lower) / (axis.upper - axis.lower);
  return std::log(value / axis.lower) / std::log(axis.upper / axis.lower);
}

/// Powers of ten, and two and five times them on an axis of less than two.
std::vector<double> logarithmic_ticks(const ChartAxis& axis) {
  const double first = std::log10(axis.lower), last = std::log10(axis.upper);
  std::vector<double> values;
  for (double power = std::floor(first); power <= last + 1e-9; power += 1.0)
    for (const double factor : {1.0, 2.0, 5.0}) {
      const double at = power + std::log10(factor);
      if (at >= first - 1e-9 && at <= last + 1e-9 && (factor == 1.0 || last - first < 2.0))
        values.push_back(factor * std::pow(10.0, power));
    }
  return values;
}

/// Two to six round numbers; on a logarithmic axis its own ticks, where it has two at least.
std::vector<double> ticks(const ChartAxis& axis) {
  std::vector<double> values;
  if (axis.logarithmic) {
    values = logarithmic_ticks(axis);
    if (values.size() >= 2) return values;
    values.clear();
  }
  const double span = axis.upper - axis.lower, decade = std::pow(10.0, std::floor(std::log10(span)));
  const double step = decade * (span / decade >= 5.0 ? 2.0 : span / decade >= 2.5 ? 1.0 : 0.5);
  for (double i = std::ceil(axis.lower / step - 1e-9); i * step <= axis.upper + 1e-9 * span; i += 1.0)
    values.push_back(i == 0.0 ? 0.0 : i * step);
  return values;
}

/// A thousand, a million or a billion, as numbers on an axis are shorter in it.
struct Prefix {
  double one = 1.0;
  const char* letter = "";
};

Prefix prefix_of(const ChartAxis& axis) {
  const double largest = std::max(std::abs(axis.lower), std::abs(axis.upper));
  return largest >= 1e9   ? Prefix{1e9, "G"}
         : largest >= 1e6 ? Prefix{1e6, "M"}
         : largest >= 1e4 ? Prefix{1e3, "k"}
                          : Prefix{};
}

/// Where the unit of a label begins, if it takes a prefix: "load [N]".
std::optional<std::size_t> unit_in(const std::string& label) {
  for (const char* const unit : {"[N]", "[N m]", "[J]", "[Pa]", "[N s]"})
    if (label.ends_with(unit)) return label.rfind('[') + 1;
  return std::nullopt;
}

/// The label of an axis, its unit as its numbers are in it.
std::string label_text(const ChartAxis& axis) {
  const auto unit = unit_in(axis.label);
  return unit ? std::string(axis.label).insert(*unit, prefix_of(axis).letter) : axis.label;
}

/// A number as a tick shows it: in the unit of label_text(), or else with the prefix behind it, or a power of ten.
std::string tick_text(const ChartAxis& axis, double value) {
  const Prefix prefix = prefix_of(axis);
  if (unit_in(axis.label)) return fmt::format("{:.4g}", value / prefix.one);
  if (axis.logarithmic) return fmt::format("{:.4g}", value);
  return fmt::format("{:.6g}{}", value / prefix.one, value == 0.0 ? "" : prefix.letter);
}

std::string text_at(double x, double y, const std::string& text, const std::string& attributes) {
  return fmt::format("<text x=\"{:.1f}\" y=\"{:.1f}\" {}>{}</text>\n", x, y, attributes, escaped(text));
}

}  // namespace

std::string axis_label(const std::string& name, const std::string& unit) {
  return unit.empty() ? name : fmt::format("{} [{}]", name, unit);
}

std::vector<double> at_equal_ratios(double first, double last, int n) {
  std::vector<double> values;
  for (int i = 0; i < n; ++i) values.push_back(first * std::pow(last / first, i / (n - 1.0)));
  return values;
}

double upper_end(double lower, double highest) {
  return highest > lower ? highest + 0.05 * (highest - lower) : highest + std::max(1.0, 0.05 * std::abs(highest));
}

Chart::Chart(double left, double top, double width, double height, std::string title, ChartAxis x, ChartAxis y)
    : left_(left),
      top_(top),
      width_(width),
      height_(height),
      title_(std::move(title)),
      x_(std::move(x)),
      y_(std::move(y)) {}

double Chart::page_x(double x) const { return left_ + width_ * share(x_, x); }
double Chart::page_y(double y) const { return top_ + height_ * (1.0 - share(y_, y)); }

bool Chart::drawable(double x, double y) const {
  return std::isfinite(x) && std::isfinite(y) && (!x_.logarithmic || x > 0.0) && (!y_.logarithmic || y > 0.0);
}

void Chart::line(const std::vector<double>& x, const std::vector<double>& y, const std::string& colour, double width) {
  std::string data;
  bool begun = false;
  for (std::size_t i = 0; i < x.size(); ++i) {
    if (!drawable(x[i], y[i])) {
      begun = false;
      continue;
    }
    data += fmt::format("{}{:.1f} {:.1f}", begun ? "L" : "M", page_x(x[i]), page_y(y[i]));
    begun = true;
  }
  content_ += fmt::format("<path d=\"{}\" fill=\"none\" stroke=\"{}\" stroke-width=\"{}\"/>\n", data, colour, width);
}

void Chart::band(const std::vector<double>& x, const std::vector<double>& lower, const std::vector<double>& upper,
                 const std::string& colour) {
  std::vector<double> around = x, values = upper;
  around.insert(around.end(), x.rbegin(), x.rend());
  values.insert(values.end(), lower.rbegin(), lower.rend());
  area(around, values, colour);
}

void Chart::area(const std::vector<double>& x, const std::vector<double>& y, const std::string& colour) {
  std::string data;
  for (std::size_t i = 0; i < x.size(); ++i)
    if (drawable(x[i], y[i]))
      data += fmt::format("{}{:.1f} {:.1f}", data.empty() ? "M" : "L", page_x(x[i]), page_y(y[i]));
  content_ += fmt::format("<path d=\"{}Z\" fill=\"{}\" fill-opacity=\".25\" stroke=\"none\"/>\n", data, colour);
}

void Chart::interval(double value, double lower, double upper, double y, const std::string& colour) {
  line({lower, upper}, {y, y}, colour, 2.0);
  point(value, y, colour, 4.0);
}

void Chart::point(double x, double y, const std::string& colour, double radius) {
  if (!drawable(x, y)) return;
  content_ +=
      fmt::format("<circle cx=\"{:.1f}\" cy=\"{:.1f}\" r=\"{}\" fill=\"{}\"/>\n", page_x(x), page_y(y), radius, colour);
}

void Chart::history(const std::vector<double>& times, const std::vector<double>& values,
                    const std::vector<std::size_t>& cuts, const std::string& colour) {
  constexpr std::size_t kMostPoints = 4000;
  const std::size_t stretch = std::max<std::size_t>(1, 2 * values.size() / kMostPoints);
  for (std::size_t p = 0; p + 1 < cuts.size(); ++p) {
    std::vector<double> x, y;
    for (std::size_t i = cuts[p]; i < cuts[p + 1]; i += stretch) {
      const std::size_t end = std::min(i + stretch, cuts[p + 1]);
      const auto [low, high] = std::minmax_element(values.begin() + static_cast<std::ptrdiff_t>(i),
                                                   values.begin() + static_cast<std::ptrdiff_t>(end));
      for (const auto at : {std::min(low, high), std::max(low, high)}) {
        x.push_back(times[static_cast<std::size_t>(at - values.begin())]);
        y.push_back(*at);
      }
    }
    line(x, y, colour, 0.7);
  }
}

void Chart::words(double x, double y, const std::string& text, const std::string& colour) {
  content_ += text_at(page_x(x), page_y(y), text, fmt::format("style=\"fill:{}\"", colour));
}

std::string Chart::frame() const {
  std::string svg = text_at(left_, top_ - 8.0, title_, "style=\"font-weight:bold\"");
  for (const double value : ticks(x_)) {
    svg += fmt::format("<path d=\"M{0:.1f} {1:.1f}v{2:.1f}\" class=\"grid\"/>\n", page_x(value), top_, height_);
    svg += text_at(page_x(value), top_ + height_ + 15.0, tick_text(x_, value), "text-anchor=\"middle\"");
  }
  for (const double value : y_.label.empty() ? std::vector<double>{} : ticks(y_)) {
    svg += fmt::format("<path d=\"M{0:.1f} {1:.1f}h{2:.1f}\" class=\"grid\"/>\n", left_, page_y(value), width_);
    svg += text_at(left_ - 5.0, page_y(value) + 4.0, tick_text(y_, value), "text-anchor=\"end\"");
  }
  svg += text_at(left_ + 0.5 * width_, top_ + height_ + 31.0, label_text(x_), "text-anchor=\"middle\"");
  if (!y_.label.empty()) {
    const double at = left_ - 52.0, middle = top_ + 0.5 * height_;
    svg += text_at(at, middle, label_text(y_),
                   fmt::format("text-anchor=\"middle\" transform=\"rotate(-90 {:.1f} {:.1f})\"", at, middle));
  }
  return svg;
}

std::string Chart::svg() const {
  // The drawing is cut off at the axes.
  return frame() +
         fmt::format(
             "<svg x=\"{0:.1f}\" y=\"{1:.1f}\" width=\"{2:.1f}\" height=\"{3:.1f}\" viewBox=\"{0:.1f} {1:.1f} "
             "{2:.1f} {3:.1f}\">\n{4}</svg>\n<rect x=\"{0:.1f}\" y=\"{1:.1f}\" width=\"{2:.1f}\" "
             "height=\"{3:.1f}\" fill=\"none\" stroke=\"#333\"/>\n",
             left_, top_, width_, height_, content_);
}

std::string svg_page(double width, double height, const std::string& content, const char* style, const char* ground) {
  return fmt::format(
      "<svg xmlns=\"http://www.w3.org/2000/svg\" viewBox=\"0 0 {0:.0f} {1:.0f}\" width=\"{0:.0f}\" "
      "height=\"{1:.0f}\">\n{2}<rect {3}/>\n{4}</svg>\n",
      width, height, style, ground, content);
}

}  // namespace brash::report
