// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/capture/gstreamer/gst_library.h"

#include "core/base/one_line.h"
#include "core/capture/redacted_location.h"

#include <cctype>
#include <cstdlib>
#include <gst/gst.h>
#include <mutex>

namespace dewpoint::capture {
namespace {

/// What may have gone wrong, where GStreamer's own words say less.
const char* knownReason(const GError& error) {
  if (error.domain == GST_RESOURCE_ERROR) {
    switch (error.code) {
    case GST_RESOURCE_ERROR_BUSY:
      return "the device is busy";
    case GST_RESOURCE_ERROR_NOT_AUTHORIZED:
      return "the password is missing or wrong";
    case GST_RESOURCE_ERROR_NO_SPACE_LEFT:
      return "no space left on the disk";
    case GST_RESOURCE_ERROR_NOT_FOUND:
    case GST_RESOURCE_ERROR_OPEN_READ:
    case GST_RESOURCE_ERROR_OPEN_READ_WRITE:
      return "it cannot be opened; nothing answers there";
    default:
      return nullptr;
    }
  }
  if (error.domain == GST_STREAM_ERROR && error.code == GST_STREAM_ERROR_CODEC_NOT_FOUND) {
    return "this computer has no decoder for the stream; the package gstreamer1.0-libav has more "
           "of them";
  }
  if (error.domain == GST_STREAM_ERROR && error.code == GST_STREAM_ERROR_FAILED) {
    return "no video stream answers, or it breaks off";
  }
  if (error.domain == GST_CORE_ERROR && error.code == GST_CORE_ERROR_MISSING_PLUGIN) {
    return "a plugin of GStreamer that the stream needs is missing";
  }
  return nullptr;
}

} // namespace

bool startGStreamer() {
  static std::once_flag once;
  static bool started = false;
  std::call_once(once, [] {
    started = gst_init_check(nullptr, nullptr, nullptr) != FALSE;
    if (started && std::getenv("GST_DEBUG") == nullptr) {
      gst_debug_set_default_threshold(GST_LEVEL_NONE);
    }
  });
  return started;
}

bool hasGstElement(const std::string& name) {
  if (!startGStreamer()) {
    return false;
  }
  GstElementFactory* factory = gst_element_factory_find(name.c_str());
  if (factory == nullptr) {
    return false;
  }
  // The registry may know a plugin that does not load.
  GstPluginFeature* loaded = gst_plugin_feature_load(GST_PLUGIN_FEATURE(factory));
  gst_object_unref(factory);
  if (loaded != nullptr) {
    gst_object_unref(loaded);
  }
  return loaded != nullptr;
}

void GstObjectRelease::operator()(_GstElement* element) const {
  gst_element_set_state(element, GST_STATE_NULL);
  gst_object_unref(element);
}

void GstSampleRelease::operator()(_GstSample* sample) const {
  gst_sample_unref(sample);
}

GstElementPtr makePipeline(const std::string& text, std::string& reason) {
  if (!startGStreamer()) {
    reason = "GStreamer does not start";
    return nullptr;
  }
  GError* error = nullptr;
  GstElement* made =
      gst_parse_launch_full(text.c_str(), nullptr, GST_PARSE_FLAG_FATAL_ERRORS, &error);
  if (error != nullptr) {
    reason = gstErrorText(*error);
    g_error_free(error);
  }
  if (made == nullptr) {
    return nullptr;
  }
  gst_object_ref_sink(made);
  if (!GST_IS_PIPELINE(made)) { // a single element
    GstElement* pipeline = gst_pipeline_new(nullptr);
    gst_object_ref_sink(pipeline);
    gst_bin_add(GST_BIN(pipeline), made);
    gst_object_unref(made);
    made = pipeline;
  }
  GstClock* clock = gst_system_clock_obtain();
  gst_pipeline_use_clock(GST_PIPELINE(made), clock);
  gst_object_unref(clock);
  return GstElementPtr(made);
}

std::string gstErrorText(const _GError& error) {
  if (const char* known = knownReason(error)) {
    return known;
  }
  std::string text = toSingleLine(redactedLocation(error.message));
  while (text.ends_with('.') || text.ends_with(' ')) {
    text.pop_back();
  }
  // A sentence of GStreamer follows a colon here.
  if (text.size() > 1 && std::islower(static_cast<unsigned char>(text[1])) != 0) {
    text[0] = static_cast<char>(std::tolower(static_cast<unsigned char>(text[0])));
  }
  return text;
}

std::string gstMessageErrorText(_GstMessage* message) {
  GError* error = nullptr;
  gchar* details = nullptr;
  gst_message_parse_error(message, &error, &details);
  const std::string more = details != nullptr ? details : "";
  g_free(details);
  if (error == nullptr) {
    return "unknown error of GStreamer";
  }
  const std::string reason = gstErrorText(*error);
  g_error_free(error);
  // These are only in the details, for developers.
  const auto has = [&](const char* part) { return more.find(part) != std::string::npos; };
  return has("Permission denied")         ? "you have no permission to open it"
         : has("No space left on device") ? "no space left on the disk"
                                          : reason;
}

} // namespace dewpoint::capture
