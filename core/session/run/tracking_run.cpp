// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/session/run/tracking_run.h"

#include "core/base/overloaded.h"
#include "core/session/people/people_writer.h"
#include "core/session/run/sphere_sample.h"
#include "core/tracking/catalog/method_catalog.h"

#include <fmt/format.h>

#include <algorithm>
#include <cassert>
#include <chrono>
#include <utility>

namespace dewpoint::session {

namespace {

/// A box is known as it is given, all else only when the frame was tracked.
constexpr Overloaded kStatusBeforeTracking{
    [](const SphereEstimate&) { return TargetStatus::Searching; },
    [](const BoxEstimate& box) {
      return isConfirmed(box) ? TargetStatus::Held : TargetStatus::Searching;
    },
    [](const PersonEstimate&) { return TargetStatus::Searching; },
    [](const AbsentEstimate&) { return TargetStatus::Gone; }};

} // namespace

TrajectoryHeader trajectoryHeader(const Project& project) {
  TrajectoryHeader header;
  header.entries = {{"version", DEWPOINT_VERSION},
                    {"project", project.name},
                    {"method", project.method},
                    {"seed", std::to_string(project.seed)}};
  for (const auto& declaration : project.parameters.declarations()) {
    const std::string unit = declaration.unit.empty() ? "" : " " + declaration.unit;
    header.entries.emplace_back(declaration.key,
                                fmt::format("{}{}", project.parameters.at(declaration.key), unit));
  }
  if (project.volumeOfInterest) {
    header.entries.emplace_back("volume_of_interest", volumeText(*project.volumeOfInterest));
  }
  for (const auto& camera : project.cameras) {
    header.cameras.push_back(
        {camera.camera.name, camera.camera.center(), camera.camera.opticalAxis()});
  }
  const Method* const method = findMethod(project.method);
  header.hasMeasurements = method != nullptr && method->writesMeasurements;
  header.hasBestParticles = method != nullptr && method->family.hasBestParticle;
  header.hasAmbiguousColumn = method != nullptr && method->writesAmbiguity;
  const auto mayBeNoBall = [](const Target& target) { return target.shape != TargetShape::Ball; };
  header.hasExtent = method != nullptr && method->tracksAnyShape &&
                     std::ranges::any_of(project.targets, mayBeNoBall);
  header.hasCorrectedColumn = header.hasBestParticles && !project.corrections.empty();
  return header;
}

std::vector<std::pair<std::string, std::string>> boxTrackHeader(const Project& project) {
  auto entries = trajectoryHeader(project).entries;
  for (std::size_t k = 0; k < project.targets.size(); ++k) {
    const Target& target = project.targets[k];
    std::string text = target.name;
    if (target.box) {
      const ImageBox& box = target.box->box;
      const auto camera = static_cast<std::size_t>(target.box->camera);
      text +=
          fmt::format(", box {} {} {} {} px at frame {} of camera {}", box.x, box.y, box.width,
                      box.height, target.box->frame,
                      camera < project.cameras.size() ? project.cameras[camera].camera.name : "");
    }
    entries.emplace_back(fmt::format("target {}", k + 1), std::move(text));
  }
  return entries;
}

Result<TrackingRun> TrackingRun::create(RunDefinitionPtr definition, int threadCount) {
  auto tracker = makeTracker(definition->method, definition->parameters, *definition->rig,
                             definition->targets);
  if (!tracker) {
    return tl::make_unexpected(tracker.error());
  }
  return fromTracker(std::move(*tracker), std::move(definition), threadCount);
}

Result<TrackingRun> TrackingRun::create(const Project& project, int threadCount,
                                        std::vector<cv::Mat> backgroundImages) {
  return create(std::make_shared<const RunDefinition>(
                    RunDefinition::fromProject(project, std::move(backgroundImages))),
                threadCount);
}

TrackingRun TrackingRun::fromTracker(std::unique_ptr<Tracker> tracker, RunDefinitionPtr definition,
                                     int threadCount) {
  TrackingRun run;
  run.tracker_ = std::move(tracker);
  if (auto* const knowing = tracking::capability<BackgroundImageConfigurable>(*run.tracker_)) {
    knowing->setBackgroundImages(definition->backgroundImages);
  }
  auto* const bounded = tracking::capability<VolumeBounded>(*run.tracker_);
  if (bounded != nullptr && definition->volumeOfInterest) {
    bounded->setVolumeOfInterest(definition->volumeOfInterest);
  }
  run.definition_ = std::move(definition);
  run.team_ = std::make_unique<ThreadTeam>(threadCount);
  run.restart(run.definition_->seed);
  return run;
}

void TrackingRun::restart(std::uint64_t seed) {
  tracker_->restart(seed);
  frames_ = nullptr;
  iterationCount_ = 0;
  frameIterationCount_ = 0;
}

bool TrackingRun::accepts(const RunDefinition& definition) const {
  const auto* const fixed = capability<FixedTargetCount>();
  return definition.method == definition_->method && haveSameImageSizes(*definition.rig, rig()) &&
         (fixed == nullptr || fixed->targetCount() == definition.targets.size());
}

void TrackingRun::apply(const RunDefinitionPtr& definition) {
  assert(accepts(*definition));
  const RunDefinitionPtr before = std::exchange(definition_, definition);
  auto* const bounded = tracking::capability<VolumeBounded>(*tracker_);
  if (bounded != nullptr && definition->volumeOfInterest != before->volumeOfInterest) {
    bounded->setVolumeOfInterest(definition->volumeOfInterest);
  }
  auto* const configurable = tracking::capability<Configurable>(*tracker_);
  if (configurable != nullptr && !(definition->parameters == before->parameters)) {
    configurable->configure(definition->parameters);
  }
  auto* const following = tracking::capability<TargetTracking>(*tracker_);
  // A target that is hidden in the views is tracked on as before, to the last bit.
  if (following != nullptr &&
      !std::ranges::equal(definition->targets, before->targets, areSameExceptShown)) {
    following->setTargets(definition->targets);
  }
  auto* const calibrated = tracking::capability<RigConfigurable>(*tracker_);
  if (calibrated != nullptr && definition->rig != before->rig && *definition->rig != *before->rig) {
    calibrated->setCameras(*definition->rig);
  }
  auto* const knowing = tracking::capability<BackgroundImageConfigurable>(*tracker_);
  if (knowing != nullptr &&
      !areImagesEqual(definition->backgroundImages, before->backgroundImages)) {
    knowing->setBackgroundImages(definition->backgroundImages);
  }
}

void TrackingRun::apply(const RunChange& change) {
  std::visit(Overloaded{[this](const DefinitionChange& other) { apply(other.after); },
                        [this](const PeopleChange& people) { applyCorrection(people); },
                        [this](const PositionCorrection& position) { correct(position); }},
             change);
}

void TrackingRun::applyCorrection(const PeopleChange& people) {
  auto* const placing = tracking::capability<PersonEditing>(*tracker_);
  if (people.newPersonPosition && placing != nullptr) {
    placing->addPerson(*people.newPersonPosition);
  }
  if (people.removedPersonId && placing != nullptr) {
    placing->removePerson(*people.removedPersonId);
  }
}

const std::vector<Target>& TrackingRun::targets() const {
  const auto* const finding = capability<PeopleFinding>();
  return finding != nullptr ? finding->peopleAsTargets() : definition_->targets;
}

bool TrackingRun::canBeCopied() const {
  const auto* const copying = capability<Copyable>();
  return copying != nullptr && copying->canBeCopied();
}

TrackingRun::State TrackingRun::save() const {
  State state{nullptr, definition_, iterationCount_, 0};
  const auto* const copying = capability<Copyable>();
  if (std::unique_ptr<Tracker> copy = copying != nullptr ? copying->clone() : nullptr) {
    copy->beginFrame(nullptr); // the images of the last frame are not needed to go on
    state.memoryBytes = tracking::capability<Copyable>(*copy)->memoryBytes();
    state.tracker = std::move(copy);
  }
  return state;
}

void TrackingRun::restore(const State& state) {
  tracker_ = tracking::capability<Copyable>(*state.tracker)->clone();
  definition_ = state.definition;
  frames_ = nullptr;
  iterationCount_ = state.iterationCount;
  frameIterationCount_ = 0;
}

void TrackingRun::beginFrame(FrameSetPtr frames) {
  frames_ = std::move(frames);
  frameIterationCount_ = 0;
  tracker_->beginFrame(frames_);
}

int TrackingRun::iterationsPerFrame() const {
  return tracker_->iterationsPerFrame();
}

double TrackingRun::iterateTimed() {
  const auto begin = std::chrono::steady_clock::now();
  tracker_->iterate(*team_);
  ++iterationCount_;
  if (++frameIterationCount_ == iterationsPerFrame()) {
    correctPeople();
    correctPositions();
  }
  const std::chrono::duration<double, std::micro> took = std::chrono::steady_clock::now() - begin;
  return took.count() / static_cast<double>(std::max<std::size_t>(1, trackedTargetCount()));
}

void TrackingRun::correctPeople() {
  for (const PersonCorrection& correction : definition_->personCorrections) {
    if (frames_ && correction.frame == frames_->index) {
      apply(effectOf(correction));
    }
  }
}

PeopleChange TrackingRun::effectOf(const PersonCorrection& correction) {
  const auto* const finding = capability<PeopleFinding>();
  return finding != nullptr
             ? peopleChange(correction, *finding, rig(), definition_->parameters, correctionErrors_)
             : PeopleChange{};
}

void TrackingRun::correct(const PositionCorrection& correction) {
  auto* const correcting = tracking::capability<PositionCorrecting>(*tracker_);
  const auto target = static_cast<std::size_t>(correction.target);
  if (correcting != nullptr && target < tracker_->trackCount()) {
    correcting->correctPosition(target, {correction.position, correction.covariance}, *team_);
  }
}

void TrackingRun::correctPositions() {
  for (const PositionCorrection& correction : definition_->corrections) {
    if (frames_ && correction.frame == frames_->index) {
      correct(correction);
    }
  }
}

bool TrackingRun::isCorrected(std::size_t target) const {
  return supportsCorrections<PositionCorrecting>() &&
         std::ranges::any_of(definition_->corrections, [&](const PositionCorrection& correction) {
           return correction.frame == frames_->index && !correction.trackedFrom &&
                  static_cast<std::size_t>(correction.target) == target;
         });
}

std::size_t TrackingRun::trackedTargetCount() const {
  const auto* const finding = capability<PeopleFinding>();
  return finding != nullptr ? finding->people().size() : targets().size();
}

std::vector<TrajectorySample> TrackingRun::samples() const {
  std::vector<TrajectorySample> samples;
  for (std::size_t k = 0; frames_ && k < tracker_->trackCount(); ++k) {
    const double time = seconds(frames_->time);
    std::visit(Overloaded{[&](const SphereEstimate& sphere) {
                            samples.push_back(
                                sampleOf(sphere, targets()[k].name, frames_->index, time));
                            samples.back().isCorrected = isCorrected(k);
                          },
                          [&](const PersonEstimate& person) {
                            samples.push_back(sampleOf(person, frames_->index, time));
                          },
                          [](const BoxEstimate&) {}, // in no space: see boxSamples()
                          [](const AbsentEstimate&) {}},
               tracker_->estimate(k));
  }
  return samples;
}

std::vector<BoxSample> TrackingRun::boxSamples() const {
  std::vector<BoxSample> samples;
  for (std::size_t k = 0; frames_ && k < tracker_->trackCount(); ++k) {
    const TrackEstimate estimate = tracker_->estimate(k);
    if (const auto* const box = std::get_if<BoxEstimate>(&estimate)) {
      samples.push_back({seconds(frames_->time), frames_->index, static_cast<int>(k) + 1, *box});
    }
  }
  return samples;
}

void TrackingRun::copyParticles(std::size_t target, int limit, Eigen::ArrayXXd& positions,
                                Eigen::ArrayXd& weights) const {
  positions.resize(0, 3);
  weights.resize(0);
  if (const auto* const cloud = capability<ParticleCloud>()) {
    cloud->copyParticles(target, limit, positions, weights);
  }
}

TrackedFrame TrackingRun::commonTrackedFrame(const TrackedFrame* before,
                                             int boxParticleLimit) const {
  TrackedFrame trackedFrame;
  trackedFrame.frame = frames_ ? frames_->index : -1;
  trackedFrame.time = frames_ ? seconds(frames_->time) : 0.0;
  trackedFrame.iterationCount = frameIterationCount_;
  trackedFrame.totalIterationCount = iterationCount_;
  const std::vector<Target>& tracked = targets();
  const bool same =
      before != nullptr && before->targetDefinitions && tracked == *before->targetDefinitions;
  trackedFrame.targetDefinitions =
      same ? before->targetDefinitions : std::make_shared<const std::vector<Target>>(tracked);
  if (const auto* const finding = capability<PeopleFinding>()) {
    trackedFrame.peopleCameras = finding->cameraStates();
  }
  const auto* const boxes = capability<BoxTracking>();
  trackedFrame.targets.resize(tracked.size());
  for (std::size_t k = 0; k < tracked.size(); ++k) {
    TrackedTarget& target = trackedFrame.targets[k];
    target.estimate = tracker_->estimate(k);
    if (boxes != nullptr) {
      target.boxParticles = boxes->boxParticles(k, boxParticleLimit);
    }
  }
  return trackedFrame;
}

TrackedFrame TrackingRun::currentFrame(const TrackedFrame* recorded, int boxParticleLimit) const {
  TrackedFrame trackedFrame = commonTrackedFrame(recorded, boxParticleLimit);
  for (std::size_t k = 0; k < trackedFrame.targets.size(); ++k) {
    TrackedTarget& target = trackedFrame.targets[k];
    if (recorded != nullptr && k < recorded->targets.size()) {
      target.status = recorded->targets[k].status;
      target.cameraReports = recorded->targets[k].cameraReports;
      target.positionCandidates = recorded->targets[k].positionCandidates;
    } else {
      target.status = std::visit(kStatusBeforeTracking, target.estimate);
    }
  }
  return trackedFrame;
}

TrackedFrame TrackingRun::trackedFrame(int particleLimit, const TrackedFrame* previous) const {
  TrackedFrame trackedFrame = commonTrackedFrame(previous, particleLimit);
  const auto* const proposing = capability<CandidateReporting>();
  const auto* const explaining = capability<CameraReporting>();
  for (std::size_t k = 0; k < trackedFrame.targets.size(); ++k) {
    TrackedTarget& target = trackedFrame.targets[k];
    Eigen::ArrayXXd positions;
    Eigen::ArrayXd weights;
    copyParticles(k, particleLimit, positions, weights);
    target.particles = positions.cast<float>();
    target.weights = weights.cast<float>();
    if (proposing != nullptr) {
      target.positionCandidates = proposing->positionCandidates(k);
    }
    if (explaining != nullptr) {
      target.cameraReports = explaining->cameraReports(k);
    }
    if (previous != nullptr && k < previous->targets.size()) {
      target.lastHeldTime = previous->targets[k].lastHeldTime;
    }
    const bool held = isConfirmed(target.estimate);
    target.lastHeldTime = held ? trackedFrame.time : target.lastHeldTime;
    target.status = isAbsent(target.estimate) ? TargetStatus::Gone
                    : isAmbiguous(target.estimate)
                        ? TargetStatus::Ambiguous
                        : statusOf(held, trackedFrame.time, target.lastHeldTime);
  }
  return trackedFrame;
}

TruthTable::TruthTable(const Trajectory& truth) {
  for (const auto& sample : truth.samples) {
    positions_[{sample.target, sample.frame}] = sample.position;
  }
}

std::optional<Eigen::Vector3d> TruthTable::at(const std::string& target, std::int64_t frame) const {
  const auto found = positions_.find({target, frame});
  return found == positions_.end() ? std::nullopt : std::optional(found->second);
}

} // namespace dewpoint::session
