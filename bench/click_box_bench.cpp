// SPDX-License-Identifier: GPL-3.0-or-later
//
// What a click gives where the true box is known: in ten images of each clip, on a grid of points
// in the inner half of what fills the true box, the share of clicks whose box has at least half of
// its area in common with it (PASCAL VOC).
//
//   click_box_bench [FOLDER [STEP]]    FOLDER: with juggle1, throws_pinkball and otb; STEP: px
#include "core/experiment/box_clips.h"
#include "core/tracking/box_tracker.h"

#include <fmt/format.h>

#include <chrono>
#include <cmath>
#include <cstdlib>

namespace dewpoint {
namespace {

constexpr int kImages = 10;
constexpr double kInner = 0.25; ///< of width and height: half of the way from the middle
constexpr double kFound = 0.5;  ///< overlap

struct Outcome {
  int clicks = 0;
  int found = 0;
  double overlap = 0.0;
  double milliseconds = 0.0;
};

void clickIn(const cv::Mat& image, const ImageBox& truth, double step, Outcome& outcome) {
  const double right = kInner * truth.width;
  const double down = kInner * truth.height;
  for (double v = -down; v <= down; v += step) {
    for (double u = -right; u <= right; u += step) {
      if (std::hypot(u / right, v / down) > 1.0) {
        continue;
      }
      const Eigen::Vector2d at = truth.center() + Eigen::Vector2d(u, v);
      const auto before = std::chrono::steady_clock::now();
      const auto box = boxFromClick(image, std::floor(at.x()), std::floor(at.y()));
      outcome.milliseconds +=
          std::chrono::duration<double, std::milli>(std::chrono::steady_clock::now() - before)
              .count();
      const double common = box ? overlap(*box, truth) : 0.0;
      outcome.overlap += common;
      outcome.found += common >= kFound ? 1 : 0;
      ++outcome.clicks;
    }
  }
}

Status measure(const BoxClip& clip, double step) {
  Outcome outcome;
  for (int i = 0; i < kImages; ++i) {
    const auto frame = (i + 0.5) * double(clip.truth.size()) / kImages;
    const ImageBox& truth = clip.truth[static_cast<std::size_t>(frame)];
    const auto image = clip.image(static_cast<std::int64_t>(frame));
    if (!image) {
      return tl::make_unexpected(image.error());
    }
    const ImageBox whole{1.0, 1.0, image->cols - 2.0, image->rows - 2.0};
    if (!truth.isEmpty() && commonArea(truth, whole) == truth.area()) {
      clickIn(*image, truth, step, outcome);
    }
  }
  const double clicks = std::max(1, outcome.clicks);
  fmt::print("{:<30} {:>6} clicks {:>6.1f} % found, mean overlap {:.2f}, {:>5.1f} ms\n", clip.name,
             outcome.clicks, 100.0 * outcome.found / clicks, outcome.overlap / clicks,
             outcome.milliseconds / clicks);
  return {};
}

int run(int count, char** arguments) {
  std::vector<BoxClip> clips;
  if (count > 1) {
    auto recorded = recordedBoxClips(arguments[1]);
    if (!recorded) {
      fmt::print(stderr, "{}\n", sentence(recorded.error()));
      return EXIT_FAILURE;
    }
    clips = std::move(*recorded);
  }
  clips.push_back(simulatedBoxClip(5001));
  for (const int camera : {0, 1}) {
    clips.push_back(clipOfScene(demoScene(), camera));
  }
  const double step = count > 2 ? std::max(1.0, std::atof(arguments[2])) : 2.0;
  for (const BoxClip& clip : clips) {
    if (const auto measured = measure(clip, step); !measured) {
      fmt::print(stderr, "{}\n", sentence(measured.error()));
      return EXIT_FAILURE;
    }
  }
  return EXIT_SUCCESS;
}

} // namespace
} // namespace dewpoint

int main(int count, char** arguments) {
  return dewpoint::run(count, arguments);
}
