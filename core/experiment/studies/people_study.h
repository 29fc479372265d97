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

/// Result of a method at one instant of a scene, see peoplePicture().
struct PeoplePicture {
  std::string words; ///< the time of the instant
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
  /// Whether every person had an identity before the meeting, and the same one after it.
  bool kept = false;
  double mota = 0.0;
  double motp = 0.0; ///< meters
  double hota = 0.0;
  double gospa = 0.0; ///< meters, mean, cutoff kPeopleGate
  int identitySwitches = 0;
  double longestGhost = 0.0; ///< longest time without a person at an estimate, seconds
  /// Longest time that a person seen by two cameras has no estimate, seconds.
  double longestMissed = 0.0;
  double hullVolume = 0.0;             ///< m³, mean over people and frames
  double stepMs = 0.0;                 ///< mean CPU time of a frame with people, ms
  PersonResult everybody;              ///< over all people of the scene
  std::vector<PersonResult> persons;   ///< in the order of the scene
  std::vector<PeoplePicture> pictures; ///< of tellingInstants(), if requested
};

/// Largest distance in meters at which an estimate belongs to a person: the width of an adult.
inline constexpr double kPeopleGate = 0.5;

/// Scene, methods and parameters of a study of people.
struct PeopleStudySetup {
  std::string scenario;
  Grade grade = Grade::Ideal; ///< any but Real
  PeopleClothes clothes = PeopleClothes::Different;
  std::vector<std::string> methods = methodNames(TargetsFrom::Images); ///< methods that find people
  std::uint64_t seed = kFirstTuningSeed;
  /// Values other than the defaults, for the methods that have such a parameter.
  std::vector<std::pair<std::string, double>> parameters;
  bool pictures = false; ///< draw the instants of tellingInstants()
};

/// Checks the parameters. UnknownKey for a parameter that no method has, BadValue for a value out
/// of range; `field` is the parameter's key.
Status checkPeopleParameters(const PeopleStudySetup& setup);

/// Renders one scene in a grade and runs all methods on it with the calibration that they receive;
/// one trial per method. Positions and silhouettes are compared with the truth in the true cameras.
/// Errors are those of the names of scene, method and parameters.
Result<std::vector<PeopleTrial>> studyPeople(const PeopleStudySetup& setup,
                                             simulation::ViewCache& views);

/// Whether every truth has the same estimate at both instants, and no estimate belongs to two of
/// them. Pairs farther apart than `gate` (meters) do not count.
bool identitiesKept(const TrackFrame& before, const TrackFrame& after, double gate);

} // namespace dewpoint::experiment
