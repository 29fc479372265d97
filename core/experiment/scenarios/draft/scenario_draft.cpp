// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/experiment/scenarios/draft/scenario_draft.h"

#include "core/experiment/scenarios/draft/draft_frames.h"
#include "core/experiment/scenarios/draft/grade_model.h"
#include "core/experiment/scenarios/draft/target_truth.h"
#include "core/experiment/scenarios/pink_target.h"
#include "core/experiment/scenarios/wild/wild_rig.h"
#include "core/experiment/scenarios/wild/wild_room.h"

#include <Eigen/Geometry>
#include <fmt/format.h>

#include <cmath>
#include <utility>

namespace dewpoint::experiment::scenarios {
namespace {

/// Keeps the noise's seed apart from the draws'.
constexpr std::uint32_t kNoisePart = 0x5EED;

/// The extents are those of the samples, in their order.
Trajectory truthOf(const ScenarioDraft& draft, std::vector<TargetExtent>& extents) {
  Trajectory truth;
  truth.header.entries = {{"scenario", draft.name}, {"seed", fmt::format("{}", draft.seed)}};
  for (const Camera& camera : draft.rig) {
    truth.header.cameras.push_back({camera.name, camera.center(), camera.opticalAxis()});
  }
  for (std::int64_t frame = 0; frame < draft.frameCount; ++frame) {
    for (const std::size_t target : draft.targets) {
      const simulation::StageBody& body = draft.stage.bodies[target];
      TrajectorySample sample;
      sample.time = draft.timeOf(frame);
      sample.frame = frame;
      sample.target = body.name;
      const TargetTruth now = targetTruth(body, sample.time);
      sample.position = now.position;
      extents.push_back(now.extent);
      sample.cameraCount = static_cast<int>(draft.rig.size());
      sample.isValid = body.isPresentAt(sample.time);
      truth.samples.push_back(std::move(sample));
    }
  }
  return truth;
}

/// What the grade and the scenario do to images, time stamps and calibration.
SensingFaults faultsOf(const ScenarioDraft& draft) {
  SensingFaults faults = noFaults(draft);
  if (draft.grade != Grade::Ideal) {
    const GradeModel& model = gradeModel(draft.grade);
    RandomDraws draws(draft.seed, draft.name + " " + model.name);
    FaultContext context;
    context.cameraCount = draft.rig.size();
    context.durationSeconds = draft.timeOf(draft.frameCount);
    context.framesPerSecond = draft.framesPerSecond;
    context.exposureSeconds = draft.stage.exposureSeconds;
    context.targetStart = draft.stage.bodies[draft.targets.front()].path(0.0);
    faults = randomFaults(model, context, draws);
    faults.illumination.lampPosition = draft.stage.illumination.lampPosition;
  }
  if (draft.adjustFaults) {
    draft.adjustFaults(faults);
  }
  return faults;
}

ScenarioRun runOf(ScenarioDraft draft) {
  ScenarioRun run;
  run.scenario = draft.name;
  run.grade = draft.grade;
  run.seed = draft.seed;
  run.trueRig = draft.rig;
  run.rig = draft.rig;
  run.finalTimeStampDelays.assign(draft.rig.size(), 0.0);
  // What is ideal stays as it was drawn, to the bit.
  if (draft.grade != Grade::Ideal || draft.adjustFaults) {
    RandomDraws errors(draft.seed, draft.name + " calibration");
    const SensingFaults faults = faultsOf(draft);
    for (std::size_t camera = 0; camera < draft.rig.size(); ++camera) {
      const double end = draft.timeOf(draft.frameCount);
      run.finalTimeStampDelays[camera] =
          end - midExposureTime(faults.cameras.at(camera).timing, end);
    }
    run.rig = applyFaults(faults, draft, errors);
  }
  for (const std::size_t target : draft.targets) {
    const simulation::StageBody& body = draft.stage.bodies[target];
    run.targets.push_back(pinkTarget(body.name, draft.isRadiusKnown ? body.radius : 0.0));
  }
  run.startCenter = draft.startCenter;
  run.startHalfSize = draft.startHalfSize;
  run.framesPerSecond = draft.framesPerSecond;
  run.frameCount = draft.frameCount;
  run.truth = truthOf(draft, run.extents);
  run.events = draft.events;
  run.equalCandidateCount = draft.equalCandidateCount;
  run.isSensingExact = draft.grade == Grade::Ideal && draft.isCalibrationExactWhenIdeal;
  const auto shared = std::make_shared<const ScenarioDraft>(std::move(draft));
  run.frames = [shared](std::int64_t frame) { return frameSetOf(*shared, frame); };
  if (shared->learnTargets) {
    shared->learnTargets(*shared, run);
  }
  return run;
}

/// A draft with its cameras and the room at rest, before the scenario's own part.
ScenarioDraft usualDraft(const ScenarioRecipe& recipe, simulation::ViewCache& cache,
                         std::uint64_t seed, Grade grade) {
  ScenarioDraft draft{recipe.name, grade, seed, RandomDraws(seed, recipe.name), recipe.rig};
  RandomDraws lenses(seed, recipe.name + " lenses");
  setRandomLenses(grade, draft.rig, lenses);
  draft.room = std::make_shared<const simulation::Room>(recipe.furnishing);
  for (const Camera& camera : draft.rig) {
    draft.stage.views.push_back(cache.view(camera, recipe.furnishing));
  }
  return draft;
}

/// The same with cameras, furniture and people of its own.
ScenarioDraft wildDraft(const ScenarioRecipe& recipe, std::uint64_t seed, int attempt) {
  ScenarioDraft draft{recipe.name, Grade::Wild, seed, RandomDraws(seed, recipe.name), {}};
  RandomDraws draws(seed, fmt::format("{} wild {}", recipe.name, attempt));
  const WildRig wild = randomRig(recipe.rig, recipe.furnishing, attempt, draws);
  draft.rig = wild.rig;
  draft.pathScale = wild.pathScale;
  draft.radiusScale = wild.radiusScale;
  setRandomLenses(Grade::Wild, draft.rig, draws);
  const simulation::RoomDesign design =
      randomRoom(recipe.furnishing, draft.rig, draws, recipe.targetColor);
  const auto room = std::make_shared<const simulation::Room>(recipe.furnishing, design);
  // Not from the cache: no other run has these views.
  for (const Camera& camera : draft.rig) {
    draft.stage.views.push_back(std::make_shared<const simulation::RoomView>(camera, *room));
  }
  draft.room = room;
  draft.stage.illumination.lampPosition = room->lampPosition();
  draft.stage.floorHeight = floorHeightOf(recipe.furnishing);
  return draft;
}

/// Makes the balls as small as the grade wants them: what was placed for larger ones stays clear.
void shrinkBalls(ScenarioDraft& draft) {
  for (simulation::StageBody& body : draft.stage.bodies) {
    if (!body.isBox) {
      body.radius *= draft.radiusScale;
    }
  }
}

Result<ScenarioRun> runOf(const ScenarioRecipe& recipe, simulation::ViewCache& cache,
                          std::uint64_t seed, Grade grade) {
  const bool wild = grade == Grade::Wild;
  for (int attempt = 0; attempt < (wild ? kMaxRigAttempts : 1); ++attempt) {
    ScenarioDraft draft =
        wild ? wildDraft(recipe, seed, attempt) : usualDraft(recipe, cache, seed, grade);
    draft.stage.seed = derivedSeed(seed, hashOf(recipe.name) ^ kNoisePart);
    if (!recipe.complete(draft)) {
      continue;
    }
    if (wild) {
      shrinkBalls(draft);
      RandomDraws people(seed, recipe.name + " people");
      const double seconds = draft.timeOf(draft.frameCount);
      draft.stage.people = randomPeople(recipe.furnishing, seconds, people, recipe.targetColor);
    }
    return runOf(std::move(draft));
  }
  return failure(ErrorCode::Undetermined, "", recipe.name,
                 fmt::format("no position was found for what must be seen (seed {})", seed));
}

} // namespace

ScenarioDeclaration declareScenario(ScenarioRecipe recipe,
                                    std::shared_ptr<simulation::ViewCache> cache) {
  ScenarioDeclaration declaration;
  declaration.name = recipe.name;
  declaration.family = recipe.name.substr(0, recipe.name.find('-'));
  declaration.description = recipe.description;
  declaration.make = [recipe = std::move(recipe), cache = std::move(cache)](std::uint64_t seed,
                                                                            Grade grade) {
    return runOf(recipe, *cache, seed, grade);
  };
  return declaration;
}

void addTarget(ScenarioDraft& draft, simulation::Path path, double radius) {
  draft.targets.push_back(draft.stage.bodies.size());
  simulation::StageBody& body = draft.stage.bodies.emplace_back();
  body.name = fmt::format("ball {}", draft.targets.size());
  body.radius = radius;
  body.path = std::move(path);
}

void startNearTruth(ScenarioDraft& draft) {
  constexpr double kOff = 0.05; // meters; chosen: as well as somebody points at a ball
  constexpr double kHalf = 0.1; // meters; chosen: holds the ball wherever in it it is
  const Eigen::Vector3d off =
      draft.draws.drawPointInBox(Eigen::Vector3d::Constant(-kOff), Eigen::Vector3d::Constant(kOff));
  draft.startCenter = targetTruth(draft.stage.bodies[draft.targets.front()], 0.0).position + off;
  draft.startHalfSize = Eigen::Vector3d::Constant(kHalf);
}

void startAroundAllTargets(ScenarioDraft& draft) {
  constexpr double kAround = 0.05; // meters; chosen: more than a radius
  Eigen::AlignedBox3d box;
  for (const std::size_t target : draft.targets) {
    box.extend(draft.stage.bodies[target].path(0.0));
  }
  draft.startCenter = box.center();
  draft.startHalfSize = 0.5 * box.sizes() + Eigen::Vector3d::Constant(kAround);
}

} // namespace dewpoint::experiment::scenarios
