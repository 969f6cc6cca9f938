// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <cstddef>
#include <string>
#include <vector>

namespace brash::report {

/// Colours of the lines of one chart, in turn.
constexpr std::array<const char*, 6> kLineColours{"#1f4e79", "#b3261e", "#2e7d32", "#8e6c00", "#6a1b9a", "#00838f"};

/// One axis of a chart.
struct ChartAxis {
  std::string label;
  double lower = 0.0;
  double upper = 1.0;
  bool logarithmic = false;  ///< then lower > 0
};

/// "load [N]": the label of an axis; without a unit the name alone.
std::string axis_label(const std::string& name, const std::string& unit);

/// `n` values from `first` to `last` at equal ratios.
std::vector<double> at_equal_ratios(double first, double last, int n);

/// The upper end of an axis that begins at `lower`: a little above the highest value on it.
double upper_end(double lower, double highest);

/// Axes with lines on them, as part of an SVG picture. Lengths in pixels, y downwards.
class Chart {
 public:
  /// @param left, top      corner of the plotted area.
  /// @param width, height  of the plotted area.
  Chart(double left, double top, double width, double height, std::string title, ChartAxis x, ChartAxis y);

  /// A line through the points that can be drawn; a value that is not positive on a logarithmic axis breaks it.
  void line(const std::vector<double>& x, const std::vector<double>& y, const std::string& colour, double width = 1.0);
  /// The area between two curves.
  void band(const std::vector<double>& x, const std::vector<double>& lower, const std::vector<double>& upper,
            const std::string& colour);
  /// A curve in its band.
  void curve(const std::vector<double>& x, const std::vector<double>& y, const std::vector<double>& lower,
             const std::vector<double>& upper, const std::string& colour, double width = 1.5) {
    band(x, lower, upper, colour);
    line(x, y, colour, width);
  }
  /// The area within an outline.
  void area(const std::vector<double>& x, const std::vector<double>& y, const std::string& colour);
  /// A dot; left out where it cannot be drawn.
  void point(double x, double y, const std::string& colour, double radius);
  /// A line through the least and the largest value of each stretch of a history, as many as a picture can show.
  /// @param cuts  first sample of each piece, and their number: gaps stay open.
  void history(const std::vector<double>& times, const std::vector<double>& values,
               const std::vector<std::size_t>& cuts, const std::string& colour);
  /// A point with a horizontal interval at the height y.
  void interval(double value, double lower, double upper, double y, const std::string& colour);
  /// Words that begin at a point of the axes.
  void words(double x, double y, const std::string& text, const std::string& colour = "#000");

  std::string svg() const;

 private:
  double page_x(double x) const;
  double page_y(double y) const;
  bool drawable(double x, double y) const;
  std::string frame() const;

  double left_, top_, width_, height_;
  std::string title_;
  ChartAxis x_, y_;
  std::string content_;
};

constexpr const char* kChartStyle = "<style>text{font:12px sans-serif;fill:#111}.grid{stroke:#ddd;fill:none}</style>\n";

/// A whole picture of charts, or of drawings in their own style.
/// @param ground  attributes of the rectangle behind them.
std::string svg_page(double width, double height, const std::string& content, const char* style = kChartStyle,
                     const char* ground = "width=\"100%\" height=\"100%\" fill=\"#fff\"");

}  // namespace brash::report
