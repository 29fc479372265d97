// SPDX-License-Identifier: GPL-3.0-or-later
// Does the color range follow slow changes of light? The pixel F1 score, with exact truth, of the
// range in use over simulated ramps of the light, with parameter `color_adaptation` and without.
//   adaptation_bench [SEEDS [TIME_CONSTANT [COLOR]]]        (default: 2 seeds, 2 s)
#include "bench/pixel_truth.h"
#include "core/color/color_learning.h"
#include "core/color/hsi.h"
#include "core/color/match_image.h"
#include "core/geometry/projector.h"
#include "core/simulation/scene/scene_file.h"
#include "core/simulation/scene/scene_renderer.h"
#include "core/tracking/catalog/method_catalog.h"
#include "core/tracking/tracker.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdlib>
#include <memory>
#include <string>
#include <utility>
#include <vector>

namespace dewpoint::bench {
namespace {

constexpr double kSteady = 4.0; ///< seconds before the light begins to change
constexpr double kRamp = 36.0;  ///< seconds
constexpr double kRate = 15.0;  ///< frames per second
constexpr std::int64_t kEvery = 5;

struct Ramp {
  std::string name;
  SceneLight from, to;
};
const std::vector<Ramp>& ramps() {
  static const std::vector<Ramp> all{
      {"steady", {0.0, 1.0, 5500.0}, {0.0, 1.0, 5500.0}},
      {"brightness x 4", {0.0, 0.35, 5500.0}, {0.0, 1.4, 5500.0}},
      {"brightness / 4", {0.0, 1.4, 5500.0}, {0.0, 0.35, 5500.0}},
      {"5500 to 4500 K", {0.0, 1.0, 5500.0}, {0.0, 1.0, 4500.0}},
      {"5500 to 6500 K", {0.0, 1.0, 5500.0}, {0.0, 1.0, 6500.0}},
  };
  return all;
}

struct BallColor {
  std::string name;
  Eigen::Vector3d bgr;
};
const std::vector<BallColor>& ballColors() {
  static const std::vector<BallColor> all{
      {"pink", {145.0, 85.0, 245.0}},   {"red", {50.0, 50.0, 220.0}},
      {"orange", {40.0, 130.0, 245.0}}, {"yellow", {50.0, 220.0, 235.0}},
      {"green", {80.0, 190.0, 60.0}},   {"blue", {210.0, 100.0, 50.0}},
  };
  return all;
}

Scene sceneOf(const BallColor& color, const Ramp& ramp, std::uint64_t seed) {
  const auto parsed = parseScene(
      fmt::format("seed = {}\nframes_per_second = {}\nframe_count = {}\n"
                  "[[ball]]\ncolor = [{}, {}, {}]\nperiod = 12.0\n"
                  "[[light]]\ntime = {}\nbrightness = {}\nkelvin = {}\n"
                  "[[light]]\ntime = {}\nbrightness = {}\nkelvin = {}\n",
                  seed, kRate, std::lround(kRate * (kSteady + kRamp)), color.bgr[2], color.bgr[1],
                  color.bgr[0], kSteady, ramp.from.brightness, ramp.from.colorTemperature,
                  kSteady + kRamp, ramp.to.brightness, ramp.to.colorTemperature),
      "adaptation_bench");
  return parsed.value();
}

/// What holds the ball's pixels in all images of a frame, but for the odd ones, with a margin.
ColorRange around(const Scene& scene, const FrameSet& frames) {
  std::array<std::vector<double>, 3> values;
  const Hsi own = hsiFromBgr(cv::saturate_cast<std::uint8_t>(scene.balls[0].color[0]),
                             cv::saturate_cast<std::uint8_t>(scene.balls[0].color[1]),
                             cv::saturate_cast<std::uint8_t>(scene.balls[0].color[2]));
  for (std::size_t k = 0; k < scene.cameras.size(); ++k) {
    const cv::Mat& image = frames.frames[k]->image;
    const cv::Mat mask = ballMask(scene.cameras[k], ballPosition(scene, 0, seconds(frames.time)),
                                  scene.balls[0].radius);
    for (int row = 0; row < image.rows; ++row) {
      for (int column = 0; column < image.cols; ++column) {
        const auto& pixel = image.at<cv::Vec3b>(row, column);
        const Hsi color = hsiFromBgr(pixel[0], pixel[1], pixel[2]);
        if (mask.at<std::uint8_t>(row, column) != 0 && !std::isnan(color.hueDegrees)) {
          values[0].push_back(std::remainder(color.hueDegrees - own.hueDegrees, 360.0));
          values[1].push_back(color.saturation);
          values[2].push_back(color.intensity);
        }
      }
    }
  }
  const auto at = [&](std::size_t k, double share) {
    std::ranges::sort(values[k]);
    return values[k][static_cast<std::size_t>(share * double(values[k].size() - 1))];
  };
  const auto rotated = [&](double hue) { return std::fmod(hue + own.hueDegrees + 720.0, 360.0); };
  constexpr double kOdd = 0.01;
  constexpr double kHue = 4.0; // degrees
  constexpr double kSaturation = 0.04;
  constexpr double kIntensity = 1.2; // factor
  return {rotated(at(0, kOdd) - kHue),
          rotated(at(0, 1.0 - kOdd) + kHue),
          std::max(0.0, at(1, kOdd) - kSaturation),
          std::min(1.0, at(1, 1.0 - kOdd) + kSaturation),
          at(2, kOdd) / kIntensity,
          std::min(1.0, at(2, 1.0 - kOdd) * kIntensity)};
}

FrameSetPtr framesOf(const SceneRenderer& renderer, std::int64_t index) {
  auto set = std::make_shared<FrameSet>();
  set->index = index;
  set->time = timeStamp(frameTime(renderer.scene(), index));
  for (std::size_t k = 0; k < renderer.scene().cameras.size(); ++k) {
    auto frame = std::make_shared<Frame>();
    frame->image = renderer.render(static_cast<int>(k), index);
    frame->index = index;
    frame->captureTime = set->time;
    set->frames.push_back(std::move(frame));
  }
  return set;
}

/// What one click on the ball in the first camera's first image gives.
ColorRange clicked(const Scene& scene, const FrameSet& frames) {
  const auto at = Projector(scene.cameras[0]).project(ballPosition(scene, 0, 0.0));
  ColorSample place;
  place.x = std::round(at->x());
  place.y = std::round(at->y());
  std::vector<cv::Mat> images;
  for (const FramePtr& frame : frames.frames) {
    images.push_back(frame->image);
  }
  const auto learned = takeSample(images[0], place).and_then([&](const ColorSample& sample) {
    return learnColor({sample}, images);
  });
  return learned ? learned->range : around(scene, frames);
}

/// One method on one range, with its scores over a run.
struct Follower {
  std::unique_ptr<Tracker> tracker;
  ColorRange range;
  PixelScore all;
  PixelScore end; ///< the last tenth of the ramp
  int looks = 0;
  int held = 0;

  Follower(const Scene& scene, const ColorRange& learned, double timeConstant) : range(learned) {
    ParameterValues values(methodParameters("dewpoint"));
    (void)values.set("color_adaptation", timeConstant);
    const Target target{"ball", scene.balls.front().radius, range};
    tracker = makeTracker("dewpoint", values, scene.cameras, {target}).value();
    tracker->restart(scene.seed);
  }

  void sightOf(const Scene& scene, const FrameSetPtr& frames, const std::vector<cv::Mat>& truth,
               ThreadTeam& team) {
    tracker->beginFrame(frames);
    tracker->iterate(team);
    const auto estimate = std::get<SphereEstimate>(tracker->estimate(0));
    const double time = frameTime(scene, frames->index);
    const Eigen::Vector3d off = estimate.mean - ballPosition(scene, 0, time);
    ++looks;
    held += estimate.isValid && off.norm() < scene.balls.front().radius ? 1 : 0;
    for (std::size_t k = 0; k < truth.size(); ++k) {
      const ColorRange& used = estimate.colors.empty() ? range : estimate.colors[k][0];
      const PixelScore score =
          pixelScore(matchImage(frames->frames[k]->image, ColorClassifier(used)), truth[k]);
      all.add(score);
      if (time > kSteady + 0.9 * kRamp) {
        end.add(score);
      }
    }
  }
};

void benchRun(const BallColor& color, const Ramp& ramp, std::uint64_t seed, double timeConstant) {
  const SceneRenderer renderer(sceneOf(color, ramp, seed));
  const Scene& scene = renderer.scene();
  ThreadTeam team;
  std::vector<Follower> followers;
  for (std::int64_t index = 0; index < scene.frameCount; ++index) {
    const FrameSetPtr frames = framesOf(renderer, index);
    if (index == 0) {
      const ColorRange learned = clicked(scene, *frames);
      for (const ColorRange& range : {learned, around(scene, *frames)}) {
        followers.emplace_back(scene, range, 0.0);
        followers.emplace_back(scene, range, timeConstant);
      }
    }
    std::vector<cv::Mat> truth;
    for (std::size_t k = 0; index % kEvery == 0 && k < scene.cameras.size(); ++k) {
      truth.push_back(ballMask(scene.cameras[k], ballPosition(scene, 0, frameTime(scene, index)),
                               scene.balls.front().radius));
    }
    for (Follower& follower : followers) {
      follower.sightOf(scene, frames, truth, team);
    }
  }
  fmt::print("{:8} {:16} {:4}", color.name, ramp.name, seed);
  for (const Follower& follower : followers) {
    fmt::print("   {:.3f} {:.3f} {:3.0f}%", follower.all.f1(), follower.end.f1(),
               100.0 * follower.held / follower.looks);
  }
  fmt::print("\n");
  std::fflush(stdout);
}

} // namespace
} // namespace dewpoint::bench

int main(int argc, char** argv) {
  using namespace dewpoint::bench;
  const int seeds = argc > 1 ? std::atoi(argv[1]) : 2;
  const double timeConstant = argc > 2 ? std::atof(argv[2]) : 2.0;
  fmt::print(
      "Pixel F1 over the ramp, over its end, and share of frames held; color_adaptation = {} "
      "s\n{:30}   {:36}   {:36}\n{:30}   {:16}   {:16}   {:16}   {:16}\n",
      timeConstant, "", "one click in the first frame", "the ball's pixels of that frame", "",
      "off", "on", "off", "on");
  for (const BallColor& color : ballColors()) {
    for (const Ramp& ramp : ramps()) {
      const bool wanted = argc <= 3 || color.name == argv[3];
      for (int seed = 1; wanted && seed <= seeds; ++seed) {
        benchRun(color, ramp, static_cast<std::uint64_t>(seed), timeConstant);
      }
    }
  }
}
