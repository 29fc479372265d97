// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/floors.h"

#include <memory>
#include <string>

struct _GError;     // NOLINT(bugprone-reserved-identifier): the library's
struct _GstElement; // NOLINT(bugprone-reserved-identifier): the library's
struct _GstMessage; // NOLINT(bugprone-reserved-identifier): the library's
struct _GstSample;  // NOLINT(bugprone-reserved-identifier): the library's

namespace dewpoint::capture {

/// Starts GStreamer once per process, without messages on stderr unless GST_DEBUG asks for them.
/// Returns whether that worked.
bool startGStreamer();

/// Returns whether this computer has an element. Starts GStreamer.
bool hasGstElement(const std::string& name);

struct GstObjectRelease {
  void operator()(_GstElement* element) const;
};
struct GstSampleRelease {
  void operator()(_GstSample* sample) const;
};
/// Elements and samples of which one reference is owned.
using GstElementPtr = std::unique_ptr<_GstElement, GstObjectRelease>;
using GstSamplePtr = std::unique_ptr<_GstSample, GstSampleRelease>;

/// Makes a pipeline that runs by the monotonic clock of this computer, which is the steady clock.
/// Returns null and a reason if the text is not valid, or an element is missing.
GstElementPtr makePipeline(const std::string& text, std::string& reason);

/// Returns the message of a GStreamer error as one line that can be appended after a colon: without
/// line breaks, and without passwords in addresses.
std::string gstReason(const _GError& error);

/// Returns the reason in a message of type error; see gstReason().
std::string gstReasonOf(_GstMessage* message);

} // namespace dewpoint::capture
