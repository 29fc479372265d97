// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/timeline/timeline.h"

#include "core/session/frames/trouble_search.h"
#include "core/session/view/target_colors.h"
#include "ui/document/document.h"
#include "ui/text/reason_text.h"
#include "ui/text/retranslation.h"
#include "ui/timeline/marker_editor.h"

#include <QAccessible>
#include <QHelpEvent>
#include <QKeyEvent>
#include <QMouseEvent>
#include <QPainter>
#include <QToolTip>

#include <algorithm>
#include <cmath>

namespace dewpoint::ui {

namespace {

constexpr double kZoomStep = 1.25;
constexpr double kWidestGutter = 160.0;

} // namespace

Timeline::Timeline(Selection& selection, Document& document, QWidget* parent)
    : QWidget(parent), selection_(selection), document_(document),
      markers_(new MarkerEditor(*this, document)) {
  setObjectName(QStringLiteral("timeline"));
  setFocusPolicy(Qt::StrongFocus);
  setMouseTracking(true);
  onRetranslate(this, [this] {
    setAccessibleName(tr("Timeline"));
    markers_->retranslateUi();
    update();
  });
  connect(&selection_, &Selection::currentFrameChanged, this, [this] {
    announceFrame();
    update();
  });
  connect(&selection_, &Selection::selectedRangeChanged, this, qOverload<>(&QWidget::update));
  connect(&document_, &Document::changed, this, &Timeline::updateMarkers);
  connect(&document_, &Document::projectReplaced, this, &Timeline::updateMarkers);
  updateMarkers();
}

void Timeline::setSnapshot(const TrackSnapshotPtr& shown) {
  if (!shown) {
    clear();
    return;
  }
  const TrackSnapshot& snapshot = *shown;
  model_.history = snapshot.history;
  model_.rerun = snapshot.rerun;
  model_.setSourceFrameRate(snapshot.sourceFramesPerSecond);
  model_.isLive = snapshot.frames != nullptr && !snapshot.frameCount.has_value();
  QStringList targets;
  for (const TargetSnapshot& target : snapshot.targets) {
    targets.append(QString::fromStdString(target.target.name));
  }
  model_.colorSources = displayColorSources(snapshot);
  const QStringList cameras = cameraNames(snapshot);
  if (targets != model_.targetNames || cameras != model_.cameraNames) {
    model_.targetNames = targets;
    model_.cameraNames = cameras;
    place();
  }
  const qint64 oldest =
      model_.records.empty() ? model_.history.firstFrame : model_.records.front().frame;
  const qint64 first = model_.isLive ? std::min<qint64>(oldest, model_.history.firstFrame) : 0;
  const qint64 last =
      model_.isLive ? model_.history.lastFrame : snapshot.frameCount.value_or(1) - 1;
  scale_.setExtent(first, std::max(first, last));
  requested_.onFrameShown(snapshot.frame);
  const int least = TimelineRows::minimumHeightFor(
      static_cast<int>(targets.size()), dropoutCameraCount(), QFontMetricsF(font()).height());
  if (least != minimumHeight_) {
    minimumHeight_ = least;
    updateGeometry();
  }
  if (!scale_.showsWholeRun() && drag_ == Drag::None) {
    scale_.reveal(std::max<qint64>(0, snapshot.frame));
  }
  update();
}

void Timeline::append(const std::vector<FrameRecord>& records, bool restarted) {
  model_.append(records, restarted);
  if (restarted || !records.empty()) {
    update();
  }
}

void Timeline::clear() {
  model_ = TimelineModel{};
  scale_ = TimelineScale{};
  hovered_ = -1;
  requested_.forget();
  place();
  updateMarkers();
}

int Timeline::dropoutCameraCount() const {
  int cameras = 0;
  for (int k = 0; k < model_.cameraNames.size(); ++k) {
    cameras += model_.hasDropouts(static_cast<std::size_t>(k)) ? 1 : 0;
  }
  return cameras;
}

TimelineRows Timeline::rows() const {
  return TimelineRows(size(), static_cast<int>(model_.targetNames.size()), dropoutCameraCount(),
                      QFontMetricsF(font()).height(), gutter_, model_.rerun.has_value());
}

void Timeline::place() {
  const QFontMetricsF metrics(font());
  double widest = 40.0;
  for (const QString& name : model_.targetNames + model_.cameraNames) {
    widest = std::max(widest, metrics.horizontalAdvance(name) + 18.0);
  }
  gutter_ = std::min(kWidestGutter, widest + 20.0);
  const QRectF axis = rows().axisArea;
  scale_.setPixelRange(axis.left(), axis.width());
}

QPoint Timeline::positionOf(qint64 frame) const {
  return QPointF(scale_.xOf(static_cast<double>(frame) + 0.5), rows().ribbonArea(0).center().y())
      .toPoint();
}

void Timeline::step(qint64 frames) {
  requestFrame(latestFrame() + frames);
}

qint64 Timeline::latestFrame() const {
  return requested_.frame().value_or(std::max<qint64>(0, selection_.currentFrame()));
}

void Timeline::requestFrame(qint64 frame, bool extendsRange) {
  const qint64 before = latestFrame();
  const auto [first, last] = reachableFrames();
  frame = std::clamp(frame, first, last);
  if (extendsRange) {
    anchor_ = selection_.selectedRange() && anchor_ >= 0 ? anchor_ : before;
    selection_.selectRange(SelectedRange{anchor_, frame});
  } else {
    anchor_ = -1;
  }
  if (frame != before) {
    requested_.request(frame);
    selection_.requestFrame(frame);
  }
}

void Timeline::selectTo(qint64 frame) {
  selection_.selectRange(SelectedRange{anchor_, frame});
}

void Timeline::zoomToRange() {
  if (selection_.selectedRange()) {
    scale_.showFrames(selection_.selectedRange()->first, selection_.selectedRange()->last);
    update();
  }
}

void Timeline::zoomOut() {
  scale_.showWholeRun();
  update();
}

bool Timeline::event(QEvent* event) {
  if (event->type() == QEvent::ToolTip) {
    const auto* help = static_cast<QHelpEvent*>(event);
    if (help->pos().x() >= gutter_ && !model_.targetNames.isEmpty()) {
      QToolTip::showText(help->globalPos(), model_.descriptionOf(scale_.frameAt(help->pos().x())),
                         this);
    }
    return true;
  }
  return QWidget::event(event);
}

void Timeline::paintEvent(QPaintEvent*) {
  QPainter painter(this);
  painter.fillRect(rect(), palette().color(QPalette::Window));
  if (model_.history.lastFrame < 0) {
    painter.setPen(palette().color(QPalette::PlaceholderText));
    painter.drawText(
        rect().adjusted(16, 0, -16, 0), Qt::AlignCenter | Qt::TextWordWrap,
        tr("Nothing tracked yet: press play (Space), then drag here to move through time."));
    return;
  }
  paintTimeline(painter, model_, scale_, rows(), selection_, hovered_, palette());
  if (hasFocus()) {
    painter.setPen(QPen(palette().color(QPalette::Highlight), 1.0));
    painter.setBrush(Qt::NoBrush);
    painter.drawRect(QRectF(rect()).adjusted(0.5, 0.5, -0.5, -0.5));
  }
}

void Timeline::resizeEvent(QResizeEvent* event) {
  QWidget::resizeEvent(event);
  place();
}

void Timeline::mousePressEvent(QMouseEvent* event) {
  if (event->button() != Qt::LeftButton || model_.history.lastFrame < 0) {
    return;
  }
  const qint64 frame = scale_.frameAt(event->position().x());
  if (const auto marker = markerAt(event->position())) {
    requestFrame(model_.markers[*marker].frame);
    return;
  }
  const bool inAxis = event->position().y() < rows().axisArea.bottom();
  if (inAxis || event->modifiers().testFlag(Qt::ShiftModifier)) {
    drag_ = Drag::Range;
    anchor_ = frame;
  } else {
    drag_ = Drag::Frame;
    requestFrame(frame);
  }
}

void Timeline::setHoveredFrame(qint64 frame) {
  if (frame != hovered_) {
    hovered_ = frame;
    update();
  }
}

void Timeline::hover(const QPointF& place) {
  const bool inside = model_.history.lastFrame >= 0 && place.x() >= gutter_;
  const qint64 frame = inside ? scale_.frameAt(place.x()) : -1;
  if (frame != hovered_) {
    setHoveredFrame(frame);
    Q_EMIT frameHovered(frame);
  }
}

void Timeline::leaveEvent(QEvent* event) {
  QWidget::leaveEvent(event);
  hover({-1.0, 0.0});
}

void Timeline::mouseMoveEvent(QMouseEvent* event) {
  const qint64 frame = scale_.frameAt(event->position().x());
  hover(event->position());
  if (drag_ == Drag::Frame) {
    requestFrame(frame);
  } else if (drag_ == Drag::Range) {
    selectTo(frame);
  }
}

void Timeline::mouseReleaseEvent(QMouseEvent* event) {
  const qint64 frame = scale_.frameAt(event->position().x());
  if (drag_ == Drag::Range && frame == anchor_) { // a click, no drag
    selection_.selectRange(std::nullopt);
    requestFrame(frame);
  }
  drag_ = Drag::None;
}

void Timeline::mouseDoubleClickEvent(QMouseEvent* event) {
  if (const auto marker = markerAt(event->position())) {
    editName(model_.markers[*marker]);
  } else if (event->position().y() < rows().axisArea.bottom()) {
    selection_.selectedRange() ? zoomToRange() : zoomOut();
  }
}

void Timeline::wheelEvent(QWheelEvent* event) {
  const double notches = event->angleDelta().y() / 120.0;
  const double sideways = event->angleDelta().x() / 120.0;
  if (sideways != 0.0 || event->modifiers().testFlag(Qt::ShiftModifier)) {
    const double by = sideways != 0.0 ? sideways : notches;
    scale_.scroll(-0.1 * by * (scale_.shownEnd() - scale_.shownBegin()));
  } else {
    scale_.zoom(std::pow(kZoomStep, notches), event->position().x());
  }
  event->accept();
  update();
}

void Timeline::keyPressEvent(QKeyEvent* event) {
  const bool extend = event->modifiers().testFlag(Qt::ShiftModifier);
  const qint64 now = latestFrame();
  const auto second = std::max<qint64>(1, std::llround(model_.framesPerSecond));
  const double middle = scale_.xOf(static_cast<double>(now) + 0.5);
  switch (event->key()) {
  case Qt::Key_Left:
    return requestFrame(now - 1, extend);
  case Qt::Key_Right:
    return requestFrame(now + 1, extend);
  case Qt::Key_PageUp:
    return requestFrame(now - second, extend);
  case Qt::Key_PageDown:
    return requestFrame(now + second, extend);
  case Qt::Key_Home:
    return requestFrame(scale_.firstFrame(), extend);
  case Qt::Key_End:
    return extend ? requestFrame(std::max<qint64>(0, model_.history.newestTrackedFrame), true)
                  : selection_.requestLiveFrame();
  case Qt::Key_Plus:
  case Qt::Key_Equal:
    scale_.zoom(kZoomStep, middle);
    return update();
  case Qt::Key_Minus:
    scale_.zoom(1.0 / kZoomStep, middle);
    return update();
  case Qt::Key_0:
    return zoomOut();
  case Qt::Key_Escape:
    return selection_.selectRange(std::nullopt);
  default:
    QWidget::keyPressEvent(event);
  }
}

void Timeline::contextMenuEvent(QContextMenuEvent* event) {
  if (event->reason() == QContextMenuEvent::Mouse && event->pos().x() >= gutter_) {
    requestFrame(scale_.frameAt(event->pos().x()));
  }
  Q_EMIT menuRequested(event->reason() == QContextMenuEvent::Mouse
                           ? event->globalPos()
                           : mapToGlobal(positionOf(selection_.currentFrame())));
}

void Timeline::announceFrame() {
  if (QAccessible::isActive()) { // nobody else hears it
    const qint64 currentFrame = selection_.currentFrame();
    setAccessibleDescription(currentFrame < 0 ? QString() : model_.descriptionOf(currentFrame));
  }
}

void Timeline::updateMarkers() {
  model_.markers = document_.project().markers;
  model_.corrections = document_.project().corrections;
  update();
}

std::optional<std::size_t> Timeline::markerAt(const QPointF& point) const {
  const QFontMetricsF metrics(font());
  for (std::size_t k = model_.markers.size(); k-- > 0;) {
    if (markerFlagArea(model_.markers[k], scale_, rows(), metrics).contains(point)) {
      return k;
    }
  }
  return std::nullopt;
}

void Timeline::stepToMarker(int direction) {
  if (const auto marker = model_.nextMarkerFrame(latestFrame(), direction)) {
    requestFrame(*marker);
  }
}

bool Timeline::stepToProblem(int direction) {
  const int target = selection_.target();
  const auto frame =
      nextTrouble(model_.records, latestFrame(), direction,
                  target >= 0 ? std::optional(static_cast<std::size_t>(target)) : std::nullopt);
  const bool reachable = frame && *frame >= reachableFrames().first;
  if (reachable) {
    requestFrame(*frame);
  }
  return reachable;
}

void Timeline::addMarker() {
  const qint64 frame = selection_.currentFrame();
  if (frame < 0) {
    return;
  }
  markers_->add(frame);
  const auto added = std::ranges::find(model_.markers, frame, &ProjectMarker::frame);
  if (added != model_.markers.end()) {
    editName(*added);
  }
}

bool Timeline::removeMarker() {
  return markers_->remove(selection_.currentFrame());
}

void Timeline::editName(const ProjectMarker& marker) {
  markers_->editName(marker, markerFlagArea(marker, scale_, rows(), QFontMetricsF(font())));
}

} // namespace dewpoint::ui
