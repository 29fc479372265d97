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

/// Follows a target back in time from where a person said that it is, in a thread that reads the
/// recording by itself, and puts what was found into the document, as a part of the step that said
/// so. Only the newest order counts. When it takes long, a message says how far it is, and can stop
/// it.
class BackwardTracker : public QObject {
  Q_OBJECT
public:
  BackwardTracker(const Workbench& bench, QObject* parent);

  /// From a correction that is in the document; `believed` as BackwardOrder, later frames count for
  /// nothing. The step that keeps what is found is merged with the one of the correction by
  /// `mergeKey`. Nothing for live cameras.
  void start(const PositionCorrection& correction, std::vector<TrajectorySample> believed,
             const std::string& mergeKey);
  void cancel();
  bool isRunning() const { return job_.isRunning(); }

private:
  void keep(const PositionCorrection& from, const std::vector<PositionCorrection>& found,
            const std::string& mergeKey);
  void showProgress(double part);
  void clearProgress();

  Workbench bench_;
  LatestJob job_{LatestJob::Overtaken::Dropped};
  std::int64_t frame_ = 0; ///< of the correction that is followed
  QElapsedTimer sinceStart_;
  QElapsedTimer sinceShown_;
  QString shown_; ///< what the message says
};

} // namespace dewpoint::ui
