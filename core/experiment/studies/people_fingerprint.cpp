// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/experiment/studies/people_fingerprint.h"

#include "core/experiment/report/fingerprint.h"
#include "core/experiment/studies/people_study.h"

#include <algorithm>

namespace dewpoint::experiment {
namespace {

constexpr const char* kScenario = "crossing";
// Steps of what is compared: coarser than rounding, finer than a change of a method.
constexpr double kShareStep = 0.001; // of probabilities
constexpr double kMeterStep = 1e-4;  // m
constexpr double kVolumeStep = 1e-4; // m³

void add(const PeopleTrial& trial, Fingerprint& fingerprint) {
  fingerprint.add(trial.hasKeptIdentities ? "kept" : "not kept");
  fingerprint.add(trial.identitySwitches, 1.0);
  const PersonResult& allPersonsResult = trial.allPersonsResult;
  for (const double share :
       {trial.mota, trial.hota, trial.longestGhostSeconds, trial.longestMissedSeconds,
        allPersonsResult.found, allPersonsResult.silhouette.recall,
        allPersonsResult.silhouette.precision}) {
    fingerprint.add(share, kShareStep);
  }
  fingerprint.add(trial.motp, kMeterStep);
  fingerprint.add(trial.gospa, kMeterStep);
  fingerprint.add(trial.hullVolume, kVolumeStep);
}

} // namespace

Result<std::map<std::string, std::string>>
peopleFingerprints(const std::vector<std::string>& methods) {
  PeopleStudySetup setup;
  for (const std::string& method : methods) {
    if (std::ranges::find(setup.methods, method) == setup.methods.end()) {
      return failure(ErrorCode::NotFound, "", "--method", method);
    }
  }
  setup.scenario = kScenario;
  setup.clothes = PeopleClothes::Similar;
  if (!methods.empty()) {
    setup.methods = methods;
  }
  simulation::ViewCache views;
  std::map<std::string, Fingerprint> fingerprints;
  for (const Grade grade : {Grade::Ideal, Grade::Room}) {
    setup.grade = grade;
    const auto trials = studyPeople(setup, views);
    if (!trials) {
      return tl::make_unexpected(trials.error());
    }
    for (const PeopleTrial& trial : *trials) {
      add(trial, fingerprints[trial.method]);
    }
  }
  std::map<std::string, std::string> texts;
  for (const auto& [method, fingerprint] : fingerprints) {
    texts[method] = fingerprint.text();
  }
  return texts;
}

} // namespace dewpoint::experiment
