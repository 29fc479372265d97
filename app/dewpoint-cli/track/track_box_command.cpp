// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/dewpoint-cli/commands.h"
#include "app/dewpoint-cli/common/exit_code.h"
#include "app/dewpoint-cli/common/frame_range.h"
#include "app/dewpoint-cli/common/interruption.h"
#include "app/dewpoint-cli/common/parameter_settings.h"
#include "app/dewpoint-cli/common/progress.h"
#include "app/dewpoint-cli/project/sample_argument.h"
#include "core/base/random.h"
#include "core/capture/frame_writer.h"
#include "core/capture/recording.h"
#include "core/session/run/box_track_file.h"
#include "core/setup/new_project.h"
#include "core/tracking/boxes/box_filter.h"
#include "core/tracking/catalog/method_catalog.h"
#include "core/tracking/tracker_capabilities.h"

#include <CLI/CLI.hpp>
#include <fmt/format.h>
#include <opencv2/imgproc.hpp>

#include <algorithm>
#include <chrono>
#include <memory>
#include <optional>
#include <span>

namespace dewpoint::app {
namespace {

struct TrackBoxOptions {
  std::string source;
  std::vector<std::string> boxes;
  std::vector<std::string> clicks;
  std::string method;
  std::vector<std::string> settings;
  std::string frames;
  std::uint64_t seed = 1;
  int threads = 1;
  double rate = 0.0;
  bool draw = false;
  std::filesystem::path folder;
};

/// What the options say, read before any file is opened.
struct BoxRequest {
  std::vector<ColorSample> marks; ///< boxes, then clicks
  ParameterValues parameters;
  FrameRange frames;
};

Result<BoxRequest> requestOf(const TrackBoxOptions& options) {
  BoxRequest request;
  request.parameters = ParameterValues(methodParameters(options.method));
  if (const auto set = applySettings(options.settings, request.parameters); !set) {
    return tl::make_unexpected(set.error());
  }
  const auto frames = parseFrames(options.frames);
  if (!frames) {
    return tl::make_unexpected(frames.error());
  }
  request.frames = *frames;
  for (const bool isBox : {true, false}) {
    for (const std::string& text : isBox ? options.boxes : options.clicks) {
      auto mark = isBox ? boxFrom(text, "--box") : clickFrom(text, "--click");
      if (!mark) {
        return tl::make_unexpected(mark.error());
      }
      request.marks.push_back(std::move(*mark));
    }
  }
  if (request.marks.empty()) {
    return failure(ErrorCode::MissingKey, "", "--box", "a box or a click says what to follow");
  }
  return request;
}

Result<std::unique_ptr<FrameSetSource>> openImages(const TrackBoxOptions& options) {
  RecordedCamera camera;
  camera.name = "camera 1";
  camera.path = options.source;
  switch (guessedSource(options.source)) {
  case SourceKind::Video:
    break;
  case SourceKind::Images:
    camera.kind = RecordedCamera::Kind::Images;
    break;
  default:
    return failure(ErrorCode::BadValue, options.source, "SOURCE",
                   "a video or a folder of images is expected");
  }
  return openRecording({camera}, options.rate);
}

cv::Scalar colorOf(std::size_t target) {
  static const std::vector<cv::Scalar> kColors{
      {60, 220, 60}, {255, 160, 40}, {60, 120, 255}, {230, 80, 230}, {40, 220, 230}};
  return kColors[target % kColors.size()];
}

/// Follows boxes through the images of one source, in a loop of its own: a click becomes a box only
/// in the first image, and a box beyond it is an error. A TrackingRun takes boxes that are known
/// before, and passes over those it cannot follow.
class BoxRun {
public:
  explicit BoxRun(const TrackBoxOptions& options) : options_(options), team_(options.threads) {}

  Status run(const BoxRequest& request, FrameSetSource& source);
  const BoxTrack& track() const { return track_; }
  double millisecondsPerFrame() const {
    const double boxes = tracker_ ? double(tracker_->trackCount()) : 0.0;
    return 1e3 * seconds_ * boxes / std::max<double>(1.0, double(track_.samples.size()));
  }

private:
  Status begin(const BoxRequest& request, const FrameSetPtr& frames);
  Status take(const BoxRequest& request, const FrameSetPtr& frames);
  Status draw(const Frame& frame, std::span<const BoxSample> samples);

  const TrackBoxOptions& options_;
  ThreadTeam team_;
  std::unique_ptr<Tracker> tracker_; ///< null before the first frame
  BoxTrack track_;
  std::optional<FrameWriter> drawing_;
  double rate_ = 30.0;
  double seconds_ = 0.0;
};

Status BoxRun::begin(const BoxRequest& request, const FrameSetPtr& frames) {
  const Frame& first = *frames->frames.front();
  track_.header = {{"version", DEWPOINT_VERSION},
                   {"source", options_.source},
                   {"method", options_.method},
                   {"seed", std::to_string(options_.seed)}};
  for (const auto& declaration : request.parameters.declarations()) {
    track_.header.emplace_back(declaration.key,
                               fmt::format("{}", request.parameters.at(declaration.key)));
  }
  auto tracker = makeTracker(options_.method, request.parameters, CameraRig(1),
                             std::vector<Target>(request.marks.size()));
  if (!tracker) {
    return tl::make_unexpected(tracker.error());
  }
  auto* const following = capability<BoxFollowing>(**tracker);
  if (following == nullptr) {
    return failure(ErrorCode::BadValue, "", "--method", options_.method + " follows no boxes");
  }
  for (std::size_t i = 0; i < request.marks.size(); ++i) {
    const ColorSample& mark = request.marks[i];
    const auto box = mark.isBox()
                         ? Result<ImageBox>(ImageBox{mark.x, mark.y, mark.width, mark.height})
                         : boxFromClick(first.image, mark.x, mark.y);
    if (!box) {
      return tl::make_unexpected(box.error());
    }
    const auto seed = derivedSeed(options_.seed, static_cast<std::uint32_t>(i));
    const auto started = following->follow(i, first.image, {0, frames->index, *box}, seed);
    if (!started) {
      return started;
    }
    BoxEstimate given;
    given.box = *box;
    given.similarity = 1.0;
    track_.samples.push_back({seconds(first.captureTime), first.index, int(i) + 1, given});
  }
  tracker_ = std::move(*tracker);
  return {};
}

Status BoxRun::draw(const Frame& frame, std::span<const BoxSample> samples) {
  if (!drawing_) {
    auto writer = FrameWriter::video((options_.folder / "boxes.mkv").string(), rate_);
    if (!writer) {
      return tl::make_unexpected(writer.error());
    }
    drawing_ = std::move(*writer);
  }
  cv::Mat picture = frame.image.clone();
  for (const BoxSample& sample : samples) {
    const ImageBox& box = sample.estimate.box;
    const cv::Rect outline(int(std::lround(box.x)), int(std::lround(box.y)),
                           int(std::lround(box.width)), int(std::lround(box.height)));
    const auto color = colorOf(std::size_t(sample.target - 1));
    cv::rectangle(picture, outline, color, sample.estimate.visible ? 2 : 1);
    const Eigen::Vector2d center = box.center();
    cv::drawMarker(picture, {int(center.x()), int(center.y())}, color, cv::MARKER_CROSS, 9);
  }
  return drawing_->write(picture);
}

Status BoxRun::take(const BoxRequest& request, const FrameSetPtr& frames) {
  const Frame& frame = *frames->frames.front();
  const std::size_t already = track_.samples.size();
  if (!tracker_) {
    if (auto begun = begin(request, frames); !begun) {
      return begun;
    }
  } else {
    const auto start = std::chrono::steady_clock::now();
    tracker_->beginFrame(frames);
    tracker_->iterate(team_);
    for (std::size_t i = 0; i < tracker_->trackCount(); ++i) {
      track_.samples.push_back({seconds(frame.captureTime), frame.index, int(i) + 1,
                                std::get<BoxEstimate>(tracker_->estimate(i))});
    }
    seconds_ += std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
  }
  return options_.draw ? draw(frame, std::span(track_.samples).subspan(already)) : Status();
}

Status BoxRun::run(const BoxRequest& request, FrameSetSource& source) {
  rate_ = source.framesPerSecond();
  if (const auto sought = source.seek(request.frames.first); !sought) {
    return sought;
  }
  const std::int64_t total = source.frameCount().value_or(0);
  const std::int64_t end = std::min(request.frames.end.value_or(total), total);
  Progress progress("tracking", std::max<std::int64_t>(0, end - request.frames.first));
  Status status;
  for (std::int64_t k = request.frames.first; k < end && status && !interruptionRequested(); ++k) {
    const auto frames = source.next();
    if (!frames) {
      status = tl::make_unexpected(frames.error());
    } else if (!*frames) {
      break;
    } else {
      status = take(request, *frames);
    }
    progress.show(k + 1 - request.frames.first);
  }
  progress.finish();
  if (status && drawing_) {
    status = drawing_->finish();
  }
  if (status && !tracker_ && !interruptionRequested()) {
    return failure(ErrorCode::BadValue, options_.source, "--frames",
                   fmt::format("there are {} frames", total));
  }
  return status;
}

int trackBoxes(const TrackBoxOptions& options) {
  const auto request = requestOf(options);
  if (!request) {
    report(request.error());
    return kExitUsage;
  }
  auto source = openImages(options);
  if (!source) {
    return report(source.error());
  }
  std::error_code problem;
  std::filesystem::create_directories(options.folder, problem);
  if (problem) {
    return report({ErrorCode::FileUnwritable, options.folder.string(), "--out", problem.message()});
  }
  catchInterruption();
  BoxRun run(options);
  const auto tracked = run.run(*request, **source);
  if (!run.track().samples.empty()) {
    if (const auto written = writeBoxTrack(run.track(), options.folder); !written) {
      return report(written.error());
    }
  }
  if (!tracked) {
    Error error = tracked.error();
    error.file = error.file.empty() ? options.source : error.file;
    const int code = report(error);
    return code == kExitBadInput && !run.track().samples.empty() ? kExitEndedEarly : code;
  }
  const auto frames = run.track().samples.size() / std::max<std::size_t>(request->marks.size(), 1);
  fmt::print("frames                  {:>10}\nms per frame            {:>10.2f}\n", frames,
             run.millisecondsPerFrame());
  return interruptionRequested() ? kExitInterrupted : kExitDone;
}

} // namespace

void addTrackBoxCommand(CLI::App& app, int& exitCode) {
  auto* command = app.add_subcommand(
      "track-box", "Follow boxes through one camera's images, without any calibration.");
  auto options = std::make_shared<TrackBoxOptions>();
  const std::vector<std::string> known = methodNames(RunTables::Boxes); // the default first
  options->method = known.front();
  command->add_option("SOURCE", options->source, "Video, or folder of images")->required();
  command->add_option("--box", options->boxes,
                      "X,Y,WIDTH,HEIGHT of a target in the first frame; may be repeated");
  command->add_option("--click", options->clicks,
                      "X,Y on a target in the first frame: the box is found; may be repeated");
  command->add_option("--out", options->folder, "Folder to write")->required();
  command->add_option("--method", options->method, "Tracking method")
      ->check(CLI::IsMember(known))
      ->capture_default_str();
  command->add_option("--set", options->settings, "Set a parameter of the method: key=value");
  command->add_option("--seed", options->seed, "Seed of the run")->capture_default_str();
  command
      ->add_option("--threads", options->threads, "Threads of the filter; never changes the result")
      ->check(CLI::Range(1, 256))
      ->capture_default_str();
  command->add_option("--frames", options->frames,
                      "Only frames A to B-1, as A:B (either may be empty)");
  command->add_option("--rate", options->rate, "Images per second of a folder")
      ->check(CLI::Range(0.0, 10000.0));
  command->add_flag("--draw", options->draw, "Write a video with the boxes drawn, too");
  command->callback([options, &exitCode] { exitCode = trackBoxes(*options); });
}

} // namespace dewpoint::app
