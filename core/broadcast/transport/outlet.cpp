// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/broadcast/transport/outlet.h"

namespace dewpoint::broadcast {

std::string outletAddressText(const OutletReport& report) {
  switch (report.kind) {
  case OutletKind::JsonLines:
    return "JSON lines at " + report.address;
  case OutletKind::WebPage:
    return "page and WebSocket at " + report.address;
  case OutletKind::OscMessages:
    return "OSC messages to " + report.address;
  case OutletKind::TuioCursors:
    return "TUIO cursors to " + report.address;
  case OutletKind::CsvLines:
    break;
  }
  return "CSV lines to " + (report.address == "-" ? "standard output" : report.address);
}

} // namespace dewpoint::broadcast
