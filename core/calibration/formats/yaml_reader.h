// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/error.h"

#include <Eigen/Core>

#include <initializer_list>
#include <memory>
#include <optional>
#include <string>
#include <vector>
#include <yaml-cpp/yaml.h>

namespace dewpoint::calibration {

/// Parses YAML. Also accepts the output of OpenCV's FileStorage, whose first line is not valid
/// YAML, and a Python dictionary of numbers and texts. NotParsed gives the line. Exceptions of
/// yaml-cpp do not get past this function.
Result<YAML::Node> parseYaml(const std::string& text, const std::string& file);

/// Reads values from one YAML mapping and keeps the first error, with its line. Unknown keys are
/// ignored, because other tools write more than is needed here.
class YamlReader {
public:
  YamlReader(const YAML::Node& node, std::string file, std::string prefix = "");

  bool has(const char* key) const;
  /// Reader for the mapping under a key; empty, with a recorded error, if there is none.
  YamlReader child(const std::string& key) const;

  /// Keys of the mapping, in the order of the file.
  std::vector<std::string> keys() const;

  /// Text under a key; `unless` if the key is absent.
  std::string text(const char* key, const std::string& unless = "") const;
  /// Number under a key; an error if it is absent or not a number.
  double number(const char* key) const;
  /// Numbers of a sequence, of nested sequences row by row, or of `data` in a matrix. It is an
  /// error if their number is not among `counts`; an empty `counts` allows any.
  std::vector<double> numbers(const char* key, std::initializer_list<std::size_t> counts) const;
  /// Matrix of the given size, read row by row.
  Eigen::MatrixXd matrix(const char* key, int rows, int columns) const;

  void fail(ErrorCode code, const std::string& key, std::string detail) const;
  const std::optional<Error>& error() const { return *error_; }
  std::string field(const std::string& key) const { return prefix_ + key; }

private:
  YAML::Node find(const std::string& key) const;

  YAML::Node node_;
  std::string file_;
  std::string prefix_;
  std::shared_ptr<std::optional<Error>> error_; ///< shared with the children
};

} // namespace dewpoint::calibration
