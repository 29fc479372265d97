// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/calibration/board/board_layer.h"

#include "ui/calibration/board/board_calibrator.h"
#include "ui/cameraview/camera_view.h"
#include "ui/style/halo.h"

#include <QEvent>
#include <QPainter>
#include <QPolygonF>
#include <QTimer>

namespace dewpoint::ui {
namespace {

constexpr int kLitMs = 350;
const QColor kSeen("#00c78f"); // bluish green, lighter than Okabe-Ito's: on images

} // namespace

BoardLayer::BoardLayer(int camera, CameraView* view, BoardCalibrator& calibrator)
    : QWidget(view), camera_(static_cast<std::size_t>(camera)), view_(view),
      calibrator_(calibrator) {
  setObjectName(QStringLiteral("boardLayer%1").arg(camera));
  setAttribute(Qt::WA_TransparentForMouseEvents);
  setFocusPolicy(Qt::NoFocus);
  setGeometry(view->rect());
  view->installEventFilter(this);
  connect(&calibrator_, &BoardCalibrator::guideChanged, this, &BoardLayer::refresh);
  connect(&calibrator_, &BoardCalibrator::changed, this, &BoardLayer::refresh);
  refresh();
}

bool BoardLayer::eventFilter(QObject* watched, QEvent* event) {
  if (watched == view_ && event->type() == QEvent::Resize) {
    setGeometry(view_->rect());
  }
  return false;
}

void BoardLayer::refresh() {
  if (isHidden() == calibrator_.isGuiding()) {
    setVisible(calibrator_.isGuiding());
    raise();
  }
  const auto state = calibrator_.guideState();
  const std::size_t taken =
      camera_ < state->cameras.size() ? state->cameras[camera_].capturedOutlines.size() : 0;
  if (taken > taken_) {
    highlighted_ = true;
    QTimer::singleShot(kLitMs, this, [this] {
      highlighted_ = false;
      update();
    });
  }
  taken_ = taken;
  update();
}

void BoardLayer::paintEvent(QPaintEvent*) {
  const auto state = calibrator_.guideState();
  if (camera_ >= state->cameras.size() || state->cameras[camera_].outline.empty()) {
    return;
  }
  const ImagePlacement& image = view_->placement();
  QPolygonF outline;
  for (const Eigen::Vector2d& corner : state->cameras[camera_].outline) {
    outline << image.topLeft + image.scale * QPointF(corner.x() + 0.5, corner.y() + 0.5);
  }
  QPainter painter(this);
  painter.setRenderHint(QPainter::Antialiasing);
  painter.setPen(haloPen(3.0, kGridHalo));
  painter.drawPolygon(outline);
  painter.setPen(QPen(kSeen, 2.5, Qt::SolidLine, Qt::RoundCap, Qt::RoundJoin));
  painter.setBrush(highlighted_ ? QBrush(QColor(kSeen.red(), kSeen.green(), kSeen.blue(), 110))
                                : QBrush(Qt::NoBrush));
  painter.drawPolygon(outline);
}

} // namespace dewpoint::ui
