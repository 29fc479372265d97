// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/session/run/background_images.h"

#include "core/base/text_file.h"
#include "core/capture/background_image.h"

#include <fmt/format.h>
#include <opencv2/core.hpp>
#include <opencv2/imgcodecs.hpp>

#include <algorithm>
#include <cctype>
#include <string>
#include <system_error>

namespace dewpoint::session {
namespace {

/// A name that is not taken: "desk-empty-left.png", "desk-empty-left-2.png", ...
std::filesystem::path freshFile(const Project& project, const std::string& camera,
                                const std::filesystem::path& folder) {
  std::string stem = fmt::format("{}-empty-{}", project.name, camera);
  std::ranges::replace_if(
      stem,
      [](unsigned char letter) {
        return letter < 0x80 && std::isalnum(letter) == 0 && letter != '-' && letter != '_';
      },
      '-');
  std::filesystem::path file = folder / (stem + ".png");
  std::error_code unknown; // then writing says what is wrong
  for (int number = 2; std::filesystem::exists(file, unknown); ++number) {
    file = folder / fmt::format("{}-{}.png", stem, number);
  }
  return file;
}

} // namespace

Result<std::vector<cv::Mat>> loadBackgroundImages(const Project& project) {
  std::vector<cv::Mat> rooms(project.cameras.size());
  for (std::size_t k = 0; k < rooms.size(); ++k) {
    const ProjectCamera& camera = project.cameras[k];
    if (camera.backgroundImageFile.empty()) {
      continue;
    }
    const Intrinsics& size = camera.camera.intrinsics;
    auto room = readBackgroundImage(camera.backgroundImageFile,
                                    {camera.camera.name, camera.rotateDegrees, size.width,
                                     size.height, camera.isMirrored, camera.crop});
    if (!room) {
      return tl::make_unexpected(room.error());
    }
    rooms[k] = std::move(*room);
  }
  return rooms;
}

Result<std::filesystem::path> saveBackgroundImage(const Project& project, std::size_t camera,
                                                  const cv::Mat& image,
                                                  const std::filesystem::path& folder) {
  const ProjectCamera& its = project.cameras.at(camera);
  std::error_code problem;
  std::filesystem::create_directories(folder, problem);
  if (problem) {
    return failure(ErrorCode::FileUnwritable, folder.string(), quotedCameraName(its.camera.name),
                   problem.message());
  }
  // As large as the camera sends it: what was cropped is not known, and continues the edges.
  cv::Mat rotated;
  cv::copyMakeBorder(image, rotated, its.crop.top, its.crop.bottom, its.crop.left, its.crop.right,
                     cv::BORDER_REPLICATE);
  if (its.isMirrored) {
    cv::flip(rotated, rotated, 1);
  }
  const auto back = prepareImage(rotated, {its.camera.name, (360 - its.rotateDegrees) % 360}, "");
  if (!back) {
    return tl::make_unexpected(back.error());
  }
  std::vector<std::uint8_t> png;
  cv::imencode(".png", *back, png);
  const auto file = freshFile(project, its.camera.name, folder);
  return writeTextFile(file, std::string(png.begin(), png.end())).map([&] { return file; });
}

} // namespace dewpoint::session
