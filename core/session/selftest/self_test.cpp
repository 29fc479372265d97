// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/session/selftest/self_test.h"

#include "core/base/thread_count.h"
#include "core/base/units.h"
#include "core/capture/codec_check.h"
#include "core/session/recorded_run.h"
#include "core/session/run/tracking_clock.h"
#include "core/trajectory/evaluation.h"

#include <Eigen/Core>
#include <fmt/format.h>
#include <opencv2/core/version.hpp>

#include <algorithm>
#include <array>
#include <ceres/version.h>
#include <thread>
#include <unistd.h>

namespace dewpoint::session {
namespace {

using enum FindingLevel;
using SelfTestLines = std::vector<SelfTestLine>;

constexpr double kBytesPerGigabyte = 1e9;
constexpr double kLittleMemory = 2.0;   ///< GB in all
constexpr double kLittleDisk = 1.0;     ///< GB that are free
constexpr double kNoDisk = 0.1;         ///< GB that are free
constexpr double kLargestError = 0.005; ///< meters: several times that of the demo
constexpr double kUsualRate = 30.0;     ///< frames per second of ordinary cameras

void addVersions(const SelfTestInputs& /*parts*/, SelfTestLines& lines) {
  lines.push_back({Ok, "versions",
                   fmt::format("Dewpoint {}, OpenCV {}, Eigen {}.{}.{}, Ceres {}", DEWPOINT_VERSION,
                               CV_VERSION, EIGEN_WORLD_VERSION, EIGEN_MAJOR_VERSION,
                               EIGEN_MINOR_VERSION, CERES_VERSION_STRING)});
}

void addMachine(const SelfTestInputs& /*parts*/, SelfTestLines& lines) {
  const double memory = static_cast<double>(::sysconf(_SC_PHYS_PAGES)) *
                        static_cast<double>(::sysconf(_SC_PAGESIZE)) / kBytesPerGigabyte;
  lines.push_back(
      {memory < kLittleMemory ? Note : Ok, "computer",
       fmt::format("{} cores, {:.1f} GB of memory{}", std::thread::hardware_concurrency(), memory,
                   memory < kLittleMemory ? "; long live runs may need more" : "")});
}

void addDisk(const SelfTestInputs& parts, SelfTestLines& lines) {
  std::error_code problem;
  const auto space = std::filesystem::space(parts.scratchFolder, problem);
  if (problem) {
    lines.push_back({Problem, "disk",
                     fmt::format("nothing can be written to {}: {}", parts.scratchFolder.string(),
                                 problem.message())});
    return;
  }
  const double free = static_cast<double>(space.available) / kBytesPerGigabyte;
  lines.push_back(
      {free < kNoDisk       ? Problem
       : free < kLittleDisk ? Note
                            : Ok,
       "disk",
       fmt::format("{:.1f} GB are free in {}", free, parts.scratchFolder.parent_path().string())});
}

void addCameras(const SelfTestInputs& parts, SelfTestLines& lines) {
  if (parts.cameraNames.empty()) {
    lines.push_back(
        {Note, "cameras", "no camera is connected (/dev/video*); recordings can still be used"});
  }
  for (const std::string& camera : parts.cameraNames) {
    const bool isAllowed = ::access(camera.c_str(), R_OK | W_OK) == 0;
    lines.push_back({isAllowed ? Ok : Problem, "camera " + camera,
                     isAllowed ? "it is connected (it was not opened)"
                               : "no permission to open it; add yourself to the group video"});
  }
}

void addCodecs(const SelfTestInputs& parts, SelfTestLines& lines) {
  for (const CodecOutcome& codec : checkCodecs(parts.scratchFolder)) {
    SelfTestLine line{Ok, "codec " + codec.name, "written and read back"};
    if (codec.isMissing) {
      line.level = Note;
      line.text = "this computer cannot write it; reading was not tested";
    } else if (!codec.problem.empty()) {
      line.level = codec.isNeeded ? Problem : Note;
      line.text = codec.problem;
    } else if (codec.isLossless) {
      line.text += ", the same bytes";
    }
    lines.push_back(std::move(line));
  }
}

/// What was tracked of a scene, and how fast without making its images.
struct SceneRun {
  RecordedRun run;
  double rate = 0.0; ///< frames per second
};

Result<SceneRun> trackScene(SessionInputs& inputs, const std::function<bool()>& shouldContinue) {
  TrackingClock clock;
  const std::array<FrameObserver*, 1> observers{&clock};
  const auto frames =
      static_cast<std::int64_t>(kSelfTestSeconds * inputs.source->framesPerSecond());
  const RecordRunOptions order{
      .frames = {0, frames}, .threadCount = threadCountForFilter(0), .observers = observers};
  auto run = recordRun(inputs.project, *inputs.source, inputs.backgroundImages, order,
                       [&](auto /*done*/, auto /*total*/) { return shouldContinue(); });
  if (!run || run->endError) {
    return tl::make_unexpected(run ? *run->endError : run.error());
  }
  const double seconds = clock.seconds();
  const double rate = seconds > 0.0 ? static_cast<double>(run->frameCount) / seconds : 0.0;
  return SceneRun{std::move(*run), rate};
}

SelfTestLine outcomeOf(const SceneRun& run, const std::vector<Evaluation>& targets) {
  double error = 0.0;
  std::int64_t lost = 0;
  for (const Evaluation& target : targets) {
    error = std::max(error, target.rmse);
    lost += target.lostFrameCount;
  }
  const bool isRight = error <= kLargestError && lost == 0;
  const bool isFast = run.rate >= kUsualRate;
  return {
      !isRight ? Problem
      : isFast ? Ok
               : Note,
      "tracking",
      fmt::format("{:.0f} s of a simulated scene at {:.0f} frames per second, RMSE {:.2f} mm{}{}",
                  kSelfTestSeconds, run.rate, inMillimeters(error),
                  isRight ? "" : "; the target was lost or the error is too large",
                  isFast ? "" : "; slower than ordinary cameras")};
}

void addTracking(const SelfTestInputs& parts, SelfTestLines& lines) {
  if (!parts.openScene) {
    return;
  }
  const auto line = parts.openScene().and_then([&](SessionInputs inputs) {
    return trackScene(inputs, parts.shouldContinue).and_then([&](const SceneRun& scene) {
      return evaluate(scene.run.trajectory, inputs.truth)
          .map([&](const std::vector<Evaluation>& targets) { return outcomeOf(scene, targets); });
    });
  });
  lines.push_back(line ? *line : SelfTestLine{Problem, "tracking", errorSentence(line.error())});
}

constexpr std::array kSelfTests{&addVersions, &addMachine, &addDisk,
                                &addCameras,  &addCodecs,  &addTracking};

} // namespace

std::vector<SelfTestLine> runSelfTest(const SelfTestInputs& parts) {
  std::error_code problem; // then the line about the disk says so
  std::filesystem::create_directories(parts.scratchFolder, problem);
  SelfTestLines lines;
  for (const auto& test : kSelfTests) {
    if (!parts.shouldContinue()) {
      break;
    }
    test(parts, lines);
  }
  std::filesystem::remove_all(parts.scratchFolder, problem);
  return lines;
}

std::string selfTestText(const SelfTestLine& line) {
  return fmt::format("{:<8} {}: {}", levelName(line.level), line.subject, line.text);
}

FindingLevel worstLevelOf(const std::vector<SelfTestLine>& lines) {
  return worstLevel(lines, &SelfTestLine::level);
}

} // namespace dewpoint::session
