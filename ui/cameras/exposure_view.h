// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/session/view/target_exposures.h"
#include "ui/jobs/latest_job.h"

#include <QElapsedTimer>
#include <QWidget>

#include <vector>

class QLabel;

namespace dewpoint::ui {

class CameraListModel;
class ExposureBars;

/// Shows whether the targets are well exposed: a histogram of the worst exposed target in the
/// selected camera, and a sentence for each camera with a target that is overexposed or too dark.
class ExposureView : public QWidget {
  Q_OBJECT
public:
  explicit ExposureView(const CameraListModel& cameras, QWidget* parent = nullptr);

  /// Measures the exposure of the targets of a snapshot in another thread, and then shows the
  /// result. Hides the view if the snapshot is null or contains people.
  void setSnapshot(const TrackSnapshotPtr& snapshot);
  /// Sets the camera whose histogram is shown.
  void setCamera(int camera);

private:
  /// Last measurement in the images of one camera.
  struct Measured {
    std::vector<ExposureInView> exposures;
    QElapsedTimer age; ///< time since this measurement
  };

  void take(std::vector<std::vector<ExposureInView>> measured, const FrameSet& frames);
  void refresh();
  QString sentenceFor(int camera, const TargetExposure& exposure) const;

  const CameraListModel& cameras_;
  int camera_ = -1;
  std::vector<Measured> measured_; ///< measured exposures, one per camera
  QLabel* title_;
  ExposureBars* bars_;
  QLabel* shares_;
  QLabel* sentences_;
  LatestJob job_{LatestJob::SupersededJob::Kept};
};

} // namespace dewpoint::ui
