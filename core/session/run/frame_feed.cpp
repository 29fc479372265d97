// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/session/run/frame_feed.h"

#include "core/project/project_check.h"
#include "core/session/run/background_images.h"
#include "core/session/run/frame_loop.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <memory>
#include <utility>

namespace dewpoint::session {
namespace {

constexpr double kLatestSeconds = 9e9; // nanoseconds of a TimeStamp hold no more

tl::unexpected<Error> wrongStep(const char* field, std::string detail) {
  return failure(ErrorCode::BadValue, "", field, std::move(detail));
}

} // namespace

Result<FrameFeed> FrameFeed::create(const Project& project, int threads) {
  const auto checked = checkProject(project).and_then([&] { return checkMethodTargets(project); });
  if (!checked) {
    return tl::make_unexpected(checked.error());
  }
  auto rooms = loadBackgroundImages(project);
  if (!rooms) {
    return tl::make_unexpected(rooms.error());
  }
  return TrackingRun::create(project, threads, std::move(*rooms)).map([](TrackingRun&& run) {
    return FrameFeed(std::move(run));
  });
}

Status FrameFeed::checkImages(const std::vector<cv::Mat>& images) const {
  const CameraRig& rig = run_.rig();
  if (images.size() != rig.size()) {
    return wrongStep(
        "images", fmt::format("expected one per camera ({}), found {}", rig.size(), images.size()));
  }
  if (std::ranges::all_of(images, [](const cv::Mat& image) { return image.empty(); })) {
    return wrongStep("images", "no camera has one");
  }
  for (std::size_t k = 0; k < images.size(); ++k) {
    const cv::Mat& image = images[k];
    const Intrinsics& in = rig[k].intrinsics;
    if (image.empty()) {
      continue;
    }
    if (image.type() != CV_8UC3) {
      return wrongStep(
          "images", fmt::format("the image of {} does not have three 8-bit channels", rig[k].name));
    }
    if (image.cols != in.width || image.rows != in.height) {
      return wrongStep("images",
                       fmt::format("that of {} is {}x{} pixels, but its calibration is for {}x{}",
                                   rig[k].name, image.cols, image.rows, in.width, in.height));
    }
  }
  return {};
}

Status FrameFeed::step(const std::vector<cv::Mat>& images, double time) {
  if (const auto good = checkImages(images); !good) {
    return good;
  }
  if (!std::isfinite(time) || std::abs(time) > kLatestSeconds) {
    return wrongStep("time", fmt::format("seconds are expected, found {}", time));
  }
  if (!(time > time_)) {
    return wrongStep("time", fmt::format("{} s does not come after {} s", time, time_));
  }
  auto set = std::make_shared<FrameSet>();
  set->index = steps_;
  set->time = timeStamp(time);
  for (const cv::Mat& image : images) {
    set->frames.push_back(
        image.empty() ? nullptr : std::make_shared<const Frame>(Frame{steps_, set->time, image}));
  }
  ++steps_;
  time_ = time;
  return trackOneFrame(run_, std::move(set), {});
}

void FrameFeed::restart() {
  run_.restart(run_.definition()->seed);
  steps_ = 0;
  time_ = -std::numeric_limits<double>::infinity();
}

} // namespace dewpoint::session
