// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/dewpoint-cli/commands.h"
#include "app/dewpoint-cli/common/exit_code.h"
#include "app/dewpoint-cli/common/interruption.h"
#include "app/dewpoint-cli/common/progress.h"
#include "app/dewpoint-cli/common/token_file.h"
#include "app/dewpoint-cli/live/take_trigger.h"
#include "app/wiring/open_project.h"
#include "core/broadcast/broadcaster.h"
#include "core/capture/gstreamer/open_live.h"
#include "core/project/project_output.h"
#include "core/session/take/take_folder.h"
#include "core/session/take/take_recorder.h"
#include "core/setup/new_project/new_project.h"

#include <CLI/CLI.hpp>
#include <fmt/format.h>

#include <algorithm>
#include <chrono>
#include <cstdint>
#include <cstdio>
#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <utility>
#include <vector>

namespace dewpoint::app {
namespace {

using namespace std::chrono_literals;
using RecordClock = std::chrono::steady_clock;

/// How long a take waits for cameras that have not sent an image yet.
constexpr auto kCameraPatience = 3s;
/// After which all streams are called ended, although their cameras could come back.
constexpr auto kEndPatience = 2s;
constexpr double kMegabyte = 1e6;
constexpr std::uint16_t kHighestPort = 65535;

struct RecordOptions {
  std::string project;
  std::string folder;
  std::optional<double> seconds;
  std::string notes;
  std::optional<int> number;
  bool lossless = false;
  bool wait = false;
  double preRoll = 0.0; ///< seconds
  std::optional<std::uint16_t> tcp;
  std::optional<std::string> listen;
  std::string tokenFile;
};

using Feeds = std::vector<EncodedFeedPtr>;

/// Prints new problems of cameras, each once while it lasts.
class NoticePrinter {
public:
  void show(const std::vector<Error>& notices) {
    std::vector<std::string> now;
    for (const Error& notice : notices) {
      now.push_back(errorSentence(notice));
      if (std::ranges::find(shown_, now.back()) == shown_.end()) {
        fmt::print(stderr, "dewpoint-cli: {}.\n", now.back());
      }
    }
    shown_ = std::move(now);
  }

private:
  std::vector<std::string> shown_;
};

/// Whether all streams have ended and none has come back.
bool allEnded(const Feeds& feeds) {
  return std::ranges::all_of(feeds, [](const auto& feed) {
    const auto since = feed->endTime();
    return since && RecordClock::now() - *since > kEndPatience;
  });
}

/// Reads images, which nobody uses, until `done`.
template <class Done>
Status watchCameras(FrameSetSource& source, NoticePrinter& notices, Done done) {
  while (!done() && !wasInterruptionRequested()) {
    if (auto next = source.next(); !next) {
      return tl::make_unexpected(next.error());
    }
    notices.show(source.notices());
  }
  return {};
}

/// Whether no camera that sends images can be recorded any more, as when the disk is full.
bool isBroken(const TakeStatus& take) {
  const auto broken = [](const TakeStatus::CameraStatus& camera) {
    return camera.counts.problem && camera.counts.problem->code == ErrorCode::FileUnwritable;
  };
  return std::ranges::any_of(take.cameras, broken) &&
         std::ranges::all_of(take.cameras, [&](const TakeStatus::CameraStatus& camera) {
           return broken(camera) || camera.counts.imageCount == 0;
         });
}

/// Prints what each camera has recorded; returns whether all of them have.
bool printTake(const TakeStatus& take) {
  bool complete = true;
  fmt::print("Take {}: {:.1f} s in {}\n", take.takeNumber, take.durationSeconds,
             take.folder.string());
  for (const TakeStatus::CameraStatus& camera : take.cameras) {
    const RecordedCounts& counts = camera.counts;
    if (counts.imageCount == 0) {
      fmt::print("{}: no images\n", camera.name);
      fmt::print(stderr, "dewpoint-cli: camera '{}' sent no images.\n", camera.name);
      complete = false;
      continue;
    }
    fmt::print("{}: {} images, {} dropped, {:.2f} per second, {:.1f} MB, times by {}\n",
               camera.name, counts.imageCount, counts.droppedImageCount, counts.framesPerSecond,
               static_cast<double>(counts.byteCount) / kMegabyte, timeOriginName(counts.origin));
  }
  return complete;
}

/// A camera that nobody has calibrated may send images of any size, and takes its guess from them.
bool isGuessed(const Project& project, std::size_t camera) {
  return hasGuessedPose(project, camera) && hasGuessedLens(project, camera);
}

std::vector<LiveCamera> camerasToRecord(const Project& project) {
  std::vector<LiveCamera> cameras = liveCamerasOf(project);
  for (std::size_t k = 0; k < cameras.size(); ++k) {
    if (isGuessed(project, k)) {
      cameras[k].width = cameras[k].height = 0;
    }
  }
  return cameras;
}

/// Waits for the first image of each camera, but not for long.
Status awaitCameras(Project& project, FrameSetSource& source, NoticePrinter& notices) {
  std::vector<bool> seen(project.cameras.size());
  const auto deadline = RecordClock::now() + kCameraPatience;
  while (!std::ranges::all_of(seen, std::identity()) && RecordClock::now() < deadline &&
         !wasInterruptionRequested()) {
    const auto set = source.next();
    if (!set) {
      return tl::make_unexpected(set.error());
    }
    notices.show(source.notices());
    for (std::size_t k = 0; *set && k < seen.size(); ++k) {
      const FramePtr& frame = (*set)->frames[k];
      if (frame && !seen[k] && isGuessed(project, k)) {
        guessCalibration(project, k, frame->image.size());
      }
      seen[k] = seen[k] || frame;
    }
  }
  return {};
}

/// The port for remote commands, if there is to be one.
Result<std::unique_ptr<broadcast::Broadcaster>>
openRemote(const RecordOptions& options, const Project& project, TakeTrigger& trigger) {
  if (!options.tcp) {
    return nullptr;
  }
  OutputSettings settings;
  settings.tcpPort = options.tcp;
  settings.listenAddress = options.listen.value_or(project.output.listenAddress);
  settings.token = project.output.token;
  if (!options.tokenFile.empty()) {
    auto token = readTokenFile(options.tokenFile);
    if (!token) {
      return tl::make_unexpected(token.error());
    }
    settings.token = std::move(*token);
  }
  if (settings.token.empty()) {
    return failure(ErrorCode::MissingKey, options.project, "output.token",
                   "--tcp needs a token, in the project or with --token-file");
  }
  const auto receive = [&trigger](const broadcast::RemoteCommand& command) {
    return trigger.receive(command);
  };
  const auto named = [&](Error error) {
    error.file = options.tokenFile.empty() ? options.project : options.tokenFile;
    return error;
  };
  if (const Status good = checkOutput(settings).map_error(named); !good) {
    return tl::make_unexpected(good.error());
  }
  return broadcast::Broadcaster::open({settings, {}, {}, receive});
}

/// Waits for the signal to start. Returns false if it cannot come any more.
Result<bool> awaitTrigger(TakeTrigger& trigger, bool isRemote, FrameSetSource& source,
                          const Feeds& feeds, NoticePrinter& notices) {
  fmt::print(stderr, "dewpoint-cli: waiting; a line on standard input{} starts the take.\n",
             isRemote ? " or the remote command record" : "");
  bool hasCome = false;
  const Status watched = watchCameras(source, notices, [&] {
    hasCome = trigger.mustStartTake();
    return hasCome || (trigger.hasInputEnded() && !isRemote) || allEnded(feeds);
  });
  return watched.map([&] { return hasCome; });
}

/// Prints how much was recorded before the start.
void printPreRoll(const TakeStatus& take, double wanted) {
  if (wanted <= 0.0) {
    return;
  }
  fmt::print("Before the start: {:.1f} s\n", take.preRollSeconds);
  for (const TakeStatus::CameraStatus& camera : take.cameras) {
    if (camera.preRoll.isShortened) {
      fmt::print(stderr,
                 "dewpoint-cli: camera '{}': only {:.1f} s before the start were kept in {:.0f} MB "
                 "of memory.\n",
                 camera.name, camera.preRoll.spanSeconds,
                 static_cast<double>(camera.preRoll.byteCount) / kMegabyte);
    }
  }
}

/// Prints the ports that are open.
void printPorts(const broadcast::Broadcaster& remote) {
  for (const broadcast::OutletReport& port : remote.reports()) {
    fmt::print("{}\n", broadcast::outletAddressText(port));
  }
  std::fflush(stdout); // a program may wait for the port
}

/// Reports why a take can start no more.
int reportNotStarted(const std::string& project, bool isInputOver) {
  return reportError(isInputOver ? Error{ErrorCode::EndedEarly, "standard input", "",
                                         "no line came to start the take"}
                                 : Error{ErrorCode::EndedEarly, project, "camera",
                                         "all streams ended before the take was started"});
}

int recordTake(const RecordOptions& options, Project project, FrameSetSource& source,
               const Feeds& feeds) {
  NoticePrinter notices;
  TakeTrigger trigger;
  const auto remote = openRemote(options, project, trigger);
  if (!remote) {
    return reportError(remote.error());
  }
  const bool isRemote = *remote != nullptr;
  if (isRemote) {
    printPorts(**remote);
  }
  if (auto waited = awaitCameras(project, source, notices); !waited) {
    return reportError(waited.error());
  }
  if (options.wait) {
    const auto started = awaitTrigger(trigger, isRemote, source, feeds, notices);
    if (!started) {
      return reportError(started.error());
    }
    if (!*started) {
      const bool isInputOver = trigger.hasInputEnded() && !isRemote;
      return wasInterruptionRequested() ? kExitInterrupted
                                        : reportNotStarted(options.project, isInputOver);
    }
  }
  auto take =
      TakeRecorder::start(project, feeds, options.folder,
                          {options.lossless ? RawStorage::Lossless : RawStorage::Jpeg,
                           options.notes.empty() ? trigger.name() : options.notes, options.number});
  if (!take) {
    return reportError(take.error());
  }
  const auto begin = RecordClock::now();
  Progress progress("recording (s)", static_cast<std::int64_t>(options.seconds.value_or(0.0)));
  auto lastLook = begin;
  const Status watched = watchCameras(source, notices, [&] {
    const double seconds = std::chrono::duration<double>(RecordClock::now() - begin).count();
    const bool isStopped = options.wait && trigger.mustStopTake();
    if (isStopped || (options.seconds && seconds >= *options.seconds) || allEnded(feeds)) {
      return true;
    }
    if (RecordClock::now() - lastLook < 200ms) {
      return false;
    }
    lastLook = RecordClock::now();
    progress.show(static_cast<std::int64_t>(seconds));
    return isBroken((*take)->status()); // nothing more can be recorded
  });
  progress.finish();
  const Status stopped = (*take)->stop();
  const bool complete = printTake((*take)->status());
  printPreRoll((*take)->status(), options.preRoll);
  if (!stopped) {
    return reportError(stopped.error());
  }
  if (!watched) {
    return reportError(watched.error());
  }
  return complete ? kExitDone : kExitEndedEarly;
}

int record(const RecordOptions& options) {
  auto project = resolveProject(options.project);
  if (!project) {
    return reportError(project.error());
  }
  if (project->cameras.empty() || !std::ranges::all_of(project->cameras, &ProjectCamera::isLive)) {
    return reportError({ErrorCode::Mismatch, options.project, "camera",
                        "only live cameras can be recorded (device or stream)"});
  }
  if (auto guessed = guessMissingCameras(*project); !guessed) {
    return reportError(guessed.error());
  }
  catchInterruption();
  Feeds feeds(project->cameras.size());
  std::ranges::generate(feeds, [] { return std::make_shared<EncodedFeed>(); });
  auto source = openLive(camerasToRecord(*project), feeds);
  if (!source) {
    return reportError(source.error());
  }
  TakeRecorder::setPreRoll(feeds, options.preRoll);
  return recordTake(options, std::move(*project), **source, feeds);
}

} // namespace

void addRecordCommand(CLI::App& app, int& exitCode) {
  auto* command = app.add_subcommand(
      "record", "Record the live cameras of a project into a folder that opens as a project.");
  auto options = std::make_shared<RecordOptions>();
  command->add_option("PROJECT", options->project, "Project file (TOML) with live cameras")
      ->required();
  command
      ->add_option("--out", options->folder,
                   "Folder for takes; each gets a folder of its own: take-001, take-002, ...")
      ->required();
  command
      ->add_option("--seconds", options->seconds,
                   "Stop after this time (default: at Ctrl+C, or when all streams have ended)")
      ->check(CLI::Range(0.1, 1e7));
  command
      ->add_option("--take", options->number,
                   "Number of the take (default: the next one after all takes in the folder)")
      ->check(CLI::Range(1, kHighestTakeNumber));
  command->add_option("--take-notes", options->notes, "Text that is saved with the take");
  auto* wait = command->add_flag("--wait", options->wait,
                                 "Start at a line on standard input, and stop at the next one");
  command
      ->add_option("--pre-roll", options->preRoll,
                   "Also record this many seconds before the start (with --wait; default: 0)")
      ->check(CLI::Range(0.0, TakeRecorder::kMaxPreRollSeconds))
      ->needs(wait);
  command
      ->add_option("--tcp", options->tcp,
                   "Also start and stop at the remote commands record and stop-recording on this "
                   "port (with --wait); 0: any free port")
      ->check(CLI::Range(std::uint16_t{0}, kHighestPort))
      ->needs(wait);
  command->add_option("--listen", options->listen,
                      "Address of this computer on which the port is opened (default: the "
                      "project's, or 127.0.0.1: only this computer)");
  command->add_option("--token-file", options->tokenFile,
                      "Token of the remote commands, in the first line of this file (default: the "
                      "project's)");
  command->add_flag("--lossless", options->lossless,
                    "Store uncompressed images unchanged, not as JPEG of quality 95");
  command->callback([options, &exitCode] { exitCode = record(*options); });
}

} // namespace dewpoint::app
