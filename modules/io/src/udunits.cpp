// SPDX-License-Identifier: GPL-3.0-or-later
#include <fmt/format.h>
#include <udunits2.h>

#include <array>
#include <memory>
#include <mutex>
#include <string_view>

#include "brash/core/error.hpp"
#include "units.hpp"

namespace brash::io {
namespace {

struct FreeUnit {
  void operator()(ut_unit* unit) const { ut_free(unit); }
};
struct FreeConverter {
  void operator()(cv_converter* converter) const { cv_free(converter); }
};
using Unit = std::unique_ptr<ut_unit, FreeUnit>;
using Converter = std::unique_ptr<cv_converter, FreeConverter>;

/// Gives `symbol` the meaning of `definition`, before UDUNITS takes its first letter for a prefix.
void define(ut_system* system, const char* symbol, const char* definition) {
  ut_unmap_symbol_to_unit(system, symbol, UT_ASCII);
  const Unit unit(ut_parse(system, definition, UT_UTF8));
  if (!unit || ut_map_symbol_to_unit(symbol, UT_ASCII, unit.get()) != UT_SUCCESS)
    throw InputError(
        fmt::format("UDUNITS-2 cannot define the unit {} as {}\n  allowed: Debian's unit database"
                    "\n  remedy:  unset UDUNITS2_XML_PATH",
                    symbol, definition));
}

/// The unit database, read once and never freed. The caller holds the lock: UDUNITS parses with global state.
ut_system* unit_system() {
  static ut_system* const system = [] {
    ut_set_error_message_handler(ut_ignore);
    ut_system* const read = ut_read_xml(nullptr);
    if (read == nullptr)
      throw InputError(
          "UDUNITS-2 cannot read its unit database\n  allowed: Debian's unit database"
          "\n  remedy:  install libudunits2-data, or unset UDUNITS2_XML_PATH");
    define(read, "nmi", "1852 m");
    define(read, "ppt", "1e-3");
    define(read, "deg", "arc_degree");
    return read;
  }();
  return system;
}

/// Whether `unit` has an angle in it: UDUNITS lets radians pass as ratios.
bool has_angle(const ut_unit* unit) {
  std::array<char, 512> text{};
  const int length = ut_format(unit, text.data(), text.size() - 1, UT_ASCII | UT_DEFINITION);
  return length > 0 && std::string_view(text.data()).find("rad") != std::string_view::npos;
}

}  // namespace

tl::expected<InOtherUnit, UnitFault> in_unit_of_udunits(double value, const std::string& from, const std::string& to) {
  static std::mutex mutex;
  const std::lock_guard lock(mutex);
  ut_system* const system = unit_system();
  const Unit target(ut_parse(system, to.c_str(), UT_UTF8));
  const Unit unit(ut_parse(system, from.c_str(), UT_UTF8));
  if (!unit) return tl::unexpected(UnitFault::kUnknown);
  if (ut_are_convertible(unit.get(), target.get()) == 0 || has_angle(unit.get()) != has_angle(target.get()))
    return tl::unexpected(UnitFault::kOtherKind);
  const Converter converter(ut_get_converter(unit.get(), target.get()));
  if (!converter) return tl::unexpected(UnitFault::kNoConverter);
  const auto converted = [&](double number) { return cv_convert_double(converter.get(), number); };
  return InOtherUnit{converted(0.0), converted(1.0), converted(value)};
}

}  // namespace brash::io
