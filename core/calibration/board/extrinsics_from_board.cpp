// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/calibration/board/extrinsics_from_board.h"

#include "core/base/statistics.h"
#include "core/calibration/board/board_chain.h"
#include "core/calibration/board/intrinsics_covariance.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <set>

namespace dewpoint::calibration {
namespace {

// Tuned; where no source is named here or in the docs, the origin is not recorded.
/// Rounds of solving and leaving out views.
constexpr int kMostRounds = 5;
constexpr double kFirstLossWidth = 3.0; // pixels: corners of a wrong view must not pull
/// Width of the loss in typical residuals.
constexpr double kLossSigmas = 3.0;
constexpr double kLeastLossWidth = 0.3; // pixels

/// Columns of the covariance after the world was turned: the places of the cameras turn with it.
Eigen::MatrixXd rotatedColumns(const std::vector<CameraParameterColumn>& columns,
                               const Eigen::Matrix3d& turn) {
  const auto count = static_cast<Eigen::Index>(columns.size());
  Eigen::MatrixXd change = Eigen::MatrixXd::Identity(count, count);
  for (Eigen::Index k = 0; k + 2 < count; ++k) {
    if (columns[static_cast<std::size_t>(k)].quantity == CameraQuantity::CenterX) {
      change.block<3, 3>(k, k) = turn;
    }
  }
  return change;
}

/// Another world for everything that was adjusted.
void transformToWorld(const Eigen::Isometry3d& worldFromFirst, BundleProblem& problem,
                      BundleResult& result) {
  const Eigen::Isometry3d firstFromWorld = worldFromFirst.inverse();
  for (BundleCamera& camera : problem.cameras) {
    camera.camera.cameraFromWorld = camera.camera.cameraFromWorld * firstFromWorld;
  }
  for (Camera& camera : result.cameras) {
    camera.cameraFromWorld = camera.cameraFromWorld * firstFromWorld;
  }
  for (auto* states : {&problem.states, &result.states}) {
    for (BundleState& state : *states) {
      state.worldFromBoard = worldFromFirst * state.worldFromBoard;
    }
  }
  BundleCovariance& covariance = result.covariance;
  const Eigen::MatrixXd change = rotatedColumns(covariance.columns, worldFromFirst.linear());
  covariance.matrix = change * covariance.matrix * change.transpose();
}

/// Adjusts, leaves out the views that fit badly, and adjusts again until all fit.
class Extrinsics {
public:
  Extrinsics(const ExtrinsicsRequest& request, const CalibrationProgress& progress,
             BoardChain chain)
      : request_(request), progress_(progress), chain_(std::move(chain)),
        refined_(request.cameras.size(), request.refinesIntrinsics) {}

  Result<ExtrinsicsResult> run() {
    if (const auto solved = solve(); !solved) {
      return tl::make_unexpected(solved.error());
    }
    if (keepUndeterminedLenses()) {
      if (const auto solved = solve(); !solved) {
        return tl::make_unexpected(solved.error());
      }
    }
    return finished();
  }

private:
  Status solve() {
    double lossWidth = kFirstLossWidth;
    for (int round = 0; round < kMostRounds; ++round) {
      if (!reportProgress(progress_, CalibrationStage::Adjustment,
                          static_cast<double>(round) / kMostRounds)) {
        return canceledError();
      }
      if (auto adjusted = adjust(RobustLoss::Huber, lossWidth); !adjusted) {
        return tl::make_unexpected(adjusted.error());
      }
      const bool fewer = leaveOutBad();
      const double width = std::max(kLeastLossWidth, kLossSigmas * typicalResidual());
      const bool settled = !fewer && round > 0;
      lossWidth = width;
      if (settled) {
        break;
      }
    }
    markDoubtful(fits_);
    if (std::ranges::none_of(fits_, &ViewFit::isDoubtful)) {
      // Nothing is to be feared any more: plain least squares are the better estimate.
      return adjust(RobustLoss::None, lossWidth);
    }
    return {};
  }

  /// Returns whether a lens that may be off by `worst` pixels is no better than the given one.
  bool isLensUseless(std::size_t k, double worst) const {
    const BoardCamera& given = request_.cameras[k];
    const bool isKnownBetter =
        worst > kWorstRayPx && given.intrinsicsErrorPx && *given.intrinsicsErrorPx < worst;
    return isKnownBetter || !(worst <= kUndeterminedRayShare * given.camera.intrinsics.width);
  }

  /// Gives cameras back the lenses that they had, if their views do not determine better ones.
  /// Returns whether there are such cameras.
  bool keepUndeterminedLenses() {
    bool any = false;
    for (std::size_t k = 0; k < refined_.size(); ++k) {
      const double worst = refined_[k] ? worstRay(k) : 0.0;
      if (!refined_[k] || !isLensUseless(k, worst)) {
        continue;
      }
      any = true;
      refined_[k] = false;
      adjusted_[k].intrinsics = request_.cameras[k].camera.intrinsics;
      adjusted_[k].distortion = request_.cameras[k].camera.distortion;
      const std::string known =
          std::isfinite(worst)
              ? fmt::format("with those of these images, a ray would be off by {:.0f} px (1 sigma) "
                            "at the worst place",
                            worst)
              : std::string("these images do not determine them");
      chain_.notices.push_back(fmt::format("'{}' keeps its intrinsics: {}; show the board tilted, "
                                           "near, and in all parts of the image",
                                           request_.cameras[k].camera.name, known));
    }
    return any;
  }

  /// How far off a ray may be where it is known worst, if the lens comes from this camera's views.
  double worstRay(std::size_t k) const {
    std::vector<ViewFit> fits;
    for (std::size_t i = 0; i < fits_.size(); ++i) {
      if (chain_.views[i].camera == k) {
        fits.push_back(fits_[i]);
      }
    }
    const Camera& camera = adjusted_[k];
    const bool rational = std::any_of(camera.distortion.begin() + 5, camera.distortion.end(),
                                      [](double value) { return value != 0.0; });
    const IntrinsicsParameters parameters(camera.lens == LensModel::Fisheye
                                              ? IntrinsicsModel::Fisheye
                                          : rational ? IntrinsicsModel::EightCoefficients
                                                     : IntrinsicsModel::FiveCoefficients,
                                          camera.intrinsics.focalX == camera.intrinsics.focalY);
    return projectionSigma(camera, parameters,
                           intrinsicsCovariance(request_.board, camera, parameters, fits));
  }

  /// The problem with the views in use; what was found becomes the start of the next round.
  Status adjust(RobustLoss loss, double lossWidth) {
    BundleProblem problem;
    problem.loss = loss;
    problem.lossWidth = lossWidth;
    for (std::size_t k = 0; k < request_.cameras.size(); ++k) {
      BundleCamera camera;
      camera.camera = adjusted_.empty() ? request_.cameras[k].camera : adjusted_[k];
      camera.camera.cameraFromWorld = chain_.cameraFromFirstCamera[k];
      camera.isPoseFixed = k == 0;
      camera.isFocalFree = refined_[k];
      camera.isPrincipalPointFree = refined_[k];
      const auto& in = camera.camera.intrinsics;
      camera.isAspectFree = refined_[k] && in.focalX != in.focalY;
      for (std::size_t c = 0; c < camera.isDistortionFree.size(); ++c) {
        camera.isDistortionFree[c] = refined_[k] && camera.camera.distortion[c] != 0.0;
      }
      problem.cameras.push_back(camera);
    }
    BundleBody body{"board", BundleBody::Kind::Board};
    for (int id = 0; id < request_.board.cornerCount(); ++id) {
      body.points.push_back(request_.board.corner(id));
    }
    problem.bodies.push_back(body);
    std::map<std::int64_t, std::size_t> states;
    for (const PosedView& view : chain_.views) {
      states[view.view->instant] = 0;
    }
    for (auto& [instant, index] : states) { // in order of time, as the accuracy expects
      index = problem.states.size();
      BundleState state;
      state.time = static_cast<double>(index);
      state.isPositionKnown = true;
      state.worldFromBoard = chain_.firstCameraFromBoard[instant];
      problem.states.push_back(state);
    }
    for (const PosedView& view : chain_.views) {
      const std::int64_t instant = view.view->instant;
      for (std::size_t k = 0; k < view.detection.ids.size(); ++k) {
        problem.observations.push_back({view.camera, states[instant],
                                        static_cast<std::size_t>(view.detection.ids[k]),
                                        view.detection.pixels[k]});
      }
    }
    auto result = adjustBundle(problem, [&](const BundleProgress&) {
      return reportProgress(progress_, CalibrationStage::Adjustment, 0.5);
    });
    if (!result) {
      return tl::make_unexpected(result.error());
    }
    adjusted_ = result->cameras;
    for (std::size_t k = 0; k < adjusted_.size(); ++k) {
      chain_.cameraFromFirstCamera[k] = adjusted_[k].cameraFromWorld;
    }
    for (const auto& [instant, state] : states) {
      chain_.firstCameraFromBoard[instant] = result->states[state].worldFromBoard;
    }
    iterations_ += result->iterationCount;
    problem_ = std::move(problem);
    bundle_ = std::move(*result);
    refit();
    return {};
  }

  void refit() {
    fits_.clear();
    for (const PosedView& view : chain_.views) {
      BoardView counted = *view.view;
      counted.detection = view.detection;
      fits_.push_back(fitView(request_.board, counted, adjusted_[view.camera],
                              chain_.cameraFromFirstCamera[view.camera] *
                                  chain_.firstCameraFromBoard[view.view->instant]));
    }
  }

  bool leaveOutBad() {
    const double median = medianRms(fits_);
    std::vector<PosedView> good;
    std::vector<ViewFit> goodFits;
    for (std::size_t k = 0; k < chain_.views.size(); ++k) {
      const PosedView& view = chain_.views[k];
      if (fits_[k].rmsPx <= maxViewErrorPx(median, adjusted_[view.camera].intrinsics)) {
        good.push_back(view);
        goodFits.push_back(fits_[k]);
        continue;
      }
      auto left = leftOutView(
          *view.view,
          fmt::format(
              "the corners of this view are {:.2f} px off, those of the other views {:.2f} px",
              fits_[k].rmsPx, median));
      left.rmsPx = fits_[k].rmsPx;
      chain_.leftOutViews[view.camera].push_back(std::move(left));
    }
    const bool fewer = good.size() < chain_.views.size();
    chain_.views = std::move(good);
    fits_ = std::move(goodFits);
    return fewer;
  }

  /// Robust standard deviation of a coordinate of a corner: 1.48 times the median deviation.
  double typicalResidual() const {
    std::vector<double> sizes;
    for (const ViewFit& fit : fits_) {
      for (const Eigen::Vector2d& residual : fit.residuals) {
        sizes.push_back(std::abs(residual.x()));
        sizes.push_back(std::abs(residual.y()));
      }
    }
    return 1.4826 * upperMedian(std::move(sizes));
  }

  Result<Eigen::Isometry3d> worldFromFirst() const {
    if (!request_.worldDefiningInstant) {
      return request_.cameras.front().camera.cameraFromWorld.inverse();
    }
    std::set<std::int64_t> seen;
    for (const PosedView& view : chain_.views) {
      seen.insert(view.view->instant);
    }
    if (!seen.contains(*request_.worldDefiningInstant)) {
      return failure(
          ErrorCode::Undetermined, "", "world",
          fmt::format(
              "no camera saw the board well at {}, where it should define the world coordinates",
              *request_.worldDefiningInstant));
    }
    return request_.worldFromBoard *
           chain_.firstCameraFromBoard.at(*request_.worldDefiningInstant).inverse();
  }

  Result<ExtrinsicsResult> finished() {
    const auto world = worldFromFirst();
    if (!world) {
      return tl::make_unexpected(world.error());
    }
    markDoubtful(fits_);
    ExtrinsicsResult result;
    result.rmsPx = overallRms(fits_);
    result.iterationCount = iterations_;
    result.notices = chain_.notices;
    result.cameraFits.resize(adjusted_.size());
    for (std::size_t k = 0; k < adjusted_.size(); ++k) {
      Camera camera = adjusted_[k];
      camera.cameraFromWorld = chain_.cameraFromFirstCamera[k] * world->inverse();
      result.cameras.push_back(camera);
    }
    std::set<std::int64_t> seen;
    for (std::size_t k = 0; k < fits_.size(); ++k) {
      CameraFit& fit = result.cameraFits[chain_.views[k].camera];
      const auto& in = adjusted_[chain_.views[k].camera].intrinsics;
      fit.coverage.add(fits_[k].pixels, tiltOf(fits_[k].cameraFromBoard), in.width, in.height);
      fit.views.push_back(std::move(fits_[k]));
      seen.insert(fit.views.back().instant);
    }
    for (const std::int64_t instant : seen) {
      result.boardPoses.push_back({instant, *world * chain_.firstCameraFromBoard[instant]});
    }
    transformToWorld(*world, problem_, bundle_);
    result.covariance = bundle_.covariance;
    result.covariance.matrix *= bundle_.residualToSigmaRatio * bundle_.residualToSigmaRatio;
    for (std::size_t k = 0; k < result.cameraFits.size(); ++k) {
      CameraFit& fit = result.cameraFits[k];
      fit.isLensRefined = refined_[k];
      fit.rmsPx = overallRms(fit.views);
      fit.views.insert(fit.views.end(), chain_.leftOutViews[k].begin(),
                       chain_.leftOutViews[k].end());
      const auto& known = result.covariance;
      fit.centerSigma = centerSigma(known, k);
      fit.rotationSigma = rotationSigma(known, k);
    }
    result.problem = std::move(problem_);
    result.bundle = std::move(bundle_);
    return result;
  }

  const ExtrinsicsRequest& request_;
  const CalibrationProgress& progress_;
  BoardChain chain_;
  std::vector<bool> refined_; ///< cameras whose intrinsics are adjusted
  CameraRig adjusted_;
  std::vector<ViewFit> fits_; ///< of chain_.views, in their order
  BundleProblem problem_;     ///< of the last adjustment, in the first camera's frame
  BundleResult bundle_;
  int iterations_ = 0;
};

} // namespace

Result<ExtrinsicsResult> calibrateExtrinsics(const ExtrinsicsRequest& request,
                                             const CalibrationProgress& progress) {
  if (request.cameras.empty()) {
    return failure(ErrorCode::NotFound, "", "cameras", "there is none");
  }
  if (!reportProgress(progress, CalibrationStage::Chaining, 0.0)) {
    return canceledError();
  }
  auto chain = chainCameras(request);
  if (!chain) {
    return tl::make_unexpected(chain.error());
  }
  return Extrinsics(request, progress, std::move(*chain)).run();
}

} // namespace dewpoint::calibration
