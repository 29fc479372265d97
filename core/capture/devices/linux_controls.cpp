// SPDX-License-Identifier: GPL-3.0-or-later
#ifdef __linux__
#include "core/capture/devices/linux_controls.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cerrno>
#include <linux/videodev2.h>
#include <optional>
#include <string_view>
#include <system_error>
#include <utility>

namespace dewpoint::capture {
namespace {

constexpr int kMostControls = 1024; ///< a driver that never ends is broken
constexpr std::int64_t kMostMenuItems = 1024;

/// Names that kernels before 5.14 derive from other labels.
constexpr std::array<std::pair<std::uint32_t, const char*>, 9> kControlNames{
    {{V4L2_CID_AUTO_WHITE_BALANCE, "white_balance_automatic"},
     {V4L2_CID_WHITE_BALANCE_TEMPERATURE, "white_balance_temperature"},
     {V4L2_CID_AUTOGAIN, "gain_automatic"},
     {V4L2_CID_HUE_AUTO, "hue_automatic"},
     {V4L2_CID_EXPOSURE_AUTO, "auto_exposure"},
     {V4L2_CID_EXPOSURE_ABSOLUTE, "exposure_time_absolute"},
     {V4L2_CID_EXPOSURE_AUTO_PRIORITY, "exposure_dynamic_framerate"},
     {V4L2_CID_FOCUS_ABSOLUTE, "focus_absolute"},
     {V4L2_CID_FOCUS_AUTO, "focus_automatic_continuous"}}};

/// As v4l2-ctl makes a name of a label.
std::string controlName(std::uint32_t id, std::string_view label) {
  const auto* const known =
      std::ranges::find(kControlNames, id, &std::pair<std::uint32_t, const char*>::first);
  if (known != kControlNames.end()) {
    return known->second;
  }
  std::string name;
  for (const char letter : label) {
    const bool isLarge = letter >= 'A' && letter <= 'Z';
    if (isLarge || (letter >= 'a' && letter <= 'z') || (letter >= '0' && letter <= '9')) {
      name += isLarge ? static_cast<char>(letter - 'A' + 'a') : letter;
    } else if (!name.empty() && name.back() != '_') {
      name += '_';
    }
  }
  name.erase(name.find_last_not_of('_') + 1);
  return name;
}

std::optional<ControlKind> kindOf(std::uint32_t type) {
  switch (type) {
  case V4L2_CTRL_TYPE_INTEGER:
  case V4L2_CTRL_TYPE_INTEGER64:
    return ControlKind::Integer;
  case V4L2_CTRL_TYPE_BOOLEAN:
    return ControlKind::Boolean;
  case V4L2_CTRL_TYPE_MENU:
  case V4L2_CTRL_TYPE_INTEGER_MENU:
    return ControlKind::Menu;
  default:
    return std::nullopt; // buttons, texts and arrays are not settings of one value
  }
}

/// What the driver says of a control, before its value is read.
struct QueriedControl {
  v4l2_query_ext_ctrl query{};
  ControlKind kind = ControlKind::Integer;
  std::string name;
};

std::vector<QueriedControl> queriedControls(LinuxNode& node) {
  std::vector<QueriedControl> controls;
  std::uint32_t last = 0;
  for (int k = 0; k < kMostControls; ++k) {
    v4l2_query_ext_ctrl query{};
    query.id = last | V4L2_CTRL_FLAG_NEXT_CTRL;
    if (node.callIoctl(VIDIOC_QUERY_EXT_CTRL, query) != 0 || query.id <= last) {
      break;
    }
    last = query.id;
    const auto kind = kindOf(query.type);
    if (kind && (query.flags & V4L2_CTRL_FLAG_DISABLED) == 0 && query.elems <= 1) {
      std::string name = controlName(query.id, query.name);
      if (!name.empty()) {
        controls.push_back({query, *kind, std::move(name)});
      }
    }
  }
  return controls;
}

v4l2_ext_controls oneOf(v4l2_ext_control& control) {
  v4l2_ext_controls all{};
  all.which = V4L2_CTRL_WHICH_CUR_VAL;
  all.count = 1;
  all.controls = &control;
  return all;
}

std::optional<std::int64_t> valueOf(LinuxNode& node, const v4l2_query_ext_ctrl& query) {
  if ((query.flags & V4L2_CTRL_FLAG_WRITE_ONLY) != 0) {
    return std::nullopt;
  }
  v4l2_ext_control control{};
  control.id = query.id;
  v4l2_ext_controls all = oneOf(control);
  if (node.callIoctl(VIDIOC_G_EXT_CTRLS, all) != 0) {
    return std::nullopt;
  }
  const std::int64_t wide = control.value64; // copies: the structure is packed
  const std::int32_t narrow = control.value;
  return query.type == V4L2_CTRL_TYPE_INTEGER64 ? wide : narrow;
}

std::vector<ControlMenuItem> menuOf(LinuxNode& node, const v4l2_query_ext_ctrl& query) {
  std::vector<ControlMenuItem> items;
  const std::int64_t last = std::min<std::int64_t>(query.maximum, query.minimum + kMostMenuItems);
  for (std::int64_t index = query.minimum; index <= last; ++index) {
    v4l2_querymenu item{};
    item.id = query.id;
    item.index = static_cast<std::uint32_t>(index);
    if (node.callIoctl(VIDIOC_QUERYMENU, item) != 0) {
      continue; // the device does not have this one
    }
    const std::int64_t number = item.value; // a copy: the structure is packed
    items.push_back({index, query.type == V4L2_CTRL_TYPE_INTEGER_MENU
                                ? std::to_string(number)
                                : std::string(reinterpret_cast<const char*>(item.name))});
  }
  return items;
}

} // namespace

std::string systemErrorText(int errorNumber) {
  switch (errorNumber) {
  case EACCES:
  case EPERM:
    return "no permission";
  case EBUSY:
    return "another program uses it";
  case ENOENT:
  case ENODEV:
  case ENXIO:
    return "no such device is plugged in";
  default:
    return std::generic_category().message(errorNumber);
  }
}

std::vector<DeviceControl> readLinuxControls(LinuxNode& node) {
  std::vector<DeviceControl> controls;
  for (const QueriedControl& one : queriedControls(node)) {
    const auto value = valueOf(node, one.query);
    if (!value) {
      continue;
    }
    DeviceControl& control = controls.emplace_back();
    control.name = one.name;
    control.label = one.query.name;
    control.kind = one.kind;
    control.minimum = one.query.minimum;
    control.maximum = one.query.maximum;
    control.step = std::max<std::int64_t>(1, static_cast<std::int64_t>(one.query.step));
    control.defaultValue = one.query.default_value;
    control.value = *value;
    control.isReadOnly = (one.query.flags & V4L2_CTRL_FLAG_READ_ONLY) != 0;
    control.isInactive = (one.query.flags & V4L2_CTRL_FLAG_INACTIVE) != 0;
    if (one.kind == ControlKind::Menu) {
      control.menuItems = menuOf(node, one.query);
    }
  }
  return controls;
}

Status setLinuxControl(LinuxNode& node, const std::string& path, const std::string& name,
                       std::int64_t value) {
  const auto controls = queriedControls(node);
  const auto found = std::ranges::find(controls, name, &QueriedControl::name);
  if (found == controls.end()) {
    return failure(ErrorCode::NotFound, path, name, "the device has no such control");
  }
  const v4l2_query_ext_ctrl& query = found->query;
  if (value < query.minimum || value > query.maximum) {
    return failure(ErrorCode::BadValue, path, name,
                   fmt::format("{} is not within {} to {}", value, query.minimum, query.maximum));
  }
  v4l2_ext_control control{};
  control.id = query.id;
  if (query.type == V4L2_CTRL_TYPE_INTEGER64) {
    control.value64 = value;
  } else {
    control.value = static_cast<std::int32_t>(value);
  }
  v4l2_ext_controls all = oneOf(control);
  if (const int problem = node.callIoctl(VIDIOC_S_EXT_CTRLS, all); problem != 0) {
    const bool isGone = problem == ENODEV;
    const bool isLocked = problem == EACCES; // read-only, or an automatic has it
    return failure(isGone ? ErrorCode::DeviceUnavailable : ErrorCode::BadValue, path, name,
                   isLocked ? "the device does not let it be set now"
                            : fmt::format("{} is refused ({})", value, systemErrorText(problem)));
  }
  return {};
}

} // namespace dewpoint::capture
#endif
