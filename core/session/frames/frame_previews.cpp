// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/session/frames/frame_previews.h"

#include <opencv2/imgcodecs.hpp>
#include <opencv2/imgproc.hpp>

#include <algorithm>
#include <exception>
#include <iterator>

namespace dewpoint::session {
namespace {

// Tuned; where no source is named here or in the docs, the origin is not recorded.
constexpr int kWidth = 160; ///< pixels
/// Quality of JPEG, 1 to 100.
constexpr int kPreviewQuality = 75;
/// A picture stands for frames up to this many behind it.
constexpr std::int64_t kFarthest = 16;

} // namespace

void FramePreviews::add(const FrameSet& frames) {
  if (frames.index % spacing_ != 0 || entries_.contains(frames.index)) {
    return;
  }
  Entry entry;
  entry.time = frames.time;
  entry.bytes = sizeof(Entry) + frames.frames.size() * sizeof(Thumbnail);
  try {
    for (const FramePtr& frame : frames.frames) {
      Thumbnail& small = entry.cameras.emplace_back();
      if (frame && !frame->image.empty()) {
        small.width = frame->image.cols;
        small.height = frame->image.rows;
        const int height = std::max(1, small.height * kWidth / std::max(1, small.width));
        cv::Mat picture;
        cv::resize(frame->image, picture, {kWidth, height}, 0.0, 0.0, cv::INTER_AREA);
        cv::imencode(".jpg", picture, small.jpeg, {cv::IMWRITE_JPEG_QUALITY, kPreviewQuality});
        entry.bytes += small.jpeg.size();
      }
    }
  } catch (const std::exception&) {
    return; // then there is none
  }
  bytes_ += entry.bytes;
  entries_.emplace(frames.index, std::move(entry));
  while (bytes_ > maxBytes_ && !entries_.empty()) {
    thin();
  }
}

void FramePreviews::thin() {
  spacing_ *= 2;
  for (auto found = entries_.begin(); found != entries_.end();) {
    const bool wanted = found->first % spacing_ == 0 && spacing_ <= kFarthest;
    bytes_ -= wanted ? 0 : found->second.bytes;
    found = wanted ? std::next(found) : entries_.erase(found);
  }
}

FrameSetPtr FramePreviews::at(std::int64_t frame) const {
  const auto next = entries_.upper_bound(frame);
  if (next == entries_.begin() || frame - std::prev(next)->first >= kFarthest) {
    return nullptr;
  }
  const Entry& entry = std::prev(next)->second;
  auto set = std::make_shared<FrameSet>();
  set->index = frame;
  set->time = entry.time;
  try {
    for (const Thumbnail& small : entry.cameras) {
      if (small.jpeg.empty()) {
        set->frames.push_back(nullptr);
        continue;
      }
      cv::Mat image;
      cv::resize(cv::imdecode(small.jpeg, cv::IMREAD_COLOR), image, {small.width, small.height},
                 0.0, 0.0, cv::INTER_LINEAR);
      set->frames.push_back(std::make_shared<const Frame>(Frame{frame, entry.time, image}));
    }
  } catch (const std::exception&) {
    return nullptr;
  }
  return set;
}

} // namespace dewpoint::session
