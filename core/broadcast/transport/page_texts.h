// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/floors.h"

#include <map>
#include <string>

namespace dewpoint::broadcast {

/// Texts that a browser shows, in one language: the texts of livePage(), and the replies of
/// WebServer to invalid requests. UTF-8 without HTML markup. `%1` and `%2` are placeholders for
/// values.
struct PageTexts {
  /// BCP 47 tag of the language, for example "de-DE". It also determines how numbers are written.
  std::string language = "en";
  std::string title = "Dewpoint live";
  /// Description of the 3D view, for screen readers.
  std::string viewDescription = "Cameras, targets and their tracks in 3D";
  std::string help = "Drag: rotate · Wheel or two fingers: zoom · Double click: reset";
  std::string connecting = "Connecting…";
  std::string waiting = "Connected. Waiting for images…";
  std::string disconnected = "Not connected. Trying again…";
  std::string frame = "Frame %1, %2"; ///< number and time of the frame shown
  std::string seconds = "%1 s";       ///< a time in seconds
  /// Displayed names of target states. The keys are the state words in messages (stateWord());
  /// "held" means confirmed by the cameras.
  std::map<std::string, std::string> states{{"held", "tracking"}, {"ambiguous", "ambiguous"},
                                            {"hidden", "hidden"}, {"searching", "searching"},
                                            {"lost", "lost"},     {"gone", "not present"}};
  std::string otherSiteRefused = "Only pages from this server can read the results.";
  std::string onlyGetSupported = "Only GET requests are supported.";
  std::string pageNotFound = "This server has only one page: /.";

  bool operator==(const PageTexts&) const = default;
};

} // namespace dewpoint::broadcast
