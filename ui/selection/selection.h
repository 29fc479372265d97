// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/floors.h"

#include <QObject>

#include <optional>

namespace dewpoint::ui {

/// Range of frames, both ends included.
struct SelectedRange {
  qint64 first = 0;
  qint64 last = 0;
  bool operator==(const SelectedRange&) const = default;
};

/// Selection shared by all views: frame, range, target and camera. Views show what the `...Changed`
/// signals report, and pass on what the user points at with `request...` and `select...`; they
/// never talk to each other. The window forwards requests for a frame to the session, and sets the
/// current frame once its images are available.
class Selection : public QObject {
  Q_OBJECT
public:
  explicit Selection(QObject* parent = nullptr) : QObject(parent) {}

  /// Frame shown in all views; -1 before the first.
  qint64 currentFrame() const { return currentFrame_; }
  /// Time of that frame, seconds.
  double seconds() const { return seconds_; }
  /// Whether that frame is earlier than the current frame of the run, or untracked.
  bool isPast() const { return past_; }
  const std::optional<SelectedRange>& selectedRange() const { return selectedRange_; }
  /// Index of the selected target or camera; -1: none.
  int target() const { return target_; }
  int camera() const { return camera_; }
  /// Index of the selected planned camera, which is highlighted instead of the selected camera; -1:
  /// none.
  int plannedCamera() const { return plannedCamera_; }

  /// Requests a frame that the user points at (timeline, plot, table).
  void requestFrame(qint64 frame) { Q_EMIT frameRequested(frame); }
  /// Requests the current frame of the run again.
  void requestLiveFrame() { Q_EMIT liveFrameRequested(); }
  /// Sets the frame shown from now on; called by the window.
  void setCurrentFrame(qint64 frame, double seconds, bool past);

  void selectRange(std::optional<SelectedRange> selectedRange);
  void selectTarget(int target);
  void selectCamera(int camera);
  void selectPlannedCamera(int planned);
  /// Clears the selection and the current frame of a run. The selected camera stays, because it
  /// does not depend on the run.
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
