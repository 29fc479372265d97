// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/setup/calibration/board_outcome.h"

#include "core/calibration/quality/board_accuracy.h"

#include <fmt/format.h>

#include <algorithm>
#include <cstddef>
#include <vector>

namespace dewpoint::setup {
namespace {

BoardReport extrinsicsReport(const BoardCalibrationRequest& request, const BoardOutcome& outcome) {
  BoardReport report = reportOf(request.board, *outcome.extrinsics);
  report.accuracyText = outcome.accuracySummary;
  for (const DetectedFault& fault : outcome.extrinsics->faults) {
    report.accuracyText += " " + fault.sentence;
  }
  return report;
}

std::string page(const BoardDetections& seen, const BoardCalibrationRequest& request,
                 const BoardOutcome& outcome) {
  std::vector<BoardReport> reports;
  if (outcome.extrinsics) {
    reports.push_back(extrinsicsReport(request, outcome));
  }
  if (outcome.lenses) {
    reports.push_back(reportOf(seen, request, *outcome.lenses));
  }
  return htmlText(reports);
}

void recordLenses(const LensesFromBoards& lenses, Project& project) {
  for (std::size_t k = 0; k < project.cameras.size(); ++k) {
    if (k < lenses.cameras.size() && lenses.cameras[k]) {
      ProjectCamera& camera = project.cameras[k];
      camera.calibrationRecord.lens = recordOfLens(camera.camera, CalibrationOrigin::Board,
                                                   lenses.cameras[k]->maxProjectionSigmaPx);
    }
  }
}

/// The camera that the others are placed by has no error of its own.
std::optional<double> positionError(double sigma) {
  return sigma > 0.0 ? std::optional(sigma) : std::nullopt;
}

/// The lenses that were estimated, of the cameras that poses were found of.
std::vector<const IntrinsicsResult*> lensesOf(const BoardOutcome& outcome,
                                              const ExtrinsicsResult& extrinsics) {
  std::vector<const IntrinsicsResult*> lenses;
  for (const BundleCamera& placed : extrinsics.problem.cameras) {
    const IntrinsicsResult*& lens = lenses.emplace_back(nullptr);
    for (std::size_t k = 0; outcome.lenses && k < outcome.lenses->cameras.size(); ++k) {
      if (outcome.lenses->cameras[k] && extrinsics.cameras[k].name == placed.camera.name) {
        lens = &*outcome.lenses->cameras[k];
      }
    }
  }
  return lenses;
}

/// Which cameras were placed by the board, and how well.
void recordPoses(const BoardCalibrationRequest& request, BoardOutcome& outcome) {
  const std::vector<CameraFit>& fits = outcome.extrinsics->cameraFits;
  for (std::size_t k = 0; k < std::min(fits.size(), outcome.project.cameras.size()); ++k) {
    ProjectCamera& camera = outcome.project.cameras[k];
    if (!fits[k].views.empty()) {
      camera.calibrationRecord.pose =
          recordOfPose(camera.camera, CalibrationOrigin::Board, positionError(fits[k].centerSigma));
    }
    if (fits[k].isLensRefined && !fits[k].views.empty()) {
      camera.calibrationRecord.lens = recordOfLens(camera.camera, CalibrationOrigin::Board);
    }
  }
  WorldRecord& world = outcome.project.worldRecord;
  world.scaleOrigin = CalibrationOrigin::Board;
  world.scaleError = outcome.accuracy ? outcome.accuracy->scaleError95 : std::nullopt;
  world.errorInsideVolume =
      outcome.accuracy ? std::optional(outcome.accuracy->positionError95) : std::nullopt;
  world.errorOutsideVolume =
      outcome.accuracy ? outcome.accuracy->outsidePositionError95 : std::nullopt;
  world.lengthCheck.reset();
  if (request.floorFrame) {
    world.floorOrigin = CalibrationOrigin::Board;
  }
}

/// Names the cameras whose lenses are known too badly for poses.
void addPoorLenses(const Project& project, ExtrinsicsResult& extrinsics) {
  for (std::size_t k = 0; k < std::min(project.cameras.size(), extrinsics.cameraFits.size()); ++k) {
    const ProjectCamera& camera = project.cameras[k];
    const auto& lens = camera.calibrationRecord.lens;
    const CameraFit& fit = extrinsics.cameraFits[k];
    if (fit.views.empty() || fit.isLensRefined || !lens || !describes(*lens, camera.camera) ||
        lens->error.value_or(0.0) <= kWorstRayPx) {
      continue;
    }
    extrinsics.notices.push_back(fmt::format(
        "the lens of '{}' is poorly known: a ray may be off by {:.0f} px (1 sigma) at the worst "
        "place in its image. Its pose, and positions seen there, may be further off than stated. "
        "Show it the board tilted, near, and in all parts of the image",
        camera.camera.name, *lens->error));
  }
}

Status addExtrinsics(const BoardDetections& seen, const BoardCalibrationRequest& request,
                     BoardOutcome& outcome, const CalibrationProgress& progress) {
  auto extrinsics = extrinsicsFromBoards(outcome.project, seen, request, progress);
  if (!extrinsics) {
    return tl::make_unexpected(extrinsics.error());
  }
  if (!reportProgress(progress, CalibrationStage::Assessment, 0.5)) {
    return canceledError();
  }
  const auto accuracy =
      assessBoard(*extrinsics, request.board, request.floorFrame, lensesOf(outcome, *extrinsics));
  if (accuracy) {
    setCameraSigmas(*accuracy, *extrinsics);
  }
  outcome.accuracy = accuracy ? std::optional(*accuracy) : std::nullopt;
  outcome.accuracySummary =
      accuracy ? accuracySummary(*accuracy) : "none; " + errorSentence(accuracy.error());
  addPoorLenses(outcome.project, *extrinsics);
  outcome.project = withCameras(std::move(outcome.project), extrinsics->cameras);
  outcome.extrinsics = std::move(*extrinsics);
  recordPoses(request, outcome);
  return {};
}

} // namespace

Result<BoardOutcome> calibrateFromBoards(const Project& project, const BoardDetections& seen,
                                         const BoardCalibrationRequest& request,
                                         const BoardGoal& goal,
                                         const CalibrationProgress& progress) {
  BoardOutcome outcome;
  outcome.project = project;
  if (goal.estimatesLenses) {
    auto lenses = intrinsicsFromBoards(seen, request, progress);
    if (!lenses) {
      return tl::make_unexpected(lenses.error());
    }
    outcome.project = withIntrinsics(std::move(outcome.project), lenses->cameras);
    recordLenses(*lenses, outcome.project);
    outcome.lenses = std::move(*lenses);
    for (const auto& camera : seen.cameras) {
      outcome.missedRuns.push_back(missedRuns(camera));
    }
  }
  const bool alone = project.cameras.size() < 2 && !request.floorFrame;
  if (goal.estimatesPoses && !(alone && goal.estimatesLenses)) {
    if (const auto found = addExtrinsics(seen, request, outcome, progress); !found) {
      if (!outcome.lenses || found.error().code == ErrorCode::Canceled) {
        return tl::make_unexpected(found.error());
      }
      outcome.extrinsicsError = found.error();
    }
  }
  outcome.report = page(seen, request, outcome);
  return outcome;
}

Result<BoardOutcome> calibrateFromBoards(const Project& project, FrameSetSource& source,
                                         const BoardCalibrationRequest& request,
                                         const BoardGoal& goal,
                                         const CalibrationProgress& progress) {
  return findBoards(project, source, request, progress).and_then([&](const BoardDetections& seen) {
    return calibrateFromBoards(project, seen, request, goal, progress);
  });
}

bool isDoubtful(const BoardOutcome& outcome) {
  return outcome.extrinsics && !outcome.extrinsics->faults.empty();
}

Project withOutcome(Project project, const BoardOutcome& outcome) {
  if (outcome.lenses) {
    project = withIntrinsics(std::move(project), outcome.lenses->cameras);
  }
  if (outcome.extrinsics) {
    project = withCameras(std::move(project), outcome.extrinsics->cameras);
    project.worldRecord = outcome.project.worldRecord;
  }
  // A record that is not about the numbers of this project says nothing.
  for (std::size_t k = 0; k < std::min(project.cameras.size(), outcome.project.cameras.size());
       ++k) {
    const CameraRecord& found = outcome.project.cameras[k].calibrationRecord;
    CameraRecord& record = project.cameras[k].calibrationRecord;
    record.lens = outcome.lenses || outcome.extrinsics ? found.lens : record.lens;
    record.pose = outcome.extrinsics ? found.pose : record.pose;
  }
  return project;
}

std::vector<std::string> outcomeRemarks(const BoardOutcome& outcome) {
  std::vector<std::string> remarks;
  if (outcome.lenses) {
    for (const Error& kept : outcome.lenses->keptIntrinsicsReasons) {
      remarks.push_back(keptIntrinsicsText(kept) + ".");
    }
  }
  if (outcome.extrinsicsError) {
    remarks.push_back("The poses of the cameras were not found: " +
                      errorSentence(*outcome.extrinsicsError) + ".");
  }
  if (outcome.extrinsics) {
    for (const std::string& notice : outcome.extrinsics->notices) {
      remarks.push_back(notice + ".");
    }
    for (const DetectedFault& fault : outcome.extrinsics->faults) {
      remarks.push_back(fault.sentence);
    }
  }
  return remarks;
}

} // namespace dewpoint::setup
