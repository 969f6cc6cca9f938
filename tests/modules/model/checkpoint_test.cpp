// SPDX-License-Identifier: GPL-3.0-or-later
#include "brash/model/checkpoint.hpp"

#include <boost/test/unit_test.hpp>
#include <limits>

#include "brash/core/contract.hpp"

namespace {

using namespace brash;
using namespace brash::model;

/// An owner with a member of every kind.
struct Owner {
  double length = 0.0;
  std::int64_t id = 0;
  std::uint64_t n_streams = 0;
  int count = 0;
  bool asleep = false;
  Vec2 place{};
  Vec3 force{};
  geometry::Polygon outline;
  geometry::ExactArea area;

  template <typename Self, typename Visit>
  static void visit(Self& self, Visit&& visit) {
    visit("length", "m", "length", self.length);
    visit("id", "1", "id", self.id);
    visit("n_streams", "1", "streams", self.n_streams);
    visit("count", "1", "count", self.count);
    visit("asleep", "1", "whether it sleeps", self.asleep);
    visit("place_", "m", "place", self.place);
    visit("force_", "N", "force", self.force);
    visit("outline", "1", "outline", self.outline);
    visit("area", "1", "area", self.area);
  }

  friend bool operator==(const Owner&, const Owner&) = default;
};

/// The largest and the smallest that 128 bits hold.
constexpr geometry::Int128 kMost = ~(geometry::Int128{1} << 127);

geometry::Point at(int x, int y) { return geometry::Point::of_units(x, y); }

Owner sample() {
  return {.length = -5e-324,
          .id = std::numeric_limits<std::int64_t>::min(),
          .n_streams = 7,
          .count = -3,
          .asleep = true,
          .place = {1.0 / 3.0, -0.0},
          .force = {1e300, 2.0, 3.0},
          .outline = {{at(0, 0), at(4, 0), at(0, 4)}, {{at(1, 1), at(1, 2), at(2, 1)}}},
          .area = geometry::ExactArea(-kMost - 1)};
}

BOOST_AUTO_TEST_SUITE(checkpoint_tables)

BOOST_AUTO_TEST_CASE(an_owner_restores_what_it_saved) {
  Checkpoint checkpoint;
  save(checkpoint, "owner", sample());
  Owner restored;
  restore(checkpoint, "owner", restored);
  BOOST_TEST((restored == sample()));
  Owner largest = sample();
  largest.area = geometry::ExactArea(kMost);
  save(checkpoint, "largest", largest);
  restore(checkpoint, "largest", restored);
  BOOST_TEST((restored == largest));
}

BOOST_AUTO_TEST_CASE(a_column_has_the_name_the_unit_and_the_meaning_that_its_owner_gave) {
  Checkpoint checkpoint;
  save(checkpoint, "owner", sample());
  const Column& column = checkpoint.table("owner").column("force_y");
  BOOST_TEST(column.unit == "N");
  BOOST_TEST(column.meaning == "force, y");
  BOOST_TEST(std::get<std::vector<double>>(column.values).at(0) == 2.0);
}

BOOST_AUTO_TEST_CASE(rows_come_back_in_their_order) {
  Table table{"owner", {}};
  for (int i = 0; i < 3; ++i) {
    Owner owner = sample();
    owner.count = i;
    SavedRow row(table);
    Owner::visit(owner, row);
  }
  BOOST_TEST(table.n_rows() == 3u);
  for (std::size_t i = 0; i < 3; ++i) {
    Owner owner;
    RestoredRow row(table, i);
    Owner::visit(owner, row);
    BOOST_TEST(owner.count == static_cast<int>(i));
  }
}

BOOST_AUTO_TEST_CASE(a_table_that_lacks_something_is_refused) {
  Checkpoint checkpoint;
  Owner owner;
  BOOST_CHECK_THROW(restore(checkpoint, "owner", owner), ContractViolation);
  save(checkpoint, "owner", sample());
  Checkpoint without = checkpoint, other_kind = checkpoint, no_number = checkpoint, too_large = checkpoint;
  std::erase_if(without.table("owner").columns, [](const Column& column) { return column.name == "force_y"; });
  BOOST_CHECK_THROW(restore(without, "owner", owner), ContractViolation);
  other_kind.table("owner").column("id").values = std::vector{1.0};
  BOOST_CHECK_THROW(restore(other_kind, "owner", owner), ContractViolation);
  no_number.table("owner").column("area").values = std::vector<std::string>{"1e9"};
  BOOST_CHECK_THROW(restore(no_number, "owner", owner), ContractViolation);
  too_large.table("owner").column("area").values = std::vector<std::string>{std::string(39, '9')};
  BOOST_CHECK_THROW(restore(too_large, "owner", owner), ContractViolation);
}

BOOST_AUTO_TEST_SUITE_END()

}  // namespace
