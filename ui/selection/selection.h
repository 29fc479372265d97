// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/floors.h"

#include <QObject>

#include <optional>

namespace dewpoint::ui {

/// A stretch of frames, both ends included.
struct SelectedRange {
  qint64 first = 0;
  qint64 last = 0;
  bool operator==(const SelectedRange&) const = default;
};

/// What is selected, in all views at once: frame, range, target and camera. A view shows what the
/// `...Changed` signals report and passes on with `request...` and `select...` what the user points
/// at; views never talk to each other. The window hands the request for a frame to the session and
/// sets the current frame once its images are there.
class Selection : public QObject {
  Q_OBJECT
public:
  explicit Selection(QObject* parent = nullptr) : QObject(parent) {}

  /// Frame shown in all views; -1 before the first.
  qint64 currentFrame() const { return currentFrame_; }
  /// Its time, seconds.
  double seconds() const { return seconds_; }
  /// Whether that is an earlier frame than the run stands at, or an untracked one.
  bool isPast() const { return past_; }
  const std::optional<SelectedRange>& selectedRange() const { return selectedRange_; }
  /// Index of the selected target or camera; -1: none.
  int target() const { return target_; }
  int camera() const { return camera_; }
  /// Index of the selected one of the cameras that are only planned, which stands out in place of
  /// the selected camera; -1: none.
  int plannedCamera() const { return plannedCamera_; }

  /// The user points at a frame (timeline, plot, table).
  void requestFrame(qint64 frame) { Q_EMIT frameRequested(frame); }
  /// The user wants to see again where the run stands.
  void requestLiveFrame() { Q_EMIT liveFrameRequested(); }
  /// The frame that is shown from now on: for the window.
  void setCurrentFrame(qint64 frame, double seconds, bool past);

  void selectRange(std::optional<SelectedRange> selectedRange);
  void selectTarget(int target);
  void selectCamera(int camera);
  void selectPlannedCamera(int planned);
  /// Nothing of a run is selected any more, and nothing shown. Cameras are not of the run.
  void clear();

Q_SIGNALS:
  void frameRequested(qint64 frame);
  void liveFrameRequested();
  void currentFrameChanged(qint64 frame, double seconds);
  void rangeChanged();
  void targetSelected(int target);
  void cameraSelected(int camera);
  void plannedCameraSelected(int planned);

private:
  qint64 currentFrame_ = -1;
  double seconds_ = 0.0;
  bool past_ = false;
  std::optional<SelectedRange> selectedRange_;
  int target_ = -1;
  int camera_ = -1;
  int plannedCamera_ = -1;
};

} // namespace dewpoint::ui
