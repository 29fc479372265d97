// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/experiment/suite/suite_runner.h"

#include "core/experiment/baselines/smoothed_method.h"
#include "core/experiment/suite/image_clip_run.h"
#include "core/experiment/suite/measured_part.h"
#include "core/experiment/suite/pixel_recorder.h"
#include "core/session/run/frame_loop.h"
#include "core/session/run/tracking_run.h"

#include <fmt/format.h>
#include <opencv2/core/utility.hpp>

#include <algorithm>
#include <atomic>
#include <ctime>
#include <memory>
#include <mutex>
#include <thread>
#include <tuple>
#include <utility>

namespace dewpoint::experiment {
namespace {

/// Seconds of processor time of this thread, so that neighbors do not count.
double threadSeconds() {
  timespec time{};
  clock_gettime(CLOCK_THREAD_CPUTIME_ID, &time);
  return static_cast<double>(time.tv_sec) + 1e-9 * static_cast<double>(time.tv_nsec);
}

/// One method in one run.
struct EvaluatedTracker {
  TrackingRun run;
  SuiteRecorder recorder; ///< of the measured part
  PixelRecorder pixels;
  bool smoothed = false; ///< all estimates are collected first
  std::vector<std::vector<SphereEstimate>> estimates;
  double seconds = 0.0;
};

RunDefinitionPtr definitionOf(const std::string& method, const ScenarioRun& run) {
  RunDefinition definition;
  definition.method = method;
  definition.targets = run.targets;
  definition.rig = std::make_shared<const CameraRig>(run.rig);
  definition.seed = run.seed;
  return std::make_shared<const RunDefinition>(std::move(definition));
}

/// `measured`, the measured part of the run, outlives the contestants.
Result<std::vector<EvaluatedTracker>> enter(const SuiteJob& job, const ScenarioRun& run,
                                            const ScenarioRun& measured) {
  std::vector<EvaluatedTracker> contestants;
  for (const std::string& method : job.methods) {
    const bool smoothed = method == kSmoothedMethod;
    auto tracker = makeSuiteTracker(method, run);
    if (!tracker) {
      return tl::make_unexpected(tracker.error());
    }
    contestants.push_back(
        {TrackingRun::fromTracker(std::move(*tracker), definitionOf(method, run), 1),
         SuiteRecorder(measured, method),
         PixelRecorder(run),
         smoothed,
         {},
         0.0});
  }
  return contestants;
}

void recordFrame(EvaluatedTracker& contestant, const ScenarioRun& run, std::int64_t frame,
                 const std::vector<SphereEstimate>& estimates) {
  if (isMeasured(run, frame)) {
    contestant.recorder.add(estimates);
    contestant.pixels.add(frame, estimates);
  }
}

Status advance(EvaluatedTracker& contestant, const ScenarioRun& run, std::int64_t frame,
               const FrameSetPtr& frames) {
  const double begin = threadSeconds();
  const Status tracked = trackOneFrame(contestant.run, frames, {});
  contestant.seconds += threadSeconds() - begin;
  auto estimates = spheresOf(contestant.run.estimates());
  if (contestant.smoothed) {
    contestant.estimates.push_back(std::move(estimates));
  } else {
    recordFrame(contestant, run, frame, estimates);
  }
  return tracked;
}

void finish(EvaluatedTracker& contestant, const ScenarioRun& run) {
  const double begin = threadSeconds();
  const auto all = smoothedEstimates(contestant.estimates, run.framesPerSecond);
  contestant.seconds += threadSeconds() - begin;
  for (std::size_t frame = 0; frame < all.size(); ++frame) {
    recordFrame(contestant, run, static_cast<std::int64_t>(frame), all[frame]);
  }
}

SuiteResult suiteResultOf(const EvaluatedTracker& contestant, const ScenarioRun& run,
                          const std::string& method) {
  const auto frameCount = static_cast<double>(std::max<std::int64_t>(1, run.frameCount));
  const double usPerFrame = 1e6 * contestant.seconds / frameCount;
  if (run.truth.samples.empty() && !run.markedCenters.empty()) {
    return contestant.pixels.result({run.scenario, run.grade, method, run.seed}, usPerFrame);
  }
  SuiteResult result = contestant.recorder.result(usPerFrame);
  result.row.rmsePx = contestant.pixels.rmsePx();
  if (!measuresSuccessiveFrames(run)) {
    result.row.jitterMm.reset();
  }
  return result;
}

/// The results of a job on a clip of one camera; nothing when it was stopped.
Result<std::vector<SuiteResult>> runClipJob(const SuiteJob& job,
                                            const std::function<bool()>& stop) {
  const auto clip = job.scenario->clip();
  if (!clip) {
    return tl::make_unexpected(clip.error());
  }
  const auto images = imagesOf(*clip);
  if (!images) {
    return tl::make_unexpected(images.error());
  }
  std::vector<SuiteResult> results;
  for (const std::string& method : job.methods) {
    auto result =
        followClip(*clip, *images, {job.scenario->name, job.grade, method, job.seed}, stop);
    if (!result) {
      return tl::make_unexpected(result.error());
    }
    if (!*result) {
      return std::vector<SuiteResult>();
    }
    results.push_back(std::move(**result));
  }
  return results;
}

/// The results of one job, one per method; nothing when it was stopped.
Result<std::vector<SuiteResult>> runJob(const SuiteJob& job, const std::function<bool()>& stop) {
  if (job.scenario->clip) {
    return runClipJob(job, stop);
  }
  const auto run = job.scenario->make(job.seed, job.grade);
  if (!run) {
    return tl::make_unexpected(run.error());
  }
  const ScenarioRun measured = measuredPart(*run);
  auto contestants = enter(job, *run, measured);
  if (!contestants) {
    return tl::make_unexpected(contestants.error());
  }
  for (std::int64_t frame = 0; frame < run->frameCount; ++frame) {
    if (stop()) {
      return std::vector<SuiteResult>();
    }
    const FrameSetPtr frames = run->frames(frame);
    for (EvaluatedTracker& contestant : *contestants) {
      if (const auto advanced = advance(contestant, *run, frame, frames); !advanced) {
        return tl::make_unexpected(advanced.error());
      }
    }
  }
  std::vector<SuiteResult> results;
  for (std::size_t k = 0; k < contestants->size(); ++k) {
    EvaluatedTracker& contestant = (*contestants)[k];
    if (contestant.smoothed) {
      finish(contestant, *run);
    }
    results.push_back(suiteResultOf(contestant, *run, job.methods[k]));
  }
  return results;
}

/// The run that this job cannot have, if that is what the error says.
std::optional<SkippedRun> skippedBy(const SuiteJob& job, const Error& error) {
  if (error.code != ErrorCode::Undetermined || job.scenario->isRecorded) {
    return std::nullopt;
  }
  return SkippedRun{job.scenario->name, job.grade, job.seed,
                    error.detail.empty() ? errorSentence(error) : error.detail};
}

bool isRunIn(const ScenarioDeclaration& scenario, Grade grade) {
  return scenario.isRecorded == (grade == Grade::Real);
}

bool isRunBy(const ScenarioDeclaration& scenario, const std::string& method) {
  const auto methods = scenario.clip ? imageClipMethods() : suiteMethods();
  return std::ranges::find(methods, method) != methods.end();
}

/// Position in a list, its size if it is not there.
template <class Range, class Value, class Projection>
std::size_t rank(const Range& range, const Value& value, Projection projection) {
  return static_cast<std::size_t>(std::ranges::find(range, value, projection) - range.begin());
}

} // namespace

Result<std::vector<const ScenarioDeclaration*>>
selectScenarios(std::span<const ScenarioDeclaration> catalog,
                const std::vector<std::string>& names) {
  const auto means = [](const std::string& name, const ScenarioDeclaration& scenario) {
    return scenario.name == name || scenario.family == name;
  };
  for (const std::string& name : names) {
    if (std::ranges::none_of(catalog, [&](const auto& item) { return means(name, item); })) {
      return failure(ErrorCode::NotFound, "", "--scenario", name + "; --list shows all of them");
    }
  }
  std::vector<const ScenarioDeclaration*> selected;
  for (const ScenarioDeclaration& scenario : catalog) {
    if (names.empty() ||
        std::ranges::any_of(names, [&](const auto& name) { return means(name, scenario); })) {
      selected.push_back(&scenario);
    }
  }
  return selected;
}

std::vector<std::string> allSuiteMethods() {
  std::vector<std::string> all = suiteMethods();
  std::ranges::copy_if(imageClipMethods(), std::back_inserter(all), [&](const std::string& method) {
    return std::ranges::find(all, method) == all.end();
  });
  return all;
}

Result<std::vector<std::string>> selectMethods(const std::vector<std::string>& names,
                                               const std::vector<std::string>& known) {
  for (const std::string& name : names) {
    if (std::ranges::find(known, name) == known.end()) {
      return failure(ErrorCode::NotFound, "", "--method",
                     fmt::format("{}; known are {}", name, fmt::join(known, ", ")));
    }
  }
  std::vector<std::string> selected;
  std::ranges::copy_if(known, std::back_inserter(selected), [&](const std::string& method) {
    return names.empty() || std::ranges::find(names, method) != names.end();
  });
  return selected;
}

std::vector<SuiteJob> planSuite(const SuiteRequest& request, const SuiteResults& done,
                                const SkippedRuns& skipped) {
  std::vector<SuiteJob> jobs;
  for (const ScenarioDeclaration* scenario : request.scenarios) {
    for (const Grade grade : request.grades) {
      if (!isRunIn(*scenario, grade)) {
        continue;
      }
      const int seeds = request.seedCount.value_or(scenario->seedCount);
      for (int k = 0; k < seeds; ++k) {
        SuiteJob job{scenario, grade, request.firstSeed + static_cast<std::uint64_t>(k), {}};
        std::ranges::copy_if(request.methods, std::back_inserter(job.methods),
                             [&](const std::string& method) {
                               return isRunBy(*scenario, method) &&
                                      !done.contains({scenario->name, grade, method, job.seed});
                             });
        if (!job.methods.empty() && !isSkipped(skipped, scenario->name, grade, job.seed)) {
          jobs.push_back(std::move(job));
        }
      }
    }
  }
  return jobs;
}

std::int64_t runCount(const std::vector<SuiteJob>& jobs) {
  std::int64_t count = 0;
  for (const SuiteJob& job : jobs) {
    count += static_cast<std::int64_t>(job.methods.size());
  }
  return count;
}

std::vector<RunKey> reportOrder(const SuiteResults& results,
                                std::span<const ScenarioDeclaration> catalog) {
  std::vector<RunKey> keys;
  for (const auto& [key, result] : results) {
    keys.push_back(key);
  }
  const auto methods = allSuiteMethods();
  std::ranges::stable_sort(keys, {}, [&](const RunKey& key) {
    return std::tuple(rank(catalog, key.scenario, &ScenarioDeclaration::name), key.scenario,
                      key.grade, rank(methods, key.method, std::identity{}), key.method, key.seed);
  });
  return keys;
}

Status runSuite(const std::vector<SuiteJob>& jobs, int threads, const SuiteSink& sink,
                const std::function<bool()>& stop, const SkipSink& skip) {
  // Each job has one thread, and its processor time is to be the method's alone.
  const int openCvThreads = cv::getNumThreads();
  cv::setNumThreads(1);
  std::atomic<std::size_t> next = 0;
  std::atomic<bool> failed = false;
  std::mutex mutex;
  Status status;
  const auto stopped = [&] { return failed || stop(); };
  const auto work = [&] {
    for (std::size_t k = next++; k < jobs.size() && !stopped(); k = next++) {
      const auto results = runJob(jobs[k], stopped);
      const std::lock_guard lock(mutex);
      Status taken = results ? Status() : Status(tl::make_unexpected(results.error()));
      const auto skipped = results ? std::nullopt : skippedBy(jobs[k], results.error());
      if (skip && skipped) {
        taken = skip(jobs[k], *skipped);
      }
      for (std::size_t item = 0; results && taken && item < results->size(); ++item) {
        taken = sink((*results)[item]);
      }
      if (!taken && !failed.exchange(true)) {
        status = taken;
      }
    }
  };
  {
    std::vector<std::jthread> others;
    for (int k = 1; k < threads; ++k) {
      others.emplace_back(work);
    }
    work();
  }
  cv::setNumThreads(openCvThreads);
  return status;
}

} // namespace dewpoint::experiment
