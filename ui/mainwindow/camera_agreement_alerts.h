// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/session/run/snapshot.h"

#include <QObject>
#include <QString>

#include <cstddef>
#include <vector>

namespace dewpoint::ui {

class MessageBar;

/// Shows in the message bar that cameras cannot agree and why, with a button for each way to mend
/// it. Each reason is shown once, and the next one when the first is dealt with; whoever closes the
/// bar is left alone.
class CameraAgreementAlerts : public QObject {
  Q_OBJECT
public:
  explicit CameraAgreementAlerts(MessageBar& bar, QObject* parent = nullptr);

  /// The frame shown; null: the run is over, and what was shown counts no more.
  void setSnapshot(const TrackSnapshotPtr& snapshot);
  /// While the user calibrates, nothing is shown.
  void setResting(bool resting) { resting_ = resting; }

Q_SIGNALS:
  void mendingWanted(const dewpoint::camera_motion::CameraDisagreement& found, std::size_t choice);
  void calibrateWanted(int camera);

private:
  void withdraw();
  void show(const CameraDisagreement& found, const QStringList& names);

  MessageBar& bar_;
  std::vector<CameraDisagreement> shown_; ///< of those that there are
  QString text_;                          ///< what the bar was given last
  bool resting_ = false;
};

} // namespace dewpoint::ui
