// SPDX-License-Identifier: GPL-3.0-or-later
// A target that is learned on a later frame of a recording: the frames before it are offered.
#include "core/geometry/projector.h"
#include "core/project/project.h"
#include "core/session/snapshot/snapshot.h"
#include "tests/ui/recorded_demo.h"
#include "tests/ui/window_fixture.h"
#include "tests/ui/window_test.h"
#include "ui/cameraview/camera_view.h"
#include "ui/cameraview/image_pick_overlay.h"
#include "ui/document/document.h"
#include "ui/selection/selection.h"
#include "ui/timeline/timeline.h"

#include <QPushButton>

#include <algorithm>

namespace dewpoint::tests {

namespace {

constexpr qint64 kLearnedAt = 4; ///< of the eight frames that are recorded

} // namespace

class LateStartTest : public QObject, private test::WindowFixture {
  Q_OBJECT

private Q_SLOTS:
  void initTestCase() { QVERIFY(recordDesk(folder_.path().toStdString())); }
  void init();
  void cleanup() { window_.reset(); }
  void theFirstFramesAreOfferedAndTracked();
  void theOfferGoesWithItsTarget();
  void onTheFirstFrameNothingIsOffered();

private:
  /// Clicks the ball in the first camera, on this frame, and waits until it is a target.
  void learnAt(qint64 frame);
  /// The frames with a result for one target.
  std::vector<qint64> trackedFrames() const {
    std::vector<qint64> frames;
    for (const FrameRecord& record : find<Timeline>("timeline")->model().records) {
      if (record.targets.size() == 1) {
        frames.push_back(record.frame);
      }
    }
    return frames;
  }
  bool isOffered() const {
    return messageText().contains(QStringLiteral("The frames before it are not tracked."));
  }
};

void LateStartTest::init() {
  makeWindow();
  open(path("desk.toml"));
}

void LateStartTest::learnAt(qint64 frame) {
  window_->selection().requestFrame(frame);
  QVERIFY(waitFor([&] { return shown().frame == frame && !shown().isPreview; }));
  auto* view = find<CameraView>("cameraView0");
  QVERIFY(draws(*view));
  // Where the ball of the demo begins; in eight frames it goes less than its radius.
  const auto at = Projector(demoRig()[0]).project({0.5, 0.5, 0.15});
  QVERIFY(at);
  QTest::mouseClick(find<ImagePickOverlay>("cameraView0Pick"), Qt::LeftButton, Qt::NoModifier,
                    view->placement().positionOf({at->x(), at->y()}).toPoint());
  QVERIFY(waitFor([this] { return window_->document().project().targets.size() == 1; }));
  QVERIFY(waitFor([this] { return shown().state == PlayState::Ended; }));
}

void LateStartTest::theFirstFramesAreOfferedAndTracked() {
  learnAt(kLearnedAt);
  QVERIFY(waitFor([this] { return isOffered(); }));
  QVERIFY(messageText().contains(QStringLiteral("frame 5,"))); // people count from 1
  QCOMPARE(trackedFrames().front(), kLearnedAt);
  auto* answer = find<QPushButton>("messageAnswer0");
  QCOMPARE(answer->text(), QStringLiteral("Track from the first frame"));
  QVERIFY(window_->findChild<QPushButton*>(QStringLiteral("messageAnswer1")) == nullptr);
  answer->click();
  QVERIFY(waitFor([this] { return trackedFrames().size() == 8; }));
  QCOMPARE(trackedFrames().front(), qint64{0});
  QVERIFY(!isOffered());
}

void LateStartTest::theOfferGoesWithItsTarget() {
  learnAt(kLearnedAt);
  QVERIFY(waitFor([this] { return isOffered(); }));
  action("actionUndo")->trigger();
  QVERIFY(window_->document().project().targets.empty());
  QVERIFY(!isOffered());
}

void LateStartTest::onTheFirstFrameNothingIsOffered() {
  learnAt(0);
  QCOMPARE(trackedFrames().front(), qint64{0});
  QVERIFY(!isOffered());
}

DEWPOINT_WINDOW_TEST(LateStartTest)

} // namespace dewpoint::tests

#include "late_start_test.moc"
