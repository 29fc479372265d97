// SPDX-License-Identifier: GPL-3.0-or-later
// Settings that are changed when something was tracked already: what is shown belongs to them, or
// is marked.
#include "core/project/project.h"
#include "core/session/session.h"
#include "tests/ui/window_fixture.h"
#include "tests/ui/window_test.h"
#include "ui/document/document.h"
#include "ui/selection/selection.h"
#include "ui/session/result_refresher.h"
#include "ui/session/session_controller.h"
#include "ui/timeline/timeline.h"
#include "ui/workbench/workbench.h"

#include <QPushButton>
#include <QUndoStack>

#include <algorithm>
#include <limits>
#include <string>
#include <utility>

namespace dewpoint::tests {

namespace {

constexpr qint64 kTrackedAtFirst = 30; ///< frames tracked at first
/// A parameter that moves every estimate.
constexpr const char* kSpread = "acceleration_sigma";
/// Whether the window takes tracking again for quick: not what this machine happens to be.
enum class Again { Quick, Slow };

} // namespace

class SettingsChangeTest : public QObject, private test::WindowFixture {
  Q_OBJECT
private Q_SLOTS:
  void cleanup() { window_.reset(); }
  void whatIsQuickIsTrackedAgainAtOnce();
  void whatIsSlowIsMarkedAndOffered();
  void anotherTargetIsTrackedOverAllFrames();
  void aChangeWhilePlayingHoldsFromThereOn();
  void severalChangesAreOne();

private:
  /// Tracks the first frames, and pauses.
  void trackSome(Again again = Again::Quick);
  ResultRefresher& results() { return window_->workbench().session.resultRefresher(); }
  bool areOld(const std::vector<ResultRange>& frames) {
    return waitFor([&] { return results().oldResults().frameRanges == frames; });
  }
  /// All results are of these settings: with this value of a parameter.
  bool areRenewed(const char* key, double value) {
    return waitFor([&] {
      const auto& header = window_->workbench().session.session()->trajectory().header.entries;
      const auto entry =
          std::ranges::find(header, std::string(key), &std::pair<std::string, std::string>::first);
      return entry != header.end() && std::stod(entry->second) == value &&
             results().oldResults().frameRanges.empty() &&
             results().oldResults().newestFrame == kTrackedAtFirst - 1 && !results().isRefreshing();
    });
  }
  const Eigen::Vector3d& mean() const {
    return std::get<SphereEstimate>(shown().targets.front().estimate).mean;
  }
};

void SettingsChangeTest::trackSome(Again again) {
  makeWindow({.theme = Theme::Light, .play = false});
  results().setQuickRerunLimit(again == Again::Quick ? std::numeric_limits<double>::infinity()
                                                     : 0.0);
  open();
  QVERIFY(waitFor([this] { return shown().history.newestTrackedFrame == 0; }));
  for (qint64 frame = 1; frame < kTrackedAtFirst; ++frame) {
    action("actionNextFrame")->trigger();
  }
  QVERIFY(waitFor([this] { return results().oldResults().newestFrame == kTrackedAtFirst - 1; }));
  QVERIFY(results().oldResults().frameRanges.empty());
  QVERIFY(!action("actionTrackAgain")->isEnabled());
}

void SettingsChangeTest::whatIsQuickIsTrackedAgainAtOnce() {
  trackSome();
  const double before = window_->document().project().parameters.at(kSpread);
  window_->selection().requestFrame(12);
  QVERIFY(waitFor([this] { return shown().frame == 12; }));
  const Eigen::Vector3d then = mean();
  QVERIFY(window_->document().setParameter(kSpread, 1.5));
  QVERIFY(areRenewed(kSpread, 1.5));
  QCOMPARE(shown().frame, 12); // it stays where the user looks
  QCOMPARE(shown().history.newestTrackedFrame, kTrackedAtFirst - 1);
  QVERIFY(shown().state == PlayState::Paused);
  QVERIFY(mean() != then);
  QCOMPARE(messageText(), QString());
  // Undo brings the old results back, to the bit.
  window_->document().undoStack()->undo();
  QVERIFY(areRenewed(kSpread, before));
  QCOMPARE(shown().frame, 12);
  QVERIFY(mean() == then);
}

void SettingsChangeTest::whatIsSlowIsMarkedAndOffered() {
  trackSome(Again::Slow);
  const double before = window_->document().project().parameters.at("particles");
  auto* timeline = find<Timeline>("timeline");
  QVERIFY(window_->document().setParameter("particles", before + 100.0));
  QVERIFY(areOld({{0, kTrackedAtFirst - 1}}));
  QVERIFY(timeline->model().hasOldResult(5));
  QVERIFY(waitFor([this] { return messageText().contains(QStringLiteral("earlier settings")); }));
  QVERIFY(action("actionTrackAgain")->isEnabled());
  // The old settings are back: so is the old run, and nothing is to be done.
  window_->document().undoStack()->undo();
  QVERIFY(areOld({}));
  QVERIFY(waitFor([this] { return messageText().isEmpty(); }));
  QVERIFY(!timeline->model().hasOldResult(5));
  QVERIFY(!action("actionTrackAgain")->isEnabled());
  window_->document().undoStack()->redo();
  QVERIFY(waitFor([this] { return messageText().contains(QStringLiteral("earlier settings")); }));
  find<QPushButton>("messageAnswer0")->click();
  QVERIFY(areRenewed("particles", before + 100.0));
  QCOMPARE(messageText(), QString());
  QCOMPARE(shown().frame, kTrackedAtFirst - 1);
}

void SettingsChangeTest::anotherTargetIsTrackedOverAllFrames() {
  trackSome();
  QVERIFY(window_->document().edit(QStringLiteral("Add target"), [](Project& project) {
    project.targets.push_back(project.targets.front());
    project.targets.back().name = "another";
    project.targets.back().color.hueMin += 2.0;
  }));
  window_->workbench().session.startAfterLearning(true);
  const auto areRecorded = [this](std::size_t targets) {
    return waitFor([&] {
      const auto& records = find<Timeline>("timeline")->model().records;
      return results().oldResults().frameRanges.empty() &&
             records.size() == std::size_t{kTrackedAtFirst} &&
             std::ranges::all_of(records, [&](const FrameRecord& record) {
               return record.targets.size() == targets;
             });
    });
  };
  QVERIFY(areRecorded(2));
  QVERIFY(shown().state == PlayState::Paused);
  QCOMPARE(shown().frame, kTrackedAtFirst - 1);
  window_->document().undoStack()->undo();
  QVERIFY(areRecorded(1));
  QVERIFY(shown().state == PlayState::Paused);
}

void SettingsChangeTest::aChangeWhilePlayingHoldsFromThereOn() {
  trackSome();
  action("actionPlay")->trigger();
  QVERIFY(waitFor([this] { return shown().history.newestTrackedFrame > kTrackedAtFirst + 2; }));
  const double before = window_->document().project().parameters.at("particles");
  QVERIFY(window_->document().setParameter("particles", before + 100.0));
  QVERIFY(waitFor([this] { return !results().oldResults().frameRanges.empty(); }));
  const ResultRange old = results().oldResults().frameRanges.front();
  QCOMPARE(old.firstFrame, 0);
  QVERIFY(waitFor(
      [&] { return shown().history.newestTrackedFrame > old.lastFrame + 2; })); // it goes on
  QCOMPARE(results().oldResults().frameRanges, std::vector<ResultRange>{old});
  QCOMPARE(messageText(), QString());
  action("actionPlay")->trigger();
  QVERIFY(waitFor([this] { return shown().state == PlayState::Paused; }));
  QVERIFY(waitFor([this] { return messageText().contains(QStringLiteral("earlier settings")); }));
  letTimePass(500);
  QCOMPARE(results().oldResults().frameRanges,
           std::vector<ResultRange>{old}); // nobody asked to track it again
}

void SettingsChangeTest::severalChangesAreOne() {
  trackSome();
  std::uint64_t generation = 0;
  std::size_t position = 0;
  const Session* session = window_->workbench().session.session();
  session->framesSince(generation, position);
  const std::uint64_t before = generation;
  for (int k = 0; k < 20; ++k) { // a slider is dragged
    QVERIFY(window_->document().setParameter("particles", 400.0 + k));
    QCoreApplication::processEvents();
  }
  QVERIFY(areRenewed("particles", 419.0));
  session->framesSince(generation, position);
  QCOMPARE(generation, before + 1);
}

DEWPOINT_WINDOW_TEST(SettingsChangeTest)

} // namespace dewpoint::tests

#include "settings_change_test.moc"
