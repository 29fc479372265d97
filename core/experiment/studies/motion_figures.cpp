// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/experiment/studies/motion_figures.h"

#include "core/base/units.h"
#include "core/experiment/report/figure_page.h"
#include "core/experiment/report/figure_parts.h"
#include "core/experiment/report/seed_blocks.h"
#include "core/experiment/scenarios/people/people_scenario.h"
#include "core/experiment/studies/people_pictures.h"
#include "core/session/run/frame_loop.h"
#include "core/session/run/tracking_run.h"
#include "core/simulation/room/view_cache.h"
#include "core/tracking/catalog/method_catalog.h"
#include "core/tracking/tracker_capabilities.h"

#include <fmt/format.h>
#include <opencv2/imgproc.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <map>
#include <memory>
#include <optional>
#include <utility>

namespace dewpoint::experiment {
namespace {

constexpr const char* kMethod = "mohedano-ms"; ///< its masks are also those of mohedano-msc
/// The frames of figure 3, as the paper spaces its own (50, 52, 58 and 61), around the instant at
/// which the two people are nearest to each other.
constexpr std::array<std::int64_t, 4> kOffsets{-8, -6, 0, 3};

/// What camera 1 shows at one frame.
struct MotionFrame {
  cv::Mat mask;   ///< CV_8UC1
  int people = 0; ///< in view
  MaskQuality quality;
  cv::Mat image;     ///< CV_8UC3; of the pictured frame only
  LikelihoodMap map; ///< log D; of the pictured frame only
};

Result<TrackingRun> runOn(const OfficeScene& scene, std::uint64_t seed) {
  RunDefinition definition;
  definition.method = kMethod;
  definition.parameters = ParameterValues(methodParameters(kMethod));
  definition.rig = std::make_shared<const CameraRig>(scene.cameras);
  definition.seed = seed;
  return TrackingRun::create(std::make_shared<const RunDefinition>(std::move(definition)), 1);
}

/// How many people an image shows, of the numbers of the people at its pixels (0: nobody).
int peopleInView(const cv::Mat& people) {
  double most = 0.0;
  cv::minMaxLoc(people, nullptr, &most);
  int count = 0;
  for (int person = 1; person <= static_cast<int>(most); ++person) {
    count += cv::countNonZero(people == person) > 0 ? 1 : 0;
  }
  return count;
}

/// The images of camera 1, the only one of the scene, and the people in them.
class OfficeFrames final : public FrameSetSource {
public:
  explicit OfficeFrames(const OfficeRenderer& renderer) : renderer_(renderer) {}

  std::optional<std::int64_t> frameCount() const override { return renderer_.scene().frameCount; }
  double framesPerSecond() const override { return renderer_.scene().framesPerSecond; }
  Result<FrameSetPtr> next() override {
    const std::int64_t frame = next_++;
    FrameSet set{frame, timeStamp(renderer_.scene().timeOf(frame)), {}};
    people_ = cv::Mat();
    cv::Mat image = renderer_.render(0, frame, &people_);
    set.frames.push_back(std::make_shared<const Frame>(Frame{frame, set.time, std::move(image)}));
    return std::make_shared<const FrameSet>(std::move(set));
  }
  Status seek(std::int64_t frame) override {
    next_ = frame;
    return {};
  }

  /// The number of the person at each pixel of the last image (0: nobody).
  const cv::Mat& people() const { return people_; }

private:
  const OfficeRenderer& renderer_;
  std::int64_t next_ = 0;
  cv::Mat people_;
};

/// Keeps every frame from which on there are masks; with its image and D that of `pictured`.
class MotionMaskObserver final : public FrameObserver {
public:
  MotionMaskObserver(const OfficeFrames& source, std::int64_t pictured,
                     const ExperimentOptions& options)
      : source_(source), pictured_(pictured), options_(options) {}

  Status onFrameTracked(const TrackingRun& run) override {
    const std::int64_t frame = run.frames()->index;
    if (!reportProgress(options_, double(frame + 1) / double(*source_.frameCount()))) {
      return stoppedExperimentError();
    }
    const cv::Mat mask = run.capability<PeopleFinding>()->foregroundMask(0);
    if (mask.empty()) {
      return {}; // still learning
    }
    MotionFrame& shown = frames_[frame];
    shown.mask = mask.clone();
    shown.people = peopleInView(source_.people());
    shown.quality = measureMaskQuality(mask, source_.people());
    if (frame == pictured_) {
      shown.image = run.frames()->frames[0]->image;
      shown.map = run.capability<MotionMapping>()->motionLikelihoodMaps().front();
    }
    return {};
  }

  std::map<std::int64_t, MotionFrame> takeFrames() { return std::move(frames_); }

private:
  const OfficeFrames& source_;
  std::int64_t pictured_;
  const ExperimentOptions& options_;
  std::map<std::int64_t, MotionFrame> frames_;
};

/// Every frame of the scene from which on there are masks; with its image and D that of `pictured`.
Result<std::map<std::int64_t, MotionFrame>> motionFrames(const OfficeRenderer& renderer,
                                                         std::int64_t pictured,
                                                         const ExperimentOptions& options) {
  auto run = runOn(renderer.scene(), options.firstSeed);
  if (!run) {
    return tl::make_unexpected(run.error());
  }
  OfficeFrames source(renderer);
  MotionMaskObserver observer(source, pictured, options);
  const std::array<FrameObserver*, 1> observers{&observer};
  if (const auto tracked = trackFrames(source, {}, *run, observers, [] { return true; });
      !tracked) {
    return tl::make_unexpected(tracked.error());
  }
  return observer.takeFrames();
}

cv::Mat inColor(const cv::Mat& gray) {
  cv::Mat color;
  cv::cvtColor(gray, color, cv::COLOR_GRAY2BGR);
  return color;
}

/// D in gray as the paper prints it: black is 0, white is 1.
cv::Mat grayLikelihood(const LikelihoodMap& map) {
  cv::Mat likelihood;
  cv::exp(map.logLikelihood, likelihood);
  cv::Mat gray;
  likelihood.convertTo(gray, CV_8UC1, 255.0);
  return inColor(gray);
}

cv::Mat besideEachOther(const std::vector<cv::Mat>& images) {
  std::vector<cv::Mat> padded;
  for (const cv::Mat& image : images) {
    cv::copyMakeBorder(image, padded.emplace_back(), 0, 0, 0, 8, cv::BORDER_CONSTANT,
                       cv::Scalar::all(255));
  }
  cv::Mat all;
  cv::hconcat(padded, all);
  return all;
}

/// One number of every frame as a curve over time; frames without anybody in view are gaps.
std::vector<double> valuesOverTime(const std::map<std::int64_t, MotionFrame>& frames,
                                   double (*number)(const MotionFrame&)) {
  std::vector<double> values;
  values.reserve(frames.size());
  for (const auto& [frame, shown] : frames) {
    values.push_back(shown.people == 0 ? std::numeric_limits<double>::quiet_NaN() : number(shown));
  }
  return values;
}

/// Mean of the numbers that are there; 0 when none is.
double meanOfPresent(const std::vector<double>& values) {
  double sum = 0.0;
  int count = 0;
  for (const double value : values) {
    if (!std::isnan(value)) {
      sum += value;
      ++count;
    }
  }
  return sum / std::max(1, count);
}

/// The numbers of all frames, as curves and as a file.
struct MaskNumbers {
  std::vector<double> times; ///< seconds
  std::vector<double> regions;
  std::vector<double> people;
  std::vector<double> recalls;
  std::vector<double> precisions;
};

MaskNumbers maskNumbersOf(const OfficeScene& scene,
                          const std::map<std::int64_t, MotionFrame>& frames) {
  MaskNumbers numbers;
  for (const auto& [frame, shown] : frames) {
    numbers.times.push_back(scene.timeOf(frame));
  }
  numbers.regions = valuesOverTime(
      frames, [](const MotionFrame& shown) { return double(shown.quality.regionCount); });
  numbers.people =
      valuesOverTime(frames, [](const MotionFrame& shown) { return double(shown.people); });
  numbers.recalls =
      valuesOverTime(frames, [](const MotionFrame& shown) { return shown.quality.recall; });
  numbers.precisions =
      valuesOverTime(frames, [](const MotionFrame& shown) { return shown.quality.precision; });
  return numbers;
}

Plot numberPlot(const MaskNumbers& numbers, const std::string& what, double high,
                const std::vector<std::pair<std::string, const std::vector<double>*>>& curves) {
  Plot plot;
  plot.title = what;
  plot.x = {"time, s", numbers.times.front(), numbers.times.back(), false};
  plot.y = {what, 0.0, high, false};
  for (const auto& [style, values] : curves) {
    SvgSeries& series = plot.series.emplace_back();
    series.style = style;
    for (std::size_t k = 0; k < values->size(); ++k) {
      series.points.push_back({numbers.times[k], (*values)[k]});
    }
  }
  return plot;
}

void showNumbers(const MaskNumbers& numbers, FigurePage& page) {
  double most = 4.0;
  for (const double regions : numbers.regions) {
    most = std::isnan(regions) ? most : std::max(most, regions);
  }
  page.addPlots({{"Regions of at least 20 pixels in camera 1's mask",
                  numberPlot(numbers, "regions", 1.1 * most,
                             {{"m0", &numbers.regions}, {"m1", &numbers.people}})}},
                {{"m0", "regions of the mask"}, {"m1", "people in view"}});
  page.addPlots(
      {{"The mask against the pixels of the people",
        numberPlot(numbers, "share", 1.0,
                   {{"m0", &numbers.recalls}, {"m1", &numbers.precisions}})}},
      {{"m0", "of the people's pixels in the mask"}, {"m1", "of the mask's pixels on people"}});
  // Without the frames in which nobody is in view: a file has no gaps.
  std::vector<std::vector<double>> columns(5);
  for (std::size_t k = 0; k < numbers.times.size(); ++k) {
    if (std::isnan(numbers.regions[k])) {
      continue;
    }
    columns[0].push_back(numbers.times[k]);
    columns[1].push_back(numbers.regions[k]);
    columns[2].push_back(numbers.people[k]);
    columns[3].push_back(numbers.recalls[k]);
    columns[4].push_back(numbers.precisions[k]);
  }
  page.addDataFile("masks.csv",
                   numbersAsCsv({"time_s", "regions", "people", "recall", "precision"}, columns));
}

void assessMasks(const MotionFrame& nearest, const MaskNumbers& numbers, FigurePage& page) {
  double least = 0.0;
  cv::minMaxLoc(nearest.map.logLikelihood, &least);
  page.addHeading("What the paper says");
  page.addClaim(
      "The motion likelihood image has a grayish background: nowhere is it below p_B = 0.2.",
      std::abs(std::exp(least) - 0.2) < 1e-4,
      fmt::format("Here its least value is {:.3f}.", std::exp(least)));
  const double regions = meanOfPresent(numbers.regions);
  const double people = meanOfPresent(numbers.people);
  page.addClaim("The regions of the masks are fragmented.", regions > people,
                fmt::format("Here {:.1f} regions for {:.1f} people in the mean over all frames.",
                            regions, people));
  const double recall = meanOfPresent(numbers.recalls);
  const double precision = meanOfPresent(numbers.precisions);
  page.addClaim(
      "The regions of the masks are inaccurate.", recall < 0.95 || precision < 0.95,
      fmt::format("Here the mask has {:.0f} % of the people's pixels, and {:.0f} % of the "
                  "mask's pixels are people's.",
                  inPercent(recall), inPercent(precision)));
}

} // namespace

MaskQuality measureMaskQuality(const cv::Mat& mask, const cv::Mat& people) {
  MaskQuality quality;
  cv::Mat labels;
  cv::Mat statistics;
  cv::Mat centers;
  const int count = cv::connectedComponentsWithStats(mask, labels, statistics, centers, 8);
  for (int label = 1; label < count; ++label) { // 0 is the background
    quality.regionCount += statistics.at<int>(label, cv::CC_STAT_AREA) >= kMinRegionArea ? 1 : 0;
  }
  const cv::Mat isPerson = people != 0;
  const int both = cv::countNonZero(isPerson & mask);
  const int persons = cv::countNonZero(isPerson);
  const int moving = cv::countNonZero(mask);
  quality.recall = persons > 0 ? double(both) / persons : 1.0;
  quality.precision = moving > 0 ? double(both) / moving : 1.0;
  return quality;
}

Status writeMohedanoMotionFigures(const ExperimentOptions& options) {
  const auto scenario = makePeopleScenario("crossing", PeopleClothes::Different, options.firstSeed);
  if (!scenario) {
    return tl::make_unexpected(scenario.error());
  }
  const std::vector<PeopleInstant> instants = chooseInstantsToShow(*scenario);
  const std::int64_t nearest = instants.at(instants.size() / 2).frame; // before, nearest, after
  OfficeScene scene = scenario->scene;
  scene.cameras.resize(1); // the masks of a camera do not depend on the others
  simulation::ViewCache views;
  const auto frames = motionFrames(OfficeRenderer(scene, views), nearest, options);
  if (!frames) {
    return tl::make_unexpected(frames.error());
  }
  const auto middle = frames->find(nearest);
  if (middle == frames->end()) {
    return failure(ErrorCode::EndedEarly, "", "scenario", "the method still learns when they meet");
  }
  FigurePage page("Motion masks and motion likelihood (figures 1 and 3)",
                  "Two people cross in the simulated office, in different clothes; camera 1, "
                  "method mohedano-ms with its defaults: MOG2 of OpenCV, sigma 4 pixels, p_B "
                  "0.2.");
  page.addParagraph("Seeds " + describeSeeds(options.firstSeed, 1) + ".");
  const MotionFrame& shown = middle->second;
  page.addJpegImage(
      "figure-1",
      fmt::format("Figure 1, frame {}: the image, its motion mask, and the motion likelihood "
                  "image D",
                  middle->first),
      besideEachOther({shown.image, inColor(shown.mask), grayLikelihood(shown.map)}));
  std::vector<cv::Mat> masks;
  std::string names;
  for (const std::int64_t offset : kOffsets) {
    if (const auto found = frames->find(nearest + offset); found != frames->end()) {
      masks.push_back(inColor(found->second.mask));
      names += fmt::format("{}{}", names.empty() ? "" : ", ", found->first);
    }
  }
  if (!masks.empty()) {
    page.addJpegImage("figure-3", fmt::format("Figure 3: motion masks of frames {}", names),
                      besideEachOther(masks));
  }
  const MaskNumbers numbers = maskNumbersOf(scene, *frames);
  showNumbers(numbers, page);
  assessMasks(shown, numbers, page);
  return page.write(options.outputFolder);
}

} // namespace dewpoint::experiment
