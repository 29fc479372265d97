// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/floors.h"

#include <array>
#include <chrono>
#include <cstddef>
#include <optional>
#include <vector>

namespace dewpoint::tracking {

/// The clock of one iteration that must not take longer than a budget. What can wait is done when
/// the time that such work took of late (a running median) still fits, and put off otherwise; what
/// cannot is made cheaper by fewer particles. Without a budget everything is done at once, no clock
/// is read, and a run can be repeated bit by bit.
class TimeBudget {
public:
  /// Work that can wait.
  enum class Part { Labels, Spots, Candidates, Learning };
  static constexpr std::size_t kPartCount = 4;
  /// After being put off so often work is done anyway: a budget that leaves no time for it slows it
  /// down, but does not stop it.
  static constexpr int kMaxDeferrals = 30;

  /// Milliseconds per iteration; 0 is no limit. A change forgets what was measured.
  void set(double milliseconds);
  bool limited() const { return limit_ > 0.0; }
  /// An iteration begins now.
  void begin();

  /// Does the work if there is time for it; whether it did. Work that was never done before is
  /// taken to fit. `urgent` work is not put off.
  template <class Work> bool spend(Part part, const Work& work, bool urgent = false) {
    if (!urgent && !affords(part)) {
      return false;
    }
    const double start = elapsed();
    work();
    record(part, elapsed() - start);
    return true;
  }

  /// The work that cannot wait is done: adapts the number of particles to the time it took.
  void endOfUpdates(double most);
  /// Particles per target that fit, at least ten; none without a limit.
  std::optional<double> particles() const;

private:
  /// The last times of one part, in milliseconds.
  struct History {
    std::vector<double> times;
    std::size_t next = 0;
    int deferrals = 0;
  };

  bool affords(Part part);
  void record(Part part, double milliseconds);
  /// Milliseconds since begin(); 0 without a limit.
  double elapsed() const;

  double limit_ = 0.0;
  std::chrono::steady_clock::time_point begin_;
  std::array<History, kPartCount> histories_;
  double optional_ = 0.0;  ///< milliseconds of this iteration for what could have waited
  double particles_ = 0.0; ///< 0: not yet known
};

} // namespace dewpoint::tracking
