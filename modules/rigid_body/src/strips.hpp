// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

namespace brash::rigid_body {

/// Two bodies that a contact moves, by their places in the order of the step, which begin at 1; 0: not moved.
struct Ends {
  std::uint32_t first = 0;
  std::uint32_t second = 0;
};

/// Divides contacts into strips, so that several strips can be solved at a time with one result.
///
/// A strip is of bodies that follow each other in the order of the step. Its contacts are those whose lower body it
/// has. It is long enough that the upper body of each contact lies in it or in the next strip. So the contacts of
/// strips 0, 2, 4 and so on have no body in common, nor have the contacts of strips 1, 3, 5. What does not move has no
/// strip. Contacts of bodies far apart in the order would make strips too long: they are left for the end, one after
/// the other.
///
/// Strips follow from the order of the bodies and their contacts alone (docs/theory/contacts-and-bodies.md, (C7)).
class Strips {
 public:
  /// @param contacts  keep their order within a strip.
  /// @param n_bodies  in the order of the step.
  void lay(std::span<const Ends> contacts, std::size_t n_bodies);

  /// Without the rest.
  std::size_t n() const { return begins_.size() - 2; }
  /// Numbers of the contacts of strip i; of strip n(): of the rest.
  std::span<const std::uint32_t> contacts_of(std::size_t i) const {
    return std::span(contacts_).subspan(begins_[i], begins_[i + 1] - begins_[i]);
  }
  /// All contacts, strip by strip, and where strip i begins among them.
  std::span<const std::uint32_t> contacts() const { return contacts_; }
  std::size_t begin(std::size_t i) const { return begins_[i]; }

 private:
  void divide(std::size_t n_bodies);

  std::vector<std::uint32_t> contacts_;
  std::vector<std::size_t> begins_{0, 0};
  std::vector<std::uint32_t> farthest_;  ///< upper body of the contacts of each body, as a lower one
  std::vector<std::uint32_t> strip_of_;  ///< each body
  std::vector<std::uint32_t> of_contact_;
  std::uint32_t n_strips_ = 0;
};

}  // namespace brash::rigid_body
