// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/session/people/people_overlay.h"

#include "core/tracking/people/people_volume.h"

#include <opencv2/imgcodecs.hpp>
#include <opencv2/imgproc.hpp>

#include <algorithm>
#include <array>
#include <cmath>

namespace dewpoint::session {
namespace {

std::vector<cv::Point> scaled(const std::vector<Eigen::Vector2d>& outline, double factor) {
  std::vector<cv::Point> points;
  for (const auto& pixel : outline) {
    const Eigen::Vector2d position = (factor * pixel).cwiseMax(-1e4).cwiseMin(1e4);
    points.emplace_back(static_cast<int>(std::lround(position.x())),
                        static_cast<int>(std::lround(position.y())));
  }
  return points;
}

} // namespace

cv::Scalar identityColor(int identity) {
  // Paul Tol's bright and vibrant schemes, made for all kinds of color vision.
  static const std::array<cv::Scalar, 12> kColors{
      cv::Scalar(119, 102, 238), cv::Scalar(51, 136, 34),   cv::Scalar(170, 119, 68),
      cv::Scalar(68, 187, 204),  cv::Scalar(238, 204, 102), cv::Scalar(119, 51, 170),
      cv::Scalar(51, 119, 238),  cv::Scalar(136, 153, 0),   cv::Scalar(187, 119, 0),
      cv::Scalar(119, 51, 238),  cv::Scalar(17, 51, 204),   cv::Scalar(187, 187, 187)};
  const auto count = static_cast<int>(kColors.size());
  return kColors.at(static_cast<std::size_t>(((identity - 1) % count + count) % count));
}

cv::Mat peopleOverlay(const PeopleFinding& people, const FrameSet& frames, const CameraRig& rig,
                      int width) {
  std::vector<ConvexHull> hulls;
  for (const PersonEstimate& person : people.people()) {
    hulls.push_back(bodyHull(people.bodyOf(person.identity)));
  }
  int height = 1;
  std::vector<cv::Mat> views;
  for (std::size_t k = 0; k < rig.size(); ++k) {
    const Intrinsics& size = rig[k].intrinsics;
    const double factor = static_cast<double>(width) / size.width;
    const int rows = static_cast<int>(std::lround(size.height * factor));
    cv::Mat view = cv::Mat::zeros(rows, width, CV_8UC3);
    if (k < frames.frames.size() && frames.frames[k] && !frames.frames[k]->image.empty()) {
      cv::resize(frames.frames[k]->image, view, view.size(), 0.0, 0.0, cv::INTER_AREA);
    }
    const Projector projector(rig[k]);
    for (std::size_t person = 0; person < hulls.size(); ++person) {
      const int identity = people.people()[person].identity;
      const auto outline = scaled(projectedHull(projector, hulls[person]), factor);
      if (outline.size() > 2) {
        cv::polylines(view, outline, true, identityColor(identity), 2, cv::LINE_AA);
        cv::putText(view, std::to_string(identity), outline.front(), cv::FONT_HERSHEY_SIMPLEX, 0.5,
                    identityColor(identity), 1, cv::LINE_AA);
      }
    }
    height = std::max(height, rows);
    views.push_back(view);
  }
  cv::Mat row = cv::Mat::zeros(height, width * static_cast<int>(rig.size()), CV_8UC3);
  for (std::size_t k = 0; k < views.size(); ++k) {
    views[k].copyTo(row(cv::Rect(static_cast<int>(k) * width, 0, width, views[k].rows)));
  }
  return row;
}

Status writeContactSheet(const std::vector<cv::Mat>& rows, const std::filesystem::path& file) {
  try {
    cv::Mat sheet;
    cv::vconcat(rows, sheet);
    if (cv::imwrite(file.string(), sheet)) {
      return {};
    }
    return failure(ErrorCode::FileUnwritable, file.string(), "", "");
  } catch (const cv::Exception& problem) {
    return failure(ErrorCode::FileUnwritable, file.string(), "", problem.err);
  }
}

} // namespace dewpoint::session
