// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/floors.h"

#include <QTest>
#include <QWidget>

#include <functional>

namespace dewpoint::tests::test {

/// What a test waits for: always a condition, never a time that is hoped to be enough.
class Waiting {
protected:
  /// How long a test waits before it fails, ms: enough for software OpenGL, a loaded machine and a
  /// sanitizer.
  static constexpr int kTimeoutMs = DEWPOINT_PATIENCE_MS;

  /// Runs the event loop until the condition holds; false when it never does.
  static bool waitFor(const std::function<bool()>& holds) {
    return QTest::qWaitFor(holds, kTimeoutMs);
  }
  /// Runs the event loop until a widget has kept its size for some rounds of it: the layout is
  /// done.
  static bool keepsItsSize(const QWidget* widget) {
    constexpr int kRounds = 10;
    QSize size;
    int same = 0;
    return waitFor([&] {
      same = widget->size() == size ? same + 1 : 0;
      size = widget->size();
      return same > kRounds;
    });
  }
  /// Runs the event loop for as long as something unwanted would take to happen. Only for tests
  /// that nothing does, when there is no condition to wait for, and for a hand that moves at a pace
  /// of its own.
  static void letTimePass(int milliseconds = 300) { QTest::qWait(milliseconds); }
};

} // namespace dewpoint::tests::test
