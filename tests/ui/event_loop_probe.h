// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/floors.h"

#include <QElapsedTimer>
#include <QTimer>

#include <algorithm>

namespace dewpoint::tests {

/// Measures how long the event loop lets a timer wait: a stall is what a person feels when the
/// window does not answer. Milliseconds.
class EventLoopProbe {
public:
  EventLoopProbe() {
    timer_.setTimerType(Qt::PreciseTimer);
    QObject::connect(&timer_, &QTimer::timeout, [this] { tick(); });
    clock_.start();
    timer_.start(kIntervalMs);
  }

  /// How often the event loop has let it measure.
  int ticks() const { return ticks_; }
  /// The longest stall since the last call.
  double takeLongest() {
    const double longest = longest_;
    longest_ = 0.0;
    return longest;
  }

private:
  static constexpr int kIntervalMs = 5;

  void tick() {
    const double gap = 1e-6 * static_cast<double>(clock_.nsecsElapsed());
    clock_.restart();
    ++ticks_;
    longest_ = std::max(longest_, gap - kIntervalMs);
  }

  QTimer timer_;
  QElapsedTimer clock_;
  double longest_ = 0.0;
  int ticks_ = 0;
};

} // namespace dewpoint::tests
