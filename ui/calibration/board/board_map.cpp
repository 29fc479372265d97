// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/calibration/board/board_map.h"

#include <QPainter>
#include <QPolygonF>

#include <algorithm>

namespace dewpoint::ui {
namespace {

constexpr int kCellLitMs = 350;
constexpr double kTiltHeight = 22.0;
constexpr double kEnoughCorners = 60.0; ///< in a region: it is filled fully
const QColor kSeenCell("#009e73");      // Okabe-Ito bluish green
const QColor kWanted("#e69f00");        // orange

QPolygonF placed(const BoardGuideState::Outline& outline, const QRectF& image, int width,
                 int height) {
  QPolygonF polygon;
  for (const Eigen::Vector2d& corner : outline) {
    polygon << QPointF(image.left() + (corner.x() + 0.5) / width * image.width(),
                       image.top() + (corner.y() + 0.5) / height * image.height());
  }
  return polygon;
}

/// A board as it looks at a tilt: the nearer side is longer.
QPolygonF tiltShape(BoardTilt tilt, const QPointF& middle) {
  const double near = 7.0;
  const double far = 4.0;
  const double left = tilt == BoardTilt::LeftNear ? near : tilt == BoardTilt::RightNear ? far : 5.5;
  const double right = tilt == BoardTilt::RightNear  ? near
                       : tilt == BoardTilt::LeftNear ? far
                                                     : 5.5;
  const double top = tilt == BoardTilt::TopNear ? 9.0 : tilt == BoardTilt::BottomNear ? 5.5 : 7.5;
  const double bottom = tilt == BoardTilt::BottomNear ? 9.0
                        : tilt == BoardTilt::TopNear  ? 5.5
                                                      : 7.5;
  QPolygonF shape;
  shape << middle + QPointF(-top, -left) << middle + QPointF(top, -right)
        << middle + QPointF(bottom, right) << middle + QPointF(-bottom, left);
  return shape;
}

} // namespace

BoardMap::BoardMap(QWidget* parent) : QWidget(parent) {
  setSizePolicy(QSizePolicy::Fixed, QSizePolicy::Fixed);
  dim_.setSingleShot(true);
  dim_.setInterval(kCellLitMs);
  connect(&dim_, &QTimer::timeout, this, qOverload<>(&QWidget::update));
}

void BoardMap::setCamera(const BoardGuideState::PerCamera& camera, bool lens) {
  if (camera.capturedOutlines.size() > camera_.capturedOutlines.size()) {
    sinceTaken_.start();
    dim_.start();
  }
  camera_ = camera;
  lens_ = lens;
  update();
}

QRectF BoardMap::imageArea() const {
  const QSizeF room(width() - 2.0, height() - 2.0 - kTiltHeight);
  const QSizeF size =
      camera_.imageWidth > 0 ? QSizeF(camera_.imageWidth, camera_.imageHeight) : QSizeF(4, 3);
  const QSizeF fitted = size.scaled(room, Qt::KeepAspectRatio);
  return {QPointF(1.0 + 0.5 * (room.width() - fitted.width()), 1.0), fitted};
}

void BoardMap::paintRegions(QPainter& painter, const QRectF& image) const {
  const double width = image.width() / BoardCoverage::kColumns;
  const double height = image.height() / BoardCoverage::kRows;
  const auto& guidance = camera_.lensGuidance;
  const auto cell = [&](int region) {
    return QRectF(image.left() + region % BoardCoverage::kColumns * width,
                  image.top() + static_cast<int>(region / BoardCoverage::kColumns) * height, width,
                  height);
  };
  for (int region = 0; region < static_cast<int>(guidance.coverage.cornerCounts.size()); ++region) {
    const int corners = guidance.coverage.cornerCounts[static_cast<std::size_t>(region)];
    QColor fill = palette().color(QPalette::Highlight);
    fill.setAlphaF(static_cast<float>(0.75 * std::min(1.0, corners / kEnoughCorners)));
    painter.fillRect(cell(region), fill);
  }
  QColor line = palette().color(QPalette::Mid);
  line.setAlpha(120);
  painter.setPen(line);
  for (int column = 1; column < BoardCoverage::kColumns; ++column) {
    painter.drawLine(QLineF(image.left() + column * width, image.top(),
                            image.left() + column * width, image.bottom()));
  }
  for (int row = 1; row < BoardCoverage::kRows; ++row) {
    painter.drawLine(QLineF(image.left(), image.top() + row * height, image.right(),
                            image.top() + row * height));
  }
  if (guidance.advice == GuidanceAdvice::MoveTo && guidance.requestedRegion >= 0) {
    painter.setBrush(Qt::NoBrush);
    painter.setPen(QPen(kWanted, 2.5));
    painter.drawRoundedRect(cell(guidance.requestedRegion).adjusted(1, 1, -1, -1), 2, 2);
  }
}

void BoardMap::paintOutlines(QPainter& painter, const QRectF& image) const {
  if (camera_.imageWidth == 0) {
    return;
  }
  QColor taken = palette().color(QPalette::Text);
  taken.setAlpha(90);
  painter.setBrush(Qt::NoBrush);
  painter.setPen(QPen(taken, 1.0));
  for (const auto& outline : camera_.capturedOutlines) {
    painter.drawPolygon(placed(outline, image, camera_.imageWidth, camera_.imageHeight));
  }
  if (camera_.outline.empty()) {
    return;
  }
  const bool lit = sinceTaken_.isValid() && sinceTaken_.elapsed() < kCellLitMs;
  painter.setPen(QPen(kSeenCell, lit ? 3.0 : 2.0));
  painter.setBrush(lit ? QBrush(QColor(kSeenCell.red(), kSeenCell.green(), kSeenCell.blue(), 150))
                       : QBrush(Qt::NoBrush));
  painter.drawPolygon(placed(camera_.outline, image, camera_.imageWidth, camera_.imageHeight));
}

void BoardMap::paintTilts(QPainter& painter, const QRectF& image) const {
  const double step = image.width() / BoardCoverage::kTiltCount;
  for (int k = 0; k < BoardCoverage::kTiltCount; ++k) {
    const auto tilt = static_cast<BoardTilt>(k);
    const bool wanted =
        camera_.lensGuidance.advice == GuidanceAdvice::TiltTo && camera_.lensGuidance.tilt == tilt;
    const int views = camera_.lensGuidance.coverage.tiltCounts[static_cast<std::size_t>(k)];
    QColor fill = palette().color(QPalette::Highlight);
    fill.setAlphaF(static_cast<float>(std::min(0.75, 0.25 * views)));
    painter.setBrush(fill);
    painter.setPen(QPen(wanted ? kWanted : palette().color(QPalette::Mid), wanted ? 2.5 : 1.0));
    painter.drawPolygon(tiltShape(
        tilt, QPointF(image.left() + (k + 0.5) * step, image.bottom() + 0.5 * kTiltHeight + 1.0)));
  }
}

void BoardMap::paintEvent(QPaintEvent*) {
  QPainter painter(this);
  painter.setRenderHint(QPainter::Antialiasing);
  const QRectF image = imageArea();
  painter.fillRect(image, palette().color(QPalette::Base));
  if (lens_) {
    paintRegions(painter, image);
    paintTilts(painter, image);
  }
  painter.setClipRect(image);
  paintOutlines(painter, image);
  painter.setClipping(false);
  painter.setBrush(Qt::NoBrush);
  painter.setPen(palette().color(QPalette::Mid));
  painter.drawRect(image);
}

} // namespace dewpoint::ui
