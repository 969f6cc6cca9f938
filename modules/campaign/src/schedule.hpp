// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>
#include <span>
#include <string>
#include <vector>

#include "brash/campaign/campaign.hpp"
#include "folder.hpp"

namespace brash::campaign {

/// Whether the interval of the mean of `values` is as narrow as `rule` wants.
bool is_narrow(const io::StopRule& rule, std::span<const double> values);

/// Which cases a campaign has and how they stand: the grid and, with a stop rule, the cases that the results so far ask
/// for.
class Schedule {
 public:
  /// Looks at the content of `folder`.
  Schedule(const io::CampaignPlan& plan, const Folder& folder);

  /// The first case that is missing and was not handed out yet.
  std::optional<CaseKey> next();
  /// Looks again at a case that was handed out and has ended.
  void look_at(const CaseKey& key);
  Counts counts() const;
  /// All cases, by setting, then replicate.
  std::vector<std::pair<CaseKey, CaseState>> cases() const;
  /// Whether a case of `setting` is neither done nor failed.
  bool is_missing_cases(std::size_t setting) const;
  /// Whether a case of `setting` has the number of the stop rule's statistic.
  bool has_statistic(std::size_t setting) const;
  /// Whether the stop rule holds for the replicates of `setting`.
  bool is_narrow_enough(std::size_t setting) const;

 private:
  struct Replicate {
    CaseState state = CaseState::kMissing;
    bool handed_out = false;
    std::optional<double> value;  ///< of the stop rule's statistic
    std::string fingerprint;      ///< of all its numbers: replicates that coincide count once
  };

  void add_replicates(std::size_t setting, int n);
  void look_at(std::size_t setting, int replicate);
  /// Adds replicates to a setting whose present ones are all there and not enough.
  void extend(std::size_t setting);

  const io::CampaignPlan& plan_;
  const Folder& folder_;
  std::vector<std::vector<Replicate>> settings_;
  std::size_t first_open_ = 0;  ///< settings before it have nothing to hand out
};

}  // namespace brash::campaign
