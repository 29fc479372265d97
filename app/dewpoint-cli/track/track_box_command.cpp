// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/dewpoint-cli/commands.h"
#include "app/dewpoint-cli/common/exit_code.h"
#include "app/dewpoint-cli/common/frame_range.h"
#include "app/dewpoint-cli/common/interruption.h"
#include "app/dewpoint-cli/common/parameter_settings.h"
#include "app/dewpoint-cli/common/progress.h"
#include "app/dewpoint-cli/project/sample_argument.h"
#include "core/base/units.h"
#include "core/capture/frame_writer.h"
#include "core/capture/recording.h"
#include "core/capture/redacted_location.h"
#include "core/session/run/box_track_file.h"
#include "core/session/run/frame_loop.h"
#include "core/session/run/tracking_run.h"
#include "core/setup/new_project/new_project.h"
#include "core/tracking/boxes/box_filter.h"
#include "core/tracking/catalog/method_catalog.h"

#include <CLI/CLI.hpp>
#include <fmt/format.h>
#include <opencv2/imgproc.hpp>

#include <algorithm>
#include <array>
#include <chrono>
#include <cmath>
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
      auto mark = isBox ? parseBox(text, "--box") : parseClick(text, "--click");
      if (!mark) {
        return tl::make_unexpected(mark.error());
      }
      request.marks.push_back(std::move(*mark));
    }
  }
  if (request.marks.empty()) {
    return failure(ErrorCode::MissingKey, "", "--box", "mark what to track with --box or --click");
  }
  return request;
}

Result<std::unique_ptr<FrameSetSource>> openImages(const TrackBoxOptions& options) {
  RecordedCamera camera;
  camera.name = "camera 1";
  camera.path = options.source;
  switch (guessSourceKind(options.source)) {
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

/// One target for each mark: a click is on something in the first image, around which a box is
/// found. BadValue for a mark on which nothing can be followed.
Result<std::vector<Target>> targetsOf(const BoxRequest& request, const FrameSet& first) {
  const cv::Mat& image = first.frames.front()->image;
  std::vector<Target> targets;
  for (const ColorSample& mark : request.marks) {
    const auto box = mark.isBox()
                         ? Result<ImageBox>(ImageBox{mark.x, mark.y, mark.width, mark.height})
                         : boxFromClick(image, mark.x, mark.y);
    if (!box) {
      return tl::make_unexpected(box.error());
    }
    if (const auto checked = checkBox(image, *box); !checked) {
      return tl::make_unexpected(checked.error());
    }
    Target& target = targets.emplace_back();
    target.name = fmt::format("target {}", targets.size());
    target.box = TargetBox{0, first.index, *box};
  }
  return targets;
}

/// A run of one camera, about which nothing is known.
Result<TrackingRun> runOf(const TrackBoxOptions& options, const ParameterValues& parameters,
                          std::vector<Target> targets) {
  RunDefinition definition;
  definition.method = options.method;
  definition.parameters = parameters;
  definition.targets = std::move(targets);
  definition.rig = std::make_shared<const CameraRig>(1);
  definition.backgroundImageFiles.resize(1);
  definition.seed = options.seed;
  return TrackingRun::create(std::make_shared<const RunDefinition>(std::move(definition)),
                             options.threads);
}

/// Keeps the boxes of every frame, and draws them into a video.
class BoxObserver final : public FrameObserver {
public:
  /// `rate`: frames per second of the video; `frameCount` 0: unknown.
  BoxObserver(const TrackBoxOptions& options, double rate, std::int64_t frameCount)
      : options_(options), rate_(rate), progress_("tracking", frameCount) {}

  void begin(const ParameterValues& parameters);
  void onFrameTaken(const FrameSet& /*frames*/) override { taken_ = Clock::now(); }
  void onIteration(const TrackingRun& run, double microseconds) override;
  Status onFrameTracked(const TrackingRun& run) override;
  /// After the last frame; completes the video unless the frames have ended in an error.
  Status finish(const Status& frames);

  const BoxTrack& track() const { return track_; }
  std::int64_t frames() const { return frames_; }
  /// Without the first frame, in which boxes are only taken as they were given.
  double millisecondsPerFrame() const {
    return inMilliseconds(seconds_) / std::max(1.0, static_cast<double>(frames_));
  }

private:
  using Clock = std::chrono::steady_clock;

  Status draw(const Frame& frame, std::span<const BoxSample> samples);

  const TrackBoxOptions& options_;
  double rate_;
  Progress progress_;
  BoxTrack track_;
  std::optional<FrameWriter> drawing_;
  Clock::time_point taken_;
  double seconds_ = 0.0;
  std::int64_t frames_ = 0;
};

void BoxObserver::begin(const ParameterValues& parameters) {
  track_.header = {{"version", DEWPOINT_VERSION},
                   {"source", redactedLocation(options_.source)},
                   {"method", options_.method},
                   {"seed", std::to_string(options_.seed)}};
  for (const auto& declaration : parameters.declarations()) {
    track_.header.emplace_back(declaration.key, fmt::format("{}", parameters.at(declaration.key)));
  }
}

void BoxObserver::onIteration(const TrackingRun& /*run*/, double /*microseconds*/) {
  if (frames_ > 0) {
    seconds_ += std::chrono::duration<double>(Clock::now() - taken_).count();
  }
}

Status BoxObserver::onFrameTracked(const TrackingRun& run) {
  std::vector<BoxSample> samples = run.boxSamples();
  if (frames_ == 0) { // the boxes as they were given: no particle was weighted
    for (BoxSample& sample : samples) {
      BoxEstimate given;
      given.box = sample.estimate.box;
      given.similarity = 1.0;
      sample.estimate = given;
    }
  }
  track_.samples.insert(track_.samples.end(), samples.begin(), samples.end());
  progress_.show(++frames_);
  return options_.draw ? draw(*run.frames()->frames.front(), samples) : Status();
}

Status BoxObserver::finish(const Status& frames) {
  progress_.finish();
  return frames && drawing_ ? drawing_->finish() : frames;
}

Status BoxObserver::draw(const Frame& frame, std::span<const BoxSample> samples) {
  if (!drawing_) {
    auto writer = FrameWriter::createVideo((options_.folder / "boxes.mkv").string(), rate_);
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
    cv::rectangle(picture, outline, color, sample.estimate.isVisible ? 2 : 1);
    const Eigen::Vector2d center = box.center();
    cv::drawMarker(picture, {int(center.x()), int(center.y())}, color, cv::MARKER_CROSS, 9);
  }
  return drawing_->write(picture);
}

/// Follows the boxes of a request through the frames of a source. `observer` has what was followed
/// until an error.
Status followBoxes(const TrackBoxOptions& options, const BoxRequest& request,
                   FrameSetSource& source, BoxObserver& observer) {
  if (const auto sought = source.seek(request.frames.first); !sought) {
    return sought;
  }
  const bool any = request.frames.countIn(source).value_or(0) > 0;
  const auto first = any ? source.next() : Result<FrameSetPtr>();
  if (!first) {
    return tl::make_unexpected(first.error());
  }
  if (!*first) {
    return failure(ErrorCode::BadValue, options.source, "--frames",
                   fmt::format("there are {} frames", source.frameCount().value_or(0)));
  }
  auto targets = targetsOf(request, **first);
  if (!targets) {
    return tl::make_unexpected(targets.error());
  }
  auto run = runOf(options, request.parameters, std::move(*targets));
  if (!run) {
    return tl::make_unexpected(run.error());
  }
  observer.begin(request.parameters);
  const std::array<FrameObserver*, 1> observers{&observer};
  const FrameRange others{request.frames.first + 1, request.frames.end};
  return observer.finish(trackOneFrame(*run, *first, observers).and_then([&] {
    return trackFrames(source, others, *run, observers, [] { return !wasInterruptionRequested(); });
  }));
}

int trackBoxes(const TrackBoxOptions& options) {
  const auto request = requestOf(options);
  if (!request) {
    reportError(request.error());
    return kExitUsage;
  }
  auto source = openImages(options);
  if (!source) {
    return reportError(source.error());
  }
  std::error_code problem;
  std::filesystem::create_directories(options.folder, problem);
  if (problem) {
    return reportError(
        {ErrorCode::FileUnwritable, options.folder.string(), "--out", problem.message()});
  }
  catchInterruption();
  BoxObserver observer(options, (*source)->framesPerSecond(),
                       request->frames.countIn(**source).value_or(0));
  const auto tracked = followBoxes(options, *request, **source, observer);
  if (observer.frames() > 0) {
    if (const auto written = writeBoxTrack(observer.track(), options.folder); !written) {
      return reportError(written.error());
    }
  }
  if (!tracked) {
    Error error = tracked.error();
    error.file = error.file.empty() ? options.source : error.file;
    const int code = reportError(error);
    return code == kExitBadInput && observer.frames() > 0 ? kExitEndedEarly : code;
  }
  fmt::print("frames                  {:>10}\nms per frame            {:>10.2f}\n",
             observer.frames(), observer.millisecondsPerFrame());
  return wasInterruptionRequested() ? kExitInterrupted : kExitDone;
}

} // namespace

void addTrackBoxCommand(CLI::App& app, int& exitCode) {
  auto* command = app.add_subcommand(
      "track-box", "Track image targets (boxes) in the images of one camera, without calibration.");
  auto options = std::make_shared<TrackBoxOptions>();
  const std::vector<std::string> known = methodNames(RunTableKind::Boxes); // the default first
  options->method = known.front();
  command->add_option("SOURCE", options->source, "Video, or folder of images")->required();
  command->add_option("--box", options->boxes,
                      "X,Y,WIDTH,HEIGHT of a target in the first frame; may be repeated");
  command->add_option(
      "--click", options->clicks,
      "X,Y of a click on a target in the first frame, to find its box; may be repeated");
  command->add_option("--out", options->folder, "Folder to write")->required();
  command->add_option("--method", options->method, "Tracking method")
      ->check(CLI::IsMember(known))
      ->capture_default_str();
  command->add_option("--set", options->settings, "Set a parameter of the method: key=value");
  command->add_option("--seed", options->seed, "Seed of the run")->capture_default_str();
  command
      ->add_option("--threads", options->threads,
                   "Number of threads of the filter; does not change the result")
      ->check(CLI::Range(1, 256))
      ->capture_default_str();
  command->add_option("--frames", options->frames,
                      "Only frames A to B-1, as A:B (either may be empty)");
  command->add_option("--rate", options->rate, "Images per second, if SOURCE is a folder of images")
      ->check(CLI::Range(0.0, 10000.0));
  command->add_flag("--draw", options->draw, "Also write a video with the boxes drawn into it");
  command->callback([options, &exitCode] { exitCode = trackBoxes(*options); });
}

} // namespace dewpoint::app
