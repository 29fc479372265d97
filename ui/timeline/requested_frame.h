// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/floors.h"

#include <QElapsedTimer>

#include <optional>

namespace dewpoint::ui {

/// Stores the frame that was requested last, until it is shown. A frame that is not shown in time
/// is forgotten.
class RequestedFrame {
public:
  void request(qint64 frame) {
    frame_ = frame;
    requestedAt_.start();
  }
  void onFrameShown(qint64 frame) {
    if (frame_ == frame) {
      frame_.reset();
    }
  }
  void forget() { frame_.reset(); }
  /// Returns the requested frame, or nothing if there is no pending request.
  std::optional<qint64> frame() const {
    return requestedAt_.isValid() && requestedAt_.elapsed() < kTimeoutMs ? frame_ : std::nullopt;
  }

private:
  static constexpr qint64 kTimeoutMs = 1500;
  std::optional<qint64> frame_;
  QElapsedTimer requestedAt_;
};

} // namespace dewpoint::ui
