// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/floors.h"

#include <array>
#include <chrono>
#include <cstddef>
#include <optional>
#include <vector>

namespace dewpoint::tracking {

/// Time budget that limits the duration of each iteration. Deferrable work is done only if its
/// usual duration (a running median) fits into the remaining time; otherwise it is deferred. Other
/// work is reduced by using fewer particles. If no budget is set, all work is done immediately, no
/// clock is read, and a run is reproducible bit by bit.
class TimeBudget {
public:
  /// Kind of deferrable work: labeling pixels, finding spots, triangulating candidates (the three
  /// stages of SlicedSearch), and learning backgrounds.
  enum class Stage { Labels, Spots, Candidates, Learning };
  static constexpr std::size_t kStageCount = 4;
  /// Number of deferrals after which work is done even without enough time. Too small a budget
  /// therefore delays work, but never prevents it. The value was chosen by judgment
  /// (docs/method-dewpoint.md, section 10).
  static constexpr int kMaxDeferrals = 30;

  /// Sets the budget in milliseconds per iteration; 0 means no limit. A change discards all
  /// measured durations.
  void setLimit(double milliseconds);
  bool isLimited() const { return limit_ > 0.0; }
  /// Starts the clock of an iteration.
  void beginIteration();

  /// Does the work if the remaining time is sufficient, and returns whether the work was done. Work
  /// that was never done before is assumed to fit. `urgent` work is never deferred.
  template <class Work> bool runIfAffordable(Stage stage, const Work& work, bool urgent = false) {
    if (!urgent && !canAfford(stage)) {
      return false;
    }
    const double start = elapsed();
    work();
    record(stage, elapsed() - start);
    return true;
  }

  /// Adapts the number of particles to the time taken by the work that cannot be deferred. Call
  /// this function after that work. `most` is the number of particles per target without a budget.
  void adaptParticleCount(double most);
  /// Returns the number of particles per target that fit into the budget, at least ten. Returns
  /// nothing without a limit.
  std::optional<double> affordableParticleCount() const;

private:
  /// Last durations of one kind of work, in milliseconds.
  struct History {
    std::vector<double> durations;
    std::size_t nextIndex = 0; ///< entry of `durations` that the next duration replaces
    int deferralCount = 0;
  };

  bool canAfford(Stage stage);
  void record(Stage stage, double milliseconds);
  /// Returns the milliseconds since beginIteration(); 0 without a limit.
  double elapsed() const;

  double limit_ = 0.0;
  std::chrono::steady_clock::time_point begin_;
  std::array<History, kStageCount> histories_;
  double optional_ = 0.0;  ///< milliseconds of this iteration spent on deferrable work
  double particles_ = 0.0; ///< affordable number of particles per target; 0: not yet known
};

} // namespace dewpoint::tracking
