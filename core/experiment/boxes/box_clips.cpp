// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/experiment/boxes/box_clips.h"

#include "core/base/text_file.h"
#include "core/geometry/sphere_image.h"
#include "core/simulation/scene/scene_renderer.h"

#include <fmt/format.h>
#include <opencv2/imgcodecs.hpp>

#include <algorithm>
#include <map>
#include <memory>
#include <optional>
#include <sstream>

namespace dewpoint::experiment {
namespace {

namespace fs = std::filesystem;

// juggle1: centers of pixels are marked, and the balls' radius is about 14 px.
constexpr double kJuggleRadius = 14.0;
constexpr double kPixelCenter = 0.5;      // boxes are measured from the corner of a pixel
constexpr double kOtbRadius = 20.0;       // of the benchmark's precision
constexpr double kClipPeriod = 0.8;       // seconds, of the simulated ball's fastest motion; chosen
constexpr std::int64_t kClipFrames = 300; // of the simulated ball: 10 s; chosen
constexpr std::size_t kMostClipRows = 1'000'000;
constexpr int kLeastFrames = 20; // of a ball that is thrown; chosen: shorter ones tell nothing

std::function<Result<cv::Mat>(std::int64_t)> imageSource(std::vector<fs::path> files) {
  return [files = std::move(files)](std::int64_t frame) -> Result<cv::Mat> {
    const std::string file = files[static_cast<std::size_t>(frame)].string();
    cv::Mat image = cv::imread(file, cv::IMREAD_COLOR);
    if (image.empty()) {
      return failure(ErrorCode::FileUnreadable, file, "", "not an image");
    }
    return image;
  };
}

/// The number of an image, as its file name has it; nothing if it cannot be one.
std::optional<int> imageNumber(double number) {
  constexpr double kHighestImage = 99'999'999.0; // eight digits
  return number >= 0.0 && number <= kHighestImage ? std::optional(static_cast<int>(number))
                                                  : std::nullopt;
}

/// The numbers of a line, whatever stands between them.
std::vector<double> numbersOf(std::string line) {
  std::ranges::replace_if(
      line, [](char letter) { return letter == ',' || letter == '\t'; }, ' ');
  std::istringstream stream(line);
  std::vector<double> numbers;
  for (double number = 0.0; stream >> number;) {
    numbers.push_back(number);
  }
  return numbers;
}

/// The lines that hold exactly `count` numbers.
Result<std::vector<std::vector<double>>> rowsOf(const fs::path& file, std::size_t count) {
  const auto text = readTextFile(file);
  if (!text) {
    return tl::make_unexpected(text.error());
  }
  std::istringstream stream(*text);
  std::vector<std::vector<double>> rows;
  for (std::string line; std::getline(stream, line);) {
    auto numbers = numbersOf(line);
    if (numbers.size() == count) {
      if (rows.size() == kMostClipRows) {
        return failure(ErrorCode::NotParsed, file.string(), "",
                       fmt::format("more than {} rows", kMostClipRows));
      }
      rows.push_back(std::move(numbers));
    }
  }
  if (rows.size() < 2) {
    return failure(ErrorCode::NotParsed, file.string(), "",
                   fmt::format("rows of {} numbers are expected", count));
  }
  return rows;
}

Status addJuggle(const fs::path& folder, std::vector<BoxClip>& clips) {
  const auto rows = rowsOf(folder / "gt1.csv", 7);
  if (!rows) {
    return tl::make_unexpected(rows.error());
  }
  std::vector<fs::path> files;
  for (const auto& row : *rows) {
    const auto number = imageNumber(row[0]);
    if (!number) {
      return failure(ErrorCode::NotParsed, (folder / "gt1.csv").string(), "frame",
                     fmt::format("{} is not the number of an image", row[0]));
    }
    files.push_back(folder / fmt::format("{:08}.jpg", *number));
  }
  constexpr const char* kBalls[] = {"red", "blue", "yellow"};
  for (std::size_t ball = 0; ball < 3; ++ball) {
    BoxClip clip;
    clip.name = fmt::format("juggle1, {} ball", kBalls[ball]);
    clip.description = "up to 70 px per frame, hands and other balls in front";
    clip.hitRadiusPx = kJuggleRadius;
    clip.hasExactBoxes = false;
    clip.image = imageSource(files);
    for (const auto& row : *rows) {
      const Eigen::Vector2d center(row[2 * ball + 2] + kPixelCenter,
                                   row[2 * ball + 1] + kPixelCenter);
      clip.truth.push_back(ImageBox::around(center, 2.0 * kJuggleRadius, 2.0 * kJuggleRadius));
    }
    clips.push_back(std::move(clip));
  }
  return {};
}

void addThrow(const fs::path& folder, const std::string& color,
              const std::map<int, ImageBox>& boxes, std::vector<BoxClip>& clips) {
  int begin = 0;
  int count = 0;
  int run = 0;
  for (const auto& [frame, box] : boxes) {
    run = boxes.contains(frame - 1) ? run + 1 : 1;
    if (run > count) {
      count = run;
      begin = frame - run + 1;
    }
  }
  if (count < kLeastFrames) {
    return;
  }
  BoxClip clip;
  clip.name = fmt::format("throws_pinkball, {} ball", color);
  clip.description = "boxes by color segmentation";
  clip.hitRadiusPx = kJuggleRadius;
  std::vector<fs::path> files;
  for (int frame = begin; frame < begin + count; ++frame) {
    clip.truth.push_back(boxes.at(frame));
    files.push_back(folder / fmt::format("frame{:05}.jpg", frame));
  }
  clip.image = imageSource(std::move(files));
  clips.push_back(std::move(clip));
}

/// The boxes of throws_pinkball: of each ball its longest run of successive frames that is whole.
Status addThrows(const fs::path& folder, std::vector<BoxClip>& clips) {
  const auto text = readTextFile(folder / "balls_by_color.csv");
  if (!text) {
    return tl::make_unexpected(text.error());
  }
  std::map<std::string, std::map<int, ImageBox>> balls;
  std::istringstream stream(*text);
  for (std::string line; std::getline(stream, line);) {
    const std::size_t comma = line.find(',');
    const auto row = numbersOf(comma == std::string::npos ? "" : line.substr(comma + 1));
    if (row.size() != 9 || row[8] != 0.0) { // frame, center, box, area, touches the border
      continue;
    }
    const auto number = imageNumber(row[0]);
    if (!number) {
      return failure(ErrorCode::NotParsed, (folder / "balls_by_color.csv").string(), "frame",
                     fmt::format("{} is not the number of an image", row[0]));
    }
    balls[line.substr(0, comma)][*number] = {row[3], row[4], row[5], row[6]};
  }
  for (const auto& [color, boxes] : balls) {
    addThrow(folder, color, boxes, clips);
  }
  return {};
}

Status addSequence(const fs::path& folder, std::vector<BoxClip>& clips) {
  const auto rows = rowsOf(folder / "groundtruth_rect.txt", 4);
  if (!rows) {
    return tl::make_unexpected(rows.error());
  }
  BoxClip clip;
  clip.name = "otb, " + folder.filename().string();
  clip.description = "hand-marked boxes";
  clip.hitRadiusPx = kOtbRadius;
  std::vector<fs::path> files;
  for (const auto& row : *rows) { // counted from 1
    clip.truth.push_back({row[0] - 1.0, row[1] - 1.0, row[2], row[3]});
    files.push_back(folder / fmt::format("{:04}.jpg", files.size() + 1));
  }
  clip.image = imageSource(std::move(files));
  clips.push_back(std::move(clip));
  return {};
}

Scene sceneOfClip(std::uint64_t seed) {
  Scene scene = demoScene();
  scene.seed = seed;
  scene.frameCount = kClipFrames;
  scene.distractorCount = 0;
  scene.noiseSigma = 5.0;
  SceneBall& ball = scene.balls.front();
  ball.motion = Motion::Smooth;
  ball.stillSeconds = 0.0;
  ball.period = kClipPeriod;
  scene.balls.resize(1);
  return scene;
}

} // namespace

BoxClip clipOfScene(const Scene& scene, int camera) {
  BoxClip clip;
  clip.name = fmt::format("{}, camera {}", scene.name, camera + 1);
  const SphereProjector projector(scene.cameras[static_cast<std::size_t>(camera)]);
  for (std::int64_t frame = 0; frame < scene.frameCount; ++frame) {
    const auto seen = projector.project(ballPosition(scene, 0, frameTime(scene, frame)),
                                        scene.balls.front().radius);
    const SphereImage disk = seen.value_or(SphereImage{});
    const Eigen::Vector2d center = disk.center + Eigen::Vector2d::Constant(kPixelCenter);
    clip.truth.push_back(ImageBox::around(center, 2.0 * disk.radius, 2.0 * disk.radius));
  }
  clip.hitRadiusPx = clip.truth.front().width / 2.0;
  const auto renderer = std::make_shared<const SceneRenderer>(scene);
  clip.image = [renderer, camera](std::int64_t frame) -> Result<cv::Mat> {
    return renderer->render(camera, frame);
  };
  return clip;
}

BoxClip simulatedBoxClip(std::uint64_t seed) {
  BoxClip clip = clipOfScene(sceneOfClip(seed), 0);
  clip.name = "simulated, fast ball";
  clip.description = "a ball that turns sharply, sensor noise of 5 gray levels";
  return clip;
}

Result<std::vector<BoxClip>> recordedBoxClips(const fs::path& folder) {
  std::vector<BoxClip> clips;
  if (fs::exists(folder / "juggle1")) {
    if (const auto added = addJuggle(folder / "juggle1", clips); !added) {
      return tl::make_unexpected(added.error());
    }
  }
  if (fs::exists(folder / "throws_pinkball")) {
    if (const auto added = addThrows(folder / "throws_pinkball", clips); !added) {
      return tl::make_unexpected(added.error());
    }
  }
  std::vector<fs::path> sequences;
  if (fs::exists(folder / "otb")) {
    for (const auto& entry : fs::directory_iterator(folder / "otb")) {
      if (fs::exists(entry.path() / "groundtruth_rect.txt")) {
        sequences.push_back(entry.path());
      }
    }
  }
  std::ranges::sort(sequences, std::greater<>());
  for (const fs::path& sequence : sequences) {
    if (const auto added = addSequence(sequence, clips); !added) {
      return tl::make_unexpected(added.error());
    }
  }
  return clips;
}

Result<std::vector<cv::Mat>> imagesOf(const BoxClip& clip) {
  std::vector<cv::Mat> images;
  for (std::size_t frame = 0; frame < clip.truth.size(); ++frame) {
    auto image = clip.image(static_cast<std::int64_t>(frame));
    if (!image) {
      return tl::make_unexpected(image.error());
    }
    images.push_back(std::move(*image));
  }
  return images;
}

} // namespace dewpoint::experiment
