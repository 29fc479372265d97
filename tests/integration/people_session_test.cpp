// SPDX-License-Identifier: GPL-3.0-or-later
// Methods for people in a session: targets that come and go.
#include "core/session/people/people_writer.h"
#include "core/session/run/tracking_run.h"
#include "core/session/session.h"
#include "core/tracking/catalog/method_catalog.h"
#include "core/tracking/people/people_parameters.h"
#include "core/tracking/tracker_capabilities.h"
#include "tests/integration/office_recording.h"
#include "tests/session/fake_recording.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <filesystem>

namespace dewpoint::tests {
namespace {

using test::eventually;
using test::OfficeRecording;
using test::reaches;

/// By then both of the first two visitors of the office are well inside.
constexpr std::int64_t kFrames = 90;

Project officeProject(const std::string& method = "people") {
  Project project;
  project.name = "office";
  project.method = method;
  project.parameters = ParameterValues(methodParameters(method));
  for (const Camera& camera : officeRig()) {
    project.cameras.push_back({camera, SourceKind::Simulation, "", 0});
  }
  return project;
}

SessionInputs office(Project project = officeProject(), std::int64_t frames = kFrames) {
  SessionInputs inputs;
  inputs.project = std::move(project);
  inputs.source = std::make_unique<OfficeRecording>(frames);
  return inputs;
}

void playThrough(Session& session) {
  session.play();
  ASSERT_TRUE(reaches(session, PlayState::Ended));
}

/// What the tracker says without any session: as the command line drives it.
Trajectory trackedAlone(const Project& project, std::int64_t frames = kFrames) {
  auto tracker = makeTracker(project.method, project.parameters, officeRig(), {}).value();
  tracker->restart(project.seed);
  OfficeRecording source(frames);
  ThreadTeam team(1);
  Trajectory trajectory;
  for (auto set = source.next(); *set; set = source.next()) {
    tracker->beginFrame(*set);
    tracker->iterate(team);
    for (const PersonEstimate& person : capability<PeopleFinding>(*tracker)->people()) {
      trajectory.samples.push_back(sampleOf(person, (*set)->index, seconds((*set)->time)));
    }
  }
  return trajectory;
}

int present(const TrackSnapshot& snapshot) {
  return static_cast<int>(std::ranges::count_if(
      snapshot.targets, [](const auto& target) { return target.person() != nullptr; }));
}

TEST(PeopleSession, TracksAsTheCommandLineDoes) {
  Session session(office());
  session.setBodyShapesShown(true);
  playThrough(session);
  const TrackSnapshotPtr last = session.newest();
  EXPECT_EQ(last->family.targetSource, TargetSource::Images);
  ASSERT_EQ(last->targets.size(), 2U); // both are inside by frame 90
  EXPECT_EQ(last->targets[0].target.name, "person 1");
  EXPECT_EQ(last->targets[1].target.name, "person 2");
  for (const TargetSnapshot& target : last->targets) {
    EXPECT_EQ(target.status, TargetStatus::Held);
    ASSERT_NE(target.person(), nullptr);
    EXPECT_GT(target.particles.rows(), 100);
    ASSERT_TRUE(target.shape);
    // A body has some 0.07 m³; its hull, legs and all, not more than a box of 0.8 x 0.8 x 1.8 m.
    EXPECT_GT(target.shape->volume, 0.03);
    EXPECT_LT(target.shape->volume, 1.15);
    ASSERT_EQ(target.shape->groundCurves.size(), std::size(kGroundProbabilities));
    EXPECT_FALSE(target.shape->groundCurves.back().empty());
  }
  ASSERT_EQ(last->peopleCameras.size(), 4U);
  EXPECT_EQ(last->peopleCameras[0].learningProgress, 1.0);
  EXPECT_TRUE(test::sameBits(session.trajectory(), trackedAlone(officeProject())));
}

TEST(PeopleSession, TellsHowFarTheRoomIsLearned) {
  Session session(office());
  session.stepFrame();
  ASSERT_TRUE(eventually([&] { return session.newest()->isTracked; }));
  for (int k = 0; k < 6; ++k) {
    session.stepFrame();
  }
  ASSERT_TRUE(eventually([&] { return session.newest()->frame == 6; }));
  const TrackSnapshotPtr shown = session.newest();
  // 6 frames at 15 per second, of the second that learning takes.
  ASSERT_EQ(shown->peopleCameras.size(), 4U);
  EXPECT_NEAR(shown->peopleCameras[2].learningProgress, 6.0 / 15.0, 1e-6);
  EXPECT_TRUE(shown->targets.empty());
}

TEST(PeopleSession, KnowsTheBackgroundImageWithoutLearning) {
  Session session(office());
  simulation::ViewCache views;
  const OfficeRenderer renderer(builtInOfficeScene(), views);
  std::vector<cv::Mat> rooms;
  for (std::size_t k = 0; k < 4; ++k) {
    rooms.push_back(renderer.backgroundImage(k));
  }
  session.setBackgroundImages({"", "", "", ""}, rooms);
  session.restart();
  session.stepFrame();
  ASSERT_TRUE(eventually([&] { return session.newest()->isTracked; }));
  EXPECT_EQ(session.newest()->peopleCameras.at(0).learningProgress, 1.0);
}

TEST(PeopleSession, ShowsThePeopleOfThen) {
  Session session(office());
  session.setBodyShapesShown(true);
  session.setMasksShown(true);
  session.setLikelihoodMapsShown(true);
  playThrough(session);
  const Trajectory all = session.trajectory();
  session.showFrame(70);
  ASSERT_TRUE(eventually(
      [&] { return session.newest()->frame == 70 && !session.newest()->masks.empty(); }));
  TrackSnapshotPtr then = session.newest();
  EXPECT_TRUE(then->isPast);
  ASSERT_EQ(then->targets.size(), 2U); // as many rows as the run has, whoever was there
  const auto sample = std::ranges::find_if(
      all.samples, [](const auto& one) { return one.frame == 70 && one.target == "person 1"; });
  ASSERT_NE(sample, all.samples.end());
  EXPECT_EQ(positionOf(then->targets[0].estimate)->mean, sample->position);
  EXPECT_TRUE(then->targets[0].shape);
  ASSERT_EQ(then->masks.size(), 4U);
  EXPECT_EQ(then->masks[0].size(), cv::Size(320, 240));
  EXPECT_GT(cv::countNonZero(then->masks[0]) + cv::countNonZero(then->masks[1]), 200);
  ASSERT_EQ(then->motionMaps.size(), 4U);
  const LikelihoodMap& map = then->motionMaps[0]; // in the size of the image, as the mask
  EXPECT_EQ(map.area, cv::Rect(0, 0, 320, 240));
  EXPECT_EQ(map.logLikelihood.size(), cv::Size(320, 240));
  EXPECT_NEAR(map.minLogLikelihood, std::log(0.2), 1e-12); // p_B
  session.showFrame(3);                                    // nobody yet
  ASSERT_TRUE(eventually([&] { return session.newest()->frame == 3; }));
  then = session.newest();
  EXPECT_EQ(present(*then), 0);
  ASSERT_EQ(then->targets.size(), 2U);
  EXPECT_EQ(then->targets[1].status, TargetStatus::Gone);
}

TEST(PeopleSession, TracksAgainWithTheSameBits) {
  for (const std::string& method :
       methodNames(TargetSource::Images)) { // two of them cannot be copied
    Session session(office(officeProject(method)));
    playThrough(session);
    const Trajectory first = session.trajectory();
    ASSERT_FALSE(first.samples.empty()) << method;
    session.rerunFrom(65);
    ASSERT_TRUE(eventually([&] {
      return !session.newest()->rerun && session.newest()->state == PlayState::Ended &&
             session.newest()->frame == kFrames - 1;
    }));
    EXPECT_TRUE(test::sameBits(first, session.trajectory())) << method;
  }
}

TEST(PeopleSession, TakesOtherMethodsAndBack) {
  Session session(office());
  playThrough(session);
  const Trajectory first = session.trajectory();
  session.setMethod("barrera", ParameterValues(methodParameters("barrera")));
  ASSERT_TRUE(
      eventually([&] { return session.newest()->family.targetSource != TargetSource::Images; }));
  EXPECT_TRUE(session.newest()->targets.empty()); // the project has none
  const Project again = officeProject();
  session.setMethod(again.method, again.parameters);
  ASSERT_TRUE(
      eventually([&] { return session.newest()->family.targetSource == TargetSource::Images; }));
  playThrough(session);
  EXPECT_TRUE(test::sameBits(first, session.trajectory()));
}

TEST(PeopleSession, PeopleArePlacedAndTakenAway) {
  Project project = officeProject();
  ASSERT_TRUE(project.parameters.set("births", 0.0));
  Session session(office(project));
  playThrough(session);
  EXPECT_EQ(session.newest()->targets.size(), 0U);
  // Where the first visitor truly is at frame 80, and the second one's image in camera 1.
  simulation::ViewCache views;
  const OfficeRenderer renderer(builtInOfficeScene(), views);
  const double time = builtInOfficeScene().timeOf(80);
  session.showFrame(80);
  ASSERT_TRUE(eventually([&] { return session.newest()->frame == 80; }));
  std::vector<PersonCorrection> said;
  said.push_back({.frame = 80, .position = renderer.bodyCenter(0, time).head<2>()});
  session.setPersonCorrections(said);
  ASSERT_TRUE(eventually([&] {
    return present(*session.newest()) == 1 && session.newest()->frame == 80 &&
           session.newest()->history.newestTrackedFrame == kFrames - 1 && !session.newest()->rerun;
  }));
  session.showFrame(kFrames - 1);
  ASSERT_TRUE(eventually([&] { return session.newest()->frame == kFrames - 1; }));
  EXPECT_EQ(session.newest()->targets.at(0).status, TargetStatus::Held);
  const double now = builtInOfficeScene().timeOf(kFrames - 1);
  const auto pixel = Projector(officeRig()[0]).project(renderer.bodyCenter(1, now));
  ASSERT_TRUE(pixel);
  const auto clicked = [&](const Eigen::Vector2d& where) {
    said.push_back({.frame = kFrames - 1, .click = PersonCorrection::Click{0, where}});
    session.setPersonCorrections(said);
  };
  clicked(*pixel);
  ASSERT_TRUE(eventually([&] { return present(*session.newest()) == 2; }));
  const Eigen::Vector3d placed = positionOf(session.newest()->targets.at(1).estimate)->mean;
  EXPECT_LT((placed - renderer.bodyCenter(1, now)).head<2>().norm(), 0.3); // of 0.1 m steps
  clicked({0.0, 0.0}); // a corner of the ceiling: nobody is there, which is said
  ASSERT_TRUE(eventually([&] { return session.newest()->notices.size() == 1; }));
  EXPECT_EQ(session.newest()->notices.front().field, officeRig()[0].name);
  EXPECT_EQ(present(*session.newest()), 2);
  said.push_back({.frame = kFrames - 1, .position = Eigen::Vector2d(50.0, 0.0)}); // another house
  session.setPersonCorrections(said);
  ASSERT_TRUE(eventually([&] { return session.newest()->notices.size() == 2; }));
  EXPECT_EQ(present(*session.newest()), 2);
  const auto firstPlace = [&] {
    return Eigen::Vector2d(positionOf(session.newest()->targets.at(0).estimate)->mean.head<2>());
  };
  const Eigen::Vector2d first = firstPlace();
  said.push_back({.frame = kFrames - 1, .position = first, .isPresent = false});
  session.setPersonCorrections(said);
  ASSERT_TRUE(eventually([&] { return present(*session.newest()) == 1; }));
  EXPECT_EQ(session.newest()->targets.at(0).status, TargetStatus::Gone); // and not lost
  // Whatever was said can be taken back: the run is what it would have been without.
  said.pop_back();
  session.setPersonCorrections(said);
  ASSERT_TRUE(eventually([&] { return present(*session.newest()) == 2; }));
  EXPECT_EQ(firstPlace(), first);
  session.setPersonCorrections({});
  ASSERT_TRUE(eventually([&] {
    return present(*session.newest()) == 0 &&
           session.newest()->history.newestTrackedFrame == kFrames - 1 && !session.newest()->rerun;
  }));
}

TEST(PeopleSession, SomebodyPutWhereNobodyIsGoesAgain) {
  Project project = officeProject();
  ASSERT_TRUE(project.parameters.set("births", 0.0));
  const PeopleArea area = peopleSettings(project.parameters).area;
  constexpr std::int64_t kPlaced = 30;
  for (const double x : {0.0, 0.4}) { // the first visitor enters on the other side
    for (const double y : {-0.4, 0.0, 0.4}) {
      project.personCorrections = {
          {.frame = kPlaced,
           .position = area.center + area.halfSize.cwiseProduct(Eigen::Vector2d(x, y))}};
      Session session(office(project));
      playThrough(session);
      std::int64_t last = -1;
      for (const TrajectorySample& sample : session.trajectory().samples) {
        last = std::max(last, sample.frame);
        EXPECT_LT(sample.existenceProbability, sample.frame > kPlaced + 5 ? 0.5 : 1.01);
      }
      EXPECT_GE(last, kPlaced) << x << ' ' << y;
      EXPECT_LT(last, kPlaced + 15) << x << ' ' << y;
    }
  }
}

TEST(PeopleSession, WhatTheProjectSaysOfPeopleComesTrueInItsFrame) {
  Project project = officeProject();
  ASSERT_TRUE(project.parameters.set("births", 0.0));
  simulation::ViewCache views;
  const OfficeRenderer renderer(builtInOfficeScene(), views);
  const double time = builtInOfficeScene().timeOf(80);
  project.personCorrections.push_back(
      {.frame = 80, .position = renderer.bodyCenter(0, time).head<2>()});
  Session session(office(project));
  playThrough(session);
  EXPECT_EQ(present(*session.newest()), 1);
  session.showFrame(79);
  ASSERT_TRUE(eventually([&] { return session.newest()->frame == 79; }));
  EXPECT_EQ(present(*session.newest()), 0);
  session.showFrame(80);
  ASSERT_TRUE(eventually([&] { return session.newest()->frame == 80; }));
  EXPECT_EQ(present(*session.newest()), 1);
}

TEST(PeopleSession, AnotherMethodWhileLookingBackLearnsTheRoomFromTheBeginning) {
  Session session(office());
  playThrough(session);
  const Trajectory first = session.trajectory();
  session.showFrame(65); // people are there
  ASSERT_TRUE(eventually([&] { return session.newest()->frame == 65; }));
  const auto changed = [&](const Project& project, bool people) {
    session.setMethodFrom(65, project.method, project.parameters);
    return eventually([&] {
      const auto snapshot = session.newest();
      return (snapshot->family.targetSource == TargetSource::Images) == people &&
             !snapshot->rerun && snapshot->frame == 65 &&
             snapshot->isPast; // the moment that was looked at is shown again
    });
  };
  Project other = officeProject();
  other.method = "barrera";
  other.parameters = ParameterValues(methodParameters(other.method));
  ASSERT_TRUE(changed(other, false));
  ASSERT_TRUE(changed(officeProject(), true));
  EXPECT_TRUE(test::sameBits(first, session.trajectory()));
}

TEST(PeopleSession, KnowsHowTallPeopleAre) {
  Session session(office());
  playThrough(session);
  simulation::ViewCache views;
  const OfficeRenderer renderer(builtInOfficeScene(), views);
  int compared = 0;
  const TrackSnapshotPtr newest = session.newest();
  for (const TargetSnapshot& target : newest->targets) {
    for (std::size_t k = 0; target.person() != nullptr && k < renderer.scene().people.size(); ++k) {
      const Eigen::Vector3d truth =
          renderer.bodyCenter(k, builtInOfficeScene().timeOf(kFrames - 1));
      if ((truth - target.person()->position).head<2>().norm() < 0.2) {
        // Seen by four cameras of 320x240 from 5 m: a pixel is 0.02 m.
        EXPECT_NEAR(target.person()->height, renderer.scene().people[k].height, 0.08) << k;
        ++compared;
      }
    }
  }
  EXPECT_GE(compared, 1);
}

TEST(PeopleSession, SavesVolumesHullsAndDensities) {
  Session session(office(officeProject(), 75));
  playThrough(session);
  const auto folder = std::filesystem::path(testing::TempDir()) / "people_session";
  std::filesystem::remove_all(folder);
  ASSERT_TRUE(session.saveRun(folder));
  for (const char* file :
       {"trajectory.csv", "run.json", "volumes.csv", "hulls.csv", "ground.csv"}) {
    EXPECT_GT(std::filesystem::file_size(folder / file), 200U) << file;
  }
}

TEST(PeopleTracks, LeaveGapsAndForgetNobody) {
  const Project project = officeProject();
  auto tracker = makeTracker("people", project.parameters, officeRig(), {}).value();
  tracker->restart(1);
  auto* const placing = capability<PersonEditing>(*tracker);
  const auto* const finding = capability<PeopleFinding>(*tracker);
  ASSERT_TRUE(placing != nullptr && finding != nullptr);
  EXPECT_EQ(placing->addPerson({0.0, 0.0, 0.86}), 1);
  EXPECT_EQ(placing->addPerson({1.0, 0.0, 0.86}), 2);
  placing->removePerson(1);
  ASSERT_EQ(tracker->trackCount(), 2U);
  EXPECT_TRUE(isAbsent(tracker->estimate(0)));
  EXPECT_FALSE(isAbsent(tracker->estimate(1)));
  EXPECT_EQ(finding->peopleAsTargets()[0].name, "person 1");
  EXPECT_EQ(placing->addPerson({1.0, 1.0, 0.86}), 3); // never given twice
}

TEST(PeopleNames, AreReadAsTheyAreWritten) {
  EXPECT_EQ(identityFromName(personName(12)), 12);
  for (const char* other : {"person", "person 0", "person -1", "person 1b", "ball", ""}) {
    EXPECT_EQ(identityFromName(other), std::nullopt) << other;
  }
}

} // namespace
} // namespace dewpoint::tests
