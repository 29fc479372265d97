// SPDX-License-Identifier: GPL-3.0-or-later
// Expected values: FNV-1a by hand in another language, whose result for "a" is the published
// af63dc4c8601ec8c.
#include "core/experiment/report/fingerprint.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

namespace dewpoint::tests {
namespace {

TEST(Fingerprint, IsFnvFoldedTo32Bits) {
  EXPECT_EQ(Fingerprint().text(), "4fd0bfc1");
  Fingerprint apart;
  apart.add("1");
  apart.add("2");
  EXPECT_EQ(apart.text(), "023684da");
  Fingerprint together;
  together.add("12");
  EXPECT_EQ(together.text(), "5d4d0d5b");
}

TEST(Fingerprint, NamesWhatIsNotFinite) {
  Fingerprint fingerprint;
  fingerprint.add(0.2512, 0.01); // "25"
  fingerprint.add(std::nan(""), 0.01);
  fingerprint.add(std::numeric_limits<double>::infinity(), 1.0);
  fingerprint.addDigits(1.2345, 3); // "1.23e+00"
  EXPECT_EQ(fingerprint.text(), "845d4d03");
}

TEST(Fingerprint, IsTheSameUpToRounding) {
  const auto of = [](double value) {
    Fingerprint fingerprint;
    fingerprint.add(value, 0.01);
    fingerprint.addDigits(value, 3);
    return fingerprint.text();
  };
  EXPECT_EQ(of(0.25), of(0.25 + 1e-9));
  EXPECT_EQ(of(0.0), of(-0.0));
  EXPECT_NE(of(0.25), of(0.26));
}

} // namespace
} // namespace dewpoint::tests
