// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/experiment/studies/people_study.h"

#include "core/base/units.h"
#include "core/experiment/metrics/clear_mot.h"
#include "core/experiment/metrics/gospa.h"
#include "core/experiment/metrics/hota.h"
#include "core/experiment/scenarios/people/people_recording.h"
#include "core/experiment/studies/office_instant.h"
#include "core/filter/assignment.h"
#include "core/session/run/frame_loop.h"
#include "core/session/run/tracking_run.h"
#include "core/tracking/catalog/method_catalog.h"
#include "core/tracking/people/people_volume.h"
#include "core/tracking/tracker_capabilities.h"

#include <opencv2/core.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <ctime>
#include <limits>
#include <map>
#include <memory>
#include <set>
#include <utility>

namespace dewpoint::experiment {
namespace {

constexpr std::int64_t kVolumeEvery = 15; ///< frames, a second; a volume costs more than a step
static_assert(kVolumeEvery % kSilhouetteInterval == 0);

/// Which estimate (identity) each truth (identity) has.
std::map<int, int> matched(const TrackFrame& frame, double gate) {
  Eigen::MatrixXd cost = distances(frame);
  cost = (cost.array() <= gate)
             .select(cost, std::numeric_limits<double>::infinity() *
                               Eigen::MatrixXd::Ones(cost.rows(), cost.cols()));
  const Assignment assignment = assignMinimumCost(cost);
  std::map<int, int> pairs;
  for (std::size_t k = 0; k < frame.truth.size(); ++k) {
    if (const auto column = assignment.columnOfRow[k]; column != kUnassigned) {
      pairs[frame.truth[k].identity] = frame.estimates[static_cast<std::size_t>(column)].identity;
    }
  }
  return pairs;
}

/// The longest run of instants, per key, during which something goes on.
class LongestRun {
public:
  void begin() { now_.clear(); }
  void goesOn(int key, double interval) { now_[key] = before_[key] + interval; }
  void end() {
    for (const auto& [key, length] : now_) {
      longest_ = std::max(longest_, length);
    }
    before_ = now_;
  }
  double longest() const { return longest_; }

private:
  std::map<int, double> before_;
  std::map<int, double> now_;
  double longest_ = 0.0;
};

/// One method at work on a scene.
class EvaluatedTracker {
public:
  /// The run is of a method that finds people.
  EvaluatedTracker(std::string method, TrackingRun run, const PeopleRecording& recording)
      : method_(std::move(method)), run_(std::move(run)), rig_(recording.rig),
        tallies_(recording.scene.people.size()) {
    projectors_.reserve(recording.scene.cameras.size());
    for (const Camera& camera : recording.scene.cameras) {
      projectors_.emplace_back(camera);
    }
  }

  Status see(const OfficeRenderer& renderer, const OfficeInstant& instant,
             const std::vector<PeopleInstant>& picturedInstants) {
    const std::clock_t begin = std::clock(); // of this process: others may be busy
    const Status tracked = trackOneFrame(run_, instant.frames, {});
    const std::clock_t end = std::clock();
    if (!tracked) {
      return tracked;
    }
    if (!found().people().empty()) {
      seconds_ += static_cast<double>(end - begin) / CLOCKS_PER_SEC;
      ++steps_;
    }
    record(renderer, instant);
    for (const PeopleInstant& pictured : picturedInstants) {
      if (pictured.frame == instant.frames->index) {
        pictures_.push_back({pictured.caption, drawPeopleImage(found(), *instant.frames, rig_,
                                                               frames_.back().truth)});
      }
    }
    return {};
  }

  PeopleTrial trial(const PeopleStudySetup& setup, const PeopleScenario& scenario) const {
    PeopleTrial result;
    result.scenario = setup.scenario;
    result.grade = setup.grade;
    result.clothes = setup.clothes;
    result.method = method_;
    result.seed = setup.seed;
    const ClearMot clear = computeClearMot(frames_, kPeopleGate);
    result.mota = clear.mota();
    result.motp = clear.motp();
    result.identitySwitches = static_cast<int>(clear.identitySwitches);
    result.hota = computeHota(frames_, kPeopleGate).hota;
    result.gospa = averageGospa(frames_, {kPeopleGate, 2.0}).mean;
    result.longestGhostSeconds = ghosts_.longest();
    result.longestMissedSeconds = missed_.longest();
    result.hullVolume = volumes_ > 0 ? volume_ / volumes_ : 0.0;
    result.stepMs = steps_ > 0 ? inMilliseconds(seconds_) / steps_ : 0.0;
    result.pictures = pictures_;
    result.allPersonsResult = everybody_.result(0.0);
    result.personResults.reserve(tallies_.size());
    for (std::size_t k = 0; k < tallies_.size(); ++k) {
      result.personResults.push_back(tallies_[k].result(scenario.scene.people[k].height));
    }
    if (scenario.timeBeforeMeeting > 0.0) {
      const auto at = [&](double time) {
        const auto frame =
            static_cast<std::size_t>(std::lround(time * scenario.scene.framesPerSecond));
        return frames_[std::min(frame, frames_.size() - 1)];
      };
      result.hasKeptIdentities = areIdentitiesKept(at(scenario.timeBeforeMeeting),
                                                   at(scenario.timeAfterMeeting), kPeopleGate);
    } else {
      result.hasKeptIdentities = clear.identitySwitches == 0;
    }
    return result;
  }

private:
  const PeopleFinding& found() const { return *run_.capability<PeopleFinding>(); }

  void record(const OfficeRenderer& renderer, const OfficeInstant& instant) {
    const double time = dewpoint::base::seconds(instant.frames->time);
    TrackFrame frame{instant.frames->index, time, {}, {}};
    const double interval = 1.0 / renderer.scene().framesPerSecond;
    for (std::size_t k = 0; k < renderer.scene().people.size(); ++k) {
      if (renderer.isInsideOffice(k, time)) {
        Eigen::Vector3d position = renderer.bodyCenter(k, time);
        position.z() = 0.0;
        frame.truth.push_back({static_cast<int>(k), position});
      }
    }
    for (const PersonEstimate& person : found().people()) {
      frame.estimates.push_back({person.identity, {person.position.x(), person.position.y(), 0.0}});
    }
    const auto pairs = matched(frame, kPeopleGate);
    if (frame.frame % kSilhouetteInterval == 0) {
      measureVolumes(instant, pairs);
    }
    measureHeights(renderer.scene(), pairs);
    std::set<int> used;
    missed_.begin();
    ghosts_.begin();
    for (const auto& [truth, estimate] : pairs) {
      used.insert(estimate);
    }
    for (const TrackPoint& truth : frame.truth) {
      const auto person = static_cast<std::size_t>(truth.identity);
      if (instant.seeingCameraCounts[person] < 2) {
        continue;
      }
      const bool isFound = pairs.contains(truth.identity);
      tallies_[person].addFrame(isFound);
      everybody_.addFrame(isFound);
      if (!isFound) {
        missed_.goesOn(truth.identity, interval);
      }
    }
    for (const TrackPoint& estimate : frame.estimates) {
      if (!used.contains(estimate.identity)) {
        ghosts_.goesOn(estimate.identity, interval);
      }
    }
    missed_.end();
    ghosts_.end();
    frames_.push_back(std::move(frame));
  }

  /// The 95 % volumes: their size, and their outlines against the true silhouettes of the people
  /// they belong to.
  void measureVolumes(const OfficeInstant& instant, const std::map<int, int>& pairs) {
    std::map<int, ConvexHull> hulls;
    for (const PersonEstimate& person : found().people()) {
      const ConvexHull& hull =
          hulls.emplace(person.identity, bodyHull(found().bodyOf(person.identity))).first->second;
      if (instant.frames->index % kVolumeEvery == 0) {
        volume_ += hull.volume();
        ++volumes_;
      }
    }
    for (const auto& [truth, estimate] : pairs) {
      measureSilhouettes(instant, static_cast<std::size_t>(truth), hulls.at(estimate));
    }
  }

  void measureSilhouettes(const OfficeInstant& instant, std::size_t person,
                          const ConvexHull& hull) {
    for (std::size_t camera = 0; camera < projectors_.size(); ++camera) {
      const cv::Mat visible = instant.visibleMask(camera, person);
      if (cv::countNonZero(visible) < kMinVisiblePixels) {
        continue;
      }
      const cv::Mat outline =
          filledOutline(projectedHull(projectors_[camera], hull), visible.size());
      const SilhouetteOverlap overlap =
          overlapOf(outline, visible, instant.silhouettes[camera][person]);
      tallies_[person].addSilhouette(overlap);
      everybody_.addSilhouette(overlap);
    }
  }

  void measureHeights(const OfficeScene& scene, const std::map<int, int>& pairs) {
    for (const auto& [truth, estimate] : pairs) {
      const auto& people = found().people();
      const auto person = std::ranges::find(people, estimate, &PersonEstimate::identity);
      if (person != people.end() && person->height > 0.0) {
        const auto k = static_cast<std::size_t>(truth);
        tallies_[k].addHeightError(person->height - scene.people[k].height);
        everybody_.addHeightError(person->height - scene.people[k].height);
      }
    }
  }

  std::string method_;
  TrackingRun run_;
  CameraRig rig_;                     ///< as the method believes it
  std::vector<Projector> projectors_; ///< per true camera
  std::vector<PersonTally> tallies_;  ///< per person
  PersonTally everybody_;
  std::vector<TrackFrame> frames_;
  std::vector<PeopleImage> pictures_;
  LongestRun ghosts_;
  LongestRun missed_;
  double volume_ = 0.0;
  int volumes_ = 0;
  double seconds_ = 0.0;
  int steps_ = 0;
};

bool declares(const std::string& method, const std::string& key) {
  const auto declared = methodParameters(method);
  return std::ranges::find(declared, key, &ParameterDeclaration::key) != declared.end();
}

Result<std::vector<EvaluatedTracker>> contestants(const PeopleStudySetup& setup,
                                                  const PeopleRecording& recording) {
  std::vector<EvaluatedTracker> all;
  for (const std::string& method : setup.methods) {
    ParameterValues parameters(methodParameters(method));
    for (const auto& [key, value] : setup.parameters) {
      if (!declares(method, key)) {
        continue; // of another method
      }
      if (const auto set = parameters.set(key, value); !set) {
        return tl::make_unexpected(set.error());
      }
    }
    RunDefinition definition;
    definition.method = method;
    definition.parameters = std::move(parameters);
    definition.rig = std::make_shared<const CameraRig>(recording.rig);
    definition.seed = setup.seed;
    auto run = TrackingRun::create(std::make_shared<const RunDefinition>(std::move(definition)), 1);
    if (!run) {
      return tl::make_unexpected(run.error());
    }
    all.emplace_back(method, std::move(*run), recording);
  }
  return all;
}

} // namespace

Status checkPeopleParameters(const PeopleStudySetup& setup) {
  for (const auto& [key, value] : setup.parameters) {
    bool known = false;
    for (const std::string& method : setup.methods) {
      if (!declares(method, key)) {
        continue;
      }
      known = true;
      if (const auto set = ParameterValues(methodParameters(method)).set(key, value); !set) {
        return set;
      }
    }
    if (!known) {
      return failure(ErrorCode::UnknownKey, "", key, "none of the chosen methods has it");
    }
  }
  return {};
}

bool areIdentitiesKept(const TrackFrame& before, const TrackFrame& after, double gate) {
  const auto first = matched(before, gate);
  const auto last = matched(after, gate);
  return !before.truth.empty() && first.size() == before.truth.size() && first == last;
}

Result<std::vector<PeopleTrial>> studyPeople(const PeopleStudySetup& setup,
                                             simulation::ViewCache& views) {
  const auto scenario = makePeopleScenario(setup.scenario, setup.clothes, setup.seed);
  if (!scenario) {
    return tl::make_unexpected(scenario.error());
  }
  if (const auto checked = checkPeopleParameters(setup); !checked) {
    return tl::make_unexpected(checked.error());
  }
  const PeopleRecording recording =
      recordPeople(setup.scenario, scenario->scene, setup.grade, views);
  auto all = contestants(setup, recording);
  if (!all) {
    return tl::make_unexpected(all.error());
  }
  const OfficeRenderer renderer(recording.scene, recording.roomViews);
  const auto picturedInstants =
      setup.drawsPictures ? chooseInstantsToShow(*scenario) : std::vector<PeopleInstant>();
  // A loop of its own: every frame is rendered once, and all methods track it.
  for (std::int64_t frame = 0; frame < scenario->scene.frameCount; ++frame) {
    const OfficeInstant instant = renderInstant(recording, renderer, frame);
    for (EvaluatedTracker& one : *all) {
      if (const auto seen = one.see(renderer, instant, picturedInstants); !seen) {
        return tl::make_unexpected(seen.error());
      }
    }
  }
  std::vector<PeopleTrial> trials;
  for (const EvaluatedTracker& one : *all) {
    trials.push_back(one.trial(setup, *scenario));
  }
  return trials;
}

} // namespace dewpoint::experiment
