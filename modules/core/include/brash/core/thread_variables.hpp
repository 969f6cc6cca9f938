// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

namespace brash {

/// Makes the variables that the calling thread has of its own, here and in the C++ library. In a module that is loaded
/// into a running program, such as Python's, the C library makes them at their first use, and ends the process where
/// memory is short.
/// @return false when there is no memory for them.
[[nodiscard]] bool make_thread_variables() noexcept;

}  // namespace brash
