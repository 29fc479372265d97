// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/setup/calibration/calibration_guide.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>

namespace dewpoint::setup {
namespace {

StepProgress ofCameras(const CalibrationStatus& status, ItemStatus CameraCalibrationStatus::*part,
                       KnowledgeLevel least) {
  return {static_cast<int>(countKnownCameras(status, part, least)),
          std::max(1, static_cast<int>(status.cameras.size())), worstError(status, part)};
}

StepProgress ofPart(bool isDone, std::optional<double> error = {}) {
  return {isDone ? 1 : 0, 1, error};
}

/// Poses found in one way. Simulated cameras need none.
StepProgress ofOrigin(const CalibrationStatus& status, CalibrationOrigin origin) {
  StepProgress progress{0, std::max(1, static_cast<int>(status.cameras.size())), {}};
  for (const CameraCalibrationStatus& camera : status.cameras) {
    const bool isExact = camera.pose.knowledge == KnowledgeLevel::Measured && !camera.pose.origin;
    if ((camera.pose.origin == origin || isExact) && !camera.pose.isPoor) {
      ++progress.doneCount;
      if (camera.pose.error) {
        progress.error = std::max(progress.error.value_or(0.0), *camera.pose.error);
      }
    }
  }
  return progress;
}

/// Cameras with enough clicks.
StepProgress ofClicks(const Project& project) {
  std::vector<int> clicks(project.cameras.size(), 0);
  for (const MeasuredPoint& point : project.measuredPoints) {
    for (const PointClick& click : point.clicks) {
      if (const auto camera = static_cast<std::size_t>(click.camera); camera < clicks.size()) {
        ++clicks[camera];
      }
    }
  }
  const auto enough =
      std::ranges::count_if(clicks, [](int count) { return count >= kFewestPointsOfPose; });
  return {static_cast<int>(enough), std::max(1, static_cast<int>(clicks.size())), {}};
}

} // namespace

StepErrorUnit errorUnit(GuideStep step) {
  switch (step) {
  case GuideStep::LensesByBoard:
    return StepErrorUnit::Pixels;
  case GuideStep::BoardInVolume:
  case GuideStep::WaveWand:
    return StepErrorUnit::Meters;
  case GuideStep::MeasuredLength:
    return StepErrorUnit::Fraction;
  case GuideStep::ImportFile:
  case GuideStep::PrintBoard:
  case GuideStep::FieldOfView:
  case GuideStep::GridOnFloor:
  case GuideStep::MeasurePoints:
  case GuideStep::ComputeCameras:
  case GuideStep::RoughPositions:
  case GuideStep::LearnBall:
  case GuideStep::Floor:
    break;
  }
  return StepErrorUnit::None;
}

const std::vector<GuideStep>& stepsOf(CalibrationProcedure procedure) {
  using enum GuideStep;
  static const std::array<std::vector<GuideStep>, 5> kSteps{
      {{FieldOfView, GridOnFloor, MeasuredLength},
       {FieldOfView, MeasurePoints, ComputeCameras, MeasuredLength},
       {PrintBoard, LensesByBoard, BoardInVolume, Floor, MeasuredLength},
       {FieldOfView, RoughPositions, LearnBall, WaveWand, Floor, MeasuredLength},
       {ImportFile, Floor, MeasuredLength}}};
  return kSteps.at(static_cast<std::size_t>(procedure));
}

StepProgress progressOf(GuideStep step, const Project& project, const CalibrationStatus& status) {
  switch (step) {
  case GuideStep::ImportFile:
  case GuideStep::GridOnFloor:
  case GuideStep::RoughPositions: {
    StepProgress progress =
        ofCameras(status, &CameraCalibrationStatus::pose, KnowledgeLevel::Given);
    progress.error.reset();
    return progress;
  }
  case GuideStep::PrintBoard: // it was printed if it was seen
    return ofPart(std::ranges::any_of(status.cameras, [](const CameraCalibrationStatus& camera) {
      return camera.lens.knowledge == KnowledgeLevel::Measured ||
             camera.pose.origin == CalibrationOrigin::Board;
    }));
  case GuideStep::LensesByBoard:
    return ofCameras(status, &CameraCalibrationStatus::lens, KnowledgeLevel::Measured);
  case GuideStep::FieldOfView: {
    StepProgress progress =
        ofCameras(status, &CameraCalibrationStatus::lens, KnowledgeLevel::Given);
    progress.error.reset();
    return progress;
  }
  case GuideStep::MeasurePoints:
    return ofClicks(project);
  case GuideStep::ComputeCameras:
    return ofOrigin(status, CalibrationOrigin::Points);
  case GuideStep::BoardInVolume:
    return ofOrigin(status, CalibrationOrigin::Board);
  case GuideStep::LearnBall:
    return ofPart(!project.targets.empty());
  case GuideStep::WaveWand:
    return ofOrigin(status, CalibrationOrigin::Wand);
  case GuideStep::Floor:
    return ofPart(status.floor.knowledge == KnowledgeLevel::Measured);
  case GuideStep::MeasuredLength:
    break;
  }
  const auto& check = status.lengthCheck;
  return check && check->measuredLength > 0.0
             ? ofPart(true, std::abs(check->calibratedLength / check->measuredLength - 1.0))
             : ofPart(false);
}

GuideStep nextStep(CalibrationProcedure procedure, const Project& project,
                   const CalibrationStatus& status) {
  for (const GuideStep step : stepsOf(procedure)) {
    if (!progressOf(step, project, status).isDone()) {
      return step;
    }
  }
  return stepsOf(procedure).back();
}

std::optional<CalibrationProcedure> procedureInUse(const CalibrationStatus& status) {
  constexpr std::array<std::pair<CalibrationOrigin, CalibrationProcedure>, 4> kWays{
      {{CalibrationOrigin::Points, CalibrationProcedure::Points},
       {CalibrationOrigin::Board, CalibrationProcedure::Board},
       {CalibrationOrigin::Wand, CalibrationProcedure::Wand},
       {CalibrationOrigin::File, CalibrationProcedure::File}}};
  std::optional<CalibrationProcedure> most;
  std::ptrdiff_t count = 0;
  for (const auto& one : kWays) {
    const auto cameras =
        std::ranges::count_if(status.cameras, [&](const CameraCalibrationStatus& camera) {
          return camera.pose.origin == one.first;
        });
    if (cameras > count) {
      most = one.second;
      count = cameras;
    }
  }
  return most;
}

} // namespace dewpoint::setup
