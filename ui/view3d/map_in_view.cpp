// SPDX-License-Identifier: GPL-3.0-or-later
// The map of expected errors in the bird's-eye view.
#include "core/calibration/planning/rig_map.h"
#include "ui/style/map_legend.h"
#include "ui/view3d/birds_eye_view.h"

#include <QHelpEvent>
#include <QToolTip>

#include <cmath>
#include <utility>

namespace dewpoint::ui {

void BirdsEyeView::showMap(std::shared_ptr<const RigMap> map, const MapLook& look) {
  if (map != nullptr || map_ != nullptr) {
    map_ = std::move(map);
    mapLook_ = look;
    mapStale_ = true;
    requestPicture();
  }
}

void BirdsEyeView::showPlanned(const CameraRig& cameras) {
  scene_.showPlanned(cameras);
  requestPicture();
}

QString BirdsEyeView::mapTextAt(QPointF position) const {
  if (map_ == nullptr || mapStale_ || !hasPicture()) {
    return {};
  }
  const QPointF offset = (position - QPointF(width() / 2.0, height() / 2.0)) * devicePixelRatioF();
  const auto place = scene_.placeInLayer({offset.x(), -offset.y()});
  const auto cell = place ? cellAt(map_->grid, *place) : std::nullopt;
  if (!cell) {
    return {};
  }
  const double sigma = double(map_->sigmas[*cell]);
  const int count = map_->counts[*cell];
  return std::isnan(sigma)
             ? tr("Cameras that see it: %1").arg(count)
             : tr("±%1 (1 σ); cameras that see it: %2").arg(shortLength(sigma)).arg(count);
}

bool BirdsEyeView::event(QEvent* event) {
  if (event->type() == QEvent::ToolTip) {
    const auto* help = static_cast<QHelpEvent*>(event);
    if (const QString text = mapTextAt(help->pos()); !text.isEmpty()) {
      QToolTip::showText(help->globalPos(), text, this);
      return true;
    }
    QToolTip::hideText();
  }
  return QWidget::event(event);
}

} // namespace dewpoint::ui
