// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/calibration/board/board_chain.h"

#include "core/geometry/rotation_vector.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>
#include <set>

namespace dewpoint::calibration {
namespace {

// Tuned; where no source is named here or in the docs, the origin is not recorded.
/// Radians (5 degrees) within which two rotations agree.
constexpr double kSameRotation = 5.0 * std::numbers::pi / 180.0;
constexpr double kSamePositionFraction = 0.1; // of the distance between camera and board
constexpr double kMostPosePart = 0.005;       // of the image's diagonal: 4 px of 640x480

/// Index into BoardChain::views by instant, for each camera.
using ViewIndex = std::vector<std::map<std::int64_t, std::size_t>>;

/// What two cameras say of each other at one instant.
struct PairPose {
  std::size_t one = 0;
  std::size_t other = 0;
  int turns = 0; ///< quarter turns of the board, as the other camera sees it
  Eigen::Isometry3d otherFromOne = Eigen::Isometry3d::Identity();
  double distance = 0.0; ///< between the other camera and the board
};

/// The relative pose of two cameras that most instants agree with.
struct PairLink {
  int support = 0;
  Eigen::Isometry3d otherFromOne = Eigen::Isometry3d::Identity();
  bool ambiguous = false; ///< another counting of the board has as many instants
};

bool posesAgree(const PairPose& one, const PairPose& other) {
  // As the first camera sees it; the second sees the same turn about another axis.
  const double turn =
      angleBetween(one.otherFromOne.linear().transpose(), other.otherFromOne.linear().transpose());
  const double apart = (one.otherFromOne.translation() - other.otherFromOne.translation()).norm();
  return turn < kSameRotation &&
         apart < kSamePositionFraction * std::max(one.distance, other.distance);
}

int turnStep(int symmetry) {
  return symmetry == 4 ? 1 : 2;
}

std::vector<PairPose> pairPoses(const ExtrinsicsRequest& request, const BoardChain& chain,
                                const ViewIndex& index, std::size_t one, std::size_t other) {
  std::vector<PairPose> poses;
  const int symmetry = request.board.symmetryOrder();
  for (const auto& [instant, at] : index[one]) {
    const auto found = index[other].find(instant);
    if (found == index[other].end()) {
      continue;
    }
    for (int k = 0; k < symmetry; ++k) {
      const PosedView rotated = rotatedView(request.board, request.cameras[other].camera,
                                            chain.views[found->second], k * turnStep(symmetry));
      PairPose pose{at, found->second, k * turnStep(symmetry)};
      pose.otherFromOne = rotated.cameraFromBoard * chain.views[at].cameraFromBoard.inverse();
      pose.distance = rotated.cameraFromBoard.translation().norm();
      poses.push_back(pose);
    }
  }
  return poses;
}

/// The pose that most others are like; among equals the one nearest to them.
PairLink linkOf(const std::vector<PairPose>& poses) {
  PairLink best;
  double bestSpread = std::numeric_limits<double>::max();
  const PairPose* bestPose = nullptr;
  std::vector<int> support(poses.size());
  for (std::size_t k = 0; k < poses.size(); ++k) {
    double spread = 0.0;
    for (const PairPose& other : poses) {
      if (posesAgree(poses[k], other)) {
        ++support[k];
        spread += (poses[k].otherFromOne.translation() - other.otherFromOne.translation()).norm();
      }
    }
    spread /= support[k];
    if (support[k] > best.support || (support[k] == best.support && spread < bestSpread)) {
      best.support = support[k];
      best.otherFromOne = poses[k].otherFromOne;
      bestSpread = spread;
      bestPose = &poses[k];
    }
  }
  for (std::size_t k = 0; k < poses.size(); ++k) {
    best.ambiguous =
        best.ambiguous || (support[k] == best.support && !posesAgree(poses[k], *bestPose));
  }
  return best;
}

void poseViews(const ExtrinsicsRequest& request, BoardChain& chain, ViewIndex& index) {
  chain.leftOutViews.resize(request.cameras.size());
  index.resize(request.cameras.size());
  for (std::size_t camera = 0; camera < request.cameras.size(); ++camera) {
    const auto& in = request.cameras[camera].camera.intrinsics;
    for (const BoardView& view : request.cameras[camera].views) {
      const auto pose = boardPose(request.board, view.detection, request.cameras[camera].camera);
      const double rms =
          pose ? fitView(request.board, view, request.cameras[camera].camera, *pose).rmsPx : 0.0;
      if (!pose) {
        chain.leftOutViews[camera].push_back(leftOutView(view, "too few corners are seen"));
      } else if (rms > kMostPosePart * std::hypot(in.width, in.height)) {
        chain.leftOutViews[camera].push_back(
            leftOutView(view, fmt::format("no board pose fits the corners within {:.1f} px", rms)));
      } else {
        index[camera][view.instant] = chain.views.size();
        chain.views.push_back({camera, &view, view.detection, *pose, rms});
      }
    }
  }
}

/// Cameras joined to the first by the links with most support (Prim's spanning tree).
Result<std::vector<Eigen::Isometry3d>>
spanningTreePoses(const ExtrinsicsRequest& request, const std::vector<std::vector<PairLink>>& links,
                  std::vector<std::string>& notices) {
  const std::size_t count = request.cameras.size();
  std::vector<Eigen::Isometry3d> poses(count, Eigen::Isometry3d::Identity());
  std::set<std::size_t> reached{0};
  const auto nameOf = [&](std::size_t k) { return request.cameras[k].camera.name; };
  while (reached.size() < count) {
    const PairLink* best = nullptr;
    std::pair<std::size_t, std::size_t> ends;
    for (const std::size_t from : reached) {
      for (std::size_t to = 0; to < count; ++to) {
        const PairLink& link = links[from][to];
        if (!reached.contains(to) && link.support > (best != nullptr ? best->support : 0)) {
          best = &link;
          ends = {from, to};
        }
      }
    }
    if (best == nullptr) {
      std::vector<std::string> missing;
      for (std::size_t k = 0; k < count; ++k) {
        if (!reached.contains(k)) {
          missing.push_back(fmt::format("'{}'", nameOf(k)));
        }
      }
      return failure(ErrorCode::Undetermined, "", "views",
                     fmt::format("{0} never see{1} the board in the same frame as '{2}' or as a "
                                 "camera that is linked to '{2}'",
                                 fmt::join(missing, ", "), missing.size() == 1 ? "s" : "",
                                 nameOf(0)));
    }
    if (best->ambiguous) {
      notices.push_back(
          fmt::format("The board looks the same when rotated by 180 degrees, so it is a guess that "
                      "'{}' and '{}' number its corners the same way. Show it in more positions",
                      nameOf(ends.first), nameOf(ends.second)));
    }
    poses[ends.second] = best->otherFromOne * poses[ends.first];
    reached.insert(ends.second);
  }
  return poses;
}

/// The board at each instant, from the view that fits it best with the others of that instant; and
/// each view counted as that place says.
void placeBoards(const ExtrinsicsRequest& request, BoardChain& chain) {
  std::map<std::int64_t, const PosedView*> best;
  for (const PosedView& view : chain.views) {
    const PosedView*& held = best[view.view->instant];
    // Large in the image is what makes a pose certain.
    const auto nearness = [&](const PosedView& posed) {
      return static_cast<double>(posed.detection.ids.size()) *
             request.cameras[posed.camera].camera.intrinsics.focalX /
             posed.cameraFromBoard.translation().norm();
    };
    if (held == nullptr || nearness(view) > nearness(*held)) {
      held = &view;
    }
  }
  for (const auto& [instant, view] : best) {
    chain.firstCameraFromBoard[instant] =
        chain.cameraFromFirstCamera[view->camera].inverse() * view->cameraFromBoard;
  }
  const int symmetry = request.board.symmetryOrder();
  for (PosedView& view : chain.views) {
    const Eigen::Isometry3d expected =
        chain.cameraFromFirstCamera[view.camera] * chain.firstCameraFromBoard[view.view->instant];
    PosedView nearest = view;
    double least = std::numeric_limits<double>::max();
    for (int k = 0; k < symmetry; ++k) {
      PosedView rotated = rotatedView(request.board, request.cameras[view.camera].camera, view,
                                      k * turnStep(symmetry));
      const double apart = (rotated.cameraFromBoard.linear() - expected.linear()).squaredNorm();
      if (apart < least) {
        least = apart;
        nearest = std::move(rotated);
      }
    }
    view = std::move(nearest);
  }
}

} // namespace

PosedView rotatedView(const BoardDescription& board, const Camera& camera, const PosedView& view,
                      int quarterTurns) {
  if (quarterTurns == 0) {
    return view;
  }
  PosedView result = view;
  result.detection = rotated(view.detection, board, quarterTurns);
  if (const auto pose = boardPose(board, result.detection, camera)) {
    result.cameraFromBoard = *pose;
  }
  return result;
}

Result<BoardChain> chainCameras(const ExtrinsicsRequest& request) {
  BoardChain chain;
  ViewIndex index;
  poseViews(request, chain, index);
  const std::size_t count = request.cameras.size();
  std::vector<std::vector<PairLink>> links(count, std::vector<PairLink>(count));
  for (std::size_t one = 0; one < count; ++one) {
    for (std::size_t other = one + 1; other < count; ++other) {
      const auto poses = pairPoses(request, chain, index, one, other);
      if (!poses.empty()) {
        links[one][other] = linkOf(poses);
        links[other][one] = links[one][other];
        links[other][one].otherFromOne = links[one][other].otherFromOne.inverse();
      }
    }
  }
  auto poses = spanningTreePoses(request, links, chain.notices);
  if (!poses) {
    return tl::make_unexpected(poses.error());
  }
  chain.cameraFromFirstCamera = std::move(*poses);
  placeBoards(request, chain);
  return chain;
}

} // namespace dewpoint::calibration
