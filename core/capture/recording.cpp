// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/capture/recording.h"

#include "core/capture/frame_source.h"
#include "core/capture/generated_reader.h"
#include "core/capture/image_reader.h"
#include "core/capture/picture.h"
#include "core/capture/picture_reader.h"
#include "core/capture/video_reader.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <utility>

namespace dewpoint::capture {
namespace {

/// Rates further apart than this share cannot be one rate, rounded in different ways.
constexpr double kSameRate = 0.01;

struct Camera {
  PictureShape shape;
  std::string path;
  PictureReaderPtr reader;
  cv::Mat first;          ///< frame 0, decoded when the recording was opened; handed out once
  double delay = 0.0;     ///< seconds
  std::int64_t ahead = 0; ///< its pictures are taken from so many farther on
};

Result<cv::Mat> readShaped(Camera& camera, std::int64_t frame) {
  if (frame == 0 && !camera.first.empty()) {
    return std::exchange(camera.first, cv::Mat());
  }
  const auto picture = camera.reader->read(frame);
  if (!picture || picture->empty()) {
    return picture;
  }
  return shaped(*picture, camera.shape, camera.reader->fileOf(frame));
}

class Recording final : public FrameSetSource {
public:
  Recording(std::vector<Camera> cameras, double rate, std::vector<Error> notices)
      : cameras_(std::move(cameras)), rate_(rate), notices_(std::move(notices)) {
    count_ = frames(*std::ranges::min_element(cameras_, {}, frames));
    for (Camera& camera : cameras_) {
      camera.ahead = std::llround(camera.delay * rate_);
    }
  }

  static std::int64_t frames(const Camera& camera) { return camera.reader->frameCount(); }

  std::optional<std::int64_t> frameCount() const override { return count_; }
  double framesPerSecond() const override { return rate_; }
  std::vector<Error> notices() const override { return notices_; }

  Result<FrameSetPtr> next() override {
    if (next_ >= count_) {
      return FrameSetPtr();
    }
    auto set = std::make_shared<FrameSet>();
    set->index = next_;
    set->time = timeStamp(static_cast<double>(next_) / rate_);
    for (Camera& camera : cameras_) {
      const std::int64_t number = next_ + camera.ahead;
      if (number < 0 || number >= frames(camera)) {
        set->frames.push_back(nullptr);
        continue;
      }
      auto picture = readShaped(camera, number);
      if (!picture) {
        return tl::make_unexpected(picture.error());
      }
      if (picture->empty()) {
        return FrameSetPtr();
      }
      const TimeStamp taken = timeStamp(static_cast<double>(number) / rate_ - camera.delay);
      set->frames.push_back(std::make_shared<Frame>(Frame{number, taken, std::move(*picture)}));
    }
    ++next_;
    return set;
  }

  Status seek(std::int64_t frame) override {
    if (frame < 0 || frame > count_) {
      return failure(ErrorCode::BadValue, "", "frame",
                     fmt::format("{} is not between 0 and {}", frame, count_));
    }
    next_ = frame;
    return {};
  }

private:
  std::vector<Camera> cameras_;
  double rate_;
  std::vector<Error> notices_;
  std::int64_t count_ = 0;
  std::int64_t next_ = 0;
};

Result<PictureReaderPtr> openReader(const RecordedCamera& camera) {
  const std::string field = cameraField(camera.name);
  switch (camera.kind) {
  case RecordedCamera::Kind::Video:
    return openVideoReader(camera.path, field);
  case RecordedCamera::Kind::Images:
    return openImageReader(camera.path, field);
  case RecordedCamera::Kind::Generated:
    break;
  }
  return openGeneratedReader(camera, field);
}

/// Opens one camera and decodes its first picture, so that what can be wrong is said at once.
Result<Camera> openCamera(const RecordedCamera& description) {
  Camera camera;
  camera.shape = {description.name, description.rotateDegrees, description.width,
                  description.height, description.mirrored};
  camera.path = description.path;
  camera.delay = description.delay;
  if (auto usable = checkShape(camera.shape, camera.path); !usable) {
    return tl::make_unexpected(usable.error());
  }
  auto reader = openReader(description);
  if (!reader) {
    return tl::make_unexpected(reader.error());
  }
  camera.reader = std::move(*reader);
  auto first = readShaped(camera, 0);
  if (!first) {
    return tl::make_unexpected(first.error());
  }
  camera.first = std::move(*first);
  return camera;
}

/// The file's name, without its folder, or the camera's.
std::string nameOf(const Camera& camera) {
  return camera.path.empty() ? cameraField(camera.shape.camera)
                             : std::filesystem::path(camera.path).filename().string();
}

/// Says which cameras differ when they do; `what` lists each with its own number.
void noteDifferences(const std::vector<Camera>& cameras, std::vector<Error>& notices) {
  const auto [shortest, longest] = std::ranges::minmax_element(cameras, {}, Recording::frames);
  if (Recording::frames(*shortest) != Recording::frames(*longest)) {
    std::string list;
    for (const Camera& camera : cameras) {
      list += fmt::format("{}{}: {} pictures", list.empty() ? "" : ", ", nameOf(camera),
                          Recording::frames(camera));
    }
    notices.push_back(
        {ErrorCode::Mismatch, shortest->path, cameraField(shortest->shape.camera),
         fmt::format("{}; only the first {} are used", list, Recording::frames(*shortest))});
  }
  const Camera* reference = nullptr;
  for (const Camera& camera : cameras) {
    const double rate = camera.reader->framesPerSecond();
    if (rate <= 0) {
      continue;
    }
    if (reference == nullptr) {
      reference = &camera;
      continue;
    }
    const double first = reference->reader->framesPerSecond();
    if (std::abs(rate - first) > kSameRate * first) {
      notices.push_back({ErrorCode::Mismatch, camera.path, cameraField(camera.shape.camera),
                         fmt::format("{:.4g} pictures per second, but {} has {:.4g}", rate,
                                     nameOf(*reference), first)});
    }
  }
}

double rateOf(const std::vector<Camera>& cameras, double requested) {
  if (requested > 0) {
    return requested;
  }
  for (const Camera& camera : cameras) {
    if (camera.reader->framesPerSecond() > 0) {
      return camera.reader->framesPerSecond();
    }
  }
  return kDefaultFramesPerSecond;
}

} // namespace

Result<std::unique_ptr<FrameSetSource>> openRecording(const std::vector<RecordedCamera>& cameras,
                                                      double framesPerSecond) {
  if (cameras.empty()) {
    return failure(ErrorCode::MissingKey, "", "camera", "a recording needs at least one camera");
  }
  if (!std::isfinite(framesPerSecond) || framesPerSecond < 0) {
    return failure(ErrorCode::BadValue, "", "frames per second",
                   fmt::format("{} is no rate", framesPerSecond));
  }
  std::vector<Camera> opened;
  for (const RecordedCamera& description : cameras) {
    auto camera = openCamera(description);
    if (!camera) {
      return tl::make_unexpected(camera.error());
    }
    opened.push_back(std::move(*camera));
  }
  std::vector<Error> notices;
  noteDifferences(opened, notices);
  const double rate = rateOf(opened, framesPerSecond);
  return std::make_unique<Recording>(std::move(opened), rate, std::move(notices));
}

} // namespace dewpoint::capture
