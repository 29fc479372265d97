// SPDX-License-Identifier: GPL-3.0-or-later
// How well one click teaches a color: the pixel F1 score of the learned range over the other frames
// of recordings with known targets, and over simulated views with exact truth.
//   click_color_bench [DATA_FOLDER]        (default: $DEWPOINT_DATA)
#include "bench/pixel_truth.h"
#include "core/color/color_learning.h"
#include "core/color/match_image.h"
#include "core/geometry/camera.h"
#include "core/geometry/projector.h"
#include "core/simulation/scene/scene_renderer.h"

#include <Eigen/Geometry>
#include <fmt/format.h>
#include <opencv2/imgcodecs.hpp>
#include <opencv2/imgproc.hpp>

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <fstream>
#include <iterator>
#include <map>
#include <sstream>

namespace dewpoint::bench {
namespace {

constexpr double kNearby = 30.0; ///< pixels around the target within which matches count

/// Where a target is in one image, pixels: an ellipse, as balls in flight are smeared.
struct Place {
  double x = 0.0, y = 0.0, halfWidth = 0.0, halfHeight = 0.0;
};

/// One target of a recording, and how far its truth can be trusted.
struct Subject {
  std::string name;
  std::map<int, Place> places; ///< by frame
  double rim = 0.0;            ///< pixels on either side of the outline that count for neither
};

PixelScore scoreOf(const cv::Mat& match, const cv::Mat& truth, const cv::Mat& counted) {
  return pixelScore(match & counted, truth & counted);
}

/// The place as a mask, `more` pixels larger (smaller where negative).
cv::Mat drawn(cv::Size size, const Place& place, double more) {
  cv::Mat mask = cv::Mat::zeros(size, CV_8UC1);
  constexpr int kShift = 4;
  const auto fixed = [](double value) { return static_cast<int>(std::lround(16.0 * value)); };
  const cv::Size half(fixed(std::max(0.5, place.halfWidth + more)),
                      fixed(std::max(0.5, place.halfHeight + more)));
  cv::ellipse(mask, {fixed(place.x), fixed(place.y)}, half, 0.0, 0.0, 360.0, cv::Scalar(255),
              cv::FILLED, cv::LINE_8, kShift);
  return mask;
}

double median(std::vector<double> values) {
  std::ranges::sort(values);
  return values.empty() ? 0.0 : values[values.size() / 2];
}

/// F1 scores of a range in one image.
struct ImageScore {
  double strict = 0.0; ///< all pixels of the image
  double whole = 0.0;  ///< all but the rim
  double near = 0.0;   ///< all but the rim, around the target: is its shape right?
};
ImageScore scoreIn(const cv::Mat& image, const Place& place, double rim, const ColorRange& range) {
  const cv::Mat match = matchImage(image, ColorClassifier(range));
  const cv::Mat truth = drawn(image.size(), place, 0.0);
  const cv::Mat counted = ~(drawn(image.size(), place, rim) & ~drawn(image.size(), place, -rim));
  return {scoreOf(match, truth, cv::Mat(image.size(), CV_8UC1, cv::Scalar(255))).f1(),
          scoreOf(match, truth, counted).f1(),
          scoreOf(match, truth, drawn(image.size(), place, kNearby) & counted).f1()};
}

/// The medians, each measure for itself.
ImageScore medianOf(const std::vector<ImageScore>& scores) {
  const auto each = [&](double ImageScore::*measure) {
    std::vector<double> values;
    std::ranges::transform(scores, std::back_inserter(values), measure);
    return median(std::move(values));
  };
  return {each(&ImageScore::strict), each(&ImageScore::whole), each(&ImageScore::near)};
}

ColorSample clickAt(const cv::Mat& image, double x, double y) {
  ColorSample place;
  place.x = std::round(x);
  place.y = std::round(y);
  return takeSample(image, place).value_or(ColorSample{});
}

std::string rangeText(const ColorRange& range) {
  return fmt::format("hue {:3.0f}-{:3.0f} sat {:.2f}-{:.2f} int {:.2f}-{:.2f}", range.hueMin,
                     range.hueMax, range.saturationMin, range.saturationMax, range.intensityMin,
                     range.intensityMax);
}

/// What one click at the target's center of one image gives in the other images.
struct Lesson {
  ColorRange range;
  double separability = 0.0;
  ImageScore score;
};
Lesson lesson(const std::map<int, cv::Mat>& images, const Subject& subject, int clicked) {
  const cv::Mat& image = images.at(clicked);
  const Place& place = subject.places.at(clicked);
  const auto learned = learnColor({clickAt(image, place.x, place.y)}, {image});
  if (!learned) {
    return {};
  }
  std::vector<ImageScore> scores;
  for (const auto& [frame, other] : subject.places) {
    if (frame != clicked) {
      scores.push_back(scoreIn(images.at(frame), other, subject.rim, learned->range));
    }
  }
  return {learned->range, learned->assessment.separability, medianOf(scores)};
}

/// A click in the given frame, and others in turn, so that no one lucky frame decides.
ImageScore benchSubject(const std::map<int, cv::Mat>& images, const Subject& subject, int first) {
  std::vector<int> frames;
  for (const auto& [frame, place] : subject.places) {
    frames.push_back(frame);
  }
  const Lesson one = lesson(images, subject, first);
  const auto print = [](const std::string& what, const ImageScore& score) {
    fmt::print("{:38} {:7.3f} {:7.3f} {:7.3f}", what, score.strict, score.whole, score.near);
  };
  print(fmt::format("{}, frame {}", subject.name, first), one.score);
  fmt::print("   verdict {:.2f}  {}\n", one.separability, rangeText(one.range));
  constexpr std::size_t kClicks = 10;
  std::vector<ImageScore> others;
  for (std::size_t k = 0; k < kClicks; ++k) {
    const std::size_t at = (2 * k + 1) * frames.size() / (2 * kClicks);
    others.push_back(lesson(images, subject, frames[at]).score);
  }
  print("  median of 10 other clicks", medianOf(others));
  fmt::print("   worst whole {:.3f}\n", std::ranges::min(others, {}, &ImageScore::whole).whole);
  std::fflush(stdout);
  return one.score;
}

std::map<int, cv::Mat> readImages(const std::string& folder, const char* pattern,
                                  const std::vector<Subject>& subjects) {
  std::map<int, cv::Mat> images;
  for (const Subject& subject : subjects) {
    for (const auto& [frame, place] : subject.places) {
      if (!images.contains(frame)) {
        images[frame] = cv::imread(folder + "/" + fmt::format(fmt::runtime(pattern), frame));
      }
    }
  }
  return images;
}

std::vector<std::vector<std::string>> readRows(const std::string& file) {
  std::ifstream stream(file);
  std::vector<std::vector<std::string>> rows;
  std::string line;
  std::getline(stream, line); // the columns' names
  while (std::getline(stream, line)) {
    if (line.ends_with('\r')) {
      line.pop_back(); // written elsewhere
    }
    auto& row = rows.emplace_back();
    std::stringstream cells(line);
    for (std::string cell; std::getline(cells, cell, ',');) {
      row.push_back(cell);
    }
  }
  return rows;
}

/// Centers marked by hand to about 3 pixels, "ball radius about 14 pixels".
std::vector<Subject> jugglingBalls(const std::string& folder) {
  constexpr double kRadius = 14.0;
  constexpr double kTrust = 3.0;
  std::vector<Subject> balls{
      {"juggle1 red", {}, kTrust}, {"juggle1 blue", {}, kTrust}, {"juggle1 yellow", {}, kTrust}};
  for (const auto& row : readRows(folder + "/gt1.csv")) {
    for (std::size_t k = 0; k < balls.size() && row.size() >= 7; ++k) {
      balls[k].places[std::stoi(row[0])] = {std::stod(row[2 + 2 * k]), std::stod(row[1 + 2 * k]),
                                            kRadius, kRadius};
    }
  }
  return balls;
}

/// Boxes from background difference and hue, good to about 2 pixels; the ellipse in the box.
std::vector<Subject> thrownBalls(const std::string& folder) {
  constexpr double kTrust = 2.0;
  std::vector<Subject> balls;
  for (const char* name : {"pink", "orange", "blue", "yellow"}) {
    Subject ball{std::string("throws ") + name, {}, kTrust};
    for (const auto& row : readRows(folder + "/balls_by_color.csv")) {
      if (row.size() >= 10 && row[0] == name && row[9] == "0") { // whole in the image
        const double halfWidth = std::stod(row[6]) / 2.0;
        const double halfHeight = std::stod(row[7]) / 2.0;
        ball.places[std::stoi(row[1])] = {std::stod(row[4]) + halfWidth - 0.5,
                                          std::stod(row[5]) + halfHeight - 0.5, halfWidth,
                                          halfHeight};
      }
    }
    balls.push_back(std::move(ball));
  }
  return balls;
}

void benchRecording(const std::string& folder, const char* pattern, std::vector<Subject> subjects,
                    std::vector<ImageScore>& scores) {
  const auto images = readImages(folder, pattern, subjects);
  for (Subject& subject : subjects) {
    std::erase_if(subject.places,
                  [&](const auto& place) { return images.at(place.first).empty(); });
    if (subject.places.size() < 2) {
      fmt::print("{} is not there; left out\n", subject.name);
      continue;
    }
    scores.push_back(benchSubject(images, subject, subject.places.begin()->first));
  }
}

/// One click in the first camera's first image; all pixels of both cameras' later images.
void benchSimulation(const std::string& name, const Eigen::Vector3d& bgr) {
  Scene scene = demoScene();
  SceneBall& ball = scene.balls.front();
  ball.color = bgr;
  ball.stillSeconds = 0.0;
  const SceneRenderer renderer(scene);
  const std::vector<cv::Mat> first{renderer.render(0, 0), renderer.render(1, 0)};
  const auto at = Projector(scene.cameras[0]).project(ballPosition(scene, 0, 0.0));
  const auto learned = learnColor({clickAt(first[0], at->x(), at->y())}, first);
  std::vector<double> scores;
  for (std::int64_t frame = 5; learned && frame < scene.frameCount; frame += 5) {
    for (std::size_t k = 0; k < scene.cameras.size(); ++k) {
      const cv::Mat image = renderer.render(static_cast<int>(k), frame);
      const cv::Mat truth =
          ballMask(scene.cameras[k], ballPosition(scene, 0, frameTime(scene, frame)), ball.radius);
      const cv::Mat match = matchImage(image, ColorClassifier(learned->range));
      scores.push_back(scoreOf(match, truth, cv::Mat(truth.size(), CV_8UC1, cv::Scalar(255))).f1());
    }
  }
  fmt::print("simulated {:28} {:7.3f}   worst {:.3f}   verdict {:.2f}  {}\n", name, median(scores),
             scores.empty() ? 0.0 : std::ranges::min(scores),
             learned ? learned->assessment.separability : 0.0,
             learned ? rangeText(learned->range) : "nothing learned");
  std::fflush(stdout);
}

} // namespace
} // namespace dewpoint::bench

int main(int argc, char** argv) {
  using namespace dewpoint::bench;
  const char* variable = std::getenv("DEWPOINT_DATA");
  const std::string data = argc > 1 ? argv[1] : variable ? variable : "../shared/data";
  fmt::print("Median pixel F1 over the other frames{:10}strict   whole    near\n", "");
  std::vector<ImageScore> scores;
  benchRecording(data + "/juggle1", "{:08}.jpg", jugglingBalls(data + "/juggle1"), scores);
  benchRecording(data + "/throws_pinkball", "frame{:05}.jpg",
                 thrownBalls(data + "/throws_pinkball"), scores);
  if (!scores.empty()) {
    const ImageScore all = medianOf(scores);
    fmt::print("{:38} {:7.3f} {:7.3f} {:7.3f}\n", "median of the targets", all.strict, all.whole,
               all.near);
  }
  benchSimulation("pink", {145.0, 85.0, 245.0});
  benchSimulation("red", {50.0, 50.0, 220.0});
  benchSimulation("orange", {40.0, 130.0, 245.0});
  benchSimulation("yellow", {50.0, 220.0, 235.0});
  benchSimulation("green", {80.0, 190.0, 60.0});
  benchSimulation("blue", {210.0, 100.0, 50.0});
}
