// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/capture/background_image.h"

#include "core/capture/frame_reader.h"
#include "core/capture/image_reader.h"
#include "core/capture/video_reader.h"

#include <algorithm>
#include <array>
#include <cstdint>
#include <filesystem>
#include <vector>

namespace dewpoint::capture {
namespace {

Result<FrameReaderPtr> openReader(const std::string& location, const std::string& field) {
  if (std::filesystem::is_directory(location)) {
    return openImageFolderReader(location, field);
  }
  return isImageFile(location) ? openImageFileReader(location, field)
                               : openVideoReader(location, field);
}

Result<std::vector<cv::Mat>> readSome(FrameReader& reader, const ImageShape& camera) {
  const std::int64_t count = std::min<std::int64_t>(kMaxMedianImages, reader.frameCount());
  std::vector<cv::Mat> pictures;
  for (std::int64_t k = 0; k < count; ++k) {
    const std::int64_t frame = k * reader.frameCount() / count;
    const auto picture = reader.read(frame);
    if (!picture) {
      return tl::make_unexpected(picture.error());
    }
    if (picture->empty()) {
      break;
    }
    auto rotated = prepareImage(*picture, camera, reader.fileOf(frame));
    if (!rotated) {
      return tl::make_unexpected(rotated.error());
    }
    pictures.push_back(rotated->clone());
  }
  if (pictures.empty()) {
    return failure(ErrorCode::FileUnreadable, reader.fileOf(0), quotedCameraName(camera.cameraName),
                   "it contains no background image");
  }
  return pictures;
}

/// The median of every byte. Not upperMedian(): that copies to floating point, here for each of the
/// millions of bytes.
cv::Mat medianImage(const std::vector<cv::Mat>& pictures) {
  if (pictures.size() == 1) {
    return pictures.front();
  }
  cv::Mat median(pictures.front().size(), CV_8UC3);
  std::array<std::uint8_t, kMaxMedianImages> values{};
  const auto end = values.begin() + std::ssize(pictures);
  const auto middle = values.begin() + std::ssize(pictures) / 2;
  for (int row = 0; row < median.rows; ++row) {
    auto* out = median.ptr<std::uint8_t>(row);
    for (int i = 0; i < 3 * median.cols; ++i) {
      std::ranges::transform(pictures, values.begin(), [&](const cv::Mat& picture) {
        return picture.ptr<std::uint8_t>(row)[i];
      });
      std::nth_element(values.begin(), middle, end);
      out[i] = *middle;
    }
  }
  return median;
}

} // namespace

Result<cv::Mat> readBackgroundImage(const std::string& location, const ImageShape& camera) {
  const std::string field = quotedCameraName(camera.cameraName);
  std::error_code problem;
  if (!std::filesystem::exists(location, problem)) {
    return failure(ErrorCode::FileMissing, location, field, "");
  }
  return openReader(location, field)
      .and_then([&](const FrameReaderPtr& reader) { return readSome(*reader, camera); })
      .map([](const std::vector<cv::Mat>& pictures) { return medianImage(pictures); });
}

} // namespace dewpoint::capture
