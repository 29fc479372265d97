// SPDX-License-Identifier: GPL-3.0-or-later
// C3D through a reader of its own; NPZ byte by byte and through NumPy.
#include "core/trajectory/export/stored_zip.h"
#include "tests/trajectory/c3d_reader.h"
#include "tests/trajectory/export_examples.h"

#include <cstdlib>

namespace dewpoint::tests {
namespace {

TEST(ExportC3d, IsReadByAnotherReader) {
  const C3dReader file(exported(exportExample(), exportAs("c3d"), "a.c3d"));
  EXPECT_EQ(file.headerWord(2), 2U);     // points
  EXPECT_EQ(file.headerWord(4), 1U);     // first frame
  EXPECT_EQ(file.headerWord(5), 4U);     // last frame
  EXPECT_EQ(file.headerReal(11), 10.0F); // frames per second
  EXPECT_EQ(file.wordOf("POINT:USED"), 2U);
  EXPECT_EQ(file.wordOf("POINT:FRAMES"), 4U);
  EXPECT_EQ(file.wordOf("POINT:DATA_START"), file.headerWord(9));
  EXPECT_EQ(file.realOf("POINT:SCALE"), file.headerReal(7));
  EXPECT_EQ(file.realOf("POINT:RATE"), 10.0F);
  EXPECT_EQ(file.textOf("POINT:UNITS"), "mm");
  EXPECT_EQ(file.textOf("POINT:LABELS", 0), "ball");
  EXPECT_EQ(file.textOf("POINT:LABELS", 1), "cap, red");
  EXPECT_EQ(file.textOf("POINT:Y_SCREEN"), "+Z");
  EXPECT_EQ(file.wordOf("ANALOG:USED"), 0U);
  EXPECT_FALSE(file.parameters().contains("POINT:LONG_FRAMES"));
  ASSERT_EQ(file.frames().size(), 4U);
  const auto& ball = file.frames()[1][0];
  EXPECT_FLOAT_EQ(ball.x, 100.0F);
  EXPECT_FLOAT_EQ(ball.y, 250.0F);
  EXPECT_FLOAT_EQ(ball.z, 2000.0F);
  // sqrt((1 + 4 + 9) / 3) = 2.16 mm is 22 steps of 0.1 mm; two cameras.
  EXPECT_EQ(ball.fourth, 3 * 256 + 22);
  EXPECT_EQ(file.frames()[2][0].fourth, -1.0F) << "a gap";
  EXPECT_FLOAT_EQ(file.frames()[2][1].x, 1000.0F);
}

TEST(ExportC3d, FilledPointsHaveNoResidual) {
  ExportOptions options = exportAs("c3d");
  options.gapRule = GapRule::Fill;
  const C3dReader file(exported(exportExample(), options, "a.c3d"));
  EXPECT_EQ(file.frames()[2][0].fourth, 0.0F);
  EXPECT_FLOAT_EQ(file.frames()[2][0].x, 200.0F);
}

TEST(ExportC3d, HoldsMoreFramesThanSixteenBits) {
  constexpr std::int64_t kFrames = 70000;
  Trajectory trajectory;
  for (std::int64_t frame = 0; frame < kFrames; ++frame) {
    trajectory.samples.push_back(
        exportSample(frame, "ball", {1.0, 2.0, static_cast<double>(frame)}));
  }
  ExportOptions options = exportAs("c3d");
  options.unit = LengthUnit::Meter;
  const C3dReader file(exported(trajectory, options, "a.c3d"));
  EXPECT_EQ(file.headerWord(5), 65535U);
  EXPECT_EQ(file.wordOf("POINT:FRAMES"), 65535U);
  EXPECT_EQ(file.realOf("POINT:LONG_FRAMES"), 70000.0F);
  EXPECT_EQ(file.wordOf("TRIAL:ACTUAL_END_FIELD", 0), 70000U - 65536U);
  EXPECT_EQ(file.wordOf("TRIAL:ACTUAL_END_FIELD", 1), 1U);
  ASSERT_EQ(file.frames().size(), 70000U);
  EXPECT_EQ(file.frames().back()[0].z, 69999.0F);
  EXPECT_EQ(file.textOf("POINT:UNITS"), "m");
}

TEST(ExportC3d, RefusesMoreTargetsThanItHolds) {
  Trajectory trajectory;
  for (int target = 0; target < 300; ++target) {
    trajectory.samples.push_back(exportSample(0, std::to_string(target), {0, 0, 0}));
  }
  const ExportFolder folder;
  const auto summary = exportTrajectory(trajectory, exportAs("c3d"), folder / "a.c3d");
  ASSERT_FALSE(summary);
  EXPECT_EQ(summary.error().field, "targets");
}

TEST(StoredZip, HasThePublishedChecksum) {
  // The check value of CRC-32/ISO-HDLC in every catalog of CRCs.
  EXPECT_EQ(crc32("123456789"), 0xCBF43926U);
}

/// What is stored under a name, found through the central directory.
std::string unzipped(const std::string& archive, const std::string& name) {
  const auto word = [&](std::size_t at) {
    return static_cast<unsigned char>(archive.at(at)) +
           256U * static_cast<unsigned char>(archive.at(at + 1));
  };
  const auto number = [&](std::size_t at) { return word(at) + 65536U * word(at + 2); };
  const std::size_t end = archive.rfind("PK\x05\x06");
  std::size_t entry = number(end + 16);
  for (unsigned k = 0; k < word(end + 10); ++k) {
    EXPECT_EQ(archive.substr(entry, 4), "PK\x01\x02");
    const std::string found = archive.substr(entry + 46, word(entry + 28));
    if (found == name) {
      const std::size_t local = number(entry + 42);
      EXPECT_EQ(archive.substr(local, 4), "PK\x03\x04");
      EXPECT_EQ(word(entry + 10), 0U) << "stored";
      const std::string bytes =
          archive.substr(local + 30 + word(local + 26) + word(local + 28), number(entry + 24));
      EXPECT_EQ(number(entry + 16), crc32(bytes));
      return bytes;
    }
    entry += 46 + word(entry + 28) + word(entry + 30) + word(entry + 32);
  }
  ADD_FAILURE() << name << " is not there";
  return {};
}

TEST(ExportNpz, HasTheBytesOfTheFormat) {
  ExportOptions options = exportAs("npz");
  options.targets = {"ball"};
  const std::string archive = exported(exportExample(), options, "a.npz");
  const std::string array = unzipped(archive, "xyz.npy");
  // NEP 1: magic, version 1.0, length of the description, which ends at a multiple of 64.
  ASSERT_GE(array.size(), 128U);
  EXPECT_EQ(array.substr(0, 6), "\x93NUMPY");
  EXPECT_EQ(array.substr(6, 2), std::string("\x01\x00", 2));
  EXPECT_EQ(static_cast<unsigned char>(array[8]), 118U); // 10 + 118 = 128
  EXPECT_EQ(array[9], '\0');
  const std::string description = "{'descr': '<f8', 'fortran_order': False, 'shape': (4, 1, 3), }";
  EXPECT_EQ(array.substr(10, description.size()), description);
  EXPECT_EQ(array[127], '\n');
  ASSERT_EQ(array.size(), 128U + 4U * 3U * 8U);
  // 2.0 is 0x4000000000000000: z of the ball at frame 1.
  EXPECT_EQ(array.substr(128 + (3 + 2) * 8, 8), std::string("\0\0\0\0\0\0\0\x40", 8));
  // A gap is a NaN: exponent all ones.
  EXPECT_EQ(static_cast<unsigned char>(array[128 + 6 * 8 + 7]) & 0x7FU, 0x7FU);
  // "ball" as UTF-32.
  const std::string names = unzipped(archive, "names.npy");
  EXPECT_NE(names.find("'<U4'"), std::string::npos);
  EXPECT_EQ(names.substr(names.size() - 16), std::string("b\0\0\0a\0\0\0l\0\0\0l\0\0\0", 16));
}

TEST(ExportNpz, TwiceTheSameBytes) {
  EXPECT_EQ(exported(exportExample(), exportAs("npz"), "a.npz"),
            exported(exportExample(), exportAs("npz"), "b.npz"));
}

TEST(ExportNpz, IsReadByNumPy) {
  if (std::system("/usr/bin/python3 -c 'import numpy' >/dev/null 2>&1") !=
      0) { // NOLINT(cert-env33-c)
    GTEST_SKIP() << "python3-numpy is not installed";
  }
  const ExportFolder folder;
  ASSERT_TRUE(exportTrajectory(exportExample(), exportAs("npz"), folder / "a.npz"));
  std::ofstream(folder / "check.py") << R"(
import sys, numpy
a = numpy.load(sys.argv[1], allow_pickle=False)
assert list(a['names']) == ['ball', 'cap, red']
assert a['xyz'].shape == (4, 2, 3) and a['xyz'].dtype == numpy.float64
assert numpy.allclose(a['xyz'][1, 0], [0.1, 0.25, 2.0])
assert numpy.isnan(a['xyz'][2, 0]).all() and not numpy.isnan(a['xyz'][2, 1]).any()
assert a['cov'].shape == (4, 2, 3, 3) and numpy.isclose(a['cov'][0, 0, 0, 1], 5e-7)
assert list(a['frame']) == [0, 1, 2, 3] and numpy.allclose(a['t'], [0, 0.1, 0.2, 0.3])
assert a['filled'].dtype == bool and not a['filled'].any()
assert 'right-handed' in str(a['units']) and 'seed: 7' in str(a['about'])
)";
  const std::string command = "/usr/bin/python3 '" + (folder / "check.py").string() + "' '" +
                              (folder / "a.npz").string() + "'";
  EXPECT_EQ(std::system(command.c_str()), 0); // NOLINT(cert-env33-c)
}

} // namespace
} // namespace dewpoint::tests
