// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/setup/new_project/footage_facts.h"

#include "core/capture/image_reader.h"
#include "core/capture/image_shape.h"
#include "core/capture/recording.h"
#include "core/capture/video_reader.h"
#include "core/setup/new_project/new_project.h"

#include <opencv2/imgproc.hpp>

#include <algorithm>
#include <cmath>
#include <filesystem>

namespace dewpoint::setup {
namespace {

/// Width of a preview, pixels: that of a small picture in a list on a dense screen. Chosen.
constexpr int kPreviewWidth = 192;

cv::Mat scaledDown(const cv::Mat& image) {
  if (image.cols <= kPreviewWidth) {
    return image.clone();
  }
  cv::Mat preview;
  const double scale = static_cast<double>(kPreviewWidth) / image.cols;
  const int height = std::max(1, static_cast<int>(std::lround(image.rows * scale)));
  cv::resize(image, preview, {kPreviewWidth, height}, 0.0, 0.0, cv::INTER_AREA);
  return preview;
}

bool differ(const std::vector<FootageFacts>& recordings, auto differs) {
  return std::ranges::any_of(
      recordings, [&](const FootageFacts& one) { return differs(one, recordings.front()); });
}

} // namespace

Result<std::optional<FootageFacts>> readFootageFacts(const std::string& location) {
  const SourceKind kind = guessSourceKind(location);
  std::error_code problem;
  const bool isThere = std::filesystem::exists(location, problem);
  const bool isFolder = std::filesystem::is_directory(location, problem);
  const bool isFile = std::filesystem::is_regular_file(location, problem);
  if (kind == SourceKind::Device || kind == SourceKind::Stream ||
      (isThere && !isFolder && !isFile)) {
    return std::nullopt;
  }
  auto reader = isFolder ? openImageFolderReader(location, "") : openVideoReader(location, "");
  if (!reader) {
    return tl::make_unexpected(reader.error());
  }
  const auto picture = (*reader)->read(0);
  if (!picture) {
    return tl::make_unexpected(picture.error());
  }
  if (picture->empty()) {
    return failure(ErrorCode::FileUnreadable, location, "", "it contains no image");
  }
  const auto image = prepareImage(*picture, ImageShape(), (*reader)->fileOf(0));
  if (!image) {
    return tl::make_unexpected(image.error());
  }
  FootageFacts facts;
  facts.width = image->cols;
  facts.height = image->rows;
  facts.framesPerSecond = (*reader)->framesPerSecond();
  facts.frameCount = (*reader)->frameCount();
  facts.preview = scaledDown(*image);
  return facts;
}

FootageDifferences footageDifferences(const std::vector<FootageFacts>& recordings) {
  FootageDifferences found;
  if (recordings.empty()) {
    return found;
  }
  if (differ(recordings,
             [](const auto& a, const auto& b) { return a.frameCount != b.frameCount; })) {
    found.shortestFrameCount =
        std::ranges::min_element(recordings, {}, &FootageFacts::frameCount)->frameCount;
  }
  found.imageSizesDiffer = differ(recordings, [](const auto& a, const auto& b) {
    return a.width != b.width || a.height != b.height;
  });
  std::vector<double> rates;
  for (const FootageFacts& one : recordings) {
    if (one.framesPerSecond > 0.0) {
      rates.push_back(one.framesPerSecond);
    }
  }
  if (!rates.empty()) {
    const auto [least, most] = std::ranges::minmax(rates);
    found.frameRatesDiffer = most > least * (1.0 + kRateTolerance);
  }
  return found;
}

} // namespace dewpoint::setup
