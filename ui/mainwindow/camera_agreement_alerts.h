// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/session/snapshot/snapshot.h"

#include <QObject>
#include <QString>

#include <cstddef>
#include <vector>

namespace dewpoint::ui {

class MessageBar;

/// Shows a message when cameras disagree, with the reason and a button for each way to correct it.
/// Each reason is shown once; the next reason follows when the first one is resolved. Once closed
/// by the user, a message does not reappear.
class CameraAgreementAlerts : public QObject {
  Q_OBJECT
public:
  explicit CameraAgreementAlerts(MessageBar& bar, QObject* parent = nullptr);

  /// Shows or removes messages for the cameras in the newest snapshot. Null means that the run is
  /// over; earlier alerts are forgotten.
  void setSnapshot(const TrackSnapshotPtr& snapshot);
  /// Suppresses alerts while the user calibrates.
  void setSuppressed(bool resting) { suppressed_ = resting; }

Q_SIGNALS:
  void rigCorrectionRequested(const dewpoint::camera_motion::CameraDisagreement& found,
                              std::size_t choice);
  void calibrationRequested(int camera);

private:
  void withdraw();
  void show(const CameraDisagreement& found, const QStringList& names);

  MessageBar& bar_;
  std::vector<CameraDisagreement> shown_; ///< disagreements that were shown and still exist
  QString text_;                          ///< last question asked
  bool suppressed_ = false;
};

} // namespace dewpoint::ui
