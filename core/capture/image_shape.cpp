// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/capture/image_shape.h"

#include <fmt/format.h>
#include <opencv2/imgproc.hpp>

#include <algorithm>
#include <utility>

namespace dewpoint::capture {

namespace {

Result<cv::Mat> asBgr(const cv::Mat& picture, const ImageShape& shape, const std::string& file) {
  if (picture.type() == CV_8UC3) {
    return picture;
  }
  cv::Mat bgr;
  if (picture.type() == CV_8UC1) {
    cv::cvtColor(picture, bgr, cv::COLOR_GRAY2BGR);
  } else if (picture.type() == CV_8UC4) {
    cv::cvtColor(picture, bgr, cv::COLOR_BGRA2BGR);
  } else {
    return failure(ErrorCode::Mismatch, file, quotedCameraName(shape.cameraName),
                   "the image has neither 8-bit color nor 8-bit gray values");
  }
  return bgr;
}

cv::Mat mirrored(const cv::Mat& picture) {
  cv::Mat result;
  cv::flip(picture, result, 1); // about the vertical
  return result;
}

cv::Mat rotated(const cv::Mat& picture, int degrees) {
  if (degrees == 0) {
    return picture;
  }
  const int code = degrees == 90    ? cv::ROTATE_90_CLOCKWISE
                   : degrees == 180 ? cv::ROTATE_180
                                    : cv::ROTATE_90_COUNTERCLOCKWISE;
  cv::Mat result;
  cv::rotate(picture, result, code);
  return result;
}

/// In memory of its own: the rest of the image is not kept.
Result<cv::Mat> cropped(const cv::Mat& picture, const ImageShape& shape, const std::string& file) {
  const ImageMargins& crop = shape.crop;
  const cv::Rect rest(crop.left, crop.top, picture.cols - crop.width(),
                      picture.rows - crop.height());
  if (rest.width < 1 || rest.height < 1) {
    return failure(ErrorCode::Mismatch, file, quotedCameraName(shape.cameraName),
                   fmt::format("{} x {}, of which cropping by {} x {} leaves nothing", picture.cols,
                               picture.rows, crop.width(), crop.height()));
  }
  return picture(rest).clone();
}

} // namespace

std::string quotedCameraName(const std::string& name) {
  const bool saysSo = name.starts_with("camera") || name.starts_with("Camera");
  return (saysSo ? "'" : "camera '") + name + "'";
}

Status checkShape(const ImageShape& shape, const std::string& file) {
  const int angle = shape.rotateDegrees;
  if (angle != 0 && angle != 90 && angle != 180 && angle != 270) {
    return failure(ErrorCode::BadValue, file, quotedCameraName(shape.cameraName),
                   fmt::format("the rotation must be 0, 90, 180 or 270 degrees, not {}", angle));
  }
  if (shape.width < 0 || shape.height < 0) {
    return failure(ErrorCode::BadValue, file, quotedCameraName(shape.cameraName),
                   fmt::format("the size {} x {} is negative", shape.width, shape.height));
  }
  const ImageMargins& crop = shape.crop;
  if (std::min({crop.left, crop.top, crop.right, crop.bottom}) < 0) {
    return failure(ErrorCode::BadValue, file, quotedCameraName(shape.cameraName),
                   "the margins to crop must not be negative");
  }
  return {};
}

Result<cv::Mat> prepareImage(const cv::Mat& picture, const ImageShape& shape,
                             const std::string& file) {
  try {
    const auto bgr = asBgr(picture, shape, file);
    if (!bgr) {
      return bgr;
    }
    cv::Mat result = rotated(*bgr, shape.rotateDegrees);
    result = shape.isMirrored ? mirrored(result) : result;
    if (!shape.crop.isZeroOnAllSides()) {
      auto rest = cropped(result, shape, file);
      if (!rest) {
        return rest;
      }
      result = std::move(*rest);
    }
    const bool fits = (shape.width == 0 || result.cols == shape.width) &&
                      (shape.height == 0 || result.rows == shape.height);
    if (!fits) {
      return failure(ErrorCode::Mismatch, file, quotedCameraName(shape.cameraName),
                     fmt::format("{} x {}, but its calibration is for {} x {}", result.cols,
                                 result.rows, shape.width, shape.height));
    }
    return result;
  } catch (const std::exception& problem) {
    return failure(ErrorCode::FileUnreadable, file, quotedCameraName(shape.cameraName),
                   problem.what());
  }
}

} // namespace dewpoint::capture
