// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/tracking/people/person_at_pixel.h"

#include "core/observation/people/body_silhouette.h"
#include "core/observation/people/person_score.h"
#include "core/tracking/people/people_parameters.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <vector>

namespace dewpoint::tracking {
namespace {

constexpr double kPlaceStep = 0.1; ///< meters between places that are tried
constexpr double kMostSteps = 200.0;
constexpr double kUsualHeight = 1.72; ///< where the method has none of its own
/// What a pixel at the border of a body takes from its score: who clicks on somebody aims at the
/// middle.
constexpr double kBesideCost = 0.2;

double heightIn(const ParameterValues& parameters) {
  const auto declared = parameters.declarations();
  const bool has =
      std::ranges::find(declared, "usual_height", &ParameterDeclaration::key) != declared.end();
  return has ? parameters.at("usual_height") : kUsualHeight;
}

/// A camera and its mask, to be scored in the size of the mask.
struct View {
  SilhouetteProjector maker;
  double scale = 1.0; ///< pixels of the image per pixel of the mask
  ScoreSums scores;   ///< empty without a mask
};

View viewOf(const PeopleFinding& people, const Camera& camera, std::size_t index) {
  View view{SilhouetteProjector(camera), 1.0, {}};
  const cv::Mat mask = people.foregroundMask(index);
  if (!mask.empty()) {
    view.scale = static_cast<double>(camera.intrinsics.width) / mask.cols;
    view.scores.build(maskScores(mask, cv::Mat()));
  }
  return view;
}

BodySilhouette shrunk(BodySilhouette silhouette, double scale) {
  for (cv::Rect& piece : silhouette.partRects) {
    const auto at = [scale](int pixel) { return static_cast<int>(std::lround(pixel / scale)); };
    const cv::Point corner(at(piece.x), at(piece.y));
    piece = cv::Rect(corner, cv::Point(std::max(corner.x + 1, at(piece.br().x)),
                                       std::max(corner.y + 1, at(piece.br().y))));
  }
  return silhouette;
}

/// How far a pixel is from the middle of a silhouette: 0 there, 1 at its border; nothing outside.
std::optional<double> besideMiddle(const BodySilhouette& silhouette, const Eigen::Vector2d& pixel) {
  cv::Rect all = silhouette.partRects.front();
  for (const cv::Rect& piece : silhouette.partRects) {
    all |= piece;
  }
  const double across = std::abs(pixel.x() - (all.x + 0.5 * all.width)) / (0.5 * all.width);
  const double along = std::abs(pixel.y() - (all.y + 0.5 * all.height)) / (0.5 * all.height);
  const double beside = std::max(across, along);
  return silhouette.isVisible && beside <= 1.0 ? std::optional(beside) : std::nullopt;
}

double scoreOf(const std::vector<View>& views, const Eigen::Vector2d& position, double floor,
               double height) {
  double sum = 0.0;
  for (const View& view : views) {
    if (!view.scores.sums.empty()) {
      sum += bodyScore(view.scores, shrunk(view.maker.project(position, floor, height), view.scale),
                       kPieceFloor);
    }
  }
  return sum;
}

} // namespace

Eigen::Vector3d bodyCenter(const Eigen::Vector2d& position, const ParameterValues& parameters) {
  return {position.x(), position.y(), parameters.at("floor_z") + 0.5 * heightIn(parameters)};
}

std::optional<Eigen::Vector3d> personCenterAtPixel(const PeopleFinding& people,
                                                   const CameraRig& rig,
                                                   const ParameterValues& parameters, int camera,
                                                   const Eigen::Vector2d& pixel) {
  const auto clicked = static_cast<std::size_t>(camera);
  if (camera < 0 || clicked >= rig.size()) {
    return std::nullopt;
  }
  std::vector<View> views;
  for (std::size_t k = 0; k < rig.size(); ++k) {
    views.push_back(viewOf(people, rig[k], k));
  }
  const PeopleArea area = peopleSettings(parameters).area;
  const double height = heightIn(parameters);
  const double step = std::max(kPlaceStep, 2.0 * area.halfSize.maxCoeff() / kMostSteps);
  double best = -std::numeric_limits<double>::infinity();
  std::optional<Eigen::Vector2d> found;
  for (double x = -area.halfSize.x(); x <= area.halfSize.x(); x += step) {
    for (double y = -area.halfSize.y(); y <= area.halfSize.y(); y += step) {
      const Eigen::Vector2d position = area.center + Eigen::Vector2d(x, y);
      const auto beside =
          besideMiddle(views[clicked].maker.project(position, area.floorHeight, height), pixel);
      if (!beside) {
        continue;
      }
      const double score =
          scoreOf(views, position, area.floorHeight, height) - kBesideCost * *beside;
      if (score > best) {
        best = score;
        found = position;
      }
    }
  }
  return found ? std::optional(bodyCenter(*found, parameters)) : std::nullopt;
}

} // namespace dewpoint::tracking
