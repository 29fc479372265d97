// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/session/take/take_recorder.h"

#include "core/base/text_file.h"
#include "core/capture/image_shape.h"
#include "core/project/project_save.h"
#include "core/session/take/take_folder.h"
#include "core/trajectory/trajectory_writer.h"

#include <fmt/chrono.h>
#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include <algorithm>
#include <cctype>
#include <condition_variable>
#include <ctime>
#include <set>
#include <utility>

namespace dewpoint::session {

namespace fs = std::filesystem;
using namespace std::chrono_literals;

namespace {

constexpr auto kWatchInterval = 100ms;
/// Images after which the first one is surely in the file, not only in the table.
constexpr std::int64_t kEnoughImages = 2;

/// A file name of a camera's name, without its ending, that is not in `used` yet.
std::string fileNameOf(const std::string& camera, std::set<std::string>& used) {
  std::string name;
  for (const char letter : camera) {
    const auto byte = static_cast<unsigned char>(letter);
    const bool isPlain = byte >= 0x80 || std::isalnum(byte) != 0 || letter == '_' || letter == '-';
    name += isPlain ? letter : '-';
  }
  name = name.empty() ? "camera" : name;
  std::string unique = name;
  for (int k = 2; !used.insert(unique).second; ++k) {
    unique = fmt::format("{}-{}", name, k);
  }
  return unique;
}

/// The project of the recordings of a live project.
Project recordedProject(Project project, const fs::path& folder, int number) {
  std::set<std::string> used;
  for (ProjectCamera& camera : project.cameras) {
    const std::string name = fileNameOf(camera.camera.name, used);
    camera.source = SourceKind::Video;
    camera.location = (folder / (name + ".mkv")).string();
    camera.captureTimeFile = (folder / (name + ".csv")).string();
  }
  project.name = fmt::format("{}{}take {}", project.name, project.name.empty() ? "" : ", ", number);
  project.framesPerSecond = 0.0; // that of the times
  project.truthFile.reset();
  project.markers.clear(); // they belong to frames of another recording
  project.personCorrections.clear();
  project.corrections.clear();
  return project;
}

} // namespace

TakeRecorder::TakeRecorder(Project project, fs::path folder, int number, TakeOptions options)
    : project_(recordedProject(std::move(project), folder, number)), folder_(std::move(folder)),
      number_(number), options_(std::move(options)),
      date_(fmt::format("{:%Y-%m-%dT%H:%M:%S%z}", fmt::localtime(std::time(nullptr)))),
      named_(project_.cameras.size()) {}

Result<std::unique_ptr<TakeRecorder>> TakeRecorder::start(const Project& project,
                                                          const std::vector<EncodedFeedPtr>& feeds,
                                                          const fs::path& parent,
                                                          const TakeOptions& options) {
  if (project.cameras.empty() || !std::ranges::all_of(project.cameras, &ProjectCamera::isLive)) {
    return failure(ErrorCode::Mismatch, project.file.string(), "camera",
                   "only live cameras can be recorded (device or stream)");
  }
  auto folder = makeTakeFolder(parent, options.number);
  if (!folder) {
    return tl::make_unexpected(folder.error());
  }
  std::unique_ptr<TakeRecorder> take(
      new TakeRecorder(project, folder->path, folder->takeNumber, options));
  const Clock::time_point zero = take->keepPreRoll(feeds);
  if (auto written = take->writeNotes(false); !written) {
    return tl::make_unexpected(written.error());
  }
  for (std::size_t k = 0; k < take->project_.cameras.size() && k < feeds.size(); ++k) {
    const ProjectCamera& camera = take->project_.cameras[k];
    take->recordings_.push_back(std::make_unique<StreamRecording>(
        feeds[k], StreamFiles{camera.location, camera.captureTimeFile}, options.rawStorage, zero,
        quotedCameraName(camera.camera.name), take->begin_));
  }
  take->watch_ =
      std::jthread([take = take.get()](const std::stop_token& stop) { take->watch(stop); });
  return take;
}

void TakeRecorder::setPreRoll(const std::vector<EncodedFeedPtr>& feeds, double seconds) {
  for (const EncodedFeedPtr& feed : feeds) {
    feed->setPreRoll({std::chrono::duration<double>(seconds), kPreRollBytes / feeds.size()});
  }
}

TakeRecorder::Clock::time_point
TakeRecorder::keepPreRoll(const std::vector<EncodedFeedPtr>& feeds) {
  Clock::time_point zero = begin_;
  for (const EncodedFeedPtr& feed : feeds) {
    zero = std::min(zero, feed->preRollBegin().value_or(begin_));
    preRolls_.push_back(feed->preRoll());
  }
  preRoll_ = std::chrono::duration<double>(begin_ - zero).count();
  return zero;
}

TakeRecorder::~TakeRecorder() {
  stop();
}

void TakeRecorder::watch(const std::stop_token& stop) {
  std::mutex mutex;
  std::condition_variable_any stopped;
  while (!stop.stop_requested()) {
    updateProject();
    std::unique_lock lock(mutex);
    stopped.wait_for(lock, stop, kWatchInterval, [] { return false; });
  }
}

void TakeRecorder::note(const Status& written) {
  std::scoped_lock lock(mutex_);
  if (!written && !problem_) {
    problem_ = written.error();
  }
}

void TakeRecorder::updateProject() {
  std::vector<bool> present(recordings_.size());
  for (std::size_t k = 0; k < recordings_.size(); ++k) {
    present[k] = recordings_[k]->counts().imageCount >= kEnoughImages;
  }
  if (present == named_) {
    return;
  }
  Project shown = project_;
  shown.cameras.clear();
  for (std::size_t k = 0; k < present.size(); ++k) {
    if (present[k]) {
      shown.cameras.push_back(project_.cameras[k]);
    }
  }
  if (shown.cameras.size() < project_.cameras.size()) {
    shown.measuredPoints.clear(); // they name cameras by number
  }
  const Status written = saveProject(shown, folder_ / "project.toml");
  note(written);
  if (written) {
    named_ = std::move(present);
  }
}

Status TakeRecorder::setNotes(const std::string& notes) {
  std::unique_lock lock(mutex_);
  options_.notes = notes;
  const bool finished = duration_.has_value();
  lock.unlock();
  return writeNotes(finished);
}

Status TakeRecorder::writeNotes(bool finished) const {
  std::scoped_lock writing(notesMutex_);
  const TakeStatus now = status();
  nlohmann::ordered_json json;
  json["version"] = DEWPOINT_VERSION;
  json["take"] = number_;
  json["project"] = project_.name;
  json["started"] = date_;
  json["notes"] = now.notes;
  json["finished"] = finished;
  json["seconds"] = now.durationSeconds;
  json["pre_roll"] = now.preRollSeconds;
  json["cameras"] = nlohmann::ordered_json::array();
  for (const TakeStatus::CameraStatus& camera : now.cameras) {
    nlohmann::ordered_json& one = json["cameras"].emplace_back();
    one["name"] = camera.name;
    one["video"] = camera.videoFile;
    one["images"] = camera.counts.imageCount;
    one["dropped"] = camera.counts.droppedImageCount;
    one["images_changed"] = camera.counts.hasChangedPixels;
    one["pre_roll_images"] = camera.counts.preRollImageCount;
    one["pre_roll_shortened"] = camera.preRoll.isShortened;
    one["bytes"] = camera.counts.byteCount;
    one["frames_per_second"] = camera.counts.framesPerSecond;
    one["time_origin"] = timeOriginName(camera.counts.origin);
    if (camera.counts.problem) {
      one["problem"] = camera.counts.problem->detail;
    }
  }
  return writeTextFile(folder_ / "take.json",
                       json.dump(2, ' ', false, nlohmann::ordered_json::error_handler_t::replace) +
                           "\n");
}

Status TakeRecorder::addLiveRun(const LiveRun& live) const {
  std::vector<std::vector<std::int64_t>> stamps;
  for (const auto& recording : recordings_) {
    stamps.push_back(recording->imageStamps());
  }
  const std::vector<StoredFrameSet> sets = locateStoredFrameSets(live.frameRecords, stamps);
  if (sets.empty() || live.trajectory.samples.empty()) {
    return {};
  }
  const fs::path folder = folder_ / kLiveFolder;
  std::error_code problem;
  fs::create_directories(folder, problem);
  if (problem) {
    return failure(ErrorCode::FileUnwritable, folder.string(), "", problem.message());
  }
  nlohmann::ordered_json settings;
  settings["other_settings"] = nlohmann::ordered_json::array();
  for (const ResultRange& range : live.framesWithOtherSettings) {
    settings["other_settings"].push_back({range.firstFrame, range.lastFrame});
  }
  return writeTrajectory(live.trajectory, folder / "trajectory.csv")
      .and_then([&] { return writeTextFile(folder / "run.json", live.report); })
      .and_then([&] { return writeTextFile(folder / "live.json", settings.dump(2) + "\n"); })
      .and_then([&] {
        return saveProject(recordedProject(live.project, folder_, number_), folder_ / kLiveProject);
      })
      .and_then([&] { return writeStoredFrameSets(sets, folder / "frames.csv"); });
}

TakeStatus TakeRecorder::status() const {
  TakeStatus status;
  status.takeNumber = number_;
  status.folder = folder_;
  status.preRollSeconds = preRoll_;
  for (std::size_t k = 0; k < recordings_.size(); ++k) {
    const ProjectCamera& camera = project_.cameras[k];
    status.cameras.push_back({camera.camera.name, fs::path(camera.location).filename().string(),
                              recordings_[k]->counts(), preRolls_[k]});
  }
  std::error_code problem;
  const fs::space_info space = fs::space(folder_, problem);
  status.freeBytes = problem ? 0 : space.available;
  std::scoped_lock lock(mutex_);
  status.durationSeconds =
      duration_.value_or(std::chrono::duration<double>(Clock::now() - begin_).count());
  status.problem = problem_;
  status.notes = options_.notes;
  return status;
}

Status TakeRecorder::stop() {
  {
    std::scoped_lock lock(mutex_);
    if (duration_) {
      return {};
    }
    duration_ = std::chrono::duration<double>(Clock::now() - begin_).count();
  }
  watch_ = {}; // joins
  {
    std::vector<std::jthread> stopping; // each may take most of a second
    for (const auto& recording : recordings_) {
      stopping.emplace_back([&recording] { recording->stop(); });
    }
  }
  updateProject();
  note(writeNotes(true));
  const TakeStatus now = status();
  for (const TakeStatus::CameraStatus& camera : now.cameras) {
    if (camera.counts.problem && camera.counts.problem->code == ErrorCode::FileUnwritable) {
      return tl::make_unexpected(*camera.counts.problem);
    }
  }
  return now.problem ? Status(tl::make_unexpected(*now.problem)) : Status();
}

} // namespace dewpoint::session
