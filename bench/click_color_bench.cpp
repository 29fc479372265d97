// SPDX-License-Identifier: GPL-3.0-or-later
// How well one click teaches a color: the pixel F1 scores of the learned range and of the learned
// table of log ratios over the other frames of recordings with known targets, and over simulated
// views with exact truth; beside the best that a range and a table could do.
//   click_color_bench [DATA_FOLDER]        (default: $DEWPOINT_DATA)
#include "bench/color_score.h"
#include "bench/pixel_truth.h"
#include "bench/taught_colors.h"
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
#include <functional>
#include <map>
#include <sstream>

namespace dewpoint::bench {
namespace {

constexpr double kNearby = 30.0;     ///< pixels around the target within which matches count
constexpr double kRenderedRim = 1.0; ///< pixels of a rendered ball's rim that are mixed

/// Where a target is in one image, pixels: an ellipse, as balls in flight are smeared.
struct ImageEllipse {
  double x = 0.0, y = 0.0, halfWidth = 0.0, halfHeight = 0.0;
};

/// One target of a recording, and how far its truth can be trusted.
struct Subject {
  std::string name;
  std::map<int, ImageEllipse> ellipses; ///< by frame
  double rim = 0.0; ///< pixels on either side of the outline that count for neither
};

/// The ellipse as a mask, `more` pixels larger (smaller where negative).
cv::Mat drawn(cv::Size size, const ImageEllipse& ellipse, double more) {
  cv::Mat mask = cv::Mat::zeros(size, CV_8UC1);
  constexpr int kShift = 4;
  const auto fixed = [](double value) { return static_cast<int>(std::lround(16.0 * value)); };
  const cv::Size half(fixed(std::max(0.5, ellipse.halfWidth + more)),
                      fixed(std::max(0.5, ellipse.halfHeight + more)));
  cv::ellipse(mask, {fixed(ellipse.x), fixed(ellipse.y)}, half, 0.0, 0.0, 360.0, cv::Scalar(255),
              cv::FILLED, cv::LINE_8, kShift);
  return mask;
}

ColorTruth truthAt(cv::Size size, const ImageEllipse& ellipse, double rim) {
  const cv::Mat rimMask = drawn(size, ellipse, rim) & ~drawn(size, ellipse, -rim);
  return {drawn(size, ellipse, 0.0), ~rimMask, drawn(size, ellipse, kNearby) & ~rimMask};
}

/// The mask, grown by a disc.
cv::Mat grown(const cv::Mat& mask, double radius) {
  const int size = 2 * static_cast<int>(radius) + 1;
  cv::Mat result;
  cv::dilate(mask, result, cv::getStructuringElement(cv::MORPH_ELLIPSE, {size, size}));
  return result;
}

ColorTruth truthOf(const cv::Mat& target) {
  const cv::Mat rimMask = grown(target, kRenderedRim) & grown(~target, kRenderedRim);
  return {target, ~rimMask, grown(target, kNearby) & ~rimMask};
}

ColorSample clickAt(const cv::Mat& image, double x, double y) {
  ColorSample sample;
  sample.x = std::round(x);
  sample.y = std::round(y);
  return takeSample(image, sample).value_or(ColorSample{});
}

std::string rangeText(const ColorRange& range) {
  return fmt::format("hue {:3.0f}-{:3.0f} sat {:.2f}-{:.2f} int {:.2f}-{:.2f}", range.hueMin,
                     range.hueMax, range.saturationMin, range.saturationMax, range.intensityMin,
                     range.intensityMax);
}

/// Calls a function with images and what is true in them.
using Visit = std::function<void(const cv::Mat& image, const ColorTruth& truth)>;
using ForEachImage = std::function<void(const Visit& visit)>;

/// The median scores of each color over the images.
std::vector<ColorScore> scoresOf(const std::vector<PixelClassifier>& colors,
                                 const ForEachImage& forEachImage) {
  std::vector<std::vector<ColorScore>> scores(colors.size());
  forEachImage([&](const cv::Mat& image, const ColorTruth& truth) {
    for (std::size_t k = 0; k < colors.size(); ++k) {
      scores[k].push_back(colorScore(colors[k].values(image), truth));
    }
  });
  std::vector<ColorScore> medians;
  for (const auto& each : scores) {
    medians.push_back(medianOf(each));
  }
  return medians;
}

/// A row for each measure, a column for each color.
void printScores(const std::vector<ColorScore>& scores) {
  const auto row = [&](const char* name, double ColorScore::*measure) {
    fmt::print("  {:26}", name);
    for (const ColorScore& score : scores) {
      fmt::print(" {:>10.3f}", score.*measure);
    }
    fmt::print("\n");
  };
  row("strict", &ColorScore::strict);
  row("whole", &ColorScore::whole);
  row("near", &ColorScore::near);
  row("ROC area", &ColorScore::rocArea);
  std::fflush(stdout);
}

/// What a lesson taught, beside the best there is; the scores by column.
std::vector<ColorScore> benchLesson(const std::string& title, const LearnedColors& lesson,
                                    const ForEachImage& forEachImage) {
  fmt::print("{}   verdict {:.2f}  {}\n", title, lesson.separability, rangeText(lesson.range));
  if (lesson.colors.empty()) {
    fmt::print("  nothing learned\n");
    return std::vector<ColorScore>(LearnedColors::kColors);
  }
  TruthLearner truthLesson;
  forEachImage(
      [&](const cv::Mat& image, const ColorTruth& truth) { truthLesson.add(image, truth); });
  std::vector<PixelClassifier> colors = lesson.colors;
  for (PixelClassifier& best : truthLesson.colors()) {
    colors.push_back(std::move(best));
  }
  fmt::print("  {:26}", "");
  for (const PixelClassifier& color : colors) {
    fmt::print(" {:>10}", color.name);
  }
  fmt::print("\n");
  auto scores = scoresOf(colors, forEachImage);
  printScores(scores);
  return scores;
}

/// What one click at the target's center of one image teaches.
LearnedColors lessonIn(const std::map<int, cv::Mat>& images, const Subject& subject, int clicked) {
  const cv::Mat& image = images.at(clicked);
  const ImageEllipse& ellipse = subject.ellipses.at(clicked);
  return learnFromSamples({clickAt(image, ellipse.x, ellipse.y)}, {image});
}

ForEachImage otherFrames(const std::map<int, cv::Mat>& images, const Subject& subject,
                         int clicked) {
  return [&images, &subject, clicked](const Visit& visit) {
    for (const auto& [frame, ellipse] : subject.ellipses) {
      if (frame != clicked) {
        const cv::Mat& image = images.at(frame);
        visit(image, truthAt(image.size(), ellipse, subject.rim));
      }
    }
  };
}

/// A click in the given frame, and others in turn, so that no one lucky frame decides.
std::vector<ColorScore> benchSubject(const std::map<int, cv::Mat>& images, const Subject& subject,
                                     int first) {
  const auto scores =
      benchLesson(fmt::format("{}, frame {}", subject.name, first),
                  lessonIn(images, subject, first), otherFrames(images, subject, first));
  std::vector<int> frames;
  for (const auto& [frame, ellipse] : subject.ellipses) {
    frames.push_back(frame);
  }
  constexpr std::size_t kClicks = 10;
  std::vector<std::vector<ColorScore>> others(LearnedColors::kColors);
  for (std::size_t k = 0; k < kClicks; ++k) {
    const int clicked = frames[(2 * k + 1) * frames.size() / (2 * kClicks)];
    const LearnedColors lesson = lessonIn(images, subject, clicked);
    const auto taught = scoresOf(lesson.colors, otherFrames(images, subject, clicked));
    for (std::size_t column = 0; column < others.size(); ++column) {
      others[column].push_back(column < taught.size() ? taught[column] : ColorScore{});
    }
  }
  std::vector<ColorScore> medians;
  fmt::print("  {:26}", "worst whole of 10 clicks");
  for (const auto& column : others) {
    medians.push_back(medianOf(column));
    fmt::print(" {:>10.3f}", std::ranges::min(column, {}, &ColorScore::whole).whole);
  }
  fmt::print("\n  median of 10 other clicks\n");
  printScores(medians);
  return scores;
}

std::map<int, cv::Mat> readImages(const std::string& folder, const char* pattern,
                                  const std::vector<Subject>& subjects) {
  std::map<int, cv::Mat> images;
  for (const Subject& subject : subjects) {
    for (const auto& [frame, ellipse] : subject.ellipses) {
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
      balls[k].ellipses[std::stoi(row[0])] = {std::stod(row[2 + 2 * k]), std::stod(row[1 + 2 * k]),
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
        ball.ellipses[std::stoi(row[1])] = {std::stod(row[4]) + halfWidth - 0.5,
                                            std::stod(row[5]) + halfHeight - 0.5, halfWidth,
                                            halfHeight};
      }
    }
    balls.push_back(std::move(ball));
  }
  return balls;
}

void benchRecording(const std::string& folder, const char* pattern, std::vector<Subject> subjects,
                    std::vector<std::vector<ColorScore>>& scores) {
  const auto images = readImages(folder, pattern, subjects);
  for (Subject& subject : subjects) {
    std::erase_if(subject.ellipses,
                  [&](const auto& ellipse) { return images.at(ellipse.first).empty(); });
    if (subject.ellipses.size() < 2) {
      fmt::print("{} is not there; left out\n", subject.name);
      continue;
    }
    scores.push_back(benchSubject(images, subject, subject.ellipses.begin()->first));
  }
}

/// The medians of each column over the targets.
void printMedians(const std::vector<std::vector<ColorScore>>& scores) {
  std::vector<std::vector<ColorScore>> columns;
  for (const auto& target : scores) {
    columns.resize(std::max(columns.size(), target.size()));
    for (std::size_t column = 0; column < target.size(); ++column) {
      columns[column].push_back(target[column]);
    }
  }
  std::vector<ColorScore> medians;
  for (const auto& column : columns) {
    medians.push_back(medianOf(column));
  }
  fmt::print("median of the targets\n");
  printScores(medians);
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
  const LearnedColors lesson = learnFromSamples({clickAt(first[0], at->x(), at->y())}, first);
  benchLesson("simulated " + name, lesson, [&](const Visit& visit) {
    for (std::int64_t frame = 5; frame < scene.frameCount; frame += 5) {
      for (std::size_t k = 0; k < scene.cameras.size(); ++k) {
        const auto position = ballPosition(scene, 0, frameTime(scene, frame));
        visit(renderer.render(static_cast<int>(k), frame),
              truthOf(ballMask(scene.cameras[k], position, ball.radius)));
      }
    }
  });
}

} // namespace
} // namespace dewpoint::bench

int main(int argc, char** argv) {
  using namespace dewpoint::bench;
  const char* variable = std::getenv("DEWPOINT_DATA");
  const std::string data = argc > 1 ? argv[1] : variable ? variable : "../shared/data";
  fmt::print("Median over the other frames: pixel F1 and area under the ROC curve\n");
  std::vector<std::vector<ColorScore>> scores;
  benchRecording(data + "/juggle1", "{:08}.jpg", jugglingBalls(data + "/juggle1"), scores);
  benchRecording(data + "/throws_pinkball", "frame{:05}.jpg",
                 thrownBalls(data + "/throws_pinkball"), scores);
  if (!scores.empty()) {
    printMedians(scores);
  }
  benchSimulation("pink", {145.0, 85.0, 245.0});
  benchSimulation("red", {50.0, 50.0, 220.0});
  benchSimulation("orange", {40.0, 130.0, 245.0});
  benchSimulation("yellow", {50.0, 220.0, 235.0});
  benchSimulation("green", {80.0, 190.0, 60.0});
  benchSimulation("blue", {210.0, 100.0, 50.0});
}
