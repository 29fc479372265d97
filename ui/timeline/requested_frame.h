// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/floors.h"

#include <QElapsedTimer>

#include <optional>

namespace dewpoint::ui {

/// The frame that was requested last, until it is shown; one that never comes is forgotten.
class RequestedFrame {
public:
  void request(qint64 frame) {
    frame_ = frame;
    since_.start();
  }
  void noteShown(qint64 frame) {
    if (frame_ == frame) {
      frame_.reset();
    }
  }
  void forget() { frame_.reset(); }
  /// Nothing: what is shown is what was requested.
  std::optional<qint64> frame() const {
    return since_.isValid() && since_.elapsed() < kTimeoutMs ? frame_ : std::nullopt;
  }

private:
  static constexpr qint64 kTimeoutMs = 1500;
  std::optional<qint64> frame_;
  QElapsedTimer since_;
};

} // namespace dewpoint::ui
