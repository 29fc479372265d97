// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/tracking/boxes/box_filter.h"

#include "core/observation/boxes/click_box.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace dewpoint::tracking {
namespace {

constexpr double kSmallest = 2.0; // pixels

Status checkImage(const cv::Mat& bgr) {
  if (bgr.empty() || bgr.type() != CV_8UC3) {
    return failure(ErrorCode::BadValue, {}, "image", "a color image is expected");
  }
  return {};
}

} // namespace

Status checkBox(const cv::Mat& bgr, const ImageBox& box) {
  if (const auto image = checkImage(bgr); !image) {
    return image;
  }
  const Eigen::Vector2d center = box.center();
  const bool large = box.width >= kSmallest && box.height >= kSmallest;
  const bool fits = box.width <= bgr.cols && box.height <= bgr.rows;
  const bool inside =
      center.x() >= 0.0 && center.x() < bgr.cols && center.y() >= 0.0 && center.y() < bgr.rows;
  if (!(large && fits && inside)) { // NaN comes here too
    return failure(ErrorCode::BadValue, {}, "box",
                   fmt::format("{:g},{:g},{:g},{:g}: at least 2 x 2 pixels, with the center in the "
                               "image of {} x {}, are expected",
                               box.x, box.y, box.width, box.height, bgr.cols, bgr.rows));
  }
  return {};
}

Result<ImageBox> boxFromClick(const cv::Mat& bgr, double x, double y) {
  if (const auto image = checkImage(bgr); !image) {
    return tl::make_unexpected(image.error());
  }
  if (!(x >= 0.0 && x < bgr.cols && y >= 0.0 && y < bgr.rows)) {
    return failure(ErrorCode::BadValue, {}, "pixel",
                   fmt::format("{} x {} pixels are in the image", bgr.cols, bgr.rows));
  }
  const auto box = boxAroundClick(bgr, {x, y});
  if (!box || !checkBox(bgr, *box)) {
    return failure(ErrorCode::Undetermined, {}, "pixel",
                   "no object stands out there; give a box instead");
  }
  return *box;
}

} // namespace dewpoint::tracking
