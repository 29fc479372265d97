// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/setup/doctor/time_checks.h"

#include "core/capture/capture_schedule.h"
#include "core/capture/recording.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace dewpoint::setup {
namespace {

/// Seconds of delay above which a camera is rather wrong than late. A judgment: streams over a
/// network are late by up to some seconds.
constexpr double kUnusualDelay = 10.0;

std::string rateText(double rate) {
  return fmt::format("{:.4g}", rate);
}

bool isSameRate(double a, double b) {
  return std::abs(a - b) <= kRateTolerance * b;
}

void compareRates(Examination& examination) {
  std::string list;
  double first = 0.0;
  bool differ = false;
  const double stated = examination.project.framesPerSecond;
  bool isOverridden = false;
  for (std::size_t k = 0; k < examination.footage.size(); ++k) {
    const double rate = examination.footage[k].framesPerSecond;
    if (rate <= 0.0 || examination.footage[k].captureTimes) {
      continue;
    }
    first = first > 0.0 ? first : rate;
    differ = differ || !isSameRate(rate, first);
    list += fmt::format("{}{} {}", list.empty() ? "" : ", ", examination.nameOf(k), rateText(rate));
    if (stated > 0.0 && !isSameRate(rate, stated) && !isOverridden) {
      isOverridden = true;
      examination.add(FindingKind::RateOverridden,
                      {rateText(stated), examination.nameOf(k), rateText(rate)},
                      "frames_per_second");
    }
  }
  if (differ) {
    examination.add(FindingKind::RatesDiffer, {list});
  }
}

void noteAssumedRate(Examination& examination) {
  const auto tells = [](const CameraFootage& footage) {
    return footage.framesPerSecond > 0.0 || footage.captureTimes;
  };
  const auto isOpen = [](const CameraFootage& footage) { return footage.isOpen; };
  if (examination.project.framesPerSecond == 0.0 &&
      std::ranges::any_of(examination.footage, isOpen) &&
      std::ranges::none_of(examination.footage, tells)) {
    examination.add(FindingKind::RateAssumed, {rateText(kDefaultFramesPerSecond)},
                    "frames_per_second");
  }
}

/// Reads the tables of times, those that can be.
void readTables(Examination& examination) {
  const auto& cameras = examination.project.cameras;
  const bool any = std::ranges::any_of(
      cameras, [](const ProjectCamera& one) { return !one.captureTimeFile.empty(); });
  for (std::size_t k = 0; any && k < cameras.size(); ++k) {
    const ProjectCamera& camera = cameras[k];
    CameraFootage& footage = examination.footage[k];
    const std::string name = examination.nameOf(k);
    if (camera.captureTimeFile.empty()) {
      examination.add(FindingKind::TimesIncomplete, {name}, cameraKey(k, "times"));
      continue;
    }
    auto times = readCaptureTimes(camera.captureTimeFile,
                                  captureTimeIds(camera.camera.name, camera.location), "");
    if (!times) {
      examination.addForFile(camera.captureTimeFile, FindingKind::TimesUnusable,
                             {name, messageWithoutFile(times.error())});
      continue;
    }
    if (footage.isOpen && completenessOf(camera.captureTimeFile) == TableCompleteness::CutOff) {
      footage.frameCount = std::min<std::int64_t>(footage.frameCount, std::ssize(*times));
      times->resize(static_cast<std::size_t>(footage.frameCount));
    }
    if (footage.isOpen && std::ssize(*times) != footage.frameCount) {
      examination.addForFile(
          camera.captureTimeFile, FindingKind::TimesCountDiffers,
          {name, std::to_string(times->size()), std::to_string(footage.frameCount)});
    } else {
      footage.captureTimes = std::move(*times);
    }
  }
}

/// Whether the tables say that all cameras were recording at some time.
void compareTables(Examination& examination) {
  std::vector<CaptureSchedule::CameraImages> pictures;
  for (std::size_t k = 0; k < examination.footage.size(); ++k) {
    const CameraFootage& footage = examination.footage[k];
    if (!footage.captureTimes) {
      return;
    }
    pictures.push_back(
        {footage.frameCount, examination.project.cameras[k].delay, footage.captureTimes});
  }
  const double rate = pictures.empty() ? 0.0 : CaptureSchedule::highestRateOf(pictures);
  if (rate > 0.0 && CaptureSchedule(pictures, rate).frameCount() == 0) {
    examination.add(FindingKind::TimesApart, {}, "times");
  }
}

void checkDelays(Examination& examination) {
  for (std::size_t k = 0; k < examination.footage.size(); ++k) {
    const CameraFootage& footage = examination.footage[k];
    const double delay = examination.project.cameras[k].delay;
    const double rate = footage.framesPerSecond > 0.0 ? footage.framesPerSecond
                        : examination.project.framesPerSecond > 0.0
                            ? examination.project.framesPerSecond
                            : kDefaultFramesPerSecond;
    const bool isTooLong = footage.isOpen && !footage.captureTimes &&
                           std::abs(delay) * rate >= static_cast<double>(footage.frameCount);
    if (isTooLong || std::abs(delay) > kUnusualDelay) {
      examination.add(isTooLong ? FindingKind::DelayTooLong : FindingKind::DelayUnusual,
                      {examination.nameOf(k), fmt::format("{:g}", delay)}, cameraKey(k, "late_by"));
    }
  }
}

} // namespace

void checkTimes(Examination& examination) {
  readTables(examination);
  compareTables(examination);
  compareRates(examination);
  noteAssumedRate(examination);
  checkDelays(examination);
}

} // namespace dewpoint::setup
