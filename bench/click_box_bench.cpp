// SPDX-License-Identifier: GPL-3.0-or-later
//
// What a click gives where the true box is known: in ten images of each clip, on a grid of points
// in the inner half of what fills the true box, the share of clicks whose box has at least half of
// its area in common with it (PASCAL VOC). And what is followed from there: `histogram` starts from
// nine clicks in each of three images and goes through the next 45; the share of images where the
// center of its box is on the target.
//
//   click_box_bench [FOLDER [STEP [region]]]    FOLDER: with juggle1, throws_pinkball and otb;
//   STEP: px; region: the box of the color region at the click instead, for comparison
#include "core/color/color_region.h"
#include "core/experiment/boxes/box_clips.h"
#include "core/experiment/boxes/box_follower.h"
#include "core/tracking/boxes/box_filter.h"

#include <fmt/format.h>
#include <opencv2/imgproc.hpp>

#include <chrono>
#include <cmath>
#include <cstdlib>
#include <string_view>

namespace dewpoint::bench {
namespace {

constexpr int kImages = 10;
constexpr double kInner = 0.25; ///< of width and height: half of the way from the middle
constexpr double kFound = 0.5;  ///< overlap

constexpr int kStarts = 3;
constexpr std::size_t kFollowed = 45; ///< images
constexpr double kNine = 0.18;        ///< from the middle to the next of the nine, in sides
constexpr int kParticles = 300;

using Click = Result<ImageBox> (*)(const cv::Mat& bgr, double x, double y);

Result<ImageBox> regionFromClick(const cv::Mat& bgr, double x, double y) {
  const cv::Rect box =
      cv::boundingRect(growRegion(bgr, cv::Point(static_cast<int>(x), static_cast<int>(y))));
  return ImageBox{double(box.x), double(box.y), double(box.width), double(box.height)};
}

struct Outcome {
  int clicks = 0;
  int found = 0;
  double overlap = 0.0;
  double milliseconds = 0.0;
};

bool isWhole(const ImageBox& truth, const cv::Mat& image) {
  const ImageBox inner{1.0, 1.0, image.cols - 2.0, image.rows - 2.0};
  return !truth.isEmpty() && intersectionArea(truth, inner) == truth.area();
}

void clickIn(const cv::Mat& image, const ImageBox& truth, double step, Click click,
             Outcome& outcome) {
  const double right = kInner * truth.width;
  const double down = kInner * truth.height;
  for (double v = -down; v <= down; v += step) {
    for (double u = -right; u <= right; u += step) {
      if (std::hypot(u / right, v / down) > 1.0) {
        continue;
      }
      const Eigen::Vector2d at = truth.center() + Eigen::Vector2d(u, v);
      const auto before = std::chrono::steady_clock::now();
      const auto box = click(image, std::floor(at.x()), std::floor(at.y()));
      outcome.milliseconds +=
          std::chrono::duration<double, std::milli>(std::chrono::steady_clock::now() - before)
              .count();
      const double common = box ? intersectionOverUnion(*box, truth) : 0.0;
      outcome.overlap += common;
      outcome.found += common >= kFound ? 1 : 0;
      ++outcome.clicks;
    }
  }
}

/// Of the images after `start` in which the target is, and of those where it is followed.
struct Followed {
  int images = 0;
  int hits = 0;
};

void followFrom(const BoxClip& clip, const std::vector<cv::Mat>& images, std::size_t start,
                const Result<ImageBox>& box, Followed& followed) {
  auto follower = makeDewpointFollower("histogram", kParticles, 1);
  const bool started = box && follower && (*follower)->start(images[start], *box);
  const std::size_t end = std::min(images.size(), start + kFollowed + 1);
  for (std::size_t frame = start + 1; frame < end; ++frame) {
    const auto found = started ? (*follower)->step(images[frame]) : std::nullopt;
    const ImageBox& truth = clip.truth[frame];
    if (!truth.isEmpty()) {
      ++followed.images;
      followed.hits +=
          found && (found->center() - truth.center()).norm() <= clip.hitRadiusPx ? 1 : 0;
    }
  }
}

void followFromNine(const BoxClip& clip, const std::vector<cv::Mat>& images, std::size_t start,
                    Click click, Followed& followed) {
  const ImageBox& truth = clip.truth[start];
  for (int i = -1; i <= 1; ++i) {
    for (int j = -1; j <= 1; ++j) {
      const Eigen::Vector2d at =
          truth.center() + kNine * Eigen::Vector2d(i * truth.width, j * truth.height);
      const auto box = click(images[start], std::floor(at.x()), std::floor(at.y()));
      followFrom(clip, images, start, box, followed);
    }
  }
}

/// From the first whole target of each part of the clip.
Result<std::vector<Followed>> follow(const BoxClip& clip, Click click) {
  const auto images = imagesOf(clip);
  if (!images) {
    return tl::make_unexpected(images.error());
  }
  std::vector<Followed> parts;
  for (std::size_t part = 0; part < kStarts; ++part) {
    const std::size_t end = (part + 1) * images->size() / kStarts;
    for (std::size_t frame = part * images->size() / kStarts; frame + 1 < end; ++frame) {
      if (isWhole(clip.truth[frame], (*images)[frame])) {
        followFromNine(clip, *images, frame, click, parts.emplace_back());
        break;
      }
    }
  }
  return parts;
}

Status measure(const BoxClip& clip, double step, Click click) {
  Outcome outcome;
  for (int i = 0; i < kImages; ++i) {
    const auto frame = (i + 0.5) * double(clip.truth.size()) / kImages;
    const ImageBox& truth = clip.truth[static_cast<std::size_t>(frame)];
    const auto image = clip.image(static_cast<std::int64_t>(frame));
    if (!image) {
      return tl::make_unexpected(image.error());
    }
    if (isWhole(truth, *image)) {
      clickIn(*image, truth, step, click, outcome);
    }
  }
  const auto parts = follow(clip, click);
  if (!parts) {
    return tl::make_unexpected(parts.error());
  }
  const double clicks = std::max(1, outcome.clicks);
  fmt::print("{:<30} {:>6} clicks {:>6.1f} % found, mean overlap {:.2f}, {:>5.1f} ms; followed",
             clip.name, outcome.clicks, 100.0 * outcome.found / clicks, outcome.overlap / clicks,
             outcome.milliseconds / clicks);
  for (const Followed& part : *parts) {
    fmt::print(" {:>5.1f}", 100.0 * part.hits / std::max(1, part.images));
  }
  fmt::print(" %\n");
  return {};
}

int run(int count, char** arguments) {
  std::vector<BoxClip> clips;
  if (count > 1) {
    auto recorded = recordedBoxClips(arguments[1]);
    if (!recorded) {
      fmt::print(stderr, "{}\n", errorSentence(recorded.error()));
      return EXIT_FAILURE;
    }
    clips = std::move(*recorded);
  }
  clips.push_back(simulatedBoxClip(5001));
  for (const int camera : {0, 1}) {
    clips.push_back(clipOfScene(demoScene(), camera));
  }
  const double step = count > 2 ? std::max(1.0, std::atof(arguments[2])) : 2.0;
  const bool region = count > 3 && arguments[3] == std::string_view("region");
  for (const BoxClip& clip : clips) {
    if (const auto measured = measure(clip, step, region ? regionFromClick : boxFromClick);
        !measured) {
      fmt::print(stderr, "{}\n", errorSentence(measured.error()));
      return EXIT_FAILURE;
    }
  }
  return EXIT_SUCCESS;
}

} // namespace
} // namespace dewpoint::bench

int main(int count, char** arguments) {
  return dewpoint::bench::run(count, arguments);
}
