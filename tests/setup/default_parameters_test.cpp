// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/setup/default_parameters.h"
#include "core/tracking/catalog/method_catalog.h"
#include "tests/observation/drawn_spheres.h"

#include <gtest/gtest.h>

#include <algorithm>

namespace dewpoint::tests {
namespace {

/// A project of three cameras that see a common volume, with nothing given.
Project threeCameras() {
  Project project;
  project.parameters = ParameterValues(methodParameters(project.method));
  for (const Camera& camera : drawn::rigAround(3)) {
    project.cameras.push_back({camera, SourceKind::Video, "video"});
  }
  return project;
}

const ParameterDeclaration& declarationOf(const Project& project, std::string_view key) {
  return *std::ranges::find(project.parameters.declarations(), key, &ParameterDeclaration::key);
}

bool isChangedIn(const Project& project, std::string_view key) {
  return isChanged(effectiveParameters(project), defaultParameters(project),
                   declarationOf(project, key));
}

TEST(DefaultParameters, NothingIsChangedAtFirst) {
  const Project project = threeCameras();
  EXPECT_EQ(defaultParameters(project), effectiveParameters(project));
  for (const ParameterDeclaration& declaration : project.parameters.declarations()) {
    EXPECT_FALSE(isChangedIn(project, declaration.key)) << declaration.key;
  }
}

TEST(DefaultParameters, AChangedOneIsReset) {
  Project project = threeCameras();
  const Project before = project;
  ASSERT_TRUE(project.parameters.set("particles", 300.0));
  ASSERT_TRUE(project.parameters.set("survival_time", 2.0));
  EXPECT_TRUE(isChangedIn(project, "particles"));
  resetParameter(project, "particles");
  EXPECT_FALSE(isChangedIn(project, "particles"));
  EXPECT_TRUE(isChangedIn(project, "survival_time")); // by itself
  resetParameter(project, "survival_time");
  EXPECT_EQ(project, before);
}

TEST(DefaultParameters, WhatComesFromTheCamerasGoesBackToThem) {
  Project project = threeCameras();
  const Project before = project;
  project.parameters = effectiveParameters(project);
  project.parameters.markAllAsGiven(); // as the window gives all of them with the first
  ASSERT_TRUE(project.parameters.set("start_x", 7.0));
  ASSERT_TRUE(project.parameters.set("start_y", 8.0));
  EXPECT_TRUE(isChangedIn(project, "start_x"));
  EXPECT_FALSE(isChangedIn(project, "start_z")); // given, but as the cameras say
  resetParameter(project, "start_x");
  EXPECT_EQ(project.parameters.at("start_x"), effectiveParameters(before).at("start_x"));
  EXPECT_EQ(project.parameters.at("start_y"), 8.0);
  EXPECT_TRUE(project.parameters.isGiven("start_x"));
  resetParameter(project, "start_y");
  EXPECT_EQ(project, before); // nothing is given any more
}

TEST(DefaultParameters, AGivenDefaultIsNoChange) {
  Project project = threeCameras();
  project.parameters.markAllAsGiven(); // the method's own, which are not what these cameras see
  ASSERT_NE(defaultParameters(project).at("start_x"), project.parameters.at("start_x"));
  EXPECT_FALSE(isChangedIn(project, "start_x"));
}

TEST(DefaultParameters, AllThatAreChangedAreResetAtOnce) {
  Project project = threeCameras();
  project.parameters.markAllAsGiven();
  const Project before = project;
  ASSERT_TRUE(project.parameters.set("particles", 300.0));
  ASSERT_TRUE(project.parameters.set("kld_error", 0.3));
  resetParameters(project);
  EXPECT_EQ(project, before); // what was given and not changed stays given
}

} // namespace
} // namespace dewpoint::tests
