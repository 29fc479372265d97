// SPDX-License-Identifier: GPL-3.0-or-later
// What plots show of a run that has just begun, in a window of the usual size: what matters is in
// sight, one iteration is a dot, and a restart shows the whole run again.
#include "core/session/snapshot/snapshot.h"
#include "tests/ui/window_fixture.h"
#include "tests/ui/window_test.h"
#include "ui/plots/frame_convergence.h"
#include "ui/plots/plot_axis_strip.h"
#include "ui/plots/plot_panel.h"
#include "ui/plots/plot_stack.h"
#include "ui/trajectory/trajectory_panel.h"

#include <QDockWidget>
#include <QLabel>
#include <QScrollArea>
#include <QScrollBar>

namespace dewpoint::tests {

class PlotsOfABeginningTest : public QObject, private test::WindowFixture {
  Q_OBJECT

private Q_SLOTS:
  void init();
  void cleanup() { window_.reset(); }
  void whatMattersIsInSight();
  void noPlotIsCut();
  void axisIsInSecondsUntilTheUserChooses();
  void axisStaysWhileThePlotsScroll();
  void oneIterationIsADot();
  void iterationsOfAFrameConverge();
  void restartShowsTheWholeRun();
  void withoutDataThereIsASentence();

private:
  PlotPanel& panel() { return *window_->findChild<PlotPanel*>(); }
  PlotStack& plots() { return panel().stack(); }
  PlotAxisStrip& strip() {
    return *static_cast<PlotAxisStrip*>(plots().findChild<QWidget*>(QStringLiteral("plotAxis")));
  }
  /// Tracks frames until there are so many iterations.
  bool runsTo(std::int64_t iterations) {
    while (shown().iterationCount < iterations) {
      const std::int64_t before = shown().iterationCount;
      action("actionNextFrame")->trigger();
      if (!waitFor([&] { return shown().iterationCount > before; })) {
        return false;
      }
    }
    return waitFor([this] { return panel().shownIterationCount() == shown().iterationCount; });
  }
};

void PlotsOfABeginningTest::init() {
  makeWindow({.size = {1400, 900}, .theme = Theme::Light, .play = false});
  open(); // and the first frame is tracked
  QVERIFY(waitFor(
      [this] { return shown().iterationCount == 1 && panel().shownIterationCount() == 1; }));
  QVERIFY(draws(*window_));
}

void PlotsOfABeginningTest::whatMattersIsInSight() {
  QVERIFY(waitFor([this] { return plots().fullyVisiblePlots().size() >= 3; }));
  QCOMPARE(plots().fullyVisiblePlots().first(3), (QStringList{"position", "spread", "sampleSize"}));
  QCOMPARE(find<QLabel>("plotTarget")->text(), QStringLiteral("pink ball"));
}

void PlotsOfABeginningTest::noPlotIsCut() {
  QVERIFY(runsTo(5));
  auto* bar = plots().findChild<QScrollArea*>(QStringLiteral("plotScroll"))->verticalScrollBar();
  for (const int height : {900, 780, 860, 1000, 1200}) {
    window_->resize(1400, height);
    QVERIFY(draws(*window_));
    for (const bool atEnd : {false, true}) {
      QVERIFY(waitFor([&] {
        bar->setValue(atEnd ? bar->maximum() : 0);
        return plots().isDrawn() && plots().partlyVisiblePlots().isEmpty() &&
               !plots().fullyVisiblePlots().isEmpty();
      }));
    }
    QCOMPARE(plots().fullyVisiblePlots().last(), plots().visiblePlots().last());
  }
}

void PlotsOfABeginningTest::axisIsInSecondsUntilTheUserChooses() {
  QVERIFY(action("actionPlotOverTime")->isChecked());
  QCOMPARE(plots().axis(), PlotAxis::Time);
  action("actionPlotOverTime")->trigger();
  QCOMPARE(plots().axis(), PlotAxis::Iterations);
  window_.reset();
  makeAnotherWindow({.size = {1400, 900}, .theme = Theme::Light, .play = false});
  QCOMPARE(plots().axis(), PlotAxis::Iterations); // as chosen before
  QVERIFY(!action("actionPlotOverTime")->isChecked());
}

void PlotsOfABeginningTest::axisStaysWhileThePlotsScroll() {
  QVERIFY(runsTo(5));
  auto* bar = plots().findChild<QScrollArea*>(QStringLiteral("plotScroll"))->verticalScrollBar();
  QVERIFY(bar->maximum() > 0); // not all of them fit
  for (const int value : {0, bar->maximum()}) {
    bar->setValue(value);
    const QRect place(strip().mapTo(&plots(), QPoint()), strip().size());
    QVERIFY(strip().isVisible() && plots().rect().contains(place));
    QVERIFY2(strip().tickLabels().size() >= 2, qPrintable(strip().tickLabels().join(u' ')));
  }
}

void PlotsOfABeginningTest::oneIterationIsADot() {
  QCOMPARE(panel().shownIterationCount(), 1);
  QVERIFY(waitFor([this] { return plots().drawnPointCount() > 0; }));
  QVERIFY(plots().hasDots());
  QVERIFY(runsTo(40));
  QVERIFY(waitFor([this] { return !plots().hasDots(); })); // a line says it
}

void PlotsOfABeginningTest::iterationsOfAFrameConverge() {
  QVERIFY(runsTo(3));
  QVERIFY(panel().convergence().isHidden()); // one iteration per frame
  for (int k = 0; k < 4; ++k) {
    const std::int64_t before = shown().iterationCount;
    action("actionNextIteration")->trigger();
    QVERIFY(waitFor([&] { return shown().iterationCount > before; }));
  }
  QVERIFY(waitFor([this] { return panel().convergence().isVisible(); }));
  QCOMPARE(panel().convergence().iterationCount(), std::size_t{5});
  QCOMPARE(panel().convergence().stack().visiblePlots(), QStringList{"convergence"});
  // One more frame: it is its own; long after, there is nothing to be shown.
  QVERIFY(runsTo(shown().iterationCount + 1));
  QCOMPARE(panel().convergence().iterationCount(), std::size_t{1});
  QVERIFY(runsTo(shown().iterationCount + 14));
  QVERIFY(waitFor([this] { return panel().convergence().isHidden(); }));
}

void PlotsOfABeginningTest::restartShowsTheWholeRun() {
  QVERIFY(runsTo(70));
  window_->findChild<QDockWidget*>(QStringLiteral("trajectoryDock"))->raise();
  auto& motion = window_->findChild<TrajectoryPanel*>()->plots();
  QVERIFY(waitFor([&] { return (motion.showRange(0.5, 1.0), !motion.showsWholeRun()); }));
  window_->findChild<QDockWidget*>(QStringLiteral("plotDock"))->raise();
  QVERIFY(waitFor([this] { return plots().isVisible(); }));
  plots().showRange(0.5, 1.5); // seconds
  QVERIFY(!plots().showsWholeRun());
  action("actionRestart")->trigger();
  QVERIFY(waitFor([this] { return shown().iterationCount == 0; }));
  QVERIFY(plots().showsWholeRun());
  QVERIFY(motion.showsWholeRun());
  QVERIFY(runsTo(66)); // at 30 per second; and the plots go along with the new run
  QVERIFY(waitFor([this] { return plots().shownRange().second >= 2.1; }));
}

void PlotsOfABeginningTest::withoutDataThereIsASentence() {
  auto* sentence = plots().findChild<QLabel*>(QStringLiteral("plotsEmpty"));
  QVERIFY(waitFor([&] { return sentence->isHidden(); }));
  action("actionRestart")->trigger();
  QVERIFY(waitFor([&] { return shown().iterationCount == 0 && sentence->isVisible(); }));
  QCOMPARE(sentence->text(), QStringLiteral("Plots appear during tracking."));
  QVERIFY(runsTo(1));
  QVERIFY(waitFor([&] { return sentence->isHidden(); }));
}

DEWPOINT_WINDOW_TEST(PlotsOfABeginningTest)

} // namespace dewpoint::tests

#include "plots_of_a_beginning_test.moc"
