// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/session/take/take_replay.h"

#include "core/base/limits.h"
#include "core/base/text_file.h"
#include "core/base/units.h"
#include "core/capture/frame_source.h"
#include "core/capture/gstreamer/stored_stream.h"
#include "core/capture/image_shape.h"
#include "core/project/project_check.h"
#include "core/project/project_load.h"
#include "core/session/run/background_images.h"
#include "core/session/run/frame_loop.h"
#include "core/session/run/tracking_run.h"
#include "core/session/take/live_run.h"
#include "core/trajectory/trajectory_reader.h"

#include <fmt/format.h>
#include <fmt/ranges.h>
#include <nlohmann/json.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <iterator>
#include <map>
#include <optional>
#include <string>
#include <utility>
#include <vector>

namespace dewpoint::session {

namespace fs = std::filesystem;

namespace {

/// The images of a take, in the frames of its live run. Images that the take does not have are
/// missing.
class StoredFrameSource final : public FrameSetSource {
public:
  /// `sets` must outlive this object.
  StoredFrameSource(const Project& project, const std::vector<StoredFrameSet>& sets) : sets_(sets) {
    for (const ProjectCamera& camera : project.cameras) {
      const Intrinsics& size = camera.camera.intrinsics;
      cameras_.push_back({{camera.camera.name, camera.rotateDegrees, size.width, size.height,
                           camera.isMirrored, camera.crop},
                          camera.location,
                          std::nullopt});
    }
  }

  std::optional<std::int64_t> frameCount() const override { return std::ssize(sets_); }
  double framesPerSecond() const override { return kDefaultFramesPerSecond; } // nobody waits
  Result<FrameSetPtr> next() override {
    if (next_ >= std::ssize(sets_)) {
      return FrameSetPtr();
    }
    return read(sets_[static_cast<std::size_t>(next_++)]);
  }
  Status seek(std::int64_t frame) override {
    next_ = frame;
    return {};
  }

  /// How many frame sets have been read.
  std::int64_t position() const { return next_; }

private:
  struct StoredCamera {
    ImageShape shape;
    std::string file;
    std::optional<StoredStream> stream; ///< opened for the first image
  };

  Result<FrameSetPtr> read(const StoredFrameSet& stored) {
    auto set = std::make_shared<FrameSet>();
    set->index = stored.index;
    set->time = stored.time;
    set->frames.resize(cameras_.size());
    for (std::size_t k = 0; k < cameras_.size(); ++k) {
      const auto& image = stored.images[k];
      if (!image || image->numberInVideo < 0) {
        continue;
      }
      auto picture = readImage(cameras_[k], image->numberInVideo);
      if (!picture) {
        return tl::make_unexpected(picture.error());
      }
      set->frames[k] = std::make_shared<const Frame>(
          Frame{image->numberInVideo, image->captureTime, std::move(*picture)});
    }
    return set;
  }

  static Result<cv::Mat> readImage(StoredCamera& camera, std::int64_t number) {
    if (!camera.stream) {
      auto opened = StoredStream::open(camera.file, quotedCameraName(camera.shape.cameraName));
      if (!opened) {
        return tl::make_unexpected(opened.error());
      }
      camera.stream.emplace(std::move(*opened));
    }
    return camera.stream->read(number).and_then(
        [&](const cv::Mat& picture) { return prepareImage(picture, camera.shape, camera.file); });
  }

  const std::vector<StoredFrameSet>& sets_;
  std::vector<StoredCamera> cameras_;
  std::int64_t next_ = 0;
};

bool isSameNumber(double a, double b) {
  return a == b || (std::isnan(a) && std::isnan(b));
}

/// Files contain the upper half of a covariance.
bool isSameEstimate(const TrajectorySample& a, const TrajectorySample& b) {
  bool same = a.isValid == b.isValid && a.cameraCount == b.cameraCount &&
              isSameNumber(a.time, b.time) &&
              isSameNumber(a.effectiveSampleSize, b.effectiveSampleSize);
  for (int row = 0; row < 3 && a.isValid; ++row) {
    same = same && isSameNumber(a.position[row], b.position[row]);
    for (int column = row; column < 3; ++column) {
      same = same && isSameNumber(a.covariance(row, column), b.covariance(row, column));
    }
  }
  return same;
}

/// Samples by frame and target.
using SamplesByFrame = std::map<std::pair<std::int64_t, std::string>, TrajectorySample>;

/// Whether the estimates of a frame are those of the live run.
bool isSameFrame(std::int64_t frame, const std::vector<TrajectorySample>& again,
                 const SamplesByFrame& live, ReplayComparison& comparison) {
  const auto count =
      std::distance(live.lower_bound({frame, ""}), live.lower_bound({frame + 1, ""}));
  bool same = count == std::ssize(again);
  for (const TrajectorySample& sample : again) {
    const auto before = live.find({frame, sample.target});
    if (before == live.end()) {
      same = false;
      continue;
    }
    same = same && isSameEstimate(before->second, sample);
    if (before->second.isValid && sample.isValid) {
      comparison.largestPositionDifference = std::max(
          comparison.largestPositionDifference, (before->second.position - sample.position).norm());
    }
  }
  return same;
}

void countComparedFrame(std::int64_t frame, bool same, ReplayComparison& comparison) {
  ++comparison.comparedFrameCount;
  if (!same) {
    ++comparison.differingFrameCount;
    comparison.firstDifferingFrame = comparison.firstDifferingFrame.value_or(frame);
  }
}

/// Compares the frames that are tracked again with those of the live run.
class ReplayComparer final : public FrameObserver {
public:
  ReplayComparer(const SamplesByFrame& live, ReplayComparison& comparison)
      : live_(live), comparison_(comparison) {}

  Status onFrameTracked(const TrackingRun& run) override {
    const std::int64_t frame = run.frames()->index;
    countComparedFrame(frame, isSameFrame(frame, run.samples(), live_, comparison_), comparison_);
    return {};
  }

private:
  const SamplesByFrame& live_;
  ReplayComparison& comparison_;
};

/// A frame number of the notes; nothing for anything else.
std::optional<std::int64_t> frameIn(const nlohmann::json& value) {
  if (!value.is_number_integer() || value.get<double>() < 0.0 ||
      value.get<double>() > static_cast<double>(limits::kMaxFrames)) {
    return std::nullopt;
  }
  return value.get<std::int64_t>();
}

/// Reads the array of a file of notes, entry by entry; `readEntry` returns whether it is one.
template <class ReadEntry>
Status readNoteArray(const fs::path& file, const char* key, const ReadEntry& readEntry) {
  const auto text = readTextFile(file);
  if (!text) {
    return tl::make_unexpected(text.error());
  }
  if (text->size() > limits::kMaxRecordBytes) {
    return failure(ErrorCode::FileUnreadable, file.string(), "",
                   fmt::format("it is larger than {} MiB", limits::kMaxRecordBytes >> 20U));
  }
  const auto json = nlohmann::json::parse(*text, nullptr, false);
  if (!json.is_object() || !json.contains(key) || !json[key].is_array()) {
    return failure(ErrorCode::NotParsed, file.string(), key, "not the JSON of a take");
  }
  for (std::size_t k = 0; k < json[key].size(); ++k) {
    if (!readEntry(json[key][k])) {
      return failure(ErrorCode::NotParsed, file.string(), fmt::format("{} {}", key, k + 1),
                     "not the JSON of a take");
    }
  }
  return {};
}

/// What a take's notes say about the live run and the stored images.
Status readNotes(const fs::path& take, ReplayComparison& comparison) {
  const auto readCamera = [&](const nlohmann::json& one) {
    if (!one.is_object()) {
      return false;
    }
    const auto changed = one.find("images_changed");
    if (changed == one.end() || *changed == false) {
      return true;
    }
    const auto name = one.find("name");
    if (*changed != true || name == one.end() || !name->is_string()) {
      return false;
    }
    comparison.changedCameras.push_back(name->get<std::string>());
    return true;
  };
  const auto readRange = [&](const nlohmann::json& one) {
    if (!one.is_array() || one.size() != 2) {
      return false;
    }
    const auto first = frameIn(one[0]);
    const auto last = frameIn(one[1]);
    if (first && last) {
      comparison.framesWithOtherSettings.push_back({*first, *last});
    }
    return first && last;
  };
  return readNoteArray(take / "take.json", "cameras", readCamera).and_then([&] {
    return readNoteArray(take / kLiveFolder / "live.json", "other_settings", readRange);
  });
}

bool hasTimeBudget(const ParameterValues& parameters) {
  constexpr const char* kKey = "time_budget";
  const auto declared = parameters.declarations();
  return std::ranges::find(declared, kKey, &ParameterDeclaration::key) != declared.end() &&
         parameters.at(kKey) > 0.0;
}

/// Counts the frames that cannot be as they were.
void countIncomplete(const std::vector<StoredFrameSet>& sets, ReplayComparison& comparison) {
  bool hasBegun = false;
  for (const StoredFrameSet& set : sets) {
    const auto isLost = [](const auto& image) { return image && image->numberInVideo < 0; };
    const auto isThere = [](const auto& image) { return image && image->numberInVideo >= 0; };
    hasBegun = hasBegun || std::ranges::any_of(set.images, isThere);
    if (!hasBegun) {
      ++comparison.frameCountBeforeTake;
      continue;
    }
    ++comparison.liveFrameCount;
    if (std::ranges::any_of(set.images, isLost)) {
      ++comparison.incompleteFrameCount;
      comparison.firstIncompleteFrame = comparison.firstIncompleteFrame.value_or(set.index);
    }
  }
}

Status replaySets(const Project& project, const std::vector<StoredFrameSet>& sets,
                  const SamplesByFrame& live, int threads, const ReplayProgress& progress,
                  ReplayComparison& comparison) {
  auto background = loadBackgroundImages(project);
  if (!background) {
    return tl::make_unexpected(background.error());
  }
  auto run = TrackingRun::create(project, threads, std::move(*background));
  if (!run) {
    return tl::make_unexpected(run.error());
  }
  StoredFrameSource source(project, sets);
  ReplayComparer comparer(live, comparison);
  const std::array<FrameObserver*, 1> observers{&comparer};
  bool isCanceled = false;
  const auto shouldContinue = [&] {
    while (comparison.comparedFrameCount < source.position()) { // no images, so it was not tracked
      const auto next = static_cast<std::size_t>(comparison.comparedFrameCount);
      countComparedFrame(sets[next].index, false, comparison);
    }
    isCanceled = source.position() < std::ssize(sets) &&
                 !progress(comparison.comparedFrameCount, comparison.liveFrameCount);
    return !isCanceled;
  };
  const Status tracked = trackFrames(source, {}, *run, observers, shouldContinue);
  return isCanceled ? failure(ErrorCode::Canceled, "", "", "") : tracked;
}

} // namespace

bool hasLiveRun(const fs::path& take) {
  std::error_code problem;
  return fs::exists(take / kLiveFolder / "frames.csv", problem);
}

Result<ReplayComparison> compareReplay(const fs::path& take, int threads,
                                       const ReplayProgress& progress) {
  const fs::path folder = take / kLiveFolder;
  if (!hasLiveRun(take)) {
    return failure(ErrorCode::NotFound, take.string(), "live results",
                   "nothing was tracked while this take was recorded");
  }
  ReplayComparison comparison;
  if (const Status read = readNotes(take, comparison); !read) {
    return tl::make_unexpected(read.error());
  }
  const auto project = loadProject(take / kLiveProject);
  if (!project) {
    return tl::make_unexpected(project.error());
  }
  if (const Status checked = checkMethodTargets(*project); !checked) {
    return tl::make_unexpected(checked.error());
  }
  const auto sets = readStoredFrameSets(folder / "frames.csv", project->cameras.size());
  if (!sets) {
    return tl::make_unexpected(sets.error());
  }
  const auto trajectory = readTrajectory(folder / "trajectory.csv");
  if (!trajectory) {
    return tl::make_unexpected(trajectory.error());
  }
  SamplesByFrame live;
  for (const TrajectorySample& sample : trajectory->samples) {
    live[{sample.frame, sample.target}] = sample;
  }
  comparison.hasTimeBudget = hasTimeBudget(project->parameters);
  countIncomplete(*sets, comparison);
  if (comparison.frameCountBeforeTake == 0) {
    if (const Status tracked = replaySets(*project, *sets, live, threads, progress, comparison);
        !tracked) {
      return tl::make_unexpected(tracked.error());
    }
  }
  return comparison;
}

std::vector<std::string> describeReplay(const ReplayComparison& found) {
  std::vector<std::string> lines;
  if (found.frameCountBeforeTake > 0) {
    lines.push_back(fmt::format("The run began {} frames before the take, so it cannot be tracked "
                                "again from its beginning.",
                                found.frameCountBeforeTake));
  } else if (found.isBitIdentical()) {
    lines.push_back(fmt::format("Same in all {} frames, to the last bit.", found.liveFrameCount));
  } else if (found.differingFrameCount > 0) {
    lines.push_back(fmt::format("{} of {} frames differ, the first one is frame {}; positions "
                                "differ by up to {:.3g} mm.",
                                found.differingFrameCount, found.liveFrameCount,
                                *found.firstDifferingFrame + 1,
                                inMillimeters(found.largestPositionDifference)));
  } else {
    lines.emplace_back("No frame was tracked.");
  }
  if (found.incompleteFrameCount > 0) {
    lines.push_back(fmt::format("Images of {} frames are not in the take, the first of frame {}.",
                                found.incompleteFrameCount, *found.firstIncompleteFrame + 1));
  }
  for (const ResultRange& range : found.framesWithOtherSettings) {
    lines.push_back(fmt::format("Frames {} to {} were tracked with other settings.",
                                range.firstFrame + 1, range.lastFrame + 1));
  }
  if (found.hasTimeBudget) {
    lines.emplace_back("A time budget is set: results depend on the speed of the computer.");
  }
  if (!found.changedCameras.empty()) {
    lines.push_back(fmt::format("The images of {} are stored with slightly other colors, because "
                                "the camera sends them uncompressed.",
                                fmt::join(found.changedCameras, ", ")));
  }
  return lines;
}

} // namespace dewpoint::session
