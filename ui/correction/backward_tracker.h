// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "ui/jobs/latest_job.h"
#include "ui/workbench/workbench.h"

#include <QElapsedTimer>
#include <QObject>
#include <QString>

#include <cstdint>
#include <string>
#include <vector>

namespace dewpoint::project {
struct PositionCorrection;
} // namespace dewpoint::project
namespace dewpoint::trajectory {
struct TrajectorySample;
} // namespace dewpoint::trajectory

namespace dewpoint::ui {

/// Tracks a target backward in time from a position that the user corrected. For this, the
/// recording is opened and read a second time, in another thread. The positions found are added to
/// the document as part of the correction step. A new request replaces one in progress. If the work
/// takes long, a message shows its progress and offers to stop it.
class BackwardTracker : public QObject {
  Q_OBJECT
public:
  BackwardTracker(const Workbench& bench, QObject* parent);

  /// Starts tracking backward from a correction in the document. `believed` are the estimates of
  /// all targets in the run (BackwardRequest::estimates); estimates of later frames are ignored.
  /// The step that stores the result is merged with the correction step, which has the same
  /// `mergeKey`. Does nothing for live cameras.
  void start(const PositionCorrection& correction, std::vector<TrajectorySample> believed,
             const std::string& mergeKey);
  void cancel();
  bool isRunning() const { return job_.isRunning(); }

private:
  void storeCorrections(const PositionCorrection& from,
                        const std::vector<PositionCorrection>& found, const std::string& mergeKey);
  void showProgress(double part);
  void clearProgress();

  Workbench bench_;
  LatestJob job_{LatestJob::SupersededJob::Dropped};
  std::int64_t frame_ = 0; ///< frame of the correction where tracking started
  QElapsedTimer sinceStart_;
  QElapsedTimer sinceShown_;
  QString shown_; ///< text of the message
};

} // namespace dewpoint::ui
