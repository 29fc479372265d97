// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/calibration/planning/camera_placement.h"

#include "core/calibration/planning/rig_map.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <vector>

namespace dewpoint::calibration {
namespace {

constexpr int kAlong = 7;               // places along a wall
constexpr double kLowest = 0.5;         // of the walls' height
constexpr int kShrinkings = 5;          // of the steps
constexpr int kMostPlacementRounds = 6; // with steps of one size
constexpr double kSeen = 0.01;          // what being seen by one camera more is worth, up to two
constexpr double kInward = 0.25; // how far out in the volume the points lie that are looked at

/// Where a camera may hang, and what it looks at.
struct Mount {
  Eigen::Vector3d position;
  Eigen::Vector3d target;
  int normal; ///< axis that the wall or the ceiling lies across
};

class Search {
public:
  Search(const CameraRig& rig, const Camera& lens, const PlacementSettings& settings)
      : lens_(lens), settings_(settings),
        map_(gridOver(settings.volume, settings.cellCount), settings.pixelSigma),
        count_(rig.size()) {
    map_.setRig(rig);
    low_ = settings.volume.min();
    high_ = settings.volume.max();
    low_.head<2>().array() -= settings.wallDistance;
    high_.array() += settings.wallDistance;
    low_.z() += kLowest * (high_.z() - low_.z());
  }

  double within() const { return map_.fractionWithin(settings_.maxGoodSigma); }
  Camera cameraAt(const Mount& mount) const {
    Camera camera = lens_;
    camera.cameraFromWorld = lookAt(mount.position, mount.target);
    return camera;
  }
  double worth(const Mount& mount);
  std::vector<Mount> mounts() const;
  Mount improved(Mount best);

private:
  std::vector<Eigen::Vector3d> targets() const;
  Eigen::Vector3d clamped(const Eigen::Vector3d& position) const {
    return position.cwiseMax(low_).cwiseMin(high_);
  }

  const Camera& lens_;
  const PlacementSettings& settings_;
  UncertaintyMap map_;
  std::size_t count_;
  Eigen::Vector3d low_, high_; ///< of where cameras may hang
};

double Search::worth(const Mount& mount) {
  map_.setCamera(count_, cameraAt(mount));
  double sum = 0.0;
  for (std::size_t i = 0; i < map_.largestSigmas().size(); ++i) {
    const double ratio = double(map_.largestSigmas()[i]) / settings_.maxGoodSigma;
    sum += std::isnan(ratio) ? 0.0 : 1.0 / (1.0 + ratio * ratio);
    sum += kSeen * std::min<int>(map_.cameraCounts()[i], 2);
  }
  return sum / double(map_.largestSigmas().size());
}

std::vector<Eigen::Vector3d> Search::targets() const {
  const Eigen::Vector3d middle = settings_.volume.center();
  const Eigen::Vector3d size = settings_.volume.sizes();
  std::vector<Eigen::Vector3d> targets{middle};
  for (const double x : {-kInward, kInward}) {
    for (const double y : {-kInward, kInward}) {
      targets.push_back(middle + Eigen::Vector3d(x * size.x(), y * size.y(), -0.1 * size.z()));
    }
  }
  return targets;
}

std::vector<Mount> Search::mounts() const {
  std::vector<Mount> mounts;
  const auto add = [&](const Eigen::Array3d& share, int normal) {
    const Eigen::Vector3d position = low_ + (share * (high_ - low_).array()).matrix();
    for (const Eigen::Vector3d& target : targets()) {
      mounts.push_back({position, target, normal});
    }
  };
  for (int k = 0; k < kAlong; ++k) {
    const double along = double(k) / (kAlong - 1);
    for (const double up : {0.0, 0.5, 1.0}) {
      add({along, 0.0, up}, 1);
      add({along, 1.0, up}, 1);
      add({0.0, along, up}, 0);
      add({1.0, along, up}, 0);
    }
    for (int m = 1; m + 1 < kAlong; ++m) {
      if (k > 0 && k + 1 < kAlong) {
        add({along, double(m) / (kAlong - 1), 1.0}, 2);
      }
    }
  }
  return mounts;
}

/// Hooke and Jeeves' search without its pattern moves: along the wall, and of the point looked at.
Mount Search::improved(Mount best) {
  double value = worth(best);
  Eigen::Vector3d step = 0.5 * (high_ - low_) / (kAlong - 1);
  Eigen::Vector3d aim = 0.5 * kInward * settings_.volume.sizes();
  for (int shrinking = 0; shrinking < kShrinkings; ++shrinking, step *= 0.5, aim *= 0.5) {
    bool better = true;
    for (int round = 0; round < kMostPlacementRounds && better; ++round) {
      better = false;
      for (int way = 0; way < 12; ++way) {
        const int axis = way % 3;
        const double sign = way % 6 < 3 ? 1.0 : -1.0;
        Mount tried = best;
        if (way < 6) {
          tried.position[axis] += axis == best.normal ? 0.0 : sign * step[axis];
          tried.position = clamped(tried.position);
        } else {
          tried.target[axis] += sign * aim[axis];
        }
        if (const double found = worth(tried); found > value + 1e-9) {
          value = found;
          best = tried;
          better = true;
        }
      }
    }
  }
  return best;
}

Status check(const Camera& lens, const PlacementSettings& settings) {
  const auto bad = [](const char* field, const char* detail) {
    return failure(ErrorCode::BadValue, "", field, detail);
  };
  const Intrinsics& in = lens.intrinsics;
  if (settings.volume.isEmpty() || !(settings.volume.sizes().minCoeff() > 0.0)) {
    return bad("volume", "has no extent");
  }
  if (in.width <= 0 || in.height <= 0 || !(in.focalX > 0.0) || !(in.focalY > 0.0)) {
    return bad("lens", "has no image size or focal length");
  }
  if (!(settings.pixelSigma > 0.0) || !(settings.maxGoodSigma > 0.0)) {
    return bad("sigma", "must be positive");
  }
  return {};
}

double fractionWithin(const CameraRig& rig, const PlacementSettings& settings) {
  const VolumeGrid cells = gridOver(settings.volume, settings.reportedCellCount);
  return summaryOf(RigMapper().map(cells, settings.pixelSigma, rig), settings.maxGoodSigma)
      .fractionWithinLimit;
}

} // namespace

Camera placedInFarthestCorner(Camera camera, const CameraRig& rig,
                              const Eigen::AlignedBox3d& volume) {
  Eigen::Vector3d best = volume.max();
  double farthest = -1.0;
  for (int k = 4; k < 8; ++k) { // the upper corners
    const Eigen::Vector3d corner = volume.corner(static_cast<Eigen::AlignedBox3d::CornerType>(k));
    double nearest = std::numeric_limits<double>::max();
    for (const Camera& other : rig) {
      nearest = std::min(nearest, (other.center() - corner).norm());
    }
    if (nearest > farthest) {
      farthest = nearest;
      best = corner;
    }
  }
  camera.cameraFromWorld = lookAt(best, volume.center());
  return camera;
}

Camera idealCamera(const std::string& name, int width, int height, double fieldOfView) {
  Camera camera;
  camera.name = name;
  const double focal = 0.5 * width / std::tan(0.5 * fieldOfView);
  camera.intrinsics = {width, height, focal, focal, 0.5 * (width - 1), 0.5 * (height - 1)};
  return camera;
}

Result<PlacedCamera> placeCamera(const CameraRig& rig, const Camera& lens,
                                 const PlacementSettings& settings,
                                 const CalibrationProgress& progress) {
  if (auto status = check(lens, settings); !status) {
    return tl::unexpected(status.error());
  }
  Search search(rig, lens, settings);
  PlacedCamera result;
  result.goodVolumeFractionBefore = search.within();
  const std::vector<Mount> mounts = search.mounts();
  Mount best = mounts.front();
  double value = -1.0;
  for (std::size_t k = 0; k < mounts.size(); ++k) {
    if (!reportProgress(progress, CalibrationStage::PlacementSearch,
                        double(k) / double(mounts.size()))) {
      return canceledError();
    }
    if (const double found = search.worth(mounts[k]); found > value) {
      value = found;
      best = mounts[k];
    }
  }
  best = search.improved(best);
  (void)search.worth(best);
  result.camera = search.cameraAt(best);
  result.goodVolumeFractionAfter = search.within();
  if (settings.reportedCellCount > 0) {
    CameraRig with = rig;
    with.push_back(result.camera);
    result.goodVolumeFractionBefore = fractionWithin(rig, settings);
    result.goodVolumeFractionAfter = fractionWithin(with, settings);
  }
  return result;
}

} // namespace dewpoint::calibration
