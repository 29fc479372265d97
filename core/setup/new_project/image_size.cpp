// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/setup/new_project/image_size.h"

#include "core/capture/recording.h"
#include "core/setup/new_project/project_recording.h"

#include <fmt/format.h>

#include <utility>

namespace dewpoint::setup {

Result<cv::Size> imageSizeOf(const ProjectCamera& camera) {
  RecordedCamera recorded = recordedCamera(camera);
  recorded.width = 0;
  recorded.height = 0;
  recorded.timesFile.clear();
  recorded.delaySeconds = 0.0;
  auto source = openRecording({recorded}, 0.0);
  if (!source) {
    return tl::make_unexpected(source.error());
  }
  const auto frames = (*source)->next();
  if (!frames) {
    return tl::make_unexpected(frames.error());
  }
  if (!*frames || !(*frames)->frames.front()) {
    return failure(ErrorCode::FileUnreadable, camera.location, camera.camera.name,
                   "there is no image in it");
  }
  return (*frames)->frames.front()->image.size();
}

Status fitCalibration(ProjectCamera& camera, const std::optional<SizeFit>& fit,
                      const std::string& file, std::vector<std::string>& decisions) {
  if (camera.source != SourceKind::Video && camera.source != SourceKind::Images) {
    return {};
  }
  const auto size = imageSizeOf(camera);
  const Intrinsics& in = camera.camera.intrinsics;
  if (!size || *size == cv::Size(in.width, in.height)) {
    return {}; // what is wrong with a recording is said where it is opened
  }
  if (!fit) {
    return failure(ErrorCode::Mismatch, file, camera.camera.name,
                   fmt::format("the calibration is for images of {} x {} pixels, and those of this "
                               "camera have {} x {}: adapt it with --fit crop, trim, scale, "
                               "rotate-90 or rotate-270",
                               in.width, in.height, size->width, size->height));
  }
  auto fitted = fittedToSize(camera.camera, size->width, size->height, *fit);
  if (!fitted) {
    fitted.error().file = file;
    return tl::make_unexpected(std::move(fitted.error()));
  }
  decisions.push_back(sizeFitSentence(camera.camera, *fitted, *fit));
  camera.camera = std::move(*fitted);
  return {};
}

} // namespace dewpoint::setup
