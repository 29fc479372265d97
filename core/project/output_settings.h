// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/floors.h"

#include <cstdint>
#include <optional>
#include <string>

namespace dewpoint::project {

/// Axes of the positions that are sent to other programs during a run.
enum class OutputAxes {
  ZUp,          ///< right-handed, z up: (x, y, z) of Dewpoint
  YUp,          ///< right-handed, y up: (y, z, x) of Dewpoint, as in the export formats
  YUpLeftHanded ///< left-handed, y up: (x, z, y) of Dewpoint, as in Unity
};

/// Unit of the lengths that are sent to other programs during a run.
enum class OutputUnit { Meter, Millimeter };

/// Settings of the outputs that send results to other programs during a run; table [output] of a
/// project file. An output without a setting is off.
struct OutputSettings {
  OutputAxes axes = OutputAxes::ZUp;
  OutputUnit unit = OutputUnit::Meter;
  double framesPerSecond = 30.0; ///< maximum number of frames sent per second; 0: all frames
  std::string oscReceiver;       ///< receiver of OSC messages as HOST:PORT (UDP)
  std::string tuioReceiver;      ///< receiver of TUIO 1.1 3D cursors as HOST:PORT (UDP)
  /// TCP port on which results are sent as JSON lines; 0: any free port.
  std::optional<std::uint16_t> tcpPort;
  /// Port for WebSocket and the page for browsers; 0: any free port.
  std::optional<std::uint16_t> webSocketPort;
  std::string csvFile; ///< file or named pipe for CSV lines; "-": standard output
  /// Address of this computer on which the ports are opened.
  std::string listenAddress = "127.0.0.1";
  /// Secret word that remote commands must contain; empty: remote commands are off. `${NAME}` is
  /// replaced by an environment variable when the outputs are opened.
  std::string token;

  static constexpr double kMaxFramesPerSecond = 1000.0;
  static constexpr std::size_t kMinTokenBytes = 8;
  static constexpr std::size_t kMaxTokenBytes = 256;

  /// Returns whether at least one output is on.
  bool isAnyOn() const {
    return !oscReceiver.empty() || !tuioReceiver.empty() || !csvFile.empty() ||
           tcpPort.has_value() || webSocketPort.has_value();
  }

  bool operator==(const OutputSettings&) const = default;
};

} // namespace dewpoint::project
