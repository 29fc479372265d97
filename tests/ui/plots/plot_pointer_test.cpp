// SPDX-License-Identifier: GPL-3.0-or-later
// The pointer and the wheel over the plots: what they show, and what they leave as it is.
#include "core/session/snapshot/snapshot.h"
#include "tests/ui/window_fixture.h"
#include "tests/ui/window_test.h"
#include "ui/plots/plot_panel.h"
#include "ui/plots/plot_stack.h"
#include "ui/timeline/timeline.h"

#include <QImage>
#include <QLabel>
#include <QMouseEvent>
#include <QScrollArea>
#include <QScrollBar>
#include <QToolTip>
#include <QWheelEvent>

namespace dewpoint::tests {

namespace {
constexpr int kPointedFrames = 60; ///< of the demo, tracked before
} // namespace

class PlotPointerTest : public QObject, private test::WindowFixture {
  Q_OBJECT

private Q_SLOTS:
  void initTestCase();
  void cleanupTestCase() { window_.reset(); }
  void cleanup();
  void hoveringChangesNoNumbers();
  void hoveringTheTimelineChangesNoNumbers();
  void theLabelOfKeysHasAllPlots();
  void theWheelScrollsTheStack();
  void theWheelZoomsWithCtrl();
  void theWheelPansWithShift();

private:
  PlotStack& plots() { return window_->findChild<PlotPanel*>()->stack(); }
  QWidget* canvas() { return plots().focusProxy(); }
  QScrollBar* bar() {
    return plots().findChild<QScrollArea*>(QStringLiteral("plotScroll"))->verticalScrollBar();
  }
  QString title() { return find<QLabel>("plotPlace")->text(); }
  /// The numbers beside the plots, as drawn.
  QImage numbers() {
    return canvas()->grab(QRect(canvas()->width() - 250, 0, 250, canvas()->height())).toImage();
  }
  /// A place on the curves of the first plot, by its share of the shown width.
  QPoint at(double share) {
    const int left = 60; // of the numbers of the axis
    const int right = canvas()->width() - 260;
    return {left + static_cast<int>(share * (right - left)), 20};
  }
  /// The pointer over a widget; not the display's own, which moves when it likes.
  static void point(QWidget* widget, QPoint place) {
    QMouseEvent event(QEvent::MouseMove, place, widget->mapToGlobal(place), Qt::NoButton,
                      Qt::NoButton, Qt::NoModifier);
    QApplication::sendEvent(widget, &event);
  }
  static void leave(QWidget* widget) {
    QEvent event(QEvent::Leave);
    QApplication::sendEvent(widget, &event);
  }
  /// Turns the wheel over the plots. What they ignore goes on to their parents, as it does from a
  /// real wheel; Qt stops at the first widget if an event is sent by hand.
  void turnWheel(int notches, Qt::KeyboardModifiers modifiers) {
    const QPoint global = canvas()->mapToGlobal(at(0.5));
    for (QWidget* widget = canvas(); widget != nullptr; widget = widget->parentWidget()) {
      QWheelEvent event(widget->mapFromGlobal(global), global, {}, {0, 120 * notches}, Qt::NoButton,
                        modifiers, Qt::NoScrollPhase, false);
      event.ignore();
      QApplication::sendEvent(widget, &event);
      if (event.isAccepted()) {
        return;
      }
    }
  }
  /// Number of plots in the label at the pointer.
  static qsizetype plotsInLabel() {
    return QToolTip::text().count(QLatin1Char('\n')) - 1; // without the frame and the hint
  }
};

void PlotPointerTest::initTestCase() {
  makeWindow({.size = {1400, 1000}, .theme = Theme::Light, .play = false});
  window_->openProject({});
  for (int frame = 0; frame < kPointedFrames; ++frame) {
    QVERIFY(waitFor([&] {
      return window_->shown() && window_->shown()->frame == frame &&
             window_->shown()->iterationCount > 0;
    }));
    if (frame + 1 < kPointedFrames) {
      action("actionNextFrame")->trigger();
    }
  }
  QVERIFY(waitFor([this] { return plots().drawnPointCount() > 0 && plots().isDrawn(); }));
  QVERIFY(draws(*window_));
}

void PlotPointerTest::cleanup() {
  leave(canvas());
  plots().showWholeRun();
  bar()->setValue(0);
  QVERIFY(waitFor([] { return !QToolTip::isVisible(); }));
}

void PlotPointerTest::hoveringChangesNoNumbers() {
  // The title and the numbers belong to the frame in all views; a label at the pointer and a thin
  // line show the other one.
  const QString shown = QStringLiteral("frame %1,").arg(window_->shown()->frame + 1);
  const QString before = title();
  QVERIFY2(before.contains(shown), qPrintable(before));
  const QImage numbersBefore = numbers();
  point(canvas(), at(0.1));
  point(canvas(), at(0.3));
  QVERIFY(!plots().cursorText().contains(shown));
  QVERIFY2(QToolTip::text().startsWith(plots().cursorText()), qPrintable(QToolTip::text()));
  QVERIFY2(QToolTip::text().contains(QStringLiteral("Position: x ")), qPrintable(QToolTip::text()));
  QVERIFY(QToolTip::text().contains(QStringLiteral("Ctrl+wheel")));
  QCOMPARE(plotsInLabel(), qsizetype{1}); // the plot under the pointer
  QCOMPARE(title(), before);
  QCOMPARE(numbers(), numbersBefore);
  leave(canvas());
  QVERIFY(plots().cursorText().contains(shown));
}

void PlotPointerTest::hoveringTheTimelineChangesNoNumbers() {
  const QString before = title();
  const QImage numbersBefore = numbers();
  auto* timeline = find<Timeline>("timeline");
  point(timeline, timeline->positionOf(7));
  QVERIFY(plots().cursorText().contains(QStringLiteral("frame 8,"))); // the thin line
  QCOMPARE(title(), before);
  QCOMPARE(numbers(), numbersBefore);
  QCOMPARE(window_->shown()->frame, qint64{kPointedFrames - 1});
  leave(timeline);
}

void PlotPointerTest::theLabelOfKeysHasAllPlots() {
  const QString before = title();
  canvas()->setFocus();
  QTest::keyClick(canvas(), Qt::Key_Left);
  QCOMPARE(plotsInLabel(), plots().visiblePlots().size());
  QCOMPARE(title(), before);
  QTest::keyClick(canvas(), Qt::Key_Escape);
  QVERIFY(waitFor([] { return !QToolTip::isVisible(); }));
}

void PlotPointerTest::theWheelScrollsTheStack() {
  for (const char* name : {"actionPlotExistence", "actionPlotDuration"}) {
    action(name)->trigger();
  }
  QVERIFY(waitFor([this] { return bar()->maximum() > 0; })); // seven plots do not fit
  turnWheel(-1, Qt::NoModifier);
  QVERIFY(bar()->value() > 0);
  QVERIFY(plots().showsWholeRun());
  turnWheel(20, Qt::NoModifier);
  QCOMPARE(bar()->value(), 0);
  QVERIFY(plots().showsWholeRun());
  for (const char* name : {"actionPlotExistence", "actionPlotDuration"}) {
    action(name)->trigger();
  }
}

void PlotPointerTest::theWheelZoomsWithCtrl() {
  const auto [first, last] = plots().shownRange();
  const int scrolled = bar()->value();
  point(canvas(), at(0.5));
  const QString under = plots().cursorText();
  turnWheel(4, Qt::ControlModifier);
  const auto [lower, upper] = plots().shownRange();
  QVERIFY(upper - lower < 0.5 * (last - first)); // 1.25⁴ = 2.44
  QCOMPARE(bar()->value(), scrolled);
  point(canvas(), at(0.1));
  point(canvas(), at(0.5));
  QCOMPARE(plots().cursorText(), under); // what was under the pointer is there still
  turnWheel(-8, Qt::ControlModifier);
  QVERIFY(plots().showsWholeRun());
}

void PlotPointerTest::theWheelPansWithShift() {
  turnWheel(6, Qt::ControlModifier);
  const auto [lower, upper] = plots().shownRange();
  const int scrolled = bar()->value();
  turnWheel(1, Qt::ShiftModifier);
  QVERIFY(plots().shownRange().first < lower);
  QCOMPARE(bar()->value(), scrolled);
  turnWheel(-1, Qt::ShiftModifier);
  QCOMPARE(plots().shownRange().first, lower);
  QCOMPARE(plots().shownRange().second, upper);
}

DEWPOINT_WINDOW_TEST(PlotPointerTest)

} // namespace dewpoint::tests

#include "plot_pointer_test.moc"
