// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/session/run/camera_motion_news.h"
#include "core/session/run/snapshot.h"

#include <QObject>
#include <QString>

namespace dewpoint::ui {

class MessageBar;

/// Shows in the message bar that a camera was moved, and what to do: one click solves it again
/// where that is possible. Each state of a moved camera is reported once; whoever closes the bar is
/// left alone.
class CameraMotionAlerts : public QObject {
  Q_OBJECT
public:
  explicit CameraMotionAlerts(MessageBar& bar, QObject* parent = nullptr);

  /// The frame shown; null: the run is over, and what was reported counts no more.
  void setSnapshot(const TrackSnapshotPtr& snapshot);

Q_SIGNALS:
  void newPoseWanted(int camera);
  void calibrateWanted(int camera);

private:
  void clear();
  void showAlert(const CameraMotionReport& report, CameraMotionStage stage, const QString& camera);
  void withdraw();

  MessageBar& bar_;
  CameraMotionNews news_;
  QString text_; ///< what the bar was given last
};

} // namespace dewpoint::ui
