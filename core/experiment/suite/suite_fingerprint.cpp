// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/experiment/suite/suite_fingerprint.h"

#include "core/experiment/report/fingerprint.h"
#include "core/experiment/report/seed_blocks.h"
#include "core/experiment/scenarios/catalog/catalog.h"
#include "core/experiment/suite/suite_runner.h"

#include <algorithm>
#include <array>
#include <cstdint>
#include <limits>
#include <utility>

namespace dewpoint::experiment {
namespace {

constexpr double kErrorStepMm = 0.01;
constexpr int kNeesDigits = 3;
constexpr double kProbabilityStep = 0.001;

/// The first frames of a run with the first tuning seed.
struct FixedRun {
  const char* scenario;
  const char* grade;
  std::int64_t frames;
};

/// Together they hold a plain track, a fast one, a start in a wide box, distractors, a third
/// camera, a jump with its loss and its recovery (frame 30), a patterned ball, one on the border of
/// an image, a crowd, a color that was learned by a click, and images of each grade. A grade that
/// the suite does not have is left out.
constexpr std::array kFixedRuns{
    FixedRun{"S0-slow", "ideal", 20},         FixedRun{"S1-still-3", "ideal", 20},
    FixedRun{"S4-jump-desk", "ideal", 45},    FixedRun{"S0-fast", "room", 20},
    FixedRun{"S2-three-cameras", "room", 20}, FixedRun{"S4-desk-cloud", "room", 10},
    FixedRun{"S1-moving-3", "wild", 20},      FixedRun{"S12-two-patches", "ideal", 15},
    FixedRun{"S17-border", "room", 30},       FixedRun{"S19-crowd-5", "ideal", 15},
    FixedRun{"S22-blue", "room", 10},
};

/// The scenario's run up to its frame `frames` - 1.
ScenarioRun begunOf(ScenarioRun run, std::int64_t frames) {
  run.frameCount = std::min(run.frameCount, frames);
  std::erase_if(run.truth.samples,
                [&](const TrajectorySample& sample) { return sample.frame >= run.frameCount; });
  run.extents.clear(); // one per sample; no fingerprint depends on them
  std::erase_if(run.events,
                [&](const ScenarioEvent& event) { return event.frame >= run.frameCount; });
  return run;
}

ScenarioDeclaration shortened(const ScenarioDeclaration& whole, std::int64_t frames) {
  ScenarioDeclaration part = whole;
  part.make = [make = whole.make, frames](std::uint64_t seed, Grade grade) {
    return make(seed, grade).map([&](ScenarioRun run) { return begunOf(std::move(run), frames); });
  };
  return part;
}

void add(Fingerprint& fingerprint, const SuiteResult& result) {
  for (const auto& target : result.trace.errorsMm) {
    for (const double errorMm : target) {
      fingerprint.add(errorMm, kErrorStepMm);
    }
  }
  fingerprint.addDigits(result.row.nees.value_or(std::numeric_limits<double>::quiet_NaN()),
                        kNeesDigits);
  for (const ReliabilityCount& bin : result.trace.reliabilityCounts) {
    fingerprint.add(bin.probabilitySum, kProbabilityStep);
  }
}

} // namespace

Result<std::map<std::string, std::string>>
suiteFingerprints(const std::vector<std::string>& methods) {
  const auto selected = selectMethods(methods);
  if (!selected) {
    return tl::make_unexpected(selected.error());
  }
  std::vector<ScenarioDeclaration> scenarios;
  scenarios.reserve(kFixedRuns.size()); // jobs point to them
  std::vector<SuiteJob> jobs;
  for (const FixedRun& run : kFixedRuns) {
    const auto grade = gradeFromName(run.grade);
    if (!grade) {
      continue;
    }
    const auto declared = selectScenarios(scenarioCatalog(), {run.scenario});
    if (!declared) {
      return tl::make_unexpected(declared.error());
    }
    scenarios.push_back(shortened(*declared->front(), run.frames));
    jobs.push_back({&scenarios.back(), *grade, kFirstTuningSeed, *selected});
  }
  std::map<std::string, Fingerprint> fingerprints;
  const auto sink = [&](const SuiteResult& result) {
    add(fingerprints[result.row.key.method], result);
    return Status();
  };
  if (const auto run = runSuite(jobs, 1, sink, [] { return false; }); !run) {
    return tl::make_unexpected(run.error());
  }
  std::map<std::string, std::string> texts;
  for (const auto& [method, fingerprint] : fingerprints) {
    texts[method] = fingerprint.text();
  }
  return texts;
}

} // namespace dewpoint::experiment
