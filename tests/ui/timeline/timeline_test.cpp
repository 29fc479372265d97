// SPDX-License-Identifier: GPL-3.0-or-later
// Going through time in the real window: scrubbing with mouse and keys, marks, spans, tracking
// again.
#include "core/session/frames/trouble_search.h"
#include "core/session/session.h"
#include "core/session/snapshot/snapshot.h"
#include "tests/ui/window_fixture.h"
#include "tests/ui/window_test.h"
#include "ui/cameraview/camera_view.h"
#include "ui/document/document.h"
#include "ui/selection/selection.h"
#include "ui/timeline/timeline.h"

#include <QLabel>
#include <QLineEdit>
#include <QSignalSpy>
#include <QUndoStack>

#include <map>

namespace dewpoint::tests {

namespace {
constexpr qint64 kTracked = 40; ///< frames tracked at first
} // namespace

class TimelineTest : public QObject, private test::WindowFixture {
  Q_OBJECT

private Q_SLOTS:
  void init();
  void cleanup() { window_.reset(); }
  void scrubbingShowsThatFrameInAllViews();
  void keysGoByFramesSecondsAndToTheEnds();
  void playGoesOnFromTheFrameShown();
  void aNewNameIsShownAtOnceWhileLookingBack();
  void trackingAgainReplacesWhatFollows();
  void markersAreStepsOfTheDocument();
  void framesAndTimesCanBeEntered();
  void troubleIsFoundInBothDirections();
  void rangesAreSelectedAndZoomedTo();
  void titleSaysWhy();

private:
  bool showsFrame(qint64 frame) {
    return waitFor(
        [&] { return shown().frame == frame && window_->selection().currentFrame() == frame; });
  }
  /// What a view shows once it has drawn the newest snapshot; empty if it does not in time.
  QImage picture(const char* view) {
    auto* widget = window_->findChild<QWidget*>(QLatin1String(view));
    return draws(*widget) ? widget->grab().toImage() : QImage();
  }
  void trigger(const char* action) {
    window_->findChild<QAction*>(QLatin1String(action))->trigger();
  }

  Timeline* timeline_ = nullptr;
};

void TimelineTest::init() {
  makeWindow({.theme = Theme::Light, .play = false});
  open();
  timeline_ = window_->findChild<Timeline*>(QStringLiteral("timeline"));
  QVERIFY(timeline_ != nullptr);
  QVERIFY(waitFor([this] { return shown().history.newestTrackedFrame == 0; }));
  for (qint64 frame = 1; frame < kTracked; ++frame) {
    trigger("actionNextFrame");
  }
  QVERIFY(waitFor([this] { return shown().history.newestTrackedFrame == kTracked - 1; }));
}

void TimelineTest::scrubbingShowsThatFrameInAllViews() {
  QVERIFY(showsFrame(kTracked - 1));
  const QImage now = picture("cameraView0");
  QTest::mousePress(timeline_, Qt::LeftButton, {}, timeline_->positionOf(30));
  QVERIFY(showsFrame(30));
  QTest::mouseMove(timeline_, timeline_->positionOf(12));
  QVERIFY(showsFrame(12));
  QTest::mouseRelease(timeline_, Qt::LeftButton, {}, timeline_->positionOf(12));
  QVERIFY(shown().isPast);
  QVERIFY(shown().isTracked);
  QCOMPARE(shown().frames->index, 12);
  QVERIFY(shown().targets.front().particles.rows() > 0);
  const QImage then = picture("cameraView0");
  QVERIFY(!now.isNull() && !then.isNull());
  QVERIFY(then != now);
  QVERIFY(window_->findChild<QLabel*>(QStringLiteral("statusFrame"))
              ->text()
              .contains(QStringLiteral("13"))); // people count from 1
  trigger("actionNow");
  QVERIFY(showsFrame(kTracked - 1));
  QVERIFY(!shown().isPast);
  QCOMPARE(picture("cameraView0"), now);
  // The same moment again is the same picture.
  QTest::mouseClick(timeline_, Qt::LeftButton, {}, timeline_->positionOf(12));
  QVERIFY(showsFrame(12));
  QCOMPARE(picture("cameraView0"), then);
}

void TimelineTest::keysGoByFramesSecondsAndToTheEnds() {
  timeline_->setFocus();
  QTest::keyClick(timeline_, Qt::Key_Left);
  QTest::keyClick(timeline_, Qt::Key_Left); // faster than the images come
  QVERIFY(showsFrame(kTracked - 3));
  QTest::keyClick(timeline_, Qt::Key_Right);
  QVERIFY(showsFrame(kTracked - 2));
  QTest::keyClick(timeline_, Qt::Key_PageUp); // the demo has 30 frames per second
  QVERIFY(showsFrame(kTracked - 32));
  QTest::keyClick(timeline_, Qt::Key_Home);
  QVERIFY(showsFrame(0));
  QTest::keyClick(timeline_, Qt::Key_PageDown);
  QVERIFY(showsFrame(30));
  QTest::keyClick(timeline_, Qt::Key_Left, Qt::ShiftModifier);
  QVERIFY(showsFrame(29));
  QVERIFY(window_->selection().selectedRange() == (SelectedRange{29, 30}));
  QTest::keyClick(timeline_, Qt::Key_Escape);
  QVERIFY(!window_->selection().selectedRange());
  QTest::keyClick(timeline_, Qt::Key_End);
  QVERIFY(showsFrame(kTracked - 1));
  QTest::keyClick(window_.get(), Qt::Key_Comma);
  QVERIFY(showsFrame(kTracked - 2));
}

void TimelineTest::playGoesOnFromTheFrameShown() {
  QTest::mouseClick(timeline_, Qt::LeftButton, {}, timeline_->positionOf(35));
  QVERIFY(showsFrame(35));
  QTest::keyClick(window_.get(), Qt::Key_Space);
  QVERIFY(waitFor(
      [this] { return shown().history.newestTrackedFrame > kTracked; })); // and goes on tracking
}

void TimelineTest::aNewNameIsShownAtOnceWhileLookingBack() {
  QTest::mouseClick(timeline_, Qt::LeftButton, {}, timeline_->positionOf(12));
  QVERIFY(showsFrame(12));
  QVERIFY(window_->document().edit(QStringLiteral("Rename target"), [](Project& project) {
    project.targets.front().name = "renamed";
  }));
  const QString name = QStringLiteral("renamed");
  QVERIFY(waitFor([&] { return timeline_->model().targetNames == QStringList{name}; }));
  QVERIFY(waitFor([&] { return find<QLabel>("plotTarget")->text() == name; }));
  QVERIFY(showsFrame(12));
  QVERIFY(shown().isPast);
}

void TimelineTest::trackingAgainReplacesWhatFollows() {
  const Eigen::Vector3d last = std::get<SphereEstimate>(shown().targets.front().estimate).mean;
  QTest::mouseClick(timeline_, Qt::LeftButton, {}, timeline_->positionOf(20));
  QVERIFY(showsFrame(20));
  const Eigen::Vector3d then = std::get<SphereEstimate>(shown().targets.front().estimate).mean;
  QVERIFY(window_->document().setParameter("acceleration_sigma", 1.5));
  trigger("actionRerun");
  QVERIFY(waitFor(
      [this] { return !shown().isPast && !shown().rerun && shown().frame == kTracked - 1; }));
  QVERIFY(shown().state == PlayState::Paused);
  QVERIFY(std::get<SphereEstimate>(shown().targets.front().estimate).mean !=
          last); // other parameters
  QCOMPARE(timeline_->model().records.size(), std::size_t{kTracked});
  // The same parameters again, from the same place: the same as before.
  window_->document().undoStack()->undo();
  QTest::mouseClick(timeline_, Qt::LeftButton, {}, timeline_->positionOf(19));
  QVERIFY(showsFrame(19));
  trigger("actionRerun");
  QVERIFY(waitFor(
      [this] { return !shown().isPast && !shown().rerun && shown().frame == kTracked - 1; }));
  QVERIFY(std::get<SphereEstimate>(shown().targets.front().estimate).mean == last);
  QTest::mouseClick(timeline_, Qt::LeftButton, {}, timeline_->positionOf(20));
  QVERIFY(showsFrame(20));
  QVERIFY(std::get<SphereEstimate>(shown().targets.front().estimate).mean == then);
}

void TimelineTest::markersAreStepsOfTheDocument() {
  QTest::mouseClick(timeline_, Qt::LeftButton, {}, timeline_->positionOf(17));
  QVERIFY(showsFrame(17));
  trigger("actionAddMark");
  auto* name = window_->findChild<QLineEdit*>(QStringLiteral("markName"));
  QVERIFY(name->isVisible());
  QTest::keyClicks(name, QStringLiteral("throw"));
  QTest::keyClick(name, Qt::Key_Return);
  QVERIFY(!name->isVisible());
  const auto& project = [this]() -> const Project& { return window_->document().project(); };
  QCOMPARE(project().markers.size(), std::size_t{1});
  QVERIFY(project().markers[0] == (ProjectMarker{17, "throw"}));
  trigger("actionNow");
  QVERIFY(showsFrame(kTracked - 1));
  trigger("actionPreviousMark");
  QVERIFY(showsFrame(17));
  window_->document().undoStack()->undo();
  QCOMPARE(project().markers[0].name, std::string("Marker 1"));
  window_->document().undoStack()->undo();
  QVERIFY(project().markers.empty());
  window_->document().undoStack()->redo();
  QCOMPARE(timeline_->model().markers.size(), std::size_t{1});
  trigger("actionRemoveMark");
  QVERIFY(project().markers.empty());
}

void TimelineTest::framesAndTimesCanBeEntered() {
  auto* edit = window_->findChild<QLineEdit*>(QStringLiteral("frameFieldEdit"));
  auto* problem = window_->findChild<QLabel*>(QStringLiteral("frameFieldProblem"));
  const auto enter = [edit](const char* text) {
    edit->selectAll();
    QTest::keyClicks(edit, QLatin1String(text));
    QTest::keyClick(edit, Qt::Key_Return);
  };
  QVERIFY(showsFrame(kTracked - 1));
  QVERIFY(!edit->isVisible());
  trigger("actionGoToFrame");
  QVERIFY(edit->isVisible() && edit->hasFocus());
  QCOMPARE(edit->text(), QString::number(kTracked)); // people count from 1
  enter("13");
  QVERIFY(!edit->isVisible());
  QVERIFY(showsFrame(12));
  // The frame number in the status bar opens the field as well.
  QTest::mouseClick(window_->findChild<QLabel*>(QStringLiteral("statusFrame")), Qt::LeftButton);
  QVERIFY(edit->isVisible());
  enter("1.0 s"); // the demo has 30 frames per second
  QVERIFY(showsFrame(30));
  trigger("actionGoToFrame");
  for (const char* wrong : {"0", "-3", "99999", "999 s", "nowhere"}) {
    enter(wrong);
    QVERIFY2(edit->isVisible() && problem->isVisible(), wrong);
    QVERIFY2(problem->text().contains(QStringLiteral(" 1 ")), qPrintable(problem->text()));
    QVERIFY(window_->rect().contains(
        QRect(problem->mapTo(window_.get(), QPoint(0, 0)), problem->size())));
  }
  QTest::keyClick(edit, Qt::Key_1);
  QVERIFY(!problem->isVisible()); // the user is mending it
  QTest::keyClick(edit, Qt::Key_Escape);
  QVERIFY(!edit->isVisible());
  QVERIFY(timeline_->hasFocus());
  QVERIFY(showsFrame(30)); // nothing has changed
}

void TimelineTest::troubleIsFoundInBothDirections() {
  const auto& records = timeline_->model().records;
  QVERIFY(showsFrame(kTracked - 1));
  // Whatever the demo does in its first frames: the actions go where the search says.
  std::vector<qint64> begins;
  for (auto at = nextTrouble(records, -1, 1); at; at = nextTrouble(records, *at, 1)) {
    begins.push_back(*at);
  }
  for (auto at = begins.rbegin(); at != begins.rend(); ++at) {
    if (*at < kTracked - 1) {
      trigger("actionPreviousTrouble");
      QVERIFY(showsFrame(*at));
    }
  }
  const qint64 first = window_->selection().currentFrame();
  trigger("actionPreviousTrouble"); // there is none: a message says so
  QVERIFY(messageText().contains(QStringLiteral("Before this frame")));
  QVERIFY(showsFrame(first));
  for (const qint64 frame : begins) {
    if (frame > first) {
      trigger("actionNextTrouble");
      QVERIFY(showsFrame(frame));
    }
  }
  const qint64 last = window_->selection().currentFrame();
  trigger("actionNextTrouble");
  QVERIFY(messageText().contains(QStringLiteral("After this frame")));
  QVERIFY(showsFrame(last));
}

void TimelineTest::rangesAreSelectedAndZoomedTo() {
  QSignalSpy ranges(&window_->selection(), &Selection::selectedRangeChanged);
  const int axis = 5;
  const QPoint begin(timeline_->positionOf(5).x(), axis);
  const QPoint end(timeline_->positionOf(25).x(), axis);
  QTest::mousePress(timeline_, Qt::LeftButton, {}, begin);
  QTest::mouseMove(timeline_, end);
  QTest::mouseRelease(timeline_, Qt::LeftButton, {}, end);
  QVERIFY(ranges.count() > 0);
  QVERIFY(window_->selection().selectedRange() == (SelectedRange{5, 25}));
  const int before = timeline_->positionOf(25).x() - timeline_->positionOf(5).x();
  trigger("actionZoomToSpan");
  QVERIFY(timeline_->positionOf(25).x() - timeline_->positionOf(5).x() > before);
}

void TimelineTest::titleSaysWhy() {
  // Until the ball of the demo is found, or where it is seen: reasons and words agree.
  QVERIFY(showsFrame(kTracked - 1));
  const auto& target = shown().targets.front();
  for (std::size_t k = 0; k < target.cameraReports.size(); ++k) {
    const auto* reason =
        window_->findChild<QLabel*>(QStringLiteral("cameraDock%1TitleReason").arg(k));
    QVERIFY(reason != nullptr);
    QCOMPARE(reason->text().isEmpty(), target.cameraReports[k].status == CameraStatus::None);
  }
}

DEWPOINT_WINDOW_TEST(TimelineTest)

} // namespace dewpoint::tests

#include "timeline_test.moc"
