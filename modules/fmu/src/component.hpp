// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <functional>
#include <string>
#include <utility>
#include <vector>

#include "instance.hpp"

namespace brash::fmu {

/// Results of a call: the numbers that both versions of the standard give them.
enum class Status { kOk = 0, kWarning = 1, kDiscard = 2, kError = 3 };

/// The categories of messages, as a description lists them.
inline constexpr const char* kWarningCategory = "logStatusWarning";
inline constexpr const char* kDiscardCategory = "logStatusDiscard";
inline constexpr const char* kErrorCategory = "logStatusError";

/// Messages of an instance to its host. A host cannot turn errors and warnings off.
class Log {
 public:
  using Write = std::function<void(Status, const char* category, const char* message)>;

  /// @param on  of all categories.
  Log(Write write, bool on) : write_(std::move(write)), discards_(on) {}

  /// @param categories  of the host, as many as `n`; none: all.
  /// @throws std::runtime_error for a category that is not there, and for a null pointer.
  void select(bool on, const char* const* categories, std::size_t n);
  void warn(const char* message) const;
  void discard(const char* message) const;
  void error(const char* message) const;

 private:
  Write write_;
  bool discards_;
};

/// The thing behind a host's pointer.
struct Component {
  Instance instance;
  Log log;
};

/// Makes an instance. @return null when that fails, once the reason is logged.
Component* make_component(const std::string& resources, const std::string& token, const Log& log) noexcept;

/// The instance that `make()` gives, or null. No exception leaves: the host may be in C.
template <typename Make>
Component* made_by(Make make) noexcept {
  try {
    return make();
  } catch (...) {
    return nullptr;
  }
}

/// Does `action(component)`. No exception leaves.
Status attempt(void* pointer, const std::function<void(Component&)>& action) noexcept;

/// @throws std::runtime_error when a host passes no array where it announces values.
void expect_array(const void* array, std::size_t size);

/// The settings that a host passes as two arrays.
/// @tparam Kind  of the number of each.
template <typename Kind, typename Value>
std::vector<Instance::Setting> settings_of(const unsigned* references, const Value* values, std::size_t n) {
  expect_array(references, n);
  expect_array(values, n);
  std::vector<Instance::Setting> settings;
  for (std::size_t i = 0; i < n; ++i) settings.push_back({references[i], static_cast<Kind>(values[i])});
  return settings;
}

// The calls of states, the same in both versions.
Status keep_state(void* component, void** kept) noexcept;
Status restore_state(void* component, void* kept) noexcept;
Status free_state(void* component, void** kept) noexcept;
Status size_of_state(void* component, void* kept, std::size_t* size) noexcept;
Status serialise_state(void* component, void* kept, void* bytes, std::size_t size) noexcept;
Status deserialise_state(void* component, const void* bytes, std::size_t size, void** kept) noexcept;

}  // namespace brash::fmu
