// SPDX-License-Identifier: GPL-3.0-or-later
// A small reader of C3D files, written from the format's published description (C3D file format
// user guide, Motion Lab Systems) and not from the writer: it follows the pointers of the file.
#pragma once

#include "core/base/floors.h"

#include <cstdint>
#include <cstring>
#include <map>
#include <stdexcept>
#include <string>
#include <vector>

namespace dewpoint::tests {

class C3dReader {
public:
  struct Parameter {
    int type = 0;
    std::vector<int> dimensions;
    std::string data;
  };
  struct Point {
    float x, y, z, fourth;
  };

  explicit C3dReader(const std::string& bytes) : bytes_(bytes) {
    if (byte(1) != 0x50) {
      throw std::runtime_error("no key");
    }
    readParameters(512U * (byte(0) - 1U));
    readData();
  }

  std::size_t headerWord(std::size_t number) const { return word(2 * (number - 1)); }
  float headerReal(std::size_t number) const { return real(2 * (number - 1)); }
  const std::map<std::string, Parameter>& parameters() const { return parameters_; }
  std::size_t wordOf(const std::string& name, std::size_t index = 0) const {
    return static_cast<unsigned char>(parameters_.at(name).data.at(2 * index)) +
           256U * static_cast<unsigned char>(parameters_.at(name).data.at(2 * index + 1));
  }
  float realOf(const std::string& name) const {
    float value = 0;
    std::memcpy(&value, parameters_.at(name).data.data(), 4);
    return value;
  }
  std::string textOf(const std::string& name, std::size_t index = 0) const {
    const Parameter& parameter = parameters_.at(name);
    const auto length = static_cast<std::size_t>(parameter.dimensions.at(0));
    std::string text = parameter.data.substr(index * length, length);
    return text.substr(0, text.find_last_not_of(' ') + 1);
  }
  /// [frame][point]
  const std::vector<std::vector<Point>>& frames() const { return frames_; }

private:
  unsigned byte(std::size_t at) const { return static_cast<unsigned char>(bytes_.at(at)); }
  std::size_t word(std::size_t at) const { return byte(at) + 256U * byte(at + 1); }
  float real(std::size_t at) const {
    float value = 0;
    std::memcpy(&value, bytes_.data() + at, 4);
    return value;
  }

  void readParameters(std::size_t at) {
    const std::size_t end = at + 512U * byte(at + 2);
    if (byte(at + 3) != 84) {
      throw std::runtime_error("not Intel's order of bytes");
    }
    std::map<int, std::string> groups;
    std::vector<std::pair<int, std::pair<std::string, Parameter>>> found;
    for (at += 4; at < end;) {
      const auto nameLength =
          static_cast<std::size_t>(std::abs(static_cast<std::int8_t>(bytes_.at(at))));
      if (nameLength == 0) {
        break;
      }
      const int group = static_cast<std::int8_t>(bytes_.at(at + 1));
      const std::string name = bytes_.substr(at + 2, nameLength);
      const std::size_t pointer = at + 2 + nameLength;
      const std::size_t next = word(pointer);
      if (group < 0) {
        groups[-group] = name;
      } else {
        found.push_back({group, {name, readParameter(pointer + 2)}});
      }
      if (next == 0) {
        break;
      }
      at = pointer + next;
    }
    for (auto& [group, parameter] : found) {
      parameters_[groups.at(group) + ":" + parameter.first] = parameter.second;
    }
  }

  Parameter readParameter(std::size_t at) const {
    Parameter parameter;
    parameter.type = static_cast<std::int8_t>(bytes_.at(at));
    std::size_t count = static_cast<std::size_t>(std::abs(parameter.type));
    const std::size_t dimensions = byte(at + 1);
    for (std::size_t k = 0; k < dimensions; ++k) {
      parameter.dimensions.push_back(static_cast<int>(byte(at + 2 + k)));
      count *= byte(at + 2 + k);
    }
    parameter.data = bytes_.substr(at + 2 + dimensions, count);
    return parameter;
  }

  void readData() {
    std::size_t count = headerWord(5) - headerWord(4) + 1;
    if (parameters_.contains("TRIAL:ACTUAL_END_FIELD")) {
      const std::size_t first =
          wordOf("TRIAL:ACTUAL_START_FIELD", 0) + 65536U * wordOf("TRIAL:ACTUAL_START_FIELD", 1);
      const std::size_t last =
          wordOf("TRIAL:ACTUAL_END_FIELD", 0) + 65536U * wordOf("TRIAL:ACTUAL_END_FIELD", 1);
      count = last - first + 1;
    }
    if (headerReal(7) >= 0.0F || headerWord(3) != 0) {
      throw std::runtime_error("only floating-point points are read here");
    }
    std::size_t at = 512U * (headerWord(9) - 1U);
    for (std::size_t frame = 0; frame < count; ++frame) {
      auto& points = frames_.emplace_back();
      for (std::size_t point = 0; point < headerWord(2); ++point, at += 16) {
        if (at + 16 > bytes_.size()) {
          throw std::runtime_error("the data end early");
        }
        points.push_back({real(at), real(at + 4), real(at + 8), real(at + 12)});
      }
    }
  }

  std::string bytes_;
  std::map<std::string, Parameter> parameters_;
  std::vector<std::vector<Point>> frames_;
};

} // namespace dewpoint::tests
