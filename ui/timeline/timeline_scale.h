// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/floors.h"

#include <QtGlobal>

#include <algorithm>
#include <cmath>

namespace dewpoint::ui {

/// Maps frames to positions along a timeline. Frame k covers xOf(k) to xOf(k + 1), in widget units.
class TimelineScale {
public:
  /// Sets the first and last frame, both inclusive.
  void setExtent(qint64 first, qint64 last) {
    const bool whole = showsWholeRun();
    first_ = first;
    last_ = std::max(first, last);
    whole ? showWholeRun() : clampToExtent();
  }
  void setPixelRange(double left, double width) {
    left_ = left;
    width_ = std::max(1.0, width);
  }
  qint64 firstFrame() const { return first_; }
  qint64 lastFrame() const { return last_; }
  double shownBegin() const { return begin_; }
  double shownEnd() const { return begin_ + length_; }
  double pixelsPerFrame() const { return width_ / length_; }

  double xOf(double frame) const { return left_ + (frame - begin_) * pixelsPerFrame(); }
  qint64 frameAt(double x) const {
    const double frame = std::floor(begin_ + (x - left_) / pixelsPerFrame());
    return std::clamp(static_cast<qint64>(frame), first_, last_);
  }

  bool showsWholeRun() const { return length_ >= static_cast<double>(last_ - first_ + 1); }
  void showWholeRun() {
    begin_ = static_cast<double>(first_);
    length_ = static_cast<double>(last_ - first_ + 1);
  }
  void showFrames(qint64 first, qint64 last) {
    begin_ = static_cast<double>(first);
    length_ = static_cast<double>(last - first + 1);
    clampToExtent();
  }
  /// Zooms by `factor` (above 1 zooms in). The frame at the position `x` (widget units) stays at
  /// this position.
  void zoom(double factor, double x) {
    const double frame = begin_ + (x - left_) / pixelsPerFrame();
    const double share = (x - left_) / width_;
    length_ /= factor;
    clampToExtent();
    begin_ = frame - share * length_;
    clampToExtent();
  }
  void scroll(double frames) {
    begin_ += frames;
    clampToExtent();
  }
  /// Scrolls just far enough to show a frame.
  void reveal(qint64 frame) {
    const double margin = std::min(0.05 * length_, 20.0);
    const auto at = static_cast<double>(frame);
    if (at < begin_ + margin) {
      begin_ = at - margin;
    } else if (at + 1.0 > shownEnd() - margin) {
      begin_ = at + 1.0 + margin - length_;
    }
    clampToExtent();
  }

private:
  static constexpr double kMinFrames = 10.0; ///< minimum number of frames shown

  void clampToExtent() {
    const auto all = static_cast<double>(last_ - first_ + 1);
    length_ = std::clamp(length_, std::min(kMinFrames, all), all);
    begin_ =
        std::clamp(begin_, static_cast<double>(first_), static_cast<double>(last_ + 1) - length_);
  }

  qint64 first_ = 0;
  qint64 last_ = 0;
  double begin_ = 0.0;
  double length_ = 1.0;
  double left_ = 0.0;
  double width_ = 1.0;
};

} // namespace dewpoint::ui
