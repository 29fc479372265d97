// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/calibration/formats/calibration_file.h"
#include "core/calibration/formats/convert_calibration.h"
#include "core/calibration/formats/format_catalog.h"
#include "core/calibration/formats/lens_refit.h"
#include "core/calibration/formats/read_calibration.h"
#include "core/geometry/projector.h"
#include "tests/calibration/own_folder.h"

#include <gtest/gtest.h>
#include <opencv2/calib3d.hpp>

#include <cstdlib>
#include <fstream>

namespace dewpoint::tests {
namespace {

Camera cameraWithLens(const char* name, const Eigen::Vector3d& position,
                      const std::array<double, 8>& distortion,
                      LensModel lens = LensModel::Pinhole) {
  Camera camera;
  camera.name = name;
  camera.intrinsics = {1280, 720, 903.5, 907.25, 618.3, 394.2};
  camera.distortion = distortion;
  camera.lens = lens;
  camera.cameraFromWorld = lookAt(position, {0.0, 0.0, 0.5});
  return camera;
}

/// Four coefficients: every format holds them.
CameraRig plainRig() {
  return {cameraWithLens("left", {2.0, -1.5, 1.4}, {-0.33, 0.16, -0.0043, 0.0041}),
          cameraWithLens("right", {1.9, 1.7, 1.2}, {0.1, -0.22, 0.0004, -0.0026})};
}

CalibrationOutput target(const CalibrationFormat& format) {
  CalibrationOutput result;
  result.format = format.name;
  result.path = ownFolder() / format.name;
  if (format.layout != FileLayout::FilePerCamera) {
    result.path += format.extension;
  }
  result.replacesExisting = true;
  return result;
}

TEST(ConvertCalibration, LosesNothingWhereTheModelsAgree) {
  for (const CalibrationFormat& format : calibrationFormats()) {
    if (format.write == nullptr) {
      continue;
    }
    const auto conversion = writeCalibration(plainRig(), target(format));
    ASSERT_TRUE(conversion) << format.name << ": " << errorSentence(conversion.error());
    ASSERT_EQ(conversion->cameraDifferences.size(), 2U);
    EXPECT_LT(conversion->maxDifferencePx, 1e-6) << format.name;
    for (const auto& camera : conversion->cameraDifferences) {
      EXPECT_FALSE(camera.isRefitted);
      EXPECT_EQ(camera.unseenDirectionCount, 0);
    }
    EXPECT_FALSE(conversion->decisions.empty());
  }
}

TEST(ConvertCalibration, GoesThereAndBackThroughEveryFormat) {
  const CameraRig rig = plainRig();
  for (const CalibrationFormat& format : calibrationFormats()) {
    if (format.write == nullptr || format.firstCameraIsWorld) {
      continue;
    }
    const auto there = target(format);
    ASSERT_TRUE(writeCalibration(rig, there)) << format.name;
    CalibrationHints hints;
    if (!format.metersPerUnit) {
      hints.metersPerUnit = format.defaultMetersPerUnit;
    }
    const auto back = readCalibration(there.path, hints);
    ASSERT_TRUE(back) << format.name << ": " << errorSentence(back.error());
    ASSERT_EQ(back->rig.size(), 2U) << format.name;
    for (std::size_t k = 0; k < 2; ++k) {
      EXPECT_TRUE(back->rig[k].cameraFromWorld.isApprox(rig[k].cameraFromWorld, 1e-9))
          << format.name;
    }
  }
}

TEST(ConvertCalibration, RenamesAndFitsOnTheWay) {
  const CameraRig rig = plainRig();
  const auto in = target(**findCalibrationFormat("dewpoint"));
  ASSERT_TRUE(writeCalibration(rig, in));
  auto out = target(**findCalibrationFormat("anipose"));
  out.metersPerUnit = 1.0;
  CalibrationChanges changes;
  changes.adaptation = {{{"renamed", rig[1].name}}, SizeFit::Scale};
  const auto& intrinsics = rig[1].intrinsics;
  changes.imageSize = {2 * intrinsics.width, 2 * intrinsics.height};
  const auto conversion = convertCalibration(in.path, {}, out, changes);
  ASSERT_TRUE(conversion) << errorSentence(conversion.error());
  const auto back = readCalibration(out.path, [] {
    CalibrationHints hints;
    hints.metersPerUnit = 1.0;
    return hints;
  }());
  ASSERT_TRUE(back) << errorSentence(back.error());
  EXPECT_EQ(back->rig[0].name, rig[0].name);
  EXPECT_EQ(back->rig[1].name, "renamed");
  EXPECT_NEAR(back->rig[1].intrinsics.focalX, 2.0 * intrinsics.focalX, 1e-6);
  EXPECT_NEAR(back->rig[1].intrinsics.centerX, 2.0 * intrinsics.centerX + 0.5, 1e-6);
}

TEST(ConvertCalibration, NamesCamerasOfOnePose) {
  CameraRig rig = plainRig();
  const auto in = target(**findCalibrationFormat("dewpoint"));
  ASSERT_TRUE(writeCalibration(rig, in));
  const auto out = target(**findCalibrationFormat("anipose"));
  auto conversion = convertCalibration(in.path, {}, out);
  ASSERT_TRUE(conversion) << errorSentence(conversion.error());
  EXPECT_TRUE(conversion->notices.empty());
  rig[1].cameraFromWorld = rig[0].cameraFromWorld;
  ASSERT_TRUE(writeCalibration(rig, in));
  conversion = convertCalibration(in.path, {}, out);
  ASSERT_TRUE(conversion) << errorSentence(conversion.error());
  ASSERT_EQ(conversion->notices.size(), 1U);
  EXPECT_NE(
      conversion->notices.front().find(rig[0].name + " and " + rig[1].name + " have the same pose"),
      std::string::npos);
}

TEST(ConvertCalibration, RefitsALensThatTheFormatCannotHoldAndSaysTheLoss) {
  CameraRig rig = plainRig();
  rig[0].distortion[4] = -0.05; // k3: Pose2Sim and Kalibr have none
  rig[1].distortion = {0.4, -0.1, 0.001, -0.0005, 0.01, 0.35, -0.02, 0.004};
  // scipy.optimize.least_squares over the same pixels leaves 8.969 and 0.549 px with k1 k2 p1 p2,
  // both in a corner.
  for (const char* name : {"pose2sim", "kalibr"}) {
    const auto conversion = writeCalibration(rig, target(**findCalibrationFormat(name)));
    ASSERT_TRUE(conversion) << errorSentence(conversion.error());
    EXPECT_NEAR(conversion->cameraDifferences[0].maxDifferencePx, 8.969, 1e-3) << name;
    EXPECT_NEAR(conversion->cameraDifferences[1].maxDifferencePx, 0.549, 1e-3) << name;
    EXPECT_TRUE(conversion->cameraDifferences[0].isRefitted &&
                conversion->cameraDifferences[1].isRefitted);
  }
  for (const char* name : {"anipose", "qualisys"}) { // these know k3
    const auto conversion = writeCalibration(rig, target(**findCalibrationFormat(name)));
    ASSERT_TRUE(conversion) << errorSentence(conversion.error());
    EXPECT_LT(conversion->cameraDifferences[0].maxDifferencePx, 1e-6) << name;
    EXPECT_TRUE(conversion->cameraDifferences[1].isRefitted) << name;
    EXPECT_LT(conversion->cameraDifferences[1].maxDifferencePx, 0.549) << name;
  }
  EXPECT_EQ(writeCalibration(rig, target(**findCalibrationFormat("mrcal")))
                ->cameraDifferences[0]
                .isRefitted,
            false);
}

TEST(LensRefit, IsMuchBetterThanDroppingTheCoefficient) {
  Camera camera = plainRig()[0];
  camera.distortion[4] = -0.05;
  const LensRefit refit = refitLens(camera, {4, false});
  ASSERT_TRUE(refit.isRefitted);
  EXPECT_EQ(refit.camera.distortion[4], 0.0);
  Camera cut = camera; // k3 simply dropped
  cut.distortion[4] = 0.0;
  const double dropped = compareCameras(camera, cut, Eigen::Isometry3d::Identity()).maxDifferencePx;
  EXPECT_LT(refit.maxDifferencePx, 0.1 * dropped);
  EXPECT_LT(refit.rmsDifferencePx, refit.maxDifferencePx);
}

TEST(LensRefit, AMildFisheyeFitsAPinholeOfEight) {
  const Camera camera = cameraWithLens("round", {2, 0, 1}, {0.02, -0.012, 0.003, -0.001},
                                       LensModel::Fisheye); // 35 degrees to the corner
  const LensRefit refit = refitLens(camera, {8, false});
  EXPECT_EQ(refit.camera.lens, LensModel::Pinhole);
  EXPECT_LT(refit.maxDifferencePx, 0.01);
}

TEST(ConvertCalibration, AnAskedUnitIsWritten) {
  auto wanted = target(**findCalibrationFormat("anipose"));
  wanted.metersPerUnit = 0.01;
  const auto conversion = writeCalibration(plainRig(), wanted);
  ASSERT_TRUE(conversion);
  EXPECT_LT(conversion->maxDifferencePx, 1e-6);
  wanted = target(**findCalibrationFormat("kalibr"));
  wanted.metersPerUnit = 0.001;
  EXPECT_EQ(writeCalibration(plainRig(), wanted).error().field, "unit");
}

TEST(ConvertCalibration, RefusesWhatTheFormatCannotHold) {
  CameraRig rig = plainRig();
  rig.push_back(rig.front());
  EXPECT_EQ(writeCalibration(rig, target(**findCalibrationFormat("opencv-stereo"))).error().code,
            ErrorCode::Mismatch);
  EXPECT_FALSE(writeCalibration(rig, target(**findCalibrationFormat("multical"))));
  auto wanted = target(**findCalibrationFormat("mrcal"));
  wanted.path = ownFolder() / "unasked";
  std::filesystem::remove_all(wanted.path);
  wanted.replacesExisting = false;
  ASSERT_TRUE(writeCalibration(plainRig(), wanted));
  EXPECT_EQ(writeCalibration(plainRig(), wanted).error().code, ErrorCode::FileUnwritable);
}

TEST(ConvertCalibration, OpenCvReadsWhatIsWrittenForIt) {
  const auto wanted = target(**findCalibrationFormat("opencv-stereo"));
  ASSERT_TRUE(writeCalibration(plainRig(), wanted));
  const cv::FileStorage inner(wanted.path.string(), cv::FileStorage::READ);
  ASSERT_TRUE(inner.isOpened());
  cv::Mat matrix;
  inner["M1"] >> matrix;
  EXPECT_EQ(matrix.at<double>(1, 1), 907.25);
  inner["D2"] >> matrix;
  EXPECT_EQ(matrix.cols, 5);
  EXPECT_EQ(matrix.at<double>(0, 1), -0.22);
}

/// What mrcal itself projects with a file that we wrote. Skipped where mrcal is not installed.
TEST(ConvertCalibration, MrcalProjectsTheSameFromOurFile) {
  if (std::system("/usr/bin/python3 -c 'import mrcal' >/dev/null 2>&1") != 0) {
    GTEST_SKIP() << "python3-mrcal is not installed";
  }
  CameraRig rig = plainRig();
  rig[0].distortion = {0.4, -0.1, 0.001, -0.0005, 0.01, 0.35, -0.02, 0.004};
  auto wanted = target(**findCalibrationFormat("mrcal"));
  const auto conversion = writeCalibration(rig, wanted);
  ASSERT_TRUE(conversion) << errorSentence(conversion.error());
  const auto answer = wanted.path / "answer.txt";
  for (std::size_t k = 0; k < 2; ++k) {
    const std::string program =
        "import mrcal, numpy as np; m = mrcal.cameramodel('" +
        conversion->writtenFiles[k].string() +
        "'); p = mrcal.transform_point_rt(m.extrinsics_rt_fromref(), np.array([0.3, -0.2, 0.7])); "
        "print('%.12f %.12f' % tuple(mrcal.project(p, *m.intrinsics())))";
    ASSERT_EQ(std::system(("/usr/bin/python3 -c \"" + program + "\" > " + answer.string()).c_str()),
              0);
    double column = 0.0;
    double row = 0.0;
    std::ifstream(answer) >> column >> row;
    const auto pixel = Projector(rig[k]).project({0.3, -0.2, 0.7});
    ASSERT_TRUE(pixel);
    EXPECT_NEAR(pixel->x(), column, 1e-6);
    EXPECT_NEAR(pixel->y(), row, 1e-6);
  }
}

} // namespace
} // namespace dewpoint::tests
