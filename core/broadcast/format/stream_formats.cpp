// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/broadcast/format/stream_formats.h"

#include "core/broadcast/format/csv_row.h"
#include "core/broadcast/format/json_line.h"
#include "core/broadcast/format/osc_target.h"
#include "core/broadcast/format/tuio_cursor.h"

#include <array>

namespace dewpoint::broadcast {
namespace {

std::string noOpening(const RigMessage& /*rig*/) {
  return {};
}

constexpr std::array kStreamFormats{
    StreamFormat{"json", "JSON lines",
                 "one object per frame: frame, time, targets with position, velocity, covariance, "
                 "existence probability, state and cameras",
                 jsonRigLine, jsonFrameLines},
    StreamFormat{"csv", "CSV lines",
                 "one row per target and frame: time, frame, target, state, position, velocity, "
                 "covariance, existence probability, cameras",
                 csvHeaderRow, csvFrameRows},
    StreamFormat{"osc", "OSC messages",
                 "/dewpoint/frame, and for each target /dewpoint/target, /dewpoint/covariance and "
                 "/dewpoint/cameras, or /dewpoint/absent",
                 noOpening, oscFrameBundles},
    StreamFormat{"tuio", "TUIO 1.1 3D cursors",
                 "/tuio/3Dcur alive, set and fseq; positions as fractions of the volume", noOpening,
                 tuioFrameBundles},
};

} // namespace

std::span<const StreamFormat> streamFormats() {
  return kStreamFormats;
}

const StreamFormat& jsonLinesFormat() {
  return kStreamFormats[0];
}

const StreamFormat& csvRowsFormat() {
  return kStreamFormats[1];
}

const StreamFormat& oscMessagesFormat() {
  return kStreamFormats[2];
}

const StreamFormat& tuioCursorsFormat() {
  return kStreamFormats[3];
}

} // namespace dewpoint::broadcast
