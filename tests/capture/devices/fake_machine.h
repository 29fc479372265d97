// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/capture/devices/linux_calls.h"
#include "core/capture/devices/linux_devices.h"
#include "tests/capture/temporary_folder.h"

#include <algorithm>
#include <cerrno>
#include <cstdint>
#include <cstring>
#include <filesystem>
#include <fstream>
#include <linux/videodev2.h>
#include <map>
#include <memory>
#include <mutex>
#include <string>
#include <utility>
#include <vector>

namespace dewpoint::tests {

/// A control of a node, as its driver has it.
struct FakeControl {
  std::uint32_t id = 0;
  std::string label;
  std::uint32_t type = V4L2_CTRL_TYPE_INTEGER;
  std::int64_t minimum = 0;
  std::int64_t maximum = 1;
  std::int64_t value = 0;
  std::uint32_t automatic = 0; ///< control that keeps this one while it is not `manual`
  std::int64_t manual = 0;
  std::vector<std::pair<std::int64_t, std::string>> menu = {};
  bool isStuck = false; ///< accepts values and does nothing
};

struct FakeSize {
  std::uint32_t width = 0;
  std::uint32_t height = 0;
  std::vector<v4l2_fract> intervals;
};

struct FakeFormat {
  std::uint32_t code = 0;
  std::string description;
  std::uint32_t flags = 0;
  std::vector<FakeSize> sizes;
};

/// A node below /dev, with what its driver answers and where it is plugged in.
struct FakeNode {
  std::string name = "video0";
  std::string card = "HD Webcam";
  std::uint32_t abilities = V4L2_CAP_VIDEO_CAPTURE | V4L2_CAP_STREAMING;
  std::string port = "3"; ///< USB port; empty: not a USB device
  std::string serial = {};
  std::string product = "0825";
  int index = 0;
  int openError = 0;
  std::vector<FakeFormat> formats = {};
  std::vector<FakeControl> controls = {};
};

inline FakeFormat fakeMjpg() {
  return {V4L2_PIX_FMT_MJPEG,
          "Motion-JPEG",
          V4L2_FMT_FLAG_COMPRESSED,
          {{640, 480, {{1, 30}, {1, 15}}}, {1280, 720, {{1, 30}}}}};
}

inline FakeFormat fakeYuyv() {
  return {V4L2_PIX_FMT_YUYV, "YUYV 4:2:2", 0, {{640, 480, {{1, 30}}}, {1280, 720, {{1, 10}}}}};
}

/// Controls of a webcam whose automatics are on.
inline std::vector<FakeControl> fakeControls() {
  return {{V4L2_CID_BRIGHTNESS, "Brightness", V4L2_CTRL_TYPE_INTEGER, 0, 255, 128},
          {V4L2_CID_AUTO_WHITE_BALANCE, "White Balance Temperature, Auto", V4L2_CTRL_TYPE_BOOLEAN,
           0, 1, 1},
          {V4L2_CID_GAIN, "Gain", V4L2_CTRL_TYPE_INTEGER, 0, 255, 64},
          {V4L2_CID_WHITE_BALANCE_TEMPERATURE, "White Balance Temperature", V4L2_CTRL_TYPE_INTEGER,
           2000, 6500, 4200, V4L2_CID_AUTO_WHITE_BALANCE, 0},
          {V4L2_CID_EXPOSURE_AUTO,
           "Exposure, Auto",
           V4L2_CTRL_TYPE_MENU,
           0,
           3,
           3,
           0,
           0,
           {{1, "Manual Mode"}, {3, "Aperture Priority Mode"}}},
          {V4L2_CID_EXPOSURE_ABSOLUTE, "Exposure (Absolute)", V4L2_CTRL_TYPE_INTEGER, 3, 2047, 250,
           V4L2_CID_EXPOSURE_AUTO, 1}};
}

/// A computer with fake devices: a folder with dev and sys, and the answers of the drivers.
class FakeMachine : public LinuxCalls {
public:
  FakeMachine() {
    std::filesystem::create_directories(root() / "dev/v4l/by-path");
    std::filesystem::create_directories(root() / "dev/v4l/by-id");
    std::filesystem::create_directories(root() / "sys/class/video4linux");
    writeAttribute(hub() / "speed", "480");
  }

  /// Holds dev and sys.
  std::filesystem::path root() const { return folder_ / "root"; }

  void plug(const FakeNode& node) {
    std::scoped_lock lock(mutex_);
    nodes_[node.name] = node;
    std::ofstream(root() / "dev" / node.name) << node.name;
    const auto entry = root() / "sys/class/video4linux" / node.name;
    writeAttribute(entry / "index", std::to_string(node.index));
    if (node.port.empty()) {
      return;
    }
    const auto device = hub() / ("1-" + node.port);
    writeAttribute(device / "idVendor", "046d");
    writeAttribute(device / "idProduct", node.product);
    writeAttribute(device / "product", node.card);
    writeAttribute(device / "busnum", "1");
    writeAttribute(device / "speed", "480");
    if (!node.serial.empty()) {
      writeAttribute(device / "serial", node.serial);
    }
    const auto interface = device / ("1-" + node.port + ":1.0");
    std::filesystem::create_directories(interface);
    std::filesystem::create_directory_symlink(interface, entry / "device");
    const std::string end = "-video-index" + std::to_string(node.index);
    link("by-path", "pci-0000:00:14.0-usb-0:" + node.port + ":1.0" + end, node.name);
    link("by-path", "pci-0000:00:14.0-usbv2-0:" + node.port + ":1.0" + end, node.name);
    link("by-id", "usb-046d_Webcam_" + node.serial + end, node.name);
  }

  void unplug(const std::string& name) {
    std::scoped_lock lock(mutex_);
    const FakeNode node = nodes_.at(name);
    nodes_.erase(name);
    std::filesystem::remove(root() / "dev" / name);
    std::filesystem::remove_all(root() / "sys/class/video4linux" / name);
    std::filesystem::remove_all(hub() / ("1-" + node.port));
    std::vector<std::filesystem::path> links;
    for (const char* folder : {"by-path", "by-id"}) {
      for (const auto& entry : std::filesystem::directory_iterator(root() / "dev/v4l" / folder)) {
        if (std::filesystem::read_symlink(entry.path()).filename() == name) {
          links.push_back(entry.path());
        }
      }
    }
    for (const auto& path : links) {
      std::filesystem::remove(path);
    }
  }

  std::int64_t valueOf(const std::string& name, std::uint32_t id) const {
    std::scoped_lock lock(mutex_);
    return std::ranges::find(nodes_.at(name).controls, id, &FakeControl::id)->value;
  }

  void setOpenError(const std::string& name, int error) {
    std::scoped_lock lock(mutex_);
    nodes_.at(name).openError = error;
  }

  int openCount() const { return opened_; }

  int open(const std::string& path) override {
    std::scoped_lock lock(mutex_);
    std::error_code problem;
    const auto node = nodes_.find(std::filesystem::canonical(path, problem).filename().string());
    if (problem || node == nodes_.end()) {
      return -ENOENT;
    }
    if (node->second.openError != 0) {
      return -node->second.openError;
    }
    ++opened_;
    descriptors_[++lastDescriptor_] = node->first;
    return lastDescriptor_;
  }
  void close(int descriptor) override {
    std::scoped_lock lock(mutex_);
    descriptors_.erase(descriptor);
    --opened_;
  }
  int callIoctl(int descriptor, unsigned long request, void* argument) override {
    std::scoped_lock lock(mutex_);
    const auto node = nodes_.find(descriptors_.at(descriptor));
    return node == nodes_.end() ? -ENODEV : answer(node->second, request, argument);
  }

private:
  std::filesystem::path hub() const { return root() / "sys/devices/pci0000:00/0000:00:14.0/usb1"; }
  static void writeAttribute(const std::filesystem::path& file, const std::string& text) {
    std::filesystem::create_directories(file.parent_path());
    std::ofstream(file) << text << "\n";
  }
  void link(const std::string& folder, const std::string& name, const std::string& node) const {
    const auto path = root() / "dev/v4l" / folder / name;
    std::filesystem::remove(path);
    std::filesystem::create_symlink("../../" + node, path);
  }
  template <std::size_t Size> static void put(__u8 (&bytes)[Size], const std::string& text) {
    std::memcpy(bytes, text.data(), std::min(text.size(), Size));
  }

  static int answer(FakeNode& node, unsigned long request, void* argument) {
    switch (request) {
    case VIDIOC_QUERYCAP: {
      auto& capability = *static_cast<v4l2_capability*>(argument);
      put(capability.driver, "uvcvideo");
      put(capability.card, node.card);
      put(capability.bus_info, "usb-0000:00:14.0-" + node.port);
      capability.capabilities = node.abilities | V4L2_CAP_META_CAPTURE | V4L2_CAP_DEVICE_CAPS;
      capability.device_caps = node.abilities;
      return 0;
    }
    case VIDIOC_ENUM_FMT:
      return format(node, *static_cast<v4l2_fmtdesc*>(argument));
    case VIDIOC_ENUM_FRAMESIZES:
      return size(node, *static_cast<v4l2_frmsizeenum*>(argument));
    case VIDIOC_ENUM_FRAMEINTERVALS:
      return interval(node, *static_cast<v4l2_frmivalenum*>(argument));
    case VIDIOC_QUERY_EXT_CTRL:
      return query(node, *static_cast<v4l2_query_ext_ctrl*>(argument));
    case VIDIOC_QUERYMENU:
      return menuItem(node, *static_cast<v4l2_querymenu*>(argument));
    case VIDIOC_G_EXT_CTRLS:
    case VIDIOC_S_EXT_CTRLS:
      return access(node, *static_cast<v4l2_ext_controls*>(argument),
                    request == VIDIOC_S_EXT_CTRLS);
    default:
      return -ENOTTY;
    }
  }

  static int format(const FakeNode& node, v4l2_fmtdesc& entry) {
    if (entry.index >= node.formats.size()) {
      return -EINVAL;
    }
    const FakeFormat& one = node.formats[entry.index];
    entry.pixelformat = one.code;
    entry.flags = one.flags;
    put(entry.description, one.description);
    return 0;
  }

  static const FakeSize* sizeAt(const FakeNode& node, std::uint32_t code, std::size_t index) {
    const auto found = std::ranges::find(node.formats, code, &FakeFormat::code);
    return found == node.formats.end() || index >= found->sizes.size() ? nullptr
                                                                       : &found->sizes[index];
  }

  static int size(const FakeNode& node, v4l2_frmsizeenum& entry) {
    const FakeSize* one = sizeAt(node, entry.pixel_format, entry.index);
    if (one == nullptr) {
      return -EINVAL;
    }
    entry.type = V4L2_FRMSIZE_TYPE_DISCRETE;
    entry.discrete = {one->width, one->height};
    return 0;
  }

  static int interval(const FakeNode& node, v4l2_frmivalenum& entry) {
    for (std::size_t k = 0; const FakeSize* one = sizeAt(node, entry.pixel_format, k); ++k) {
      if (one->width == entry.width && one->height == entry.height &&
          entry.index < one->intervals.size()) {
        entry.type = V4L2_FRMIVAL_TYPE_DISCRETE;
        entry.discrete = one->intervals[entry.index];
        return 0;
      }
    }
    return -EINVAL;
  }

  static FakeControl* controlOf(FakeNode& node, std::uint32_t id) {
    const auto found = std::ranges::find(node.controls, id, &FakeControl::id);
    return found == node.controls.end() ? nullptr : &*found;
  }

  static bool isInactive(FakeNode& node, const FakeControl& control) {
    const FakeControl* automatic = controlOf(node, control.automatic);
    return automatic != nullptr && automatic->value != control.manual;
  }

  static int query(FakeNode& node, v4l2_query_ext_ctrl& entry) {
    const std::uint32_t last = entry.id & ~static_cast<std::uint32_t>(V4L2_CTRL_FLAG_NEXT_CTRL);
    const FakeControl* next = nullptr;
    for (const FakeControl& one : node.controls) {
      if (one.id > last && (next == nullptr || one.id < next->id)) {
        next = &one;
      }
    }
    if (next == nullptr) {
      return -EINVAL;
    }
    entry.id = next->id;
    entry.type = next->type;
    std::memcpy(entry.name, next->label.data(),
                std::min(next->label.size(), sizeof entry.name - 1));
    entry.minimum = next->minimum;
    entry.maximum = next->maximum;
    entry.step = 1;
    entry.elems = 1;
    entry.flags = isInactive(node, *next) ? V4L2_CTRL_FLAG_INACTIVE : 0;
    return 0;
  }

  static int menuItem(FakeNode& node, v4l2_querymenu& entry) {
    const FakeControl* control = controlOf(node, entry.id);
    for (const auto& [value, name] : control->menu) {
      if (value == entry.index) {
        std::memcpy(entry.name, name.data(), std::min(name.size(), sizeof entry.name - 1));
        return 0;
      }
    }
    return -EINVAL;
  }

  static int access(FakeNode& node, v4l2_ext_controls& all, bool writes) {
    FakeControl* control = controlOf(node, all.controls[0].id);
    if (control == nullptr) {
      return -EINVAL;
    }
    if (!writes) {
      all.controls[0].value = static_cast<std::int32_t>(control->value);
      return 0;
    }
    const std::int64_t value = all.controls[0].value;
    const bool isMenu = control->type == V4L2_CTRL_TYPE_MENU;
    if (isMenu &&
        std::ranges::none_of(control->menu, [&](auto& one) { return one.first == value; })) {
      return -EINVAL;
    }
    if (isInactive(node, *control)) {
      return -EACCES;
    }
    control->value = control->isStuck ? control->value : value;
    return 0;
  }

  test::TemporaryFolder folder_;
  mutable std::mutex mutex_;
  std::map<std::string, FakeNode> nodes_;
  std::map<int, std::string> descriptors_;
  int lastDescriptor_ = 100;
  int opened_ = 0;
};

/// Access to the devices of a fake computer.
inline DeviceAccessPtr accessTo(const std::shared_ptr<FakeMachine>& machine) {
  return std::make_shared<LinuxDevices>(machine->root(), machine);
}

} // namespace dewpoint::tests
