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

/// Starts GStreamer unless it was started before. Returns whether GStreamer is running. It writes
/// no messages to stderr unless GST_DEBUG is set.
bool startGStreamer();

/// Returns whether GStreamer on this computer has an element of this name. Starts GStreamer if
/// needed.
bool hasGstElement(const std::string& name);

struct GstObjectRelease {
  void operator()(_GstElement* element) const;
};
struct GstSampleRelease {
  void operator()(_GstSample* sample) const;
};
/// Owning pointers to GStreamer elements and samples. Each holds one reference.
using GstElementPtr = std::unique_ptr<_GstElement, GstObjectRelease>;
using GstSamplePtr = std::unique_ptr<_GstSample, GstSampleRelease>;

/// Creates a pipeline from its text. Its clock is the monotonic clock of this computer
/// (std::chrono::steady_clock). If the text is not valid or an element is missing, returns null and
/// sets `reason`.
GstElementPtr makePipeline(const std::string& text, std::string& reason);

/// Returns the message of a GStreamer error as one line of text to append after a colon. Passwords
/// in addresses are removed.
std::string gstErrorText(const _GError& error);

/// Returns the error in a GStreamer message of type error, as one line of text without passwords;
/// see gstErrorText().
std::string gstMessageErrorText(_GstMessage* message);

} // namespace dewpoint::capture
