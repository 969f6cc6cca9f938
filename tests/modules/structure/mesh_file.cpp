// SPDX-License-Identifier: GPL-3.0-or-later
// Meshes from files: repaired, or refused with places.
#include "brash/structure/mesh_file.hpp"

#include <algorithm>
#include <boost/test/unit_test.hpp>
#include <filesystem>
#include <fstream>
#include <random>

#include "meshes.hpp"
#include "triangle_mesh.hpp"

namespace {

using namespace brash;
using namespace brash::structure;
using namespace brash::structure::test;

const auto kExact = boost::test_tools::tolerance(1e-12);
const auto kFloat = boost::test_tools::tolerance(1e-6);  // the numbers of a binary STL have 24 bits

const TriangleMesh kBox = box({-10.0, -2.0, -3.0}, {10.0, 2.0, 1.0});

/// The error of a mesh that is no hull.
std::string refusal(const TriangleMesh& mesh) {
  const auto read = read_mesh(off(mesh), "off");
  BOOST_REQUIRE(!read);
  BOOST_TEST(!read.error().allowed.empty());
  BOOST_TEST(!read.error().remedy.empty());
  return read.error().what;
}

bool says(const std::string& text, const std::string& part) { return text.find(part) != std::string::npos; }

BOOST_AUTO_TEST_SUITE(mesh_file)

BOOST_AUTO_TEST_CASE(every_format_gives_the_same_closed_box) {
  const std::vector<std::pair<std::string, std::string>> files{
      {"off", off(kBox)}, {"obj", obj(kBox)}, {"ply", ply(kBox)}, {"stl", ascii_stl(kBox)}, {"stl", binary_stl(kBox)}};
  for (const auto& [kind, bytes] : files) {
    const auto read = read_mesh(bytes, kind);
    BOOST_REQUIRE(read.has_value());
    BOOST_TEST(signed_volume(read->mesh) == 320.0, kFloat);
    BOOST_TEST(read->mesh.vertices.size() == 8U, kind);
    BOOST_TEST(read->report.n_triangles == 12);
    BOOST_TEST(read->report.n_turned == 0);
    BOOST_TEST(read->report.n_shells == 1);
  }
}

BOOST_AUTO_TEST_CASE(an_obj_file_may_continue_lines_and_have_lines_as_elements) {
  const std::string cube =
      "# C:\\ships\\\nv -1 -1 -1\nv 1 -1 -1\nv 1 1 -1\nv -1 1 -1\nv -1 -1 1\nv 1 -1 1\nv 1 1 1\nv -1 1 1\ng f Three\n"
      "f 4 3 \\\n2 1\nf 5 6 \\\r\n 7\\\r\n 8\nf 1\t2\t6\t5\nf 2 3 7 6\nf 3 4 8 7\nl 1 2\nf 4 1 5 8\nl\t3 \\\n4";
  const auto read = read_mesh(cube, "obj");
  BOOST_REQUIRE(read.has_value());
  BOOST_TEST(signed_volume(read->mesh) == 8.0, kExact);
  BOOST_TEST(read->report.n_dropped == 0);
}

BOOST_AUTO_TEST_CASE(a_face_of_four_corners_is_two_triangles) {
  const std::string cube =
      "OFF\n8 6 0\n0 0 0\n1 0 0\n1 1 0\n0 1 0\n0 0 1\n1 0 1\n1 1 1\n0 1 1\n"
      "4 0 3 2 1\n4 4 5 6 7\n4 0 1 5 4\n4 1 2 6 5\n4 2 3 7 6\n4 3 0 4 7\n";
  const auto read = read_mesh(cube, "off");
  BOOST_REQUIRE(read.has_value());
  BOOST_TEST(read->report.n_read == 12);
  BOOST_TEST(signed_volume(read->mesh) == 1.0, kExact);
}

BOOST_AUTO_TEST_CASE(flipped_faces_are_turned_outwards_and_counted) {
  TriangleMesh mesh = sphere({}, 5.0, 12);
  for (const std::size_t t : {3U, 57U, 200U}) std::swap(mesh.triangles[t][0], mesh.triangles[t][1]);
  const auto some = read_mesh(off(mesh), "off");
  BOOST_REQUIRE(some.has_value());
  BOOST_TEST(some->report.n_turned == 3);
  BOOST_TEST(signed_volume(some->mesh) == signed_volume(sphere({}, 5.0, 12)), kExact);
  TriangleMesh inside_out = kBox;
  for (auto& triangle : inside_out.triangles) std::swap(triangle[0], triangle[1]);
  const auto all = read_mesh(off(inside_out), "off");
  BOOST_REQUIRE(all.has_value());
  BOOST_TEST(all->report.n_turned == 12);
  BOOST_TEST(signed_volume(all->mesh) == 320.0, kExact);
}

BOOST_AUTO_TEST_CASE(triangles_that_are_there_twice_or_have_no_area_are_dropped_and_counted) {
  TriangleMesh mesh = kBox;
  mesh.triangles.push_back(mesh.triangles[4]);
  mesh.triangles.push_back({1, 1, 2});
  const auto read = read_mesh(off(mesh), "off");
  BOOST_REQUIRE(read.has_value());
  BOOST_TEST(read->report.n_dropped == 2);
  BOOST_TEST(signed_volume(read->mesh) == 320.0, kExact);
}

BOOST_AUTO_TEST_CASE(a_lost_triangle_of_a_fine_mesh_is_filled_and_counted) {
  TriangleMesh mesh = sphere({}, 5.0, 200);
  mesh.triangles.erase(mesh.triangles.begin() + 40000);
  const auto read = read_mesh(off(mesh), "off");
  BOOST_REQUIRE(read.has_value());
  BOOST_TEST(read->report.n_holes_filled == 1);
  BOOST_TEST(signed_volume(read->mesh) == signed_volume(sphere({}, 5.0, 200)), boost::test_tools::tolerance(1e-9));
}

BOOST_AUTO_TEST_CASE(an_open_deck_and_large_holes_are_named_with_their_places) {
  TriangleMesh open = kBox;
  open.triangles.erase(open.triangles.begin() + 2, open.triangles.begin() + 4);
  const std::string deck = refusal(open);
  BOOST_TEST(says(deck, "1 hole,"), deck);
  BOOST_TEST(says(deck, "of 4 edges from (-10, -2, 1) to (10, 2, 1)"), deck);
  TriangleMesh leaky = sphere({}, 5.0, 12);
  leaky.triangles.erase(leaky.triangles.begin() + 300);
  leaky.triangles.erase(leaky.triangles.begin() + 10);
  BOOST_TEST(says(refusal(leaky), "2 holes, "), refusal(leaky));
}

/// The triangles of a mesh, each with corners of its own, as an STL file has them.
TriangleMesh apart(const TriangleMesh& mesh) {
  TriangleMesh result;
  for (std::size_t t = 0; t < mesh.triangles.size(); ++t) {
    const int first = static_cast<int>(result.vertices.size());
    for (const Vec3 v : corners(mesh, t)) result.vertices.push_back(v);
    result.triangles.push_back({first, first + 1, first + 2});
  }
  return result;
}

BOOST_AUTO_TEST_CASE(vertices_that_differ_by_round_off_are_one_where_that_closes_the_mesh) {
  const TriangleMesh ball = sphere({}, 5.0, 12);
  for (const auto& [noise, is_read] :
       {std::pair{1e-15, true}, {1e-9, true}, {1e-7, true}, {5e-6, true}, {1e-3, false}}) {
    TriangleMesh mesh = apart(ball);
    std::mt19937 random(5);
    std::uniform_real_distribution<double> shift(-noise, noise);
    for (Vec3& v : mesh.vertices) v += Vec3{shift(random), shift(random), shift(random)};
    const auto read = read_mesh(off(mesh), "off");
    BOOST_REQUIRE(read.has_value() == is_read);
    if (!is_read) continue;
    BOOST_TEST(read->report.n_joined > 0);
    BOOST_TEST(read->report.n_holes_filled == 0);
    BOOST_TEST(signed_volume(read->mesh) == signed_volume(ball), boost::test_tools::tolerance(1e-5));
  }
  // Where nothing is open nothing is joined, however close.
  TriangleMesh thin = box({0.0, 0.0, 0.0}, {1.0, 1.0, 1e-7});
  BOOST_TEST(read_mesh(off(thin), "off")->report.n_joined == 0);
}

BOOST_AUTO_TEST_CASE(an_inner_deck_is_named_with_the_edge_where_three_faces_meet) {
  TriangleMesh decked = kBox;
  for (const Vec3 v : {Vec3{-10, -2, 0}, {10, -2, 0}, {10, 2, 0}, {-10, 2, 0}}) decked.vertices.push_back(v);
  // The sides as two storeys, and a deck between them.
  decked.triangles.erase(decked.triangles.begin() + 4, decked.triangles.end());
  for (const int low : {0, 8})
    for (int i = 0; i < 4; ++i) {
      const int next = (i + 1) % 4, high = low == 0 ? 8 : 4;
      decked.triangles.push_back({low + i, low + next, high + next});
      decked.triangles.push_back({low + i, high + next, high + i});
    }
  BOOST_TEST(signed_volume(read_mesh(off(decked), "off")->mesh) == 320.0, kExact);
  decked.triangles.push_back({8, 9, 10});
  decked.triangles.push_back({8, 10, 11});
  const std::string what = refusal(decked);
  BOOST_TEST(says(what, "4 edges in which three faces or more meet, one from ("), what);
  BOOST_TEST(!says(what, "is open"), what);
}

BOOST_AUTO_TEST_CASE(a_ship_that_is_turned_is_doubted_with_the_key_that_turns_it_back) {
  // A hull with a pointed bow and sides that flare.
  const TriangleMesh upright = [] {
    TriangleMesh mesh = prism({{-15, -4}, {5, -4}, {15, 0}, {5, 4}, {-15, 4}}, -3.0, 2.0);
    for (Vec3& v : mesh.vertices)
      if (v.z < 0.0) v.y *= 0.4;
    return mesh;
  }();
  const auto bearing_when = [&](double x, double y, double z, bool swaps) {
    TriangleMesh mesh = upright;
    for (Vec3& v : mesh.vertices) v = swaps ? Vec3{x * v.x, y * v.z, z * v.y} : Vec3{x * v.x, y * v.y, z * v.z};
    if ((x * y * z < 0.0) != swaps)
      for (auto& triangle : mesh.triangles) std::swap(triangle[0], triangle[1]);
    return bearing_of(MeshSections(mesh));
  };
  BOOST_TEST(bearing_when(1, 1, 1, false).doubt == "");
  BOOST_TEST(says(bearing_when(-1, 1, 1, false).remedy, "structure.heading = \"180 deg\""));
  BOOST_TEST(says(bearing_when(1, 1, -1, false).remedy, "structure.heel = \"180 deg\""));
  BOOST_TEST(says(bearing_when(1, 1, 1, true).remedy, "structure.heel = \"90 deg\""));
  BOOST_TEST(says(bearing_when(1, -1, 1, true).remedy, "structure.heel = \"-90 deg\""));
  BOOST_TEST(bearing_of(MeshSections(sphere({}, 5.0, 12))).doubt == "");
  BOOST_TEST(bearing_of(MeshSections(kBox)).doubt == "");
}

BOOST_AUTO_TEST_CASE(a_mesh_that_crosses_itself_is_named_with_places) {
  const TriangleMesh crossed = joined(kBox, box({9.0, -1.0, -2.0}, {12.0, 1.0, 0.5}));
  const std::string what = refusal(crossed);
  BOOST_TEST(says(what, "crosses itself"), what);
  BOOST_TEST(says(what, "near ("), what);
}

BOOST_AUTO_TEST_CASE(two_shells_are_one_hull_and_a_shell_inside_another_one_is_left_out) {
  const auto two = read_mesh(off(joined(kBox, box({-10.0, 5.0, -3.0}, {10.0, 9.0, 1.0}))), "off");
  BOOST_REQUIRE(two.has_value());
  BOOST_TEST(two->report.n_shells == 2);
  BOOST_TEST(signed_volume(two->mesh) == 640.0, kExact);
  const auto tank = read_mesh(off(joined(kBox, box({-5.0, -1.0, -2.0}, {5.0, 1.0, 0.0}))), "off");
  BOOST_REQUIRE(tank.has_value());
  BOOST_TEST(tank->report.n_inner_shells == 1);
  BOOST_TEST(tank->report.n_shells == 1);
  BOOST_TEST(signed_volume(tank->mesh) == 320.0, kExact);
}

BOOST_AUTO_TEST_CASE(files_that_are_no_mesh_are_refused) {
  for (const std::string kind : {"stl", "obj", "ply", "off"}) {
    BOOST_TEST(!read_mesh("", kind).has_value(), kind);
    BOOST_TEST(!read_mesh("a page about ice\n", kind).has_value(), kind);
  }
  BOOST_TEST(!read_mesh("OFF\n3 1 0\n0 0 0\n1 0 0\n0 1 0\n3 0 1 7\n", "off").has_value());
  BOOST_TEST(!read_mesh("OFF\n3 1 0\n0 0 0\n1 0 0\n0 nan 0\n3 0 1 2\n", "off").has_value());
  BOOST_TEST(!read_mesh("OFF\n4000000000 4000000000 0\n0 0 0\n", "off").has_value());
  BOOST_TEST(!read_mesh("v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 -9\n", "obj").has_value());
}

/// Truncated and altered files end in an error or a mesh, never in a crash.
BOOST_AUTO_TEST_CASE(broken_files_end_in_an_answer) {
  std::mt19937 random(7);
  const TriangleMesh mesh = sphere({}, 5.0, 4);
  const std::vector<std::pair<std::string, std::string>> files{
      {"off", off(mesh)}, {"obj", obj(mesh)}, {"ply", ply(mesh)}, {"stl", ascii_stl(mesh)}, {"stl", binary_stl(mesh)}};
  int n_answers = 0;
  for (const auto& [kind, bytes] : files)
    for (int i = 0; i < 400; ++i) {
      std::string broken = bytes.substr(0, i % 3 == 0 ? random() % bytes.size() : bytes.size());
      for (int k = 0; k < 1 + i % 4 && !broken.empty(); ++k)
        broken[random() % broken.size()] = static_cast<char>(i % 2 == 0 ? '0' + random() % 10 : random() % 256);
      const auto read = read_mesh(broken, kind);
      n_answers += read.has_value() ? signed_volume(read->mesh) > 0.0 : !read.error().what.empty();
    }
  BOOST_TEST(n_answers == 2000);
}

struct Scratch {
  std::filesystem::path folder = std::filesystem::temp_directory_path() / ("brash-mesh-" + std::to_string(::getpid()));
  Scratch() { std::filesystem::create_directories(folder); }
  ~Scratch() { std::filesystem::remove_all(folder); }
  std::string write(const std::string& name, const std::string& bytes) const {
    std::ofstream(folder / name, std::ios::binary) << bytes;
    return (folder / name).string();
  }
};

BOOST_AUTO_TEST_CASE(a_mesh_lies_in_the_water_as_its_draught_says) {
  const Scratch scratch;
  model::Mesh how{.file = scratch.write("box.OFF", off(kBox)), .draught = 1.5};
  const auto report = examine(how);
  BOOST_REQUIRE(report.has_value());
  BOOST_TEST(report->size.x == 20.0, kExact);
  BOOST_TEST(report->n_parts == 1);
  BOOST_TEST(report->parts_error == 0.0, boost::test_tools::tolerance(1e-9));
  BOOST_TEST(make_hull(how)->displaced({}).volume == 20.0 * 4.0 * 1.5, kExact);
  how.scale = 0.1;
  how.draught = 0.15;
  BOOST_TEST(make_hull(how)->displaced({}).volume == 20.0 * 4.0 * 1.5 * 1e-3, kExact);
  BOOST_TEST(make_hull(how)->displaced({}).waterplane.centre.x == 0.0, boost::test_tools::tolerance(1e-12));
}

BOOST_AUTO_TEST_CASE(trim_lifts_the_bow_heel_sinks_starboard_and_heading_turns_to_port) {
  const Scratch scratch;
  const std::string file = scratch.write("box.off", off(kBox));
  const auto highest = [](const Hull& hull, Vec3 towards) {
    const auto& vertices = hull.mesh().vertices;
    return *std::ranges::max_element(vertices, {}, [&](Vec3 v) { return dot(v, towards); });
  };
  const auto trimmed = make_hull(model::Mesh{.file = file, .draught = 2.0, .trim = 0.1});
  BOOST_TEST(highest(*trimmed, {0.0, 0.0, 1.0}).x > 5.0);
  const auto heeled = make_hull(model::Mesh{.file = file, .draught = 2.0, .heel = 0.1});
  BOOST_TEST(highest(*heeled, {0.0, 0.0, 1.0}).y > 1.0);
  const auto turned = make_hull(model::Mesh{.file = file, .draught = 2.0, .heading = 0.5 * kPi});
  BOOST_TEST(turned->bounds().second.y == 10.0, kExact);
  BOOST_TEST(turned->bounds().second.x == 2.0, kExact);
}

BOOST_AUTO_TEST_CASE(a_ship_in_millimetres_is_refused_with_the_unit_that_it_was_probably_in) {
  const Scratch scratch;
  const std::string file = scratch.write("ship.off", off(box({0.0, 0.0, 0.0}, {150e3, 22e3, 14e3})));
  const auto refused = examine(model::Mesh{.file = file, .draught = 9.0});
  BOOST_REQUIRE(!refused.has_value());
  BOOST_TEST(says(refused.error().what, "150 km long"), refused.error().what);
  BOOST_TEST(says(refused.error().remedy, "in millimetres it would be 150 m long: write structure.scale = 0.001"),
             refused.error().remedy);
  BOOST_TEST(examine(model::Mesh{.file = file, .scale = 1e-3, .draught = 9.0}).has_value());
}

BOOST_AUTO_TEST_CASE(a_draught_above_the_deck_is_refused) {
  const Scratch scratch;
  const auto refused = examine(model::Mesh{.file = scratch.write("box.off", off(kBox)), .draught = 4.5});
  BOOST_REQUIRE(!refused.has_value());
  BOOST_TEST(says(refused.error().what, "is 4 m high, and its draught 4.5 m"), refused.error().what);
}

BOOST_AUTO_TEST_CASE(a_mesh_that_is_thinner_than_its_outlines_is_refused_with_its_size) {
  const Scratch scratch;
  const auto plate = [&](double thickness) {
    return scratch.write("plate.off", off(box({-2.0, -0.5 * thickness, 0.0}, {2.0, 0.5 * thickness, 3.0})));
  };
  for (const double heading : {0.0, 0.5}) {
    const auto refused = examine(model::Mesh{.file = plate(4e-9), .draught = 1.0, .heading = heading});
    BOOST_REQUIRE(!refused.has_value());
    BOOST_TEST(says(refused.error().what, "m x 3 m large and at most 4e-09 m thick"), refused.error().what);
  }
  const auto small = examine(model::Mesh{.file = plate(1.0), .scale = 1e-6, .draught = 1e-6});
  BOOST_REQUIRE(!small.has_value());
  BOOST_TEST(says(small.error().what, "is 4e-06 m x 1e-06 m x 3e-06 m large"), small.error().what);
  BOOST_TEST(examine(model::Mesh{.file = plate(0.01), .draught = 1.0}).has_value());
}

BOOST_AUTO_TEST_CASE(a_mesh_with_a_gap_at_the_waterline_is_refused) {
  const Scratch scratch;
  const TriangleMesh apart = joined(box({0.0, 0.0, 0.0}, {8.0, 4.0, 10.0}), box({0.0, 0.0, 12.0}, {8.0, 4.0, 20.0}));
  const std::string file = scratch.write("apart.off", off(apart));
  const auto refused = examine(model::Mesh{.file = file, .draught = 11.0});
  BOOST_REQUIRE(!refused.has_value());
  BOOST_TEST(says(refused.error().what, "has nothing 11 m above its lowest point"), refused.error().what);
  BOOST_TEST(examine(model::Mesh{.file = file, .draught = 9.0}).has_value());
}

BOOST_AUTO_TEST_SUITE_END()

}  // namespace
