// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/color/image_histogram_job.h"

#include <memory>
#include <vector>

namespace dewpoint::ui {

namespace {
constexpr qint64 kSurveyMs = 1000;
} // namespace

void ImageHistogramJob::start(const TrackSnapshotPtr& snapshot) {
  if (sinceLast_.isValid() && sinceLast_.elapsed() <= kSurveyMs) {
    return;
  }
  sinceLast_.start();
  if (!snapshot || !snapshot->frames) {
    return;
  }
  job_.start([this, frames = snapshot->frames](const BackgroundJob::Progress&) {
    std::vector<cv::Mat> images;
    for (const FramePtr& frame : frames->frames) {
      if (frame) {
        images.push_back(frame->image);
      }
    }
    auto histogram = std::make_shared<const ColorHistogram>(histogramOf(images));
    return [this, histogram] { Q_EMIT finished(*histogram); };
  });
}

} // namespace dewpoint::ui
