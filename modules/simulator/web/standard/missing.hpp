// SPDX-License-Identifier: GPL-3.0-or-later
// Parts of the standard library that emscripten's libc++ 13 does not have. Every source of this build includes the file
// first. A name that a later libc++ brings would be a clash, which the compiler reports.
#pragma once

#ifdef __cplusplus

#include <algorithm>
#include <cerrno>
#include <charconv>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <functional>
#include <iterator>
#include <string>
#include <system_error>
#include <type_traits>
#include <utility>

namespace std {

/// The number at the start of a text. musl's strtod() rounds to the nearest, as the standard asks.
template <typename Float>
requires is_same_v<Float, double> from_chars_result from_chars(const char* first, const char* last, Float& value) {
  const char* const digits = first != last && *first == '-' ? first + 1 : first;
  // strtod() would also take blanks, a plus and hexadecimal numbers.
  if (digits == last || !((*digits >= '0' && *digits <= '9') || *digits == '.' || *digits == 'i' || *digits == 'I' ||
                          *digits == 'n' || *digits == 'N'))
    return {first, errc::invalid_argument};
  string text(first, last);
  if (const size_t x = text.find_first_of("xX"); x != string::npos) text.resize(x);
  char* end = nullptr;
  errno = 0;
  const double read = strtod(text.c_str(), &end);
  if (end == text.c_str()) return {first, errc::invalid_argument};
  const char* const stop = first + (end - text.c_str());
  if (errno == ERANGE) return {stop, errc::result_out_of_range};
  value = read;
  return {stop, errc{}};
}

/// The fewest digits, of 15 or more, that give the number back; without zeros at the end.
template <typename Float>
requires is_same_v<Float, double> to_chars_result to_chars(char* first, char* last, Float value) {
  constexpr int kMost = 17;
  char text[32];
  int n = 0;
  for (int digits = 15; digits <= kMost; ++digits) {
    n = snprintf(text, sizeof text, "%.*g", digits, value);
    if (strtod(text, nullptr) == value) break;
  }
  if (n > last - first) return {last, errc::value_too_large};
  return {copy_n(text, n, first), errc{}};
}

namespace ranges {
namespace missing {

/// An order of elements as an order of their projections.
template <typename Compare, typename Project>
auto projected(Compare compare, Project project) {
  return [compare, project](auto&& a, auto&& b) -> bool {
    return std::invoke(compare, std::invoke(project, a), std::invoke(project, b));
  };
}
template <typename Test, typename Project>
auto tested(Test test, Project project) {
  return [test, project](auto&& a) -> bool { return std::invoke(test, std::invoke(project, a)); };
}

// Functions are objects, as in the standard: they are never found by their arguments.
#define BRASH_MISSING_ORDER(name)                                                               \
  struct name##_function {                                                                      \
    template <typename Range, typename Compare = std::less<>, typename Project = std::identity> \
    auto operator()(Range&& range, Compare compare = {}, Project project = {}) const {          \
      return std::name(std::begin(range), std::end(range), projected(compare, project));        \
    }                                                                                           \
  }
BRASH_MISSING_ORDER(sort);
BRASH_MISSING_ORDER(stable_sort);
BRASH_MISSING_ORDER(max_element);
BRASH_MISSING_ORDER(min_element);
#undef BRASH_MISSING_ORDER

#define BRASH_MISSING_TEST(name)                                                   \
  struct name##_function {                                                         \
    template <typename Range, typename Test, typename Project = std::identity>     \
    auto operator()(Range&& range, Test test, Project project = {}) const {        \
      return std::name(std::begin(range), std::end(range), tested(test, project)); \
    }                                                                              \
  }
BRASH_MISSING_TEST(any_of);
BRASH_MISSING_TEST(all_of);
BRASH_MISSING_TEST(none_of);
BRASH_MISSING_TEST(find_if);
BRASH_MISSING_TEST(count_if);
#undef BRASH_MISSING_TEST

struct find_function {
  template <typename Range, typename Value, typename Project = std::identity>
  auto operator()(Range&& range, const Value& value, Project project = {}) const {
    return std::find_if(std::begin(range), std::end(range),
                        [&](auto&& each) -> bool { return std::invoke(project, each) == value; });
  }
};
struct count_function {
  template <typename Range, typename Value>
  auto operator()(Range&& range, const Value& value) const {
    return std::count(std::begin(range), std::end(range), value);
  }
};
struct lower_bound_function {
  template <typename Range, typename Value, typename Compare = std::less<>, typename Project = std::identity>
  auto operator()(Range&& range, const Value& value, Compare compare = {}, Project project = {}) const {
    return std::lower_bound(std::begin(range), std::end(range), value, [&](auto&& each, const Value& v) -> bool {
      return std::invoke(compare, std::invoke(project, each), v);
    });
  }
};
struct upper_bound_function {
  template <typename Range, typename Value, typename Compare = std::less<>, typename Project = std::identity>
  auto operator()(Range&& range, const Value& value, Compare compare = {}, Project project = {}) const {
    return std::upper_bound(std::begin(range), std::end(range), value, [&](const Value& v, auto&& each) -> bool {
      return std::invoke(compare, v, std::invoke(project, each));
    });
  }
};
struct binary_search_function {
  template <typename Range, typename Value, typename Compare = std::less<>, typename Project = std::identity>
  bool operator()(Range&& range, const Value& value, Compare compare = {}, Project project = {}) const {
    const auto at = lower_bound_function{}(range, value, compare, project);
    return at != std::end(range) && !std::invoke(compare, value, std::invoke(project, *at));
  }
};
struct copy_function {
  template <typename Range, typename Out>
  auto operator()(Range&& range, Out out) const {
    return std::copy(std::begin(range), std::end(range), out);
  }
};
struct move_function {
  template <typename Range, typename Out>
  auto operator()(Range&& range, Out out) const {
    return std::move(std::begin(range), std::end(range), out);
  }
};
struct transform_function {
  template <typename Range, typename Out, typename Operation>
  auto operator()(Range&& range, Out out, Operation operation) const {
    return std::transform(std::begin(range), std::end(range), out,
                          [&](auto&& each) { return std::invoke(operation, each); });
  }
};
struct reverse_function {
  template <typename Range>
  void operator()(Range&& range) const {
    std::reverse(std::begin(range), std::end(range));
  }
};
struct rotate_function {
  template <typename Range, typename Iterator>
  auto operator()(Range&& range, Iterator middle) const {
    return std::rotate(std::begin(range), middle, std::end(range));
  }
};
struct nth_element_function {
  template <typename Range, typename Iterator, typename Compare = std::less<>, typename Project = std::identity>
  void operator()(Range&& range, Iterator nth, Compare compare = {}, Project project = {}) const {
    std::nth_element(std::begin(range), nth, std::end(range), projected(compare, project));
  }
};
template <typename Iterator>
struct min_max_result {
  Iterator min, max;
};
struct minmax_element_function {
  template <typename Range, typename Compare = std::less<>, typename Project = std::identity>
  auto operator()(Range&& range, Compare compare = {}, Project project = {}) const {
    const auto [least, most] = std::minmax_element(std::begin(range), std::end(range), projected(compare, project));
    return min_max_result<std::decay_t<decltype(least)>>{least, most};
  }
};
struct max_function {
  template <typename Range, typename Compare = std::less<>, typename Project = std::identity>
  auto operator()(Range&& range, Compare compare = {}, Project project = {}) const {
    return *std::max_element(std::begin(range), std::end(range), projected(compare, project));
  }
};
struct min_function {
  template <typename Range, typename Compare = std::less<>, typename Project = std::identity>
  auto operator()(Range&& range, Compare compare = {}, Project project = {}) const {
    return *std::min_element(std::begin(range), std::end(range), projected(compare, project));
  }
};
struct minmax_function {
  template <typename Range, typename Compare = std::less<>, typename Project = std::identity>
  auto operator()(Range&& range, Compare compare = {}, Project project = {}) const {
    const auto [least, most] = std::minmax_element(std::begin(range), std::end(range), projected(compare, project));
    return min_max_result<std::decay_t<decltype(*least)>>{*least, *most};
  }
};

}  // namespace missing

#define BRASH_MISSING(name) \
  inline constexpr missing::name##_function name {}
BRASH_MISSING(sort);
BRASH_MISSING(stable_sort);
BRASH_MISSING(max_element);
BRASH_MISSING(min_element);
BRASH_MISSING(minmax_element);
BRASH_MISSING(any_of);
BRASH_MISSING(all_of);
BRASH_MISSING(none_of);
BRASH_MISSING(find_if);
BRASH_MISSING(count_if);
BRASH_MISSING(find);
BRASH_MISSING(count);
BRASH_MISSING(lower_bound);
BRASH_MISSING(upper_bound);
BRASH_MISSING(binary_search);
BRASH_MISSING(copy);
BRASH_MISSING(move);
BRASH_MISSING(transform);
BRASH_MISSING(reverse);
BRASH_MISSING(rotate);
BRASH_MISSING(nth_element);
BRASH_MISSING(max);
BRASH_MISSING(min);
BRASH_MISSING(minmax);
#undef BRASH_MISSING

}  // namespace ranges
}  // namespace std

#endif
