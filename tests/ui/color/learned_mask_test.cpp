// SPDX-License-Identifier: GPL-3.0-or-later
// The mask that shows what was learned: it is there at once, and goes while the run plays.
#include "core/session/snapshot/snapshot.h"
#include "tests/ui/recorded_demo.h"
#include "tests/ui/window_fixture.h"
#include "tests/ui/window_test.h"
#include "ui/cameraview/camera_view.h"
#include "ui/cameraview/image_pick_overlay.h"

#include <QAction>

#include <cstdint>

namespace dewpoint::tests {

/// More frames of the demo than are played until the mask of a learned color goes.
constexpr std::int64_t kFramesOfMask = 75;

class LearnedMaskTest : public QObject, private test::WindowFixture {
  Q_OBJECT

private Q_SLOTS:
  void init() { makeWindow(); }
  void cleanup() { window_.reset(); }
  void theMaskOfALearnedColorGoesWhileTheRunPlays();
};

void LearnedMaskTest::theMaskOfALearnedColorGoesWhileTheRunPlays() {
  openDemo();
  QVERIFY(waitFor([this] { return shown().frame >= 2; }));
  if (shown().state == PlayState::Playing) {
    action("actionPlay")->trigger();
  }
  QVERIFY(waitFor([this] { return shown().state == PlayState::Paused; }));
  auto* view = find<CameraView>("cameraView0");
  QVERIFY(draws(*view));
  const auto position = positionOf(shown().targets[0].estimate);
  QVERIFY(position);
  const auto at = Projector(demoRig()[0]).project(position->mean);
  QVERIFY(at);
  const QPointF place = view->placement().positionOf({at->x(), at->y()});
  QTest::mouseClick(find<ImagePickOverlay>("cameraView0Pick"), Qt::LeftButton, Qt::ShiftModifier,
                    place.toPoint());
  QVERIFY(waitFor([this] { return action("actionShowMask")->isChecked(); }));
  letTimePass();
  QVERIFY(action("actionShowMask")->isChecked()); // as long as nobody plays
  action("actionPlay")->trigger();
  QVERIFY(waitFor([this] { return !action("actionShowMask")->isChecked(); }));
  // A mask that was shown before stays.
  action("actionShowMask")->setChecked(true);
  const std::int64_t last = shown().frame + kFramesOfMask;
  QVERIFY(waitFor([&] { return shown().frame >= last; }));
  QVERIFY(action("actionShowMask")->isChecked());
}

DEWPOINT_WINDOW_TEST(LearnedMaskTest)

} // namespace dewpoint::tests

#include "learned_mask_test.moc"
