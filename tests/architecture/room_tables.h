// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <map>
#include <set>
#include <string>
#include <string_view>
#include <vector>

namespace dewpoint::tests {

using Names = std::set<std::string, std::less<>>;

/// The table of docs/architecture.md: what each floor of core names; base is free for all. What a
/// named floor names may be included as well.
const std::map<std::string, Names, std::less<>>& floorTable();

/// The rooms of the floors of core that have some, and which other rooms of the same floor each
/// includes; "" is the floor's own folder, and "a/b" is room b inside room a.
const std::map<std::string, std::map<std::string, Names>, std::less<>>& roomTable();

/// The floors of the window, from below: a room includes rooms of lower floors only.
const std::vector<Names>& windowFloors();

/// Arrows between rooms on one floor of the window: they are few and do not form a circle.
bool windowNeighbors(const std::string& from, const std::string& to);

/// Inside ui/calibration: each way of calibrating is a room; all stand on the folder itself.
bool calibrationArrow(const std::string& from, const std::string& to);

/// Inside app/dewpoint-cli: which folders each folder of commands includes; all may include its own
/// folder, which has the list of the commands.
const std::map<std::string, Names, std::less<>>& commandTable();

/// The folders of app that work without Qt, VTK and the window, since dewpoint-cli and the Python
/// package are made of them.
const Names& windowlessPrograms();

/// A tracker takes frames, so the value type Frame is open to it and to what stands on it.
inline constexpr std::string_view kFrameHeader = "core/capture/frame.h";

/// A project stores the settings of devices, so their value type is open to it.
inline constexpr std::string_view kDeviceSettingsHeader = "core/capture/device_settings.h";

/// The value types that core/session hands out; besides core/session and core/base, the window
/// sees nothing else of core.
const Names& windowHeaders();

} // namespace dewpoint::tests
