// SPDX-License-Identifier: GPL-3.0-or-later
// The frame around the views: images first, on a large screen and on a small one; views that fill
// the window or float; messages that cover nothing and take no keys; the status line.
#include "core/session/snapshot/snapshot.h"
#include "tests/ui/window_fixture.h"
#include "tests/ui/window_test.h"
#include "ui/cameraview/camera_view.h"
#include "ui/document/document.h"
#include "ui/widgets/message_bar.h"
#include "ui/workbench/dock_manager.h"
#include "ui/workbench/workbench.h"

#include <QComboBox>
#include <QLabel>
#include <QMouseEvent>
#include <QPushButton>
#include <QStatusBar>
#include <QToolBar>
#include <QToolButton>

#include <map>
#include <utility>

namespace dewpoint::tests {

namespace {

constexpr int kShared = 12; ///< pixels that Qt gives docks below of what comes or goes above

} // namespace

class WindowFrameTest : public QObject, private test::WindowFixture {
  Q_OBJECT

private Q_SLOTS:
  void init() { makeWindow({.play = false}); }
  void cleanup() { window_.reset(); }
  void imagesHaveNearlyHalfOfTheWidth_data();
  void imagesHaveNearlyHalfOfTheWidth();
  void aLargerWindowShowsLargerImages();
  void whoDragsASeparatorKeepsTheSizes();
  void itFitsASmallScreen_data();
  void itFitsASmallScreen();
  void figuresOfTheStatusLineGoFromTheRight();
  void detailsAreOneClickAway();
  void escAndAButtonGiveAllViewsBack();
  void aFloatingViewIsAWindowLikeAnyOther();
  void aMessagePushesTheViewsAndCoversNothing();
  void aMessageTakesNoKeys();
  void theSeverityOfAMessageIsSeen();

private:
  void openScene(const char* scene, const QSize& size);
  ViewDock* dock(const char* name) { return window_->findChild<ViewDock*>(QLatin1String(name)); }
  bool settlesPlaces();
  /// Where the docks are, by name; those behind another tab and hidden ones are nowhere.
  std::map<QString, QRect> places() const;
  /// Share of the window that is covered by images of cameras.
  double shareOfImages() const;
  void expectNoOverlapInStatusLine();
};

std::map<QString, QRect> WindowFrameTest::places() const {
  std::map<QString, QRect> found;
  for (const ViewDock* one : window_->workbench().docks.docks()) {
    if (!one->isHidden() && !one->isBehindOtherDocks()) {
      found[one->objectName()] = one->geometry();
    }
  }
  return found;
}

bool WindowFrameTest::settlesPlaces() {
  constexpr int kRounds = 10; // of the event loop, with all views where they were
  int same = 0;
  return waitFor([&, last = places()]() mutable {
    same = last == std::exchange(last, places()) ? same + 1 : 0;
    return same > kRounds;
  });
}

void WindowFrameTest::openScene(const char* scene, const QSize& size) {
  window_->resize(size);
  open(std::filesystem::path(scene));
  QVERIFY(waitFor([this] { return shown().iterationCount > 0; }));
  QVERIFY(settlesPlaces());
  QVERIFY(draws(*window_));
}

double WindowFrameTest::shareOfImages() const {
  double covered = 0.0;
  for (const CameraView* view : window_->findChildren<CameraView*>()) {
    const QSizeF image = QSizeF(view->imageSize()) * view->placement().scale;
    covered += image.width() * image.height();
  }
  return covered / (window_->width() * window_->height());
}

void WindowFrameTest::imagesHaveNearlyHalfOfTheWidth_data() {
  QTest::addColumn<QSize>("size");
  QTest::addColumn<double>("share"); // of the window, that images cover at least
  QTest::newRow("small") << QSize(1024, 640) << 0.11;
  QTest::newRow("first") << QSize(1400, 900) << 0.18;
  QTest::newRow("large") << QSize(1600, 1000) << 0.20;
  QTest::newRow("full") << QSize(1920, 1080) << 0.22;
}

void WindowFrameTest::imagesHaveNearlyHalfOfTheWidth() {
  QFETCH(QSize, size);
  QFETCH(double, share);
  openScene("demo", size);
  QCOMPARE(window_->size(), size);
  const QRect cameras = dock("cameraDock0")->geometry().united(dock("cameraDock1")->geometry());
  QVERIFY2(cameras.width() >= 0.45 * size.width(), qPrintable(QString::number(cameras.width())));
  qInfo("images cover %.1f %% of %d x %d", 100.0 * shareOfImages(), size.width(), size.height());
  QVERIFY2(shareOfImages() >= share, qPrintable(QString::number(shareOfImages())));
}

void WindowFrameTest::aLargerWindowShowsLargerImages() {
  openScene("demo", {1400, 900});
  const double before = shareOfImages() * 1400 * 900;
  window_->resize(1920, 1080);
  QVERIFY(waitFor([&] { return shareOfImages() * 1920 * 1080 > 1.3 * before; }));
  // And back, as it was.
  window_->resize(1400, 900);
  QVERIFY(waitFor([&] { return qAbs(shareOfImages() * 1400 * 900 - before) < 0.02 * before; }));
}

void WindowFrameTest::whoDragsASeparatorKeepsTheSizes() {
  openScene("demo", {1400, 900});
  ViewDock* scene = dock("birdsEyeDock");
  const int before = scene->width();
  const QPoint edge(scene->geometry().left() - 2, scene->geometry().center().y());
  const auto send = [this](QEvent::Type type, const QPoint& at) { // with the button held down
    QMouseEvent event(type, at, window_->mapToGlobal(at),
                      type == QEvent::MouseMove ? Qt::NoButton : Qt::LeftButton, Qt::LeftButton,
                      Qt::NoModifier);
    QApplication::sendEvent(window_.get(), &event);
  };
  send(QEvent::MouseButtonPress, edge);
  send(QEvent::MouseMove, edge - QPoint(60, 0));
  send(QEvent::MouseMove, edge - QPoint(120, 0));
  QVERIFY(waitFor([&] { return scene->width() > before + 80; })); // it follows a little later
  send(QEvent::MouseButtonRelease, edge - QPoint(120, 0));
  QVERIFY(settlesPlaces());
  const int wanted = scene->width();
  window_->resize(1410, 910);
  QVERIFY(settlesPlaces());
  QVERIFY2(qAbs(scene->width() - wanted) < 40, qPrintable(QString::number(scene->width())));
  action("actionResetLayout")->trigger();
  QVERIFY(waitFor([&] { return qAbs(scene->width() - before) < 20; }));
}

void WindowFrameTest::itFitsASmallScreen_data() {
  QTest::addColumn<QString>("scene");
  QTest::newRow("two cameras") << QStringLiteral("demo");
  QTest::newRow("people, four cameras") << QStringLiteral("office");
}

void WindowFrameTest::itFitsASmallScreen() {
  QFETCH(QString, scene);
  openScene(qPrintable(scene), {1024, 640});
  QCOMPARE(window_->size(), QSize(1024, 640));
  const QSize least = window_->minimumSizeHint();
  QVERIFY2(least.width() <= 1000 && least.height() <= 600,
           qPrintable(QStringLiteral("%1 x %2").arg(least.width()).arg(least.height())));
  for (const char* name : {"targetDock", "colorDock", "cameraListDock", "trajectoryDock"}) {
    dock(name)->bringToFront();
    QVERIFY(settlesPlaces());
    QCOMPARE(window_->size(), QSize(1024, 640));
    QVERIFY2(window_->minimumSizeHint().height() <= 600, name);
  }
  QVERIFY(window_->rect().contains(window_->statusBar()->geometry()));
  expectNoOverlapInStatusLine();
}

void WindowFrameTest::expectNoOverlapInStatusLine() {
  auto* line = find<QWidget>("statusFigures");
  QVERIFY(settles(*line));
  QVERIFY(window_->statusBar()->rect().contains(line->geometry()));
  const QList<QWidget*> parts = line->findChildren<QWidget*>(Qt::FindDirectChildrenOnly);
  for (const QWidget* one : parts) {
    if (!one->isVisible() || one->isWindow()) {
      continue;
    }
    QVERIFY2(line->rect().contains(one->geometry()), qPrintable(one->objectName()));
    if (one->objectName() != QStringLiteral("statusReason")) { // which is cut, with an ellipsis
      QVERIFY2(one->width() >= one->sizeHint().width(), qPrintable(one->objectName()));
    }
    for (const QWidget* other : parts) {
      QVERIFY2(other == one || !other->isVisible() || other->isWindow() ||
                   !other->geometry().intersects(one->geometry()),
               qPrintable(one->objectName() + QStringLiteral(", ") + other->objectName()));
    }
  }
}

void WindowFrameTest::figuresOfTheStatusLineGoFromTheRight() {
  openScene("demo", {1400, 900});
  action("actionNextFrame")->trigger();
  QVERIFY(waitFor([this] { return find<QLabel>("statusPosition")->text().contains("z"); }));
  for (const char* name : {"statusHeld", "statusPosition", "statusSpread", "statusSpeed",
                           "statusFrame", "statusRate", "statusMore"}) {
    QVERIFY2(find<QWidget>(name)->isVisible(), name);
  }
  expectNoOverlapInStatusLine();
  // Narrower than the window can be: the state stays.
  auto* line = find<QWidget>("statusFigures");
  for (const int width : {900, 700, 500, 300, 160}) {
    line->resize(width, line->height());
    QVERIFY(find<QWidget>("statusHeld")->isVisible());
    QCOMPARE(find<QWidget>("statusRate")->isVisible(), width >= 900);
    QVERIFY(find<QWidget>("statusPosition")->isVisible() || width < 500);
  }
}

void WindowFrameTest::detailsAreOneClickAway() {
  openScene("demo", {1400, 900});
  auto* details = find<QWidget>("statusDetails");
  QTest::mouseClick(find<QToolButton>("statusMore"), Qt::LeftButton);
  QVERIFY(details->isVisible());
  QVERIFY(find<QLabel>("statusHistory")->text().contains(QStringLiteral("MB")));
  QVERIFY(!find<QLabel>("statusHistory")->toolTip().isEmpty()); // what the memory is for
  QTest::keyClick(details, Qt::Key_Escape);
  QVERIFY(waitFor([&] { return !details->isVisible(); }));
}

void WindowFrameTest::escAndAButtonGiveAllViewsBack() {
  openScene("demo", {1400, 900});
  const auto before = places();
  auto* restore = find<QToolButton>("cameraDock1TitleRestore");
  const auto maximize = [&] {
    QTest::mouseDClick(dock("cameraDock1")->titleBarWidget(), Qt::LeftButton);
    return waitFor([&] { return places().size() == 1 && restore->isVisible(); });
  };
  QVERIFY(!restore->isVisible());
  // As often as wanted, whichever way back is taken.
  for (int round = 0; round < 2; ++round) {
    QVERIFY(maximize());
    QTest::keyClick(window_.get(), Qt::Key_Escape);
    QVERIFY(waitFor([&] { return places() == before; }));
    QVERIFY(maximize());
    QTest::mouseClick(restore, Qt::LeftButton);
    QVERIFY(waitFor([&] { return places() == before; }));
    QVERIFY(maximize());
    QTest::mouseDClick(dock("cameraDock1")->titleBarWidget(), Qt::LeftButton);
    QVERIFY(waitFor([&] { return places() == before; }));
    QVERIFY(!restore->isVisible());
  }
}

void WindowFrameTest::aFloatingViewIsAWindowLikeAnyOther() {
  openScene("demo", {1400, 900});
  ViewDock* view = dock("cameraDock1");
  const QPoint place = view->mapToGlobal(QPoint());
  QTest::mouseClick(find<QToolButton>("cameraDock1TitleFloat"), Qt::LeftButton);
  QVERIFY(waitFor([&] {
    return view->isFloating() && view->isVisible() &&
           !view->windowFlags().testFlag(Qt::FramelessWindowHint);
  }));
  QCOMPARE(view->windowType(), Qt::Window); // has a frame, and can be maximized
  QVERIFY(waitFor([&] { return (view->pos() - place).manhattanLength() >= 60; }));
  // The keys of the window work there, too.
  const auto frame = shown().frame;
  QTest::keyClick(view, Qt::Key_Period);
  QVERIFY(waitFor([&] { return shown().frame == frame + 1; }));
  QTest::mouseDClick(view->titleBarWidget(), Qt::LeftButton);
  QVERIFY(waitFor([&] { return !view->isFloating() && view->isVisible(); }));
  // Again, back by its button; at last closed by its frame: put away, as in the list of views.
  QTest::mouseClick(find<QToolButton>("cameraDock1TitleFloat"), Qt::LeftButton);
  QVERIFY(waitFor([&] { return view->isFloating(); }));
  QTest::mouseClick(find<QToolButton>("cameraDock1TitleFloat"), Qt::LeftButton);
  QVERIFY(waitFor([&] { return !view->isFloating(); }));
  QTest::mouseClick(find<QToolButton>("cameraDock1TitleFloat"), Qt::LeftButton);
  QVERIFY(waitFor([&] { return view->isFloating() && view->isVisible(); }));
  view->close();
  QVERIFY(!view->isVisible() && view->isHiddenByUser());
  action("actionResetLayout")->trigger();
  QVERIFY(waitFor([&] { return view->isVisible() && !view->isFloating(); }));
}

void WindowFrameTest::aMessagePushesTheViewsAndCoversNothing() {
  openScene("demo", {1400, 900});
  for (const bool arranged : {false, true}) {
    if (arranged) { // by hand
      window_->resizeDocks({dock("plotDock")}, {300}, Qt::Vertical);
      dock("birdsEyeDock")->setFloating(true);
      QVERIFY(settlesPlaces());
    }
    const auto before = places();
    window_->workbench().messages.showError(QStringLiteral("something went wrong"));
    QVERIFY(settlesPlaces());
    auto* bar = find<MessageBar>("messageBar");
    const QRect covered(bar->mapTo(window_.get(), QPoint()), bar->size());
    for (const auto& [name, place] : places()) {
      const bool isInside = !dock(qPrintable(name))->isFloating();
      QVERIFY2(!isInside || !covered.intersects(place), qPrintable(name));
    }
    QVERIFY(places().at("cameraDock0").top() > before.at("cameraDock0").top());
    const auto isBefore = [&](const char* name) {
      const QRect now = places().at(QLatin1String(name));
      const QRect then = before.at(QLatin1String(name));
      const int most = arranged ? kShared : 0;
      return qAbs(now.top() - then.top()) <= most && qAbs(now.bottom() - then.bottom()) <= most;
    };
    for (const char* name : {"timelineDock", "plotDock"}) { // what lies below stays
      QVERIFY2(isBefore(name), name);
    }
    for (int more = 0; more < 4; ++more) { // nothing creeps
      window_->workbench().messages.dismiss();
      QVERIFY(settlesPlaces());
      window_->workbench().messages.showNotice(QStringLiteral("again"));
      QVERIFY(settlesPlaces());
    }
    window_->workbench().messages.dismiss();
    QVERIFY(settlesPlaces());
    for (const char* name : {"timelineDock", "plotDock", "cameraDock0", "cameraDock1"}) {
      QVERIFY2(isBefore(name), name);
    }
  }
}

void WindowFrameTest::aMessageTakesNoKeys() {
  openScene("demo", {1400, 900});
  auto* method = find<QComboBox>("methodChoice");
  const std::string before = window_->document().project().method;
  MessageBar& messages = window_->workbench().messages;
  int answered = 0;
  const auto ask = [&] {
    messages.showQuestion(QStringLiteral("Really?"),
                          {{QStringLiteral("Yes"), [&] { ++answered; }}});
    QVERIFY(waitFor([this] { return window_->findChild<QPushButton*>("messageAnswer0"); }));
  };
  const auto gone = [this] {
    QCoreApplication::sendPostedEvents(nullptr, QEvent::DeferredDelete); // the answers
    return !find<MessageBar>("messageBar")->isVisible();
  };
  // With the mouse, while nothing has the keys; and closed.
  if (QWidget* now = window_->focusWidget()) {
    now->clearFocus();
  }
  ask();
  QTest::mouseClick(find<QPushButton>("messageAnswer0"), Qt::LeftButton);
  QVERIFY(gone());
  QCOMPARE(answered, 1);
  QVERIFY(!method->hasFocus());
  ask();
  QTest::mouseClick(find<QToolButton>("messageClose"), Qt::LeftButton);
  QVERIFY(gone());
  QVERIFY(!method->hasFocus());
  QTest::keyClick(window_.get(), Qt::Key_Down);
  QCOMPARE(window_->document().project().method, before);
  // With keys, they go back where they were.
  auto* pressed = find<QWidget>("statusMore");
  for (const Qt::Key key : {Qt::Key_Space, Qt::Key_Escape}) {
    pressed->setFocus(Qt::TabFocusReason);
    ask();
    find<QPushButton>("messageAnswer0")->setFocus(Qt::TabFocusReason);
    QTest::keyClick(find<QPushButton>("messageAnswer0"), key);
    QVERIFY(gone());
    QVERIFY(pressed->hasFocus());
  }
  QCOMPARE(answered, 2);
}

void WindowFrameTest::theSeverityOfAMessageIsSeen() {
  MessageBar& messages = window_->workbench().messages;
  auto* bar = find<MessageBar>("messageBar");
  const auto looks = [&] {
    return std::pair(bar->grab().toImage().pixelColor(bar->width() / 2, 2).rgb(),
                     find<QLabel>("messageMark")->text());
  };
  messages.showNotice(QStringLiteral("a"));
  QVERIFY(settles(*bar));
  const auto notice = looks();
  messages.showWarning(QStringLiteral("a"));
  const auto warning = looks();
  messages.showError(QStringLiteral("a"));
  const auto error = looks();
  QVERIFY(notice.first != warning.first && warning.first != error.first);
  QVERIFY(notice.second != warning.second && warning.second != error.second);
  QVERIFY(messages.recentMessages().last().endsWith(QStringLiteral("a")));
}

DEWPOINT_WINDOW_TEST(WindowFrameTest)

} // namespace dewpoint::tests

#include "window_frame_test.moc"
