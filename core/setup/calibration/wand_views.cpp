// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/setup/calibration/wand_views.h"

#include "core/calibration/quality/fault_finder.h"
#include "core/calibration/wand/time_offset_search.h"

#include <fmt/format.h>

#include <algorithm>
#include <utility>

namespace dewpoint::setup {
namespace {

Result<std::vector<const Target*>> selectedBalls(const Project& project,
                                                 const WandOptions& options) {
  std::vector<const Target*> balls;
  for (const std::string& name : options.targets) {
    const auto found = std::ranges::find(project.targets, name, &Target::name);
    if (found == project.targets.end()) {
      return failure(ErrorCode::NotFound, project.file.string(), "target", name);
    }
    balls.push_back(&*found);
  }
  if (balls.empty() && project.targets.size() == 1) {
    balls.push_back(&project.targets.front());
  }
  if (balls.empty()) {
    return failure(
        ErrorCode::MissingKey, project.file.string(), "target",
        fmt::format("the project has {} targets; select the ball, or both balls of a wand",
                    project.targets.size()));
  }
  if (balls.size() > 2 || (balls.size() == 2) != (options.stickLength > 0.0)) {
    return failure(ErrorCode::BadValue, project.file.string(), "target",
                   "a wand needs two balls and the distance between their centers, in meters");
  }
  return balls;
}

Result<std::vector<std::vector<MarkerObservation>>>
searchThrough(const Project& project, FrameSetSource& source, const WandOptions& options,
              const WandCalibrationCallback& callback) {
  const auto colors = wandColorClassifiers(project, options);
  if (!colors) {
    return tl::make_unexpected(colors.error());
  }
  if (source.isLive()) {
    return failure(ErrorCode::BadValue, project.file.string(), "camera",
                   "its cameras are live; record the wand first");
  }
  if (auto sought = source.seek(options.firstFrame); !sought) {
    return tl::make_unexpected(sought.error());
  }
  const std::int64_t end =
      std::min(options.endFrame.value_or(*source.frameCount()), *source.frameCount());
  WandViews views(project.cameras.size(), *colors);
  for (std::int64_t frame = options.firstFrame; frame < end; ++frame) {
    const auto frames = source.next();
    if (!frames) {
      return tl::make_unexpected(frames.error());
    }
    if (!*frames) {
      break;
    }
    views.add(**frames);
    if (callback && !callback({true, frame + 1 - options.firstFrame, end - options.firstFrame})) {
      return failure(ErrorCode::Canceled, "", "", "");
    }
  }
  return views.views();
}

} // namespace

WandViews::WandViews(std::size_t cameraCount, const std::vector<ColorClassifier>& balls)
    : finders_(balls.begin(), balls.end()), views_(cameraCount) {}

void WandViews::add(const FrameSet& frames) {
  ++frameSets_;
  for (std::size_t c = 0; c < std::min(views_.size(), frames.frames.size()); ++c) {
    if (frames.frames[c] == nullptr) {
      continue;
    }
    const Frame& frame = *frames.frames[c];
    for (std::size_t ball = 0; ball < finders_.size(); ++ball) {
      if (const auto found = finders_[ball].find(frame.image)) {
        views_[c].push_back({seconds(frame.captureTime), ball, found->outline.center,
                             found->outline.radius, found->sigma});
      }
    }
  }
}

std::vector<std::vector<MarkerObservation>> WandViews::takeViews() {
  return std::exchange(views_, std::vector<std::vector<MarkerObservation>>(views_.size()));
}

Result<WandProblem> makeWandProblem(const Project& project, const WandOptions& options) {
  const auto balls = selectedBalls(project, options);
  if (!balls) {
    return tl::make_unexpected(balls.error());
  }
  WandProblem problem;
  for (const ProjectCamera& camera : project.cameras) {
    problem.initialRig.push_back(camera.camera);
  }
  for (std::size_t ball = 0; ball < balls->size(); ++ball) {
    problem.ballRadii.at(ball) = (*balls)[ball]->radius;
  }
  problem.stickLength = options.stickLength;
  problem.scaleMethod = options.stickLength > 0.0  ? WandScale::Stick
                        : options.touchedDistance  ? WandScale::Distance
                        : options.usesBallDiameter ? WandScale::Diameter
                                                   : WandScale::InitialRig;
  problem.distance = options.touchedDistance.value_or(TouchedDistance{});
  problem.floorTimes = options.floorTimes;
  problem.freeFallSpan = options.freeFallSpan;
  problem.estimatesTimeOffsets = options.estimatesTimeOffsets;
  problem.estimatesFocalLengths = options.estimatesFocalLengths;
  problem.estimatesDistortion = options.estimatesDistortion;
  problem.initialPositionError = options.initialPositionError;
  problem.initialRotationError = options.initialRotationError;
  return problem;
}

Result<std::vector<ColorClassifier>> wandColorClassifiers(const Project& project,
                                                          const WandOptions& options) {
  return selectedBalls(project, options).map([](const std::vector<const Target*>& balls) {
    std::vector<ColorClassifier> colors;
    colors.reserve(balls.size());
    for (const Target* ball : balls) {
      colors.emplace_back(ball->colors());
    }
    return colors;
  });
}

Result<WandResult> calibrateFromViews(const Project& project,
                                      const std::vector<std::vector<MarkerObservation>>& views,
                                      const WandOptions& options,
                                      const WandCalibrationCallback& callback) {
  auto problem = makeWandProblem(project, options);
  if (!problem) {
    return tl::make_unexpected(problem.error());
  }
  problem->views = views;
  auto result = calibrateFromWand(*problem, [&](const WandProgress& now) {
    return !callback || callback({false, now.step, now.stepCount, now.rmsPx});
  });
  if (result && options.estimatesTimeOffsets) { // a camera that is late is none of the faults then
    problem->views = shiftedInTime(std::move(problem->views), result->timeOffsets);
  }
  const bool canceled = !result && result.error().code == ErrorCode::Canceled;
  const auto report = canceled ? FaultReport{} : findWandFaults(*problem).value_or(FaultReport{});
  if (result) {
    result->faults = report.faults;
  } else if (!report.faults.empty()) {
    result.error().detail += "; " + report.faults.front().sentence;
  }
  if (!result && result.error().file.empty()) {
    result.error().file = project.file.string();
  }
  return result;
}

Result<WandResult> calibrateFromRecording(const Project& project, FrameSetSource& source,
                                          const WandOptions& options,
                                          const WandCalibrationCallback& callback) {
  const auto views = searchThrough(project, source, options, callback);
  return views ? calibrateFromViews(project, *views, options, callback)
               : Result<WandResult>(tl::make_unexpected(views.error()));
}

} // namespace dewpoint::setup
