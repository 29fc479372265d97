// SPDX-License-Identifier: GPL-3.0-or-later
// Methods that follow boxes, in the window: several targets, edges, and beginning again.
#include "core/base/text_file.h"
#include "tests/ui/color/box_window.h"
#include "tests/ui/window_test.h"
#include "ui/selection/selection.h"
#include "ui/text/tracking_state_text.h"

#include <QComboBox>
#include <QLabel>

namespace dewpoint::tests {

class BoxTargetTest : public QObject, private BoxWindow {
  Q_OBJECT

private Q_SLOTS:
  void initTestCase() { record(); }
  void init() { open(); }
  void cleanup() { close(); }
  void aBoxDraggedBeyondTheEdgeIsCutThere();
  void onlyTheFirstBoxStartsPlaying();
  void anAddedTargetThatIsUndoneLeavesNothing();
  void theBoxIsThereAfterARestart();
  void aBoxOutsideTheImageIsRefused();
};

void BoxTargetTest::aBoxDraggedBeyondTheEdgeIsCutThere() {
  openVideo(); // 320 x 240
  const QPoint far = find<CameraView>("cameraView0")->rect().bottomRight() + QPoint(40, 40);
  dragTo(placeOf({290.0, 200.0}), far);
  QVERIFY(waitFor([this] { return targetCount() == 1; }));
  ImageBox box = window_->document().project().targets[0].box->box;
  const double widgetPixel = 1.0 / find<CameraView>("cameraView0")->placement().scale;
  QVERIFY(std::abs(box.x - 290.0) <= widgetPixel && std::abs(box.y - 200.0) <= widgetPixel);
  QCOMPARE(box.x + box.width, 320.0);
  QCOMPARE(box.y + box.height, 240.0);
  // From the other corner, too.
  action("actionLearnColor")->trigger();
  dragTo(placeOf({40.0, 30.0}), QPoint(-30, -30));
  QVERIFY(waitFor([&] { return window_->document().project().targets[0].box->box != box; }));
  box = window_->document().project().targets[0].box->box;
  QCOMPARE(box.x, 0.0);
  QCOMPARE(box.y, 0.0);
  QVERIFY(std::abs(box.width - 40.0) <= widgetPixel && std::abs(box.height - 30.0) <= widgetPixel);
}

void BoxTargetTest::onlyTheFirstBoxStartsPlaying() {
  openVideo();
  clickAt(MovingPatch{}.box(0).center());
  QVERIFY(isTrackedTo(5)); // the first one
  action("actionPlay")->trigger();
  QVERIFY(waitFor([this] { return window_->shown()->state != PlayState::Playing; }));
  action("actionRestart")->trigger();
  QVERIFY(waitFor([this] { return window_->shown()->frame == 0; }));
  QVERIFY(window_->shown()->state != PlayState::Playing);
  for (const std::size_t count : {2U, 3U}) {
    action("actionAddTarget")->trigger();
    clickAt({60.0 * double(count), 40.0});
    QVERIFY(waitFor([&] { return targetCount() == count; }));
    letTimePass(); // a run that plays would track some frames
    QCOMPARE(window_->shown()->state, PlayState::Paused);
    QCOMPARE(window_->shown()->frame, std::int64_t{0});
    QCOMPARE(window_->document().project().targets.back().box->frame, std::int64_t{0});
  }
}

void BoxTargetTest::anAddedTargetThatIsUndoneLeavesNothing() {
  openVideo();
  clickAt(MovingPatch{}.box(0).center());
  QVERIFY(isTrackedTo(kFrames - 1));
  window_->selection().requestFrame(12);
  QVERIFY(waitFor([this] { return window_->shown()->frame == 12; }));
  action("actionAddTarget")->trigger();
  clickAt(MovingPatch{}.box(12).center());
  QVERIFY(waitFor([this] { return targetCount() == 2; }));
  QVERIFY(waitFor([this] {
    return !window_->shown()->rerun && window_->shown()->history.newestTrackedFrame == kFrames - 1;
  }));
  window_->selection().requestFrame(5);
  QVERIFY(waitFor([this] { return window_->shown()->frame == 5; }));
  QCOMPARE(window_->shown()->targets.size(), std::size_t{2});
  QCOMPARE(window_->shown()->targets[1].status, TargetStatus::Gone); // not lost: not there yet
  action("actionUndo")->trigger();
  QVERIFY(waitFor([this] { return window_->shown()->targets.size() == 1; }));
  QCOMPARE(window_->shown()->frame, std::int64_t{5});
  QCOMPARE(window_->selection().target(), 0); // the one that the list shows as chosen
  QVERIFY(waitFor([this] {
    return find<QLabel>("statusHeld")->text() == trackingStateText(TrackingState::Held);
  }));
  action("actionRedo")->trigger();
  QVERIFY(waitFor([this] { return targetCount() == 2 && !window_->shown()->rerun; }));
}

void BoxTargetTest::theBoxIsThereAfterARestart() {
  openVideo();
  clickAt(MovingPatch{}.box(0).center());
  QVERIFY(waitFor([this] { return window_->shown()->state == PlayState::Ended; }));
  action("actionRestart")->trigger();
  QVERIFY(waitFor([this] { return window_->shown()->frame == 0 && hasBox(); }));
  QVERIFY(window_->shown()->history.newestTrackedFrame < 0); // nothing was tracked yet
  QVERIFY(find<QLabel>("targetBox")->text().contains(QStringLiteral("Similarity")));
  auto* choice = find<QComboBox>("methodChoice");
  const int row = choice->findData(QStringLiteral("sugandi"));
  choice->setCurrentIndex(row);
  Q_EMIT choice->activated(row);
  QCOMPARE(window_->document().project().method, std::string("sugandi"));
  QVERIFY(waitFor([this] { return window_->shown()->frame == 0 && hasBox(); }));
}

void BoxTargetTest::aBoxOutsideTheImageIsRefused() {
  const auto file = path("far.toml");
  QVERIFY(writeTextFile(file, "format = 2\nname = \"far\"\nmethod = \"histogram\"\n"
                              "scene = \"occluder\"\n[[target]]\nname = \"ball\"\nbox = "
                              "{camera = 1, x = 900, y = 97, width = 46, height = 46}\n"));
  window_->openProject(file);
  QVERIFY(waitFor([this] { return messageText().contains(QStringLiteral("target 1.box")); }));
  QVERIFY(messageText().contains(QStringLiteral("far.toml")));
}

DEWPOINT_WINDOW_TEST(BoxTargetTest)

} // namespace dewpoint::tests

#include "box_targets_test.moc"
