// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/view3d/map_overlay.h"

#include "core/calibration/planning/rig_map.h"
#include "ui/style/map_legend.h"
#include "ui/text/quantity_text.h"

#include <QPainter>
#include <QWidget>

#include <cmath>
#include <utility>

namespace dewpoint::ui {

bool MapOverlay::setMap(std::shared_ptr<const RigMap> map, const MapOptions& look) {
  if (map == nullptr && map_ == nullptr) {
    return false;
  }
  map_ = std::move(map);
  options_ = look;
  stale_ = true;
  return true;
}

void MapOverlay::updateScene() {
  if (std::exchange(stale_, false)) {
    scene_.showMap(map_, options_);
  }
}

QString MapOverlay::textAt(const ViewProjection& projection, QPointF position) const {
  if (map_ == nullptr || stale_) {
    return {};
  }
  const auto place = scene_.positionInMapLayer(projection.toRenderedImage(position));
  const auto cell = place ? cellAt(map_->grid, *place) : std::nullopt;
  if (!cell) {
    return {};
  }
  const double sigma = double(map_->sigmas[*cell]);
  const int count = map_->cameraCounts[*cell];
  return std::isnan(sigma) ? tr("Cameras that see this point: %1").arg(count)
                           : tr("Expected error: ±%1 (1 σ); cameras that see this point: %2")
                                 .arg(lengthText(sigma, LengthForm::Short))
                                 .arg(count);
}

void MapOverlay::paintLegend(QPainter& painter, const QWidget& view) const {
  if (map_ != nullptr) {
    paintMapLegend(painter, view.rect(), options_, view.palette());
  }
}

} // namespace dewpoint::ui
