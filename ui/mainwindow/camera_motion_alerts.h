// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/session/snapshot/snapshot.h"
#include "core/session/watch/camera_motion_messages.h"

#include <QObject>
#include <QString>

namespace dewpoint::ui {

class MessageBar;

/// Shows a message when a camera has moved, with advice. If the run has found the new pose, one
/// click applies it. Each state of a moved camera is reported once. Once closed by the user, a
/// message does not reappear.
class CameraMotionAlerts : public QObject {
  Q_OBJECT
public:
  explicit CameraMotionAlerts(MessageBar& bar, QObject* parent = nullptr);

  /// Sets the frame shown. Null means that the run is over; earlier alerts are forgotten.
  void setSnapshot(const TrackSnapshotPtr& snapshot);

Q_SIGNALS:
  void newPoseRequested(int camera);
  void calibrationRequested(int camera);

private:
  void clear();
  void showAlert(const CameraMotionReport& report, CameraMotionStage stage, const QString& camera);
  void withdraw();

  MessageBar& bar_;
  CameraMotionMessages news_;
  QString text_; ///< last text shown in the bar
};

} // namespace dewpoint::ui
