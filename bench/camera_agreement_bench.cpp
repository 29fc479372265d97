// SPDX-License-Identifier: GPL-3.0-or-later
// Cameras that disagree: how soon the fault of a rig is named and how often rightly, in scenarios
// of the suite, and how often one is named where there is none. Usage:
// camera_agreement_bench faults|quiet ideal|room|wild FIRST_SEED SEEDS [SCENARIO ...], or
// camera_agreement_bench quiet real 1 1 RECORDINGS, a folder with a folder for each real recording.
#include "core/base/angle.h"
#include "core/base/random.h"
#include "core/base/statistics.h"
#include "core/calibration/manual/moved_camera_pose.h"
#include "core/camera_motion/agreement/camera_agreement.h"
#include "core/experiment/clips/clip_catalog.h"
#include "core/experiment/clips/real_scenarios.h"
#include "core/experiment/scenarios/catalog/catalog.h"

#include <fmt/format.h>

#include <algorithm>
#include <cstdlib>
#include <ctime>
#include <map>
#include <string>
#include <utility>
#include <vector>

namespace dewpoint::bench {
namespace {

constexpr double kTurned = 2.0 * kDegree;
constexpr double kLate = 0.2; // seconds

std::string textOf(const CameraDisagreement& found) {
  static const char* const kNames[] = {"swapped", "late", "rotated", "unit", "pose", "unknown"};
  std::string text = kNames[static_cast<int>(found.fault)];
  for (const std::size_t camera : found.cameras) {
    text += fmt::format(" {}", camera + 1);
  }
  if (found.fault == CameraFault::Late) {
    text += fmt::format(" by {:.0f} ms", 1e3 * found.delay);
  }
  for (const Eigen::Vector3d& turn : found.rotationCorrections) {
    text += fmt::format(" {:.2f} deg", turn.norm() / kDegree);
  }
  if (found.fault == CameraFault::Unit) {
    text += fmt::format(" {}", found.metersPerUnit);
  }
  return text + fmt::format(" (log odds {:.0f})", found.logOdds);
}

/// A rig and its images with something wrong.
struct Faulty {
  CameraFault fault = CameraFault::Unknown;
  std::size_t camera = 0;
  std::size_t other = 1;
  Eigen::Vector3d turn = Eigen::Vector3d::Zero();
  double scale = 1.0;

  CameraRig rigOf(CameraRig rig) const {
    if (fault == CameraFault::Rotated) {
      rig[camera] = rotatedCamera(rig[camera], turn);
    }
    for (Camera& one : rig) {
      one.cameraFromWorld.translation() *= scale;
    }
    return rig;
  }
  FrameSetPtr framesOf(const ScenarioRun& run, std::int64_t frame) const {
    FrameSetPtr frames = run.frames(frame);
    if (fault != CameraFault::Late && fault != CameraFault::Swapped) {
      return frames;
    }
    auto changed = std::make_shared<FrameSet>(*frames);
    if (fault == CameraFault::Swapped) {
      std::swap(changed->frames[camera], changed->frames[other]);
      return changed;
    }
    const auto before = frame - std::int64_t(kLate * run.framesPerSecond + 0.5);
    const FramePtr old = before >= 0 ? run.frames(before)->frames[camera] : nullptr;
    changed->frames[camera] = nullptr;
    if (old) {
      auto late = std::make_shared<Frame>(*old);
      late->captureTime += timeStamp(kLate);
      changed->frames[camera] = late;
    }
    return changed;
  }
  bool isNamedBy(const CameraDisagreement& found) const {
    if (found.fault != fault) {
      return false;
    }
    const auto has = [&](std::size_t one) {
      return std::ranges::find(found.cameras, one) != found.cameras.end();
    };
    switch (fault) {
    case CameraFault::Swapped:
      return has(camera) && has(other);
    case CameraFault::Late:
      return has(camera) && std::abs(found.delay - kLate) < 0.05;
    case CameraFault::Rotated:
      return has(camera);
    case CameraFault::Unit:
      return std::abs(found.metersPerUnit * scale - 1.0) < 0.01;
    default:
      return false;
    }
  }
};

struct Outcome {
  double named = -1.0; // seconds; never: negative
  bool right = false;
  std::string text;
  double microseconds = 0.0; // per frame set
};

Outcome watched(const ScenarioRun& run, const Faulty& faulty, std::int64_t frames) {
  CameraAgreement agreement(faulty.rigOf(run.rig));
  Outcome outcome;
  const auto stated = agreement.disagreements().size();
  double spent = 0.0;
  for (std::int64_t k = 0; k < frames; ++k) {
    const FrameSetPtr set = faulty.framesOf(run, k);
    const std::clock_t begin = std::clock();
    agreement.watch(*set, run.targets);
    spent += double(std::clock() - begin) / CLOCKS_PER_SEC;
    const bool isOfRig = stated > 0 && faulty.fault == CameraFault::Unit;
    if ((isOfRig || agreement.disagreements().size() > stated) && outcome.text.empty()) {
      outcome.named = seconds(set->time);
      outcome.right = faulty.isNamedBy(agreement.disagreements().back());
      outcome.text = textOf(agreement.disagreements().back());
    }
  }
  outcome.microseconds = 1e6 * spent / double(frames);
  return outcome;
}

Faulty drawn(CameraFault fault, std::uint64_t seed, const CameraRig& rig) {
  const std::size_t cameras = rig.size();
  const RandomStream random(seed, 0, 0, RandomPurpose::Simulation);
  const auto number = std::uint32_t(fault);
  Faulty faulty;
  faulty.fault = fault;
  faulty.camera = std::size_t(random.uniform(number, 1) * double(cameras));
  faulty.other =
      (faulty.camera + 1 + std::size_t(random.uniform(number, 2) * double(cameras - 1))) % cameras;
  const auto normal = random.normal4(100 + number);
  faulty.turn = kTurned * Eigen::Vector3d(normal[0], normal[1], 0.0).normalized(); // in the image
  if (rig.size() == 2) { // what moves along the epipolar lines of a pair cannot be seen
    const Eigen::Vector3d other = rig[faulty.camera].cameraFromWorld * rig[faulty.other].center();
    faulty.turn =
        std::copysign(kTurned, normal[0]) * Eigen::Vector3d(other.x(), other.y(), 0.0).normalized();
  }
  faulty.scale = fault == CameraFault::Unit ? 1000.0 : 1.0;
  return faulty;
}

void measureFaults(const ScenarioDeclaration& scenario, Grade grade, std::uint64_t first,
                   int seeds) {
  for (const CameraFault fault :
       {CameraFault::Swapped, CameraFault::Late, CameraFault::Rotated, CameraFault::Unit}) {
    int named = 0, right = 0, inTime = 0, runs = 0;
    std::vector<double> times;
    for (std::uint64_t seed = first; seed < first + std::uint64_t(seeds); ++seed) {
      const auto run = scenario.make(seed, grade);
      if (!run) {
        continue;
      }
      const Faulty faulty = drawn(fault, seed, run->rig);
      const auto outcome = watched(*run, faulty, std::min<std::int64_t>(run->frameCount, 150));
      ++runs;
      named += outcome.named >= 0.0;
      right += outcome.right;
      inTime += outcome.right && outcome.named <= 3.0;
      if (outcome.right) {
        times.push_back(outcome.named);
      } else {
        fmt::print("  {} seed {}: camera {} (and {}): {} at {:.1f} s\n", scenario.name, seed,
                   faulty.camera + 1, faulty.other + 1,
                   outcome.text.empty() ? "nothing" : outcome.text, outcome.named);
      }
    }
    fmt::print("{} {} fault {}: {} runs, {} named, {} right, {} right within 3 s; median {:.1f} s, "
               "longest {:.1f} s\n",
               scenario.name, gradeName(grade), int(fault), runs, named, right, inTime,
               upperMedian(times), times.empty() ? 0.0 : std::ranges::max(times));
    std::fflush(stdout);
  }
}

void measureQuiet(const ScenarioDeclaration& scenario, Grade grade, std::uint64_t first,
                  int seeds) {
  for (std::uint64_t seed = first; seed < first + std::uint64_t(seeds); ++seed) {
    const auto run = scenario.make(seed, grade);
    if (!run || run->rig.size() < 2) {
      continue;
    }
    const auto outcome = watched(*run, {}, std::min<std::int64_t>(run->frameCount, 300));
    fmt::print("{} {} seed {}: {} ({:.1f} s), {:.0f} us per frame set\n", scenario.name,
               gradeName(grade), seed, outcome.text.empty() ? "quiet" : "ALARM " + outcome.text,
               outcome.named, outcome.microseconds);
    std::fflush(stdout);
  }
}

} // namespace
} // namespace dewpoint::bench

int main(int argc, char** argv) {
  using namespace dewpoint;
  if (argc < 5) {
    fmt::print("camera_agreement_bench faults|quiet GRADE FIRST_SEED SEEDS [SCENARIO ...]\n");
    return 1;
  }
  const bool faults = std::string(argv[1]) == "faults";
  const auto grade = experiment::gradeFromName(argv[2]).value_or(experiment::Grade::Ideal);
  std::vector<std::string> wanted(argv + 5, argv + argc);
  std::vector<experiment::ScenarioDeclaration> scenarios = experiment::scenarioCatalog();
  if (grade == experiment::Grade::Real && !wanted.empty()) {
    scenarios =
        experiment::makeRealScenarios({wanted.front(), "bench/clips"}, experiment::clipCatalog())
            .scenarios;
    std::erase_if(scenarios, [](const auto& one) { return one.clip != nullptr; });
    wanted.clear();
  }
  for (const auto& scenario : scenarios) {
    if (!wanted.empty() && std::ranges::find(wanted, scenario.name) == wanted.end()) {
      continue;
    }
    const auto first = std::strtoull(argv[3], nullptr, 10);
    faults ? bench::measureFaults(scenario, grade, first, std::atoi(argv[4]))
           : bench::measureQuiet(scenario, grade, first, std::atoi(argv[4]));
  }
  return 0;
}
