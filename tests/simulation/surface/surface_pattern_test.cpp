// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/simulation/surface/solid.h"
#include "core/simulation/surface/surface_pattern.h"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

namespace dewpoint::tests {
namespace {

using namespace dewpoint::simulation;

const Vector3f kPlain{200.0F, 60.0F, 80.0F};
const Vector3f kWhite{250.0F, 250.0F, 250.0F};
const Vector3f kBlack{5.0F, 5.0F, 5.0F};

/// A unit vector at an angle (degrees) from Z, toward X.
Vector3f tilted(float degrees) {
  const float angle = degrees * std::numbers::pi_v<float> / 180.0F;
  return {std::sin(angle), 0.0F, std::cos(angle)};
}

TEST(SurfacePattern, APatchEndsAtItsAngle) {
  SurfacePattern pattern;
  pattern.patches = {{Vector3f::UnitZ(), std::cos(0.5236F), kWhite}}; // 30 degrees
  EXPECT_EQ(pattern.colorAt(tilted(0.0F), kPlain), kWhite);
  EXPECT_EQ(pattern.colorAt(tilted(29.0F), kPlain), kWhite);
  EXPECT_EQ(pattern.colorAt(tilted(31.0F), kPlain), kPlain);
  EXPECT_EQ(pattern.colorAt(tilted(180.0F), kPlain), kPlain);
}

TEST(SurfacePattern, ASeamRunsAroundAndPatchesLieOverIt) {
  SurfacePattern pattern;
  pattern.seams = {{Vector3f::UnitX(), std::sin(0.0873F), kBlack}}; // 5 degrees about X = 0
  EXPECT_EQ(pattern.colorAt(tilted(0.0F), kPlain), kBlack);
  EXPECT_EQ(pattern.colorAt(tilted(180.0F), kPlain), kBlack);
  EXPECT_EQ(pattern.colorAt(Vector3f::UnitY(), kPlain), kBlack);
  EXPECT_EQ(pattern.colorAt(tilted(6.0F), kPlain), kPlain);
  pattern.patches = {{Vector3f::UnitZ(), 0.9F, kWhite}, {Vector3f::UnitZ(), 0.5F, kPlain}};
  EXPECT_EQ(pattern.colorAt(tilted(0.0F), kPlain), kWhite) << "the first patch over the others";
}

TEST(Gloss, IsBrightestWhereTheSurfaceMirrorsTheLamp) {
  const Gloss gloss{100.0F, 12.0F};
  const Vector3f looking = -Vector3f::UnitZ(); // from above
  EXPECT_NEAR(gloss.highlightAt(Vector3f::UnitZ(), Vector3f::UnitZ(), looking), 100.0F, 1e-4F);
  // A lamp 60 degrees aside: the half way is 30 degrees off, cos^12 of it is (3/4)^6.
  EXPECT_NEAR(gloss.highlightAt(Vector3f::UnitZ(), tilted(60.0F), looking), 100.0F * 0.17798F,
              1e-2F);
  EXPECT_EQ(gloss.highlightAt(-Vector3f::UnitZ(), Vector3f::UnitZ(), looking), 0.0F)
      << "turned away";
  EXPECT_EQ(Gloss{}.highlightAt(Vector3f::UnitZ(), Vector3f::UnitZ(), looking), 0.0F);
}

TEST(Solid, ItsAxesAreRotatedAboutTheVertical) {
  const Solid box = makeSolid(Shape::Box, {1.0F, 2.0F, 3.0F}, {0.3F, 0.2F, 0.1F}, {},
                              0.5F * std::numbers::pi_v<float>);
  EXPECT_LT((toWorld(box, Vector3f::UnitX()) - Vector3f::UnitY()).norm(), 1e-6F);
  EXPECT_LT((toSolidFrame(box, Vector3f::UnitY()) - Vector3f::UnitX()).norm(), 1e-6F);
  const Vector3f any{0.3F, -0.7F, 0.2F};
  EXPECT_LT((toSolidFrame(box, toWorld(box, any)) - any).norm(), 1e-6F);
  EXPECT_GE(box.boundingRadius, box.halfSize.norm() - 1e-6F)
      << "the corners lie in the sphere around it";
}

} // namespace
} // namespace dewpoint::tests
