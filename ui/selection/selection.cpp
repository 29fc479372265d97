// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/selection/selection.h"

#include <utility>

namespace dewpoint::ui {

void Selection::setCurrentFrame(qint64 frame, double seconds, bool past) {
  const bool changed = frame != currentFrame_ || seconds != seconds_ || past != past_;
  currentFrame_ = frame;
  seconds_ = seconds;
  past_ = past;
  if (changed) {
    Q_EMIT currentFrameChanged(frame, seconds);
  }
}

void Selection::selectRange(std::optional<SelectedRange> selectedRange) {
  if (selectedRange && selectedRange->first > selectedRange->last) {
    std::swap(selectedRange->first, selectedRange->last);
  }
  if (selectedRange != selectedRange_) {
    selectedRange_ = selectedRange;
    Q_EMIT selectedRangeChanged();
  }
}

void Selection::selectTarget(int target) {
  if (std::exchange(target_, target) != target) {
    Q_EMIT targetSelected(target);
  }
}

void Selection::selectCamera(int camera) {
  if (std::exchange(camera_, camera) != camera) {
    Q_EMIT cameraSelected(camera);
  }
  selectPlannedCamera(-1);
}

void Selection::selectPlannedCamera(int planned) {
  if (std::exchange(plannedCamera_, planned) != planned) {
    Q_EMIT plannedCameraSelected(planned);
  }
}

void Selection::clear() {
  selectRange(std::nullopt);
  selectTarget(-1);
  setCurrentFrame(-1, 0.0, false);
}

} // namespace dewpoint::ui
