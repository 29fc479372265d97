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
/// YAML, and Python dictionaries of numbers and strings. Error: NotParsed, which contains the line.
/// Catches all exceptions of yaml-cpp.
Result<YAML::Node> parseYaml(const std::string& text, const std::string& file);

/// Reads values from a YAML mapping and keeps the first error, with its line. Unknown keys are
/// ignored because other tools write more than this program needs.
class YamlReader {
public:
  YamlReader(const YAML::Node& node, std::string file, std::string prefix = "");

  bool has(const char* key) const;
  /// Returns a reader for the mapping under a key. If there is no such mapping, an error is
  /// recorded and the returned reader is empty.
  YamlReader child(const std::string& key) const;

  /// Returns the keys of the mapping, in file order.
  std::vector<std::string> keys() const;

  /// Returns the text under a key, or `unless` if the key is absent.
  std::string text(const char* key, const std::string& unless = "") const;
  /// Returns the number under a key. An absent key, or a value that is not a number, is an error.
  double number(const char* key) const;
  /// Returns the numbers under a key: a sequence, nested sequences (row by row), or the sequence
  /// under `data` in an OpenCV matrix. It is an error if their count is none of `counts`, unless
  /// `counts` is empty.
  std::vector<double> numbers(const char* key, std::initializer_list<std::size_t> counts) const;
  /// Returns a matrix of the given size, read row by row.
  Eigen::MatrixXd matrix(const char* key, int rows, int columns) const;

  void fail(ErrorCode code, const std::string& key, std::string detail) const;
  const std::optional<Error>& error() const { return *error_; }
  std::string fieldPath(const std::string& key) const { return prefix_ + key; }

private:
  YAML::Node find(const std::string& key) const;

  YAML::Node node_;
  std::string file_;
  std::string prefix_;
  std::shared_ptr<std::optional<Error>> error_; ///< shared with child readers
};

} // namespace dewpoint::calibration
