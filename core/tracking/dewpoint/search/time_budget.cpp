// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/tracking/dewpoint/search/time_budget.h"

#include "core/base/statistics.h"

#include <algorithm>

namespace dewpoint::tracking {
namespace {

// Judgments (docs/method-dewpoint.md, section 10).

constexpr std::size_t kRemembered = 15; ///< measured times of a part
/// Share of the budget for updates; the rest is for work that can wait, and a reserve.
constexpr double kUpdateShare = 0.6;
/// Share of the budget after which no deferrable work may be expected to end.
constexpr double kFullShare = 0.8;
/// Factors of the number of particles per iteration, least and largest: down at once, up slowly, as
/// a budget must be kept, not met on average.
constexpr double kFastestFall = 0.25;
constexpr double kFastestRise = 1.1;
constexpr double kFewestParticles = 10.0; ///< per target

} // namespace

void TimeBudget::setLimit(double milliseconds) {
  if (milliseconds != limit_) {
    *this = TimeBudget();
    limit_ = milliseconds;
  }
}

void TimeBudget::beginIteration() {
  if (isLimited()) {
    begin_ = std::chrono::steady_clock::now();
    optional_ = 0.0;
  }
}

double TimeBudget::elapsed() const {
  if (!isLimited()) {
    return 0.0;
  }
  const std::chrono::duration<double, std::milli> passed =
      std::chrono::steady_clock::now() - begin_;
  return passed.count();
}

bool TimeBudget::canAfford(Stage stage) {
  if (!isLimited()) {
    return true;
  }
  History& history = histories_[static_cast<std::size_t>(stage)];
  const double expected = upperMedian(history.durations);
  const bool fits = elapsed() + expected <= kFullShare * limit_;
  history.deferralCount = fits ? 0 : history.deferralCount + 1;
  return fits || history.deferralCount > kMaxDeferrals;
}

void TimeBudget::record(Stage stage, double milliseconds) {
  if (!isLimited()) {
    return;
  }
  History& history = histories_[static_cast<std::size_t>(stage)];
  history.deferralCount = 0;
  optional_ += milliseconds;
  if (history.durations.size() < kRemembered) {
    history.durations.push_back(milliseconds);
    return;
  }
  history.durations[history.nextIndex] = milliseconds;
  history.nextIndex = (history.nextIndex + 1) % kRemembered;
}

void TimeBudget::adaptParticleCount(double most) {
  const double taken = elapsed() - optional_;
  if (taken <= 0.0) {
    return;
  }
  const double now = particles_ > 0.0 ? std::min(particles_, most) : most;
  const double factor = std::clamp(kUpdateShare * limit_ / taken, kFastestFall, kFastestRise);
  particles_ = std::clamp(now * factor, kFewestParticles, std::max(most, kFewestParticles));
}

std::optional<double> TimeBudget::affordableParticleCount() const {
  return particles_ > 0.0 ? std::optional(particles_) : std::nullopt;
}

} // namespace dewpoint::tracking
