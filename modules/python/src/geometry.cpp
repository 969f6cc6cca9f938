// SPDX-License-Identifier: GPL-3.0-or-later
#include <fmt/format.h>

#include <cmath>
#include <stdexcept>
#include <utility>

#include "brash/core/constants.hpp"
#include "brash/geometry/ice_sheet.hpp"
#include "brash/geometry/repair.hpp"
#include "brash/geometry/text.hpp"
#include "brash/geometry/trapezoid.hpp"
#include "brash/geometry/unite.hpp"
#include "convert.hpp"
#include "polygons.hpp"
#include "rooms.hpp"
#include "signals.hpp"

namespace brash::python {
namespace {

using geometry::Cut;
using geometry::IceSheet;
using geometry::Polygon;

/// More radial cracks than anyone breaks ice into, and few enough to draw.
constexpr int kMostWedges = 1000;
/// A full turn and the rounding of its digits [rad]; more of it is of degrees.
constexpr double kMostAngle = 2.0 * kPi + 0.01;
constexpr int kMostSides = 100000;

/// A sheet that threads may read without the GIL. Calls that change it keep the GIL.
struct SharedSheet : IceSheet {
  explicit SharedSheet(IceSheet sheet) : IceSheet(std::move(sheet)) {}
  mutable int n_readers = 0;  ///< counted with the GIL
};

/// One reader, while it lives.
class Reading {
 public:
  explicit Reading(const SharedSheet& sheet) : sheet_(sheet) { ++sheet_.n_readers; }
  Reading(const Reading&) = delete;
  Reading& operator=(const Reading&) = delete;
  ~Reading() { --sheet_.n_readers; }

 private:
  const SharedSheet& sheet_;
};

void expect_unread(const SharedSheet& sheet) {
  if (sheet.n_readers > 0) throw std::runtime_error("this sheet is in use by another thread");
}

SharedSheet make_sheet(const py::object& polygons) {
  const std::vector<Polygon> ice = to_polygons(polygons, "polygons");
  auto sheet = [&] {
    const Released release;
    return IceSheet::from_polygons(ice);
  }();
  if (!sheet) throw InputError("polygons: " + sheet.error().what);
  return SharedSheet(*std::move(sheet));
}

double expect_range(double value, double least, double most, const char* name) {
  if (value >= least && value <= most) return value;
  throw InputError(fmt::format("{} = {}: a number from {} to {} is expected", name, value, least, most));
}

/// Circles and windows are not smaller than this: a thousand units of the grid [m].
constexpr double kLeastRadius = 1e-6;

/// A circle that stays on the grid, of at least `least` [m].
double expect_radius(double radius, Vec2 centre, const char* name, double least = kLeastRadius) {
  const double room = geometry::kMaxCoordinate - std::max(std::abs(centre.x), std::abs(centre.y));
  if (radius >= least && radius <= room) return radius;
  throw InputError(fmt::format("{} = {}: metres from {:g} that keep within +-{} m are expected", name, radius, least,
                               geometry::kMaxCoordinate));
}

Cut cut(SharedSheet& sheet, const py::object& region, const py::object& cracks) {
  const geometry::Ring ring = to_ring(region, "region");
  const std::vector<geometry::Crack> lines =
      cracks.is_none() ? std::vector<geometry::Crack>{} : to_cracks(cracks, "cracks");
  expect_unread(sheet);
  return sheet.cut(ring, lines);
}

Cut cut_circumferential(SharedSheet& sheet, const py::object& centre, double radius, int wedges,
                        const py::object& angles, int sides) {
  const Vec2 at = point(centre, "centre");
  expect_range(wedges, 1, kMostWedges, "wedges");
  expect_range(sides, 3, kMostSides, "sides");
  // The vertices of the circle must not fall together on the grid.
  expect_radius(radius, at, "radius", std::max(kLeastRadius, geometry::kGridUnit * sides));
  expect_unread(sheet);
  if (angles.is_none()) return geometry::cut_circumferential(sheet, at, radius, wedges, sides);
  const Array radians = samples(angles, "angles");
  expect_range(static_cast<double>(radians.size()), 0, kMostWedges, "number of angles");
  for (const double angle : span_of(radians))
    if (!(std::abs(angle) <= kMostAngle))
      throw InputError(fmt::format(
          "angles: {} is not allowed; radians within a full turn, 2 pi, are expected: np.radians([...])", angle));
  return geometry::cut_circumferential(sheet, at, radius, span_of(radians), sides);
}

geometry::FitRequest fit_request(const py::object& at, const py::object& towards, double reach, double contact_length) {
  const Vec2 b = point(at, "at"), direction = point(towards, "towards");
  if (!(norm(direction) > 0.0)) throw InputError("towards = (0, 0): a direction is expected");
  // The window is looked at up to twice the reach away.
  expect_radius(2.0 * reach, b, "twice the reach");
  expect_range(contact_length, 0.0, geometry::kMaxCoordinate, "contact_length");
  return {.at = b, .towards = normalized(direction), .contact_length = contact_length, .reach = reach};
}

geometry::Trapezoid fit(const py::object& ice, const py::object& at, const py::object& towards, double reach,
                        double contact_length) {
  const geometry::FitRequest request = fit_request(at, towards, reach, contact_length);
  if (py::isinstance<SharedSheet>(ice)) {
    const auto& sheet = ice.cast<const SharedSheet&>();
    if (!geometry::leads_into_ice(sheet, request))
      throw InputError(
          fmt::format("towards = ({:.6g}, {:.6g}): leads out of the ice; a direction from `at` into the ice is "
                      "expected",
                      request.towards.x, request.towards.y));
    return geometry::fit_trapezoid(sheet, request);
  }
  std::vector<std::vector<Vec2>> edges;
  if (py::isinstance<py::str>(ice) || !py::isinstance<py::iterable>(ice))
    throw InputError("ice: a sheet or a list of polylines with shape (n, 2) is expected");
  for (const py::handle edge : ice) edges.push_back(points(edge, "ice"));
  return geometry::fit_trapezoid(edges, request);
}

geometry::Union unite_polygons(const py::object& polygons) {
  const std::vector<Polygon> given = to_polygons(polygons, "polygons");
  auto result = [&] {
    const Released release;
    return geometry::unite(given);
  }();
  if (!result) throw InputError("polygons: " + result.error().what);
  return *std::move(result);
}

/// Polygons of texts and arrays may have faults here.
geometry::Repair repair_polygons(const py::object& polygons) {
  const std::vector<Polygon> given = to_polygons(polygons, "polygons");
  auto result = unlocked([&] { return geometry::repair(given); });
  if (!result) throw InputError("polygons: " + result.error().what);
  return *std::move(result);
}

py::list rings_of(std::span<const geometry::Ring> rings) {
  py::list out;
  for (const geometry::Ring& ring : rings) out.append(to_array(ring));
  return out;
}

Polygon polygon_from(const py::object& outline, const py::object& holes) {
  Polygon polygon{geometry::ring(points(outline, "outline")), {}};
  for (const py::handle hole : holes) {
    geometry::Ring ring = geometry::ring(points(hole, "holes"));
    std::reverse(ring.begin() + 1, ring.end());  // as read from a text: it begins at the same vertex
    polygon.holes.push_back(std::move(ring));
  }
  if (const auto alone = IceSheet::from_polygons(std::span(&polygon, 1)); !alone) throw InputError(alone.error().what);
  return polygon;
}

py::dict geo_interface(const Polygon& polygon) {
  const auto closed = [](const geometry::Ring& ring) {
    py::list positions;
    for (std::size_t i = 0; i <= ring.size(); ++i) {
      const Vec2 v = geometry::metres(ring[i % ring.size()]);
      positions.append(py::make_tuple(v.x, v.y));
    }
    return py::tuple(positions);
  };
  py::list rings;
  rings.append(closed(polygon.outline));
  for (const geometry::Ring& hole : polygon.holes) rings.append(closed(hole));
  py::dict out;
  out["type"] = "Polygon";
  out["coordinates"] = py::tuple(rings);
  return out;
}

void add_polygon(py::module_& m) {
  py::class_<Polygon>(m, "Polygon", "A simple polygon with holes on the grid of 2^-30 m, plan coordinates in metres.")
      .def(py::init(&polygon_from), py::arg("outline"), py::arg("holes") = py::tuple(),
           "outline: shape (n, 2) [m], in either orientation; holes: a list of such arrays.")
      .def_static(
          "read", [](const py::object& value) { return to_polygon(value, "value"); }, py::arg("value"),
          "From WKT, GeoJSON, vertices, or an object with __geo_interface__ such as shapely's.")
      .def_property_readonly(
          "outline", [](const Polygon& p) { return to_array(p.outline); },
          "Vertices, counter-clockwise; shape (n, 2) [m].")
      .def_property_readonly(
          "holes", [](const Polygon& p) { return rings_of(p.holes); },
          "Vertices of each hole, clockwise; shape (n, 2) [m].")
      .def_property_readonly(
          "area", [](const Polygon& p) { return geometry::area(p).square_metres(); }, "[m2]")
      .def_property_readonly(
          "exact_area", [](const Polygon& p) { return fraction(geometry::area(p)); },
          "Area as a Fraction [m2]: sums are exact.")
      .def_property_readonly(
          "centroid",
          [](const Polygon& p) {
            const Vec2 c = geometry::centroid(p);
            return to_array(std::array{c.x, c.y});
          },
          "shape (2,) [m]")
      .def(
          "convex_parts", [](const Polygon& p) { return rings_of(geometry::convex_parts(p)); },
          "Convex rings that tile the polygon; shape (n, 2) each [m].")
      .def("to_wkt", [](const Polygon& p) { return geometry::to_wkt(std::span(&p, 1)); })
      .def_property_readonly("__geo_interface__", &geo_interface)
      .def(
          "__eq__", [](const Polygon& a, const Polygon& b) { return a == b; }, py::is_operator(),
          "Whether the grid points are the same, in the same order from the same vertex on.")
      .def(py::pickle([](const Polygon& p) { return py::str(geometry::to_wkt(std::span(&p, 1))); },
                      [](const py::str& text) { return to_polygon(text, "state"); }))
      .def("__repr__", [](const Polygon& p) {
        return fmt::format("<brash.Polygon of {} vertices, {:.6g} m2>", p.outline.size(),
                           geometry::area(p).square_metres());
      });
}

void add_cuts(py::module_& m) {
  py::class_<Cut>(m, "Cut", "What one cut did: area before = after + pieces + snap, exactly.")
      .def_readonly("pieces", &Cut::pieces, "The ice inside the region, split by the cracks.")
      .def_property_readonly(
          "snap", [](const Cut& c) { return fraction(c.snap); },
          "Area that rounding to the grid moved out of the ice, a Fraction [m2].")
      .def_readonly("n_rounded", &Cut::n_rounded, "Vertices that rounding made or led an edge to.");
  py::class_<geometry::Union>(m, "Union", "A union of polygons: given = united + overlap + snap, exactly.")
      .def_readonly("polygons", &geometry::Union::polygons, "Simple and apart, but for common vertices.")
      .def_property_readonly(
          "given", [](const geometry::Union& u) { return fraction(u.given); }, "Of all polygons, a Fraction [m2].")
      .def_property_readonly(
          "united", [](const geometry::Union& u) { return fraction(u.united); }, "Of the union, a Fraction [m2].")
      .def_property_readonly(
          "overlap", [](const geometry::Union& u) { return fraction(u.overlap); },
          "Of places that c polygons cover, c - 1 times, a Fraction [m2].")
      .def_property_readonly(
          "snap", [](const geometry::Union& u) { return fraction(u.snap); },
          "Area that rounding to the grid moved out of the polygons, a Fraction [m2].")
      .def_readonly("n_rounded", &geometry::Union::n_rounded, "Crossings that became new vertices.");
}

void add_repair(py::module_& m) {
  using geometry::Repair;
  py::class_<Repair>(m, "Repair", "Polygons without faults: given = kept + overlap + folded + snap, exactly.")
      .def_property_readonly(
          "polygons",
          [](const Repair& r) {
            std::vector<Polygon> polygons;
            for (const Repair::Part& part : r.parts) polygons.push_back(part.polygon);
            return polygons;
          },
          "Simple and apart, but for common vertices and edges.")
      .def_property_readonly(
          "sources",
          [](const Repair& r) {
            std::vector<std::size_t> sources;
            for (const Repair::Part& part : r.parts) sources.push_back(part.from);
            return sources;
          },
          "Number of the given polygon that each of `polygons` is of.")
      .def_readonly("changed", &Repair::changed, "Numbers of the given polygons whose shape is another one.")
      .def_readonly("gone", &Repair::gone, "Those of them that nothing is left of.")
      .def_property_readonly(
          "faults",
          [](const Repair& r) {
            std::vector<std::string> faults;
            for (const geometry::Fault& fault : r.faults) faults.push_back(fault.what);
            return faults;
          },
          "The faults that were repaired, in words.")
      .def_property_readonly(
          "given", [](const Repair& r) { return fraction(r.given); }, "Of all given polygons, a Fraction [m2].")
      .def_property_readonly(
          "kept", [](const Repair& r) { return fraction(r.kept); }, "Of `polygons`, a Fraction [m2].")
      .def_property_readonly(
          "overlap", [](const Repair& r) { return fraction(r.overlap); },
          "Of places that c polygons cover, c - 1 times, a Fraction [m2].")
      .def_property_readonly(
          "folded", [](const Repair& r) { return fraction(r.folded); },
          "That outlines which cross themselves count wrongly, a Fraction [m2].")
      .def_property_readonly(
          "snap", [](const Repair& r) { return fraction(r.snap); },
          "Area that rounding to the grid moved out of the polygons, a Fraction [m2].");
}

void add_contacts(py::module_& m) {
  py::class_<geometry::Trapezoid>(m, "Trapezoid", "The ice in front of a contact as the paper's trapezoid (Fig. 2).")
      .def_readonly("depth", &geometry::Trapezoid::depth, "b [m]")
      .def_readonly("contact_length", &geometry::Trapezoid::contact_length, "c [m]")
      .def_readonly("angle", &geometry::Trapezoid::angle, "theta [rad]")
      .def_readonly("error", &geometry::Trapezoid::error, "Area between fit and edge over the window's area.")
      .def_readonly("reidentified", &geometry::Trapezoid::reidentified, "The edge had to be re-identified (Fig. 4).")
      .def("__repr__", [](const geometry::Trapezoid& t) {
        return fmt::format("<brash.Trapezoid b = {:.4g} m, c = {:.4g} m, theta = {:.4g} deg, error {:.3g}>", t.depth,
                           t.contact_length, degrees(t.angle), t.error);
      });
  py::class_<geometry::ContactRegion>(m, "ContactRegion", "One connected overlap of a section with the ice.")
      .def_readonly("overlap", &geometry::ContactRegion::overlap, "The overlap itself, a Polygon.")
      .def_readonly("contact_length", &geometry::ContactRegion::contact_length, "c [m]")
      .def_property_readonly(
          "midpoint",
          [](const geometry::ContactRegion& r) {
            return to_array(std::array{r.midpoint.x, r.midpoint.y});
          },
          "Collision point B, shape (2,) [m].")
      .def_property_readonly(
          "normal",
          [](const geometry::ContactRegion& r) {
            return to_array(std::array{r.normal.x, r.normal.y});
          },
          "Unit normal of the chord into the ice, shape (2,).");
}

py::object contains(const SharedSheet& sheet, const py::object& where) {
  const Array array = numbers(where, "points");
  if (array.ndim() == 1) return py::bool_(sheet.contains(point(array, "points")));
  const std::vector<Vec2> all = points(array, "points");
  py::array_t<bool> inside(static_cast<py::ssize_t>(all.size()));
  auto view = inside.mutable_unchecked<1>();
  const Reading reading(sheet);
  without_gil(all.size(), [&](std::size_t i) { view(static_cast<py::ssize_t>(i)) = sheet.contains(all[i]); });
  return inside;
}

py::list free_edge(const SharedSheet& sheet, const py::object& at, double radius) {
  const Vec2 b = point(at, "at");
  py::list chains;
  for (const std::vector<Vec2>& chain : sheet.free_edge(b, expect_radius(radius, b, "radius")))
    chains.append(to_array(chain));
  return chains;
}

void add_sheet(py::module_& m) {
  py::class_<SharedSheet>(m, "IceSheet",
                          R"(The ice sheet: its free edges as an exact polygon set on the grid of 2^-30 m.

The cost of a cut or a query is that of the edges near it, whatever the size of the sheet.

>>> sheet = brash.IceSheet([[0, -25], [50, -25], [50, 25], [0, 25]])
>>> cut = sheet.cut_circumferential([0, 0], radius=3, wedges=4)
>>> len(cut.pieces)
4)")
      .def(py::init(&make_sheet), py::arg("polygons"),
           "polygons: vertices with shape (n, 2) [m], WKT, GeoJSON, a Polygon or shapely geometry, or a list; "
           "simple and disjoint. Those with a common edge become one part.")
      .def(py::pickle([](const SharedSheet& s) { return py::str(geometry::to_wkt(s.polygons())); },
                      [](const py::str& text) { return make_sheet(text); }))
      .def_property_readonly(
          "area", [](const SharedSheet& s) { return s.area().square_metres(); }, "[m2]")
      .def_property_readonly(
          "exact_area", [](const SharedSheet& s) { return fraction(s.area()); }, "A Fraction [m2].")
      .def_property_readonly("n_vertices", &IceSheet::n_vertices)
      .def("polygons", &IceSheet::polygons, "The connected parts with their holes.")
      .def("contains", &contains, py::arg("points"), "shape (2,) -> bool; shape (n, 2) -> shape (n,).")
      .def(
          "cut", &cut, py::arg("region"), py::arg("cracks") = py::none(),
          "Takes the ice inside `region` (one simple polygon) out and splits it along `cracks` [m]: the two ends of "
          "each, shape (n, 2, 2), or lines as WKT, GeoJSON, vertices or geometries, one or a sequence. A region around "
          "the sheet takes all of it.")
      .def("cut_circumferential", &cut_circumferential, py::arg("centre"), py::arg("radius"), py::arg("wedges") = 4,
           py::arg("angles") = py::none(), py::arg("sides") = 16,
           "Breaks the ice within `radius` [m] of `centre`, shape (2,), free and divides it by radial cracks: evenly "
           "into `wedges`, or at `angles` [rad], counter-clockwise from x. A hole that reaches across a wedge divides "
           "it. "
           "`sides`: chords of the full circle.")
      .def(
          "release_detached",
          [](SharedSheet& s) {
            expect_unread(s);
            return s.release_detached();
          },
          "Takes every part but the largest out of the sheet and returns them.")
      .def(
          "contacts",
          [](const SharedSheet& s, const py::object& section) { return s.contacts(to_ring(section, "section")); },
          py::arg("section"), "Overlaps of a simple section with the ice; a hollow one may have several.")
      .def(
          "within", [](const SharedSheet& s, const py::object& window) { return s.within(to_ring(window, "window")); },
          py::arg("window"), "The ice inside the window as polygons, without taking it.")
      .def("free_edge", &free_edge, py::arg("at"), py::arg("radius"),
           "Polylines of ice boundary within `radius` [m] of `at`, ice on the left, the nearest first; shape (n, 2).")
      .def("to_wkt", [](const SharedSheet& s) { return geometry::to_wkt(s.polygons()); })
      .def("check", &IceSheet::check, "Raises ContractViolation unless the sheet is consistent.")
      .def("__repr__", [](const SharedSheet& s) {
        return fmt::format("<brash.IceSheet of {:.6g} m2, {} vertices>", s.area().square_metres(), s.n_vertices());
      });
}

void add_functions(py::module_& m) {
  m.def("unite", &unite_polygons, py::arg("polygons"),
        "Unites polygons, which may overlap, touch or be there twice; each is simple. `polygons`: as of IceSheet.");
  m.def(
      "repair", &repair_polygons, py::arg("polygons"),
      "Removes crossings and overlaps. A place is ice of a polygon if its outline winds around it and no hole does; a "
      "place of several polygons goes to the first of them. `polygons`: as of IceSheet, of any shape.");
  m.def("fit_trapezoid", &fit, py::arg("ice"), py::arg("at"), py::arg("towards"), py::arg("reach"),
        py::arg("contact_length") = 0.0,
        "Fits the trapezoid (b, c, theta) to the free edge of a sheet, or to polylines with the ice on their left.\n\n"
        "at: collision point B on the edge, shape (2,) [m]; towards: direction into the ice, of any length; reach: "
        "half width of the window, about a characteristic length [m] (a run takes two); contact_length: c where it is "
        "known [m]. Where no edge is in the window, b is 0 and the error 1.");
}

}  // namespace

void add_geometry(py::module_& m) {
  add_polygon(m);
  add_cuts(m);
  add_repair(m);
  add_contacts(m);
  add_sheet(m);
  add_functions(m);
}

}  // namespace brash::python
