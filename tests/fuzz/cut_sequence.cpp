// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>
#include <cstdint>
#include <cstdlib>

#include "brash/geometry/ice_sheet.hpp"

// libFuzzer: bytes become a sheet and a sequence of cuts on a coarse or a unit lattice, where everything is degenerate.
// A broken contract ends the program, as does an area that is lost.
namespace {

using namespace brash::geometry;

class Bytes {
 public:
  Bytes(const std::uint8_t* data, std::size_t size) : data_(data), size_(size) {}
  bool empty() const { return at_ >= size_; }
  int next() { return empty() ? 0 : data_[at_++]; }
  /// A point of a lattice of 16 x 16, some of them a unit beside it.
  Point point(std::int64_t spacing) {
    const int place = next();
    const int shift = spacing > 4 ? next() : 0;
    return Point::of_units(place % 16 * spacing + shift % 3 - (spacing > 4 ? 1 : 0),
                           place / 16 * spacing + shift / 3 % 3);
  }

 private:
  const std::uint8_t* data_;
  std::size_t size_;
  std::size_t at_ = 0;
};

/// A triangle, or nothing when its points lie on a line.
Ring triangle(Bytes& bytes, std::int64_t spacing) {
  Ring ring{bytes.point(spacing), bytes.point(spacing), bytes.point(spacing)};
  const ExactArea enclosed = signed_area(ring);
  if (enclosed == ExactArea{}) return {};
  if (enclosed < ExactArea{}) std::swap(ring[1], ring[2]);
  return ring;
}

ExactArea total(const std::vector<Polygon>& polygons) {
  ExactArea sum;
  for (const Polygon& polygon : polygons) sum += area(polygon);
  return sum;
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  Bytes bytes(data, size);
  const int kind = bytes.next();
  const std::int64_t spacing = kind % 4 == 0 ? 1 : kind % 4 == 1 ? 3 : std::int64_t{1} << (8 + kind % 29);
  const auto corner = [&](int x, int y) { return Point::of_units(x * spacing, y * spacing); };
  const Polygon whole{{corner(0, 0), corner(15, 0), corner(15, 15), corner(0, 15)}, {}};
  IceSheet sheet = IceSheet::from_polygons(std::vector<Polygon>{whole}).value();
  for (int i = 0; i < 24 && !bytes.empty(); ++i) {
    const ExactArea before = sheet.area();
    const int what = bytes.next();
    if (what % 8 == 0) {
      const ExactArea released = total(sheet.release_detached());
      if (before != sheet.area() + released) std::abort();
    } else {
      const Ring region = triangle(bytes, spacing);
      std::vector<Crack> cracks;
      for (int k = 0; k < what % 4; ++k) cracks.push_back({bytes.point(spacing), bytes.point(spacing)});
      if (region.empty()) continue;
      const Cut cut = what / 32 % 2 == 0 ? sheet.cut(region, cracks) : sheet.crush(region);
      if (before != sheet.area() + total(cut.pieces) + cut.snap) std::abort();
    }
    sheet.check();
  }
  return 0;
}
