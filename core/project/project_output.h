// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/table_reader.h"
#include "core/project/project.h"

#include <cstdint>
#include <string>
#include <string_view>

namespace dewpoint::project {

/// Address of a receiver of UDP datagrams.
struct OutputAddress {
  std::string host; ///< name or IP address; an IPv6 address without brackets
  std::uint16_t port = 0;
};

/// Parses HOST:PORT, where an IPv6 address is in brackets. Error: BadValue for any other text.
Result<OutputAddress> parseOutputAddress(std::string_view text);

/// Returns the axes with this name in the project file, or nothing if the name is unknown.
std::optional<OutputAxes> outputAxes(std::string_view name);
/// Returns the unit with this name in the project file, or nothing if the name is unknown.
std::optional<OutputUnit> outputUnit(std::string_view name);
/// Returns the name of the axes in the project file.
const char* nameOf(OutputAxes axes);
/// Returns the name of the unit in the project file.
const char* nameOf(OutputUnit unit);

/// Reads the table [output] of a project file into Project::output. Errors are stored in `reader`.
void readOutput(TableReader& reader, const std::string& file, Project& project);
/// Returns the table [output] as TOML; empty if all settings have their defaults.
std::string outputText(const OutputSettings& output);
/// Checks the rate, the addresses, the ports and the token. Error: BadValue, which names the key,
/// for example "output.osc".
Status checkOutput(const OutputSettings& output);

} // namespace dewpoint::project
