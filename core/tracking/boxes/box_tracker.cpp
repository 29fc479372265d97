// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/tracking/boxes/box_tracker.h"

#include "core/observation/boxes/click_box.h"
#include "core/tracking/boxes/histogram_tracker.h"
#include "core/tracking/boxes/sugandi_tracker.h"

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

std::vector<std::string> boxMethodNames() {
  return {"histogram", "sugandi"};
}

Result<std::unique_ptr<BoxTracker>> makeBoxTracker(const std::string& method,
                                                   const ParameterValues& parameters) {
  const auto names = boxMethodNames();
  if (std::ranges::find(names, method) == names.end()) {
    return failure(ErrorCode::NotFound, "", "method", method);
  }
  if (const auto checked = checkParameters(method, parameters); !checked) {
    return tl::make_unexpected(checked.error());
  }
  if (method == "sugandi") {
    return std::make_unique<SugandiTracker>(parameters);
  }
  return std::make_unique<HistogramTracker>(parameters);
}

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
  const auto box = clickBox(bgr, {x, y});
  if (!box || !checkBox(bgr, *box)) {
    return failure(ErrorCode::Undetermined, {}, "pixel",
                   "nothing stands out there; give a box instead");
  }
  return *box;
}

} // namespace dewpoint::tracking
