// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/view3d/birds_eye_view.h"

#include "ui/style/map_legend.h"
#include "ui/view3d/offscreen_vtk.h"

#include <QKeyEvent>
#include <QLocale>
#include <QMouseEvent>
#include <QPainter>
#include <QSurfaceFormat>
#include <QToolButton>
#include <QWheelEvent>

#include <algorithm>
#include <cmath>
#include <utility>

namespace dewpoint::ui {
namespace {

/// At most about 15 pictures a second, and never more than half of one processor's time.
constexpr double kClickPx = 4.0;      ///< a longer way of the pointer is a drag
constexpr double kTailReachPx = 12.0; ///< a click this near is meant for the tail
constexpr qint64 kPictureIntervalMs = 66;
constexpr int kSpacing = 8;
constexpr std::array<Scene3d::View, 3> kViews{Scene3d::View::Above, Scene3d::View::Front,
                                              Scene3d::View::Free};

using Pointer = OffscreenVtk::Pointer;

} // namespace

void BirdsEyeView::prepareSurfaceFormat() {
  QSurfaceFormat format;
  format.setRenderableType(QSurfaceFormat::OpenGL);
  format.setVersion(3, 2);
  format.setProfile(QSurfaceFormat::CoreProfile);
  format.setDepthBufferSize(24);
  format.setStencilBufferSize(8);
  format.setSamples(0);
  QSurfaceFormat::setDefaultFormat(format);
}

BirdsEyeView::BirdsEyeView(QWidget* parent) : QWidget(parent) {
  setObjectName(QStringLiteral("birdsEyeView"));
  setAttribute(Qt::WA_OpaquePaintEvent);
  setFocusPolicy(Qt::StrongFocus);
  setSizePolicy(QSizePolicy::Expanding, QSizePolicy::Expanding);
  timer_.setSingleShot(true);
  connect(&timer_, &QTimer::timeout, this, &BirdsEyeView::renderPicture);
  makeButtons();
  retranslate();
  applyTheme();
}

BirdsEyeView::~BirdsEyeView() = default;

void BirdsEyeView::makeButtons() {
  const std::array<QString, 3> names{QStringLiteral("lookFromAboveButton"),
                                     QStringLiteral("lookFromFrontButton"),
                                     QStringLiteral("lookFreeButton")};
  for (std::size_t i = 0; i < kViews.size(); ++i) {
    auto* button = new QToolButton(this);
    button->setObjectName(names[i]);
    button->setCheckable(true);
    button->setAutoFillBackground(true);
    button->setCursor(Qt::ArrowCursor);
    connect(button, &QToolButton::clicked, this, [this, i] { look(kViews[i]); });
    buttons_[i] = button;
  }
  checkButtons();
}

void BirdsEyeView::placeButtons() {
  int x = kSpacing;
  for (QToolButton* button : buttons_) {
    const QSize size = button->sizeHint();
    button->setGeometry(QRect(QPoint(x, height() - size.height() - kSpacing), size));
    button->setVisible(failure_.empty());
    x += size.width() + kSpacing / 2;
  }
}

void BirdsEyeView::checkButtons() {
  for (std::size_t i = 0; i < kViews.size(); ++i) {
    buttons_[i]->setChecked(scene_.view() == kViews[i]);
  }
}

void BirdsEyeView::retranslate() {
  scene_.setDecimalPoint(locale().decimalPoint().toStdString());
  requestPicture();
  setAccessibleName(tr("Bird's-eye view"));
  setAccessibleDescription(tr("The room in 3D: cameras, particles, estimates and their tracks"));
  const std::array<QString, 3> texts{tr("Above"), tr("Front"), tr("Free")};
  const std::array<QString, 3> tips{
      tr("Look from above: X to the right, Y up. Drag to move, wheel to zoom, double click to see "
         "everything."),
      tr("Look from the front: X to the right, Z up. Drag to move, wheel to zoom, double click to "
         "see everything."),
      tr("Perspective. Drag to orbit, Shift and drag to move, wheel to zoom, double click to see "
         "everything.")};
  for (std::size_t i = 0; i < kViews.size(); ++i) {
    buttons_[i]->setText(texts[i]);
    buttons_[i]->setToolTip(tips[i]);
    buttons_[i]->setAccessibleDescription(tips[i]);
  }
  placeButtons();
}

void BirdsEyeView::startVtk() {
  if (started_) {
    return;
  }
  started_ = true;
  vtk_ = std::make_unique<OffscreenVtk>(scene_.renderer());
  if (!vtk_->start()) {
    failure_ = vtk_->reason();
    vtk_.reset();
    placeButtons();
    return;
  }
  vtk_->onCameraMoved = [this] {
    scene_.keepCamera();
    requestPicture();
  };
}

void BirdsEyeView::prepare() {
  startVtk();
  if (vtk_) {
    constexpr QSize kSmall(64, 64);
    scene_.prepareFrame(kSmall.width(), kSmall.height());
    vtk_->render(kSmall);
  }
}

void BirdsEyeView::setSnapshot(const TrackSnapshotPtr& snapshot) {
  snapshot_ = snapshot;
  sceneStale_ = true;
  requestPicture();
}

void BirdsEyeView::startAnew() {
  look(Scene3d::View::Above);
}

Scene3d::View BirdsEyeView::currentView() const {
  return scene_.view();
}

bool BirdsEyeView::hasPicture() const {
  return failure_.empty();
}

QSize BirdsEyeView::sizeHint() const {
  return {480, 360};
}

QSize BirdsEyeView::minimumSizeHint() const {
  return {200, 150};
}

void BirdsEyeView::look(Scene3d::View view) {
  scene_.look(view);
  checkButtons();
  requestPicture();
  Q_EMIT viewChanged(view);
}

void BirdsEyeView::lookFromAbove() {
  look(Scene3d::View::Above);
}
void BirdsEyeView::lookFromFront() {
  look(Scene3d::View::Front);
}
void BirdsEyeView::lookFree() {
  look(Scene3d::View::Free);
}

void BirdsEyeView::resetView() {
  scene_.resetView();
  requestPicture();
}

QSize BirdsEyeView::pictureSize() const {
  return (QSizeF(size()) * devicePixelRatioF()).toSize().expandedTo(QSize(1, 1));
}

void BirdsEyeView::highlight(const std::vector<std::vector<Eigen::Vector3d>>& strokes) {
  scene_.highlight(strokes);
  requestPicture();
}

void BirdsEyeView::requestPicture() {
  pictureStale_ = true;
  if (!isVisible() || timer_.isActive()) {
    return; // hidden: drawn when shown
  }
  const qint64 interval = std::max(kPictureIntervalMs, 2 * pictureMs_);
  const qint64 elapsed = sincePicture_.isValid() ? sincePicture_.elapsed() : interval;
  timer_.start(static_cast<int>(std::max<qint64>(0, interval - elapsed)));
}

void BirdsEyeView::renderPicture() {
  startVtk();
  pictureStale_ = false;
  if (vtk_) {
    QElapsedTimer clock;
    clock.start();
    if (sceneStale_) {
      snapshot_ ? scene_.show(*snapshot_) : scene_.clear();
      sceneStale_ = false;
    }
    if (std::exchange(mapStale_, false)) {
      scene_.showMap(map_, mapLook_);
    }
    const QSize size = pictureSize();
    scene_.setPixelRatio(devicePixelRatioF());
    scene_.prepareFrame(size.width(), size.height());
    picture_ = vtk_->render(size);
    markPeople();
    picture_.setDevicePixelRatio(devicePixelRatioF());
    pictureMs_ = clock.elapsed();
    sincePicture_.start();
  }
  update();
}

QImage BirdsEyeView::currentPicture() {
  renderPicture();
  QImage picture = picture_;
  if (!picture.isNull()) {
    QPainter painter(&picture);
    paintPeople(painter);
    if (map_ != nullptr) {
      paintMapLegend(painter, rect(), mapLook_, palette());
    }
  }
  return picture;
}

void BirdsEyeView::paintEvent(QPaintEvent*) {
  const bool fits = picture_.size() == pictureSize() &&
                    qFuzzyCompare(picture_.devicePixelRatio(), devicePixelRatioF());
  if (failure_.empty() && !fits) {
    renderPicture();
  }
  QPainter painter(this);
  if (picture_.isNull()) {
    painter.fillRect(rect(), palette().window());
    painter.setPen(palette().color(QPalette::WindowText));
    const QString text = tr("No 3D: %1").arg(QString::fromStdString(failure_));
    painter.drawText(rect().adjusted(kSpacing, kSpacing, -kSpacing, -kSpacing),
                     Qt::AlignCenter | Qt::TextWordWrap, text);
    return;
  }
  painter.drawImage(QPointF(0, 0), picture_);
  paintPeople(painter);
  paintHandles(painter);
  if (map_ != nullptr) {
    paintMapLegend(painter, rect(), mapLook_, palette());
  }
  if (hasFocus()) {
    painter.setPen(QPen(palette().color(QPalette::Highlight), 1));
    painter.drawRect(rect().adjusted(0, 0, -1, -1));
  }
}

void BirdsEyeView::resizeEvent(QResizeEvent* event) {
  QWidget::resizeEvent(event);
  placeButtons();
}

void BirdsEyeView::showEvent(QShowEvent* event) {
  QWidget::showEvent(event);
  if (pictureStale_) {
    requestPicture();
  }
}

void BirdsEyeView::changeEvent(QEvent* event) {
  QWidget::changeEvent(event);
  if (event->type() == QEvent::PaletteChange) {
    applyTheme();
  } else if (event->type() == QEvent::LanguageChange || event->type() == QEvent::LocaleChange) {
    retranslate();
  } else if (event->type() == QEvent::FontChange || event->type() == QEvent::StyleChange) {
    placeButtons();
  }
}

void BirdsEyeView::applyTheme() {
  scene_.setTheme(palette().color(QPalette::Window).lightnessF() < 0.5F);
  requestPicture();
}

void BirdsEyeView::sendPointer(int what, QPointF position, Qt::KeyboardModifiers modifiers) {
  if (!vtk_) {
    return;
  }
  // The flat views stay flat: there, dragging moves instead of turning.
  const bool shift = scene_.view() != Scene3d::View::Free || modifiers.testFlag(Qt::ShiftModifier);
  vtk_->pointer(static_cast<Pointer>(what), (position * devicePixelRatioF()).toPoint(), shift,
                false);
}

void BirdsEyeView::mousePressEvent(QMouseEvent* event) {
  const auto press = event->button() == Qt::LeftButton     ? Pointer::LeftPress
                     : event->button() == Qt::MiddleButton ? Pointer::MiddlePress
                                                           : Pointer::RightPress;
  pressed_ = event->position();
  if (event->button() == Qt::LeftButton && takeHandle(event->position())) {
    return;
  }
  sendPointer(static_cast<int>(press), event->position(), event->modifiers());
}

void BirdsEyeView::mouseReleaseEvent(QMouseEvent* event) {
  const auto release = event->button() == Qt::LeftButton     ? Pointer::LeftRelease
                       : event->button() == Qt::MiddleButton ? Pointer::MiddleRelease
                                                             : Pointer::RightRelease;
  if (event->button() == Qt::LeftButton && heldHandle_) {
    heldHandle_.reset();
    Q_EMIT cameraDropped();
    update();
    return;
  }
  sendPointer(static_cast<int>(release), event->position(), event->modifiers());
  const QPointF moved = event->position() - pressed_;
  if (event->button() == Qt::LeftButton && moved.manhattanLength() < kClickPx) {
    if (placing_) {
      clickFloor(event->position());
    } else if (!clickPerson(event->position())) {
      clickTail(event->position(), event->modifiers().testFlag(Qt::ShiftModifier));
    }
  }
}

void BirdsEyeView::clickTail(QPointF position, bool extend) {
  if (!snapshot_ || !hasPicture()) {
    return;
  }
  const Eigen::Vector2d clicked = inPicture(position);
  double nearest = kTailReachPx * devicePixelRatioF();
  int target = -1;
  Eigen::Vector3d place = Eigen::Vector3d::Zero();
  for (std::size_t k = 0; k < snapshot_->targets.size(); ++k) {
    for (const Eigen::Vector3d& point : snapshot_->targets[k].tail) {
      const double away = (scene_.placeInPicture(point) - clicked).norm();
      if (away < nearest) {
        nearest = away;
        target = static_cast<int>(k);
        place = point;
      }
    }
  }
  if (target >= 0) {
    Q_EMIT tailClicked(target, place, extend);
  }
}

void BirdsEyeView::mouseMoveEvent(QMouseEvent* event) {
  if (heldHandle_) {
    dragHandle(event->position());
    return;
  }
  sendPointer(static_cast<int>(Pointer::Move), event->position(), event->modifiers());
}

void BirdsEyeView::mouseDoubleClickEvent(QMouseEvent* event) {
  if (event->button() == Qt::LeftButton) {
    resetView();
  }
}

void BirdsEyeView::wheelEvent(QWheelEvent* event) {
  const double steps = event->angleDelta().y() / 120.0;
  scene_.zoom(std::pow(1.15, steps));
  requestPicture();
  event->accept();
}

void BirdsEyeView::keyPressEvent(QKeyEvent* event) {
  switch (event->key()) {
  case Qt::Key_Plus:
  case Qt::Key_Equal:
    scene_.zoom(1.15);
    requestPicture();
    break;
  case Qt::Key_Minus:
    scene_.zoom(1.0 / 1.15);
    requestPicture();
    break;
  case Qt::Key_Home:
    resetView();
    break;
  default:
    QWidget::keyPressEvent(event);
  }
}

} // namespace dewpoint::ui
