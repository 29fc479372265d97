// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/experiment/studies/people_pictures.h"

#include "core/session/people/people_overlay.h"
#include "core/session/people/person_shape.h"

#include <fmt/format.h>
#include <opencv2/imgproc.hpp>

#include <algorithm>
#include <cmath>
#include <limits>

namespace dewpoint::experiment {
namespace {

constexpr double kHalfFloor = 3.6; // meters: a little more than the office
// Pixels: as high as two views of 320 x 240 are.
constexpr int kFloorPixels = 480;
constexpr int kViewWidth = 320;

/// How many people are in the office, and the least distance of two of them (meters).
struct Gathering {
  int people = 0;
  double nearest = std::numeric_limits<double>::infinity();

  bool tellsMoreThan(const Gathering& other) const {
    return people != other.people ? people > other.people : nearest < other.nearest;
  }
};

Gathering gatheringAt(const OfficeScene& scene, double time) {
  Gathering result;
  std::vector<Eigen::Vector2d> positions;
  for (const simulation::Walker& walker : scene.people) {
    const Eigen::Vector2d position = walker.positionAt(time);
    if (!walker.isPresentAt(time) || position.cwiseAbs().maxCoeff() > kHalfFloor) {
      continue;
    }
    for (const Eigen::Vector2d& other : positions) {
      result.nearest = std::min(result.nearest, (other - position).norm());
    }
    positions.push_back(position);
  }
  result.people = static_cast<int>(positions.size());
  return result;
}

/// Two images beside each other per row, numbered, of a row of images of one width.
cv::Mat folded(const cv::Mat& row, int width) {
  const int count = row.cols / width;
  const int rows = (count + 1) / 2;
  cv::Mat page = cv::Mat::zeros(rows * row.rows, 2 * width, CV_8UC3);
  for (int k = 0; k < count; ++k) {
    cv::Mat position = page(cv::Rect(k % 2 * width, k / 2 * row.rows, width, row.rows));
    row(cv::Rect(k * width, 0, width, row.rows)).copyTo(position);
    cv::putText(position, std::to_string(k + 1), {6, 16}, cv::FONT_HERSHEY_SIMPLEX, 0.45,
                {255, 255, 255}, 1, cv::LINE_AA);
  }
  return page;
}

cv::Point onFloor(const Eigen::Vector2d& position) {
  const double scale = kFloorPixels / (2.0 * kHalfFloor);
  const Eigen::Vector2d pixel =
      (scale * Eigen::Vector2d(position.x() + kHalfFloor, kHalfFloor - position.y()))
          .cwiseMax(-1e4)
          .cwiseMin(1e4);
  return {cvRound(pixel.x()), cvRound(pixel.y())};
}

cv::Mat emptyFloor(const CameraRig& rig) {
  const cv::Scalar grid(62, 58, 54);
  const cv::Scalar marks(190, 190, 190);
  cv::Mat floor(kFloorPixels, kFloorPixels, CV_8UC3, cv::Scalar(34, 31, 28));
  for (int meter = -3; meter <= 3; ++meter) {
    cv::line(floor, onFloor({meter, -kHalfFloor}), onFloor({meter, kHalfFloor}), grid);
    cv::line(floor, onFloor({-kHalfFloor, meter}), onFloor({kHalfFloor, meter}), grid);
  }
  for (std::size_t k = 0; k < rig.size(); ++k) {
    const cv::Point at = onFloor(rig[k].center().head<2>());
    cv::circle(floor, at, 5, marks, 1, cv::LINE_AA);
    const int right = at.x > kFloorPixels / 2 ? -18 : 9;
    cv::putText(floor, std::to_string(k + 1), at + cv::Point(right, 5), cv::FONT_HERSHEY_SIMPLEX,
                0.4, marks, 1, cv::LINE_AA);
  }
  cv::putText(floor, "1 m grid", {kFloorPixels / 2 - 30, kFloorPixels - 8},
              cv::FONT_HERSHEY_SIMPLEX, 0.4, marks, 1, cv::LINE_AA);
  return floor;
}

void drawPerson(const PersonEstimate& person, const PersonShape& shape, cv::Mat& floor) {
  const cv::Scalar color = identityColor(person.identity);
  for (const auto& level : shape.groundCurves) {
    for (const LevelCurve& curve : level) {
      std::vector<cv::Point> points(curve.size());
      std::ranges::transform(curve, points.begin(), onFloor);
      cv::polylines(floor, points, false, color, 1, cv::LINE_AA);
    }
  }
  cv::putText(floor, std::to_string(person.identity),
              onFloor(person.position.head<2>()) + cv::Point(14, -14), cv::FONT_HERSHEY_SIMPLEX,
              0.55, color, 1, cv::LINE_AA);
}

} // namespace

std::vector<PeopleInstant> chooseInstantsToShow(const PeopleScenario& scenario) {
  const OfficeScene& scene = scenario.scene;
  const auto instantAt = [&](double time, const char* words) {
    const auto frame = std::llround(time * scene.framesPerSecond);
    return PeopleInstant{std::clamp<std::int64_t>(frame, 0, scene.frameCount - 1),
                         fmt::format("{}, {:.1f} s", words, time)};
  };
  Gathering most;
  double nearest = 0.0;
  for (std::int64_t frame = 0; frame < scene.frameCount; ++frame) {
    const double time = scene.timeOf(frame);
    const Gathering now = gatheringAt(scene, time);
    if (time >= scenario.timeBeforeMeeting && now.tellsMoreThan(most)) {
      most = now;
      nearest = time;
    }
  }
  if (scenario.timeBeforeMeeting <= 0.0) {
    return {instantAt(nearest, "most people, nearest to each other")};
  }
  return {instantAt(scenario.timeBeforeMeeting, "before"),
          instantAt(nearest, "nearest to each other"),
          instantAt(scenario.timeAfterMeeting, "after")};
}

cv::Mat drawPeopleImage(const PeopleFinding& people, const FrameSet& frames, const CameraRig& rig,
                        std::span<const TrackPoint> truth) {
  const cv::Mat views = folded(peopleOverlay(people, frames, rig, kViewWidth), kViewWidth);
  cv::Mat floor = emptyFloor(rig);
  for (const PersonEstimate& person : people.people()) {
    drawPerson(person, personShape(people.bodyOf(person.identity)), floor);
  }
  for (const TrackPoint& person : truth) {
    cv::drawMarker(floor, onFloor(person.position.head<2>()), {255, 255, 255},
                   cv::MARKER_TILTED_CROSS, 9, 1, cv::LINE_AA);
  }
  const int height = std::max(views.rows, floor.rows);
  cv::Mat page = cv::Mat::zeros(height, views.cols + 8 + floor.cols, CV_8UC3);
  views.copyTo(page(cv::Rect(0, 0, views.cols, views.rows)));
  floor.copyTo(page(cv::Rect(views.cols + 8, 0, floor.cols, floor.rows)));
  return page;
}

} // namespace dewpoint::experiment
