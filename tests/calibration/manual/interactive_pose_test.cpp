// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/base/random.h"
#include "core/calibration/manual/interactive_pose.h"
#include "core/calibration/manual/point_drag.h"

#include <gtest/gtest.h>

#include <numbers>

namespace dewpoint::tests {
namespace {

/// Uniform numbers for the properties; the seed names the case.
class Draw {
public:
  explicit Draw(std::uint64_t seed) : stream_(seed, 0, 0, RandomPurpose::Start) {}
  double between(double low, double high) {
    return low + (high - low) * stream_.uniform3(next_++)[0];
  }
  Eigen::Vector3d point() { return {between(-1, 1), between(-1, 1), between(0, 1)}; }

private:
  RandomStream stream_;
  std::uint32_t next_ = 0;
};

Camera someCamera(Draw& draw, bool bent) {
  Camera camera;
  camera.intrinsics = {640, 480, 520.0, 515.0, 322.0, 236.0};
  if (bent) {
    camera.distortion = {-0.18, 0.05, 0.001, -0.0012, 0.0};
  }
  camera.cameraFromWorld = lookAt(
      {draw.between(-2, 2), draw.between(-4, -3), draw.between(1.5, 2.5)},
      {draw.between(-0.3, 0.3), draw.between(-0.3, 0.3), 0.3}, {0, 0, 1}, draw.between(-0.3, 0.3));
  return camera;
}

ImageAnchor seenBy(const Camera& camera, const Eigen::Vector3d& world) {
  return {world, Projector(camera).project(world).value()};
}

double missAt(const Camera& camera, const ImageAnchor& anchor) {
  return (Projector(camera).project(anchor.world).value() - anchor.pixel).norm();
}

double poseDifference(const Camera& a, const Camera& b) {
  return (a.cameraFromWorld.matrix() - b.cameraFromWorld.matrix()).cwiseAbs().maxCoeff();
}

class Drags : public testing::TestWithParam<int> {};

TEST_P(Drags, ThePointFollowsHeldPointsStayAndTheWayBackLeadsBack) {
  const int heldCount = GetParam();
  int reached = 0;
  for (std::uint64_t seed = 1; seed <= 40; ++seed) {
    Draw draw(seed);
    const Camera camera = someCamera(draw, seed % 2 == 0);
    std::vector<ImageAnchor> held;
    for (int k = 0; k < heldCount; ++k) {
      held.push_back(seenBy(camera, draw.point()));
    }
    ImageAnchor dragged = seenBy(camera, draw.point());
    const Eigen::Vector2d from = dragged.pixel;
    dragged.pixel += Eigen::Vector2d(draw.between(-30, 30), draw.between(-30, 30));
    for (const DragMode mode : {DragMode::Turn, DragMode::Slide}) {
      const DragResult drag = dragPoint(camera, held, dragged, {mode, false});
      for (const ImageAnchor& anchor : held) {
        EXPECT_LT(missAt(drag.camera, anchor), 1e-6) << "seed " << seed;
      }
      if (drag.limit != DragLimit::None) {
        continue; // points too near to each other: said, and nothing jumped
      }
      ++reached;
      EXPECT_LT(drag.distanceToRequestedPx, 1e-6) << "seed " << seed;
      const DragResult back = dragPoint(drag.camera, held, {dragged.world, from}, {mode, false});
      const bool isUnique = heldCount != 1 || mode == DragMode::Turn;
      if (back.limit == DragLimit::None && isUnique) {
        EXPECT_LT(poseDifference(back.camera, camera), 1e-6) << "seed " << seed;
      }
      if (heldCount == 0) {
        const double moved = (drag.camera.center() - camera.center()).norm();
        EXPECT_TRUE(mode == DragMode::Slide || moved < 1e-12);
        EXPECT_TRUE(mode == DragMode::Turn ||
                    (drag.camera.opticalAxis() - camera.opticalAxis()).norm() < 1e-12);
      }
    }
  }
  EXPECT_GE(reached, heldCount == 2 ? 60 : 76); // of 80
}

INSTANTIATE_TEST_SUITE_P(Held, Drags, testing::Values(0, 1, 2));

TEST(InteractivePose, ASmallDragIsASmallChangeEverywhere) {
  // No jump: a pixel of the mouse moves the camera by no more than the geometry asks for.
  for (std::uint64_t seed = 1; seed <= 30; ++seed) {
    Draw draw(seed);
    const Camera start = someCamera(draw, true);
    const std::vector<ImageAnchor> held{seenBy(start, draw.point()), seenBy(start, draw.point())};
    ImageAnchor dragged = seenBy(start, draw.point());
    Camera before = start;
    for (int k = 0; k < 60; ++k) {
      dragged.pixel += Eigen::Vector2d(1.0, 0.4);
      const DragResult drag = dragPoint(start, held, dragged, {});
      EXPECT_LT(poseDifference(drag.camera, before), 0.6) << "seed " << seed << " step " << k;
      before = drag.camera;
    }
  }
}

TEST(InteractivePose, ADragBackToItsBeginningChangesNothing) {
  Draw draw(3);
  const Camera camera = someCamera(draw, true);
  const std::vector<ImageAnchor> held{seenBy(camera, draw.point()), seenBy(camera, draw.point())};
  const DragResult drag = dragPoint(camera, held, seenBy(camera, draw.point()), {});
  EXPECT_TRUE(drag.camera == camera) << "to the bit";
}

TEST(InteractivePose, OneHeldPointRollsAndMovesAlongItsRay) {
  Draw draw(5);
  const Camera camera = someCamera(draw, false);
  const ImageAnchor held = seenBy(camera, {0.2, 0.1, 0.3});
  ImageAnchor dragged = seenBy(camera, {-0.5, 0.4, 0.0});
  dragged.pixel += Eigen::Vector2d(14.0, -9.0);
  const DragResult drag = dragPoint(camera, {held}, dragged, {});
  ASSERT_EQ(drag.limit, DragLimit::None);
  const Eigen::Vector3d ray = (held.world - camera.center()).normalized();
  const Eigen::Vector3d moved = drag.camera.center() - camera.center();
  EXPECT_LT(moved.cross(ray).norm(), 1e-7) << "along the ray of the held point";
  EXPECT_LT(((held.world - drag.camera.center()).normalized() - ray).norm(), 1e-7);
}

TEST(InteractivePose, ThreeHeldPointsLeaveTheFocalLengthOnly) {
  int nearer = 0;
  for (std::uint64_t seed = 1; seed <= 20; ++seed) {
    Draw draw(seed);
    const Camera camera = someCamera(draw, seed % 2 == 0);
    const std::vector<ImageAnchor> held{seenBy(camera, draw.point()), seenBy(camera, draw.point()),
                                        seenBy(camera, draw.point())};
    ImageAnchor dragged = seenBy(camera, draw.point());
    dragged.pixel += Eigen::Vector2d(6.0, 4.0);
    EXPECT_EQ(dragPoint(camera, held, dragged, {}).limit, DragLimit::Fixed);
    EXPECT_TRUE(dragPoint(camera, held, dragged, {}).camera == camera);
    const DragResult drag = dragPoint(camera, held, dragged, {DragMode::Turn, true});
    for (const ImageAnchor& anchor : held) {
      EXPECT_LT(missAt(drag.camera, anchor), 1e-6) << "seed " << seed;
    }
    EXPECT_LT(drag.distanceToRequestedPx, Eigen::Vector2d(6.0, 4.0).norm() + 1e-9)
        << "seed " << seed;
    nearer += drag.camera.intrinsics.focalX != camera.intrinsics.focalX ? 1 : 0;
  }
  EXPECT_GE(nearer, 15);
}

TEST(InteractivePose, RefusesWithAReason) {
  Draw draw(7);
  const Camera camera = someCamera(draw, false);
  const ImageAnchor held = seenBy(camera, {0.0, 0.0, 0.2});
  // The dragged point behind the held one, on its ray: nothing that holds one moves the other.
  ImageAnchor behind = seenBy(camera, held.world + 0.4 * (held.world - camera.center()));
  behind.pixel.x() += 20.0;
  const DragResult same = dragPoint(camera, {held}, behind, {});
  EXPECT_NE(same.limit, DragLimit::None);
  EXPECT_LT(poseDifference(same.camera, camera), 1e-3);
  const ImageAnchor unseen{camera.center() - camera.opticalAxis(), {100.0, 100.0}};
  EXPECT_EQ(dragPoint(camera, {}, unseen, {}).limit, DragLimit::OutOfSight);
  EXPECT_EQ(dragPoint(camera, {held}, unseen, {}).limit, DragLimit::OutOfSight);
  EXPECT_TRUE(dragPoint(camera, {held}, unseen, {}).camera == camera);
  // Two held points 1 m apart, a third dragged to the far side of the image.
  const ImageAnchor other = seenBy(camera, {0.8, 0.3, 0.0});
  ImageAnchor far = seenBy(camera, {-0.5, 0.2, 0.4});
  far.pixel = {630.0, 5.0};
  const DragResult stopped = dragPoint(camera, {held, other}, far, {});
  EXPECT_LT(missAt(stopped.camera, held), 1e-6);
  EXPECT_LT(missAt(stopped.camera, other), 1e-6);
  EXPECT_TRUE(stopped.limit != DragLimit::None || stopped.distanceToRequestedPx < 1e-6);
}

TEST(InteractivePose, DerivativesAreThoseOfTheProjection) {
  Draw draw(11);
  const Camera camera = someCamera(draw, true);
  const std::vector<ImageAnchor> anchors{seenBy(camera, draw.point())};
  const CameraVariation change(camera, 2.0);
  const auto jacobian = change.jacobian(ChangeVector::Zero(), anchors);
  ASSERT_TRUE(jacobian);
  for (int k = 0; k < 7; ++k) {
    ChangeVector step = ChangeVector::Zero();
    step[k] = 1e-4;
    // The changed camera itself, projected by Projector: another path than
    // CameraVariation::projectedPixel().
    const Eigen::Vector2d moved =
        Projector(change.changedCamera(step)).project(anchors[0].world).value() - anchors[0].pixel;
    EXPECT_LT((moved - 1e-4 * jacobian->col(k)).norm(), 2e-4 * 1e-4 * 520.0 * 10) << k;
  }
}

TEST(Nudges, AreUndoneByTheirInverse) {
  for (std::uint64_t seed = 1; seed <= 10; ++seed) {
    Draw draw(seed);
    const Camera camera = someCamera(draw, true);
    const Eigen::Vector3d step = 0.1 * draw.point();
    for (const NudgeFrame frame : {NudgeFrame::Camera, NudgeFrame::World}) {
      EXPECT_LT(poseDifference(moved(moved(camera, step, frame), -step, frame), camera), 1e-14);
      EXPECT_LT(poseDifference(rotated(rotated(camera, step, frame), -step, frame), camera), 1e-14);
    }
    EXPECT_NEAR(zoomed(zoomed(camera, 1.25), 0.8).intrinsics.focalX, 520.0, 1e-12);
  }
}

TEST(Nudges, GoAlongTheAxesTheyName) {
  Draw draw(2);
  const Camera camera = someCamera(draw, false);
  const Eigen::Vector3d world = moved(camera, {0.01, 0, 0}, NudgeFrame::World).center();
  EXPECT_LT((world - camera.center() - Eigen::Vector3d(0.01, 0, 0)).norm(), 1e-14);
  const Eigen::Vector3d ahead = moved(camera, {0, 0, 0.01}, NudgeFrame::Camera).center();
  EXPECT_LT((ahead - camera.center() - 0.01 * camera.opticalAxis()).norm(), 1e-14);
  // About the vertical, counterclockwise: the heading grows, pitch and roll stay.
  const Heading before = headingOf(camera);
  const Camera other = rotated(camera, {0, 0, 0.02}, NudgeFrame::World);
  EXPECT_NEAR(headingOf(other).yaw, before.yaw + 0.02, 1e-12);
  EXPECT_NEAR(headingOf(other).pitch, before.pitch, 1e-12);
  EXPECT_NEAR(headingOf(other).roll, before.roll, 1e-12);
  EXPECT_LT((other.center() - camera.center()).norm(), 1e-12);
  // About its own axis: only the roll.
  EXPECT_NEAR(headingOf(rotated(camera, {0, 0, 0.02}, NudgeFrame::Camera)).roll, before.roll + 0.02,
              1e-12);
}

TEST(Conversions, HeadingsComeBack) {
  Camera camera;
  camera.intrinsics = {640, 480, 500, 500, 319.5, 239.5};
  camera = withPosition(camera, {1, 2, 3});
  for (const double yaw : {-3.0, -1.0, 0.0, 2.0}) {
    for (const double pitch : {-1.4, -0.3, 0.0, 1.2}) {
      for (const double roll : {-2.8, -0.4, 0.0, 1.7}) {
        const Camera set = withHeading(camera, {yaw, pitch, roll});
        const Heading got = headingOf(set);
        EXPECT_NEAR(got.yaw, yaw, 1e-9);
        EXPECT_NEAR(got.pitch, pitch, 1e-9);
        EXPECT_NEAR(got.roll, roll, 1e-9);
        EXPECT_LT((set.center() - Eigen::Vector3d(1, 2, 3)).norm(), 1e-12);
        // lookAt() says the same: its roll is the one of Heading.
        const Eigen::Isometry3d same =
            lookAt({1, 2, 3}, set.center() + set.opticalAxis(), {0, 0, 1}, roll);
        EXPECT_LT((same.matrix() - set.cameraFromWorld.matrix()).norm(), 1e-9);
      }
    }
  }
  const Camera down = withHeading(camera, {0.7, -std::numbers::pi / 2, 0.0});
  EXPECT_NEAR(headingOf(down).yaw, 0.7, 1e-9) << "straight down, the image's right tells";
}

TEST(Conversions, AGridSuitsItsRig) {
  Camera camera;
  camera.intrinsics = {640, 480, 500, 500, 319.5, 239.5};
  camera.cameraFromWorld = lookAt({3.0, -3.0, 2.0}, {1.0, 2.0, 0.0});
  const ReferenceGrid grid = referenceGridFor({camera});
  EXPECT_TRUE(checkGrid(grid));
  // 5.7 m away: half a meter from line to line, around (1, 2).
  EXPECT_EQ(grid.step, 0.5);
  EXPECT_LT((grid.center() - Eigen::Vector3d(1.0, 2.0, 0.0)).norm(), 1e-9);
  EXPECT_EQ(referenceGridFor({}), ReferenceGrid());
}

TEST(Conversions, TargetsAndFocalLengths) {
  Draw draw(4);
  const Camera camera = someCamera(draw, false);
  const Eigen::Vector3d target = aimPoint(camera, 0.0);
  EXPECT_NEAR(target.z(), 0.0, 1e-12);
  EXPECT_LT(poseDifference(lookingAt(camera, target), camera), 1e-12);
  const Camera other = lookingAt(camera, {0.5, 0.5, 0.5});
  EXPECT_LT((Projector(other).project({0.5, 0.5, 0.5}).value() - Eigen::Vector2d(322, 236)).norm(),
            1e-9);
  EXPECT_NEAR(headingOf(other).roll, headingOf(camera).roll, 1e-12);
  EXPECT_TRUE(lookingAt(camera, camera.center()) == camera);
  // 640 pixels at a focal length of 320: 45 degrees to each side.
  EXPECT_NEAR(fieldOfView(withFocalLength(camera, 320.0)), std::numbers::pi / 2, 1e-12);
  EXPECT_NEAR(focalLengthOf(camera, fieldOfView(camera)), 520.0, 1e-9);
  const Camera wide = withFocalLength(camera, 260.0);
  EXPECT_NEAR(wide.intrinsics.focalY, 257.5, 1e-12);
  Camera fisheye = camera;
  fisheye.lens = LensModel::Fisheye;
  EXPECT_NEAR(fieldOfView(fisheye), 640.0 / 520.0, 1e-12);
  EXPECT_NEAR(focalLengthOf(fisheye, 640.0 / 520.0), 520.0, 1e-9);
}

} // namespace
} // namespace dewpoint::tests
