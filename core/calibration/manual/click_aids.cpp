// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/calibration/manual/click_aids.h"

#include <opencv2/imgproc.hpp>

#include <cmath>
#include <vector>

namespace dewpoint::calibration {
namespace {

cv::Mat grayOf(const cv::Mat& image) {
  if (image.channels() == 1) {
    return image;
  }
  cv::Mat gray;
  cv::cvtColor(image, gray, cv::COLOR_BGR2GRAY);
  return gray;
}

bool isUsable(const cv::Mat& image) {
  return !image.empty() && (image.type() == CV_8UC3 || image.type() == CV_8UC1);
}

/// Whether there is more around a place than the noise of a sensor.
bool hasContrast(const cv::Mat& piece, cv::Point2f pixel) {
  /// Pixels around a corner whose contrast is measured.
  constexpr int kReach = 4;
  constexpr double kLeast = 24.0; // gray levels, smoothed
  const cv::Rect around =
      cv::Rect(static_cast<int>(pixel.x) - kReach, static_cast<int>(pixel.y) - kReach,
               2 * kReach + 1, 2 * kReach + 1) &
      cv::Rect(0, 0, piece.cols, piece.rows);
  cv::Mat smooth;
  cv::GaussianBlur(piece, smooth, {7, 7}, 1.3);
  double low = 0.0;
  double high = 0.0;
  cv::minMaxLoc(smooth(around), &low, &high);
  return high - low >= kLeast;
}

/// The strong corner of a piece of an image that is nearest to a place in it.
std::optional<cv::Point2f> nearestCorner(const cv::Mat& piece, cv::Point2f pixel, double reach) {
  /// Corners that are considered.
  constexpr int kMost = 12;
  constexpr double kQuality = 0.25; // of the strongest corner there
  constexpr double kApart = 3.0;    // pixels
  std::vector<cv::Point2f> corners;
  cv::goodFeaturesToTrack(piece, corners, kMost, kQuality, kApart);
  std::optional<cv::Point2f> nearest;
  for (const cv::Point2f& corner : corners) {
    if (cv::norm(corner - pixel) < reach && hasContrast(piece, corner)) {
      reach = cv::norm(corner - pixel);
      nearest = corner;
    }
  }
  return nearest;
}

} // namespace

std::optional<Eigen::Vector2d> snapToCorner(const cv::Mat& image, const Eigen::Vector2d& click,
                                            double reach) {
  constexpr int kWindow = 5;  // half, pixels
  constexpr int kMargin = 16; // more of the image than is searched, for the refinement
  if (!isUsable(image) || !click.allFinite()) {
    return std::nullopt;
  }
  try {
    const int half = static_cast<int>(std::ceil(reach)) + kMargin;
    const cv::Rect wanted(static_cast<int>(std::lround(click.x())) - half,
                          static_cast<int>(std::lround(click.y())) - half, 2 * half + 1,
                          2 * half + 1);
    const cv::Rect inside = wanted & cv::Rect(0, 0, image.cols, image.rows);
    if (inside.width <= 2 * kWindow + 5 || inside.height <= 2 * kWindow + 5) {
      return std::nullopt; // too near to the border of the image
    }
    const cv::Mat piece = grayOf(image(inside));
    const cv::Point2f pixel(static_cast<float>(click.x() - inside.x),
                            static_cast<float>(click.y() - inside.y));
    const auto corner = nearestCorner(piece, pixel, reach);
    if (!corner) {
      return std::nullopt;
    }
    std::vector<cv::Point2f> refined{*corner};
    const cv::TermCriteria until(cv::TermCriteria::COUNT | cv::TermCriteria::EPS, 40, 1e-3);
    cv::cornerSubPix(piece, refined, {kWindow, kWindow}, {-1, -1}, until);
    const Eigen::Vector2d found(refined[0].x + inside.x, refined[0].y + inside.y);
    const bool stayed = cv::norm(refined[0] - *corner) <= kWindow;
    return stayed && (found - click).norm() <= reach + 1.0 ? std::optional(found) : std::nullopt;
  } catch (const cv::Exception&) {
    return std::nullopt;
  }
}

cv::Mat magnified(const cv::Mat& image, const Eigen::Vector2d& center, int side, int factor) {
  cv::Mat result(side, side, image.type(), cv::Scalar::all(0));
  if (image.empty() || !center.allFinite()) {
    return result;
  }
  // Pixel p covers the places p - 0.5 to p + 0.5.
  const double middle = 0.5 * side;
  const double left = middle - factor * (center.x() + 0.5);
  const double top = middle - factor * (center.y() + 0.5);
  try {
    // warpAffine counts from centers of pixels on both sides.
    const cv::Matx23d placed(factor, 0, left + 0.5 * (factor - 1), 0, factor,
                             top + 0.5 * (factor - 1));
    cv::warpAffine(image, result, placed, result.size(), cv::INTER_NEAREST, cv::BORDER_CONSTANT);
  } catch (const cv::Exception&) {
    result.setTo(cv::Scalar::all(0));
  }
  return result;
}

cv::Mat edgeStrengthImage(const cv::Mat& image) {
  cv::Mat edges(image.rows, image.cols, CV_8UC1, cv::Scalar(0));
  if (!isUsable(image)) {
    return edges;
  }
  try {
    cv::Mat across;
    cv::Mat down;
    cv::Mat smooth;
    cv::GaussianBlur(grayOf(image), smooth, {3, 3}, 0.0);
    cv::Sobel(smooth, across, CV_16S, 1, 0);
    cv::Sobel(smooth, down, CV_16S, 0, 1);
    cv::Mat left;
    cv::Mat right;
    cv::convertScaleAbs(across, left);
    cv::convertScaleAbs(down, right);
    cv::addWeighted(left, 1.0, right, 1.0, 0.0, edges);
  } catch (const cv::Exception&) {
    edges.setTo(cv::Scalar(0));
  }
  return edges;
}

cv::Mat edgeStrengthImage(const cv::Mat& image, const cv::Size& size) {
  cv::Mat fitted;
  try {
    cv::resize(image, fitted, size, 0.0, 0.0, cv::INTER_AREA);
  } catch (const cv::Exception&) {
    return cv::Mat(size, CV_8UC1, cv::Scalar(0));
  }
  return edgeStrengthImage(fitted);
}

} // namespace dewpoint::calibration
