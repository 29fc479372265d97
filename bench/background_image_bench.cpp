// SPDX-License-Identifier: GPL-3.0-or-later
// What one background image is worth on the recording throws_pinkball: F1 score of the
// pixels that count as target, and the share of the background among them, without and with it.
//   background_image_bench [DATA_FOLDER]        (default: $DEWPOINT_DATA)
#include "bench/pixel_truth.h"
#include "core/base/statistics.h"
#include "core/capture/background_image.h"
#include "core/color/color_learning.h"
#include "core/color/hsi.h"
#include "core/color/match_image.h"
#include "core/observation/background/label_image.h"

#include <fmt/format.h>
#include <opencv2/imgcodecs.hpp>
#include <opencv2/imgproc.hpp>

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <fstream>
#include <map>
#include <sstream>
#include <string>
#include <vector>

namespace dewpoint::bench {
namespace {

constexpr int kEmptyFrame = 10;
constexpr std::size_t kLessons = 5;
constexpr double kRim = 2.0; ///< pixels: the boxes were made by color and are about so exact

using Boxes = std::map<int, cv::Rect>; ///< of a ball, by frame

/// Boxes of the balls that are whole in the image: ball, frame, cx, cy, x, y, w, h, area, border.
std::map<std::string, Boxes> readBoxes(const std::string& file) {
  std::ifstream stream(file);
  std::map<std::string, Boxes> balls;
  for (std::string line; std::getline(stream, line);) {
    std::ranges::replace(line, ',', ' ');
    std::istringstream words(line);
    std::string ball;
    int frame = 0;
    double middle[2];
    cv::Rect box;
    int area = 0;
    int border = 1;
    words >> ball >> frame >> middle[0] >> middle[1] >> box.x >> box.y >> box.width >> box.height >>
        area >> border;
    if (words && border == 0) {
      balls[ball][frame] = box;
    }
  }
  return balls;
}

cv::Mat drawn(cv::Size size, const cv::Rect& box, double more) {
  cv::Mat mask = cv::Mat::zeros(size, CV_8UC1);
  const cv::RotatedRect ellipse(
      cv::Point2f(box.x + 0.5F * (box.width - 1), box.y + 0.5F * (box.height - 1)),
      cv::Size2f(box.width + 2 * more, box.height + 2 * more), 0.0F);
  cv::ellipse(mask, ellipse, cv::Scalar(255), cv::FILLED);
  return mask;
}

double mean(const std::vector<double>& values) {
  double sum = 0.0;
  for (const double value : values) {
    sum += value;
  }
  return values.empty() ? 0.0 : sum / static_cast<double>(values.size());
}

/// What a person sets by hand: the hue around what is seen, anything that is not gray or black.
ColorRange byHand(const ColorSample& sample) {
  constexpr double kAside = 20.0; // degrees
  std::vector<double> hues;
  for (const BgrColor& color : sample.colors) {
    const double hue = hsiFromBgr(color[0], color[1], color[2]).hueDegrees;
    if (!std::isnan(hue)) {
      hues.push_back(hue);
    }
  }
  const double hue = upperMedian(hues);
  return {
      std::fmod(hue - kAside + 360.0, 360.0), std::fmod(hue + kAside, 360.0), 0.2, 1.0, 0.1, 1.0};
}

/// The middle of the ball, as a person drags a box on it.
ColorSample boxOn(const cv::Mat& image, const cv::Rect& ball) {
  ColorSample place;
  place.x = ball.x + ball.width / 4;
  place.y = ball.y + ball.height / 4;
  place.width = std::max(2, ball.width / 2);
  place.height = std::max(2, ball.height / 2);
  return takeSample(image, place).value_or(ColorSample{});
}

struct Figures {
  std::vector<double> f1, background;
  void add(const cv::Mat& match, const cv::Mat& truth, const cv::Mat& rim) {
    f1.push_back(pixelScore(match & ~rim, truth & ~rim).f1());
    const cv::Mat rest = ~truth & ~rim;
    background.push_back(double(cv::countNonZero(match & rest)) / cv::countNonZero(rest));
  }
};

void benchRange(const ColorRange& range, const std::map<int, cv::Mat>& images, const Boxes& boxes,
                const cv::Mat& room, Figures& without, Figures& with) {
  BackgroundModel background;
  background.setBackgroundImage(room);
  background.reset();
  const ColorClassifier classifier(range);
  LabelImage labels;
  for (const auto& [frame, box] : boxes) {
    const cv::Mat& image = images.at(frame);
    background.adaptToLight(image);
    labels.setImage(image, background, classifier);
    labels.ensureAllLabels();
    const cv::Mat truth = drawn(image.size(), box, 0.0);
    const cv::Mat rim = drawn(image.size(), box, kRim) & ~drawn(image.size(), box, -kRim);
    without.add(matchImage(image, classifier), truth, rim);
    with.add(labels.labels() == static_cast<int>(PixelLabel::Target), truth, rim);
    background.learn(image, {{{box.x + 0.5 * box.width, box.y + 0.5 * box.height},
                              0.7 * std::max(box.width, box.height) + 2.0}});
  }
}

void benchBall(const std::string& name, const std::map<int, cv::Mat>& images, const Boxes& boxes,
               const cv::Mat& room) {
  std::vector<int> frames;
  for (const auto& [frame, box] : boxes) {
    frames.push_back(frame);
  }
  struct Way {
    const char* name;
    Figures without, with;
  };
  Way box{"a box", {}, {}};
  Way hand{"by hand", {}, {}};
  for (std::size_t k = 0; k < kLessons; ++k) {
    const int taught = frames[(2 * k + 1) * frames.size() / (2 * kLessons)];
    const ColorSample sample = boxOn(images.at(taught), boxes.at(taught));
    const auto learned = learnColor({sample}, {images.at(taught)});
    if (learned) {
      benchRange(learned->range, images, boxes, room, box.without, box.with);
    }
    benchRange(byHand(sample), images, boxes, room, hand.without, hand.with);
  }
  for (const Way& way : {box, hand}) {
    fmt::print(
        "{:8} {:8} F1 {:.3f} -> {:.3f}   background that counts as target {:.3f} % -> {:.3f} %\n",
        name, way.name, mean(way.without.f1), mean(way.with.f1),
        100.0 * mean(way.without.background), 100.0 * mean(way.with.background));
  }
  std::fflush(stdout);
}

} // namespace
} // namespace dewpoint::bench

int main(int argc, char** argv) {
  using namespace dewpoint::bench;
  const char* variable = std::getenv("DEWPOINT_DATA");
  const std::string data = argc > 1 ? argv[1] : variable ? variable : "../shared/data";
  const std::string folder = data + "/throws_pinkball/";
  const auto picture = [&](int frame) { return folder + fmt::format("frame{:05}.jpg", frame); };
  const auto room = readBackgroundImage(picture(kEmptyFrame), {"throws", 0, 0, 0});
  if (!room) {
    fmt::print(stderr, "{}\n", errorSentence(room.error()));
    return 1;
  }
  for (const auto& [name, boxes] : readBoxes(folder + "balls_by_color.csv")) {
    std::map<int, cv::Mat> images;
    Boxes there;
    for (const auto& [frame, box] : boxes) {
      const cv::Mat image = cv::imread(picture(frame));
      if (!image.empty()) {
        images[frame] = image;
        there[frame] = box;
      }
    }
    if (there.size() > kLessons) {
      benchBall(name, images, there, *room);
    }
  }
  return 0;
}
