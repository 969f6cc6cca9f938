// SPDX-License-Identifier: GPL-3.0-or-later
#include "brash/formats/vtk.hpp"

#include <fmt/format.h>

#include <bit>
#include <cstring>
#include <string_view>

#include "brash/core/contract.hpp"

namespace brash::formats {
namespace {

static_assert(std::endian::native == std::endian::little, "the files say LittleEndian");

std::string escaped_xml(std::string_view text) {
  std::string out;
  for (const char c : text) {
    switch (c) {
      case '&':
        out += "&amp;";
        break;
      case '<':
        out += "&lt;";
        break;
      case '>':
        out += "&gt;";
        break;
      case '"':
        out += "&quot;";
        break;
      default:
        out += c;
    }
  }
  return out;
}

/// Arrays that go behind the XML, each with its length in bytes before it.
class Appended {
 public:
  /// @return the element that represents `values` in the XML.
  template <typename T>
  std::string add(const char* type, std::string_view name, int n_components, const std::vector<T>& values) {
    const std::string element = fmt::format(
        "<DataArray type=\"{}\" Name=\"{}\" NumberOfComponents=\"{}\" format=\"appended\" offset=\"{}\"/>\n", type,
        escaped_xml(name), n_components, bytes_.size());
    const std::uint64_t n_bytes = values.size() * sizeof(T);
    append(&n_bytes, sizeof(n_bytes));
    append(values.data(), n_bytes);
    return element;
  }
  const std::string& bytes() const { return bytes_; }

 private:
  void append(const void* from, std::size_t n_bytes) {
    if (n_bytes > 0) bytes_.append(static_cast<const char*>(from), n_bytes);
  }

  std::string bytes_;
};

constexpr const char* kHead =
    "<?xml version=\"1.0\"?>\n<VTKFile type=\"{}\" version=\"1.0\" byte_order=\"LittleEndian\" "
    "header_type=\"UInt64\">\n";

}  // namespace

std::string to_vtp(const PolyData& data) {
  std::vector<double> coordinates;
  for (const Vec3& p : data.points) coordinates.insert(coordinates.end(), {p.x, p.y, p.z});
  std::vector<std::int64_t> connectivity, offsets;
  for (const std::vector<std::int64_t>& face : data.faces) {
    connectivity.insert(connectivity.end(), face.begin(), face.end());
    offsets.push_back(static_cast<std::int64_t>(connectivity.size()));
  }
  Appended appended;
  std::string xml = fmt::format(fmt::runtime(kHead), "PolyData");
  xml += fmt::format("<PolyData>\n<Piece NumberOfPoints=\"{}\" NumberOfPolys=\"{}\">\n", data.points.size(),
                     data.faces.size());
  xml += "<Points>\n" + appended.add("Float64", "Points", 3, coordinates) + "</Points>\n<Polys>\n";
  xml += appended.add("Int64", "connectivity", 1, connectivity) + appended.add("Int64", "offsets", 1, offsets);
  xml += "</Polys>\n<CellData>\n";
  for (const auto& [name, values] : data.cell_data) {
    BRASH_EXPECTS(values.size() == data.faces.size(), name, values.size(), data.faces.size());
    xml += appended.add("Float64", name, 1, values);
  }
  return xml + "</CellData>\n</Piece>\n</PolyData>\n<AppendedData encoding=\"raw\">\n_" + appended.bytes() +
         "\n</AppendedData>\n</VTKFile>\n";
}

std::string to_pvd(const std::vector<VtkStep>& steps) {
  std::string xml = fmt::format(fmt::runtime(kHead), "Collection") + "<Collection>\n";
  for (const VtkStep& step : steps) {
    xml += fmt::format("<DataSet timestep=\"{}\" part=\"{}\" file=\"{}\"/>\n", step.time, step.part,
                       escaped_xml(step.file));
  }
  return xml + "</Collection>\n</VTKFile>\n";
}

}  // namespace brash::formats
