// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/capture/picture_reader.h"

#include <fmt/format.h>
#include <opencv2/imgcodecs.hpp>

#include <algorithm>
#include <array>
#include <cctype>
#include <filesystem>
#include <string_view>
#include <utility>

namespace dewpoint::capture {

namespace {

namespace fs = std::filesystem;

bool isDigit(char c) {
  return c >= '0' && c <= '9';
}

/// Cuts the run of digits off the front of `text`, without its leading zeros.
std::string_view takeNumber(std::string_view& text) {
  const auto end = std::ranges::find_if_not(text, isDigit);
  std::string_view number = text.substr(0, static_cast<std::size_t>(end - text.begin()));
  text.remove_prefix(number.size());
  number.remove_prefix(std::min(number.find_first_not_of('0'), number.size()));
  return number;
}

bool isPicture(const fs::path& path) {
  constexpr std::array kEndings{".png", ".jpg", ".jpeg", ".bmp", ".tif", ".tiff"};
  std::string ending = path.extension().string();
  std::ranges::transform(ending, ending.begin(), [](unsigned char c) { return std::tolower(c); });
  return !path.filename().string().starts_with('.') &&
         std::ranges::find(kEndings, ending) != kEndings.end();
}

class ImageReader final : public PictureReader {
public:
  ImageReader(std::vector<std::string> files, std::string field)
      : files_(std::move(files)), field_(std::move(field)) {}

  std::int64_t frameCount() const override { return std::ssize(files_); }
  std::string fileOf(std::int64_t frame) const override {
    return files_[static_cast<std::size_t>(frame)];
  }
  Result<cv::Mat> read(std::int64_t frame) override {
    const std::string file = fileOf(frame);
    try {
      cv::Mat picture = cv::imread(file, cv::IMREAD_COLOR);
      if (picture.empty()) {
        return failure(ErrorCode::FileUnreadable, file, field_,
                       "it is no picture, or a damaged one");
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

class GeneratedReader final : public PictureReader {
public:
  GeneratedReader(const RecordedCamera& camera, std::string field)
      : camera_(camera), field_(std::move(field)) {}

  std::int64_t frameCount() const override { return camera_.generatedFrames; }
  std::string fileOf(std::int64_t) const override { return camera_.path; }
  Result<cv::Mat> read(std::int64_t frame) override {
    try {
      cv::Mat picture = camera_.generate(frame);
      if (picture.empty()) {
        return failure(ErrorCode::FileUnreadable, camera_.path, field_,
                       fmt::format("picture {} was not made", frame));
      }
      return picture;
    } catch (const std::exception& problem) {
      return failure(ErrorCode::FileUnreadable, camera_.path, field_, problem.what());
    }
  }

private:
  RecordedCamera camera_;
  std::string field_;
};

} // namespace

bool isPictureFile(const std::string& path) {
  return isPicture(path);
}

bool naturallyBefore(const std::string& left, const std::string& right) {
  std::string_view a = left;
  std::string_view b = right;
  while (!a.empty() && !b.empty()) {
    if (isDigit(a.front()) && isDigit(b.front())) {
      const auto numberA = takeNumber(a);
      const auto numberB = takeNumber(b);
      if (numberA.size() != numberB.size()) {
        return numberA.size() < numberB.size();
      }
      if (numberA != numberB) {
        return numberA < numberB;
      }
      continue;
    }
    if (a.front() != b.front()) {
      return static_cast<unsigned char>(a.front()) < static_cast<unsigned char>(b.front());
    }
    a.remove_prefix(1);
    b.remove_prefix(1);
  }
  // Equal but for leading zeros or an ending: any fixed order will do.
  return a.empty() != b.empty() ? a.empty() : left < right;
}

Result<PictureReaderPtr> openImageReader(const std::string& folder, const std::string& field) {
  std::error_code problem;
  if (!fs::exists(folder, problem)) {
    return failure(ErrorCode::FileMissing, folder, field, "");
  }
  if (!fs::is_directory(folder, problem)) {
    return failure(ErrorCode::FileUnreadable, folder, field,
                   "a folder of pictures is expected here");
  }
  std::vector<std::string> files;
  for (fs::directory_iterator item(folder, problem), end; !problem && item != end;
       item.increment(problem)) {
    std::error_code ignored;
    if (isPicture(item->path()) && item->is_regular_file(ignored)) {
      files.push_back(item->path().string());
    }
  }
  if (problem) {
    return failure(ErrorCode::FileUnreadable, folder, field, problem.message());
  }
  if (files.empty()) {
    return failure(ErrorCode::FileUnreadable, folder, field,
                   "the folder contains no pictures (png, jpg, bmp or tif)");
  }
  std::ranges::sort(files, naturallyBefore);
  return std::make_unique<ImageReader>(std::move(files), field);
}

Result<PictureReaderPtr> openPictureReader(const std::string& file, const std::string& field) {
  return std::make_unique<ImageReader>(std::vector<std::string>{file}, field);
}

Result<PictureReaderPtr> openGeneratedReader(const RecordedCamera& camera,
                                             const std::string& field) {
  if (!camera.generate || camera.generatedFrames < 1) {
    return failure(ErrorCode::BadValue, camera.path, field, "there is nothing that makes pictures");
  }
  return std::make_unique<GeneratedReader>(camera, field);
}

} // namespace dewpoint::capture
