// SPDX-License-Identifier: GPL-3.0-or-later
// Live cameras of different delay and rate, tracked by the same session as the window's.
#include "app/wiring/open_project.h"
#include "core/base/statistics.h"
#include "core/capture/live_frame_source.h"
#include "core/session/session.h"
#include "core/simulation/scene/scene_renderer.h"

#include <gtest/gtest.h>

#include <chrono>
#include <cmath>
#include <limits>
#include <memory>
#include <thread>

namespace dewpoint::tests {
namespace {

using Clock = std::chrono::steady_clock;

constexpr double kSceneRate = 60.0; ///< pictures per second of the scene

/// Pictures of one camera of a scene, and when the scene began.
struct Film {
  std::vector<cv::Mat> pictures;
  Clock::time_point begin;
};

/// A camera that sends the scene as it happens, `delay` seconds late.
class DelayedStream final : public LiveStream {
public:
  DelayedStream(std::shared_ptr<const Film> film, double rate, double delay)
      : film_(std::move(film)), rate_(rate), delay_(delay) {}

  tl::expected<void, std::string> open() override { return {}; }
  bool grab() override {
    std::this_thread::sleep_until(arrivalOf(next_));
    // Like a device, it has only its newest picture for whoever comes late.
    while (Clock::now() >= arrivalOf(next_ + 1)) {
      ++next_;
    }
    picture_ = std::llround(static_cast<double>(next_++) / rate_ * kSceneRate);
    return picture_ < std::ssize(film_->pictures);
  }
  cv::Mat retrieve() override {
    return film_->pictures[static_cast<std::size_t>(picture_)].clone();
  }

private:
  Clock::time_point arrivalOf(std::int64_t index) const {
    const std::chrono::duration<double> since(static_cast<double>(index) / rate_ + delay_);
    return film_->begin + std::chrono::duration_cast<Clock::duration>(since);
  }

  std::shared_ptr<const Film> film_;
  double rate_;
  double delay_;
  std::int64_t next_ = 0;
  std::int64_t picture_ = 0;
};

struct StreamPlan {
  double rate = 30.0;
  double delay = 0.0;
  double declared = 0.0;
};

/// Millimeters from the truth, the median of all frames; a constant offset between the clocks of
/// scene and session is taken out.
double medianError(const std::vector<StreamPlan>& plans) {
  Scene scene = demoScene();
  scene.balls.front().motion = Motion::Smooth;
  scene.balls.front().stillSeconds = 0.0;
  scene.framesPerSecond = kSceneRate;
  const SceneRenderer renderer(scene);
  constexpr double kSeconds = 4.0;
  std::vector<std::shared_ptr<Film>> films;
  for (int camera = 0; camera < 2; ++camera) {
    auto film = std::make_shared<Film>();
    for (int k = 0; k < static_cast<int>(kSeconds * kSceneRate); ++k) {
      film->pictures.push_back(renderer.render(camera, k));
    }
    films.push_back(film);
  }
  Project project = makeSceneProject(scene, "");
  std::vector<LiveCamera> cameras;
  for (std::size_t k = 0; k < 2; ++k) {
    const Intrinsics& intrinsics = project.cameras[k].camera.intrinsics;
    cameras.push_back({project.cameras[k].camera.name, std::to_string(k), 0, intrinsics.width,
                       intrinsics.height, false, plans[k].declared});
    films[k]->begin = Clock::now() + std::chrono::milliseconds(50);
  }
  films[1]->begin = films[0]->begin;
  SessionInputs inputs;
  inputs.project = project;
  inputs.source = std::move(*openLive(cameras, [&](const LiveCamera& camera) -> LiveStreamPtr {
    const std::size_t k = std::stoul(camera.location);
    return std::make_unique<DelayedStream>(films[k], plans[k].rate, plans[k].delay);
  }));
  Session session(std::move(inputs));
  session.play();
  while (Clock::now() < films[0]->begin + std::chrono::milliseconds(3800)) {
    std::this_thread::sleep_for(std::chrono::milliseconds(20));
  }
  const Trajectory trajectory = session.trajectory();
  double best = std::numeric_limits<double>::infinity();
  for (double offset = -0.15; offset < 0.15; offset += 0.002) {
    std::vector<double> errors;
    for (const TrajectorySample& sample : trajectory.samples) {
      if (sample.isValid && sample.time > 0.5) {
        const Eigen::Vector3d truth = ballPosition(scene, 0, sample.time + offset);
        errors.push_back(1000.0 * (sample.position - truth).norm());
      }
    }
    EXPECT_GE(errors.size(), 20U);
    best = std::min(best, upperMedian(std::move(errors)));
  }
  return best;
}

// The ball moves at 0.2 m/s: 100 ms of it are 20 mm.
TEST(LiveDelay, ADeclaredDelayIsMadeUpFor) {
  EXPECT_LT(medianError({{}, {.delay = 0.1, .declared = 0.1}}), 3.0);
}

TEST(LiveDelay, RatesMayDiffer) {
  EXPECT_LT(medianError({{.rate = 60.0}, {.rate = 25.0, .delay = 0.05, .declared = 0.05}}), 3.0);
  EXPECT_LT(medianError({{}, {.rate = 10.0}}), 3.0);
}

} // namespace
} // namespace dewpoint::tests
