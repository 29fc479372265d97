// SPDX-License-Identifier: GPL-3.0-or-later
// How the window is put together: a view that is added with one line, views that fill the window
// and come back, and what another project finds.
#include "core/project/project_save.h"
#include "core/session/session.h"
#include "tests/added_view/frame_clock.h"
#include "tests/ui/window_fixture.h"
#include "tests/ui/window_test.h"
#include "ui/document/document.h"
#include "ui/document/project_saver.h"
#include "ui/plots/plot_stack.h"
#include "ui/selection/selection.h"
#include "ui/session/open_request.h"
#include "ui/session/project_loader.h"
#include "ui/session/session_controller.h"
#include "ui/view3d/birds_eye_view.h"
#include "ui/workbench/dock_manager.h"
#include "ui/workbench/workbench.h"

#include <QFile>
#include <QMenu>
#include <QSignalSpy>

#include <cmath>
#include <map>
#include <memory>
#include <utility>
#include <vector>

namespace dewpoint::tests {

class WindowAssemblyTest : public QObject, private test::WindowFixture {
  Q_OBJECT

private Q_SLOTS:
  void init() { makeWindow({.play = false}); }
  void cleanup() { window_.reset(); }
  void aViewIsAddedWithOneLine();
  void thatViewIsTheOneOfThePage();
  void aMaximizedViewGivesTheOthersTheirPlacesBack();
  void whatIsWantedWhileOneViewFillsTheWindowStays();
  void whatNobodyArrangedSuitsAnotherWindow();
  void anotherProjectIsSeenWhole();
  void theRequestComesBackWithWhatItOpened();
  void viewsAreToldInOrder();
  void closingBeforeTheRunBeginsKeepsItFromBeginning();

private:
  void openDemo();
  ViewDock* dock(const char* name) { return window_->findChild<ViewDock*>(QLatin1String(name)); }
  void doubleClickTitle(const char* name) {
    QTest::mouseDClick(dock(name)->titleBarWidget(), Qt::LeftButton);
  }
  /// Which docks are shown, by name, and where; those behind another tab are nowhere.
  std::map<QString, QRect> places() const;
};

void WindowAssemblyTest::openDemo() {
  constexpr int kRounds = 10; // of the event loop, with all views where they were
  open();
  QVERIFY(waitFor([this] { return shown().iterationCount > 0; }));
  int same = 0;
  QVERIFY(waitFor([&, last = places()]() mutable {
    same = last == std::exchange(last, places()) ? same + 1 : 0;
    return same > kRounds;
  }));
}

std::map<QString, QRect> WindowAssemblyTest::places() const {
  std::map<QString, QRect> found;
  for (const ViewDock* one : window_->workbench().docks.docks()) {
    if (!one->isHidden()) {
      found[one->objectName()] = one->isBehindOtherDocks() ? QRect() : one->geometry();
    }
  }
  return found;
}

void WindowAssemblyTest::aViewIsAddedWithOneLine() {
  installFrameClock(window_->workbench());
  const auto* view = window_->findChild<FrameClock*>();
  QVERIFY(view != nullptr);
  openDemo();
  QCOMPARE(view->text(), QString::number(window_->shown()->frame));
  // It is a tab of the inspector, and in the list of views.
  QVERIFY(!dock("frameClockDock")->isHidden());
  QVERIFY(window_->tabifiedDockWidgets(dock("parameterDock")).contains(dock("frameClockDock")));
  auto* views = window_->findChild<QMenu*>(QStringLiteral("menuViews"));
  QVERIFY(views != nullptr);
  Q_EMIT views->aboutToShow();
  QVERIFY(views->actions().contains(dock("frameClockDock")->toggleViewAction()));
  // Who puts it away does not find it again after the views were arranged anew.
  dock("frameClockDock")->toggleViewAction()->trigger();
  window_->findChild<QAction*>(QStringLiteral("actionResetLayout"))->trigger();
  QVERIFY(dock("frameClockDock")->isHidden());
  QVERIFY(!view->text().isEmpty());
  window_->findChild<QAction*>(QStringLiteral("actionCloseProject"))->trigger();
  QCOMPARE(view->text(), QString()); // it is told, hidden as it is
}

// Each fenced block of the page under the name of its file; the page has no license lines.
void WindowAssemblyTest::thatViewIsTheOneOfThePage() {
  const auto textOf = [](const QString& name) {
    QFile file(QStringLiteral(DEWPOINT_SOURCE_DIR "/") + name);
    return file.open(QIODevice::ReadOnly) ? QString::fromUtf8(file.readAll()) : QString();
  };
  const QString page = textOf(QStringLiteral("docs/architecture.md"));
  const QString fence = QStringLiteral("```");
  for (const QString& name : {QStringLiteral("frame_clock.h"), QStringLiteral("frame_clock.cpp")}) {
    const QString built = textOf(QStringLiteral("tests/added_view/") + name);
    const qsizetype named = page.indexOf(QLatin1Char('`') + name + QLatin1Char('`'));
    QVERIFY2(named >= 0 && !built.isEmpty(), qPrintable(name));
    const qsizetype begin = page.indexOf(QLatin1Char('\n'), page.indexOf(fence, named)) + 1;
    const QString shown = page.mid(begin, page.indexOf(fence, begin) - begin);
    QCOMPARE(shown, built.mid(built.indexOf(QLatin1Char('\n')) + 1));
  }
}

void WindowAssemblyTest::aMaximizedViewGivesTheOthersTheirPlacesBack() {
  openDemo();
  const auto before = places();
  for (int round = 0; round < 2; ++round) {
    doubleClickTitle("cameraDock1");
    QTRY_COMPARE_WITH_TIMEOUT(places().size(), std::size_t{1}, kTimeoutMs);
    QVERIFY(!dock("cameraDock1")->isHidden());
    doubleClickTitle("cameraDock1");
    QTRY_COMPARE_WITH_TIMEOUT(places().size(), before.size(), kTimeoutMs);
    QTRY_VERIFY_WITH_TIMEOUT(places() == before, kTimeoutMs);
  }
}

void WindowAssemblyTest::whatIsWantedWhileOneViewFillsTheWindowStays() {
  openDemo();
  const auto before = places();
  doubleClickTitle("birdsEyeDock");
  QTRY_COMPARE_WITH_TIMEOUT(places().size(), std::size_t{1}, kTimeoutMs);
  dock("historyDock")->toggleViewAction()->trigger();
  doubleClickTitle("birdsEyeDock");
  QTRY_COMPARE_WITH_TIMEOUT(places().size(), before.size() + 1, kTimeoutMs);
  QVERIFY(!dock("historyDock")->isHidden());
  // The view that fills the window is put away: the others come back without it.
  doubleClickTitle("plotDock");
  QTRY_COMPARE_WITH_TIMEOUT(places().size(), std::size_t{1}, kTimeoutMs);
  dock("plotDock")->toggleViewAction()->trigger();
  QTRY_COMPARE_WITH_TIMEOUT(places().size(), before.size(), kTimeoutMs);
  QVERIFY(dock("plotDock")->isHidden());
}

void WindowAssemblyTest::whatNobodyArrangedSuitsAnotherWindow() {
  const auto project = path("kept.toml");
  QVERIFY(saveProject(*resolveProject("demo"), project));
  window_->resize(1100, 700);
  open(project);
  dock("trajectoryDock")->toggleViewAction()->trigger();
  action("actionSave")->trigger();
  QVERIFY(waitFor([this] { return !window_->saver().isSaving(); }));
  QVERIFY(!window_->document().project().windowLayout.empty());
  makeAnotherWindow({.size = {1700, 1000}, .play = false});
  open(project);
  const auto widthOfImages = [this] {
    return dock("cameraDock0")->geometry().united(dock("cameraDock1")->geometry()).width();
  };
  QTRY_VERIFY_WITH_TIMEOUT(widthOfImages() >= 0.45 * window_->width(), kTimeoutMs);
  QVERIFY(dock("trajectoryDock")->isHidden()); // that was arranged
}

void WindowAssemblyTest::anotherProjectIsSeenWhole() {
  openDemo();
  auto* room = window_->findChild<BirdsEyeView*>();
  QCOMPARE(room->currentView(), Scene3d::View::Free);
  for (int step = 0; step < 5; ++step) {
    QTest::keyClick(room, Qt::Key_Plus);
  }
  auto* plots = window_->findChild<PlotStack*>(QStringLiteral("plotStack"));
  // Long enough to be looked at in part.
  QTRY_VERIFY_WITH_TIMEOUT((plots->showRange(0.5, 1.0), !plots->showsWholeRun()), kTimeoutMs);
  dock("trajectoryDock")->raise(); // the panel follows the run while it is seen
  auto* motion = window_->findChild<PlotStack*>(QStringLiteral("motionPlots"));
  QTRY_VERIFY_WITH_TIMEOUT((motion->showRange(0.5, 1.0), !motion->showsWholeRun()), kTimeoutMs);
  openDemo();
  QCOMPARE(room->currentView(), Scene3d::View::Free);
  if (room->hasImage()) {
    room->currentImage();
    const double shown = room->scene().metersPerPixel();
    action("actionFitScene")->trigger();
    room->currentImage();
    // Twice as near before; what is tracked meanwhile changes little.
    QVERIFY(std::abs(shown / room->scene().metersPerPixel() - 1.0) < 0.1);
  }
  QVERIFY(plots->showsWholeRun());
  QVERIFY(motion->showsWholeRun());
}

void WindowAssemblyTest::theRequestComesBackWithWhatItOpened() {
  ProjectLoader loader(&openProject);
  std::vector<QString> notes;
  connect(&loader, &ProjectLoader::opened, this,
          [&](const OpenRequest& request, const std::shared_ptr<SessionInputs>& inputs) {
            notes.push_back(request.message + QString::fromStdString(inputs->project.scene));
          });
  loader.open(
      {.sessionRequest = std::filesystem::path("still"), .message = QStringLiteral("first ")});
  loader.open(
      {.sessionRequest = std::filesystem::path("fast"), .message = QStringLiteral("second ")});
  loader.open({.sessionRequest = std::filesystem::path("jump"), .keepsHistory = true});
  QVERIFY(loader.isReopening());
  loader.open(
      {.sessionRequest = std::filesystem::path("smooth"), .message = QStringLiteral("last ")});
  QVERIFY(!loader.isReopening());
  QTRY_VERIFY_WITH_TIMEOUT(!loader.isOpening(), kTimeoutMs);
  // Of those asked for meanwhile, the last: with its own meaning.
  QCOMPARE(notes, std::vector<QString>{QStringLiteral("last smooth")});
}

void WindowAssemblyTest::viewsAreToldInOrder() {
  QObject window;
  Document document;
  Selection selection;
  SessionController session(&openProject, document, selection, &window);
  session.setPlayOnOpen(false);
  QStringList told;
  const auto tell = [&](const char* what) {
    return [&told, what] { told << QLatin1String(what); };
  };
  connect(&session, &SessionController::documentAboutToBeReplaced, this, tell("replacing"));
  connect(&session, &SessionController::documentReplaced, this, tell("replaced"));
  connect(&session, &SessionController::runStarted, this, tell("started"));
  connect(&session, &SessionController::framesLogged, this, tell("frames"));
  connect(&session, &SessionController::snapshotChanged, this,
          [&](const TrackSnapshotPtr& snapshot) { told << (snapshot ? "snapshot" : "nothing"); });
  connect(&session, &SessionController::iterationsLogged, this, tell("iterations"));
  connect(&session, &SessionController::opened, this, tell("opened"));
  connect(&session, &SessionController::runEnded, this, tell("ended"));
  connect(&session, &SessionController::closed, this, tell("closed"));
  session.open({.sessionRequest = std::filesystem::path("still")});
  QTRY_VERIFY_WITH_TIMEOUT(told.contains(QStringLiteral("opened")), kTimeoutMs);
  QCOMPARE(told.mid(0, 9), QStringList({"ended", "nothing", "replacing", "replaced", "started",
                                        "frames", "snapshot", "iterations", "opened"}));
  QCOMPARE(document.project().scene, std::string("still"));
  told.clear();
  session.close();
  QCOMPARE(told, QStringList({"ended", "nothing", "closed"}));
  QVERIFY(!session.isRunning() && session.shownSnapshot() == nullptr);
  QVERIFY(document.project().cameras.empty());
}

void WindowAssemblyTest::closingBeforeTheRunBeginsKeepsItFromBeginning() {
  QObject window;
  Document document;
  Selection selection;
  SessionController session(&openProject, document, selection, &window);
  QSignalSpy started(&session, &SessionController::runStarted);
  QSignalSpy closed(&session, &SessionController::closed);
  // Between the document's change and the run's beginning lies a turn of the event loop.
  connect(&session, &SessionController::documentReplaced, &session, [&session] {
    QMetaObject::invokeMethod(&session, &SessionController::close, Qt::QueuedConnection);
  });
  session.open({.sessionRequest = std::filesystem::path("still")});
  QVERIFY(closed.wait(kTimeoutMs));
  QVERIFY(!QTest::qWaitFor([&] { return started.count() > 0; }, 100));
  QVERIFY(!session.isRunning());
}

DEWPOINT_WINDOW_TEST(WindowAssemblyTest)

} // namespace dewpoint::tests

#include "window_assembly_test.moc"
