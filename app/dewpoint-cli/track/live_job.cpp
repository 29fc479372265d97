// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/dewpoint-cli/track/live_job.h"

#include "app/dewpoint-cli/common/exit_code.h"
#include "app/dewpoint-cli/common/interruption.h"
#include "app/dewpoint-cli/track/live_recorder.h"
#include "core/base/units.h"
#include "core/broadcast/broadcaster.h"
#include "core/session/session.h"
#include "core/session/snapshot/snapshot_state.h"

#include <fmt/format.h>

#include <chrono>
#include <cstdio>
#include <memory>
#include <set>
#include <string>
#include <string_view>
#include <thread>
#include <unistd.h>
#include <utility>
#include <vector>

namespace dewpoint::app {
namespace {

using LiveClock = std::chrono::steady_clock;

constexpr auto kTurn = std::chrono::milliseconds(50);
constexpr auto kStatusPeriod = std::chrono::seconds(1);
/// How long a run that reports a problem may take to begin.
constexpr auto kPatience = std::chrono::seconds(10);
/// Of images and particles for going back, which nobody does here.
constexpr std::size_t kHistoryBytes = std::size_t{32} << 20U;

/// Executes remote commands.
Status execute(const broadcast::RemoteCommand& command, Session& session, LiveRecorder* recorder) {
  using broadcast::RemoteAction;
  switch (command.action) {
  case RemoteAction::Start:
    session.play();
    return {};
  case RemoteAction::Stop:
    session.pause();
    return {};
  case RemoteAction::StartRecording:
  case RemoteAction::StopRecording:
    break;
  }
  if (recorder == nullptr) {
    return failure(ErrorCode::BadValue, "", "record", "the program was started without --out");
  }
  return command.action == RemoteAction::StartRecording ? recorder->startTake(command.name)
                                                        : recorder->stopTake();
}

/// What is shown of a run on a terminal, and said at its end.
class LiveConsole {
public:
  /// Results on standard output leave no room for anything else.
  explicit LiveConsole(bool isOutputTaken)
      : out_(isOutputTaken ? stderr : stdout), isTerminal_(::isatty(STDERR_FILENO) == 1) {}

  void showPlaces(const broadcast::Broadcaster& broadcaster) {
    for (const broadcast::OutletReport& report : broadcaster.reports()) {
      fmt::print(out_, "{}\n", broadcast::outletAddressText(report));
    }
    std::fflush(out_); // a program may wait for the port
  }

  /// Prints each notice once.
  void showNotices(const TrackSnapshot& snapshot) {
    for (const Error& notice : snapshot.notices) {
      if (std::string text = errorSentence(notice); printed_.insert(text).second) {
        clear();
        fmt::print(stderr, "dewpoint-cli: note: {}.\n", text);
      }
    }
  }

  void showStatus(const TrackSnapshot& snapshot, const broadcast::Broadcaster& broadcaster,
                  const std::string& take) {
    if (!isTerminal_) {
      return;
    }
    std::string targets;
    for (const TargetSnapshot& target : snapshot.targets) {
      targets += fmt::format("{}{} {}", targets.empty() ? "" : ", ", target.target.name,
                             broadcast::stateWord(trackingState(target)));
    }
    int clients = 0;
    std::int64_t dropped = broadcaster.droppedFrameCount();
    for (const broadcast::OutletReport& report : broadcaster.reports()) {
      clients += report.clientCount;
      dropped += report.droppedPieceCount;
    }
    const char* state = snapshot.state == PlayState::Playing ? "" : "stopped, ";
    fmt::print(stderr, "\r\x1b[K{}frame {}, {:.1f} images/s, {}; {} clients, {} sent, {} dropped{}",
               state, snapshot.frame, snapshot.framesPerSecond, targets, clients,
               broadcaster.sentFrameCount(), dropped, take.empty() ? "" : "; recording " + take);
    std::fflush(stderr);
    isShown_ = true;
  }

  void showSummary(const TrackSnapshot& snapshot, const broadcast::Broadcaster& broadcaster) {
    clear();
    fmt::print(out_, "frames                  {:>10}\n", snapshot.frame + 1);
    fmt::print(out_, "frames sent             {:>10}\n", broadcaster.sentFrameCount());
    fmt::print(out_, "images dropped          {:>10}\n", snapshot.droppedFrameCount);
    fmt::print(out_, "latency p99             {:>7.1f} ms\n", inMilliseconds(snapshot.latency.p99));
    if (snapshot.liveLatency.total.longest > 0.0) {
      fmt::print(out_, "light to estimate p99   {:>7.1f} ms\n",
                 inMilliseconds(snapshot.liveLatency.total.p99));
    }
    std::fflush(out_);
  }

private:
  /// Removes the line of the status.
  void clear() {
    if (std::exchange(isShown_, false)) {
      fmt::print(stderr, "\r\x1b[K");
    }
  }

  std::FILE* out_;
  bool isTerminal_;
  bool isShown_ = false;
  std::set<std::string> printed_;
};

} // namespace

Error LiveJob::withLocation(Error error) const {
  constexpr std::string_view kPrefix = "output.";
  const std::string key =
      error.field.starts_with(kPrefix) ? error.field.substr(kPrefix.size()) : error.field;
  if (!keysFromCommandLine.contains(key)) {
    error.file = projectFile.string();
  } else {
    error.field = key == "token" ? "--token-file" : "--" + key;
  }
  return error;
}

int LiveJob::run(SessionInputs inputs) const {
  if (folder && !inputs.truth.samples.empty()) {
    std::error_code problem;
    std::filesystem::create_directories(*folder, problem);
    if (const auto written = writeTrajectory(inputs.truth, *folder / "truth.csv"); !written) {
      return reportError(written.error());
    }
  }
  const std::optional<WorldBox> volume = inputs.project.volumeOfInterest;
  inputs.maxHistoryBytes = kHistoryBytes;
  Session session(std::move(inputs));
  std::optional<LiveRecorder> recorder;
  if (folder) {
    recorder.emplace(session, *folder);
    if (const Status begun = recorder->begin(); !begun) {
      return reportError(begun.error());
    }
  }
  LiveRecorder* const used = recorder ? &*recorder : nullptr;
  const auto receiver = [&session, used](const broadcast::RemoteCommand& command) {
    return execute(command, session, used);
  };
  auto opened = broadcast::Broadcaster::open({output, projectFile.parent_path(), volume, receiver});
  if (!opened) {
    return reportError(withLocation(opened.error()));
  }
  const std::unique_ptr<broadcast::Broadcaster> broadcaster = std::move(*opened);
  LiveConsole console(output.csvFile == "-");
  console.showPlaces(*broadcaster);

  catchInterruption();
  session.onSnapshot([&session, &broadcaster] { broadcaster->enqueue(session.newest()); });
  session.play();
  const auto begin = LiveClock::now();
  auto nextStatus = begin + kStatusPeriod;
  Status done;
  bool hasPlayed = false;
  while (!wasInterruptionRequested() && done) {
    std::this_thread::sleep_for(kTurn);
    const TrackSnapshotPtr now = session.newest();
    console.showNotices(*now);
    done = used != nullptr ? used->update() : Status();
    hasPlayed = hasPlayed || now->state == PlayState::Playing;
    const auto elapsed = LiveClock::now() - begin;
    const bool hasFailed = !hasPlayed && elapsed > kPatience && !now->notices.empty();
    if (now->state == PlayState::Ended || hasFailed ||
        (maxSeconds && elapsed >= std::chrono::duration<double>(*maxSeconds))) {
      break;
    }
    if (LiveClock::now() >= nextStatus) {
      nextStatus += kStatusPeriod;
      console.showStatus(*now, *broadcaster, used != nullptr ? used->takeName() : "");
    }
  }
  session.pause();
  session.onSnapshot({});
  if (used != nullptr) {
    const Status finished = used->finish();
    done = done ? finished : done;
  }
  const TrackSnapshotPtr last = session.newest();
  console.showNotices(*last);
  console.showSummary(*last, *broadcaster);
  if (!done) {
    return reportError(done.error());
  }
  return last->iterationCount > 0 ? kExitDone : kExitBadInput;
}

} // namespace dewpoint::app
