// SPDX-License-Identifier: GPL-3.0-or-later
// The trajectory panel and the plots' numbers on made-up runs, also long ones.
#include "core/session/snapshot/snapshot.h"
#include "tests/ui/wait.h"
#include "tests/ui/window_test.h"
#include "ui/actions/action_registry.h"
#include "ui/actions/window_actions.h"
#include "ui/plots/plot_stack.h"
#include "ui/plots/run_plots.h"
#include "ui/trajectory/frame_row_delegate.h"
#include "ui/trajectory/gap_list.h"
#include "ui/trajectory/trajectory_panel.h"

#include <QApplication>
#include <QScrollBar>
#include <QSignalSpy>
#include <QTableView>
#include <QTest>

#include <algorithm>
#include <cmath>
#include <memory>

namespace dewpoint::tests {

namespace {

/// A ball on a circle of 1 m about (0, 0, 1) at 2 rad/s, not held in frames 40 to 49.
std::vector<TrajectorySample> circle(std::int64_t frames) {
  std::vector<TrajectorySample> samples;
  for (std::int64_t frame = 0; frame < frames; ++frame) {
    TrajectorySample sample;
    sample.frame = frame;
    sample.time = static_cast<double>(frame) / 30.0;
    sample.target = "ball";
    sample.position = {std::cos(2.0 * sample.time), std::sin(2.0 * sample.time), 1.0};
    sample.isValid = frame < 40 || frame >= 50;
    samples.push_back(sample);
  }
  return samples;
}

} // namespace

class TrajectoryPanelTest : public QObject, private test::Waiting {
  Q_OBJECT

private Q_SLOTS:
  void init();
  void cleanup();
  void speedHeightAndGaps();
  void chosenGapIsTheRange();
  void tableFollowsAndGoesBack();
  void rowOfTheFrameShownIsMarkedAndInSight();
  void whoScrollsOrSelectsIsLeftAlone();
  void longRunsAreBounded();
  void drawingKeepsTheExtremes();
  void timeShowsTheLastIterationOfAFrame();
  void longRunsAreDrawnFromFewPoints();

private:
  void follow(const std::vector<TrajectorySample>& samples);
  bool isRowVisible(int row) {
    return table().viewport()->rect().contains(table().visualRect(table().model()->index(row, 0)));
  }
  std::pair<int, int> markedRows() {
    return static_cast<FrameRowDelegate*>(table().itemDelegate())->rows();
  }
  QTableView& table() { return *panel_->findChild<QTableView*>(QStringLiteral("trajectoryTable")); }

  std::unique_ptr<QWidget> window_;
  std::unique_ptr<ActionRegistry> actions_;
  Selection selection_;
  TrajectoryPanel* panel_ = nullptr;
  std::vector<TrajectorySample> samples_;
  bool restarted_ = false;
};

void TrajectoryPanelTest::init() {
  window_ = std::make_unique<QWidget>();
  actions_ = std::make_unique<ActionRegistry>(window_.get());
  declareWindowActions(*actions_);
  panel_ = new TrajectoryPanel(*actions_, selection_, window_.get());
  panel_->resize(1000, 300);
  window_->resize(1000, 300);
  window_->show();
  QVERIFY(QTest::qWaitForWindowExposed(window_.get()));
}

void TrajectoryPanelTest::cleanup() {
  selection_.clear();
  actions_.reset(); // the window would delete it, too
  window_.reset();
}

void TrajectoryPanelTest::follow(const std::vector<TrajectorySample>& samples) {
  samples_ = samples;
  panel_->setSource([this](auto&, auto& position) {
    LogUpdate<TrajectorySample> piece;
    piece.restarted = std::exchange(restarted_, false);
    piece.first = piece.restarted ? 0 : std::min(position, samples_.size());
    piece.records.assign(samples_.begin() + static_cast<std::ptrdiff_t>(piece.first),
                         samples_.end());
    position = samples_.size();
    return piece;
  });
  QVERIFY(
      waitFor([&] { return table().model()->rowCount() == static_cast<int>(samples_.size()); }));
}

void TrajectoryPanelTest::speedHeightAndGaps() {
  follow(circle(100));
  panel_->plots().setHoveredFrame(20);
  const QString words = panel_->plots().valuesText();
  // 2 rad/s on 1 m; the straight line over five frames of an arc is 0.25 % short: 1.99498 m/s.
  QVERIFY2(words.contains(QStringLiteral("1.99 m/s")), qPrintable(words));
  QVERIFY2(words.contains(QStringLiteral("1.000 m")), qPrintable(words));
  auto* gaps = panel_->findChild<GapList*>();
  QCOMPARE(gaps->rowCount(), 1);
  QCOMPARE(gaps->item(0, 0)->text(), QStringLiteral("frame 41")); // people count from 1
  QCOMPARE(gaps->item(0, 1)->text(), QStringLiteral("frame 50"));
  // From frame 39 to frame 50 at 30 frames a second: 11 / 30 s.
  QVERIFY(gaps->item(0, 2)->text().startsWith(QStringLiteral("0.37 s")));
}

void TrajectoryPanelTest::chosenGapIsTheRange() {
  follow(circle(100));
  QSignalSpy chosen(&selection_, &Selection::selectedRangeChanged);
  panel_->findChild<GapList*>()->selectRow(0);
  QCOMPARE(chosen.size(), 1);
  QCOMPARE(selection_.selectedRange(), std::optional(SelectedRange{40, 49}));
  QCOMPARE(table().selectionModel()->selectedRows().size(), 10);
  selection_.selectRange(std::nullopt);
  QVERIFY(!table().selectionModel()->hasSelection());
  QVERIFY(!panel_->findChild<GapList*>()->selectionModel()->hasSelection());
}

void TrajectoryPanelTest::tableFollowsAndGoesBack() {
  follow(circle(30));
  samples_ = circle(60);
  panel_->refresh();
  QVERIFY(waitFor([&] { return table().model()->rowCount() == 60; }));
  auto* bar = table().verticalScrollBar();
  QCOMPARE(bar->value(), bar->maximum());
  // With less room it stays at the end.
  const int before = bar->maximum();
  panel_->resize(1000, 150);
  QVERIFY(waitFor([&] { return bar->maximum() > before; }));
  QCOMPARE(bar->value(), bar->maximum());
  samples_ = circle(70);
  panel_->refresh();
  QVERIFY(waitFor([&] { return table().model()->rowCount() == 70; }));
  QCOMPARE(bar->value(), bar->maximum());
  panel_->resize(1000, 300);
  samples_ = circle(60);
  restarted_ = true;
  panel_->refresh();
  QVERIFY(waitFor([&] { return table().model()->rowCount() == 60; }));
  samples_ = circle(10); // the run went back
  restarted_ = true;
  panel_->refresh();
  QVERIFY(waitFor([&] { return table().model()->rowCount() == 10; }));
  QCOMPARE(panel_->findChild<GapList*>()->rowCount(), 0);
}

void TrajectoryPanelTest::rowOfTheFrameShownIsMarkedAndInSight() {
  follow(circle(200));
  selection_.setCurrentFrame(199, 6.6, false);
  QCOMPARE(markedRows(), std::pair(199, 200));
  QVERIFY(isRowVisible(199));
  const QImage before = table().grab().toImage();
  for (const int frame : {100, 101, 20, 150}) {
    selection_.setCurrentFrame(frame, frame / 30.0, true);
    QCOMPARE(markedRows(), std::pair(frame, frame + 1));
    QVERIFY(isRowVisible(frame));
  }
  // It is a color of its own.
  const QRect cell = table().visualRect(table().model()->index(150, 0));
  const QImage with = table().viewport()->grab(cell).toImage();
  selection_.setCurrentFrame(151, 5.0, true);
  QVERIFY(with != table().viewport()->grab(cell).toImage());
  // A frame that the table does not have yet: the end is in sight, and nothing is marked.
  selection_.setCurrentFrame(204, 6.8, false);
  QCOMPARE(markedRows().second - markedRows().first, 0);
  QVERIFY(isRowVisible(199));
  samples_ = circle(210);
  panel_->refresh();
  QVERIFY(waitFor([&] { return table().model()->rowCount() == 210; }));
  QCOMPARE(markedRows(), std::pair(204, 205));
  QVERIFY(isRowVisible(204));
}

void TrajectoryPanelTest::whoScrollsOrSelectsIsLeftAlone() {
  follow(circle(200));
  auto* bar = table().verticalScrollBar();
  QVERIFY(waitFor([&] { return bar->maximum() > 150; }));
  selection_.setCurrentFrame(150, 5.0, true);
  bar->setValue(10); // as a wheel does
  selection_.setCurrentFrame(151, 5.0, true);
  QCOMPARE(bar->value(), 10);
  QCOMPARE(markedRows(), std::pair(151, 152)); // marked all the same
  selection_.requestFrame(90);                 // who goes somewhere wants to see it
  selection_.setCurrentFrame(90, 3.0, true);
  QVERIFY(isRowVisible(90));
  bar->setValue(10);
  bar->setValue(88); // scrolled back to where it is
  selection_.setCurrentFrame(120, 4.0, true);
  QVERIFY(isRowVisible(120));
  selection_.selectRange(SelectedRange{40, 49});
  const int there = bar->value();
  selection_.setCurrentFrame(180, 6.0, true);
  QCOMPARE(bar->value(), there);
}

void TrajectoryPanelTest::longRunsAreBounded() {
  PlotSeries series;
  series.reset(1);
  constexpr std::int64_t kIterations = 500000; // 4.6 hours of one iteration at 30 frames a second
  for (std::int64_t i = 0; i < kIterations; ++i) {
    const auto value = static_cast<float>(i % 100);
    series.append({i, i, static_cast<double>(i) / 30.0}, std::span(&value, 1));
  }
  QVERIFY(series.size() <= PlotSeries::kMaxRows);
  QCOMPARE(series.row(0).iteration, 0);
  QCOMPARE(series.row(series.size() - 1).iteration, kIterations - 1);
  // The newest are there in full.
  QCOMPARE(series.row(series.size() - 1000).iteration, kIterations - 1000);
  const auto line = series.curvePoints(0, PlotAxis::Iterations, 0.0, kIterations, 800);
  QVERIFY(line.axisPositions.size() <= 2 * 802);
  QVERIFY(std::ranges::is_sorted(line.axisPositions));
}

void TrajectoryPanelTest::drawingKeepsTheExtremes() {
  PlotSeries series;
  series.reset(1);
  for (std::int64_t i = 0; i < 20000; ++i) {
    const float value = i == 12345 ? 99.0F : i == 777 ? -99.0F : 1.0F;
    series.append({i, i, static_cast<double>(i)}, std::span(&value, 1));
  }
  const auto line = series.curvePoints(0, PlotAxis::Iterations, 0.0, 20000.0, 300);
  QCOMPARE(std::ranges::max(line.values), 99.0);
  QCOMPARE(std::ranges::min(line.values), -99.0);
}

void TrajectoryPanelTest::timeShowsTheLastIterationOfAFrame() {
  PlotSeries series;
  series.reset(1);
  for (std::int64_t i = 0; i < 30; ++i) {
    const auto value = static_cast<float>(i);
    series.append({i, i / 3, static_cast<double>(i / 3)}, std::span(&value, 1)); // 3 per frame
  }
  const auto line = series.curvePoints(0, PlotAxis::Time, 0.0, 9.0, 300);
  QCOMPARE(line.values.size(), std::size_t{10});
  QCOMPARE(line.values[4], 14.0); // frame 4: iterations 12, 13, 14
  QCOMPARE(series.row(*series.nearestRow(PlotAxis::Time, 4.1)).iteration, 14);
  QCOMPARE(series.row(*series.rowAtFrame(4)).iteration, 14);
}

void TrajectoryPanelTest::longRunsAreDrawnFromFewPoints() {
  PlotStack stack;
  stack.setPlots(plotsOfRun({QStringLiteral("left"), QStringLiteral("right")}));
  stack.setShownPlots({QStringLiteral("spread"), QStringLiteral("sampleSize"),
                       QStringLiteral("likelihood"), QStringLiteral("error")});
  PlotSeries series;
  series.reset(columnCountOfRunPlots(2));
  IterationRecord record;
  record.cameraEvidence.resize(2);
  for (std::int64_t i = 0; i < 40000; ++i) {
    const double wave = std::sin(0.37 * static_cast<double>(i * i % 1009));
    record.iteration = i + 1;
    record.frame = i;
    record.frameTime = static_cast<double>(i) / 30.0;
    record.spreadPerAxis = Eigen::Vector3d(0.01, 0.02, 0.03) * (1.5 + wave);
    record.position = Eigen::Vector3d(0.5, 0.1 * wave, 0.2);
    record.truth = Eigen::Vector3d(0.5, 0.0, 0.2);
    record.effectiveSampleSize = 100.0 + 50.0 * wave;
    record.particleCount = 200;
    record.distanceToTruth = 0.02 * (1.1 + wave);
    for (CameraEvidence& camera : record.cameraEvidence) {
      camera = {true, -20.0 + wave, 0.9, 1.0};
    }
    appendIteration(series, record);
  }
  stack.setSeries(&series);
  stack.resize(1400, 240);
  stack.show();
  QVERIFY(QTest::qWaitForWindowExposed(&stack));
  QVERIFY(waitFor([&] { return stack.drawnPointCount() > 0; }));
  // Eight curves, two points for each of at most 1400 pixels, and one beyond either end.
  QVERIFY(stack.drawnPointCount() <= 8 * (2 * 1400 + 4));
  stack.showWholeRun();
  stack.showWholeRun();
  qInfo("40,000 iterations, %d points: %.1f ms per drawing", stack.drawnPointCount(),
        stack.lastDrawingMs());
  // A short run is drawn more smoothly.
  stack.setShownPlots({QStringLiteral("position"), QStringLiteral("spread"),
                       QStringLiteral("sampleSize"), QStringLiteral("likelihood")});
  series.removeFrom(700);
  stack.showWholeRun();
  stack.showWholeRun();
  qInfo("700 iterations, %d points: %.1f ms per drawing", stack.drawnPointCount(),
        stack.lastDrawingMs());
}

DEWPOINT_WINDOW_TEST(TrajectoryPanelTest)

} // namespace dewpoint::tests

#include "trajectory_panel_test.moc"
