// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/color/assessed_regions.h"

#include <QCoreApplication>
#include <QPolygonF>

#include <algorithm>

namespace dewpoint::ui {

namespace {

class AssessedRegions {
  Q_DECLARE_TR_FUNCTIONS(AssessedRegions)
};

ImagePickOverlay::Region regionOf(const std::vector<cv::Point>& outline, const QString& text) {
  QPolygonF polygon;
  for (const cv::Point& point : outline) {
    polygon << QPointF(point.x, point.y);
  }
  return {polygon, text};
}

} // namespace

std::map<int, std::vector<ImagePickOverlay::Region>>
assessedRegions(const ColorAssessment& assessment, const std::vector<setup::FoundOutline>& found) {
  std::map<int, std::vector<ImagePickOverlay::Region>> regions;
  const QString matches = assessment.isGood()
                              ? AssessedRegions::tr("some pixels also have the target's color")
                              : AssessedRegions::tr("also has the target's color");
  for (const DistractorRegion& region : assessment.distractors) {
    regions[region.camera].push_back(regionOf(region.outline, matches));
  }
  const QString also =
      AssessedRegions::tr("recognized as the target (if this is wrong, Ctrl+Shift-click here)");
  for (const setup::FoundOutline& target : found) {
    auto& shown = regions[target.camera];
    const bool isSaid = std::ranges::any_of(
        shown, [&](const ImagePickOverlay::Region& region) { return region.text == also; });
    // Of a target of several colors there is an outline each; one label is enough.
    shown.push_back(regionOf(target.outline, isSaid ? QString() : also));
  }
  return regions;
}

} // namespace dewpoint::ui
