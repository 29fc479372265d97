// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/calibration/quality/missing_motion.h"

#include "core/base/statistics.h"
#include "core/base/units.h"
#include "core/calibration/board/board_coverage.h"
#include "core/calibration/quality/common_view.h"
#include "core/calibration/quality/position_error.h"
#include "core/geometry/image_bounds.h"
#include "core/geometry/projector.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <iterator>
#include <optional>
#include <set>
#include <utility>

namespace dewpoint::calibration {
namespace {

// Limits below which motion is missing. Chosen: waves through the volume of eight simulated rigs
// are above all of them (MissingMotion in the tests). By how much was not measured.
constexpr double kLeastSeconds = 10.0;
/// Extents of the ball's positions across a line or a plane, relative to the distance from the
/// cameras. The line must be several times as long as it is thick.
constexpr double kLeastAcross = 0.06;
constexpr double kLeastDepth = 0.12;  ///< range of distances from a camera over their median
constexpr double kLeastVolume = 0.02; ///< share of the volume that the cameras see together
constexpr double kLeastImage = 0.3;   ///< share of the regions of an image that show that volume
/// Share of the volume in view of either of two cameras that both must see to be compared, ...
constexpr double kSharedView = 0.2;
/// ... and share of the instants at which both must then see the ball.
constexpr double kLeastTogether = 0.05;
constexpr double kLeastInstants = 20.0; ///< at which two cameras must see it
constexpr double kOutlierShare = 0.05;  ///< of the positions, at each end
constexpr double kMiddleOfImage = 0.12; ///< of the image: nearer centers are no side
constexpr std::size_t kMostGaps = 2;

/// The range between the outer shares of the values.
std::pair<double, double> rangeOf(std::vector<double> values) {
  std::ranges::sort(values);
  return {quantile(values, kOutlierShare), quantile(values, 1.0 - kOutlierShare)};
}

/// The search in one result.
class MotionSearch {
public:
  explicit MotionSearch(const WandResult& result)
      : result_(result), rig_(result.bundle.cameras),
        positions_(observedPositions(result.problem, result.bundle)) {}

  std::vector<MotionGap> run() {
    if (positions_.size() < 4 || rig_.size() < 2) {
      return {};
    }
    box_ = principalBox(positions_, kOutlierShare);
    view_ = findCommonView(rig_, positions_);
    findDistances();
    addDuration();
    addShape();
    addImages();
    addPairs();
    std::ranges::stable_sort(
        gaps_, [](const MotionGap& a, const MotionGap& b) { return a.severity > b.severity; });
    gaps_.resize(std::min(gaps_.size(), kMostGaps));
    return std::move(gaps_);
  }

private:
  /// Adds a gap if `value` is below the least that is needed.
  bool add(MotionGap gap, double share, double least) {
    if (!(share < least)) {
      return false;
    }
    gap.severity = 1.0 - share / least;
    gaps_.push_back(std::move(gap));
    return true;
  }

  /// From the ball to each camera, along its optical axis.
  std::vector<double> depths(std::size_t camera) const {
    std::vector<double> all;
    for (const Eigen::Vector3d& position : positions_) {
      all.push_back((rig_[camera].cameraFromWorld * position).z());
    }
    return all;
  }

  void findDistances() {
    std::vector<double> distances;
    for (std::size_t c = 0; c < rig_.size(); ++c) {
      distances.push_back((rig_[c].center() - box_.center).norm());
    }
    distance_ = upperMedian(std::move(distances));
  }

  void addDuration() {
    std::vector<double> times;
    for (const BundleState& state : result_.bundle.states) {
      if (state.isPositionKnown) {
        times.push_back(state.time);
      }
    }
    const auto [first, last] = std::ranges::minmax_element(times);
    const double seconds = times.empty() ? 0.0 : *last - *first;
    add({.missingMotion = MissingMotion::Duration, .motionAmount = seconds}, seconds,
        kLeastSeconds);
  }

  /// A line, a plane, a small volume, or no depth: each of them explains the next ones.
  void addShape() {
    const Eigen::Vector3d extents = box_.extents();
    const auto across = [&](int axis) { return extents[axis] / std::max(distance_, 1e-9); };
    if (add({.missingMotion = MissingMotion::OffTheLine, .motionAmount = extents[1]}, across(1),
            kLeastAcross) ||
        add({.missingMotion = MissingMotion::OffThePlane,
             .cameras = {cameraAcross(box_.axes.col(2))},
             .motionAmount = extents[2]},
            across(2), kLeastAcross)) {
      return;
    }
    if (!view_.positions.empty()) {
      const Eigen::Vector3d all = principalBox(view_.positions, kOutlierShare).extents();
      const double share = extents.prod() / std::max(all.prod(), 1e-12);
      if (add({.missingMotion = MissingMotion::WholeVolume, .motionAmount = share}, share,
              kLeastVolume)) {
        return;
      }
    }
    for (std::size_t c = 0; c < rig_.size(); ++c) {
      auto all = depths(c);
      const auto [low, high] = rangeOf(all);
      const double range = high - low;
      add({.missingMotion = MissingMotion::InDepth, .cameras = {c}, .motionAmount = range},
          range / std::max(upperMedian(std::move(all)), 1e-9), kLeastDepth);
    }
  }

  /// The camera whose optical axis is nearest to a direction.
  std::size_t cameraAcross(const Eigen::Vector3d& direction) const {
    std::size_t best = 0;
    double most = -1.0;
    for (std::size_t c = 0; c < rig_.size(); ++c) {
      const double along = std::abs(rig_[c].cameraFromWorld.linear().row(2).dot(direction));
      if (along > most) {
        most = along;
        best = c;
      }
    }
    return best;
  }

  void addImages() {
    std::vector<BoardCoverage> seen(rig_.size());
    for (const BundleObservation& one : result_.problem.observations) {
      const Intrinsics& image = rig_[one.camera].intrinsics;
      ++seen[one.camera].cornerCounts.at(
          static_cast<std::size_t>(BoardCoverage::regionOf(one.pixel, image.width, image.height)));
    }
    for (std::size_t c = 0; c < rig_.size(); ++c) {
      addImage(c, seen[c]);
    }
  }

  void addImage(std::size_t camera, const BoardCoverage& seen) {
    const BoardCoverage visible = regionsOfView(camera);
    double covered = 0.0;
    double usable = 0.0;
    Eigen::Vector2d coveredMiddle = Eigen::Vector2d::Zero();
    Eigen::Vector2d usableMiddle = Eigen::Vector2d::Zero();
    for (std::size_t region = 0; region < visible.cornerCounts.size(); ++region) {
      if (visible.cornerCounts[region] == 0 && seen.cornerCounts[region] == 0) {
        continue;
      }
      const std::size_t row = region / BoardCoverage::kColumns;
      const std::size_t column = region % BoardCoverage::kColumns;
      const Eigen::Vector2d at((static_cast<double>(column) + 0.5) / BoardCoverage::kColumns,
                               (static_cast<double>(row) + 0.5) / BoardCoverage::kRows);
      usable += 1.0;
      usableMiddle += at;
      if (seen.cornerCounts[region] > 0) {
        covered += 1.0;
        coveredMiddle += at;
      }
    }
    if (covered == 0.0) {
      return; // the calibration of this camera has failed already
    }
    const Eigen::Vector2d toward = usableMiddle / usable - coveredMiddle / covered;
    add({.missingMotion = MissingMotion::WholeImage,
         .cameras = {camera},
         .motionAmount = covered / static_cast<double>(visible.cornerCounts.size()),
         .side = sideOf(toward)},
        covered / usable, kLeastImage);
  }

  static ImageSide sideOf(const Eigen::Vector2d& toward) {
    if (toward.cwiseAbs().maxCoeff() < kMiddleOfImage) {
      return ImageSide::Edges;
    }
    if (std::abs(toward.x()) > std::abs(toward.y())) {
      return toward.x() > 0.0 ? ImageSide::Right : ImageSide::Left;
    }
    return toward.y() > 0.0 ? ImageSide::Bottom : ImageSide::Top;
  }

  /// The regions of an image in which the volume lies that the camera sees with another one.
  BoardCoverage regionsOfView(std::size_t camera) const {
    BoardCoverage regions;
    const Projector projector(rig_[camera]);
    const Intrinsics& image = rig_[camera].intrinsics;
    for (std::size_t i = 0; i < view_.positions.size(); ++i) {
      if (std::ranges::find(view_.camerasPerPosition[i], camera) ==
          view_.camerasPerPosition[i].end()) {
        continue;
      }
      if (const auto pixel = projector.project(view_.positions[i])) {
        ++regions.cornerCounts.at(
            static_cast<std::size_t>(BoardCoverage::regionOf(*pixel, image.width, image.height)));
      }
    }
    return regions;
  }

  void addPairs() {
    std::vector<std::set<std::size_t>> instants(rig_.size());
    for (std::size_t i = 0; i < result_.problem.observations.size(); ++i) {
      if (std::isfinite(result_.bundle.residuals[i].norm())) {
        const BundleObservation& one = result_.problem.observations[i];
        instants[one.camera].insert(one.state);
      }
    }
    std::optional<MotionGap> worst;
    double worstShare = 0.0;
    for (std::size_t a = 0; a < rig_.size(); ++a) {
      for (std::size_t b = a + 1; b < rig_.size(); ++b) {
        if (!shareView(a, b)) {
          continue;
        }
        std::vector<std::size_t> both;
        std::ranges::set_intersection(instants[a], instants[b], std::back_inserter(both));
        const auto count = static_cast<double>(both.size());
        const auto either = static_cast<double>(std::min(instants[a].size(), instants[b].size()));
        const double share =
            std::min(count / kLeastInstants, count / std::max(kLeastTogether * either, 1e-9));
        if (!worst || share < worstShare) {
          worstShare = share;
          worst = MotionGap{.missingMotion = MissingMotion::SeenTogether,
                            .cameras = {a, b},
                            .motionAmount = count};
        }
      }
    }
    if (worst) {
      add(std::move(*worst), worstShare, 1.0);
    }
  }

  /// Whether two cameras see much of the common volume together.
  bool shareView(std::size_t a, std::size_t b) const {
    double both = 0.0;
    std::array<double, 2> each{};
    for (const auto& seeing : view_.camerasPerPosition) {
      const bool byA = std::ranges::find(seeing, a) != seeing.end();
      const bool byB = std::ranges::find(seeing, b) != seeing.end();
      each[0] += byA ? 1.0 : 0.0;
      each[1] += byB ? 1.0 : 0.0;
      both += byA && byB ? 1.0 : 0.0;
    }
    return both > kSharedView * std::max({each[0], each[1], 1.0});
  }

  const WandResult& result_;
  const CameraRig& rig_;
  std::vector<Eigen::Vector3d> positions_;
  PrincipalBox box_;
  CommonView view_;
  double distance_ = 0.0; ///< from the cameras to the ball, meters
  std::vector<MotionGap> gaps_;
};

const char* sideText(ImageSide side) {
  switch (side) {
  case ImageSide::Left:
    return "the left part of its image";
  case ImageSide::Right:
    return "the right part of its image";
  case ImageSide::Top:
    return "the upper part of its image";
  case ImageSide::Bottom:
    return "the lower part of its image";
  default:
    return "all edges of its image";
  }
}

} // namespace

std::vector<MotionGap> findMissingMotion(const WandResult& result) {
  return MotionSearch(result).run();
}

std::string motionGapText(const MotionGap& gap, const CameraRig& rig) {
  const auto name = [&](std::size_t k) {
    return k < gap.cameras.size() && gap.cameras[k] < rig.size() ? rig[gap.cameras[k]].name
                                                                 : std::string("a camera");
  };
  switch (gap.missingMotion) {
  case MissingMotion::Duration:
    return fmt::format("The ball was seen for only {:.0f} s. Wave for half a minute.",
                       gap.motionAmount);
  case MissingMotion::OffTheLine:
    return "The ball moved only along one line. Move it in all directions: to the sides, up and "
           "down, near and far.";
  case MissingMotion::OffThePlane:
    return fmt::format("The ball moved only within a plane ({:.0f} cm thick). Also move it across "
                       "this plane: toward {} and away from it.",
                       inCentimeters(gap.motionAmount), name(0));
  case MissingMotion::InDepth:
    return fmt::format("The distance from {0} to the ball hardly changed (by only {1:.0f} cm). "
                       "Also move the ball toward {0} and away from it.",
                       name(0), inCentimeters(gap.motionAmount));
  case MissingMotion::WholeVolume:
    return fmt::format("The ball stayed in {:.1f} % of the volume that the cameras see together. "
                       "Move it through the whole volume in which you will track.",
                       inPercent(gap.motionAmount));
  case MissingMotion::WholeImage:
    return fmt::format("{} saw the ball in only {:.0f} % of its image. Also move it to {}.",
                       name(0), inPercent(gap.motionAmount), sideText(gap.side));
  default:
    return fmt::format("{} and {} saw the ball at the same time in only {:.0f} frame{}. Move it "
                       "where both see it.",
                       name(0), name(1), gap.motionAmount, gap.motionAmount == 1.0 ? "" : "s");
  }
}

} // namespace dewpoint::calibration
