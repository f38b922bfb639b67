// SPDX-License-Identifier: BSD-3-Clause
#ifndef palpate_testing_FlatBodyFixture_h
#define palpate_testing_FlatBodyFixture_h

#include "Contact/FlatBodyFile.h"
#include "SampleResponses.h"
#include "ScratchFile.h"

#include <gtest/gtest.h>

#include <cstdint>
#include <fstream>
#include <iterator>
#include <string>
#include <vector>

namespace palpate::testing
{
/// A ball with another curve at each point, and a file for it.
class FlatBodyFixture : public ::testing::Test
{
protected:
  explicit FlatBodyFixture(int subdivisions)
    : Ball(icosphere(20.0, subdivisions))
    , Store(this->Ball.points.size())
    , Validity(this->Ball.points.size(), 0.5F)
    , Limit(this->Ball.points.size(), 1)
  {
    this->Store.normalsFromPoints(this->Ball);
    this->Store.randomizeCurves(5);
  }

  FlatBody flat() const
  {
    FlatBody body;
    body.points = this->Ball.points.size();
    body.triangles = this->Ball.triangles.size();
    body.coordinates = this->Ball.points.front().data();
    body.corners = this->Ball.triangles.front().data();
    body.response = this->Store.arrays();
    body.validity = this->Validity.data();
    body.limit = this->Limit.data();
    body.tool = "sphere:6.35";
    body.model = "half-space";
    body.modelParts = HalfSpacePart | GlobalCompliancePart;
    return body;
  }

  std::vector<char> bytes() const
  {
    std::ifstream file(this->Path, std::ios::binary);
    return { std::istreambuf_iterator<char>(file), std::istreambuf_iterator<char>() };
  }
  void replace(const std::vector<char>& content) const
  {
    std::ofstream file(this->Path, std::ios::binary | std::ios::trunc);
    file.write(content.data(), static_cast<std::streamsize>(content.size()));
  }
  /// Opens the file and returns its error. Requires that no content is available after an error.
  std::string openError() const
  {
    FlatBodyFile file;
    const std::string error = file.open(this->Path);
    EXPECT_EQ(file.body().points, error.empty() ? this->Ball.points.size() : 0U);
    return error;
  }
  static bool contains(const std::string& text, const std::string& part)
  {
    return text.find(part) != std::string::npos;
  }

  Surface Ball;
  ResponseStore Store;
  std::vector<float> Validity;
  std::vector<std::uint8_t> Limit;
  ScratchFile File{ ".palpate" };
  const std::string& Path = this->File.path();
};
} // namespace palpate::testing

#endif
