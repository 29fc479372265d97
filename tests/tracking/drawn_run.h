// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/thread_team.h"
#include "core/tracking/catalog/method_catalog.h"
#include "core/tracking/dewpoint/dewpoint_tracker.h"
#include "core/tracking/tracker_capabilities.h"
#include "tests/observation/drawn_spheres.h"
#include "tests/tracking/sphere_of.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <initializer_list>
#include <memory>
#include <utility>
#include <vector>

namespace dewpoint::tests::drawn {

/// QVGA a meter away: a pixel is 3.3 mm wide; an estimate is a fraction of it off.
inline constexpr double kClose = 3e-3;

using Changes = std::initializer_list<std::pair<const char*, double>>;

inline ParameterValues parametersOf(const char* method, Changes changes = {}) {
  ParameterValues values(methodParameters(method));
  for (const auto& [key, value] : changes) {
    EXPECT_TRUE(values.set(key, value)) << key;
  }
  return values;
}

inline Target redBall(double radius = kRadius) {
  return {"ball", radius, kRed};
}

/// What all cameras see of the balls at frame `index` of 30 per second; null for a blind camera.
inline std::shared_ptr<FrameSet> framesOf(const CameraRig& rig, const std::vector<Ball>& balls,
                                          std::int64_t index,
                                          const std::vector<std::size_t>& blind = {},
                                          double noise = 3.0) {
  auto set = std::make_shared<FrameSet>();
  set->index = index;
  set->time = timeStamp(static_cast<double>(index) / 30.0);
  for (std::size_t k = 0; k < rig.size(); ++k) {
    if (std::find(blind.begin(), blind.end(), k) != blind.end()) {
      set->frames.push_back(nullptr);
      continue;
    }
    auto frame = std::make_shared<Frame>();
    frame->index = index;
    frame->captureTime = set->time;
    frame->image = draw(rig[k], balls);
    if (noise > 0.0) {
      addNoise(frame->image, noise, static_cast<std::uint32_t>(index), 99 + k);
    }
    set->frames.push_back(std::move(frame));
  }
  return set;
}

/// Method `dewpoint` at work on drawn frames.
class DrawnRun {
public:
  DrawnRun(CameraRig rig, const std::vector<Target>& targets, Changes changes = {},
           std::uint64_t seed = 1, int threads = 1)
      : rig_(std::move(rig)), team_(threads) {
    tracker_ = std::make_unique<DewpointTracker>(parametersOf("dewpoint", changes), rig_, targets);
    tracker_->restart(seed);
  }

  /// The next frame, with as many iterations as the parameters say.
  SphereEstimate show(const std::vector<Ball>& balls, const std::vector<std::size_t>& blind = {}) {
    return showSet(framesOf(rig_, balls, index_, blind));
  }
  SphereEstimate showSet(FrameSetPtr frames) {
    index_ = frames ? frames->index + 1 : index_;
    tracker_->beginFrame(std::move(frames));
    for (int k = 0; k < tracker_->iterationsPerFrame(); ++k) {
      tracker_->iterate(team_);
    }
    return estimate();
  }
  /// One more iteration on the same frame.
  SphereEstimate again() {
    tracker_->iterate(team_);
    return estimate();
  }

  SphereEstimate estimate(std::size_t target = 0) const { return sphereOf(*tracker_, target); }
  std::vector<ClockEstimate> estimateClocks() const { return tracker_->clockEstimates(); }
  DewpointTracker& tracker() { return *tracker_; }
  const CameraRig& rig() const { return rig_; }
  std::int64_t index() const { return index_; }

private:
  CameraRig rig_;
  ThreadTeam team_;
  std::unique_ptr<DewpointTracker> tracker_;
  std::int64_t index_ = 0;
};

} // namespace dewpoint::tests::drawn
