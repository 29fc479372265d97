// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/calibration/board/board_in_rig.h"

#include "core/calibration/board/view_fit.h"
#include "core/calibration/bundle/bundle_adjustment.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>

namespace dewpoint::calibration {
namespace {

/// Width of the loss, pixels. Chosen: several times the error of a corner.
constexpr double kLossWidth = 2.0;

using Seen = std::vector<std::optional<BoardDetection>>;

/// Root mean square error of all corners, pixels.
double errorOf(const Eigen::Isometry3d& worldFromBoard, const BoardDescription& board,
               const CameraRig& rig, const Seen& seen) {
  double sum = 0.0;
  std::size_t count = 0;
  for (std::size_t k = 0; k < rig.size(); ++k) {
    if (!seen[k]) {
      continue;
    }
    const ViewFit fit =
        fitView(board, {"", 0, *seen[k]}, rig[k], rig[k].cameraFromWorld * worldFromBoard);
    sum += fit.rmsPx * fit.rmsPx * static_cast<double>(seen[k]->ids.size());
    count += seen[k]->ids.size();
  }
  return count > 0 ? std::sqrt(sum / static_cast<double>(count))
                   : std::numeric_limits<double>::infinity();
}

/// A symmetric board may have been numbered from another corner in each camera: all are numbered as
/// they appear from the given pose.
Seen renumbered(const Eigen::Isometry3d& worldFromBoard, const BoardDescription& board,
                const CameraRig& rig, Seen seen) {
  for (std::size_t k = 0; k < rig.size(); ++k) {
    if (!seen[k]) {
      continue;
    }
    const BoardDetection original = *seen[k];
    double best = std::numeric_limits<double>::infinity();
    for (int turns = 0; turns < 4; turns += 4 / board.symmetryOrder()) {
      const BoardDetection turned = rotated(original, board, turns);
      const double error =
          fitView(board, {"", 0, turned}, rig[k], rig[k].cameraFromWorld * worldFromBoard).rmsPx;
      if (error < best) {
        best = error;
        seen[k] = turned;
      }
    }
  }
  return seen;
}

BundleProblem problemOf(const Eigen::Isometry3d& worldFromBoard, const BoardDescription& board,
                        const CameraRig& rig, const Seen& seen) {
  BundleProblem problem;
  problem.loss = RobustLoss::Huber;
  problem.lossWidth = kLossWidth;
  for (const Camera& camera : rig) {
    problem.cameras.push_back({camera, true});
  }
  BundleBody body{"board", BundleBody::Kind::Board};
  for (int id = 0; id < board.cornerCount(); ++id) {
    body.points.push_back(board.corner(id));
  }
  problem.bodies.push_back(body);
  BundleState state;
  state.isPositionKnown = true;
  state.worldFromBoard = worldFromBoard;
  problem.states.push_back(state);
  for (std::size_t k = 0; k < rig.size(); ++k) {
    for (std::size_t i = 0; seen[k] && i < seen[k]->ids.size(); ++i) {
      problem.observations.push_back(
          {k, 0, static_cast<std::size_t>(seen[k]->ids[i]), seen[k]->pixels[i]});
    }
  }
  return problem;
}

} // namespace

Result<BoardInRig> locateBoardInRig(const BoardDescription& board, const CameraRig& rig,
                                    const Seen& seen) {
  BoardInRig result;
  Seen counted(rig.size());
  std::optional<Eigen::Isometry3d> start;
  double best = std::numeric_limits<double>::infinity();
  for (std::size_t k = 0; k < rig.size() && k < seen.size(); ++k) {
    if (!seen[k] || !spansPlane(board, *seen[k])) {
      continue;
    }
    counted[k] = seen[k];
    result.cameras.push_back(k);
  }
  for (const std::size_t k : result.cameras) {
    const auto pose = boardPose(board, *counted[k], rig[k]);
    if (!pose) {
      continue;
    }
    const Eigen::Isometry3d world = rig[k].cameraFromWorld.inverse() * *pose;
    const double error = errorOf(world, board, rig, renumbered(world, board, rig, counted));
    if (error < best) {
      best = error;
      start = world;
    }
  }
  if (!start) {
    return failure(ErrorCode::NotFound, "", "board", "no camera sees enough corners of the board");
  }
  counted = renumbered(*start, board, rig, counted);
  const auto adjusted = adjustBundle(problemOf(*start, board, rig, counted));
  if (!adjusted) {
    return tl::make_unexpected(adjusted.error());
  }
  result.worldFromBoard = adjusted->states.front().worldFromBoard;
  result.rmsPx = errorOf(result.worldFromBoard, board, rig, counted);
  const double most = maxViewErrorPx(0.0, rig[result.cameras.front()].intrinsics);
  if (result.rmsPx > most) {
    return failure(ErrorCode::Mismatch, "", "board",
                   fmt::format("the corners of the board are {:.1f} px off: the calibration is "
                               "wrong, or the board was moved between the images",
                               result.rmsPx));
  }
  return result;
}

} // namespace dewpoint::calibration
