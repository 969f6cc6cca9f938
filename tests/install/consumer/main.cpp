// SPDX-License-Identifier: GPL-3.0-or-later
// Cracks a sheet, and asks the failure model that comes with the program.
#include <brash/failure/criterion.hpp>
#include <brash/geometry/ice_sheet.hpp>
#include <brash/geometry/text.hpp>
#include <cstdio>

int main() {
  namespace geometry = brash::geometry;
  const geometry::Map map = geometry::read_polygons("POLYGON ((0 -20, 40 -20, 40 20, 0 20, 0 -20))").value();
  auto sheet = geometry::IceSheet::from_polygons(geometry::polygons_of(map.features));
  const geometry::Cut cut = geometry::cut_circumferential(*sheet, {0.0, 0.0}, 3.5, 4);
  const brash::failure::IceProperties ice{.thickness = 0.33, .youngs_modulus = 0.35e9, .flexural_strength = 539e3};
  const auto criterion = brash::failure::make_criterion(brash::model::FailureModel::kSuperposition, "", ice);
  const auto answer =
      criterion->assess({.depth = 1.0, .contact_length = 0.5, .angle = 1.0, .mu1 = 0.5, .pressure = 5e5});
  std::printf("%zu pieces, breaks: %d\n", cut.pieces.size(), answer.fails);
}
