// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/color/color_histogram.h"
#include "core/session/snapshot/snapshot.h"
#include "ui/jobs/background_job.h"

#include <QElapsedTimer>

namespace dewpoint::ui {

/// Computes the histogram of the colors in the images in another thread, at most once per second.
class ImageHistogramJob : public QObject {
  Q_OBJECT
public:
  using QObject::QObject;

  /// Computes the histogram of the images of a snapshot in another thread, and emits `finished()`
  /// afterward. Does nothing if less than a second has passed since the last time, or if the
  /// snapshot has no images.
  void start(const TrackSnapshotPtr& snapshot);

Q_SIGNALS:
  void finished(const dewpoint::color::ColorHistogram& histogram);

private:
  QElapsedTimer sinceLast_;
  BackgroundJob job_;
};

} // namespace dewpoint::ui
