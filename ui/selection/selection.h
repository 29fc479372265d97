// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/floors.h"

#include <QObject>

#include <optional>

namespace dewpoint::ui {

/// Range of frames, including both ends.
struct SelectedRange {
  qint64 first = 0;
  qint64 last = 0;
  bool operator==(const SelectedRange&) const = default;
};

/// Selection shared by all views: frame, range, target and camera. Views follow the signals, and
/// call `request...` and `select...` when the user points at something; they never communicate with
/// each other directly. The window forwards frame requests to the session, and sets the current
/// frame once its images are available.
class Selection : public QObject {
  Q_OBJECT
public:
  explicit Selection(QObject* parent = nullptr) : QObject(parent) {}

  /// Returns the frame shown in all views, or -1 before the first frame.
  qint64 currentFrame() const { return currentFrame_; }
  /// Returns the time of the current frame in seconds.
  double currentSeconds() const { return seconds_; }
  /// Returns whether the frame shown is not the current frame of the run: it is earlier, or not
  /// tracked yet.
  bool isAwayFromLiveFrame() const { return past_; }
  const std::optional<SelectedRange>& selectedRange() const { return selectedRange_; }
  /// Return the index of the selected target and of the selected camera; -1 if none is selected.
  int target() const { return target_; }
  int camera() const { return camera_; }
  /// Returns the index of the selected planned camera (a camera that does not exist yet), or -1 if
  /// none is selected. A selected planned camera is highlighted instead of the selected camera.
  int plannedCamera() const { return plannedCamera_; }

  /// Requests a frame that the user points at (in the timeline, a plot or a table).
  void requestFrame(qint64 frame) { Q_EMIT frameRequested(frame); }
  /// Requests the run's current frame again.
  void requestLiveFrame() { Q_EMIT liveFrameRequested(); }
  /// Sets the frame shown from now on and its time. `past` is true if this is not the current frame
  /// of the run. Called by the window.
  void setCurrentFrame(qint64 frame, double seconds, bool past);

  void selectRange(std::optional<SelectedRange> selectedRange);
  void selectTarget(int target);
  void selectCamera(int camera);
  void selectPlannedCamera(int planned);
  /// Clears the current frame and the selection at the end of a run. The selected camera stays,
  /// because it does not depend on the run.
  void clear();

Q_SIGNALS:
  void frameRequested(qint64 frame);
  void liveFrameRequested();
  void currentFrameChanged(qint64 frame, double seconds);
  void selectedRangeChanged();
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
