// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/project/project_output.h"

#include "core/base/text_number.h"

#include <array>
#include <utility>

namespace dewpoint::project {
namespace {

constexpr std::array<std::pair<const char*, OutputAxes>, 3> kOutputAxesKeys{
    {{"z-up", OutputAxes::ZUp},
     {"y-up", OutputAxes::YUp},
     {"y-up-left-handed", OutputAxes::YUpLeftHanded}}};
constexpr std::array<std::pair<const char*, OutputUnit>, 2> kOutputUnitKeys{
    {{"m", OutputUnit::Meter}, {"mm", OutputUnit::Millimeter}}};
constexpr std::size_t kLongestHost = 253; ///< RFC 1035, as text

template <class Keys> auto valueOf(const Keys& keys, std::string_view name) {
  const auto found = std::ranges::find_if(keys, [&](const auto& one) { return name == one.first; });
  return found == keys.end() ? std::nullopt : std::optional(found->second);
}

/// A key with one of several words.
template <class Keys, class Value>
void readWord(TableReader& reader, const char* key, const Keys& keys, Value& value) {
  std::string word;
  reader.readText(key, word);
  if (!reader.has(key) || reader.failed()) {
    return;
  }
  if (const auto known = valueOf(keys, word)) {
    value = *known;
    return;
  }
  std::string all;
  for (const auto& one : keys) {
    all += fmt::format("{}{}", all.empty() ? "" : ", ", one.first);
  }
  reader.fail(ErrorCode::BadValue, key, fmt::format("'{}'; known are {}", word, all));
}

void readPort(TableReader& reader, const char* key, std::optional<std::uint16_t>& port) {
  std::uint16_t read = 0;
  reader.readInteger(key, read, 0, 65535);
  if (reader.has(key) && !reader.failed()) {
    port = read;
  }
}

} // namespace

Result<OutputAddress> parseOutputAddress(std::string_view text) {
  const auto colon = text.rfind(':');
  if (colon != std::string_view::npos) {
    std::string_view host = text.substr(0, colon);
    const bool hasBrackets = host.starts_with('[') && host.ends_with(']') && host.size() > 2;
    host = hasBrackets ? host.substr(1, host.size() - 2) : host;
    const auto port = toNumber<std::uint16_t>(text.substr(colon + 1));
    const bool isPlain = hasBrackets || host.find_first_of(":[]") == std::string_view::npos;
    const bool isHost = !host.empty() && host.size() <= kLongestHost && isPlain &&
                        std::ranges::all_of(host, [](char c) { return c > ' ' && c < '\x7f'; });
    if (isHost && port && *port > 0) {
      return OutputAddress{std::string(host), *port};
    }
  }
  return failure(ErrorCode::BadValue, "", "",
                 fmt::format("'{}' is not HOST:PORT with a port from 1 to 65535", text));
}

std::optional<OutputAxes> outputAxes(std::string_view name) {
  return valueOf(kOutputAxesKeys, name);
}

std::optional<OutputUnit> outputUnit(std::string_view name) {
  return valueOf(kOutputUnitKeys, name);
}

const char* nameOf(OutputAxes axes) {
  return kOutputAxesKeys.at(static_cast<std::size_t>(axes)).first;
}

const char* nameOf(OutputUnit unit) {
  return kOutputUnitKeys.at(static_cast<std::size_t>(unit)).first;
}

void readOutput(TableReader& reader, const std::string& file, Project& project) {
  const toml::table* table = reader.findTable("output");
  if (table == nullptr) {
    return;
  }
  OutputSettings& output = project.output;
  TableReader one(*table, file, "output.");
  readWord(one, "axes", kOutputAxesKeys, output.axes);
  readWord(one, "unit", kOutputUnitKeys, output.unit);
  one.readNumber("rate", output.framesPerSecond, 0.0, OutputSettings::kMaxFramesPerSecond);
  one.readText("osc", output.oscReceiver);
  one.readText("tuio", output.tuioReceiver);
  readPort(one, "tcp", output.tcpPort);
  readPort(one, "websocket", output.webSocketPort);
  one.readText("csv", output.csvFile);
  one.readText("listen", output.listenAddress);
  one.readText("token", output.token);
  reader.recordError(one.finish());
}

std::string outputText(const OutputSettings& output) {
  const OutputSettings unset;
  if (output == unset) {
    return {};
  }
  std::string text = "\n[output]   # results that leave the program while it runs\n";
  const auto put = [&](const char* key, bool isGiven, const std::string& value) {
    text += isGiven ? fmt::format("{} = {}\n", key, value) : std::string();
  };
  put("axes", output.axes != unset.axes, tomlQuoted(nameOf(output.axes)));
  put("unit", output.unit != unset.unit, tomlQuoted(nameOf(output.unit)));
  put("rate", output.framesPerSecond != unset.framesPerSecond,
      fmt::format("{}   # frames per second", output.framesPerSecond));
  put("osc", !output.oscReceiver.empty(), tomlQuoted(output.oscReceiver));
  put("tuio", !output.tuioReceiver.empty(), tomlQuoted(output.tuioReceiver));
  put("tcp", output.tcpPort.has_value(), fmt::format("{}", output.tcpPort.value_or(0)));
  put("websocket", output.webSocketPort.has_value(),
      fmt::format("{}", output.webSocketPort.value_or(0)));
  put("csv", !output.csvFile.empty(), tomlQuoted(output.csvFile));
  put("listen", output.listenAddress != unset.listenAddress, tomlQuoted(output.listenAddress));
  put("token", !output.token.empty(), tomlQuoted(output.token));
  return text;
}

Status checkOutput(const OutputSettings& output) {
  if (!(output.framesPerSecond >= 0.0 &&
        output.framesPerSecond <= OutputSettings::kMaxFramesPerSecond)) {
    return failure(
        ErrorCode::BadValue, "", "output.rate",
        fmt::format("0 to {} frames per second are expected", OutputSettings::kMaxFramesPerSecond));
  }
  for (const auto& [key, address] : {std::pair("output.osc", output.oscReceiver),
                                     std::pair("output.tuio", output.tuioReceiver)}) {
    if (const auto parsed = parseOutputAddress(address); !address.empty() && !parsed) {
      return failure(ErrorCode::BadValue, "", key, parsed.error().detail);
    }
  }
  if (output.listenAddress.empty()) {
    return failure(ErrorCode::BadValue, "", "output.listen",
                   "an address of this computer is expected, such as 127.0.0.1 or 0.0.0.0");
  }
  if (output.tcpPort && output.tcpPort == output.webSocketPort && *output.tcpPort != 0) {
    return failure(ErrorCode::BadValue, "", "output.websocket",
                   fmt::format("port {} is also that of tcp", *output.tcpPort));
  }
  const std::size_t bytes = output.token.size();
  if (bytes > 0 &&
      (bytes < OutputSettings::kMinTokenBytes || bytes > OutputSettings::kMaxTokenBytes) &&
      output.token.find("${") == std::string::npos) {
    return failure(ErrorCode::BadValue, "", "output.token",
                   fmt::format("{} to {} characters are expected", OutputSettings::kMinTokenBytes,
                               OutputSettings::kMaxTokenBytes));
  }
  return {};
}

} // namespace dewpoint::project
