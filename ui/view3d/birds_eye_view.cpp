// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/view3d/birds_eye_view.h"

#include "core/calibration/planning/rig_map.h"
#include "ui/style/spacing.h"
#include "ui/view3d/gl_context.h"
#include "ui/view3d/scene_picture.h"
#include "ui/view3d/tail_pick.h"
#include "ui/view3d/view_projection.h"

#include <QHelpEvent>
#include <QKeyEvent>
#include <QLocale>
#include <QMouseEvent>
#include <QPainter>
#include <QToolTip>
#include <QWheelEvent>

#include <algorithm>
#include <cmath>
#include <utility>

namespace dewpoint::ui {
namespace {

constexpr double kClickPx = 4.0;      ///< a longer way of the pointer is a drag
constexpr double kTailReachPx = 12.0; ///< a click this near is meant for the tail

using PointerEvent = OffscreenVtk::PointerEvent;

} // namespace

void BirdsEyeView::prepareSurfaceFormat() {
  GlContext::prepareSurfaceFormat();
}

BirdsEyeView::BirdsEyeView(QWidget* parent)
    : QWidget(parent), picture_(std::make_unique<ScenePicture>(scene_, *this)),
      handles_(new CameraHandles(*this, scene_)), labels_(scene_), inset_(scene_), map_(scene_),
      buttons_(new ViewButtons(*this)) {
  setObjectName(QStringLiteral("birdsEyeView"));
  setAttribute(Qt::WA_OpaquePaintEvent);
  setFocusPolicy(Qt::StrongFocus);
  setSizePolicy(QSizePolicy::Expanding, QSizePolicy::Expanding);
  connect(picture_.get(), &ScenePicture::aboutToRender, this, &BirdsEyeView::updateScene);
  connect(picture_.get(), &ScenePicture::rendered, this, [this] {
    people_.setSnapshot(snapshot_.get());
    inset_.setSnapshot(snapshot_);
  });
  connect(picture_.get(), &ScenePicture::unavailable, this, [this] { buttons_->setShown(false); });
  buttons_->setCurrentView(scene_.view());
  connect(buttons_, &ViewButtons::viewChosen, this, &BirdsEyeView::setView);
  connect(buttons_, &ViewButtons::fitRequested, this, &BirdsEyeView::resetView);
  connect(handles_, &CameraHandles::cameraChosen, this, &BirdsEyeView::cameraChosen);
  connect(handles_, &CameraHandles::cameraDragged, this, &BirdsEyeView::cameraDragged);
  connect(handles_, &CameraHandles::cameraAimed, this, &BirdsEyeView::cameraAimed);
  connect(handles_, &CameraHandles::cameraDropped, this, &BirdsEyeView::cameraDropped);
  retranslateUi();
  applyTheme();
}

BirdsEyeView::~BirdsEyeView() = default;

void BirdsEyeView::retranslateUi() {
  scene_.setDecimalPoint(locale().decimalPoint().toStdString());
  requestRendering();
  setAccessibleName(tr("Bird's-eye view"));
  setAccessibleDescription(tr("The room in 3D: cameras, particles, estimates and their tracks"));
  buttons_->retranslateUi();
}

void BirdsEyeView::prepareFirstImage() {
  picture_->prepareFirstImage();
}

void BirdsEyeView::setSnapshot(const TrackSnapshotPtr& snapshot) {
  snapshot_ = snapshot;
  scene_.recordSnapshot(snapshot ? *snapshot : TrackSnapshot{});
  sceneStale_ = true;
  requestRendering();
}

void BirdsEyeView::copyAppearance(const BirdsEyeView& other) {
  scene_.copyView(other.scene_, static_cast<double>(width()) / std::max(1, height()));
  map_.setMap(other.map_.sharedMap(), other.map_.options());
  chosenTarget_ = other.chosenTarget_;
  buttons_->setCurrentView(scene_.view());
  sceneStale_ = true;
  requestRendering();
}

Scene3d::View BirdsEyeView::currentView() const {
  return scene_.view();
}

bool BirdsEyeView::hasImage() const {
  return picture_->failureReason().empty();
}

QSize BirdsEyeView::sizeHint() const {
  return {480, 360};
}

QSize BirdsEyeView::minimumSizeHint() const {
  return {200, 150};
}

void BirdsEyeView::setView(Scene3d::View view) {
  scene_.setView(view);
  buttons_->setCurrentView(view);
  requestRendering();
  Q_EMIT viewChanged(view);
}

void BirdsEyeView::resetView() {
  scene_.resetView();
  requestRendering();
}

void BirdsEyeView::highlight(const std::vector<std::vector<Eigen::Vector3d>>& strokes) {
  scene_.highlight(strokes);
  requestRendering();
}

void BirdsEyeView::requestRendering() {
  picture_->requestRendering();
}

bool BirdsEyeView::isDrawn() const {
  return !isVisible() || picture_->isUpToDate();
}

void BirdsEyeView::updateScene() {
  if (sceneStale_) {
    snapshot_ ? scene_.setSnapshot(*snapshot_) : scene_.clear();
    sceneStale_ = false;
  }
  map_.updateScene();
}

QImage BirdsEyeView::currentImage() {
  picture_->render();
  QImage picture = picture_->image();
  if (!picture.isNull()) {
    QPainter painter(&picture);
    paintOver(painter);
  }
  return picture;
}

void BirdsEyeView::paintOver(QPainter& painter) const {
  labels_.paint(painter, *this, inset_.shownArea(*this, chosenTarget_));
  inset_.paint(painter, *this, chosenTarget_);
  people_.paint(painter, *this, {*this, scene_}, chosenTarget_);
  map_.paintLegend(painter, *this);
}

void BirdsEyeView::paintEvent(QPaintEvent*) {
  if (hasImage() && !picture_->hasSizeOfView()) {
    picture_->render();
  }
  QPainter painter(this);
  if (picture_->image().isNull()) {
    painter.fillRect(rect(), palette().window());
    painter.setPen(palette().color(QPalette::WindowText));
    const QString text =
        tr("3D view not available: %1").arg(QString::fromStdString(picture_->failureReason()));
    painter.drawText(rect().adjusted(kSpacing, kSpacing, -kSpacing, -kSpacing),
                     Qt::AlignCenter | Qt::TextWordWrap, text);
    return;
  }
  painter.drawImage(QPointF(0, 0), picture_->image());
  paintOver(painter);
  handles_->paint(painter);
  if (hasFocus()) {
    painter.setPen(QPen(palette().color(QPalette::Highlight), 1));
    painter.drawRect(rect().adjusted(0, 0, -1, -1));
  }
}

void BirdsEyeView::resizeEvent(QResizeEvent* event) {
  QWidget::resizeEvent(event);
  buttons_->moveToCorner();
}

void BirdsEyeView::showEvent(QShowEvent* event) {
  QWidget::showEvent(event);
  if (picture_->isStale()) {
    requestRendering();
  }
}

void BirdsEyeView::changeEvent(QEvent* event) {
  QWidget::changeEvent(event);
  if (event->type() == QEvent::PaletteChange) {
    applyTheme();
  } else if (event->type() == QEvent::LanguageChange || event->type() == QEvent::LocaleChange) {
    retranslateUi();
  } else if (event->type() == QEvent::FontChange || event->type() == QEvent::StyleChange) {
    buttons_->moveToCorner();
  }
}

void BirdsEyeView::applyTheme() {
  scene_.setTheme(palette().color(QPalette::Window).lightnessF() < 0.5F);
  requestRendering();
}

void BirdsEyeView::sendPointer(int what, QPointF position, Qt::KeyboardModifiers modifiers) {
  // The flat views stay flat: there, dragging moves instead of turning.
  const bool shift = scene_.view() != Scene3d::View::Free || modifiers.testFlag(Qt::ShiftModifier);
  picture_->passPointerEvent(static_cast<PointerEvent>(what), position, shift);
}

void BirdsEyeView::mousePressEvent(QMouseEvent* event) {
  const auto press = event->button() == Qt::LeftButton     ? PointerEvent::LeftPress
                     : event->button() == Qt::MiddleButton ? PointerEvent::MiddlePress
                                                           : PointerEvent::RightPress;
  pressed_ = event->position();
  if (event->button() == Qt::LeftButton && hasImage() && handles_->grab(event->position())) {
    return;
  }
  sendPointer(static_cast<int>(press), event->position(), event->modifiers());
}

void BirdsEyeView::mouseReleaseEvent(QMouseEvent* event) {
  const auto release = event->button() == Qt::LeftButton     ? PointerEvent::LeftRelease
                       : event->button() == Qt::MiddleButton ? PointerEvent::MiddleRelease
                                                             : PointerEvent::RightRelease;
  if (event->button() == Qt::LeftButton && handles_->isDragging()) {
    handles_->endDrag();
    return;
  }
  sendPointer(static_cast<int>(release), event->position(), event->modifiers());
  const QPointF moved = event->position() - pressed_;
  if (event->button() == Qt::LeftButton && moved.manhattanLength() < kClickPx) {
    if (placing_) {
      clickFloor(event->position());
    } else if (const int person = people_.personAt({*this, scene_}, event->position());
               person >= 0) {
      Q_EMIT personClicked(person);
    } else {
      clickTail(event->position(), event->modifiers().testFlag(Qt::ShiftModifier));
    }
  }
}

void BirdsEyeView::clickTail(QPointF position, bool extend) {
  if (!snapshot_ || !hasImage()) {
    return;
  }
  const auto found = nearestTailPosition(*snapshot_, scene_,
                                         ViewProjection(*this, scene_).toRenderedImage(position),
                                         kTailReachPx * devicePixelRatioF());
  if (found) {
    Q_EMIT tailClicked(found->target, found->position, extend);
  }
}

void BirdsEyeView::mouseMoveEvent(QMouseEvent* event) {
  if (handles_->isDragging()) {
    handles_->drag(event->position());
    return;
  }
  sendPointer(static_cast<int>(PointerEvent::Move), event->position(), event->modifiers());
}

void BirdsEyeView::mouseDoubleClickEvent(QMouseEvent* event) {
  if (event->button() == Qt::LeftButton) {
    resetView();
  }
}

void BirdsEyeView::wheelEvent(QWheelEvent* event) {
  const double steps = event->angleDelta().y() / 120.0;
  scene_.zoom(std::pow(1.15, steps));
  requestRendering();
  event->accept();
}

void BirdsEyeView::keyPressEvent(QKeyEvent* event) {
  switch (event->key()) {
  case Qt::Key_Plus:
  case Qt::Key_Equal:
    scene_.zoom(1.15);
    requestRendering();
    break;
  case Qt::Key_Minus:
    scene_.zoom(1.0 / 1.15);
    requestRendering();
    break;
  case Qt::Key_Home:
    resetView();
    break;
  default:
    QWidget::keyPressEvent(event);
  }
}

void BirdsEyeView::setCameraHandles(std::vector<CameraHandle> handles, int chosen) {
  handles_->setHandles(std::move(handles), chosen);
}

void BirdsEyeView::showMap(std::shared_ptr<const RigMap> map, const MapOptions& look) {
  if (map_.setMap(std::move(map), look)) {
    requestRendering();
  }
}

void BirdsEyeView::showPlannedCameras(const CameraRig& cameras) {
  scene_.showPlannedCameras(cameras);
  requestRendering();
}

bool BirdsEyeView::event(QEvent* event) {
  if (event->type() == QEvent::ToolTip) {
    const auto* help = static_cast<QHelpEvent*>(event);
    const QString text =
        hasImage() ? map_.textAt({*this, scene_}, QPointF(help->pos())) : QString();
    if (!text.isEmpty()) {
      QToolTip::showText(help->globalPos(), text, this);
      return true;
    }
    QToolTip::hideText();
  }
  return QWidget::event(event);
}

void BirdsEyeView::setChosenTarget(int target) {
  chosenTarget_ = target;
  scene_.setChosenTarget(target);
  requestRendering();
}

void BirdsEyeView::setPersonPlacingMode(bool placing, double floor) {
  placing_ = placing;
  floor_ = floor;
  if (placing && (scene_.view() == Scene3d::View::Front || scene_.view() == Scene3d::View::Side)) {
    lookFromAbove(); // edge on, the floor has no places
  }
  setCursor(placing ? Qt::CrossCursor : Qt::ArrowCursor);
}

void BirdsEyeView::clickFloor(QPointF position) {
  if (!hasImage()) {
    return;
  }
  const ViewProjection projection(*this, scene_);
  if (const auto clicked = scene_.positionAtHeight(projection.toRenderedImage(position), floor_)) {
    Q_EMIT floorClicked(clicked->head<2>());
  }
}

} // namespace dewpoint::ui
