// SPDX-License-Identifier: GPL-3.0-or-later
#include "../../../modules/rigid_body/src/strips.hpp"

#include <algorithm>
#include <boost/test/unit_test.hpp>
#include <numeric>
#include <random>
#include <set>
#include <vector>

using namespace brash::rigid_body;

namespace {

/// Contacts of `n_bodies` in a row with others up to `reach` places on, some with what does not move, some from end to
/// end.
std::vector<Ends> contacts(std::uint32_t n_bodies, std::uint32_t reach, unsigned seed) {
  std::mt19937 random(seed);
  std::vector<Ends> all;
  for (std::uint32_t body = 1; body <= n_bodies; ++body)
    for (int k = 0; k < 4; ++k) {
      const auto other = std::min(n_bodies, static_cast<std::uint32_t>(body + 1 + random() % reach));
      if (other == body) continue;
      const Ends ends = random() % 2 == 0 ? Ends{body, other} : Ends{other, body};
      all.push_back(random() % 10 == 0 ? Ends{body, 0} : ends);
    }
  for (int k = 0; k < 3; ++k) all.push_back({1, n_bodies});
  std::shuffle(all.begin(), all.end(), random);
  return all;
}

}  // namespace

BOOST_AUTO_TEST_CASE(Every_second_strip_has_no_body_in_common_with_another) {
  for (const std::uint32_t reach : {1, 7, 40, 100})
    for (unsigned seed = 0; seed < 20; ++seed) {
      const std::vector<Ends> all = contacts(1000, reach, seed);
      Strips strips;
      strips.lay(all, 1000);
      BOOST_TEST(strips.n() > 4u);
      std::vector<std::size_t> owner[2];
      for (auto& of_colour : owner) of_colour.assign(1001, strips.n());
      for (std::size_t i = 0; i < strips.n(); ++i)
        for (const std::uint32_t c : strips.contacts_of(i))
          for (const std::uint32_t body : {all[c].first, all[c].second}) {
            if (body == 0) continue;
            std::size_t& strip = owner[i % 2][body];
            BOOST_REQUIRE((strip == strips.n() || strip == i));
            strip = i;
          }
    }
}

BOOST_AUTO_TEST_CASE(Each_contact_has_one_strip_and_strips_keep_their_order) {
  const std::vector<Ends> all = contacts(300, 20, 1);
  Strips strips;
  strips.lay(all, 300);
  std::set<std::uint32_t> seen;
  for (std::size_t i = 0; i <= strips.n(); ++i) {
    const auto some = strips.contacts_of(i);
    BOOST_TEST(std::is_sorted(some.begin(), some.end()));
    seen.insert(some.begin(), some.end());
  }
  BOOST_TEST(seen.size() == all.size());
  BOOST_TEST(strips.contacts().size() == all.size());
}

BOOST_AUTO_TEST_CASE(Contacts_of_bodies_far_apart_are_left_for_the_end) {
  const std::vector<Ends> all = contacts(300, 20, 2);
  Strips strips;
  strips.lay(all, 300);
  BOOST_TEST(strips.contacts_of(strips.n()).size() == 3u);
  for (const std::uint32_t c : strips.contacts_of(strips.n())) BOOST_TEST((all[c].first == 1 && all[c].second == 300));
}

BOOST_AUTO_TEST_CASE(No_bodies_have_no_strips) {
  Strips strips;
  BOOST_TEST(strips.n() == 0u);
  strips.lay({}, 0);
  BOOST_TEST(strips.n() == 0u);
  BOOST_TEST(strips.contacts_of(0).empty());
  const std::vector<Ends> fixed{{0, 0}};
  strips.lay(fixed, 0);
  BOOST_TEST(strips.contacts_of(0).size() == 1u);
}
