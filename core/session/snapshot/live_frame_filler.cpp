// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/session/snapshot/live_frame_filler.h"

namespace dewpoint::session {

TrackSnapshotPtr LiveFrameFiller::withMissingImages(const TrackSnapshotPtr& snapshot) {
  const bool live = snapshot && snapshot->frames && !snapshot->frameCount && !snapshot->isPast;
  if (!live) {
    return snapshot;
  }
  const FrameSet& now = *snapshot->frames;
  frames_.resize(now.frames.size());
  masks_.resize(now.frames.size());
  FrameSet seen = now;
  std::vector<cv::Mat> masks = snapshot->masks;
  bool any = false;
  for (std::size_t k = 0; k < now.frames.size(); ++k) {
    const bool hasMask = k < masks.size();
    if (now.frames[k]) {
      frames_[k] = now.frames[k];
      masks_[k] = hasMask ? masks[k] : cv::Mat();
      continue;
    }
    const double age =
        frames_[k] ? seconds(now.time - frames_[k]->captureTime) : kMaxImageAgeSeconds;
    if (age >= 0.0 && age < kMaxImageAgeSeconds) {
      seen.frames[k] = frames_[k];
      if (hasMask) {
        masks[k] = masks_[k];
      }
      any = true;
    }
  }
  if (!any) {
    return snapshot;
  }
  auto copy = std::make_shared<TrackSnapshot>(*snapshot);
  copy->frames = std::make_shared<const FrameSet>(std::move(seen));
  copy->masks = std::move(masks);
  return copy;
}

} // namespace dewpoint::session
