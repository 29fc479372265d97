// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/color/color_histogram.h"
#include "core/session/snapshot/snapshot.h"
#include "ui/jobs/background_job.h"

#include <QElapsedTimer>

namespace dewpoint::ui {

/// Which colors the images have, found in the background and once a second at most.
class ImageSurvey : public QObject {
  Q_OBJECT
public:
  using QObject::QObject;

  /// The images shown now; a survey that is not due, or one without images, is left out.
  void take(const TrackSnapshotPtr& snapshot);

Q_SIGNALS:
  void taken(const dewpoint::color::ColorHistogram& histogram);

private:
  QElapsedTimer sinceLast_;
  BackgroundJob job_;
};

} // namespace dewpoint::ui
