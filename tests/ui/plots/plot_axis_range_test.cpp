// SPDX-License-Identifier: GPL-3.0-or-later
// Which part of a run plots show.
#include "tests/ui/window_test.h"
#include "ui/plots/plot_axis_range.h"

#include <QTest>

#include <array>

namespace dewpoint::tests {

class PlotAxisRangeTest : public QObject {
  Q_OBJECT

private Q_SLOTS:
  void init();
  void aShortRunGrowsIntoTheLeastRange();
  void aPartStaysWithinTheRun();
  void aPartAtTheEndGoesAlong();
  void aPartInThePastStays();
  void anotherAxisShowsAll();
  void aRunThatWentBackBeforeThePartIsSeenWhole();

private:
  using Range = PlotAxisRange::Range;
  /// Iterations up to this one, ten a second.
  void run(std::int64_t last) {
    for (auto k = static_cast<std::int64_t>(series_.size()); k <= last; ++k) {
      series_.append({k, k, 0.1 * static_cast<double>(k)}, std::array<float, 1>{0.0F});
    }
  }

  PlotSeries series_;
  PlotAxisRange range_;
};

void PlotAxisRangeTest::init() {
  series_.reset(1);
  range_ = PlotAxisRange();
}

void PlotAxisRangeTest::aShortRunGrowsIntoTheLeastRange() {
  QCOMPARE(range_.shownRange(nullptr), Range(0.0, 60.0));
  run(10);
  QCOMPARE(range_.shownRange(&series_), Range(0.0, 60.0));
  run(100);
  QCOMPARE(range_.shownRange(&series_), Range(0.0, 100.0));
  QVERIFY(range_.showsWholeRun());
}

void PlotAxisRangeTest::aPartStaysWithinTheRun() {
  run(100);
  range_.showRange(&series_, -20.0, 10.0); // 30 wide, moved to the beginning
  QCOMPARE(range_.shownRange(&series_), Range(0.0, 30.0));
  range_.showRange(&series_, 50.0, 50.5); // 4 iterations are the least that can be read
  QCOMPARE(range_.shownRange(&series_), Range(50.0, 54.0));
  range_.showRange(&series_, -50.0, 200.0); // more than there is
  QVERIFY(range_.showsWholeRun());
}

void PlotAxisRangeTest::aPartAtTheEndGoesAlong() {
  run(100);
  range_.showRange(&series_, 80.0, 100.0);
  run(130);
  QCOMPARE(range_.followNewestData(&series_), Range(110.0, 130.0));
  run(140);
  QCOMPARE(range_.followNewestData(&series_), Range(120.0, 140.0));
}

void PlotAxisRangeTest::aPartInThePastStays() {
  run(100);
  range_.showRange(&series_, 20.0, 40.0);
  run(200);
  QCOMPARE(range_.followNewestData(&series_), Range(20.0, 40.0));
}

void PlotAxisRangeTest::anotherAxisShowsAll() {
  run(100);
  range_.showRange(&series_, 20.0, 40.0);
  QVERIFY(!range_.setAxis(PlotAxis::Iterations));
  QVERIFY(!range_.showsWholeRun());
  QVERIFY(range_.setAxis(PlotAxis::Time));
  QCOMPARE(range_.shownRange(&series_), Range(0.0, 10.0)); // seconds
}

void PlotAxisRangeTest::aRunThatWentBackBeforeThePartIsSeenWhole() {
  run(10);
  range_.showRange(&series_, 20.0, 40.0); // where the run has not been yet
  QCOMPARE(range_.followNewestData(&series_), Range(20.0, 40.0));
  run(200);
  range_.showRange(&series_, 120.0, 160.0);
  series_.removeFrom(140); // the part still begins within the run
  QCOMPARE(range_.followNewestData(&series_), Range(120.0, 160.0));
  series_.removeFrom(100);
  QCOMPARE(range_.followNewestData(&series_), Range(0.0, 99.0));
  QVERIFY(range_.showsWholeRun());
  run(200); // and from then on it grows with the run
  QCOMPARE(range_.followNewestData(&series_), Range(0.0, 200.0));
}

DEWPOINT_CORE_TEST(PlotAxisRangeTest)

} // namespace dewpoint::tests

#include "plot_axis_range_test.moc"
