// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/capture/recording.h"

#include "core/capture/capture_schedule.h"
#include "core/capture/capture_times.h"
#include "core/capture/frame_reader.h"
#include "core/capture/frame_source.h"
#include "core/capture/generated_reader.h"
#include "core/capture/image_reader.h"
#include "core/capture/image_shape.h"
#include "core/capture/video_reader.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <utility>

namespace dewpoint::capture {
namespace {

struct Camera {
  ImageShape shape;
  std::string path;
  FrameReaderPtr reader;
  cv::Mat first; ///< frame 0, decoded when the recording was opened; handed out once
  CaptureSchedule::CameraImages pictures;
};

Result<cv::Mat> readPrepared(Camera& camera, std::int64_t frame) {
  if (frame == 0 && !camera.first.empty()) {
    return std::exchange(camera.first, cv::Mat());
  }
  const auto picture = camera.reader->read(frame);
  if (!picture || picture->empty()) {
    return picture;
  }
  return prepareImage(*picture, camera.shape, camera.reader->fileOf(frame));
}

std::vector<CaptureSchedule::CameraImages> cameraImages(const std::vector<Camera>& cameras) {
  std::vector<CaptureSchedule::CameraImages> pictures(cameras.size());
  std::ranges::transform(cameras, pictures.begin(), &Camera::pictures);
  return pictures;
}

class Recording final : public FrameSetSource {
public:
  Recording(std::vector<Camera> cameras, double rate, std::vector<Error> notices)
      : cameras_(std::move(cameras)), schedule_(cameraImages(cameras_), rate), rate_(rate),
        notices_(std::move(notices)) {}

  std::optional<std::int64_t> frameCount() const override { return schedule_.frameCount(); }
  double framesPerSecond() const override { return rate_; }
  std::vector<Error> notices() const override { return notices_; }

  Result<FrameSetPtr> next() override {
    if (next_ >= schedule_.frameCount()) {
      return FrameSetPtr();
    }
    auto set = std::make_shared<FrameSet>();
    set->index = next_;
    set->time = timeStamp(static_cast<double>(next_) / rate_);
    for (std::size_t k = 0; k < cameras_.size(); ++k) {
      const auto scheduled = schedule_.imageAt(k, next_);
      if (!scheduled) {
        set->frames.push_back(nullptr);
        continue;
      }
      auto picture = readPrepared(cameras_[k], scheduled->imageIndex);
      if (!picture) {
        return tl::make_unexpected(picture.error());
      }
      if (picture->empty()) {
        return FrameSetPtr();
      }
      set->frames.push_back(std::make_shared<Frame>(
          Frame{scheduled->imageIndex, timeStamp(scheduled->time), std::move(*picture)}));
    }
    ++next_;
    return set;
  }

  Status seek(std::int64_t frame) override {
    if (frame < 0 || frame > schedule_.frameCount()) {
      return failure(ErrorCode::BadValue, "", "frame",
                     fmt::format("{} is not between 0 and {}", frame, schedule_.frameCount()));
    }
    next_ = frame;
    return {};
  }

private:
  std::vector<Camera> cameras_;
  CaptureSchedule schedule_;
  double rate_;
  std::vector<Error> notices_;
  std::int64_t next_ = 0;
};

Result<FrameReaderPtr> openReader(const RecordedCamera& camera) {
  const std::string field = quotedCameraName(camera.name);
  switch (camera.kind) {
  case RecordedCamera::Kind::Video:
    return openVideoReader(
        camera.path, field,
        readRecordedStamps(camera.timesFile, captureTimeIds(camera.name, camera.path)));
  case RecordedCamera::Kind::Images:
    return openImageFolderReader(camera.path, field);
  case RecordedCamera::Kind::Generated:
    break;
  }
  return openGeneratedReader(camera, field);
}

/// A recording that was cut off has some more times than images, or the other way round.
Status addTimes(const RecordedCamera& description, CaptureSchedule::CameraImages& pictures) {
  if (description.timesFile.empty()) {
    return {};
  }
  const std::string field = quotedCameraName(description.name);
  auto times = readCaptureTimes(description.timesFile,
                                captureTimeIds(description.name, description.path), field);
  if (!times) {
    return tl::make_unexpected(times.error());
  }
  if (completenessOf(description.timesFile) == TableCompleteness::CutOff) {
    pictures.imageCount = std::min<std::int64_t>(pictures.imageCount, std::ssize(*times));
    times->resize(static_cast<std::size_t>(pictures.imageCount));
  }
  if (std::ssize(*times) != pictures.imageCount) {
    return failure(ErrorCode::Mismatch, description.timesFile, field,
                   fmt::format("it has {} times, but there are {} images", times->size(),
                               pictures.imageCount));
  }
  pictures.times = std::move(*times);
  return {};
}

/// Opens one camera and decodes its first picture, so that what can be wrong is said at once.
Result<Camera> openCamera(const RecordedCamera& description) {
  Camera camera;
  camera.shape = {description.name,   description.rotateDegrees, description.width,
                  description.height, description.isMirrored,    description.crop};
  camera.path = description.path;
  if (auto usable = checkShape(camera.shape, camera.path); !usable) {
    return tl::make_unexpected(usable.error());
  }
  auto reader = openReader(description);
  if (!reader) {
    return tl::make_unexpected(reader.error());
  }
  camera.reader = std::move(*reader);
  auto first = readPrepared(camera, 0);
  if (!first) {
    return tl::make_unexpected(first.error());
  }
  camera.first = std::move(*first);
  camera.pictures = {camera.reader->frameCount(), description.delaySeconds, std::nullopt,
                     camera.reader->sequenceNumbers()};
  if (auto timed = addTimes(description, camera.pictures); !timed) {
    return tl::make_unexpected(timed.error());
  }
  return camera;
}

/// The file's name, without its folder, or the camera's.
std::string nameOf(const Camera& camera) {
  return camera.path.empty() ? quotedCameraName(camera.shape.cameraName)
                             : std::filesystem::path(camera.path).filename().string();
}

/// Says which cameras differ when they do; `what` lists each with its own number.
void noteDifferences(const std::vector<Camera>& cameras, std::vector<Error>& notices) {
  const auto lengthOf = [](const Camera& camera) {
    return CaptureSchedule::frameSetCountOf(camera.pictures);
  };
  const auto [shortest, longest] = std::ranges::minmax_element(cameras, {}, lengthOf);
  // By their times cameras need not have as many pictures.
  if (lengthOf(*shortest) != lengthOf(*longest) && !shortest->pictures.times) {
    std::string list;
    for (const Camera& camera : cameras) {
      list += fmt::format("{}{}: {} pictures", list.empty() ? "" : ", ", nameOf(camera),
                          lengthOf(camera));
    }
    notices.push_back({ErrorCode::Mismatch, shortest->path,
                       quotedCameraName(shortest->shape.cameraName),
                       fmt::format("{}; only the first {} are used", list, lengthOf(*shortest))});
  }
  const Camera* reference = nullptr;
  for (const Camera& camera : cameras) {
    const double rate = camera.reader->framesPerSecond();
    if (rate <= 0 || camera.pictures.times) { // with times, what the video announces is not used
      continue;
    }
    if (reference == nullptr) {
      reference = &camera;
      continue;
    }
    const double first = reference->reader->framesPerSecond();
    if (std::abs(rate - first) > kRateTolerance * first) {
      notices.push_back({ErrorCode::Mismatch, camera.path,
                         quotedCameraName(camera.shape.cameraName),
                         fmt::format("{:.4g} images per second, but {} has {:.4g}", rate,
                                     nameOf(*reference), first)});
    }
  }
}

/// The name of the file after which a picture is missing.
std::string firstFileBeforeGap(const Camera& camera) {
  const auto& sequenceNumbers = camera.pictures.sequenceNumbers;
  std::int64_t number = 0;
  while (sequenceNumbers[static_cast<std::size_t>(number)] == number) {
    ++number;
  }
  return std::filesystem::path(camera.reader->fileOf(number - 1)).filename().string();
}

/// Says of which camera numbered pictures are missing.
void noteGaps(const std::vector<Camera>& cameras, std::vector<Error>& notices) {
  for (const Camera& camera : cameras) {
    const std::int64_t gaps =
        CaptureSchedule::frameSetCountOf(camera.pictures) - camera.pictures.imageCount;
    if (gaps > 0 && !camera.pictures.times) {
      notices.push_back({ErrorCode::Mismatch, camera.path,
                         quotedCameraName(camera.shape.cameraName),
                         fmt::format("by the numbers in the file names, {} images are missing, the "
                                     "first after {}; the camera has no image in these frames",
                                     gaps, firstFileBeforeGap(camera))});
    }
  }
}

double highestRateOf(const std::vector<Camera>& cameras, double requested) {
  if (requested > 0) {
    return requested;
  }
  if (const double byTimes = CaptureSchedule::highestRateOf(cameraImages(cameras)); byTimes > 0) {
    return byTimes;
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
                   fmt::format("{} is not a valid frame rate", framesPerSecond));
  }
  std::vector<Camera> opened;
  for (const RecordedCamera& description : cameras) {
    auto camera = openCamera(description);
    if (!camera) {
      return tl::make_unexpected(camera.error());
    }
    opened.push_back(std::move(*camera));
  }
  const auto hasTimes = [](const Camera& camera) { return camera.pictures.times.has_value(); };
  if (std::ranges::any_of(opened, hasTimes)) {
    if (const auto without = std::ranges::find_if_not(opened, hasTimes); without != opened.end()) {
      return failure(ErrorCode::MissingKey, without->path,
                     quotedCameraName(without->shape.cameraName),
                     "other cameras have a table of times, and this one has none");
    }
  }
  std::vector<Error> notices;
  noteDifferences(opened, notices);
  noteGaps(opened, notices);
  const double rate = highestRateOf(opened, framesPerSecond);
  return std::make_unique<Recording>(std::move(opened), rate, std::move(notices));
}

} // namespace dewpoint::capture
