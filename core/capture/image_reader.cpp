// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/capture/image_reader.h"

#include "core/base/lower_case.h"
#include "core/capture/natural_order.h"
#include "core/capture/numbered_files.h"

#include <opencv2/imgcodecs.hpp>

#include <algorithm>
#include <array>
#include <filesystem>
#include <utility>
#include <vector>

namespace dewpoint::capture {
namespace {

namespace fs = std::filesystem;

bool hasImageExtension(const fs::path& path) {
  constexpr std::array kEndings{".png", ".jpg", ".jpeg", ".bmp", ".tif", ".tiff"};
  const std::string ending = toLowerCase(path.extension().string());
  return !path.filename().string().starts_with('.') &&
         std::ranges::find(kEndings, ending) != kEndings.end();
}

class ImageReader final : public FrameReader {
public:
  ImageReader(std::vector<std::string> files, std::string field)
      : files_(std::move(files)), field_(std::move(field)) {}

  std::int64_t frameCount() const override { return std::ssize(files_); }
  std::vector<std::int64_t> sequenceNumbers() const override { return sequenceNumbersOf(files_); }
  std::string fileOf(std::int64_t frame) const override {
    return files_[static_cast<std::size_t>(frame)];
  }
  Result<cv::Mat> read(std::int64_t frame) override {
    const std::string file = fileOf(frame);
    try {
      cv::Mat picture = cv::imread(file, cv::IMREAD_COLOR);
      if (picture.empty()) {
        return failure(ErrorCode::FileUnreadable, file, field_,
                       "it is not an image, or it is damaged");
      }
      return picture;
    } catch (const std::exception& problem) {
      return failure(ErrorCode::FileUnreadable, file, field_, problem.what());
    }
  }

private:
  std::vector<std::string> files_;
  std::string field_;
};

} // namespace

bool isImageFile(const std::string& path) {
  return hasImageExtension(path);
}

Result<FrameReaderPtr> openImageFolderReader(const std::string& folder, const std::string& field) {
  std::error_code problem;
  if (!fs::exists(folder, problem)) {
    return failure(ErrorCode::FileMissing, folder, field, "");
  }
  if (!fs::is_directory(folder, problem)) {
    return failure(ErrorCode::FileUnreadable, folder, field, "a folder of images is expected here");
  }
  std::vector<std::string> files;
  for (fs::directory_iterator item(folder, problem), end; !problem && item != end;
       item.increment(problem)) {
    std::error_code ignored;
    if (hasImageExtension(item->path()) && item->is_regular_file(ignored)) {
      files.push_back(item->path().string());
    }
  }
  if (problem) {
    return failure(ErrorCode::FileUnreadable, folder, field, problem.message());
  }
  if (files.empty()) {
    return failure(ErrorCode::FileUnreadable, folder, field,
                   "the folder contains no images (png, jpg, bmp or tif)");
  }
  std::ranges::sort(files, isBeforeInNaturalOrder);
  return std::make_unique<ImageReader>(std::move(files), field);
}

Result<FrameReaderPtr> openImageFileReader(const std::string& file, const std::string& field) {
  return std::make_unique<ImageReader>(std::vector<std::string>{file}, field);
}

} // namespace dewpoint::capture
