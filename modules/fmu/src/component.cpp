// SPDX-License-Identifier: GPL-3.0-or-later
#include "component.hpp"

#include <algorithm>
#include <array>
#include <stdexcept>

namespace brash::fmu {
namespace {

/// A state that a host keeps, and its bytes once it has asked for their number.
struct KeptState {
  State state;
  std::string bytes{};
};

/// The bytes of a state, made when they are asked for first.
const std::string& bytes_of(KeptState& kept, const Component& component) {
  if (kept.bytes.empty()) kept.bytes = to_bytes(kept.state, component.instance.token());
  return kept.bytes;
}

void keep(void** kept, State state) {
  if (*kept == nullptr) *kept = new KeptState;
  *static_cast<KeptState*>(*kept) = {std::move(state)};
}

}  // namespace

void Log::select(bool on, const char* const* categories, std::size_t n) {
  constexpr std::array<std::string_view, 3> kKnown{kWarningCategory, kDiscardCategory, kErrorCategory};
  expect_array(categories, n);
  bool has_discards = n == 0;
  for (std::size_t i = 0; i < n; ++i) {
    expect_array(categories[i], 1);
    const std::string category = categories[i];
    if (std::ranges::find(kKnown, category) == kKnown.end())
      throw std::runtime_error("there is no log category " + category);
    if (category == kDiscardCategory) has_discards = true;
  }
  if (has_discards) discards_ = on;
}

void Log::warn(const char* message) const {
  if (write_) write_(Status::kWarning, kWarningCategory, message);
}

void Log::discard(const char* message) const {
  if (discards_ && write_) write_(Status::kDiscard, kDiscardCategory, message);
}

void Log::error(const char* message) const {
  if (write_) write_(Status::kError, kErrorCategory, message);
}

Component* make_component(const std::string& resources, const std::string& token, const Log& log) noexcept {
  try {
    return new Component{Instance(resources, token), log};
  } catch (const std::exception& error) {
    log.error(error.what());
    return nullptr;
  } catch (...) {
    return nullptr;
  }
}

Status attempt(void* pointer, const std::function<void(Component&)>& action) noexcept {
  auto* const component = static_cast<Component*>(pointer);
  if (component == nullptr) return Status::kError;
  try {
    action(*component);
    const std::string warning = component->instance.take_warning();
    if (!warning.empty()) component->log.warn(warning.c_str());
    return Status::kOk;
  } catch (const Discarded& discarded) {
    component->log.discard(discarded.what());
    return Status::kDiscard;
  } catch (const std::exception& error) {
    component->instance.fail();
    component->log.error(error.what());
    return Status::kError;
  } catch (...) {
    component->instance.fail();
    return Status::kError;
  }
}

void expect_array(const void* array, std::size_t size) {
  if (array == nullptr && size > 0) throw std::runtime_error("an argument is a null pointer");
}

Status keep_state(void* component, void** kept) noexcept {
  return attempt(component, [&](Component& c) {
    expect_array(kept, 1);
    keep(kept, c.instance.state());
  });
}

Status restore_state(void* component, void* kept) noexcept {
  return attempt(component, [&](Component& c) {
    expect_array(kept, 1);
    c.instance.restore(static_cast<KeptState*>(kept)->state);
  });
}

Status free_state(void* component, void** kept) noexcept {
  return attempt(component, [&](Component&) {
    if (kept == nullptr) return;
    delete static_cast<KeptState*>(*kept);
    *kept = nullptr;
  });
}

Status size_of_state(void* component, void* kept, std::size_t* size) noexcept {
  return attempt(component, [&](Component& c) {
    expect_array(kept, 1);
    expect_array(size, 1);
    *size = bytes_of(*static_cast<KeptState*>(kept), c).size();
  });
}

Status serialise_state(void* component, void* kept, void* bytes, std::size_t size) noexcept {
  return attempt(component, [&](Component& c) {
    expect_array(kept, 1);
    expect_array(bytes, size);
    const std::string& own = bytes_of(*static_cast<KeptState*>(kept), c);
    if (size < own.size()) throw std::runtime_error("the array is smaller than the serialised state");
    own.copy(static_cast<char*>(bytes), own.size());
  });
}

Status deserialise_state(void* component, const void* bytes, std::size_t size, void** kept) noexcept {
  return attempt(component, [&](Component& c) {
    expect_array(bytes, size);
    expect_array(kept, 1);
    keep(kept, state_from({static_cast<const char*>(bytes), size}, c.instance.token()));
  });
}

}  // namespace brash::fmu
