// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/broadcast/format/osc_bundle.h"

#include <algorithm>
#include <lo/lo.h>
#include <new>

namespace dewpoint::broadcast {
namespace {

constexpr std::size_t kLongestText = 255;

/// At most the first kLongestText bytes, without half a character at the end.
std::string shortened(const std::string& text) {
  std::size_t bytes = std::min(text.size(), kLongestText);
  while (bytes > 0 && bytes < text.size() &&
         (static_cast<unsigned char>(text[bytes]) & 0xC0U) == 0x80U) {
    --bytes;
  }
  return text.substr(0, bytes);
}

struct ArgumentAdder {
  lo_message message;
  int operator()(std::int32_t value) const { return lo_message_add_int32(message, value); }
  int operator()(float value) const { return lo_message_add_float(message, value); }
  int operator()(const std::string& value) const {
    return lo_message_add_string(message, shortened(value).c_str());
  }
};

lo_message loMessage(const OscMessage& message) {
  const lo_message made = lo_message_new();
  if (made == nullptr) {
    throw std::bad_alloc();
  }
  for (const OscMessage::Argument& argument : message.arguments) {
    std::visit(ArgumentAdder{made}, argument);
  }
  return made;
}

} // namespace

void OscBundle::Deleter::operator()(void* bundle) const {
  lo_bundle_free_recursive(static_cast<lo_bundle>(bundle));
}

OscBundle::OscBundle() : bundle_(lo_bundle_new(LO_TT_IMMEDIATE)) {
  if (!bundle_) {
    throw std::bad_alloc();
  }
}

void OscBundle::add(const std::vector<OscMessage>& messages) {
  for (const OscMessage& message : messages) {
    const lo_message made = loMessage(message); // the bundle frees it
    lo_bundle_add_message(static_cast<lo_bundle>(bundle_.get()),
                          std::string(message.address).c_str(), made);
  }
}

std::size_t OscBundle::byteCount() const {
  return lo_bundle_length(static_cast<lo_bundle>(bundle_.get()));
}

std::string OscBundle::bytes() const {
  std::string bytes(byteCount(), '\0');
  std::size_t written = bytes.size();
  lo_bundle_serialise(static_cast<lo_bundle>(bundle_.get()), bytes.data(), &written);
  bytes.resize(written);
  return bytes;
}

std::size_t OscBundle::byteCountOf(const std::vector<OscMessage>& messages) {
  OscBundle alone;
  const std::size_t empty = alone.byteCount();
  alone.add(messages);
  return alone.byteCount() - empty;
}

} // namespace dewpoint::broadcast
