// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/experiment/metrics/track_frame.h"
#include "core/experiment/report/seed_blocks.h"
#include "core/experiment/scenarios/grade.h"
#include "core/experiment/scenarios/people/people_scenario.h"
#include "core/experiment/studies/people_pictures.h"
#include "core/experiment/studies/person_tally.h"
#include "core/simulation/room/view_cache.h"
#include "core/tracking/catalog/method_catalog.h"

#include <cstdint>
#include <functional>
#include <string>
#include <vector>

namespace dewpoint::experiment {

/// Image that shows the result of a method in one frame of a scene; see drawPeopleImage().
struct PeopleImage {
  std::string caption; ///< description, with the time of the frame
  cv::Mat image;
};

/// Results of a method on one simulated scene. Positions are compared on the floor, within
/// kPeopleGate.
struct PeopleTrial {
  std::string scenario;
  Grade grade = Grade::Ideal;
  PeopleClothes clothes = PeopleClothes::Different;
  std::string method;
  std::uint64_t seed = 0;
  /// True if every person had an identity before the meeting, and the same identity after the
  /// meeting.
  bool hasKeptIdentities = false;
  double mota = 0.0;
  double motp = 0.0; ///< mean distance of matches (ClearMot::motp()), meters
  double hota = 0.0;
  double gospa = 0.0; ///< mean GOSPA distance over the frames, meters; the cutoff is kPeopleGate
  int identitySwitches = 0;
  /// Longest time, in seconds, during which an estimated person has no true person nearby (within
  /// kPeopleGate).
  double longestGhostSeconds = 0.0;
  /// Longest time during which a person has no estimate although at least two cameras see the
  /// person, seconds.
  double longestMissedSeconds = 0.0;
  /// Volume that contains 95 % of a person (bodyHull()), m³; mean over people and frames.
  double hullVolume = 0.0;
  double stepMs = 0.0;                     ///< mean CPU time per frame with people, ms
  PersonResult allPersonsResult;           ///< results over all people in the scene
  std::vector<PersonResult> personResults; ///< results per person, in scene order
  /// Images of the frames that are chosen to be shown (chooseInstantsToShow()), if requested.
  std::vector<PeopleImage> pictures;
};

/// Largest distance (meters) at which an estimate is assigned to a person: the width of an adult.
inline constexpr double kPeopleGate = 0.5;

/// Scene, methods and parameters for a study of people.
struct PeopleStudySetup {
  std::string scenario;
  Grade grade = Grade::Ideal; ///< any grade except Real
  PeopleClothes clothes = PeopleClothes::Different;
  std::vector<std::string> methods =
      methodNames(TargetSource::Images); ///< methods that find people
  std::uint64_t seed = kFirstTuningSeed;
  /// Non-default parameter values. They apply to the methods that have such a parameter.
  std::vector<std::pair<std::string, double>> parameters;
  /// True to draw the frames that are chosen to be shown (chooseInstantsToShow()).
  bool drawsPictures = false;
};

/// Checks the parameters. Returns UnknownKey for a parameter that no method has, or BadValue for a
/// value out of range. The error's `field` is the parameter's key.
Status checkPeopleParameters(const PeopleStudySetup& setup);

/// Renders one scene in a grade, runs all methods of `setup` on it, and returns one trial per
/// method. The methods receive a calibration with errors (PeopleRecording::rig). Their positions
/// are compared with the true ones, and their silhouettes with those in the images of the true
/// cameras. Returns an error for an unknown scene, method or parameter.
Result<std::vector<PeopleTrial>> studyPeople(const PeopleStudySetup& setup,
                                             simulation::ViewCache& views);

/// Returns whether all identities were kept: whether every true target is matched to the same
/// estimate in the frames `before` and `after`, and no estimate to two targets. Pairs farther apart
/// than `gate` (meters) are not matched.
bool areIdentitiesKept(const TrackFrame& before, const TrackFrame& after, double gate);

} // namespace dewpoint::experiment
