// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/calibration/board/intrinsics_from_board.h"

#include "core/calibration/board/intrinsics_covariance.h"
#include "core/calibration/board/opencv_pose.h"

#include <fmt/format.h>
#include <opencv2/calib3d.hpp>

#include <algorithm>
#include <cmath>

namespace dewpoint::calibration {
namespace {

// Tuned; where no source is named here or in the docs, the origin is not recorded.
/// Views that a lens needs.
constexpr std::size_t kLeastViews = 3;
/// Rounds of solving and leaving out views.
constexpr int kMostLensRounds = 10;
/// The pixels' aspect is not 1 when it is off by this share, ...
constexpr double kClearAspect = 0.003;
/// ... and by so many of its standard deviations.
constexpr double kClearSigmas = 5.0;

/// Of the image's diagonal: real corners are off by a tenth of that; and widths: 3 degrees of view.
constexpr double kMostRms = 0.0025;
constexpr double kLongestFocal = 20.0;
/// Image widths: a solution of a longer focal length is none.
constexpr double kDivergedFocal = 1e3;

using Views = std::vector<const BoardView*>;

struct Solution {
  Camera camera;
  std::vector<Eigen::Isometry3d> poses;
};

Camera cameraOf(const IntrinsicsRequest& request, const cv::Mat& matrix, const cv::Mat& lens) {
  Camera camera;
  camera.intrinsics = {request.width,           request.height,          matrix.at<double>(0, 0),
                       matrix.at<double>(1, 1), matrix.at<double>(0, 2), matrix.at<double>(1, 2)};
  camera.lens = request.model == IntrinsicsModel::Fisheye ? LensModel::Fisheye : LensModel::Pinhole;
  for (int k = 0; k < std::min<int>(8, static_cast<int>(lens.total())); ++k) {
    camera.distortion[static_cast<std::size_t>(k)] = lens.at<double>(k);
  }
  return camera;
}

/// All views together, by OpenCV. Throws its exceptions.
Solution solveWithOpenCv(const IntrinsicsRequest& request, const Views& views, bool square) {
  std::vector<cv::Mat> board; // of points in double precision for fisheyes, single for pinholes
  std::vector<cv::Mat> image;
  const bool fisheye = request.model == IntrinsicsModel::Fisheye;
  const int depth = fisheye ? CV_64F : CV_32F;
  for (const BoardView* view : views) {
    std::vector<cv::Point3d> corners;
    std::vector<cv::Point2d> pixels;
    for (std::size_t k = 0; k < view->detection.ids.size(); ++k) {
      const Eigen::Vector3d corner = request.board.corner(view->detection.ids[k]);
      corners.emplace_back(corner.x(), corner.y(), corner.z());
      pixels.emplace_back(view->detection.pixels[k].x(), view->detection.pixels[k].y());
    }
    cv::Mat(corners).convertTo(board.emplace_back(), depth);
    cv::Mat(pixels).convertTo(image.emplace_back(), depth);
  }
  const cv::Size size(request.width, request.height);
  cv::Mat matrix = cv::Mat::eye(3, 3, CV_64F);
  cv::Mat lens;
  std::vector<cv::Mat> rotations;
  std::vector<cv::Mat> translations;
  if (fisheye) {
    cv::fisheye::calibrate(board, image, size, matrix, lens, rotations, translations,
                           cv::fisheye::CALIB_RECOMPUTE_EXTRINSIC | cv::fisheye::CALIB_FIX_SKEW);
  } else {
    const int flags =
        (square ? cv::CALIB_FIX_ASPECT_RATIO : 0) |
        (request.model == IntrinsicsModel::EightCoefficients ? cv::CALIB_RATIONAL_MODEL : 0);
    cv::calibrateCamera(board, image, size, matrix, lens, rotations, translations, flags);
  }
  Solution solution{cameraOf(request, matrix, lens), {}};
  for (std::size_t k = 0; k < views.size(); ++k) {
    solution.poses.push_back(poseFromOpenCv(rotations[k], translations[k]));
  }
  return solution;
}

Result<Solution> solve(const IntrinsicsRequest& request, const Views& views, bool square) {
  const auto undetermined = [](const std::string& why) {
    return failure(ErrorCode::BadValue, "", "views",
                   "the images do not determine the camera: " + why +
                       "; show the board tilted, near, and in all parts of the image");
  };
  try {
    Solution solution = solveWithOpenCv(request, views, square);
    const auto& in = solution.camera.intrinsics;
    const bool good = std::isfinite(in.focalX) && in.focalX > 1.0 && std::isfinite(in.focalY) &&
                      in.focalY > 1.0 && std::isfinite(in.centerX) && std::isfinite(in.centerY) &&
                      in.focalX < kDivergedFocal * request.width;
    if (!good) {
      return undetermined(fmt::format("focal length {:.4g} px", in.focalX));
    }
    return solution;
  } catch (const cv::Exception& problem) {
    return undetermined(problem.err);
  }
}

/// Solves, leaves out the views that fit badly, and solves again until all fit.
class IntrinsicsRefinement {
public:
  IntrinsicsRefinement(const IntrinsicsRequest& request, const CalibrationProgress& progress)
      : request_(request), progress_(progress) {}

  Result<IntrinsicsResult> run() {
    for (const BoardView& view : request_.views) {
      if (spansPlane(request_.board, view.detection)) {
        views_.push_back(&view);
      } else {
        left_.push_back(leftOutView(view, "too few corners are seen"));
      }
    }
    const auto solved = solveAll(request_.pixelShape != PixelShape::Free);
    if (!solved) {
      return tl::make_unexpected(solved.error());
    }
    if (request_.pixelShape == PixelShape::Measured && request_.model != IntrinsicsModel::Fisheye) {
      if (const auto checked = checkAspect(); !checked) {
        return tl::make_unexpected(checked.error());
      }
    }
    IntrinsicsResult result = finished();
    if (const auto plausible = checkPlausibility(result); !plausible) {
      return tl::make_unexpected(plausible.error());
    }
    return result;
  }

private:
  Status solveAll(bool square) {
    square_ = square && request_.model != IntrinsicsModel::Fisheye;
    for (int round = 0; round < kMostLensRounds; ++round) {
      if (views_.size() < kLeastViews) {
        return failure(
            ErrorCode::Undetermined, "", "views",
            fmt::format("the board is clearly visible in {} image{}; at least {} are needed",
                        views_.size(), views_.size() == 1 ? "" : "s", kLeastViews));
      }
      if (!reportProgress(progress_, CalibrationStage::Intrinsics,
                          static_cast<double>(round) / kMostLensRounds)) {
        return canceledError();
      }
      const auto solution = solve(request_, views_, square_);
      if (!solution) {
        return tl::make_unexpected(solution.error());
      }
      camera_ = solution->camera;
      fits_.clear();
      for (std::size_t k = 0; k < views_.size(); ++k) {
        fits_.push_back(fitView(request_.board, *views_[k], camera_, solution->poses[k]));
      }
      if (!leaveOutBad()) {
        return {};
      }
    }
    return {};
  }

  bool leaveOutBad() {
    const double median = medianRms(fits_);
    const double limit = maxViewErrorPx(median, camera_.intrinsics);
    Views good;
    for (std::size_t k = 0; k < views_.size(); ++k) {
      if (fits_[k].rmsPx <= limit) {
        good.push_back(views_[k]);
      } else {
        left_.push_back(leftOutView(
            *views_[k],
            fmt::format(
                "the corners of this view are {:.2f} px off, those of the other views {:.2f} px",
                fits_[k].rmsPx, median)));
        left_.back().rmsPx = fits_[k].rmsPx;
      }
    }
    std::swap(views_, good);
    return views_.size() < good.size();
  }

  /// Square pixels were assumed; when the pictures clearly say otherwise, they are not.
  Status checkAspect() {
    auto assumed = *this;
    if (const auto solved = solveAll(false); !solved) {
      return solved;
    }
    const IntrinsicsParameters parameters(request_.model, false);
    const Eigen::MatrixXd covariance =
        intrinsicsCovariance(request_.board, camera_, parameters, fits_);
    const auto& in = camera_.intrinsics;
    const double off = std::abs(in.focalX / in.focalY - 1.0);
    const double variance = covariance.size() == 0
                                ? 1.0
                                : (covariance(0, 0) + covariance(1, 1) - 2.0 * covariance(0, 1)) /
                                      (in.focalX * in.focalY);
    if (off < std::max(kClearAspect, kClearSigmas * std::sqrt(variance))) {
      views_ = std::move(assumed.views_);
      left_ = std::move(assumed.left_);
      fits_ = std::move(assumed.fits_);
      camera_ = assumed.camera_;
      square_ = true;
    }
    return {};
  }

  /// A board with another number of corners than was said can be found and solved, too; but then
  /// nothing fits.
  Status checkPlausibility(const IntrinsicsResult& result) const {
    const double limit = kMostRms * std::hypot(request_.width, request_.height);
    const double focal = result.camera.intrinsics.focalX;
    if (result.rmsPx <= limit && focal <= kLongestFocal * request_.width) {
      return {};
    }
    return failure(ErrorCode::BadValue, "", "board",
                   fmt::format("with this board, the corners are {:.1f} px off (RMS) and the focal "
                               "length is {:.0f} px; count the inner corners of the board again",
                               result.rmsPx, focal));
  }

  IntrinsicsResult finished() {
    IntrinsicsResult result;
    result.camera = camera_;
    markDoubtful(fits_);
    for (const ViewFit& fit : fits_) {
      result.coverage.add(fit.pixels, tiltOf(fit.cameraFromBoard), request_.width, request_.height);
    }
    result.rmsPx = overallRms(fits_);
    const IntrinsicsParameters parameters(request_.model, square_);
    const Eigen::MatrixXd stated = intrinsicsCovariance(request_.board, camera_, parameters, fits_);
    result.viewNormalEquations = normalEquationsOfViews(request_.board, camera_, parameters, fits_);
    const Eigen::MatrixXd found = lensJackknifeCovariance(result.viewNormalEquations);
    result.covariance = widenedCovariance(stated, found);
    result.independentProjectionSigmaPx = projectionSigma(camera_, parameters, stated);
    result.maxProjectionSigmaPx = result.independentProjectionSigmaPx;
    if (found.size() > 0) {
      result.maxProjectionSigmaPx =
          std::max(result.maxProjectionSigmaPx, projectionSigma(camera_, parameters, found));
    }
    const Eigen::VectorXd values = parameters.valuesOf(camera_);
    for (Eigen::Index k = 0; k < values.size(); ++k) {
      const double sigma = result.covariance.size() == 0 ? 0.0 : std::sqrt(result.covariance(k, k));
      result.parameters.push_back(
          {parameters.names()[static_cast<std::size_t>(k)], values(k), sigma});
    }
    result.views = std::move(fits_);
    result.views.insert(result.views.end(), left_.begin(), left_.end());
    return result;
  }

  const IntrinsicsRequest& request_;
  const CalibrationProgress& progress_;
  Views views_;
  std::vector<ViewFit> fits_;
  std::vector<ViewFit> left_;
  Camera camera_;
  bool square_ = false;
};

} // namespace

Result<IntrinsicsResult> calibrateIntrinsics(const IntrinsicsRequest& request,
                                             const CalibrationProgress& progress) {
  return IntrinsicsRefinement(request, progress).run();
}

Camera guessedCamera(int width, int height) {
  Camera camera;
  camera.intrinsics = {
      width, height, 1.0 * width, 1.0 * width, 0.5 * (width - 1), 0.5 * (height - 1)};
  return camera;
}

} // namespace dewpoint::calibration
