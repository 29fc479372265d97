// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/capture/devices/color_lock.h"
#include "tests/capture/devices/fake_machine.h"

#include <gtest/gtest.h>

namespace dewpoint::tests {
namespace {

constexpr const char* kLockedPath = "/dev/video0";

std::shared_ptr<FakeMachine> machineWith(std::vector<FakeControl> controls) {
  auto machine = std::make_shared<FakeMachine>();
  FakeNode node;
  node.formats = {fakeMjpg()};
  node.controls = std::move(controls);
  machine->plug(node);
  return machine;
}

TEST(ColorLock, SwitchesAutomaticsOffAtTheirPresentValues) {
  const auto machine = machineWith(fakeControls());
  const auto lock = lockColors(*accessTo(machine), kLockedPath);
  ASSERT_TRUE(lock) << errorSentence(lock.error());
  EXPECT_EQ(lock->values, (ControlValues{{"auto_exposure", 1},
                                         {"brightness", 128},
                                         {"exposure_time_absolute", 250},
                                         {"gain", 64},
                                         {"white_balance_automatic", 0},
                                         {"white_balance_temperature", 4200}}));
  EXPECT_TRUE(lock->refusals.empty());
  EXPECT_TRUE(lock->missingControls.empty());
  EXPECT_EQ(machine->valueOf("video0", V4L2_CID_EXPOSURE_AUTO), 1);
  EXPECT_EQ(machine->valueOf("video0", V4L2_CID_AUTO_WHITE_BALANCE), 0);
  EXPECT_EQ(machine->valueOf("video0", V4L2_CID_EXPOSURE_ABSOLUTE), 250);
}

TEST(ColorLock, SaysWhatTheDeviceCannotDo) {
  auto controls = fakeControls();
  controls[1].isStuck = true;                         // its white balance stays automatic
  controls[4].menu = {{3, "Aperture Priority Mode"}}; // no manual exposure
  controls.erase(controls.begin() + 2);               // no gain
  const auto lock = lockColors(*accessTo(machineWith(controls)), kLockedPath);
  ASSERT_TRUE(lock) << errorSentence(lock.error());
  ASSERT_EQ(lock->refusals.size(), 2U);
  EXPECT_EQ(lock->refusals[0].adjustment, ColorAutomatic::Exposure);
  EXPECT_EQ(lock->refusals[0].controlName, "auto_exposure");
  EXPECT_NE(lock->refusals[0].reason.find("refused"), std::string::npos);
  EXPECT_EQ(lock->refusals[1].controlName, "white_balance_automatic");
  EXPECT_EQ(lock->missingControls, std::vector<ColorAutomatic>{ColorAutomatic::Gain});
  EXPECT_EQ(lock->values, (ControlValues{{"brightness", 128}}));
}

TEST(ColorLock, FailsWithoutTheDevice) {
  const auto lock = lockColors(*accessTo(std::make_shared<FakeMachine>()), kLockedPath);
  ASSERT_FALSE(lock);
  EXPECT_EQ(lock.error().code, ErrorCode::DeviceUnavailable);
  EXPECT_EQ(lock.error().file, kLockedPath);
}

TEST(ApplyControls, SetsSwitchesFirst) {
  const auto machine = machineWith(fakeControls());
  // By name, exposure_time_absolute comes before white_balance_automatic; a driver refuses values
  // that an automatic has.
  const auto errors = applyControls(*accessTo(machine), kLockedPath,
                                    {{"auto_exposure", 1},
                                     {"exposure_time_absolute", 77},
                                     {"white_balance_automatic", 0},
                                     {"white_balance_temperature", 3000}});
  EXPECT_TRUE(errors.empty()) << errorSentence(errors.front());
  EXPECT_EQ(machine->valueOf("video0", V4L2_CID_EXPOSURE_ABSOLUTE), 77);
  EXPECT_EQ(machine->valueOf("video0", V4L2_CID_WHITE_BALANCE_TEMPERATURE), 3000);
}

TEST(ApplyControls, NamesWhatWasNotSetAndSetsTheRest) {
  const auto machine = machineWith(fakeControls());
  const auto errors = applyControls(*accessTo(machine), kLockedPath,
                                    {{"brightness", 999},
                                     {"exposure_time_absolute", 77}, // its automatic is on
                                     {"gain", 12},
                                     {"zoom_absolute", 1}});
  ASSERT_EQ(errors.size(), 2U);
  EXPECT_EQ(errors[0].field, "brightness");
  EXPECT_EQ(errors[0].code, ErrorCode::BadValue);
  EXPECT_EQ(errors[1].field, "zoom_absolute");
  EXPECT_EQ(errors[1].code, ErrorCode::NotFound);
  EXPECT_EQ(machine->valueOf("video0", V4L2_CID_GAIN), 12);
  EXPECT_EQ(machine->valueOf("video0", V4L2_CID_EXPOSURE_ABSOLUTE), 250);
  EXPECT_TRUE(applyControls(*accessTo(machine), kLockedPath, {}).empty());
}

} // namespace
} // namespace dewpoint::tests
