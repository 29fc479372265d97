// SPDX-License-Identifier: GPL-3.0-or-later
// How fast the window plays: by keys, by the button beside Play, and slowly at first.
#include "core/session/playback_pace.h"
#include "core/session/session.h"
#include "core/session/snapshot/snapshot.h"
#include "tests/ui/window_fixture.h"
#include "tests/ui/window_test.h"
#include "ui/preferences/preferences.h"
#include "ui/selection/selection.h"
#include "ui/session/session_controller.h"
#include "ui/text/language.h"

#include <QLabel>
#include <QMenu>
#include <QToolButton>

namespace dewpoint::tests {

class SpeedTest : public QObject, private test::WindowFixture {
  Q_OBJECT
private Q_SLOTS:
  void initTestCase() { useLanguage(QStringLiteral("en")); }
  void init() { makeWindow(); }
  void cleanup() { window_.reset(); }
  void keysChangeTheSpeedWithinItsLimits();
  void theMenuHasEverySpeed();
  void aSpeedHoldsForTheNextProject();
  void slowlyAtFirstIsRemembered();
  void whatIsBelievedBeforeTheFirstIterationIsShown();
  void theRateIsShownWhilePlaying();

private:
  const Pace& pace() const { return window_->findChild<SessionController*>()->pace(); }
  QString speedShown() const { return find<QToolButton>("speedButton")->text(); }
};

void SpeedTest::keysChangeTheSpeedWithinItsLimits() {
  openDemo();
  QCOMPARE(speedShown(), QStringLiteral("1 ×"));
  QTest::keyClick(window_.get(), Qt::Key_BracketRight);
  QCOMPARE(speedShown(), QStringLiteral("2 ×"));
  QTest::keyClick(window_.get(), Qt::Key_BracketLeft);
  QTest::keyClick(window_.get(), Qt::Key_BracketLeft);
  QCOMPARE(speedShown(), QStringLiteral("1/2 ×"));
  for (int i = 0; i < 10; ++i) {
    QTest::keyClick(window_.get(), Qt::Key_BracketLeft);
  }
  QCOMPARE(speedShown(), QStringLiteral("1/30 ×"));
  QVERIFY(!action("actionSlower")->isEnabled());
  QCOMPARE(pace().speedFactor, Pace::kSlowest);
  QTest::keyClick(window_.get(), Qt::Key_Backslash);
  QCOMPARE(speedShown(), QStringLiteral("1 ×"));
  QVERIFY(!action("actionNormalSpeed")->isEnabled());
}

void SpeedTest::theMenuHasEverySpeed() {
  openDemo();
  const QMenu* menu = find<QToolButton>("speedButton")->menu();
  QStringList texts;
  for (QAction* one : menu->actions()) {
    if (one->data().isValid()) {
      texts += one->text();
      one->trigger();
      QCOMPARE(pace().speedFactor, one->data().toDouble());
      QCOMPARE(speedShown(), one->text());
    }
  }
  QCOMPARE(texts.size(), 9);
  QCOMPARE(texts.last(), QStringLiteral("8 ×"));
}

void SpeedTest::aSpeedHoldsForTheNextProject() {
  openDemo();
  action("actionFaster")->trigger();
  action("actionFaster")->trigger();
  open();
  QCOMPARE(speedShown(), QStringLiteral("4 ×"));
  // At this speed ten seconds are over soon.
  QVERIFY(waitFor([this] { return shown().state == PlayState::Ended; }));
}

void SpeedTest::slowlyAtFirstIsRemembered() {
  QVERIFY(action("actionSlowStart")->isChecked());
  QVERIFY(pace().slowUntilTracking);
  action("actionSlowStart")->trigger();
  QVERIFY(!pace().slowUntilTracking);
  QVERIFY(!Preferences().isSlowUntilTracking());
  window_.reset();
  makeAnotherWindow();
  QVERIFY(!action("actionSlowStart")->isChecked());
  QVERIFY(!pace().slowUntilTracking);
}

void SpeedTest::whatIsBelievedBeforeTheFirstIterationIsShown() {
  bool seenBefore = false;
  connect(window_->findChild<SessionController*>(), &SessionController::snapshotChanged, this,
          [&](const TrackSnapshotPtr& snapshot) {
            seenBefore =
                seenBefore || (snapshot && snapshot->state == PlayState::Playing &&
                               snapshot->iterationCount == 0 && !snapshot->targets.empty() &&
                               snapshot->targets.front().particles.rows() > 0);
          });
  openDemo();
  QVERIFY(waitFor([this] { return shown().iterationCount > 3; }));
  QVERIFY(seenBefore);
}

void SpeedTest::theRateIsShownWhilePlaying() {
  window_->resize(1400, 900);
  openDemo();
  const auto* rate = find<QLabel>("statusRate");
  if (shown().state != PlayState::Playing) {
    action("actionPlay")->trigger();
  }
  QVERIFY(waitFor([&] { return rate->text().endsWith(QStringLiteral(" fps")); }));
  QVERIFY(waitFor([this] { return shown().history.newestTrackedFrame > 10; }));
  action("actionPlay")->trigger();
  QVERIFY(waitFor([&] { return rate->text().isEmpty(); }));
  // Frames that are shown again are not tracked.
  window_->selection().requestFrame(0);
  QVERIFY(waitFor([this] { return shown().isPast; }));
  bool isReplayed = false;
  bool isShown = false;
  connect(window_->findChild<SessionController*>(), &SessionController::snapshotChanged, this,
          [&](const TrackSnapshotPtr& snapshot) {
            if (snapshot && snapshot->isPast && snapshot->state == PlayState::Playing) {
              isReplayed = true;
              isShown = isShown || !rate->text().isEmpty();
            }
          });
  action("actionPlay")->trigger();
  QVERIFY(waitFor([&] { return isReplayed && !shown().isPast; }));
  window_->findChild<SessionController*>()->disconnect(this);
  QVERIFY(!isShown);
}

DEWPOINT_WINDOW_TEST(SpeedTest)

} // namespace dewpoint::tests

#include "speed_test.moc"
