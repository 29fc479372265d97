// SPDX-License-Identifier: GPL-3.0-or-later
// Camera views are zoomed and moved by wheel, mouse and keys, whatever tool is in use, and a click
// is meant where it looks to be; a menu offers what can be done at a pixel.
#include "core/project/project.h"
#include "core/session/session.h"
#include "tests/ui/window_fixture.h"
#include "tests/ui/window_test.h"
#include "ui/cameraview/camera_view.h"
#include "ui/cameraview/image_pick_overlay.h"
#include "ui/document/document.h"
#include "ui/selection/selection.h"

#include <QContextMenuEvent>
#include <QCursor>
#include <QMenu>
#include <QMouseEvent>
#include <QWheelEvent>

#include <cmath>

namespace dewpoint::tests {

class CameraZoomTest : public QObject, private test::WindowFixture {
  Q_OBJECT

private Q_SLOTS:
  void init();
  void cleanup() { window_.reset(); }
  void theWheelKeepsThePixelUnderThePointer();
  void dragsMoveAZoomedImage();
  void aDoubleClickFits();
  void actionsZoomTheSelectedCamera();
  void framesGoOnAnotherProjectIsFitted();
  void aZoomedClickLearnsWhereItLooksToBe();
  void aBoxStaysWhereItBeganWhileTheImageIsZoomed();
  void aMenuOffersWhatCanBeDone();
  void theMenuSaysWhereTheTargetIs();
  void withoutATargetOnlyItsColorCanBeLearned();

private:
  CameraView* view(int k = 0) const {
    return find<CameraView>(QStringLiteral("cameraView%1").arg(k));
  }
  ImagePickOverlay* layer() const { return find<ImagePickOverlay>("cameraView0Pick"); }
  void wheel(QWidget* widget, const QPointF& at, int notches) {
    QWheelEvent event(at, widget->mapToGlobal(at), {}, {0, 120 * notches}, Qt::NoButton,
                      Qt::NoModifier, Qt::NoScrollPhase, false);
    QApplication::sendEvent(widget, &event);
  }
  void mouse(QEvent::Type type, const QPointF& at, Qt::MouseButton button,
             Qt::KeyboardModifiers modifiers = Qt::NoModifier) {
    const bool moves = type == QEvent::MouseMove;
    const bool down = type != QEvent::MouseButtonRelease;
    QMouseEvent event(type, at, layer()->mapToGlobal(at), moves ? Qt::NoButton : button,
                      down ? button : Qt::NoButton, modifiers);
    QApplication::sendEvent(layer(), &event);
  }
  void drag(const QPointF& from, const QPointF& way, Qt::MouseButton button,
            Qt::KeyboardModifiers modifiers = Qt::NoModifier) {
    mouse(QEvent::MouseButtonPress, from, button, modifiers);
    mouse(QEvent::MouseMove, from + way, button, modifiers);
    mouse(QEvent::MouseButtonRelease, from + way, button, modifiers);
  }
  /// The ball of the frame shown in the first camera's image, pixels.
  QPointF ball() const {
    const auto pixel = Projector(shown().rig->at(0)).project(*shown().targets.at(0).truth);
    return {pixel->x(), pixel->y()};
  }
  /// Opens the menu of the first image at a pixel.
  QMenu* menuAt(const QPointF& pixel) {
    const QPoint at = view()->placement().positionOf(pixel).toPoint();
    QContextMenuEvent event(QContextMenuEvent::Mouse, at, layer()->mapToGlobal(at));
    QApplication::sendEvent(layer(), &event);
    return find<QMenu>("menuImage");
  }
  static QAction* entry(QMenu* menu, const char* name) {
    return menu->findChild<QAction*>(QLatin1String(name));
  }
};

void CameraZoomTest::init() {
  makeWindow({.size = {1500, 950}, .theme = Theme::Light, .play = false});
  open();
  QVERIFY(waitFor([this] { return shown().history.newestTrackedFrame == 0; }));
  QVERIFY(waitFor([this] { return !view()->imageSize().isEmpty(); }));
  QVERIFY(keepsItsSize(view()));
  QVERIFY(draws(*view()));
  QCursor::setPos(window_->mapToGlobal(QPoint(3, 3))); // over no image
}

void CameraZoomTest::theWheelKeepsThePixelUnderThePointer() {
  const QPointF at(view()->width() * 0.45, view()->height() * 0.55);
  const QPointF pixel = view()->placement().pixelAt(at);
  const double before = view()->placement().scale;
  for (int k = 0; k < 6; ++k) {
    wheel(layer(), at, 1);
    const QPointF off = view()->placement().positionOf(pixel) - at;
    QVERIFY(std::hypot(off.x(), off.y()) < 1.0);
  }
  QVERIFY(std::abs(view()->placement().scale / before - 8.0) < 1e-6);
  QVERIFY(draws(*view()));
  QVERIFY(!view(1)->isZoomed()); // each has its own
  wheel(layer(), at, 100);
  QCOMPARE(view()->placement().scale, 32.0);
  wheel(layer(), at, -100);
  QVERIFY(!view()->isZoomed());
  QCOMPARE(view()->placement().scale, before);
}

void CameraZoomTest::dragsMoveAZoomedImage() {
  const QPointF at(view()->width() * 0.5, view()->height() * 0.5);
  drag(at, {30.0, 20.0}, Qt::MiddleButton);
  QVERIFY(!view()->isZoomed());
  wheel(layer(), at, 6);
  const auto moves = [&](Qt::MouseButton button, Qt::KeyboardModifiers modifiers) {
    const QPointF before = view()->placement().topLeft;
    drag(at, {-30.0, 20.0}, button, modifiers);
    const QPointF off = view()->placement().topLeft - before - QPointF(-30.0, 20.0);
    return std::hypot(off.x(), off.y()) < 1.5;
  };
  QVERIFY(moves(Qt::MiddleButton, Qt::NoModifier));
  QVERIFY(moves(Qt::LeftButton, Qt::NoModifier)); // no tool is meant by it
  action("actionLearnColor")->setChecked(true);
  QVERIFY(moves(Qt::MiddleButton, Qt::NoModifier));
  QVERIFY(moves(Qt::LeftButton, Qt::ControlModifier));
  QVERIFY(action("actionLearnColor")->isChecked()); // and nothing was learned
}

void CameraZoomTest::aDoubleClickFits() {
  const QPointF at(view()->width() * 0.5, view()->height() * 0.5);
  wheel(layer(), at, 3);
  QVERIFY(view()->isZoomed());
  QTest::mouseDClick(layer(), Qt::LeftButton, {}, at.toPoint());
  QVERIFY(!view()->isZoomed());
}

void CameraZoomTest::actionsZoomTheSelectedCamera() {
  window_->selection().selectCamera(1);
  action("actionZoomIn")->trigger();
  action("actionZoomIn")->trigger();
  QVERIFY(view(1)->isZoomed());
  QVERIFY(!view(0)->isZoomed());
  action("actionZoomOut")->trigger();
  QVERIFY(view(1)->isZoomed());
  action("actionFitImage")->trigger();
  QVERIFY(!view(1)->isZoomed());
}

void CameraZoomTest::framesGoOnAnotherProjectIsFitted() {
  wheel(layer(), view()->rect().center(), 4);
  const double scale = view()->placement().scale;
  action("actionNextFrame")->trigger();
  QVERIFY(waitFor([this] { return shown().frame == 1; }));
  QVERIFY(draws(*view()));
  QCOMPARE(view()->placement().scale, scale);
  open();
  QVERIFY(waitFor([this] { return shown().history.newestTrackedFrame == 0; }));
  QVERIFY(draws(*view()));
  QVERIFY(!view()->isZoomed());
}

void CameraZoomTest::aZoomedClickLearnsWhereItLooksToBe() {
  const QPointF pixel = ball();
  wheel(layer(), view()->placement().positionOf(pixel), 8);
  action("actionLearnColor")->setChecked(true);
  const QPoint at = view()->placement().positionOf(pixel + QPointF(1.0, -1.0)).toPoint();
  const QPointF meant = view()->placement().pixelAt(at);
  QTest::mouseClick(layer(), Qt::LeftButton, {}, at);
  const auto samples = [this] { return window_->document().project().targets.at(0).samples; };
  QVERIFY(waitFor([&] { return !samples().empty(); }));
  QCOMPARE(samples()[0].camera, 0);
  // Samples have whole pixels.
  QVERIFY(std::abs(samples()[0].x - meant.x()) <= 0.51);
  QVERIFY(std::abs(samples()[0].y - meant.y()) <= 0.51);
}

void CameraZoomTest::aBoxStaysWhereItBeganWhileTheImageIsZoomed() {
  QRectF box;
  connect(layer(), &ImagePickOverlay::picked, this, [&box](const QRectF& region) { box = region; });
  layer()->setPicking(true);
  const QPointF from(100.25, 80.5);
  const QPointF to(180.5, 130.25);
  mouse(QEvent::MouseButtonPress, view()->placement().positionOf(from), Qt::LeftButton);
  wheel(layer(), view()->placement().positionOf(to), 2);
  const QPointF end = view()->placement().positionOf(to);
  mouse(QEvent::MouseMove, end, Qt::LeftButton);
  mouse(QEvent::MouseButtonRelease, end, Qt::LeftButton);
  QVERIFY((box.topLeft() - from).manhattanLength() < 1e-6);
  QVERIFY((box.bottomRight() - to).manhattanLength() < 1e-6);
}

void CameraZoomTest::aMenuOffersWhatCanBeDone() {
  QMenu* menu = menuAt(ball());
  for (const char* name :
       {"imageLearnColor", "imageAddSample", "imageExclude", "imageCorrect", "imageZoomIn"}) {
    QVERIFY2(entry(menu, name) != nullptr && entry(menu, name)->isEnabled(), name);
  }
  QVERIFY(!entry(menu, "imageFit")->isEnabled());
  entry(menu, "imageZoomIn")->trigger();
  QVERIFY(view()->isZoomed());
  menu->close();
  QVERIFY(waitFor([this] { return window_->findChild<QMenu*>("menuImage") == nullptr; }));
  menu = menuAt(ball());
  const QPointF meant =
      view()->placement().pixelAt(view()->placement().positionOf(ball()).toPoint());
  entry(menu, "imageFit")->trigger();
  QVERIFY(!view()->isZoomed());
  entry(menu, "imageLearnColor")->trigger();
  const auto samples = [this] { return window_->document().project().targets.at(0).samples; };
  QVERIFY(waitFor([&] { return !samples().empty(); }));
  QVERIFY(std::abs(samples()[0].x - meant.x()) <= 0.51);
  QVERIFY(std::abs(samples()[0].y - meant.y()) <= 0.51);
  menu->close();
}

void CameraZoomTest::theMenuSaysWhereTheTargetIs() {
  const QPointF pixel = ball() + QPointF(20.0, 10.0);
  QMenu* menu = menuAt(pixel);
  entry(menu, "imageCorrect")->trigger();
  const auto& corrections = window_->document().project().corrections;
  QCOMPARE(corrections.size(), std::size_t{1});
  QCOMPARE(corrections[0].clicks.size(), std::size_t{1});
  const QPointF said(corrections[0].clicks[0].pixel.x(), corrections[0].clicks[0].pixel.y());
  const double reach = 1.0 / view()->placement().scale; // a whole widget pixel was clicked
  QVERIFY((said - pixel).manhattanLength() <= 2.0 * reach);
  menu->close();
}

void CameraZoomTest::withoutATargetOnlyItsColorCanBeLearned() {
  const QPointF pixel = ball();
  window_->selection().selectTarget(0);
  action("actionRemoveTarget")->trigger();
  QVERIFY(waitFor([this] { return shown().targets.empty(); }));
  QMenu* menu = menuAt(pixel);
  QVERIFY(entry(menu, "imageLearnColor")->isEnabled());
  QVERIFY(!entry(menu, "imageAddSample")->isEnabled());
  QVERIFY(!entry(menu, "imageExclude")->isEnabled());
  QVERIFY(!entry(menu, "imageCorrect")->isEnabled());
  menu->close();
}

DEWPOINT_WINDOW_TEST(CameraZoomTest)

} // namespace dewpoint::tests

#include "camera_zoom_test.moc"
