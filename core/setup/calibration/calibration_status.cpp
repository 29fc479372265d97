// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/setup/calibration/calibration_status.h"

#include "core/setup/calibration/world_step.h"
#include "core/setup/new_project/new_project.h"

#include <algorithm>

namespace dewpoint::setup {
namespace {

// Errors above which a part is poor. Chosen: each is about 1 % of a distance of 2 m, where a focal
// length of 1000 pixels is assumed.
constexpr double kPoorLens = 10.0; ///< pixels
constexpr double kPoorPose = 0.02; ///< meters

/// Numbers read from a file are given, whoever measured them.
KnowledgeLevel knowledgeFrom(CalibrationOrigin origin) {
  return origin == CalibrationOrigin::File ? KnowledgeLevel::Given : KnowledgeLevel::Measured;
}

template <class Record>
ItemStatus partStatus(const std::optional<Record>& record, const Camera& camera, bool isGuessed,
                      double poor) {
  if (record && describes(*record, camera)) {
    return {knowledgeFrom(record->origin), record->origin, record->error,
            record->error && *record->error > poor};
  }
  return {.knowledge = isGuessed ? KnowledgeLevel::Missing : KnowledgeLevel::Given};
}

CameraCalibrationStatus cameraStatus(const Project& project, std::size_t index) {
  const ProjectCamera& camera = project.cameras[index];
  CameraCalibrationStatus status;
  status.delaySeconds = camera.delay;
  if (camera.source == SourceKind::Simulation && !camera.hasOwnCalibration) {
    status.lens.knowledge = status.pose.knowledge = KnowledgeLevel::Measured;
    return status;
  }
  status.lens = partStatus(camera.calibrationRecord.lens, camera.camera,
                           hasGuessedLens(project, index), kPoorLens);
  status.pose = partStatus(camera.calibrationRecord.pose, camera.camera,
                           hasGuessedPose(project, index), kPoorPose);
  return status;
}

/// Scale and floor are those of the cameras' positions: they are not known better than the best
/// known of these, and not at all while one is guessed.
ItemStatus worldPart(const std::vector<CameraCalibrationStatus>& cameras,
                     const std::optional<CalibrationOrigin>& origin, bool survivesEditing) {
  KnowledgeLevel best = KnowledgeLevel::Missing;
  for (const CameraCalibrationStatus& camera : cameras) {
    if (camera.pose.knowledge == KnowledgeLevel::Missing) {
      return {};
    }
    best = std::max(best, camera.pose.knowledge);
  }
  ItemStatus status{.knowledge = best == KnowledgeLevel::Missing ? best : KnowledgeLevel::Given};
  if (origin && (best == KnowledgeLevel::Measured || survivesEditing)) {
    status.knowledge = knowledgeFrom(*origin);
    status.origin = origin;
  } else if (best == KnowledgeLevel::Measured && !origin) {
    status.knowledge =
        std::ranges::all_of(
            cameras, [](const CameraCalibrationStatus& camera) { return !camera.pose.origin; })
            ? KnowledgeLevel::Measured // simulated
            : KnowledgeLevel::Given;
  }
  return status;
}

} // namespace

CalibrationStatus calibrationStatus(const Project& project) {
  CalibrationStatus status;
  for (std::size_t k = 0; k < project.cameras.size(); ++k) {
    status.cameras.push_back(cameraStatus(project, k));
  }
  const WorldRecord& record = project.worldRecord;
  // Marks in the images set the world whatever the cameras come from.
  const auto isByMarks = [](const std::optional<CalibrationOrigin>& origin) {
    return origin == CalibrationOrigin::Marks;
  };
  status.scale = worldPart(status.cameras, record.scaleOrigin, isByMarks(record.scaleOrigin));
  status.floor = worldPart(status.cameras, record.floorOrigin, isByMarks(record.floorOrigin));
  if (status.scale.origin) {
    status.scale.error = record.scaleError;
  }
  status.isUpright = !canRotateUpright(project);
  if (!status.isUpright) {
    status.floor = {};
  }
  const bool isAllMeasured = !status.cameras.empty() &&
                             countKnownCameras(status, &CameraCalibrationStatus::pose,
                                               KnowledgeLevel::Measured) == status.cameras.size();
  status.errorInVolume = isAllMeasured ? record.errorInsideVolume : std::nullopt;
  status.errorOutsideVolume = isAllMeasured ? record.errorOutsideVolume : std::nullopt;
  status.lengthCheck =
      status.scale.knowledge == KnowledgeLevel::Missing ? std::nullopt : record.lengthCheck;
  return status;
}

const char* originText(const ItemStatus& part) {
  if (part.knowledge == KnowledgeLevel::Missing) {
    return "guessed";
  }
  if (!part.origin) {
    return part.knowledge == KnowledgeLevel::Measured ? "exact (simulated)" : "set by hand";
  }
  switch (*part.origin) {
  case CalibrationOrigin::Points:
    return "measured points";
  case CalibrationOrigin::Board:
    return "board";
  case CalibrationOrigin::Wand:
    return "wand";
  case CalibrationOrigin::File:
    return "from a file";
  case CalibrationOrigin::Marks:
    break;
  }
  return "points marked in the images";
}

std::size_t countKnownCameras(const CalibrationStatus& status,
                              ItemStatus CameraCalibrationStatus::*part, KnowledgeLevel least) {
  return static_cast<std::size_t>(
      std::ranges::count_if(status.cameras, [&](const CameraCalibrationStatus& camera) {
        const ItemStatus& known = camera.*part;
        const bool isPoor = least == KnowledgeLevel::Measured && known.isPoor;
        return known.knowledge >= least && !isPoor;
      }));
}

std::optional<double> worstError(const CalibrationStatus& status,
                                 ItemStatus CameraCalibrationStatus::*part) {
  std::optional<double> worst;
  for (const CameraCalibrationStatus& camera : status.cameras) {
    if (const auto& error = (camera.*part).error) {
      worst = std::max(worst.value_or(0.0), *error);
    }
  }
  return worst;
}

} // namespace dewpoint::setup
