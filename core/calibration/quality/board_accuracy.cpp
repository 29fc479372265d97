// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/calibration/quality/board_accuracy.h"

#include "core/base/statistics.h"
#include "core/calibration/board/intrinsics_covariance.h"
#include "core/calibration/formats/calibration_plausibility.h"
#include "core/geometry/projector.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>

namespace dewpoint::calibration {
namespace {

constexpr double kRulerSigma = 0.2e-3;      ///< meters
constexpr double kFlatnessSigma = 0.5e-3;   ///< meters
constexpr double kDerivativeStep = 1e-6;    ///< radians, meters: of derivatives
constexpr double kCornerSigma = 0.3;        ///< pixels
constexpr double kLeastCameraSpread = 0.01; ///< meters: cameras all in one place are not placed yet
/// An initial rig that leaves more than this, in pixels and in times of what the board itself
/// leaves, was no knowledge.
constexpr double kMostSigma = 1.0;
constexpr double kMostSigmas = 3.0;
/// A solution that leaves more than this has errors that boards share, as of late images of a board
/// that moves, or of poor lens data: corners are no independent witnesses then.
constexpr double kSharedErrors = 0.5; ///< pixels, per axis

/// A board's pose, rotated and moved a little in its own frame along one of six numbers.
Eigen::Isometry3d nudged(const Eigen::Isometry3d& pose, int number) {
  Eigen::Isometry3d change = Eigen::Isometry3d::Identity();
  if (number < 3) {
    change.linear() =
        Eigen::AngleAxisd(kDerivativeStep, Eigen::Vector3d::Unit(number)).toRotationMatrix();
  } else {
    change.translation() = kDerivativeStep * Eigen::Vector3d::Unit(number - 3);
  }
  return pose * change;
}

/// Adds what one camera's corners say about the pose of a board before it.
void addInformation(const BoardDescription& board, const Camera& camera, const ViewFit& view,
                    Eigen::Matrix<double, 6, 6>& information) {
  const auto pixelOf = [&](const Eigen::Isometry3d& pose, int id) {
    Camera placed = camera;
    placed.cameraFromWorld = pose;
    return Projector(placed).project(board.corner(id));
  };
  for (const int id : view.ids) {
    const auto here = pixelOf(view.cameraFromBoard, id);
    Eigen::Matrix<double, 2, 6> slope = Eigen::Matrix<double, 2, 6>::Zero();
    for (int number = 0; here && number < 6; ++number) {
      if (const auto there = pixelOf(nudged(view.cameraFromBoard, number), id)) {
        slope.col(number) = (*there - *here) / kDerivativeStep;
      }
    }
    information += slope.transpose() * slope;
  }
}

/// How well the normal of the board that lay on the floor is known; radians.
std::optional<double> upSigma(const ExtrinsicsResult& result, const BoardDescription& board,
                              std::int64_t instant) {
  Eigen::Matrix<double, 6, 6> information = Eigen::Matrix<double, 6, 6>::Zero();
  for (std::size_t k = 0; k < result.cameraFits.size(); ++k) {
    for (const ViewFit& view : result.cameraFits[k].views) {
      if (view.isUsed && view.instant == instant) {
        addInformation(board, result.cameras[k], view, information);
      }
    }
  }
  const Eigen::FullPivLU<Eigen::Matrix<double, 6, 6>> solver(information);
  if (!solver.isInvertible()) {
    return std::nullopt;
  }
  const Eigen::Matrix<double, 6, 6> covariance = solver.inverse();
  const double tilt =
      result.bundle.residualToSigmaRatio * std::sqrt(0.5 * (covariance(0, 0) + covariance(1, 1)));
  const double shorter =
      board.squareSize * std::max(1, std::min(board.cornerColumns(), board.cornerRows()) - 1);
  return std::hypot(tilt, kFlatnessSigma / (0.5 * shorter));
}

/// The cameras with the lenses that they would have without some of the instants.
CameraRig lensesWithout(const ExtrinsicsResult& result,
                        const std::vector<const IntrinsicsResult*>& lenses, std::size_t first,
                        std::size_t end) {
  using Limits = std::numeric_limits<std::int64_t>;
  const auto& poses = result.boardPoses;
  const std::int64_t from = first == 0 ? Limits::min() : poses[first].instant;
  const std::int64_t to = end < poses.size() ? poses[end].instant : Limits::max();
  CameraRig rig = result.bundle.cameras;
  for (std::size_t c = 0; c < std::min(rig.size(), lenses.size()); ++c) {
    if (lenses[c] != nullptr) {
      rig[c] = lensWithoutViews(*lenses[c], from, to);
    }
  }
  return rig;
}

/// What the views show, before anything is solved.
BundleProblem problemFromViews(const ExtrinsicsRequest& request, double framesPerSecond) {
  BundleProblem problem;
  BundleBody body{"board", BundleBody::Kind::Board};
  for (int id = 0; id < request.board.cornerCount(); ++id) {
    body.points.push_back(request.board.corner(id));
  }
  problem.bodies.push_back(std::move(body));
  std::map<std::int64_t, std::size_t> states;
  for (const BoardCamera& camera : request.cameras) {
    for (const BoardView& view : camera.views) {
      states[view.instant] = 0;
    }
  }
  for (auto& [instant, state] : states) {
    state = problem.states.size();
    problem.states.push_back({.time = static_cast<double>(instant) / framesPerSecond});
  }
  for (std::size_t k = 0; k < request.cameras.size(); ++k) {
    for (const BoardView& view : request.cameras[k].views) {
      for (std::size_t c = 0; c < view.detection.ids.size(); ++c) {
        BundleObservation seen;
        seen.camera = k;
        seen.state = states[view.instant];
        seen.point = static_cast<std::size_t>(view.detection.ids[c]);
        seen.pixel = view.detection.pixels[c];
        seen.sigma = kCornerSigma;
        problem.observations.push_back(seen);
      }
    }
  }
  return problem;
}

/// Frames between the instants.
double strideOf(const BundleProblem& problem, double framesPerSecond) {
  std::vector<double> gaps;
  for (std::size_t s = 1; s < problem.states.size(); ++s) {
    gaps.push_back((problem.states[s].time - problem.states[s - 1].time) * framesPerSecond);
  }
  return gaps.empty() ? 1.0 : std::round(upperMedian(gaps));
}

void countFrames(FaultReport& report, double stride, const ExtrinsicsRequest& request) {
  std::vector<std::string> names;
  for (const BoardCamera& camera : request.cameras) {
    names.push_back(camera.camera.name);
  }
  for (DetectedFault& fault : report.faults) {
    if (fault.fault == CalibrationFault::CameraDelayed) {
      fault.value *= stride;
      fault.sentence = faultDescription(fault, names);
    }
  }
}

} // namespace

Result<CalibrationAccuracy> assessBoard(const ExtrinsicsResult& result,
                                        const BoardDescription& board,
                                        std::optional<std::int64_t> worldDefiningInstant,
                                        const std::vector<const IntrinsicsResult*>& lenses) {
  AccuracyPriors known;
  known.scaleSigma =
      kRulerSigma / (board.squareSize * std::max(board.squareColumns(), board.squareRows()));
  known.upSigma =
      worldDefiningInstant ? upSigma(result, board, *worldDefiningInstant) : std::nullopt;
  const bool estimated = std::ranges::any_of(lenses, [](const auto* lens) { return lens; });
  if (estimated && result.boardPoses.size() == result.problem.states.size()) {
    known.estimateInitialCamerasWithoutStates = [&](std::size_t first, std::size_t end) {
      return lensesWithout(result, lenses, first, end);
    };
  }
  return assessCalibration(result.problem, result.bundle, known);
}

void setCameraSigmas(const CalibrationAccuracy& accuracy, ExtrinsicsResult& result) {
  for (std::size_t i = 0; i < accuracy.cameras.size(); ++i) {
    const std::string& name = result.problem.cameras.at(i).camera.name;
    for (std::size_t k = 0; k < result.cameras.size(); ++k) {
      if (result.cameras[k].name == name) {
        result.cameraFits[k].centerSigma = accuracy.cameras[i].positionSigma;
        result.cameraFits[k].rotationSigma = accuracy.cameras[i].rotationSigma;
      }
    }
  }
}

FaultReport findBoardFaults(const ExtrinsicsRequest& request, double framesPerSecond,
                            const ExtrinsicsResult* result) {
  const auto seeing = std::ranges::count_if(
      request.cameras, [](const BoardCamera& camera) { return !camera.views.empty(); });
  const bool alike = request.board.symmetryOrder() > 1; // only the solution tells how to count
  if (seeing < 2 || (alike && result == nullptr)) {
    return {};
  }
  FaultSearchInput input;
  input.problem = alike ? result->problem : problemFromViews(request, framesPerSecond);
  input.board = request.board;
  CameraRig former;
  for (const BoardCamera& camera : request.cameras) {
    former.push_back(camera.camera);
  }
  const auto ask = [&](const CameraRig& initialRig) {
    input.problem.cameras.clear();
    for (const Camera& camera : initialRig) {
      input.problem.cameras.push_back({.camera = camera});
    }
    auto report = findFaults(input);
    countFrames(report, alike ? 1.0 : strideOf(input.problem, framesPerSecond), request);
    return report;
  };
  const double own = result != nullptr ? result->rmsPx / std::sqrt(2.0) : kCornerSigma;
  input.isUnsynchronized = own > kSharedErrors;
  if (cameraSpread(former) > kLeastCameraSpread) {
    auto report = ask(former);
    if (report.sigmaPx > 0.0 && report.sigmaPx < std::max(kMostSigma, kMostSigmas * own)) {
      return report;
    }
  }
  return result != nullptr ? ask(result->cameras) : FaultReport{};
}

} // namespace dewpoint::calibration
