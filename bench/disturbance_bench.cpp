// SPDX-License-Identifier: GPL-3.0-or-later
//
// Random events at four cameras of a fake desk, in the window: how long its event loop stalls,
// whether any image came from another camera, whether the target was tracked whenever two cameras
// showed it, and what memory and handles do. Needs a display (xvfb-run will do).
//
//     disturbance_bench [EVENTS [LOG [SEED]]]
#include "app/wiring/quiet_libraries.h"
#include "core/session/session.h"
#include "tests/integration/disturbed_cameras.h"
#include "tests/integration/kept_track.h"
#include "tests/integration/process_usage.h"
#include "ui/mainwindow/main_window.h"
#include "ui/session/session_controller.h"
#include "ui/view3d/birds_eye_view.h"

#include <QApplication>
#include <QElapsedTimer>
#include <QTimer>
#include <fmt/format.h>

#include <algorithm>
#include <cstdlib>
#include <fstream>
#include <functional>
#include <memory>
#include <string>
#include <utility>

namespace dewpoint::bench {
namespace {

using namespace dewpoint::tests;

constexpr int kBetweenMs = 100;
constexpr int kMostStallMs = 200;
constexpr int kReportEvery = 100; ///< events
constexpr int kSteadySets = 5;
constexpr double kErrorBound = 0.03; ///< meters
constexpr std::size_t kHistoryBytes = std::size_t{64} << 20;
constexpr int kSettleMs = 2000; ///< until the window is complete
constexpr int kCalmMs = 20000;  ///< without events, for comparison

void pass(int milliseconds) {
  QElapsedTimer clock;
  clock.start();
  while (clock.elapsed() < milliseconds) {
    QApplication::processEvents(QEventLoop::WaitForMoreEvents | QEventLoop::AllEvents, 5);
  }
}

void waitForAll(const SetRecord& record) {
  while (record.completeSets() < 3) {
    pass(10);
  }
}

/// Measures how long the event loop lets a timer wait, and which part of it is the fault of other
/// programs: the time in which the thread could have run, but had no processor (Linux).
class StallProbe {
public:
  struct Stall {
    double milliseconds = 0.0;
    double own = 0.0; ///< without waiting for a processor
  };

  StallProbe() {
    timer_.setTimerType(Qt::PreciseTimer);
    QObject::connect(&timer_, &QTimer::timeout, [this] { tick(); });
    clock_.start();
    waited_ = waitedForProcessor();
    timer_.start(kIntervalMs);
  }

  /// The longest stall since the last call, and the longest one without waiting.
  Stall takeLongest() { return std::exchange(longest_, {}); }

private:
  static constexpr int kIntervalMs = 5;

  static double waitedForProcessor() {
    double ran = 0.0;
    double waited = 0.0; // nanoseconds, of the main thread
    std::ifstream("/proc/self/schedstat") >> ran >> waited;
    return 1e-6 * waited;
  }

  void tick() {
    const double gap = 1e-6 * static_cast<double>(clock_.nsecsElapsed()) - kIntervalMs;
    clock_.restart();
    const double waited = waitedForProcessor();
    longest_.milliseconds = std::max(longest_.milliseconds, gap);
    longest_.own = std::max(longest_.own, gap - (waited - waited_));
    waited_ = waited;
  }

  QTimer timer_;
  QElapsedTimer clock_;
  double waited_ = 0.0;
  Stall longest_;
};

/// Runs the trial, and keeps its log.
class Trial {
public:
  Trial(int events, std::uint64_t seed, const std::string& log)
      : events_(events), cameras_(seed), log_(log) {
    note(fmt::format("seed {}, {} events", seed, events));
  }

  /// Returns whether all went well; stalls, which depend on the computer, are only reported.
  bool run() {
    MainWindow window([this](const SessionRequest&) { return inputs(); });
    window.resize(1600, 1000);
    window.show();
    window.openProject("disturbed");
    waitForAll(*record_);
    pass(kSettleMs);
    report();
    const ProcessUsage before = processUsage();
    StallProbe probe;
    pass(kCalmMs);
    const StallProbe::Stall calm = probe.takeLongest();
    note(fmt::format("before: longest stall {:.0f} ms, without waiting for a processor {:.0f} ms",
                     calm.milliseconds, calm.own),
         true);
    int stalls = 0;
    StallProbe::Stall longest;
    for (int event = 1; event <= events_; ++event) {
      const std::string what = cameras_.disturb();
      pass(kBetweenMs);
      const StallProbe::Stall stall = probe.takeLongest();
      stalls += stall.milliseconds > kMostStallMs ? 1 : 0;
      longest.milliseconds = std::max(longest.milliseconds, stall.milliseconds);
      longest.own = std::max(longest.own, stall.own);
      note(fmt::format("{:4} {} (stall {:.0f} ms, own {:.0f} ms)", event, what, stall.milliseconds,
                       stall.own));
      if (event % kReportEvery == 0) {
        report();
        probe.takeLongest();
      }
    }
    cameras_.mend();
    waitForAll(*record_);
    report();
    const ProcessUsage after = processUsage();
    note(fmt::format("longest stall {:.0f} ms, {} events with more than {} ms; without waiting for "
                     "a processor, the longest is {:.0f} ms",
                     longest.milliseconds, stalls, kMostStallMs, longest.own),
         true);
    return check(window) && after.handles <= before.handles;
  }

private:
  Result<SessionInputs> inputs() {
    SessionInputs inputs;
    inputs.project = cameras_.project();
    inputs.maxHistoryBytes = kHistoryBytes;
    auto source = cameras_.open();
    if (!source) {
      return tl::make_unexpected(source.error());
    }
    inputs.source = std::make_unique<WatchedSource>(std::move(*source), record_);
    return inputs;
  }

  bool check(const MainWindow& window) {
    const auto faults = record_->faults();
    for (const std::string& fault : faults) {
      note(fault, true);
    }
    const Session* session = window.findChild<SessionController*>()->session();
    const KeptTrack kept = keptTrack(
        record_->sets(), session->trajectory(),
        [this](std::int64_t tick) { return cameras_.truth(tick); }, kSteadySets, kErrorBound);
    for (const std::string& lost : kept.lost) {
      note(lost, true);
    }
    note(fmt::format("{} frame sets, {} wrong images; two cameras showed the target in {} frames, "
                     "of which {} were lost; largest error {:.1f} mm",
                     record_->sets().size(), faults.size(), kept.due, kept.lost.size(),
                     1000.0 * kept.largestError),
         true);
    return faults.empty() && kept.lost.empty();
  }

  void report() {
    const ProcessUsage usage = processUsage();
    note(fmt::format("     {} MB, {} handles, {} threads, {} connections", usage.bytes >> 20,
                     usage.handles, usage.threads, cameras_.connections()),
         true);
  }

  void note(const std::string& line, bool isShown = false) {
    log_ << line << std::endl; // complete even if the program is killed
    if (isShown) {
      fmt::print("{}\n", line);
      std::fflush(stdout);
    }
  }

  int events_;
  DisturbedCameras cameras_;
  std::shared_ptr<SetRecord> record_ =
      std::make_shared<SetRecord>(FakeDesk::kWidth, FakeDesk::kHeight);
  std::ofstream log_;
};

} // namespace
} // namespace dewpoint::bench

int main(int argc, char** argv) {
  dewpoint::app::silenceLibraries();
  dewpoint::ui::BirdsEyeView::prepareSurfaceFormat();
  QApplication application(argc, argv);
  QApplication::setOrganizationName(QStringLiteral("dewpoint-bench"));
  const int events = argc > 1 ? std::atoi(argv[1]) : 1000;
  const std::string log = argc > 2 ? argv[2] : "disturbance-events.txt";
  const std::uint64_t seed = argc > 3 ? std::strtoull(argv[3], nullptr, 10) : 1;
  return dewpoint::bench::Trial(events, seed, log).run() ? 0 : 1;
}
