// SPDX-License-Identifier: GPL-3.0-or-later
//
// Method `people`, whole frames, beside OpenCV's MOG2 alone on the same images: four cameras at
// QVGA, two people who walk past each other in the simulated office, one thread each.
#include "bench/ratios.h"
#include "core/experiment/scenarios/people/people_scenario.h"
#include "core/tracking/catalog/method_catalog.h"
#include "core/tracking/people/people_volume.h"
#include "core/tracking/tracker_capabilities.h"

#include <benchmark/benchmark.h>
#include <opencv2/core.hpp>
#include <opencv2/core/utility.hpp>
#include <opencv2/video/background_segm.hpp>

#include <memory>
#include <vector>

namespace dewpoint::bench {
namespace {

/// All frames of a scene, rendered once.
struct Recording {
  CameraRig rig;
  std::vector<FrameSetPtr> frames;
  std::size_t first = 0; ///< from here on both people are there and known
};

const Recording& recording() {
  static const Recording made = [] {
    cv::setNumThreads(1);
    const auto scenario = *makePeopleScenario("crossing", PeopleClothes::Different, 1);
    simulation::ViewCache views;
    const OfficeRenderer renderer(scenario.scene, views);
    Recording result{scenario.scene.cameras, {}, 35};
    for (std::int64_t frame = 0; frame < scenario.scene.frameCount; ++frame) {
      FrameSet set{frame, timeStamp(scenario.scene.timeOf(frame)), {}};
      for (std::size_t k = 0; k < result.rig.size(); ++k) {
        set.frames.push_back(
            std::make_shared<const Frame>(Frame{frame, set.time, renderer.render(k, frame)}));
      }
      result.frames.push_back(std::make_shared<const FrameSet>(std::move(set)));
    }
    return result;
  }();
  return made;
}

/// Runs `step` over the frames with two people, again and again; `begin` over those before them.
template <class Begin, class Step>
void overFrames(benchmark::State& state, const Begin& begin, const Step& step) {
  const Recording& frames = recording();
  std::size_t next = frames.frames.size();
  for ([[maybe_unused]] auto _ : state) {
    if (next == frames.frames.size()) {
      state.PauseTiming();
      begin();
      for (next = 0; next < frames.first; ++next) {
        step(frames.frames[next]);
      }
      state.ResumeTiming();
    }
    step(frames.frames[next++]);
  }
}

void mog2Alone(benchmark::State& state) {
  cv::setNumThreads(1);
  std::vector<cv::Ptr<cv::BackgroundSubtractorMOG2>> models;
  cv::Mat mask;
  overFrames(
      state,
      [&] {
        models.clear();
        for (std::size_t k = 0; k < recording().rig.size(); ++k) {
          models.push_back(cv::createBackgroundSubtractorMOG2());
        }
      },
      [&](const FrameSetPtr& frames) {
        for (std::size_t k = 0; k < models.size(); ++k) {
          models[k]->apply(frames->frames[k]->image, mask);
          benchmark::DoNotOptimize(mask.data);
        }
      });
}

void wholeFrame(benchmark::State& state, const char* method, double background, bool volumes) {
  cv::setNumThreads(1);
  ParameterValues parameters(methodParameters(method));
  (void)parameters.set("background", background);
  const auto tracker = std::move(*makeTracker(method, parameters, recording().rig, {}));
  const auto* const finding = capability<PeopleFinding>(*tracker);
  ThreadTeam team(1);
  std::size_t people = 0;
  overFrames(
      state, [&] { tracker->restart(1); },
      [&](const FrameSetPtr& frames) {
        tracker->beginFrame(frames);
        tracker->iterate(team);
        people = finding->people().size();
        for (std::size_t k = 0; volumes && k < people; ++k) {
          const auto hull = bodyHull(finding->bodyOf(finding->people()[k].identity));
          benchmark::DoNotOptimize(hull.vertices.data());
        }
      });
  if (people != 2) {
    state.SkipWithError("not both people are tracked");
  }
}

} // namespace
} // namespace dewpoint::bench

int main(int argc, char** argv) {
  using namespace dewpoint::bench;
  const auto add = [](const char* name, const auto& body) {
    benchmark::RegisterBenchmark(name, body)->Unit(benchmark::kMillisecond);
  };
  add("MOG2", [](benchmark::State& state) { mog2Alone(state); });
  add("people", [](benchmark::State& state) { wholeFrame(state, "people", 0.0, false); });
  add("people+hulls", [](benchmark::State& state) { wholeFrame(state, "people", 0.0, true); });
  add("people/MOG2", [](benchmark::State& state) { wholeFrame(state, "people", 1.0, false); });
  add("mohedano-msc",
      [](benchmark::State& state) { wholeFrame(state, "mohedano-msc", 0.0, false); });
  add("mohedano-msc/MOG2",
      [](benchmark::State& state) { wholeFrame(state, "mohedano-msc", 1.0, false); });
  return runBenchmarks(argc, argv, {},
                       {{"method people, whole frame, against MOG2 alone", "MOG2", "people", 2.0},
                        {"the same with the volumes of both people", "MOG2", "people+hulls"},
                        {"the same with MOG2 as its background model", "MOG2", "people/MOG2"},
                        {"method mohedano-msc with our background", "MOG2", "mohedano-msc"},
                        {"method mohedano-msc with MOG2", "MOG2", "mohedano-msc/MOG2"}});
}
