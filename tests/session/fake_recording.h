// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/capture/frame_source.h"
#include "core/session/session.h"
#include "core/tracking/catalog/method_catalog.h"

#include <opencv2/imgproc.hpp>

#include <atomic>
#include <chrono>
#include <functional>
#include <memory>
#include <thread>

namespace dewpoint::tests::test {

inline const Eigen::Vector3d kBall(0.0, 0.0, 0.1);
inline constexpr double kBallRadius = 0.04;
/// HSI of the disc's color by hand: I = 475/765 = 0.62, S = 1 - 3*85/475 = 0.46, hue about 337
/// degrees.
inline const cv::Scalar kDiscColor(145, 85, 245);

/// Two cameras 0.6 m from the ball that look at it at a right angle.
inline CameraRig twoCameras() {
  CameraRig rig(2);
  for (int k = 0; k < 2; ++k) {
    auto& camera = rig[static_cast<std::size_t>(k)];
    camera.name = k == 0 ? "left" : "right";
    camera.intrinsics = {160, 120, 150.0, 150.0, 79.5, 59.5};
    camera.cameraFromWorld =
        lookAt(k == 0 ? Eigen::Vector3d(0.0, -0.6, 0.1) : Eigen::Vector3d(-0.6, 0.0, 0.1), kBall);
  }
  return rig;
}

inline Project twoCameraProject() {
  Project project;
  project.name = "two cameras";
  project.method = "barrera"; // whose iterations are what these tests count
  project.parameters = ParameterValues(methodParameters(project.method));
  for (const auto& [key, value] : {std::pair("start_x", 0.02), std::pair("start_y", -0.02),
                                   std::pair("start_z", 0.1), std::pair("particles", 100.0)}) {
    (void)project.parameters.set(key, value);
  }
  project.targets = {{"ball", kBallRadius, ColorRange{320.0, 352.0, 0.25, 0.65, 0.15, 0.9}}};
  for (const auto& camera : twoCameras()) {
    project.cameras.push_back({camera, SourceKind::Simulation, "", 0});
  }
  return project;
}

inline cv::Mat discPicture(const Camera& camera) {
  const auto& intrinsics = camera.intrinsics;
  cv::Mat picture(intrinsics.height, intrinsics.width, CV_8UC3, cv::Scalar(60, 60, 60));
  const Eigen::Vector2d center = Projector(camera).project(kBall).value();
  const double distance = (camera.center() - kBall).norm();
  cv::circle(picture, {cvRound(center.x()), cvRound(center.y())},
             cvRound(intrinsics.focalX * kBallRadius / distance), kDiscColor, cv::FILLED);
  return picture;
}

/// A source in memory: a still disc in both cameras.
class FakeRecording : public FrameSetSource {
public:
  struct Options {
    std::optional<std::int64_t> frames = 12;           ///< nothing: live
    std::optional<std::int64_t> failsAt;               ///< next() of this frame is an error
    std::shared_ptr<std::atomic<bool>> delivering;     ///< live: empty sets while false
    std::shared_ptr<std::atomic<bool>> unplugged = {}; ///< a notice for each camera while true
  };
  explicit FakeRecording(Options options) : options_(std::move(options)) {
    for (const auto& camera : twoCameras()) {
      pictures_.push_back(discPicture(camera));
    }
  }
  std::optional<std::int64_t> frameCount() const override { return options_.frames; }
  double framesPerSecond() const override { return 1e6; } // as fast as possible
  std::vector<Error> notices() const override {
    const bool is = options_.unplugged && *options_.unplugged;
    return is ? std::vector<Error>{{ErrorCode::ConnectionLost, "/dev/left", "camera 'left'", ""},
                                   {ErrorCode::ConnectionLost, "/dev/right", "camera 'right'", ""}}
              : std::vector<Error>();
  }
  Result<FrameSetPtr> next() override {
    if (options_.failsAt == position_) {
      return failure(ErrorCode::EndedEarly, "left.mkv", "", "frame 5 of 12");
    }
    if (options_.frames == position_) {
      return FrameSetPtr();
    }
    auto set = std::make_shared<FrameSet>();
    set->frames.resize(pictures_.size());
    if (options_.delivering && !*options_.delivering) {
      std::this_thread::sleep_for(std::chrono::milliseconds(1));
      return set;
    }
    set->index = position_++;
    set->time = timeStamp(static_cast<double>(set->index) / 30.0);
    for (std::size_t k = 0; k < pictures_.size(); ++k) {
      set->frames[k] =
          std::make_shared<const Frame>(Frame{set->index, set->time, pictures_[k].clone()});
    }
    return set;
  }
  Status seek(std::int64_t frame) override {
    position_ = options_.frames ? frame : position_;
    return {};
  }

private:
  Options options_;
  std::int64_t position_ = 0;
  std::vector<cv::Mat> pictures_;
};

inline SessionInputs inputs(FakeRecording::Options options = {},
                            Project project = twoCameraProject()) {
  SessionInputs result;
  result.project = std::move(project);
  result.source = std::make_unique<FakeRecording>(std::move(options));
  return result;
}

/// Polls until `condition` holds; the bound only keeps a broken program from hanging for ever.
/// Sanitizers are slow.
inline bool eventually(const std::function<bool()>& condition) {
  const auto giveUp =
      std::chrono::steady_clock::now() + std::chrono::seconds(DEWPOINT_TEST_SECONDS / 3);
  while (!condition()) {
    if (std::chrono::steady_clock::now() > giveUp) {
      return false;
    }
    std::this_thread::sleep_for(std::chrono::milliseconds(1));
  }
  return true;
}

inline bool reaches(const Session& session, PlayState state) {
  return eventually([&] { return session.newest()->state == state; });
}

inline bool showsFrame(const Session& session) {
  return eventually([&] { return session.newest()->frame >= 0; });
}

inline bool sameBits(const Trajectory& a, const Trajectory& b) {
  bool same = a.samples.size() == b.samples.size();
  for (std::size_t k = 0; same && k < a.samples.size(); ++k) {
    const auto& x = a.samples[k];
    const auto& y = b.samples[k];
    same = x.frame == y.frame && x.target == y.target && x.time == y.time &&
           x.position == y.position && x.covariance == y.covariance &&
           x.effectiveSampleSize == y.effectiveSampleSize && x.cameraCount == y.cameraCount &&
           x.isValid == y.isValid;
  }
  return same;
}

} // namespace dewpoint::tests::test
