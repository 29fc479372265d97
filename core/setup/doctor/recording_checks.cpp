// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/setup/doctor/recording_checks.h"

#include "core/capture/background_image.h"
#include "core/capture/capture_schedule.h"
#include "core/capture/devices/device_access.h"
#include "core/capture/image_reader.h"
#include "core/capture/image_shape.h"
#include "core/capture/video_reader.h"
#include "core/project/project_format.h"
#include "core/setup/new_project/project_devices.h"

#include <fmt/format.h>

#include <algorithm>
#include <filesystem>
#include <set>

namespace dewpoint::setup {
namespace {

namespace fs = std::filesystem;

bool isRecorded(const ProjectCamera& camera) {
  return camera.source == SourceKind::Video || camera.source == SourceKind::Images;
}

bool isOfDevice(const ProjectCamera& camera) {
  return camera.source == SourceKind::Device;
}

const char* sourceKey(SourceKind source) {
  const auto* const found =
      std::ranges::find(kSourceKeys, source, &std::pair<const char*, SourceKind>::second);
  return found != kSourceKeys.end() ? found->first : "video";
}

std::string sizeText(int width, int height) {
  return fmt::format("{} x {}", width, height);
}

/// The name of the file after which an image is missing.
std::string fileBeforeGap(const FrameReader& reader,
                          const std::vector<std::int64_t>& sequenceNumbers) {
  std::int64_t number = 0;
  while (sequenceNumbers[static_cast<std::size_t>(number)] == number) {
    ++number;
  }
  return fs::path(reader.fileOf(number - 1)).filename().string();
}

/// One recording, frame by frame.
class RecordingCheck {
public:
  RecordingCheck(Examination& examination, std::size_t camera)
      : examination_(examination), number_(camera), camera_(examination.project.cameras[camera]),
        footage_(examination.footage[camera]), name_(examination.nameOf(camera)),
        field_(cameraKey(camera, sourceKey(camera_.source))) {}

  void run() {
    std::error_code problem;
    if (!fs::exists(camera_.location, problem)) {
      examination_.add(FindingKind::RecordingMissing, {name_, camera_.location}, field_);
      return;
    }
    auto reader = camera_.source == SourceKind::Video
                      ? openVideoReader(camera_.location, "",
                                        readRecordedStamps(
                                            camera_.captureTimeFile,
                                            captureTimeIds(camera_.camera.name, camera_.location)))
                      : openImageFolderReader(camera_.location, "");
    if (!reader) {
      examination_.addForFile(camera_.location, FindingKind::RecordingUnreadable,
                              {name_, messageWithoutFile(reader.error())});
      return;
    }
    footage_.frameCount = (*reader)->frameCount();
    footage_.framesPerSecond = (*reader)->framesPerSecond();
    footage_.sequenceNumbers = (*reader)->sequenceNumbers();
    if (!take(**reader, 0)) {
      return; // what is not an image at its beginning is none
    }
    footage_.isOpen = true;
    checkSize();
    checkRest(**reader);
    checkGaps(**reader);
    if (!hasFault_) {
      addFineFinding();
    }
  }

private:
  ImageShape shape() const {
    return {"", camera_.rotateDegrees, 0, 0, camera_.isMirrored, camera_.crop};
  }

  /// Reads a frame and keeps its image. False: it could not be read, which was reported.
  bool take(FrameReader& reader, std::int64_t frame) {
    auto image = readAs(reader, frame);
    if (!image) {
      return false;
    }
    if (!image->empty()) {
      footage_.size = image->size();
      footage_.images.push_back(std::move(*image));
    }
    return true;
  }

  Result<cv::Mat> readAs(FrameReader& reader, std::int64_t frame) {
    auto picture = reader.read(frame);
    if (picture && !picture->empty()) {
      picture = prepareImage(*picture, shape(), reader.fileOf(frame)).map([](const cv::Mat& image) {
        return image.clone();
      });
    }
    if (!picture) {
      hasFault_ = true;
      const bool isEnd = picture.error().code == ErrorCode::EndedEarly;
      const auto kind = isEnd ? FindingKind::VideoCutOff : FindingKind::FrameUnreadable;
      const std::string detail = messageWithoutFile(picture.error());
      examination_.addForFile(reader.fileOf(frame), kind,
                              isEnd ? std::vector{name_, detail}
                                    : std::vector{name_, std::to_string(frame), detail});
    }
    return picture;
  }

  void checkRest(FrameReader& reader) {
    const std::int64_t last = footage_.frameCount - 1;
    std::set<std::int64_t> kept{last / 2, last};
    kept.erase(0);
    for (std::int64_t frame = 1; frame <= last; ++frame) {
      const bool isKept = kept.contains(frame);
      if (!isKept && !examination_.options.decodesEveryFrame) {
        continue;
      }
      if (!(isKept ? take(reader, frame) : readAs(reader, frame).has_value())) {
        return;
      }
      if (examination_.options.decodesEveryFrame && !reportProgress(frame)) {
        return;
      }
    }
  }

  bool reportProgress(std::int64_t frame) const {
    const double part = static_cast<double>(frame) / static_cast<double>(footage_.frameCount);
    const auto cameras = static_cast<double>(examination_.footage.size());
    return examination_.options.shouldContinue((static_cast<double>(number_) + part) / cameras);
  }

  void checkSize() {
    const Intrinsics& wanted = camera_.camera.intrinsics;
    const cv::Size size = footage_.size;
    if (wanted.width == 0 || size == cv::Size(wanted.width, wanted.height)) {
      return;
    }
    hasFault_ = true;
    const bool isTurned = size == cv::Size(wanted.height, wanted.width);
    examination_.add(
        isTurned ? FindingKind::SizeRotated : FindingKind::SizeDiffers,
        {name_, sizeText(size.width, size.height), sizeText(wanted.width, wanted.height)},
        cameraKey(number_, isTurned ? "rotate" : "calibration.size"));
  }

  void checkGaps(const FrameReader& reader) {
    const std::int64_t length =
        CaptureSchedule::frameSetCountOf({footage_.frameCount, 0.0, {}, footage_.sequenceNumbers});
    if (length > footage_.frameCount && camera_.captureTimeFile.empty()) {
      hasFault_ = true;
      examination_.addForFile(camera_.location, FindingKind::ImagesMissing,
                              {name_, std::to_string(length - footage_.frameCount),
                               std::to_string(length),
                               fileBeforeGap(reader, footage_.sequenceNumbers)});
    }
  }

  void addFineFinding() {
    examination_.add(FindingKind::RecordingFine,
                     {name_, std::to_string(footage_.frameCount),
                      sizeText(footage_.size.width, footage_.size.height),
                      footage_.framesPerSecond > 0.0
                          ? fmt::format("{:.4g} per second", footage_.framesPerSecond)
                          : std::string("no rate stated")},
                     field_);
  }

  Examination& examination_;
  std::size_t number_;
  const ProjectCamera& camera_;
  CameraFootage& footage_;
  std::string name_;
  std::string field_;
  bool hasFault_ = false;
};

void checkLive(Examination& examination, std::size_t number) {
  const ProjectCamera& camera = examination.project.cameras[number];
  const std::string name = examination.nameOf(number);
  const std::string field = cameraKey(number, sourceKey(camera.source));
  if (camera.source == SourceKind::Stream) {
    examination.add(FindingKind::StreamNotTested, {name}, field);
    return;
  }
  if (!camera.device.identity.isEmpty()) {
    const auto devices = systemDevices()->listDevices();
    const bool isConnected =
        matchProjectDevices(examination.project, devices).at(number).deviceIndex.has_value();
    examination.add(isConnected ? FindingKind::DeviceFound : FindingKind::DeviceMissing,
                    isConnected ? std::vector{name}
                                : std::vector{name, describe(camera.device.identity)},
                    field);
    return;
  }
  std::error_code problem;
  const std::string file =
      camera.location.starts_with('/') ? camera.location : "/dev/video" + camera.location;
  const bool isThere = fs::exists(file, problem);
  examination.add(isThere ? FindingKind::DeviceFound : FindingKind::DeviceMissing,
                  isThere ? std::vector{name} : std::vector{name, file}, field);
}

void checkBackgroundImage(Examination& examination, std::size_t number) {
  const ProjectCamera& camera = examination.project.cameras[number];
  if (camera.backgroundImageFile.empty()) {
    return;
  }
  const Intrinsics& size = camera.camera.intrinsics;
  const auto read = readBackgroundImage(
      camera.backgroundImageFile,
      {"", camera.rotateDegrees, size.width, size.height, camera.isMirrored, camera.crop});
  if (!read) {
    examination.addForFile(camera.backgroundImageFile, FindingKind::BackgroundImageUnusable,
                           {examination.nameOf(number), messageWithoutFile(read.error())});
  }
}

/// The first, the middle and the last images of a simulated scene.
void takeSceneImages(Examination& examination) {
  if (!examination.options.open) {
    return;
  }
  auto source = examination.options.open(examination.project);
  if (!source) {
    examination.add(FindingKind::CannotOpen, {errorSentence(source.error())});
    return;
  }
  const std::int64_t frames = (*source)->frameCount().value_or(1);
  for (const std::int64_t frame : std::set<std::int64_t>{0, frames / 2, frames - 1}) {
    const auto set = (*source)->seek(frame).and_then([&] { return (*source)->next(); });
    for (std::size_t k = 0; set && *set && k < examination.footage.size(); ++k) {
      CameraFootage& footage = examination.footage[k];
      const FramePtr& image = (*set)->frames[k];
      if (image) {
        footage.isOpen = true;
        footage.frameCount = frames;
        footage.framesPerSecond = (*source)->framesPerSecond();
        footage.size = image->image.size();
        footage.images.push_back(image->image);
      }
    }
  }
}

void compareLengths(Examination& examination) {
  std::int64_t least = 0;
  std::int64_t most = 0;
  std::string list;
  for (std::size_t k = 0; k < examination.footage.size(); ++k) {
    const CameraFootage& footage = examination.footage[k];
    if (!footage.isOpen || !examination.project.cameras[k].captureTimeFile.empty()) {
      continue;
    }
    const std::int64_t length =
        CaptureSchedule::frameSetCountOf({footage.frameCount, 0.0, {}, footage.sequenceNumbers});
    least = list.empty() ? length : std::min(least, length);
    most = std::max(most, length);
    list += fmt::format("{}{} {}", list.empty() ? "" : ", ", examination.nameOf(k), length);
  }
  if (least != most) {
    examination.add(FindingKind::LengthsDiffer, {list, std::to_string(least)});
  }
}

} // namespace

void checkRecordings(Examination& examination) {
  const auto& cameras = examination.project.cameras;
  const auto simulated =
      std::ranges::count(cameras, SourceKind::Simulation, &ProjectCamera::source);
  const auto recorded = std::ranges::count_if(cameras, isRecorded);
  if (simulated > 0) {
    examination.add(FindingKind::SceneCameras, {std::to_string(simulated)}, "scene");
    takeSceneImages(examination);
  } else if (recorded > 0 && recorded < std::ssize(cameras)) {
    examination.add(FindingKind::MixedSources, {}, "camera");
  }
  for (std::size_t k = 0; k < cameras.size(); ++k) {
    if (isRecorded(cameras[k])) {
      RecordingCheck(examination, k).run();
    } else if (isOfDevice(cameras[k]) || cameras[k].source == SourceKind::Stream) {
      checkLive(examination, k);
    }
    checkBackgroundImage(examination, k);
  }
  if (simulated == 0) {
    compareLengths(examination);
  }
}

} // namespace dewpoint::setup
