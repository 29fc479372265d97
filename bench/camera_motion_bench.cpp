// SPDX-License-Identifier: GPL-3.0-or-later
// The detector of camera motion on simulated scenes: how soon a rotated camera is reported, how
// often one that stands still, and what a check costs. Usage: camera_motion_bench [motions] [quiet
// minutes] [image width]
#include "core/base/angle.h"
#include "core/base/random.h"
#include "core/base/statistics.h"
#include "core/calibration/manual/moved_camera_pose.h"
#include "core/camera_motion/camera_motion_detector.h"
#include "core/simulation/scene/scene.h"
#include "core/simulation/scene/scene_catalog.h"
#include "core/simulation/scene/scene_renderer.h"

#include <fmt/format.h>
#include <opencv2/imgproc.hpp>

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <ctime>
#include <limits>

namespace dewpoint::bench {
namespace {

constexpr double kRate = 10.0; // images per second; the sentinel looks at five of them

const char* const kScenes[] = {"demo", "fast", "look-alikes", "occluder"};

/// The same camera with finer or coarser pixels.
void resize(Camera& camera, int width) {
  Intrinsics& in = camera.intrinsics;
  const double factor = double(width) / in.width;
  in = {width,
        int(std::lround(in.height * factor)),
        in.focalX * factor,
        in.focalY * factor,
        (in.centerX + 0.5) * factor - 0.5,
        (in.centerY + 0.5) * factor - 0.5};
}

/// The scene at kRate, for `seconds`; its first camera turned, with images of this width (0: as the
/// scene has them).
Scene sceneOf(int number, double seconds, const Eigen::Vector3d& turn, int width) {
  Scene scene = *loadScene(kScenes[number % 4]);
  scene.framesPerSecond = kRate;
  scene.frameCount = std::int64_t(seconds * kRate) + 1;
  scene.seed = std::uint64_t(number + 1);
  scene.cameras[0] = rotatedCamera(scene.cameras[0], turn);
  if (width > 0) {
    resize(scene.cameras[0], width);
  }
  return scene;
}

FrameSetPtr frameSet(cv::Mat image, std::int64_t index) {
  auto frame = std::make_shared<Frame>();
  frame->image = std::move(image);
  auto set = std::make_shared<FrameSet>();
  set->index = index;
  set->time = timeStamp(double(index) / kRate);
  set->frames = {std::move(frame)};
  return set;
}

struct Cost {
  double longest = 0.0; // milliseconds
  double sum = 0.0;
  std::int64_t frames = 0;
};

void watch(CameraMotionDetector& sentinel, const FrameSetPtr& frames, Cost& cost) {
  const std::clock_t begin = std::clock(); // of the processor, whatever else the machine does
  sentinel.watch(*frames);
  const double took = 1e3 * double(std::clock() - begin) / CLOCKS_PER_SEC;
  cost.longest = std::max(cost.longest, frames->index > 0 ? took : 0.0);
  cost.sum += took;
  ++cost.frames;
}

Eigen::Vector3d direction(const RandomStream& random, int motion) {
  const auto normal = random.normal4(std::uint32_t(motion));
  return Eigen::Vector3d(normal[0], normal[1], normal[2]).normalized();
}

/// Seconds until a turn of the first camera is reported; negative: before it, infinite: never.
double delayOf(int motion, double degrees, int width, Cost& cost, double& error) {
  const RandomStream random(11, 0, 0, RandomPurpose::Simulation);
  const Eigen::Vector3d turn = degrees * kDegree * direction(random, motion);
  const double at = 3.0 + 5.0 * random.uniform(std::uint32_t(motion), 9);
  const SceneRenderer before(sceneOf(motion, 20.0, Eigen::Vector3d::Zero(), width));
  const SceneRenderer after(sceneOf(motion, 20.0, turn, width));
  CameraMotionDetector sentinel({before.scene().cameras[0]});
  double delay = std::numeric_limits<double>::infinity();
  for (std::int64_t k = 0; k < std::int64_t((at + 4.0) * kRate); ++k) {
    const double time = double(k) / kRate;
    watch(sentinel, frameSet((time < at ? before : after).render(0, k), k), cost);
    if (!sentinel.events().empty() && !std::isfinite(delay)) {
      delay = time - at;
    }
  }
  error = (sentinel.camera(0).rotation.turn - turn).norm() / kDegree;
  return delay;
}

void measureMotions(int count, double degrees, int width) {
  Cost cost;
  std::vector<double> delays, errors;
  int early = 0, missed = 0, late = 0;
  for (int motion = 0; motion < count; ++motion) {
    double error = 0.0;
    const double delay = delayOf(motion, degrees, width, cost, error);
    early += delay < 0.0;
    missed += !std::isfinite(delay);
    late += std::isfinite(delay) && delay > 2.0;
    delays.push_back(delay);
    errors.push_back(error);
  }
  fmt::print(
      "{:.2f} degrees: {} motions, {} missed, {} later than 2 s, {} before; delay median {:.2f} "
      "s, longest {:.2f} s; turn known to {:.4f} degrees (median), {:.4f} (worst)\n",
      degrees, count, missed, late, early, upperMedian(delays), std::ranges::max(delays),
      upperMedian(errors), std::ranges::max(errors));
  fmt::print("cost: {:.3f} ms a frame at {} images/s, longest {:.2f} ms\n",
             cost.sum / double(cost.frames), kRate, cost.longest);
}

/// Light that wanders between half and full, and a shadow that comes and goes over a part.
void relight(cv::Mat& image, double time) {
  image.convertTo(image, -1, 0.75 + 0.25 * std::sin(time / 17.0), 0.0);
  const int left = int(0.5 * image.cols * (1.0 + std::sin(time / 41.0)));
  cv::Mat part = image(cv::Rect(left, 0, std::min(image.cols / 4, image.cols - left), image.rows));
  if (!part.empty() && std::fmod(time, 60.0) < 30.0) {
    part.convertTo(part, -1, 0.6, 0.0);
  }
}

void measureQuiet(double minutes, int width) {
  Cost cost;
  std::size_t alarms = 0;
  double worst = 0.0;
  int unassessed = 0;
  for (int number = 0; number < 4; ++number) {
    const double seconds = 60.0 * minutes / 4.0;
    const SceneRenderer renderer(sceneOf(number, seconds, Eigen::Vector3d::Zero(), width));
    CameraMotionDetector sentinel({renderer.scene().cameras[0]});
    for (std::int64_t k = 0; k < std::int64_t(seconds * kRate); k += 2) { // what it looks at
      cv::Mat image = renderer.render(0, k);
      relight(image, double(k) / kRate);
      watch(sentinel, frameSet(std::move(image), k), cost);
      worst = std::max(worst, sentinel.camera(0).rotation.turn.norm() / kDegree);
      unassessed += k > 0 && !sentinel.camera(0).isAssessed;
    }
    alarms += sentinel.events().size();
  }
  fmt::print("{:.0f} minutes of standing still, with wandering light: {} alarms, largest turn "
             "{:.4f} degrees, {} of {} images not judged\n",
             minutes, alarms, worst, unassessed, cost.frames);
  fmt::print("cost: {:.3f} ms a check, longest {:.2f} ms\n", cost.sum / double(cost.frames),
             cost.longest);
}

} // namespace
} // namespace dewpoint::bench

int main(int argc, char** argv) {
  const int motions = argc > 1 ? std::atoi(argv[1]) : 20;
  const double minutes = argc > 2 ? std::atof(argv[2]) : 4.0;
  const int width = argc > 3 ? std::atoi(argv[3]) : 0;
  for (const double degrees : {0.1, 0.5, 3.0}) {
    dewpoint::bench::measureMotions(motions, degrees, width);
  }
  dewpoint::bench::measureQuiet(minutes, width);
  return 0;
}
