// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/calibration/manual/grid_layer.h"

#include "ui/calibration/manual/grid_painter.h"
#include "ui/calibration/manual/nudge_keys.h"
#include "ui/calibration/manual_calibration.h"
#include "ui/calibration/points/point_calibrator.h"
#include "ui/calibration/snapped_click.h"
#include "ui/cameraview/camera_view.h"
#include "ui/cameraview/loupe.h"
#include "ui/text/retranslation.h"

#include <QKeyEvent>
#include <QLineF>
#include <QMouseEvent>
#include <QPainter>

#include <algorithm>
#include <cmath>
#include <utility>

namespace dewpoint::ui {
namespace {

constexpr double kReachPx = 9.0; ///< of the widget: a crossing, pin or corner this near is meant
constexpr double kDragPx = 3.0;

} // namespace

GridLayer::GridLayer(int camera, CameraView* view, ManualCalibration& manual,
                     PointCalibrator& points)
    : QWidget(view), camera_(camera), view_(view), manual_(manual), points_(points) {
  setObjectName(QStringLiteral("gridLayer%1").arg(camera));
  setFocusPolicy(Qt::StrongFocus);
  setMouseTracking(true);
  setGeometry(view->rect());
  view->installEventFilter(this);
  connect(&manual_, &ManualCalibration::changed, this, &GridLayer::refresh);
  connect(&points_, &PointCalibrator::changed, this, &GridLayer::refresh);
  onRetranslate(this, [this] { retranslateUi(); });
  refresh();
}

void GridLayer::retranslateUi() {
  setAccessibleName(tr("Grid over the image of %1").arg(manual_.nameOf(camera_)));
  setAccessibleDescription(tr("Drag the grid onto the real scene. Click a point to hold it. Arrow "
                              "keys, W A S D, Q and E move or rotate the camera"));
}

void GridLayer::refresh() {
  if (isHidden() == manual_.takesClicks()) {
    setVisible(manual_.takesClicks());
    raise();
  }
  if (manual_.takesClicks()) {
    setCursor(points_.clicksPlacePoint() ? Qt::CrossCursor : Qt::ArrowCursor);
    update();
  }
}

bool GridLayer::eventFilter(QObject* watched, QEvent* event) {
  if (watched == view_ && event->type() == QEvent::Resize) {
    setGeometry(view_->rect());
  }
  return false;
}

void GridLayer::setSnapshot(const TrackSnapshotPtr& snapshot) {
  snapshot_ = snapshot;
  update();
}

FramePtr GridLayer::frame() const {
  const auto index = static_cast<std::size_t>(camera_);
  const bool there = snapshot_ && snapshot_->frames && index < snapshot_->frames->frames.size();
  return there ? snapshot_->frames->frames[index] : nullptr;
}

Eigen::Vector2d GridLayer::pixelAt(QPointF position) const {
  const QPointF pixel = view_->placement().pixelAt(position);
  return {pixel.x(), pixel.y()};
}

bool GridLayer::isInside(const Eigen::Vector2d& pixel) const {
  const QSize size = view_->imageSize();
  return pixel.x() >= -0.5 && pixel.y() >= -0.5 && pixel.x() < size.width() - 0.5 &&
         pixel.y() < size.height() - 0.5;
}

double GridLayer::toImagePixels(double widgetPixels) const {
  return widgetPixels / view_->placement().scale;
}

Eigen::Vector2d GridLayer::clicked(QPointF position, Qt::KeyboardModifiers modifiers) const {
  return snappedClick(snapshot_, camera_, pixelAt(position), modifiers.testFlag(Qt::AltModifier));
}

void GridLayer::placeClick(QMouseEvent* event) {
  const Eigen::Vector2d pixel = clicked(event->position(), event->modifiers());
  manual_.selectCamera(camera_);
  const bool isRecording = snapshot_ && snapshot_->frameCount && snapshot_->frame >= 0;
  points_.setClick(camera_, pixel, isRecording ? std::optional(snapshot_->frame) : std::nullopt);
}

void GridLayer::mousePressEvent(QMouseEvent* event) {
  const Eigen::Vector2d pixel = pixelAt(event->position());
  if (event->button() != Qt::LeftButton || !isInside(pixel)) {
    return;
  }
  manual_.selectCamera(camera_);
  if (points_.clicksPlacePoint()) {
    placeClick(event);
    return;
  }
  pressed_ = event->position();
}

void GridLayer::mouseMoveEvent(QMouseEvent* event) {
  pointer_ = event->position();
  exact_ = event->modifiers().testFlag(Qt::AltModifier);
  if (points_.clicksPlacePoint()) {
    update();
    return;
  }
  if (!pressed_) {
    return;
  }
  const QPointF way = event->position() - *pressed_;
  if (!manual_.isDragging() && std::hypot(way.x(), way.y()) >= kDragPx) {
    manual_.beginDrag(camera_, pixelAt(*pressed_), toImagePixels(kReachPx));
  }
  if (manual_.isDragging()) {
    manual_.dragTo(pixelAt(event->position()));
  }
}

void GridLayer::mouseReleaseEvent(QMouseEvent* event) {
  if (event->button() != Qt::LeftButton || !pressed_) {
    return;
  }
  const QPointF from = *std::exchange(pressed_, std::nullopt);
  if (manual_.isDragging()) {
    manual_.endDrag();
  } else {
    const auto before = manual_.pins(camera_).size();
    manual_.togglePin(camera_, pixelAt(from), toImagePixels(kReachPx));
    const auto after = manual_.pins(camera_).size();
    lastClick_ = after > before ? Click::SetPin : after < before ? Click::RemovedPin : Click::None;
  }
}

void GridLayer::mouseDoubleClickEvent(QMouseEvent* event) {
  const Eigen::Vector2d pixel = pixelAt(event->position());
  const bool isForGrid = points_.clicksPlacePoint() || lastClick_ == Click::RemovedPin ||
                         manual_.hasGridCrossingNear(camera_, pixel, toImagePixels(kReachPx));
  if (event->button() == Qt::LeftButton && !isForGrid && view_->isZoomed()) {
    if (lastClick_ == Click::SetPin) { // by the first of the two clicks
      manual_.togglePin(camera_, pixel, toImagePixels(kReachPx));
    }
    lastClick_ = Click::None;
    view_->fitImage();
  } else {
    mousePressEvent(event); // two clicks
  }
}

void GridLayer::focusOutEvent(QFocusEvent* event) {
  if (manual_.areEarlierCamerasShown()) {
    manual_.showEarlierCameras({}); // the release of the key will not come
  }
  QWidget::focusOutEvent(event);
}

void GridLayer::hideEvent(QHideEvent* event) {
  QWidget::hideEvent(event);
  edgeJob_.cancel(); // other images are shown when it comes back
  requestedEdges_ = {};
  edgesSource_ = {};
  edges_ = {};
}

void GridLayer::leaveEvent(QEvent*) {
  pointer_.reset();
  update();
}

bool GridLayer::event(QEvent* event) {
  // Keys that are shortcuts elsewhere in the window (A, E, ...) mean movements here.
  if (event->type() == QEvent::ShortcutOverride) {
    auto* key = static_cast<QKeyEvent*>(event);
    const bool isOwn = key->key() == Qt::Key_Escape || key->key() == Qt::Key_Delete ||
                       (key->key() == Qt::Key_B && key->modifiers() == Qt::NoModifier);
    if (isOwn || nudgeForKey(*key, manual_.keyMode())) {
      event->accept();
      return true;
    }
  }
  return QWidget::event(event);
}

void GridLayer::keyPressEvent(QKeyEvent* event) {
  if (event->key() == Qt::Key_Escape) {
    if (manual_.isDragging()) {
      pressed_.reset();
      manual_.cancelDrag();
    } else if (points_.clicksPlacePoint()) {
      points_.setClicksPlacePoint(false);
    } else {
      manual_.clearPins();
    }
    return;
  }
  if (event->key() == Qt::Key_B) {
    manual_.showEarlierCameras(manual_.comparedCameras());
    return;
  }
  if (event->key() == Qt::Key_Delete) {
    points_.removeClick(camera_);
    return;
  }
  if (const auto nudge = nudgeForKey(*event, manual_.keyMode()); nudge && !manual_.isDragging()) {
    manual_.selectCamera(camera_);
    nudge->axis < 0 ? manual_.nudgeFocalLength(nudge->stepsOrPercent, event->isAutoRepeat())
                    : manual_.nudge(nudge->axis, nudge->stepsOrPercent, event->isAutoRepeat());
    return;
  }
  QWidget::keyPressEvent(event);
}

void GridLayer::keyReleaseEvent(QKeyEvent* event) {
  if (!event->isAutoRepeat()) {
    manual_.endStepMerging();
    if (event->key() == Qt::Key_B) {
      manual_.showEarlierCameras({});
    }
  }
  QWidget::keyReleaseEvent(event);
}

GridLayer::EdgeSource GridLayer::edgeSource() const {
  const FramePtr image = frame();
  if (!manual_.areEdgesShown() || !image || image->image.empty()) {
    return {};
  }
  const QSizeF area = QSizeF(view_->imageSize()) * view_->placement().scale;
  // A zoomed image has no more edges than its own pixels show.
  return {image, (area * devicePixelRatioF()).toSize().boundedTo(view_->imageSize())};
}

bool GridLayer::isDrawn() const {
  return !isVisible() || edgesSource_ == edgeSource();
}

void GridLayer::followEdges() {
  const EdgeSource wanted = edgeSource();
  if (wanted == edgesSource_ || wanted == requestedEdges_) {
    return;
  }
  requestedEdges_ = wanted;
  if (wanted.frame == nullptr || wanted.size.isEmpty()) {
    edgeJob_.cancel();
    edgesSource_ = wanted;
    edges_ = {};
    return;
  }
  edgeJob_.start([this, wanted](const BackgroundJob::Progress&) {
    const QImage found = edgeImage(wanted.frame->image, wanted.size);
    return [this, wanted, found] {
      edgesSource_ = wanted;
      edges_ = found;
      update();
    };
  });
}

void GridLayer::drawEdges(QPainter& painter) {
  followEdges();
  if (edges_.isNull()) {
    return;
  }
  const QRectF area(view_->placement().topLeft,
                    QSizeF(view_->imageSize()) * view_->placement().scale);
  painter.fillRect(area, QColor(0, 0, 0, 120)); // the rest steps back
  painter.drawImage(area, edges_);
}

void GridLayer::drawPoints(QPainter& painter) {
  const Projector projector(manual_.shownCamera(camera_));
  const ImagePlacement& placement = view_->placement();
  const auto& all = points_.points();
  std::vector<PaintedPoint> shown;
  for (std::size_t k = 0; k < all.size(); ++k) {
    PaintedPoint& painted = shown.emplace_back();
    painted.name = QString::fromStdString(all[k].name);
    painted.isSelected = static_cast<int>(k) == points_.selectedPoint();
    painted.isInOtherFrames =
        !painted.isSelected && snapshot_ && isClickedOnlyInOtherFrames(all[k], snapshot_->frame);
    painted.isMisfit = points_.misfitPoint() == static_cast<int>(k);
    if (const PointClick* click = findClick(all[k], camera_)) {
      painted.click = widgetPosition(click->pixel, placement);
    }
    if (const auto seen = projector.project(all[k].world); seen && isInside(*seen)) {
      painted.projection = widgetPosition(*seen, placement);
    }
  }
  paintPoints(painter, shown);
}

void GridLayer::drawMagnifier(QPainter& painter) {
  const FramePtr image = frame();
  if (!points_.clicksPlacePoint() || !pointer_ || !image || !isInside(pixelAt(*pointer_))) {
    return;
  }
  const Eigen::Vector2d pixel = pixelAt(*pointer_);
  const Eigen::Vector2d meant =
      clicked(*pointer_, exact_ ? Qt::AltModifier : Qt::KeyboardModifiers());
  const QRectF place = loupeRect(*pointer_, size());
  if (!place.isEmpty()) {
    painter.save();
    painter.setClipping(false);
    paintLoupe(painter, place, image->image, {pixel.x(), pixel.y()}, {meant.x(), meant.y()});
    painter.restore();
  }
}

bool GridLayer::isGridInSight() const {
  const QRectF area = view_->shownArea();
  // A line that crosses the area also crosses one of its diagonals.
  const QLineF diagonals[] = {{area.topLeft(), area.bottomRight()},
                              {area.topRight(), area.bottomLeft()}};
  for (const auto& stroke : projectGrid(manual_.shownCamera(camera_), manual_.grid()).strokes) {
    for (std::size_t k = 0; k < stroke.points.size(); ++k) {
      const QPointF to = widgetPosition(stroke.points[k], view_->placement());
      const QLineF part(widgetPosition(stroke.points[k == 0 ? 0 : k - 1], view_->placement()), to);
      if (area.contains(to) || std::ranges::any_of(diagonals, [&part](const QLineF& diagonal) {
            return part.intersects(diagonal) == QLineF::BoundedIntersection;
          })) {
        return true;
      }
    }
  }
  return false;
}

QString GridLayer::shownLabel() const {
  return !manual_.areEarlierCamerasShown() ? QString()
         : isGridInSight()                 ? tr("before")
                           : tr("The earlier grid is outside the visible part of the image");
}

void GridLayer::drawLabel(QPainter& painter) {
  const QString text = shownLabel();
  if (text.isEmpty()) {
    return;
  }
  const int room = std::max(1, static_cast<int>(view_->shownArea().width()) - 32);
  const QRectF box = painter.fontMetrics()
                         .boundingRect(QRect(0, 0, room, height()), Qt::TextWordWrap, text)
                         .toRectF()
                         .adjusted(-8, -4, 8, 4);
  const QRectF label(view_->shownArea().topLeft() + QPointF(8.0, 8.0), box.size());
  painter.fillRect(label, QColor(0, 0, 0, 180));
  painter.setPen(QColor("#f0e442"));
  painter.drawText(label, Qt::AlignCenter | Qt::TextWordWrap, text);
}

void GridLayer::paintEvent(QPaintEvent*) {
  if (view_->imageSize().isEmpty()) {
    return;
  }
  QPainter painter(this);
  const ImagePlacement& placement = view_->placement();
  painter.setClipRect(view_->shownArea().toAlignedRect()); // whole pixels are clipped faster
  drawEdges(painter);
  const Camera camera = manual_.shownCamera(camera_);
  paintGrid(painter, projectGrid(camera, manual_.grid()), placement, manual_.gridOpacity());
  const Projector projector(camera);
  for (const Eigen::Vector3d& pin : manual_.pins(camera_)) {
    if (const auto at = projector.project(pin)) {
      paintPin(painter, widgetPosition(*at, placement));
    }
  }
  if (const auto grip = manual_.draggedPoint(); grip && manual_.camera() == camera_) {
    if (const auto at = projector.project(*grip)) {
      paintGrip(painter, widgetPosition(*at, placement));
    }
  }
  drawPoints(painter);
  drawMagnifier(painter);
  drawLabel(painter);
  if (manual_.camera() == camera_) {
    painter.setClipping(false);
    painter.setPen(QPen(palette().color(QPalette::Highlight), hasFocus() ? 3 : 1));
    painter.drawRect(rect().adjusted(1, 1, -2, -2));
  }
}

} // namespace dewpoint::ui
