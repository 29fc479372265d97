// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/capture/generated_reader.h"

#include <fmt/format.h>

#include <exception>
#include <memory>
#include <utility>

namespace dewpoint::capture {
namespace {

class GeneratedReader final : public FrameReader {
public:
  GeneratedReader(const RecordedCamera& camera, std::string field)
      : camera_(camera), field_(std::move(field)) {}

  std::int64_t frameCount() const override { return camera_.generatedFrameCount; }
  std::string fileOf(std::int64_t) const override { return camera_.path; }
  Result<cv::Mat> read(std::int64_t frame) override {
    try {
      cv::Mat picture = camera_.generate(frame);
      if (picture.empty()) {
        return failure(ErrorCode::FileUnreadable, camera_.path, field_,
                       fmt::format("image {} was not made", frame));
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

Result<FrameReaderPtr> openGeneratedReader(const RecordedCamera& camera, const std::string& field) {
  if (!camera.generate || camera.generatedFrameCount < 1) {
    return failure(ErrorCode::BadValue, camera.path, field, "there is nothing that makes images");
  }
  return std::make_unique<GeneratedReader>(camera, field);
}

} // namespace dewpoint::capture
