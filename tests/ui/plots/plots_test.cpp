// SPDX-License-Identifier: GPL-3.0-or-later
// Plots and trajectory of the demo in the real window: data, cursor, span, table, pictures.
#include "core/session/session.h"
#include "core/session/snapshot/snapshot.h"
#include "tests/ui/window_fixture.h"
#include "tests/ui/window_test.h"
#include "ui/plots/plot_panel.h"
#include "ui/plots/plot_row.h"
#include "ui/plots/plot_stack.h"
#include "ui/selection/selection.h"
#include "ui/timeline/timeline.h"
#include "ui/trajectory/trajectory_panel.h"
#include "ui/view3d/birds_eye_view.h"

#include <QClipboard>
#include <QDockWidget>
#include <QLineF>
#include <QMouseEvent>
#include <QRegularExpression>
#include <QSignalSpy>
#include <QSvgRenderer>
#include <QTableView>

namespace dewpoint::tests {

namespace {
constexpr int kDemoFrames = 100; ///< of the demo, tracked before; from 60 on the ball moves
} // namespace

class PlotsTest : public QObject, private test::WindowFixture {
  Q_OBJECT

private Q_SLOTS:
  void initTestCase();
  void cleanupTestCase();
  void init();
  void curvesHaveTheRun();
  void everyPlotCanBeShown();
  void ticksAreWrittenAsTheyAre();
  void pointerShowsOneFrameInAllViews();
  void wheelDragAndKeysMoveAlongTheAxis();
  void rangeOfThePlotsIsSelectedInTheTable();
  void rowsOfTheTableAreARangeInThePlotsAndTheRoom();
  void positionOfTheTailIsAFrame();
  void csvIsWhatIsShown();
  void trajectoryCsvIsWhatIsSelected();
  void picturesCanBeRead();
  void restartBeginsAnew();

private:
  PlotStack& plots() { return window_->findChild<PlotPanel*>()->stack(); }
  TrajectoryPanel& trajectory() { return *window_->findChild<TrajectoryPanel*>(); }
  QTableView& table() {
    return *window_->findChild<QTableView*>(QStringLiteral("trajectoryTable"));
  }
  QWidget* canvas() { return plots().focusProxy(); }
  /// A place on the curves, by its share of the shown width.
  QPoint at(double share) {
    const int left = 60; // of the numbers of the axis
    const int right = canvas()->width() - 260;
    return {left + static_cast<int>(share * (right - left)), canvas()->height() / 3};
  }
  /// The pointer over the plots; not the display's own, which moves when it likes.
  void point(QPoint place) {
    QMouseEvent event(QEvent::MouseMove, place, canvas()->mapToGlobal(place), Qt::NoButton,
                      Qt::NoButton, Qt::NoModifier);
    QApplication::sendEvent(canvas(), &event);
  }
  static QStringList csvLines(const QString& text) {
    return text.trimmed().split(QLatin1Char('\n'));
  }
  /// Brings the trajectory to the front, and waits until it has all rows.
  void openTrajectory();
};

void PlotsTest::initTestCase() {
  makeWindow({.size = {1400, 1000}, .theme = Theme::Light, .play = false});
  window_->openProject({});
  for (int frame = 0; frame < kDemoFrames; ++frame) {
    QVERIFY(waitFor([&] {
      return window_->shown() && window_->shown()->frame == frame &&
             window_->shown()->iterationCount > 0;
    }));
    if (frame + 1 < kDemoFrames) {
      action("actionNextFrame")->trigger();
    }
  }
  QVERIFY(waitFor([this] { return plots().drawnPointCount() > 0; }));
}

void PlotsTest::cleanupTestCase() {
  window_.reset();
}

void PlotsTest::init() {
  plots().showWholeRun();
  action("actionPlotOverTime")->setChecked(false);
  QTest::keyClick(canvas(), Qt::Key_Escape);
  QVERIFY(!plots().selectedRange());
}

void PlotsTest::openTrajectory() {
  auto* dock = window_->findChild<QDockWidget*>(QStringLiteral("trajectoryDock"));
  dock->show();
  dock->raise();
  QVERIFY(waitFor(
      [this] { return table().isVisible() && table().model()->rowCount() == kDemoFrames; }));
}

void PlotsTest::curvesHaveTheRun() {
  const qint64 iterations = window_->shown()->iterationCount;
  QCOMPARE(window_->findChild<PlotPanel*>()->shownIterationCount(), static_cast<int>(iterations));
  // As in the desk's plan of the window; the demo knows its truth.
  QCOMPARE(plots().visiblePlots(),
           (QStringList{"position", "spread", "sampleSize", "likelihood", "error"}));
  const auto [first, last] = plots().shownRange();
  QVERIFY(first <= 1.0 && last >= static_cast<double>(iterations));
}

void PlotsTest::everyPlotCanBeShown() {
  action("actionPlotExistence")->trigger();
  action("actionPlotDuration")->trigger();
  QCOMPARE(plots().visiblePlots(), (QStringList{"position", "spread", "sampleSize", "likelihood",
                                                "existence", "error", "duration"}));
  const QString words = plots().valuesText();
  // The time of an iteration: under a sanitizer it takes milliseconds.
  const bool saysHowLong = words.contains(QStringLiteral("µs")) ||
                           words.contains(QRegularExpression(QStringLiteral("\\d.ms")));
  QVERIFY2(words.contains(QStringLiteral("mm")) && saysHowLong, qPrintable(words));
  action("actionPlotExistence")->trigger();
  action("actionPlotDuration")->trigger();
  QCOMPARE(plots().visiblePlots().size(), 5);
}

void PlotsTest::ticksAreWrittenAsTheyAre() {
  auto* canvas = trajectory().plots().findChild<QCustomPlot*>(QStringLiteral("plotCanvas"));
  QCPAxis* axis = canvas->axisRect(0)->axis(QCPAxis::atBottom);
  const auto labels = [&](double end) {
    QVector<double> ticks;
    QVector<QString> texts;
    axis->ticker()->generate(QCPRange(0.0, end), canvas->locale(), 'f', 0, ticks, nullptr, &texts);
    for (qsizetype i = 0; i < ticks.size(); ++i) {
      if (std::abs(canvas->locale().toDouble(texts[i]) - ticks[i]) > 1e-9) {
        return QStringList{texts[i] + QStringLiteral(" is not ") + QString::number(ticks[i])};
      }
    }
    return QStringList(texts.begin(), texts.end());
  };
  for (const double end : {0.13, 0.6, 2.0, 12.6, 37.0, 126.0, 4000.0}) {
    QVERIFY2(labels(end).size() > 2, qPrintable(labels(end).join(QLatin1Char(' '))));
  }
  QVERIFY(labels(12.6).contains(QStringLiteral("2.5")));
  window_->setLocale(QLocale(QLocale::German));
  QVERIFY(labels(12.6).contains(QStringLiteral("2,5")));
  window_->setLocale(QLocale());
  QVERIFY(labels(12.6).contains(QStringLiteral("2.5")));
}

void PlotsTest::pointerShowsOneFrameInAllViews() {
  QSignalSpy hovered(&plots(), &PlotStack::frameHovered);
  point(at(0.1));
  point(at(0.3));
  QVERIFY(waitFor([&] { return !hovered.isEmpty(); }));
  const qint64 frame = hovered.last().first().toLongLong();
  QVERIFY(frame > 0 && frame < kDemoFrames - 1);
  QVERIFY(plots().cursorText().contains(QStringLiteral("frame %1,").arg(frame + 1)));
  // Left and right: one frame each.
  QTest::keyClick(canvas(), Qt::Key_Right);
  QVERIFY(plots().cursorText().contains(QStringLiteral("frame %1,").arg(frame + 2)));
  // The timeline shows it as well, and the other way round.
  auto* timeline = window_->findChild<Timeline*>(QStringLiteral("timeline"));
  const QImage with = timeline->grab().toImage();
  const QPoint there = timeline->positionOf(frame + 1);
  timeline->setHoveredFrame(-1);
  const QImage without = timeline->grab().toImage();
  int changed = 0;
  for (int x = 0; x < with.width(); ++x) {
    const bool same = with.pixelColor(x, there.y()) == without.pixelColor(x, there.y());
    changed += same ? 0 : 1;
    QVERIFY(same || std::abs(x - there.x()) <= 3);
  }
  QVERIFY(changed > 0);
  openTrajectory();
  QVERIFY(trajectory().plots().cursorText().contains(QStringLiteral("frame %1,").arg(frame + 2)));
  QMouseEvent over(QEvent::MouseMove, timeline->positionOf(7), timeline->positionOf(7),
                   Qt::NoButton, Qt::NoButton, Qt::NoModifier);
  QApplication::sendEvent(timeline, &over);
  QVERIFY(trajectory().plots().cursorText().contains(QStringLiteral("frame 8,")));
  QEvent leaving(QEvent::Leave);
  QApplication::sendEvent(timeline, &leaving);
  QVERIFY(!trajectory().plots().cursorText().contains(QStringLiteral("frame 8,")));
  window_->findChild<QDockWidget*>(QStringLiteral("plotDock"))->raise();
}

void PlotsTest::wheelDragAndKeysMoveAlongTheAxis() {
  const auto width = [this] {
    const auto [first, last] = plots().shownRange();
    return last - first;
  };
  const double all = width();
  QTest::keyClick(canvas(), Qt::Key_Home); // the cursor: what keys zoom about
  for (int i = 0; i < 4; ++i) {
    QTest::keyClick(canvas(), Qt::Key_Plus);
  }
  QVERIFY(!plots().showsWholeRun());
  QVERIFY(width() < 0.5 * all); // 1.25⁴ = 2.44
  const double before = plots().shownRange().first;
  QTest::mousePress(canvas(), Qt::LeftButton, {}, at(0.8));
  point(at(0.6));
  point(at(0.5));
  QTest::mouseRelease(canvas(), Qt::LeftButton, {}, at(0.5));
  QVERIFY(plots().shownRange().first > before); // dragged to the left: later moments
  QTest::mouseDClick(canvas(), Qt::LeftButton, {}, at(0.5));
  QVERIFY(plots().showsWholeRun());
  QCOMPARE(width(), all);
  QTest::keyClick(canvas(), Qt::Key_Plus);
  action("actionPlotAll")->trigger();
  QVERIFY(plots().showsWholeRun());
}

void PlotsTest::rangeOfThePlotsIsSelectedInTheTable() {
  openTrajectory();
  QSignalSpy highlighted(&trajectory(), &TrajectoryPanel::highlightChanged);
  auto* dock = window_->findChild<QDockWidget*>(QStringLiteral("plotDock"));
  dock->raise();
  QVERIFY(waitFor([this] { return canvas()->isVisible(); }));
  QTest::mousePress(canvas(), Qt::LeftButton, Qt::ShiftModifier, at(0.2));
  point(at(0.3));
  point(at(0.6));
  QTest::mouseRelease(canvas(), Qt::LeftButton, Qt::ShiftModifier, at(0.6));
  QVERIFY(plots().selectedRange());
  const SelectedRange selectedRange = *plots().selectedRange();
  QVERIFY(selectedRange.first < selectedRange.last);
  QCOMPARE(window_->selection().selectedRange(), plots().selectedRange());
  // One target: a row for each frame.
  QCOMPARE(table().selectionModel()->selectedRows().size(),
           selectedRange.last - selectedRange.first + 1);
  QVERIFY(!highlighted.isEmpty());
  QTest::keyClick(canvas(), Qt::Key_Escape);
  QVERIFY(!window_->selection().selectedRange());
  QVERIFY(!table().selectionModel()->hasSelection());
}

void PlotsTest::rowsOfTheTableAreARangeInThePlotsAndTheRoom() {
  openTrajectory();
  QVERIFY(
      waitFor([this] { return !window_->findChild<BirdsEyeView*>()->currentImage().isNull(); }));
  const QImage before = window_->findChild<BirdsEyeView*>()->currentImage();
  table().setFocus();
  table().selectRow(64);
  QTest::keyClick(&table(), Qt::Key_Down, Qt::ShiftModifier);
  for (int i = 0; i < 20; ++i) {
    QTest::keyClick(&table(), Qt::Key_Down, Qt::ShiftModifier);
  }
  QVERIFY(plots().selectedRange());
  QCOMPARE(*plots().selectedRange(), (SelectedRange{64, 85})); // rows from 64 on, 21 steps down
  QCOMPARE(trajectory().plots().selectedRange(), plots().selectedRange());
  QVERIFY(window_->findChild<BirdsEyeView*>()->currentImage() != before);
  window_->findChild<QDockWidget*>(QStringLiteral("plotDock"))->raise();
}

void PlotsTest::positionOfTheTailIsAFrame() {
  openTrajectory();
  auto* view = window_->findChild<BirdsEyeView*>();
  QVERIFY(waitFor([&] { return !view->currentImage().isNull(); }));
  const auto& tail = window_->shown()->targets.front().tailPositions;
  QCOMPARE(tail.size(), static_cast<std::size_t>(kDemoFrames));
  const auto pixel = [&](std::size_t frame) {
    const Eigen::Vector2d place = view->scene().projectToImage(tail[frame]);
    const QPointF offset(place.x(), -place.y());
    return (QPointF(view->width(), view->height()) / 2.0 + offset / view->devicePixelRatioF());
  };
  QSignalSpy wanted(&window_->selection(), &Selection::frameRequested);
  QTest::mouseClick(view, Qt::LeftButton, {}, pixel(80).toPoint());
  QCOMPARE(wanted.size(), 1);
  // Neighbors in the tail may be nearer to the whole pixel that was clicked.
  const auto chosen = wanted.first().first().toULongLong();
  QVERIFY(QLineF(pixel(chosen), pixel(80)).length() < 2.0);
  QTest::mouseClick(view, Qt::LeftButton, Qt::ShiftModifier, pixel(80).toPoint());
  QVERIFY(window_->selection().selectedRange());
  const SelectedRange selectedRange = *window_->selection().selectedRange();
  QVERIFY(selectedRange.first == static_cast<qint64>(chosen) ||
          selectedRange.last == static_cast<qint64>(chosen));
  window_->selection().requestLiveFrame();
  QVERIFY(waitFor([this] { return window_->shown()->frame == kDemoFrames - 1; }));
  window_->findChild<QDockWidget*>(QStringLiteral("plotDock"))->raise();
}

void PlotsTest::csvIsWhatIsShown() {
  action("actionPlotCopy")->trigger();
  QStringList lines = csvLines(QApplication::clipboard()->text());
  QVERIFY(lines.first().startsWith(
      QStringLiteral("iteration,frame,time_s,x_m,y_m,z_m,true_x_m,true_y_m,true_z_m,spread_x_mm,"
                     "spread_y_mm,spread_z_mm,effective_sample_size,particles,log_likelihood_")));
  QCOMPARE(lines.size() - 1, window_->shown()->iterationCount);
  const qsizetype columns = lines.first().split(QLatin1Char(',')).size();
  for (const QString& line : lines) {
    QCOMPARE(line.split(QLatin1Char(',')).size(), columns);
  }
  // The last line is the estimate that the window shows.
  const QStringList last = lines.last().split(QLatin1Char(','));
  const auto estimate = std::get<SphereEstimate>(window_->shown()->targets.front().estimate);
  QCOMPARE(last[0].toLongLong(), window_->shown()->iterationCount);
  QCOMPARE(last[1].toLongLong(), window_->shown()->frame);
  // Kept as float: 24 bits.
  for (int axis = 0; axis < 3; ++axis) {
    QVERIFY(std::abs(last[3 + axis].toDouble() - estimate.mean[axis]) < 1e-6);
    QVERIFY(std::abs(last[6 + axis].toDouble() -
                     window_->shown()->targets.front().truth.value()[axis]) < 1e-6);
  }
  QVERIFY(std::abs(last[9].toDouble() - 1000.0 * std::sqrt(estimate.covariance(0, 0))) <
          1e-3 * last[9].toDouble() + 1e-6);
  QVERIFY(std::abs(last[12].toDouble() - estimate.effectiveSampleSize) <
          1e-6 * estimate.effectiveSampleSize);
  // A part of the axis: that part of the table.
  QTest::keyClick(canvas(), Qt::Key_Home);
  for (int i = 0; i < 4; ++i) {
    QTest::keyClick(canvas(), Qt::Key_Plus);
  }
  const auto [lower, upper] = plots().shownRange();
  action("actionPlotCopy")->trigger();
  lines = csvLines(QApplication::clipboard()->text());
  QVERIFY(lines.size() > 1 && lines.size() - 1 < window_->shown()->iterationCount);
  for (const QString& line : lines.mid(1)) {
    const double iteration = line.section(QLatin1Char(','), 0, 0).toDouble();
    QVERIFY(iteration >= lower && iteration <= upper);
  }
}

void PlotsTest::trajectoryCsvIsWhatIsSelected() {
  openTrajectory();
  QApplication::clipboard()->clear();
  action("actionTrajectoryCopy")->trigger();
  QVERIFY(waitFor([] { return !QApplication::clipboard()->text().isEmpty(); }));
  QCOMPARE(csvLines(QApplication::clipboard()->text()).size(), 1 + kDemoFrames);
  table().selectRow(7);
  QApplication::clipboard()->clear();
  action("actionTrajectoryCopy")->trigger();
  QVERIFY(waitFor([] { return !QApplication::clipboard()->text().isEmpty(); }));
  const QStringList lines = csvLines(QApplication::clipboard()->text());
  QCOMPARE(lines.size(), 2);
  const QStringList cells = lines.last().split(QLatin1Char(','));
  QCOMPARE(cells[1], QStringLiteral("7"));
  // The table shows the same place, to a tenth of a millimeter.
  const QString shown = table().model()->index(7, 3).data().toString();
  QCOMPARE(QLocale::c().toString(cells[3].toDouble(), 'f', 4).replace('-', QChar(0x2212)), shown);
  window_->findChild<QDockWidget*>(QStringLiteral("plotDock"))->raise();
}

void PlotsTest::picturesCanBeRead() {
  QVERIFY(waitFor([this] { return canvas()->isVisible(); }));
  QTemporaryDir folder;
  auto* panel = window_->findChild<PlotPanel*>();
  const QString svg = folder.filePath(QStringLiteral("plots.svg"));
  QSignalSpy saved(panel, &PlotPanel::noticeRequested);
  panel->savePicture(svg);
  QVERIFY(waitFor([&] { return saved.size() == 1; }));
  QSvgRenderer renderer(svg);
  QVERIFY(renderer.isValid());
  // As wide as in the window; however low the plots are there, on paper they can be read.
  QCOMPARE(renderer.viewBox().width(), canvas()->width());
  QVERIFY(renderer.viewBox().height() >= canvas()->height());
  QVERIFY(renderer.viewBox().height() >= 80 * plots().visiblePlots().size());
  QFile file(svg);
  QVERIFY(file.open(QIODevice::ReadOnly));
  QVERIFY(file.readAll().contains("Spread")); // text stays text
  const QString png = folder.filePath(QStringLiteral("plots.png"));
  panel->savePicture(png);
  QVERIFY(waitFor([&] { return saved.size() == 2; }));
  const QImage picture(png);
  QVERIFY(picture.width() >= 2 * canvas()->width()); // twice the window's pixels
  QSignalSpy failed(panel, &PlotPanel::failed);
  panel->savePicture(QStringLiteral("/proc/none/plots.svg"));
  QVERIFY(waitFor([&] { return failed.size() == 1; }));
  QCOMPARE(saved.size(), 2);
}

void PlotsTest::restartBeginsAnew() {
  openTrajectory();
  action("actionRestart")->trigger();
  QVERIFY(waitFor([this] { return window_->shown()->iterationCount == 0; }));
  action("actionNextFrame")->trigger();
  QVERIFY(waitFor([this] { return table().model()->rowCount() == 1; }));
  QCOMPARE(window_->findChild<PlotPanel*>()->shownIterationCount(),
           static_cast<int>(window_->shown()->iterationCount));
}

DEWPOINT_WINDOW_TEST(PlotsTest)

} // namespace dewpoint::tests

#include "plots_test.moc"
