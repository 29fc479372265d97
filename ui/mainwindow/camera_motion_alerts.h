// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/session/snapshot/snapshot.h"
#include "core/session/watch/camera_motion_messages.h"

#include <QObject>
#include <QString>

#include <map>

namespace dewpoint::ui {

class MessageBar;

/// Shows a message when a camera has moved, with advice. If the run has found the new pose, one
/// click applies it. Each stage (moved, new pose known, pose cannot be computed, moved back) is
/// reported once per camera. If several cameras have moved, the question about each one stays until
/// it is answered. Once closed by the user, a message does not reappear.
class CameraMotionAlerts : public QObject {
  Q_OBJECT
public:
  explicit CameraMotionAlerts(MessageBar& bar, QObject* parent = nullptr);

  /// Shows or removes messages for the moved cameras in the newest snapshot. Null means that the
  /// run is over; earlier alerts are forgotten.
  void setSnapshot(const TrackSnapshotPtr& snapshot);

Q_SIGNALS:
  void newPoseRequested(int camera);
  void calibrationRequested(int camera);

private:
  void clear();
  void showAlert(const CameraMotionReport& report, CameraMotionStage stage, const QString& camera);
  void ask(int camera, const QString& question, const QString& answer,
           void (CameraMotionAlerts::*answered)(int));
  /// Withdraw the questions about all cameras, and about one camera.
  void withdraw();
  void withdraw(int camera);

  MessageBar& bar_;
  CameraMotionMessages news_;
  QString notice_;                   ///< last notice shown in the bar
  std::map<int, QString> questions_; ///< last question about each camera
};

} // namespace dewpoint::ui
