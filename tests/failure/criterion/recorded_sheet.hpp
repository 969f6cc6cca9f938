// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdio>
#include <fstream>
#include <map>
#include <sstream>
#include <stdexcept>
#include <string>
#include <vector>

#include "brash/failure/criterion.hpp"

namespace brash::testing {

/// A solution of a recorded sheet.
struct SheetReference {
  double ratio = 0.0;  ///< largest stress over the strength
  Vec2 place{};        ///< where it is, frame of LoadCase::outline [m]
  /// Stress along the edge at B over the strength, on the surface where a radial crack opens; 0 for a split sheet.
  double radial = 0.0;
};

/// A load case that a run has asked the criterion about.
struct RecordedSheet {
  std::string name;
  failure::IceProperties ice;
  failure::LoadCase load;
  std::map<std::string, SheetReference> references;  ///< by kind and sheet, as "fine whole" or "independent split"
};

namespace sheet_format {

inline void read(std::istream& words, failure::IceProperties& ice) {
  words >> ice.thickness >> ice.youngs_modulus >> ice.poisson_ratio >> ice.flexural_strength >>
      ice.compressive_strength >> ice.crushing_factor >> ice.water_density;
}

inline void read(std::istream& words, failure::SheetMotion& motion) {
  words >> motion.length >> motion.stress >> motion.radial;
}

inline failure::SheetLoad read_load(std::istream& words) {
  failure::SheetLoad load;
  words >> load.from.x >> load.from.y >> load.to.x >> load.to.y >> load.radius >> load.in_plane.x >> load.in_plane.y >>
      load.out_of_plane >> load.moment >> load.has_verdict;
  return load;
}

inline void read_line(const std::string& kind, std::istream& words, RecordedSheet& sheet) {
  failure::LoadCase& load = sheet.load;
  if (kind == "trapezoid") {
    words >> load.depth >> load.contact_length >> load.angle >> load.mu1 >> load.mu2 >> load.pressure;
  } else if (kind == "motion") {
    read(words, load.motion.whole);
    read(words, load.motion.split);
  } else if (kind == "load") {
    load.loads.push_back(read_load(words));
  } else if (kind == "outline") {
    for (Vec2 point; words >> point.x >> point.y;) load.outline.push_back(point);
    if (words.eof()) words.clear();
  } else {  // recorded, fine, independent
    std::string of_sheet;
    SheetReference reference;
    words >> of_sheet >> reference.ratio >> reference.place.x >> reference.place.y >> reference.radial;
    sheet.references[kind + " " + of_sheet] = reference;
  }
}

inline void write(std::FILE* file, const failure::LoadCase& load) {
  std::fprintf(file, "trapezoid %.4f %.4f %.5f %.6g %.6g %.7g\n", load.depth, load.contact_length, load.angle, load.mu1,
               load.mu2, load.pressure);
  const auto& [whole, split] = load.motion;
  std::fprintf(file, "motion %.5f %.5f %.5f %.5f %.5f %.5f\n", whole.length, whole.stress, whole.radial, split.length,
               split.stress, split.radial);
  for (const failure::SheetLoad& one : load.loads)
    std::fprintf(file, "load %.4f %.4f %.4f %.4f %.4f %.0f %.0f %.0f %.0f %d\n", one.from.x, one.from.y, one.to.x,
                 one.to.y, one.radius, one.in_plane.x, one.in_plane.y, one.out_of_plane, one.moment, one.has_verdict);
  std::fprintf(file, "outline");
  for (const Vec2 point : load.outline) std::fprintf(file, " %.3f %.3f", point.x, point.y);
  std::fprintf(file, "\n");
}

}  // namespace sheet_format

/// The sheets of a file of tests/corpus/sheets, whose README describes the format.
/// @throws std::runtime_error for a file without sheets and for a line that is not of the format.
inline std::vector<RecordedSheet> read_sheets(const std::string& path) {
  std::ifstream file(path);
  std::vector<RecordedSheet> sheets;
  failure::IceProperties ice;
  for (std::string line; std::getline(file, line);) {
    std::istringstream words(line);
    std::string kind;
    if (!(words >> kind) || kind.front() == '#') continue;
    if (kind == "ice") {
      sheet_format::read(words, ice);
    } else if (kind == "sheet") {
      sheets.push_back({.name = {}, .ice = ice, .load = {}, .references = {}});
      words >> sheets.back().name;
    } else {
      if (sheets.empty()) throw std::runtime_error(path + ": expected a line \"sheet\" before \"" + kind + "\"");
      sheet_format::read_line(kind, words, sheets.back());
    }
    if (words.fail()) throw std::runtime_error(path + ": cannot read the line \"" + line.substr(0, 60) + "\"");
  }
  if (sheets.empty()) throw std::runtime_error(path + ": expected recorded sheets, found none");
  return sheets;
}

/// Writes one sheet as read_sheets() reads it.
inline void write_sheet(std::FILE* file, const RecordedSheet& sheet) {
  std::fprintf(file, "sheet %s\n", sheet.name.c_str());
  sheet_format::write(file, sheet.load);
  for (const auto& [kind, reference] : sheet.references)
    std::fprintf(file, "%s %.5f %.3f %.3f %.5f\n", kind.c_str(), reference.ratio, reference.place.x, reference.place.y,
                 reference.radial);
}

/// Writes the line of the ice, which holds for the sheets below it.
inline void write_ice(std::FILE* file, const failure::IceProperties& ice) {
  std::fprintf(file, "ice %g %g %g %g %g %g %g\n", ice.thickness, ice.youngs_modulus, ice.poisson_ratio,
               ice.flexural_strength, ice.compressive_strength, ice.crushing_factor, ice.water_density);
}

}  // namespace brash::testing
